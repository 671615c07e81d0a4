use super::{model::SceneSize, settle::SettlingSummary, summary::RunSummary};
use crate::simulation::{SettlingOptions, SettlingProgress, Simulation};
use std::path::Path;
use yformat::{diagnostic::Diagnostic, source::SourceMap};

/// Where a run stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Progress {
    /// Steps done in this run.
    pub done: u64,
    /// Steps to do in this run.
    pub total: u64,
    /// Index of the step that comes next.
    pub step: u64,
    /// Physical time, s.
    pub time: f64,
    /// Kinetic energy, J.
    pub kinetic_energy: f64,
    /// Wall-clock seconds since the start.
    pub seconds: f64,
}

/// Somebody who watches a run and may stop it.
pub trait Observer {
    /// A stage of the deck begins, with so many steps to do of so many seconds each.
    fn stage_starts(&mut self, _deck: &str, _size: SceneSize, _steps: u64, _time_step: f64) {}

    /// Findings about the deck.
    fn findings(&mut self, _findings: &[Diagnostic], _sources: &SourceMap) {}

    /// The scene is brought to rest before its first step.
    fn settling_starts(&mut self, _simulation: &Simulation, _options: &SettlingOptions) {}

    /// Called now and then while it settles.
    fn settling(&mut self, _progress: &SettlingProgress) {}

    /// It is at rest.
    fn settled(&mut self, _summary: &SettlingSummary) {}

    /// A row of the run table is due.
    fn row(&mut self, _row: &str, _progress: &Progress) {}

    /// Called now and then between rows.
    fn progress(&mut self, _progress: &Progress) {}

    /// A checkpoint was written, at the step that comes next.
    fn checkpoint(&mut self, _path: &Path, _step: u64) {}

    /// Whether the run is to end at the next step.
    fn wants_stop(&self) -> bool {
        false
    }

    /// The run is over and all files are complete.
    fn finished(&mut self, _summary: &RunSummary) {}
}

/// An observer that says nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct Silent;

impl Observer for Silent {}
