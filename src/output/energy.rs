//! The balance of energies during a run: `BASE.energy.csv`.

use super::{
    FilePosition, OutputError, OutputNames, ResultWriter, decode, encode, table_file::TableFile,
};
use crate::simulation::{
    EnergyBalance, Ledger, PlaneAudit, Simulation, SpaceAudit, SpatialSimulation,
};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// What checkpoints call the table.
const KIND: &str = "energy";

/// How a run kept its energy.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct EnergySummary {
    /// The last balance.
    pub last: EnergyBalance,
    /// Largest error by the largest energy until then, without its sign.
    pub worst_relative_error: f64,
}

/// Audits a simulation in `D` dimensions.
pub trait Audit<S, const D: usize> {
    /// Looks at a state after its forces were evaluated.
    fn after_forces(&mut self, simulation: &S);
    /// Looks at it after it has moved.
    fn after_motion(&mut self, simulation: &S);
    /// Energies and works so far.
    fn ledger(&self) -> &Ledger<D>;
    /// Goes on with those of an earlier audit; false if they are not complete.
    fn go_on_with(&mut self, ledger: Ledger<D>) -> bool;
    /// Step and time of a simulation, s.
    fn instant(simulation: &S) -> (u64, f64);
}

macro_rules! audits {
    ($audit:ty, $simulation:ty, $dimension:literal) => {
        impl Audit<$simulation, $dimension> for $audit {
            fn after_forces(&mut self, simulation: &$simulation) {
                self.after_forces(simulation);
            }

            fn after_motion(&mut self, simulation: &$simulation) {
                self.after_motion(simulation);
            }

            fn ledger(&self) -> &Ledger<$dimension> {
                self.ledger()
            }

            fn go_on_with(&mut self, ledger: Ledger<$dimension>) -> bool {
                self.go_on_with(ledger)
            }

            fn instant(simulation: &$simulation) -> (u64, f64) {
                (simulation.step_index(), simulation.time())
            }
        }
    };
}

audits!(PlaneAudit, Simulation, 2);
audits!(SpaceAudit, SpatialSimulation, 3);

/// Writes the table of energies.
pub struct EnergyOutput<A, const D: usize> {
    audit: A,
    interval: u64,
    /// None until a table of an earlier run is gone on with.
    table: Option<TableFile>,
}

/// How to go on with a table of energies.
#[derive(Serialize, Deserialize)]
struct EnergyMark<const D: usize> {
    position: FilePosition,
    interval: u64,
    ledger: Ledger<D>,
}

impl<A, const D: usize> EnergyOutput<A, D> {
    /// Starts the table, which gets a line at steps whose index is a multiple of `interval`.
    ///
    /// # Errors
    /// If the file cannot be created.
    pub fn open(names: &OutputNames, audit: A, interval: u64) -> Result<Self, OutputError> {
        let heading = format!("time (s),step,{}", EnergyBalance::NAMES.join(","));
        let table = Some(TableFile::with_heading(names.energy(), &heading)?);
        Ok(Self { table, ..Self::closed(audit, interval) })
    }

    /// A table of an earlier run, to be gone on with.
    #[must_use]
    pub fn closed(audit: A, interval: u64) -> Self {
        Self { audit, interval, table: None }
    }
}

impl<S, A: Audit<S, D>, const D: usize> ResultWriter<S> for EnergyOutput<A, D> {
    fn after_forces(&mut self, simulation: &S) -> Result<(), OutputError> {
        self.audit.after_forces(simulation);
        Ok(())
    }

    fn after_motion(&mut self, simulation: &S) -> Result<(), OutputError> {
        self.audit.after_motion(simulation);
        let (step, time) = A::instant(simulation);
        match &mut self.table {
            Some(table) if step.is_multiple_of(self.interval) => {
                let values =
                    self.audit.ledger().balance().values().map(|value| format!("{value:e}"));
                table.line(&format!("{time:e},{step},{}", values.join(",")))
            }
            _ => Ok(()),
        }
    }

    fn kind(&self) -> &'static str {
        KIND
    }

    fn energy(&self) -> Option<EnergySummary> {
        let ledger = self.audit.ledger();
        let (last, worst_relative_error) = (ledger.balance(), ledger.worst_error());
        ledger.has_begun().then_some(EnergySummary { last, worst_relative_error })
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        let table = self.table.as_mut().ok_or(OutputError::Mark { kind: KIND })?;
        encode(
            KIND,
            &EnergyMark {
                position: table.mark()?,
                interval: self.interval,
                ledger: self.audit.ledger().clone(),
            },
        )
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        _simulation: &S,
    ) -> Result<(), OutputError> {
        let mark: EnergyMark<D> = decode(KIND, mark)?;
        if mark.interval != self.interval || !self.audit.go_on_with(mark.ledger) {
            return Err(OutputError::Mark { kind: KIND });
        }
        self.table = Some(TableFile::resume(names.energy(), mark.position)?);
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        self.table.map(TableFile::finish).into_iter().collect()
    }
}
