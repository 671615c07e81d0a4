//! Chapter 3 of the thesis but for its wall, in plane form and in space.

mod damping;
mod elastic_impact;
mod homogeneous;
mod impact;
mod inelastic_impact;
mod one_bar;
mod pressure;
mod rotation;
mod simple_shear;
mod sliding_block;
mod two_bars;
mod uniaxial;

use crate::Case;

/// Cases of this group that are evaluated with tetrahedra as well.
pub(super) const SOLIDS: [&Case; 9] = [
    &simple_shear::SOLID,
    &uniaxial::SOLID,
    &pressure::SOLID,
    &rotation::SOLID,
    &two_bars::SOLID,
    &sliding_block::SOLID,
    &inelastic_impact::SOLID,
    &elastic_impact::SOLID,
    &damping::SOLID,
];

/// The cases of this group.
pub const CASES: &[&Case] = &[
    &simple_shear::CASE,
    &uniaxial::CASE,
    &pressure::CASE,
    &rotation::CASE,
    &two_bars::CASE,
    &one_bar::CASE,
    &sliding_block::CASE,
    &inelastic_impact::CASE,
    &elastic_impact::CASE,
    &damping::CASE,
];
