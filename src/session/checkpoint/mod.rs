//! Checkpoints: a run can be stopped and gone on with, bit for bit.
//!
//! A checkpoint holds the state of the simulation between two steps, how far the result files had
//! been written, and which deck and program it belongs to. What follows from the deck is not in
//! it, so that it is of use with that deck only.

mod deck_print;
mod error;
mod file;

pub(super) use deck_print::DeckPrint;
pub use error::CheckpointError;

use super::{Format, model::ModelState, restage::Entry, run::Watch, settle::SettlingSummary};
use crate::{
    output::{FilePosition, MonitorPlan},
    scene::{Profile, SpatialContact},
};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// What a run was asked for that a run that goes on with it is to do as well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunSettings {
    /// Kinds of result files.
    pub formats: Vec<Format>,
    /// Numbers of completed steps after which a full-precision state is written.
    pub states: Vec<u64>,
    /// Whether d3plot headers are exactly the original's.
    pub legacy_d3plot: bool,
    /// Program followed where the two originals of the split dialect differ.
    pub profile: Profile,
    /// Dialect that the deck was taken for, as `--dialect` calls it, if it was forced.
    pub dialect: Option<String>,
    /// The law of contact of tetrahedra.
    pub spatial_contact: SpatialContact,
    /// What is watched.
    pub monitors: MonitorPlan,
    /// What is looked after.
    pub watch: Watch,
}

/// A run between two steps.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Checkpoint {
    pub(super) settings: RunSettings,
    pub(super) deck: DeckPrint,
    /// Where the deck was.
    pub(super) deck_file: String,
    pub(super) position: Position,
    pub(super) state: ModelState,
    /// What each writer needs to go on: its kind and its mark.
    pub(super) marks: Vec<(String, Vec<u8>)>,
}

/// Where a run stands.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Position {
    /// Where the run stood when it entered its second and later stages.
    pub entries: Vec<Entry>,
    /// Last step (`MCSTEP`) of each stage that it has entered.
    pub ends: Vec<i64>,
    /// Steps done.
    pub steps: u64,
    /// Triangles times steps.
    pub triangle_steps: u64,
    /// Wall-clock seconds.
    pub seconds: f64,
    /// Warnings said so far.
    pub warnings: Vec<String>,
    /// What settling did before the first step.
    pub settling: Option<SettlingSummary>,
    /// How far the log was written.
    pub log: Option<FilePosition>,
}

impl Checkpoint {
    /// What the run was asked for.
    #[must_use]
    pub fn settings(&self) -> &RunSettings {
        &self.settings
    }

    /// Where the deck of the run was, in full.
    #[must_use]
    pub fn deck_file(&self) -> &Path {
        Path::new(&self.deck_file)
    }

    /// Index of the step that comes next.
    #[must_use]
    pub fn step_index(&self) -> u64 {
        self.state.step_index()
    }

    /// Physical time, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.state.time()
    }
}

/// When a run writes checkpoints, and which one it goes on from.
#[derive(Debug, Clone, Default)]
pub struct Checkpoints {
    /// Whether one is written when the run ends, orderly or interrupted.
    pub at_end: bool,
    /// After so many steps each, counted from step 0 of the deck.
    pub every: Option<u64>,
    /// Dialect that the deck was forced to be read in.
    pub dialect: Option<String>,
    /// Law of contact of tetrahedra that the deck was loaded with.
    pub spatial_contact: SpatialContact,
    /// Where the run goes on from.
    pub resume: Option<Checkpoint>,
}

impl Checkpoints {
    /// Whether any is written.
    #[must_use]
    pub fn are_written(&self) -> bool {
        self.at_end || self.every.is_some()
    }
}
