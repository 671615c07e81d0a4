//! The kinds of meshes, one file for each.

mod arch;
mod block_on_plane;
mod bridge;
mod column;
mod cube;
mod dominoes;
mod rocking_block;
mod two_bars;
mod two_blocks;
mod wall;

pub use arch::Arch;
pub use block_on_plane::BlockOnPlane;
pub use bridge::{BlockBond, Bridge};
pub use column::Column;
pub use cube::{Cube, Held};
pub use dominoes::Dominoes;
pub use rocking_block::RockingBlock;
pub use two_bars::TwoBars;
pub use two_blocks::TwoBlocks;
pub use wall::Wall;

use super::{
    mesh::Mesh,
    model::{Bond, Model, Substance},
    properties::Material,
};

/// A model of separate bodies without joints.
fn bodies(title: String, mesh: Mesh, materials: Vec<(&'static str, Material)>) -> Model {
    let substance = |(name, material)| Substance { name, material, bond: Bond::Continuous };
    Model {
        title,
        area: mesh.total_area(),
        bodies: mesh.blocks,
        mesh,
        substances: materials.into_iter().map(substance).collect(),
        joints: None,
        supports: Vec::new(),
        top: Vec::new(),
        velocities: std::collections::BTreeMap::new(),
        start: Default::default(),
        second_stage_s: None,
        settled_s: 1.0,
        gravity_m_s2: -9.81,
        notes: Vec::new(),
    }
}
