//! The balance of energies during a run: `BASE.energy.csv`.

use super::{OutputError, OutputNames, ResultWriter};
use crate::simulation::{EnergyBalance, PlaneAudit, Simulation, SpaceAudit, SpatialSimulation};
use serde::{Deserialize, Serialize};
use std::{
    io::{BufWriter, Write as _},
    path::PathBuf,
};
use yformat::part_file::PartFile;

/// How a run kept its energy.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct EnergySummary {
    /// The last balance.
    pub last: EnergyBalance,
    /// Largest error by the largest energy until then, without its sign.
    pub worst_relative_error: f64,
}

/// Audits a simulation.
pub trait Audit<S> {
    /// Looks at a state after its forces were evaluated.
    fn after_forces(&mut self, simulation: &S);
    /// Looks at it after it has moved: the balance, and the largest relative error so far.
    fn after_motion(&mut self, simulation: &S) -> EnergySummary;
    /// Step and time of a simulation, s.
    fn instant(simulation: &S) -> (u64, f64);
}

impl Audit<Simulation> for PlaneAudit {
    fn after_forces(&mut self, simulation: &Simulation) {
        self.after_forces(simulation);
    }

    fn after_motion(&mut self, simulation: &Simulation) -> EnergySummary {
        self.after_motion(simulation);
        EnergySummary { last: self.balance(), worst_relative_error: self.worst_error() }
    }

    fn instant(simulation: &Simulation) -> (u64, f64) {
        (simulation.step_index(), simulation.time())
    }
}

impl Audit<SpatialSimulation> for SpaceAudit {
    fn after_forces(&mut self, simulation: &SpatialSimulation) {
        self.after_forces(simulation);
    }

    fn after_motion(&mut self, simulation: &SpatialSimulation) -> EnergySummary {
        self.after_motion(simulation);
        EnergySummary { last: self.balance(), worst_relative_error: self.worst_error() }
    }

    fn instant(simulation: &SpatialSimulation) -> (u64, f64) {
        (simulation.step_index(), simulation.time())
    }
}

/// Writes the table of energies.
pub struct EnergyOutput<A> {
    audit: A,
    interval: u64,
    path: PathBuf,
    file: BufWriter<PartFile>,
    summary: Option<EnergySummary>,
}

impl<A> EnergyOutput<A> {
    /// Starts the table, which gets a line at steps whose index is a multiple of `interval`.
    ///
    /// # Errors
    /// If the file cannot be created.
    pub fn open(names: &OutputNames, audit: A, interval: u64) -> Result<Self, OutputError> {
        let path = names.energy();
        let part = PartFile::create(&path).map_err(OutputError::io(&path))?;
        let mut file = BufWriter::new(part);
        let heading = format!("time (s),step,{}", EnergyBalance::NAMES.join(","));
        writeln!(file, "{heading}").map_err(OutputError::io(&path))?;
        Ok(Self { audit, interval, path, file, summary: None })
    }
}

impl<S, A: Audit<S>> ResultWriter<S> for EnergyOutput<A> {
    fn after_forces(&mut self, simulation: &S) -> Result<(), OutputError> {
        self.audit.after_forces(simulation);
        Ok(())
    }

    fn after_motion(&mut self, simulation: &S) -> Result<(), OutputError> {
        let summary = self.audit.after_motion(simulation);
        self.summary = Some(summary);
        let (step, time) = A::instant(simulation);
        if !step.is_multiple_of(self.interval) {
            return Ok(());
        }
        let values = summary.last.values().map(|value| format!("{value:e}"));
        writeln!(self.file, "{time:e},{step},{}", values.join(","))
            .map_err(OutputError::io(&self.path))
    }

    fn kind(&self) -> &'static str {
        "energy"
    }

    fn energy(&self) -> Option<EnergySummary> {
        self.summary
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        let Self { path, file, .. } = *self;
        let part = file.into_inner().map_err(|e| OutputError::io(&path)(e.into_error()))?;
        Ok(vec![part.complete().map_err(OutputError::io(path))?])
    }
}
