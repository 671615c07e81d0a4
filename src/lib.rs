//! Ypsilon: Munjiza's combined finite-discrete element method (FEM/DEM).
//!
//! Data flows one way: deck text → [`yformat`] → [`scene::Scene`] →
//! [`simulation::Simulation`] → [`output`]. The architecture is described in
//! `docs/src/architecture.md`.
//!
//! All quantities are in one consistent unit system chosen by the deck (SI in
//! every example); 2D bodies have unit thickness.

pub mod assessment;
pub mod bench;
pub mod cli;
pub mod contact;
pub mod insertion;
pub mod lanes;
pub mod mechanics;
pub mod meshing;
pub mod output;
pub mod scene;
pub mod session;
pub mod simulation;
pub mod stability;
pub mod sweep;
pub mod team;

/// The absolute tolerance of the original program: lengths, areas, masses and
/// area coordinates below it count as zero (spec `y2d3d.md`, notation). It
/// makes results depend on the unit system and is part of the method's
/// definition here, because states are to be equal to the original's.
pub const TOLERANCE: f64 = 1e-10;
