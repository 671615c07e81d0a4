use super::settle::SettlingSummary;
use crate::{output::EnergySummary, simulation::PhaseTimes};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// Why a run ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum StopReason {
    /// All steps are done.
    Finished,
    /// The user asked it to stop.
    Interrupted,
}

/// What a run did, for people and for scripts (`--formats json`).
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct RunSummary {
    /// Version of Ypsilon.
    pub version: String,
    /// The deck.
    pub deck: PathBuf,
    /// Why the run ended.
    pub stop: StopReason,
    /// Steps done, those before a checkpoint that the run goes on from among them.
    pub steps: u64,
    /// Physical time at the end, s.
    pub time: f64,
    /// Nodes at the end.
    pub nodes: usize,
    /// Triangles at the end.
    pub triangles: usize,
    /// Tetrahedra at the end.
    #[serde(default)]
    pub tetrahedra: usize,
    /// Joints that failed.
    pub broken_joints: usize,
    /// Kinetic energy at the end, J.
    pub kinetic_energy: f64,
    /// Wall-clock seconds of the step loop, output included.
    pub seconds: f64,
    /// Triangles, or tetrahedra in 3D, times steps per second.
    pub triangle_steps_per_second: f64,
    /// Contact detections.
    pub detections: u64,
    /// Couples evaluated.
    pub couples_evaluated: u64,
    /// Couples that were at rest and needed no evaluation.
    pub couples_rested: u64,
    /// What settling did before the first step, if the run was asked to settle.
    pub settling: Option<SettlingSummary>,
    /// Where the time went, if it was taken
    /// ([`Simulation::watch_phases`](crate::simulation::Simulation::watch_phases)).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub phases: Option<PhaseTimes>,
    /// Where the energy went, if the run was asked to watch it (`--energy`).
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub energy: Option<EnergySummary>,
    /// Step of the checkpoint that the run went on from.
    pub resumed_at: Option<u64>,
    /// Warnings about the deck.
    pub warnings: Vec<String>,
    /// Result files.
    pub files: Vec<PathBuf>,
}
