//! The kinds of structures in space, one file for each.

mod block_on_plane;
mod bridge;
mod cube;
mod two_bars;
mod two_cubes;
mod wall;

pub use block_on_plane::BlockOnPlane3d;
pub use bridge::Bridge3d;
pub use cube::Cube3d;
pub use two_bars::TwoBars3d;
pub use two_cubes::TwoCubes3d;
pub use wall::{BrickBond, Wall3d};

use super::mesh::{Place, SpatialMesh};
use crate::meshing::{
    MeshingError,
    properties::{count, positive},
};
use std::{collections::BTreeMap, ops::Range};

/// Adds a box of cells, or, without cells, one of twelve tetrahedra around its centre.
fn add_body(
    mesh: &mut SpatialMesh,
    ends: [Place; 2],
    cells: [usize; 3],
    material: usize,
) -> Result<Range<usize>, MeshingError> {
    match cells {
        [0, 0, 0] => Ok(mesh.add_centred_box(ends, material)),
        _ => mesh.add_box(ends, cells, material),
    }
}

/// Checks numbers of cells: all 0 or all above.
fn check_cells(name: &str, cells: [usize; 3]) -> Result<(), MeshingError> {
    if cells == [0; 3] {
        return Ok(());
    }
    cells.iter().try_for_each(|&n| count(name, n, 1))
}

/// Checks lengths of a box.
fn check_size(name: &str, size: [f64; 3]) -> Result<(), MeshingError> {
    size.iter().try_for_each(|&length| positive(name, length))
}

/// The area that each node bears of the outer faces whose nodes all fulfil a condition \[m²\]: a
/// third of each.
fn areas(mesh: &SpatialMesh, condition: impl Fn(Place) -> bool) -> BTreeMap<usize, f64> {
    let mut areas = BTreeMap::new();
    for (face, sides) in mesh.faces() {
        if sides.len() == 1 && face.iter().all(|&node| condition(mesh.nodes[node])) {
            let share = mesh.face_area(face) / 3.0;
            face.iter().for_each(|&node| *areas.entry(node).or_insert(0.0) += share);
        }
    }
    areas
}
