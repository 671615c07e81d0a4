//! What acts on a triangle's nodes besides its stress.

use super::plan::Batch;
use crate::{
    mechanics::{
        Vec2,
        edge_load::{EdgeIntensity, apply_pressure, apply_traction},
        triangle::opposite_normal,
    },
    scene::{Condition, LoadHistory, Material, NodeSet, Scene},
};
use nalgebra::Matrix2;

/// Loads of the node sets, stress in situ and absorbing nodes at one instant.
pub(super) struct ExtraLoads<'a> {
    scene: &'a Scene,
    history: Option<&'a LoadHistory>,
    time: f64,
    /// Factor of staged loading.
    ramp: f64,
    /// Edge load factor of each node set, where there is no history.
    edge_factors: &'a [f64],
}

/// A triangle that more than its stress acts on.
pub(super) struct LoadedTriangle<'a> {
    pub batch: &'a Batch,
    pub nodes: &'a [u32; 3],
    pub corners: &'a [Vec2; 3],
    /// Stress in situ, Pa.
    in_situ: Option<Matrix2<f64>>,
}

impl<'a> LoadedTriangle<'a> {
    pub fn new(
        scene: &Scene,
        batch: &'a Batch,
        nodes: &'a [u32; 3],
        corners: &'a [Vec2; 3],
    ) -> Self {
        let in_situ = scene.in_situ.map(|stress| {
            let [a, b, c] = nodes.map(|n| scene.nodes.initial[n as usize].y);
            stress.at((a + b + c) / 3.0)
        });
        Self { batch, nodes, corners, in_situ }
    }
}

impl<'a> ExtraLoads<'a> {
    pub fn new(scene: &'a Scene, edge_factors: &'a [f64], time: f64) -> Self {
        Self {
            scene,
            history: scene.load_history.as_ref().filter(|h| h.is_active()),
            time,
            ramp: scene.ramp.map_or(1.0, |ramp| ramp.factor(time)),
            edge_factors,
        }
    }

    /// What comes right after the stress at local node `i`: the stress in situ,
    /// then the loads of the opposite edge. `force` is that of the triangle's nodes.
    pub fn apply(&self, i: usize, triangle: &LoadedTriangle<'_>, force: &mut [Vec2; 3]) {
        let normal = opposite_normal(triangle.corners, i);
        if let Some(stress) = &triangle.in_situ {
            let at = &mut force[i];
            at.x += (stress[(0, 0)] * normal.x + stress[(0, 1)] * normal.y) / 2.0;
            at.y += (stress[(1, 0)] * normal.x + stress[(1, 1)] * normal.y) / 2.0;
        }
        let [from, to] = [1, 2].map(|k| (i + k) % 3);
        let ends = [from, to].map(|k| triangle.nodes[k] as usize);
        let [Some(a), Some(b)] = ends.map(|n| self.set(n)) else { return };
        let [mut at_from, mut at_to] = [force[from], force[to]];
        let sets = [&self.scene.node_sets[a], &self.scene.node_sets[b]];
        let factor = [self.factor(a), self.factor(b)];
        for (load, apply) in [
            (sets.map(|s| s.pressure), apply_pressure as fn(&EdgeIntensity, _, &mut _, &mut _)),
            (sets.map(|s| s.traction), apply_traction),
        ] {
            if (EdgeIntensity { value: load, factor }).is_active() {
                let value = load.map(|intensity| self.ramp * intensity);
                apply(&EdgeIntensity { value, factor }, normal, &mut at_from, &mut at_to);
            }
        }
        let material = &self.scene.materials[triangle.batch.material];
        let velocities = ends.map(|n| self.scene.nodes.velocity[n]);
        absorb(material, sets, velocities, normal, [&mut at_from, &mut at_to]);
        (force[from], force[to]) = (at_from, at_to);
    }

    fn set(&self, node: usize) -> Option<usize> {
        let set = self.scene.nodes.set[node];
        usize::try_from(set).ok().filter(|&s| s < self.scene.node_sets.len())
    }

    fn factor(&self, set: usize) -> f64 {
        self.history.map_or(self.edge_factors[set], |h| h.factor(set, self.time))
    }
}

/// Damps the motion of an edge between two absorbing nodes as if the material
/// went on behind it: impedances of pressure and shear waves on the projections
/// of the edge (spec `mechanics.md` 2.3).
fn absorb(
    material: &Material,
    sets: [&NodeSet<2>; 2],
    velocities: [Vec2; 2],
    normal: Vec2,
    forces: [&mut Vec2; 2],
) {
    let rho = material.density;
    let pressure_wave = ((2.0 * material.shear_modulus + material.lame_lambda) / rho).sqrt();
    let shear_wave = (material.shear_modulus / rho).sqrt();
    let [from, to] = forces;
    for axis in 0..2 {
        if sets.iter().any(|s| s.conditions[axis] != Condition::Absorbing) {
            continue;
        }
        let [v0, v1] = velocities.map(|v| v[axis]);
        for (speed, width) in
            [(pressure_wave, normal[axis].abs()), (shear_wave, normal[1 - axis].abs())]
        {
            from[axis] -= rho * speed * v0 * width / 3.0;
            from[axis] -= rho * speed * v1 * width / 6.0;
            to[axis] -= rho * speed * v0 * width / 6.0;
            to[axis] -= rho * speed * v1 * width / 3.0;
        }
    }
}
