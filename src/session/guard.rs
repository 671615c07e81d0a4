//! What a run does when its motion makes no sense any more.

use super::{
    model::{Model, ModelState},
    run::{RunError, Watch},
};
use crate::{
    output::{OutputError, OutputNames},
    simulation::{Trouble, Wrong},
    stability::Limits,
};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;
use yformat::part_file::PartFile;
use ypsilon_converters::vtk::write_vtu;

/// What to do about instability.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum OnInstability {
    /// Motion that is no number ends the run; what else makes no sense is said once.
    #[default]
    EndLate,
    /// Nothing ends the run; it is said once.
    Warn,
    /// The run ends at the first step that makes no sense, with the state just before it.
    Stop,
}

/// Steps between two looks at the state: one look takes about a hundredth of a step.
pub(super) const INTERVAL: u64 = 64;

/// The states that a run falls back on.
pub(super) struct Guard {
    pub mode: OnInstability,
    /// Relative error of the balance of energies beyond which the motion makes no sense.
    energy_limit: f64,
    /// The state at the last look, if the run may have to go back to it.
    good: Option<ModelState>,
    has_warned: bool,
}

/// What the run has come to.
pub(super) enum Verdict {
    /// Nothing is wrong.
    Sound,
    /// Something is, and it is to be said.
    Warn(String),
    /// The run ends.
    End(RunError),
}

impl Guard {
    pub fn new(watch: &Watch) -> Self {
        let Watch { on_instability: mode, energy_limit, .. } = *watch;
        Self { mode, energy_limit, good: None, has_warned: false }
    }

    /// Remembers the state before the first step, or after a look.
    pub fn remember<M: Model>(&mut self, simulation: &M) {
        if self.mode == OnInstability::Stop {
            self.good = Some(simulation.save());
        }
    }

    /// Whether a relative error of the balance of energies, which is known after every step, asks for a look.
    pub fn wants_look(&self, energy_error: f64) -> bool {
        !self.has_warned && self.is_off(energy_error)
    }

    fn is_off(&self, energy_error: f64) -> bool {
        energy_error.is_nan() || energy_error.abs() > self.energy_limit
    }

    /// Looks at the state between two steps; `energy_error` is the relative one of the balance of
    /// energies, if it is watched. `end` writes the checkpoint of a state.
    pub fn look<M: Model>(
        &mut self,
        simulation: &mut M,
        energy_error: Option<f64>,
        names: &OutputNames,
        end: impl FnOnce(&M, PathBuf) -> Result<(), RunError>,
    ) -> Verdict {
        let off = energy_error.filter(|error| self.is_off(*error)).map(|error| Trouble {
            wrong: Wrong::Energy(error.abs()),
            node: None,
            element: None,
            in_contact_with: None,
            place: Vec::new(),
        });
        let Some(trouble) = simulation.trouble().or(off) else {
            self.remember(simulation);
            return Verdict::Sound;
        };
        match self.mode {
            OnInstability::Stop => Verdict::End(self.stop(simulation, trouble, names, end)),
            OnInstability::EndLate | OnInstability::Warn if self.has_warned => Verdict::Sound,
            OnInstability::EndLate | OnInstability::Warn => {
                self.has_warned = true;
                let (step, time) = (simulation.step_index(), simulation.time());
                Verdict::Warn(format!(
                    "the run has become unstable before step {step} (time {time:.6e} s): {trouble}; {}",
                    cause(&simulation.limits(), simulation.control().time_step)
                ))
            }
        }
    }

    /// Goes back to the last sound state, and from there to the first that is not.
    fn stop<M: Model>(
        &mut self,
        simulation: &mut M,
        trouble: Trouble,
        names: &OutputNames,
        end: impl FnOnce(&M, PathBuf) -> Result<(), RunError>,
    ) -> RunError {
        let found = (simulation.step_index(), simulation.time());
        let dt = simulation.control().time_step;
        let Some(good) = self.good.take() else {
            let cause = cause(&simulation.limits(), dt);
            return unstable(found, &trouble, cause, Vec::new());
        };
        let mut before = good.clone();
        if simulation.load(good).is_err() {
            return unstable(found, &trouble, String::new(), Vec::new());
        }
        let mut first = trouble;
        while simulation.step_index() < found.0 {
            before = simulation.save();
            simulation.evaluate();
            simulation.move_on();
            simulation.complete();
            if let Some(trouble) = simulation.trouble() {
                first = trouble;
                break;
            }
        }
        let at = (simulation.step_index().saturating_sub(1), simulation.time() - dt);
        if simulation.load(before).is_err() {
            return unstable(at, &first, String::new(), Vec::new());
        }
        let cause = cause(&simulation.limits(), dt);
        match leave(simulation, names, end) {
            Ok(files) => unstable(at, &first, cause, files),
            Err(error) => error,
        }
    }
}

/// Writes a state as text, as a checkpoint and, with the stresses of its forces, as VTU files.
fn leave<M: Model>(
    simulation: &mut M,
    names: &OutputNames,
    end: impl FnOnce(&M, PathBuf) -> Result<(), RunError>,
) -> Result<Vec<PathBuf>, RunError> {
    let state = names.unstable_state();
    PartFile::create(&state)
        .and_then(|mut file| {
            simulation.write_state(&mut file)?;
            file.complete()
        })
        .map_err(OutputError::io(&state))?;
    let checkpoint = names.unstable_checkpoint();
    end(simulation, checkpoint.clone())?;
    let mut files = vec![state, checkpoint];
    for (part, grid) in simulation.grids() {
        let path = names.unstable_vtu(part);
        write_vtu(&path, &grid).map_err(OutputError::from)?;
        files.push(path);
    }
    Ok(files)
}

fn unstable(
    (step, time): (u64, f64),
    trouble: &Trouble,
    cause: String,
    files: Vec<PathBuf>,
) -> RunError {
    RunError::Instability { step, time, trouble: trouble.to_string(), cause, files }
}

/// The likely cause, from the limits of the state.
fn cause(limits: &Limits, dt: f64) -> String {
    let set_by = limits.set_by.map_or_else(String::new, |c| format!(", which {} sets", c.part));
    if !limits.critical_s.is_finite() {
        "nothing that limits the time step is left in this state: --on-instability stop goes back to the one before".to_owned()
    } else if dt > limits.critical_s {
        format!(
            "the time step {dt:e} s is longer than the critical one of this state, {:.3e} s{set_by}",
            limits.critical_s
        )
    } else if dt > limits.impact_s {
        format!(
            "the time step {dt:e} s is too long for bodies that meet face to face, {:.3e} s",
            limits.impact_s
        )
    } else {
        format!(
            "the time step {dt:e} s is {:.0} % of the critical one of this state{set_by}: look at loads, strengths and what met there",
            100.0 * dt / limits.critical_s
        )
    }
}
