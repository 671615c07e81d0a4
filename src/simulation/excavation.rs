//! Excavation and support (Y-Geo, spec `mechanics.md` 7.6).

use super::{Simulation, plan::Batch};
use crate::mechanics::Vec2;

/// Where the original puts the nodes of excavated triangles, from their initial place, m.
const OUT_OF_PLAY: Vec2 = Vec2::new(200.0, 200.0);
/// Node set that it gives them.
const OUT_OF_PLAY_SET: i32 = 1;

impl Simulation {
    /// Puts the nodes of excavated triangles far away and into node set 1, in
    /// every step.
    pub(super) fn remove_from_play(&mut self, batch: &Batch) {
        let nodes = &mut self.scene.nodes;
        for node in batch.triangles.iter().flat_map(|t| t.corners) {
            let n = node as usize;
            nodes.set[n] = OUT_OF_PLAY_SET;
            nodes.current[n] = nodes.initial[n] + OUT_OF_PLAY;
        }
    }
}
