//! Forces of tetrahedra and joints.

use super::{FaceFailure, SpatialSimulation};
use crate::{
    mechanics::{
        Vec3, face_load,
        joint3::{self, JointResponse, Points},
        tetrahedron, tetrahedron10,
    },
    scene::{ContactSelection, FailedJoints, JointKind, JointPoints, Scene},
    simulation::StressUse,
    team::Team,
};
use nalgebra::Matrix3;
use std::sync::atomic::{AtomicU32, Ordering};

/// From so many elements or nodes on, threads are asked.
const PARALLEL_FROM: usize = 2048;
/// Number of elements or nodes that a thread takes at a time.
const GRAIN: usize = 512;

impl JointPoints {
    /// The points.
    #[must_use]
    pub fn points(self) -> Points {
        match self {
            Self::Three => Points::THREE,
            Self::Seven => Points::SEVEN,
            Self::MidEdges => Points::MID_EDGES,
        }
    }
}

/// What a tetrahedron does to its nodes, and its stress in the last step that needed it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TetrahedronResponse {
    forces: [Vec3; 4],
    pub stress: Matrix3<f64>,
}

impl Default for TetrahedronResponse {
    fn default() -> Self {
        Self { forces: [Vec3::zeros(); 4], stress: Matrix3::zeros() }
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

impl SpatialSimulation {
    /// Sets the nodal forces to those of the tetrahedra, those with four nodes first: materials
    /// ascending, elements ascending.
    pub(super) fn add_tetrahedron_forces(&mut self) {
        let keeps_stress = self.needs_stress();
        let Self { scene, plan, tetrahedron_slots, quadratic_slots, force, options, .. } = self;
        let team = &options.team;
        let nodes = &scene.nodes;
        let inverted = AtomicU32::new(u32::MAX);
        for_each(team, tetrahedron_slots, |t, slot| {
            let planned = &plan.tetrahedra[t];
            let corners = planned.corners.map(|n| nodes.current[n as usize]);
            let velocities = planned.corners.map(|n| nodes.velocity[n as usize]);
            let law = &plan.laws[planned.material as usize];
            let (stress, volume) =
                tetrahedron::cauchy_stress(law, &planned.reference, &corners, &velocities);
            slot.forces = tetrahedron::nodal_forces(&stress, &corners);
            if keeps_stress {
                slot.stress = stress;
            }
            if volume <= 0.0 {
                inverted.fetch_min(planned.element, Ordering::Relaxed);
            }
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
                *force += slots[slot as usize / 4].forces[slot as usize % 4];
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

    /// Sets the nodal forces of joints: joint sets ascending, elements ascending. A joint that
    /// fails still acts in this step.
    pub(super) fn add_joint_forces(&mut self) {
        if self.plan.joints.is_empty() {
            return;
        }
        let Self { scene, plan, joint_slots, joint_force, options, .. } = self;
        let team = &options.team;
        let points = scene.joint_points.points();
        let places = &scene.nodes.current;
        for_each(team, joint_slots, |j, response| {
            let joint = &plan.joints[j];
            // what has failed adds zeros, which change no sum
            *response = if joint.is_live {
                let law = &scene.cohesive_laws[joint.law as usize];
                joint3::evaluate(law, &points, &joint.corners.map(|n| places[n as usize]))
            } else {
                JointResponse::default()
            };
        });
        let slots = &*joint_slots;
        for_each(team, joint_force, |n, force| {
            *force = Vec3::zeros();
            for &slot in plan.joint_shares.of(n) {
                let (joint, corner) = (slot as usize / 6, slot as usize % 6);
                let response = &slots[joint].pair_forces;
                if corner < 3 {
                    *force -= response[corner];
                } else {
                    *force += response[corner - 3];
                }
            }
        });
        let before = self.failures.len();
        for joint in 0..self.plan.joints.len() {
            if self.joint_slots[joint].fails {
                self.record_failure(joint);
            }
        }
        if self.failures.len() > before && self.scene.failed_joints == FailedJoints::Opened {
            self.open(before);
        }
    }

    /// What failed in this step becomes boundary, and contact between its sides begins at once.
    fn open(&mut self, first: usize) {
        let Self { scene, families, failures, contact, .. } = self;
        let Scene { nodes, elements, .. } = scene;
        let failed = failures[first..].iter().map(|failure| failure.element);
        let upper = failed.clone().flat_map(|joint| elements.corners::<3>(joint));
        families.flag(upper, &mut nodes.boundary_flag);
        if let Some(contact) = contact {
            contact.couple(failed.map(|joint| elements.sides[joint]), elements);
        }
    }

    fn record_failure(&mut self, joint: usize) {
        let planned = &mut self.plan.joints[joint];
        planned.is_live = false;
        let (element, law) = (planned.element as usize, planned.law as usize);
        let corners = planned.corners.map(|n| self.scene.nodes.current[n as usize]);
        self.scene.elements.joint_kind[element] = JointKind::Broken;
        if let Some(contact) = &mut self.contact
            && self.scene.conventions.selection == ContactSelection::Bodies
        {
            contact.detect_next();
        }
        let points = self.scene.joint_points.points();
        let state = joint3::state(&self.scene.cohesive_laws[law], &points, &corners);
        self.failures.push(FaceFailure {
            element,
            step: self.step,
            time: self.time,
            mode: state.mode,
            law,
            place: corners.iter().sum::<Vec3>() / 6.0,
            area: joint3::area(&corners),
        });
    }
}
