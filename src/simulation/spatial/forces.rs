//! Forces of tetrahedra and of pressures on their faces.

use super::{SpatialSimulation, plan::TetrahedronBlock};
use crate::{
    lanes::{Kernel, LANES, Lanes, Mask as _, each, run},
    mechanics::{
        Vec3, face_load,
        tetrahedron::{SolidLaw, lanes},
        tetrahedron10,
    },
    simulation::StressUse,
    team::Team,
};
use nalgebra::Matrix3;
use std::sync::atomic::{AtomicU32, Ordering};

/// From so many elements or nodes on, threads are asked.
const PARALLEL_FROM: usize = 2048;
/// Number of elements or nodes that a thread takes at a time.
const GRAIN: usize = 512;

/// Forces of four tetrahedra on their nodes, and their stresses in the last step that needed them.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct TetrahedronResponses {
    /// Of each lane the four corners; vectors are filled up with 0.
    forces: [[f64; LANES]; 4 * LANES],
    /// Components xx, xy, xz, yy, yz, zz in all lanes.
    stress: [[f64; LANES]; 6],
}

impl TetrahedronResponses {
    /// Cauchy stress of one of them, Pa.
    pub fn stress(&self, lane: usize) -> Matrix3<f64> {
        let [xx, xy, xz, yy, yz, zz] = self.stress.map(|component| component[lane]);
        Matrix3::new(xx, xy, xz, xy, yy, yz, xz, yz, zz)
    }
}

/// Vectors of four nodes.
#[inline(always)]
pub(super) fn gather<L: Lanes>(vectors: &[Vec3], nodes: &[u32; LANES]) -> [L; 3] {
    let of = each!(4, |lane| &vectors[nodes[lane] as usize]);
    each!(3, |k| L::new(each!(4, |lane| of[lane][k])))
}

/// Writes the vectors of four lanes, each filled up with 0.
#[inline(always)]
pub(super) fn scatter<L: Lanes>(vectors: [L; 3]) -> [L; LANES] {
    let [x, y, z] = vectors;
    L::transpose([x, y, z, L::splat(0.0)])
}

/// The vector that [`scatter`] wrote.
#[inline(always)]
pub(super) fn vector([x, y, z, _]: &[f64; LANES]) -> Vec3 {
    Vec3::new(*x, *y, *z)
}

/// Evaluates blocks of tetrahedra.
struct Tetrahedra<'a> {
    blocks: &'a [TetrahedronBlock],
    responses: &'a mut [TetrahedronResponses],
    laws: &'a [SolidLaw],
    places: &'a [Vec3],
    velocities: &'a [Vec3],
    keeps_stress: bool,
    /// The lowest number of an element that has turned inside out.
    inverted: &'a AtomicU32,
}

impl Kernel for Tetrahedra<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let zero = L::splat(0.0);
        for (block, response) in self.blocks.iter().zip(self.responses) {
            let law = lanes::LawLanes::<L>::new(&self.laws[block.material as usize]);
            let corners = each!(4, |i| gather::<L>(self.places, &block.corners[i]));
            let velocities = each!(4, |i| gather::<L>(self.velocities, &block.corners[i]));
            let found = lanes::respond(&law, &block.reference, &corners, &velocities);
            for i in 0..4 {
                let forces = scatter(found.forces[i]);
                for lane in 0..LANES {
                    forces[lane].store(&mut response.forces[4 * lane + i]);
                }
            }
            if self.keeps_stress {
                let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = found.stress;
                let components = [xx, xy, xz, yy, yz, zz];
                for k in 0..6 {
                    components[k].store(&mut response.stress[k]);
                }
            }
            let inverted = found.sixfold_volume.le(zero).bits();
            if inverted != 0 {
                for lane in (0..LANES).filter(|lane| inverted & 1 << lane != 0) {
                    self.inverted.fetch_min(block.elements[lane], Ordering::Relaxed);
                }
            }
        }
    }
}

/// Does something for each item, on all threads if there are many.
pub(super) fn for_each<T: Send>(team: &Team, items: &mut [T], act: impl Fn(usize, &mut T) + Sync) {
    if items.len() < PARALLEL_FROM || team.size() == 1 {
        items.iter_mut().enumerate().for_each(|(i, item)| act(i, item));
    } else {
        team.share(items.chunks_mut(GRAIN).enumerate(), |(part, items)| {
            items.iter_mut().enumerate().for_each(|(i, item)| act(part * GRAIN + i, item));
        });
    }
}

/// The same for blocks of four, some of which a thread is given in a row, with the place of the
/// first.
pub(super) fn for_blocks<T: Send>(
    team: &Team,
    blocks: &mut [T],
    act: impl Fn(usize, &mut [T]) + Sync,
) {
    if LANES * blocks.len() < PARALLEL_FROM || team.size() == 1 {
        act(0, blocks);
    } else {
        let parts = blocks.chunks_mut(GRAIN / LANES).enumerate();
        team.share(parts, |(part, blocks)| act(part * (GRAIN / LANES), blocks));
    }
}

impl SpatialSimulation {
    /// Sets the nodal forces to those of the tetrahedra, those with four nodes first: materials
    /// ascending, elements ascending.
    pub(super) fn add_tetrahedron_forces(&mut self) {
        let keeps_stress = self.needs_stress();
        let Self { scene, plan, tetrahedron_slots, quadratic_slots, force, options, .. } = self;
        let team = &options.team;
        let nodes = &scene.nodes;
        let inverted = AtomicU32::new(u32::MAX);
        for_blocks(team, tetrahedron_slots, |first, responses| {
            run(Tetrahedra {
                blocks: &plan.tetrahedron_blocks[first..],
                responses,
                laws: &plan.laws,
                places: &nodes.current,
                velocities: &nodes.velocity,
                keeps_stress,
                inverted: &inverted,
            });
        });
        for_each(team, quadratic_slots, |t, slot| {
            let planned = &plan.quadratic[t];
            let places = planned.nodes.map(|n| nodes.current[n as usize]);
            let velocities = planned.nodes.map(|n| nodes.velocity[n as usize]);
            let law = &plan.laws[planned.material as usize];
            *slot = tetrahedron10::evaluate(law, &planned.reference, &places, &velocities);
            // what is no number has turned over, too
            if slot.least_jacobian.partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater) {
                inverted.fetch_min(planned.element, Ordering::Relaxed);
            }
        });
        let (slots, quadratic_slots) = (&*tetrahedron_slots, &*quadratic_slots);
        let has_quadratic = !quadratic_slots.is_empty();
        for_each(team, force, |n, force| {
            *force = Vec3::zeros();
            for &slot in plan.tetrahedron_shares.of(n) {
                let slot = slot as usize;
                *force += vector(&slots[slot / (4 * LANES)].forces[slot % (4 * LANES)]);
            }
            if has_quadratic {
                for &slot in plan.quadratic_shares.of(n) {
                    let nodes = tetrahedron10::NODES;
                    *force += quadratic_slots[slot as usize / nodes].forces[slot as usize % nodes];
                }
            }
        });
        let inverted = inverted.into_inner();
        if inverted != u32::MAX && self.first_inversion.is_none() {
            self.first_inversion = Some((self.step, inverted as usize));
        }
    }

    /// Adds the pressures on faces, faces ascending.
    pub(super) fn add_face_pressures(&mut self) {
        let Self { scene, plan, force, time, .. } = self;
        let rise = scene.pressure_ramp;
        let factor = if rise > 0.0 { (*time / rise).min(1.0) } else { 1.0 };
        for (nodes, pressure) in &plan.pressed_faces {
            let corners = nodes.map(|n| scene.nodes.current[n as usize]);
            let share = face_load::nodal_force(&corners, pressure * factor);
            for &n in nodes {
                force[n as usize] += share;
            }
        }
    }

    fn needs_stress(&self) -> bool {
        self.stress_use == StressUse::EveryStep || self.is_output_step()
    }
}
