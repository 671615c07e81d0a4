//! Chapter 4 of the thesis: three arch bridges. One file for each kind of load.

mod abrupt_load;
mod family;
mod mesh_symmetry;
mod moving_loads;
mod pictures;
mod self_weight;
mod settlement;
mod static_loads;

use crate::Case;

/// The cases of this group.
pub const CASES: &[&Case] = &[
    &mesh_symmetry::CASE,
    &self_weight::CASE,
    &static_loads::POINT,
    &static_loads::DISTRIBUTED,
    &static_loads::TRAIN,
    &settlement::CASE,
    &moving_loads::SINE,
    &moving_loads::CONVOY,
    &abrupt_load::CASE,
];
