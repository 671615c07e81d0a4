use super::{
    Simulation,
    extra_loads::{ExtraLoads, LoadedTriangle},
    plan::{Batch, PlannedTriangle},
};
use crate::{
    mechanics::{
        Vec2,
        softening_triangle::{self, largest_stretch, soften},
        triangle::{self, Kinematics},
    },
    scene::{ElementKind, Nodes},
};
use multiversion::multiversion;
use nalgebra::Matrix2;
use rayon::prelude::*;

/// From so many triangles of a material on, threads pay (measured,
/// `docs/src/performance.md`).
const PARALLEL_FROM: usize = 16_384;
/// Least number of triangles that a thread takes at a time.
const GRAIN: usize = 512;

/// Stress and internal nodal forces of a triangle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct TriangleResponse {
    stress: Matrix2<f64>,
    forces: [Vec2; 3],
}

impl TriangleResponse {
    #[inline(always)]
    fn of_elastic(batch: &Batch, planned: &PlannedTriangle, nodes: &Nodes<2>) -> Self {
        let [a, b, c] = planned.corners;
        let at = |values: &[Vec2]| [values[a as usize], values[b as usize], values[c as usize]];
        let corners = at(&nodes.current);
        let stress =
            triangle::cauchy_stress(&batch.law, &planned.reference, &corners, &at(&nodes.velocity));
        Self { stress, forces: triangle::nodal_forces(&stress, &corners) }
    }
}

impl Simulation {
    /// Stresses and internal forces of the triangles of a batch, elements
    /// ascending, nodes of an element in turn, the loads of the opposite edge
    /// right after each node.
    ///
    /// Responses may come from any thread; they are added in this order, so
    /// that sums round the same on any number of threads.
    pub(super) fn add_triangle_forces(&mut self, batch: usize) {
        let batches = std::mem::take(&mut self.plan.batches);
        let mut force = std::mem::take(&mut self.force);
        let batch = &batches[batch];
        if batch.kind == ElementKind::ElasticTriangle {
            self.add_elastic(batch, &mut force);
        } else {
            self.add_softening(batch, &mut force);
        }
        self.force = force;
        if self.scene.materials[batch.material].is_excavated {
            self.remove_from_play(batch);
        }
        self.plan.batches = batches;
    }

    fn add_elastic(&mut self, batch: &Batch, force: &mut [Vec2]) {
        if batch.triangles.len() >= PARALLEL_FROM && rayon::current_num_threads() > 1 {
            let mut responses = std::mem::take(&mut self.responses);
            responses.resize(batch.triangles.len(), TriangleResponse::default());
            let nodes = &self.scene.nodes;
            let (planned, out) = (&batch.triangles, &mut responses);
            planned.par_iter().zip(out).with_min_len(GRAIN).for_each(|(planned, out)| {
                *out = TriangleResponse::of_elastic(batch, planned, nodes);
            });
            for (planned, response) in batch.triangles.iter().zip(&responses) {
                self.add_response(batch, planned, response, force);
            }
            self.responses = responses;
        } else {
            add_elastic_serially(self, batch, force);
        }
    }

    #[inline(always)]
    fn add_response(
        &mut self,
        batch: &Batch,
        planned: &PlannedTriangle,
        response: &TriangleResponse,
        force: &mut [Vec2],
    ) {
        self.stress[planned.element as usize] = response.stress;
        if planned.has_extras {
            self.add_loaded_response(batch, planned, response, force);
        } else {
            for (&node, internal) in planned.corners.iter().zip(&response.forces) {
                force[node as usize] += internal;
            }
        }
    }

    #[cold]
    #[inline(never)]
    fn add_loaded_response(
        &self,
        batch: &Batch,
        planned: &PlannedTriangle,
        response: &TriangleResponse,
        force: &mut [Vec2],
    ) {
        let corners = planned.corners.map(|n| self.scene.nodes.current[n as usize]);
        let triangle = LoadedTriangle::new(&self.scene, batch, &planned.corners, &corners);
        let loads = ExtraLoads::new(&self.scene, &self.edge_factors, self.time);
        for i in 0..3 {
            force[planned.corners[i] as usize] += response.forces[i];
            loads.apply(i, &triangle, force);
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

/// Compiled for several instruction sets and chosen at run time; all give the
/// same bits, because nothing is fused or reassociated.
#[multiversion(targets("x86_64+avx2+bmi1+bmi2+lzcnt", "x86_64+avx"))]
fn add_elastic_serially(simulation: &mut Simulation, batch: &Batch, force: &mut [Vec2]) {
    for planned in &batch.triangles {
        let response = TriangleResponse::of_elastic(batch, planned, &simulation.scene.nodes);
        simulation.add_response(batch, planned, &response, force);
    }
}
