//! Turns the bytes of records into geometry and states.

use super::geometry::{Geometry, Shell, Solid};
use super::layout::StateLayout;
use super::state::State;

/// The words of a record, taken one after the other; what the record lacks reads as 0.
struct Words<'a>(std::slice::ChunksExact<'a, u8>);

impl Words<'_> {
    fn next_bytes(&mut self) -> [u8; 4] {
        match self.0.next() {
            Some(&[a, b, c, d]) => [a, b, c, d],
            _ => [0; 4],
        }
    }
    fn float(&mut self) -> f32 {
        f32::from_le_bytes(self.next_bytes())
    }
    fn integer(&mut self) -> i32 {
        i32::from_le_bytes(self.next_bytes())
    }
    fn integers<const N: usize>(&mut self) -> [i32; N] {
        std::array::from_fn(|_| self.integer())
    }
    fn vectors(&mut self, count: u64, into: &mut Vec<[f32; 3]>) {
        into.clear();
        into.extend((0..count).map(|_| [self.float(), self.float(), self.float()]));
    }
    fn floats(&mut self, count: u64, into: &mut Vec<f32>) {
        into.clear();
        into.extend((0..count).map(|_| self.float()));
    }
}

/// The geometry section.
pub(super) fn geometry(layout: &StateLayout, bytes: &[u8]) -> Geometry {
    let mut words = Words(bytes.chunks_exact(4));
    let mut geometry = Geometry::default();
    words.vectors(layout.nodes, &mut geometry.coordinates);
    geometry.solids = (0..layout.solids)
        .map(|_| Solid { nodes: words.integers(), material: words.integer() })
        .collect();
    geometry.shells = (0..layout.shells)
        .map(|_| Shell { nodes: words.integers(), material: words.integer() })
        .collect();
    geometry
}

/// One state, into memory that is used again.
pub(super) fn state(layout: &StateLayout, bytes: &[u8], into: &mut State) {
    let mut words = Words(bytes.chunks_exact(4));
    into.time = words.float();
    words.floats(layout.globals, &mut into.globals);
    let of = |there: bool| if there { layout.nodes } else { 0 };
    words.vectors(of(layout.vectors[0]), &mut into.coordinates);
    words.vectors(of(layout.vectors[1]), &mut into.velocities);
    words.vectors(of(layout.vectors[2]), &mut into.accelerations);
    words.floats(layout.solids * layout.words_per_solid, &mut into.solid_data);
    words.floats(layout.shells * layout.words_per_shell, &mut into.shell_data);
    words.floats(layout.deletion_table, &mut into.deletion_table);
}
