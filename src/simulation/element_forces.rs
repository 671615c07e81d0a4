use super::{
    Simulation, StressUse,
    plan::{Batch, ForcePhase},
};
use crate::{
    mechanics::{
        softening_triangle::{self, largest_stretch, soften},
        triangle::{self, Kinematics},
    },
    scene::{CohesiveModel, ElementKind},
};

impl Simulation {
    /// Internal forces of all elements in the plan's order: as much in one go as the domains
    /// of the mesh can do.
    pub(super) fn add_internal_forces(&mut self) {
        let mut next = 0;
        while next < self.plan.forces.len() {
            let reach = self.domains.reach(&self.plan, next);
            // one by one where somebody takes their times; the sums are the same
            let reach = if self.clock.is_running() { reach.min(1) } else { reach };
            if reach > 0 {
                self.add_forces_of(next..next + reach);
                self.clock.lap((&self.plan.forces[next]).into());
                next += reach;
                continue;
            }
            match self.plan.forces[next] {
                ForcePhase::Triangles(batch) => self.add_triangle_forces(next, batch),
                ForcePhase::Joints => self.add_joint_forces(),
                ForcePhase::EveryJoint(law) => self.add_classic_joint_forces(law),
                ForcePhase::LoadStep(set) => {
                    self.edge_factors[set] += self.scene.node_sets[set].edge_factor_step;
                }
            }
            self.clock.lap((&self.plan.forces[next]).into());
            next += 1;
        }
    }

    /// Whether the stresses of this step have to be kept: for output, for histories, or for
    /// what the classic dialect makes of the stresses beside its fractures, those of the
    /// previous step among them.
    pub(super) fn needs_stress(&self) -> bool {
        let scene = &self.scene;
        self.stress_use == StressUse::EveryStep
            || scene.conventions.cohesive == CohesiveModel::Classic
            || !self.plan.probes.is_empty()
            // joints that break in this step may make output due
            || scene.control.refined_output.is_some()
            || self.is_output_step()
    }

    /// Forces of the triangles of a batch after which the mesh may have changed.
    fn add_triangle_forces(&mut self, phase: usize, batch: usize) {
        if self.plan.batches[batch].kind == ElementKind::ElasticTriangle {
            self.add_forces_of(phase..phase + 1);
        }
        let batches = std::mem::take(&mut self.plan.batches);
        let batch = &batches[batch];
        if batch.kind == ElementKind::SofteningTriangle {
            self.add_softening(batch);
        }
        if self.scene.materials[batch.material].is_excavated {
            self.remove_from_play(batch);
        }
        self.plan.batches = batches;
    }

    /// Stresses and forces of softening triangles, and their masses, elements ascending.
    fn add_softening(&mut self, batch: &Batch) {
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
                self.force[node as usize] += internal;
            }
        }
    }
}
