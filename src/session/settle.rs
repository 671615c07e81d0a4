//! Settling before the first step of a run.

use super::{
    model::Model,
    observer::Observer,
    run::{RunError, RunOptions},
};
use crate::simulation::{
    Settled, SettlingFault, SettlingOutcome, SettlingProgress, Simulation, Unsettleable,
};
use serde::{Deserialize, Serialize};
use std::time::{Duration, Instant};

/// Time between two looks at the progress.
const PROGRESS_INTERVAL: Duration = Duration::from_millis(100);
/// Iterations between two looks at the clock.
const CLOCK_INTERVAL: u64 = 16;

/// What settling did before the first step (`--settle`).
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct SettlingSummary {
    /// What was done.
    pub settled: Settled,
    /// Unbalanced force ratio that was asked for.
    pub tolerance: f64,
    /// Wall-clock seconds.
    pub seconds: f64,
}

/// Brings the scene to rest if the run is asked to; none if the observer wanted the end.
pub(super) fn settle(
    options: &RunOptions,
    simulation: &mut Simulation,
    observer: &mut dyn Observer,
) -> Result<Option<SettlingSummary>, RunError> {
    let Some(settling) = options.settling else { return Ok(None) };
    let started = Instant::now();
    let mut shown = started;
    observer.settling_starts(simulation, &settling);
    let mut goes_on = |progress: &SettlingProgress| {
        if progress.iterations.is_multiple_of(CLOCK_INTERVAL) && shown.elapsed() > PROGRESS_INTERVAL
        {
            shown = Instant::now();
            observer.settling(progress);
        }
        !observer.wants_stop()
    };
    let outcome = simulation.settle(settling, &mut goes_on)?;
    let SettlingOutcome::Settled(settled) = outcome else { return Ok(None) };
    let seconds = started.elapsed().as_secs_f64();
    let summary = SettlingSummary { settled, tolerance: settling.tolerance, seconds };
    observer.settled(&summary);
    Ok(Some(summary))
}

/// Whether settling makes sense, before any file is touched. A run that goes on from a checkpoint
/// has had its first step.
pub(super) fn check_start(
    options: &RunOptions,
    is_resumed: bool,
    simulation: Option<&impl Model>,
) -> Result<(), SettlingFault> {
    match (options.settling, simulation) {
        (Some(_), _) if is_resumed => Err(Unsettleable::Resumed.into()),
        (Some(settling), Some(simulation)) => simulation.check_settling(settling),
        _ => Ok(()),
    }
}
