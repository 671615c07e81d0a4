//! Memory, files and time that a run takes.

use super::Facts;
use crate::simulation::AnySimulation;
use serde::Serialize;
use std::time::{Duration, Instant};

/// What a run takes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Resources {
    /// Steps of the first stage.
    pub steps: u64,
    /// Seconds for them on one core, output not counted, as the first steps went; none where
    /// nothing was timed.
    pub seconds_on_one_core: Option<f64>,
    /// Memory with the deck loaded and some steps done, bytes, where the system tells.
    pub memory_bytes: Option<u64>,
    /// States that are written.
    pub states: u64,
    /// Size of these states as d3plot and VTU together, bytes, to about a tenth.
    pub output_bytes: u64,
}

/// Steps that are timed at most, and for how long.
const TIMED_STEPS: u32 = 200;
const TIMED: Duration = Duration::from_millis(300);

impl Resources {
    pub(super) fn of(simulation: &AnySimulation, facts: &Facts) -> Self {
        let timed = match simulation {
            AnySimulation::Plane(simulation) => {
                let mut copy = simulation.clone();
                timed(|| {
                    copy.evaluate_forces();
                    copy.advance();
                })
            }
            AnySimulation::Spatial(simulation) => {
                let mut copy = simulation.clone();
                timed(|| {
                    copy.evaluate_forces();
                    copy.advance();
                })
            }
        };
        let (nodes, elements) = match simulation {
            AnySimulation::Plane(s) => (s.scene().nodes.len(), s.scene().elements.len()),
            AnySimulation::Spatial(s) => (s.scene().nodes.len(), s.scene().elements.len()),
        };
        let states = facts.steps / facts.output_interval.max(1) + 1;
        // d3plot: places and velocities of nodes in single precision, about ten values of each
        // element; VTU: places, velocities and forces in double precision, stress and properties
        let state = 24 * nodes + 40 * elements + (72 + 16) * nodes + 120 * elements;
        Self {
            steps: facts.steps,
            seconds_on_one_core: timed.map(|seconds| seconds * facts.steps as f64),
            memory_bytes: resident(),
            states,
            output_bytes: states * state as u64,
        }
    }
}

/// Seconds of one step, after a first one that looks for contact.
fn timed(mut step: impl FnMut()) -> Option<f64> {
    step();
    let start = Instant::now();
    let mut steps = 0;
    while steps < TIMED_STEPS && start.elapsed() < TIMED {
        step();
        steps += 1;
    }
    (steps > 0).then(|| start.elapsed().as_secs_f64() / f64::from(steps))
}

/// `VmRSS` of this process, bytes.
fn resident() -> Option<u64> {
    let status = std::fs::read_to_string("/proc/self/status").ok()?;
    let line = status.lines().find_map(|line| line.strip_prefix("VmRSS:"))?;
    let kilobytes: u64 = line.trim().strip_suffix("kB")?.trim().parse().ok()?;
    Some(1024 * kilobytes)
}
