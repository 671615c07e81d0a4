//! What the process of one run does.

use super::BenchError;
use crate::{
    scene::Profile,
    session::{Format, RunOptions, Silent, load, run},
    simulation::{AnySimulation, PhaseTimes, SolverOptions, face_joint_views, joint_views},
    team::Team,
};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// One run of a deck.
#[derive(Debug, Clone)]
pub struct Work {
    /// The deck.
    pub deck: PathBuf,
    /// Where results go.
    pub folder: PathBuf,
    /// Steps at most; as the deck says without it.
    pub steps: Option<u64>,
    /// Whether the time of phases is taken. It costs a little time itself.
    pub takes_phases: bool,
}

/// What a run of a deck came to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Measurement {
    /// Steps done.
    pub steps: u64,
    /// Nodes at the end.
    pub nodes: usize,
    /// Triangles, or tetrahedra in 3D.
    pub triangles: usize,
    /// Joints at the start.
    pub joints: usize,
    /// Joints that broke.
    pub broken_joints: usize,
    /// Wall-clock time of the step loop, output included, s.
    pub loop_seconds: f64,
    /// Contact detections.
    pub detections: u64,
    /// Couples evaluated, summed over steps.
    pub couples_evaluated: u64,
    /// Couples at rest, summed over steps.
    pub couples_rested: u64,
    /// Wall-clock time of phases, s, if it was taken.
    pub phases: Option<PhaseTimes>,
    /// Most memory that the process has held, bytes; `None` where the system does not tell.
    pub peak_memory: Option<u64>,
}

/// Runs a deck as `ypsilon run` does, with the result files of the deck's original program.
///
/// # Errors
/// If the deck cannot be run or a file cannot be written.
pub fn work(work: &Work, team: Team) -> Result<Measurement, BenchError> {
    let solver = SolverOptions { team, ..SolverOptions::default() };
    let mut loaded = load(&work.deck, None, Profile::default(), solver)?;
    let joints = match &mut loaded.simulation {
        None => return Err(BenchError::NothingRuns(work.deck.clone())),
        Some(AnySimulation::Plane(simulation)) => {
            if work.takes_phases {
                simulation.watch_phases();
            }
            joint_views(simulation).count()
        }
        Some(AnySimulation::Spatial(simulation)) => {
            if work.takes_phases {
                simulation.watch_phases();
            }
            face_joint_views(simulation).count()
        }
    };
    let options = RunOptions {
        formats: vec![Format::Native],
        steps: work.steps,
        ..RunOptions::new(work.deck.clone(), work.folder.clone())
    };
    let summary = run(loaded, &options, &mut Silent)?;
    Ok(Measurement {
        steps: summary.steps,
        nodes: summary.nodes,
        triangles: summary.triangles + summary.tetrahedra,
        joints,
        broken_joints: summary.broken_joints,
        loop_seconds: summary.seconds,
        detections: summary.detections,
        couples_evaluated: summary.couples_evaluated,
        couples_rested: summary.couples_rested,
        phases: summary.phases,
        peak_memory: peak_memory(),
    })
}

/// The high-water mark of this process's resident memory, bytes.
fn peak_memory() -> Option<u64> {
    mark(&std::fs::read_to_string("/proc/self/status").ok()?)
}

/// `VmHWM` of a Linux status file, bytes.
fn mark(status: &str) -> Option<u64> {
    let value = status.lines().find_map(|line| line.strip_prefix("VmHWM:"))?;
    let kilobytes: u64 = value.trim().strip_suffix("kB")?.trim().parse().ok()?;
    kilobytes.checked_mul(1024)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_high_water_mark_is_read() {
        assert_eq!(mark("Name:\tx\nVmPeak:\t  9 kB\nVmHWM:\t    1234 kB\n"), Some(1234 * 1024));
        assert_eq!(mark("Name:\tx\n"), None);
        assert_eq!(mark("VmHWM: many kB\n"), None);
    }
}
