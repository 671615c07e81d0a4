use crate::{
    mechanics::{
        Vec2,
        edge_load::{EdgeIntensity, apply_pressure, apply_traction},
        triangle::opposite_normal,
    },
    scene::{LoadHistory, NodeSet, Scene},
};

/// Pressures and tractions of the node sets at one instant.
pub(super) struct EdgeLoads<'a> {
    sets: &'a [NodeSet<2>],
    node_set: &'a [i32],
    history: Option<&'a LoadHistory>,
    time: f64,
}

impl<'a> EdgeLoads<'a> {
    pub fn new(scene: &'a Scene, time: f64) -> Self {
        Self {
            sets: &scene.node_sets,
            node_set: &scene.nodes.set,
            history: scene.load_history.as_ref().filter(|h| h.is_active()),
            time,
        }
    }

    /// Loads of the edge opposite to local node `i` of a triangle.
    pub fn apply(&self, i: usize, nodes: &[u32; 3], corners: &[Vec2; 3], force: &mut [Vec2]) {
        let (from, to) = (nodes[(i + 1) % 3] as usize, nodes[(i + 2) % 3] as usize);
        let (Some(a), Some(b)) = (self.set(from), self.set(to)) else { return };
        let factor = [self.factor(a), self.factor(b)];
        let [pressure, traction] = [
            EdgeIntensity { value: [self.sets[a].pressure, self.sets[b].pressure], factor },
            EdgeIntensity { value: [self.sets[a].traction, self.sets[b].traction], factor },
        ];
        let normal = opposite_normal(corners, i);
        let [mut at_from, mut at_to] = [force[from], force[to]];
        if pressure.is_active() {
            apply_pressure(&pressure, normal, &mut at_from, &mut at_to);
        }
        if traction.is_active() {
            apply_traction(&traction, normal, &mut at_from, &mut at_to);
        }
        (force[from], force[to]) = (at_from, at_to);
    }

    fn set(&self, node: usize) -> Option<usize> {
        usize::try_from(self.node_set[node]).ok().filter(|&s| s < self.sets.len())
    }

    fn factor(&self, set: usize) -> f64 {
        self.history.map_or(1.0, |h| h.factor(set, self.time))
    }
}
