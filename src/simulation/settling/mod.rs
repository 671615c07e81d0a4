//! Settling: the state in which a scene is at rest under the loads of its first instant, found
//! without waiting for it.
//!
//! Dynamic relaxation (Otter 1966; Underwood 1983): nodes move with fictitious masses that give
//! every one of them the same limit of the time step, under viscous damping that follows the
//! lowest frequency in motion. Loads are brought on step by step, as fast as the structure
//! follows. The equilibrium that is reached is that of the real masses: neither masses nor damping
//! act on what is at rest. Theory, guarantees and limits: `docs/src/settling.md`.

mod contact_stiffness;
mod damping;
mod fault;
mod free_nodes;
mod loads;
mod masses;
mod memory;
mod refusal;
mod relaxation;

use super::{Simulation, SimulationState};
use relaxation::{Course, Relaxation};
use serde::{Deserialize, Serialize};

pub use fault::{SettlingFault, Unsettleable};

/// How often fictitious masses are made heavier before settling is given up.
const ATTEMPTS: u32 = 4;
/// By how much they are made heavier.
const HEAVIER: f64 = 2.0;

/// When a scene counts as settled.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SettlingOptions {
    /// Largest [unbalanced force ratio](SettlingProgress::ratio) that is left, above 0.
    pub tolerance: f64,
    /// Iterations after which settling is given up.
    pub most_iterations: u64,
}

impl SettlingOptions {
    /// Default tolerance.
    pub const TOLERANCE: f64 = 1e-4;
    /// Default bound of the iterations.
    pub const MOST_ITERATIONS: u64 = 200_000;
}

impl Default for SettlingOptions {
    fn default() -> Self {
        Self { tolerance: Self::TOLERANCE, most_iterations: Self::MOST_ITERATIONS }
    }
}

/// Where settling stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SettlingProgress {
    /// Iterations done.
    pub iterations: u64,
    /// Share of the loads that act, 0 to 1.
    pub load: f64,
    /// Unbalanced force ratio: the largest residual force on a free node over the mean load of
    /// the free nodes. The resultant on any part of the scene is out of balance by at most this
    /// ratio times the sum of all loads.
    pub ratio: f64,
}

/// What settling did.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Settled {
    /// Iterations, each as costly as a step; those of attempts that became unstable among them.
    pub iterations: u64,
    /// Unbalanced force ratio of the state that the first step begins with.
    pub ratio: f64,
    /// Joints that broke.
    pub broken_joints: usize,
}

/// How settling ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SettlingOutcome {
    /// The scene is at rest.
    Settled(Settled),
    /// The watcher asked for the end: the scene is on its way and of no use.
    Stopped,
}

impl Simulation {
    /// Brings the scene to rest under the loads of its first instant, between [`Self::prepare`]
    /// and the first step. Afterwards all velocities are zero; step, time, masses, loads and
    /// viscosities are those of the deck again. `goes_on` is told the progress after every iteration.
    ///
    /// # Errors
    /// If the scene cannot be settled, or is not within the iterations allowed; it is of no use
    /// then.
    pub fn settle(
        &mut self,
        options: SettlingOptions,
        goes_on: &mut dyn FnMut(&SettlingProgress) -> bool,
    ) -> Result<SettlingOutcome, SettlingFault> {
        self.check_settling(options)?;
        let start = self.state();
        let failed_before = self.failures.len();
        let (mut done, mut weight) = (0, 1.0);
        for _ in 0..ATTEMPTS {
            let course = Relaxation::new(self, weight)?.run(self, options, done, goes_on);
            self.end_settling(&start);
            match course {
                Course::Settled { iterations, ratio } => {
                    let broken_joints = self.failures.len() - failed_before;
                    let settled = Settled { iterations, ratio, broken_joints };
                    return Ok(SettlingOutcome::Settled(settled));
                }
                Course::Stopped => return Ok(SettlingOutcome::Stopped),
                Course::Exhausted { ratio, load } => {
                    let SettlingOptions { tolerance, most_iterations: iterations } = options;
                    return Err(SettlingFault::NotSettled { iterations, ratio, load, tolerance });
                }
                Course::Unstable { iterations } => {
                    done = iterations;
                    weight *= HEAVIER;
                    self.restart_settling(&start)?;
                }
            }
        }
        Err(SettlingFault::Unstable)
    }

    /// Goes back to where settling began.
    fn restart_settling(&mut self, start: &SimulationState) -> Result<(), SettlingFault> {
        // it is this scene's own state; were it refused, masses would not be what is wrong
        self.restore(start.clone()).map_err(|_| SettlingFault::Unstable)?;
        self.rebuild();
        Ok(())
    }
}
