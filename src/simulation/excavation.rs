//! Excavation and support (Y-Geo, spec `mechanics.md` 7.6).

use super::{Simulation, plan::Batch};
use crate::mechanics::Vec2;

/// Where the original puts the nodes of excavated triangles, from their initial place, m.
const OUT_OF_PLAY: Vec2 = Vec2::new(200.0, 200.0);
/// Node set that it gives them.
const OUT_OF_PLAY_SET: i32 = 1;

impl Simulation {
    /// Puts the nodes of excavated triangles far away, in every step.
    pub(super) fn remove_from_play(&mut self, batch: &Batch) {
        let nodes = &mut self.scene.nodes;
        for node in batch.triangles.iter().flat_map(|t| t.corners) {
            let n = node as usize;
            nodes.current[n] = nodes.initial[n] + OUT_OF_PLAY;
        }
    }

    /// Gives the nodes of excavated triangles the node set that the original gives them.
    pub(super) fn put_excavated_nodes_into_their_set(&mut self) {
        for element in 0..self.scene.elements.len() {
            if self.scene.material_of(element).is_some_and(|m| m.is_excavated) {
                for node in self.scene.elements.corners::<3>(element) {
                    self.scene.nodes.set[node] = OUT_OF_PLAY_SET;
                }
            }
        }
    }

    /// Makes the present shape of the materials that are to be supported their
    /// stress-free shape, once.
    pub(super) fn install_supports(&mut self) {
        for element in 0..self.scene.elements.len() {
            if self.scene.material_of(element).is_some_and(|m| m.resets_shape) {
                for node in self.scene.elements.corners::<3>(element) {
                    self.scene.nodes.initial[node] = self.scene.nodes.current[node];
                }
            }
        }
        for material in &mut self.scene.materials {
            material.resets_shape = false;
        }
    }
}
