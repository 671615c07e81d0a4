use super::{Simulation, edge_loads::EdgeLoads, plan::Batch};
use crate::{
    mechanics::{
        Vec2,
        softening_triangle::{self, largest_stretch, soften},
        triangle::{self, Kinematics},
    },
    scene::ElementKind,
};

impl Simulation {
    /// Stresses and internal forces of all triangles, materials ascending,
    /// elements ascending, nodes of an element in turn, the load of the
    /// opposite edge right after each node.
    pub(super) fn add_element_forces(&mut self) {
        let batches = std::mem::take(&mut self.plan.batches);
        let mut force = std::mem::take(&mut self.force);
        for batch in &batches {
            if batch.kind == ElementKind::ElasticTriangle {
                self.add_elastic(batch, &mut force);
            } else {
                self.add_softening(batch, &mut force);
            }
        }
        self.plan.batches = batches;
        self.force = force;
        self.record_element_probes();
    }

    fn add_elastic(&mut self, batch: &Batch, force: &mut [Vec2]) {
        let nodes = &self.scene.nodes;
        for planned in &batch.triangles {
            let corners = planned.corners.map(|n| nodes.current[n as usize]);
            let velocities = planned.corners.map(|n| nodes.velocity[n as usize]);
            let stress = triangle::cauchy_stress(
                &batch.elasticity,
                &planned.reference,
                &corners,
                &velocities,
            );
            self.stress[planned.element as usize] = stress;
            let internal = triangle::nodal_forces(&stress, &corners);
            if planned.has_loaded_edge {
                let loads = EdgeLoads::new(&self.scene, self.time);
                for i in 0..3 {
                    force[planned.corners[i] as usize] += internal[i];
                    loads.apply(i, &planned.corners, &corners, force);
                }
            } else {
                for (&node, internal) in planned.corners.iter().zip(&internal) {
                    force[node as usize] += internal;
                }
            }
        }
    }

    fn add_softening(&mut self, batch: &Batch, force: &mut [Vec2]) {
        let material = &self.scene.materials[batch.material];
        let nodes = &self.scene.nodes;
        for planned in &batch.triangles {
            let element = planned.element as usize;
            let corners = planned.corners.map(|n| nodes.current[n as usize]);
            let velocities = planned.corners.map(|n| nodes.velocity[n as usize]);
            let kinematics = Kinematics::new(&planned.reference, &corners, &velocities);
            let damage = &mut self.scene.elements.state[material.damage_row as usize][element];
            let softening = soften(
                damage,
                largest_stretch(&kinematics.left_cauchy_green),
                material.softening_stretch,
                self.strength[element],
            );
            let stress = softening_triangle::cauchy_stress(
                &batch.elasticity,
                &planned.reference,
                &kinematics,
                softening.loss,
            );
            self.stress[element] = stress;
            let internal = triangle::nodal_forces(&stress, &corners);
            let mass =
                softening.mass_factor * material.density * planned.reference.double_area / 6.0;
            for (&node, internal) in planned.corners.iter().zip(&internal) {
                self.mass[node as usize] += mass;
                force[node as usize] += internal;
            }
        }
    }
}
