//! Forces of tetrahedra and joints.

use super::{FaceFailure, SpatialSimulation};
use crate::{
    mechanics::{
        joint3::{self, JointResponse, Points},
        tetrahedron,
    },
    scene::{JointKind, JointPoints},
    simulation::StressUse,
};
use rayon::prelude::*;

/// Least number of elements or nodes that a thread takes at a time.
const GRAIN: usize = 512;

impl JointPoints {
    /// The points.
    #[must_use]
    pub fn points(self) -> Points {
        match self {
            Self::Three => Points::THREE,
            Self::Seven => Points::SEVEN,
        }
    }
}

impl SpatialSimulation {
    /// Sets the nodal forces to those of the tetrahedra: materials ascending, elements ascending.
    pub(super) fn add_tetrahedron_forces(&mut self) {
        let keeps_stress = self.needs_stress();
        let Self { scene, plan, stress, tetrahedron_slots, force, .. } = self;
        let (nodes, laws) = (&scene.nodes, &plan.laws);
        let exert =
            |(planned, (forces, stress)): (&super::plan::PlannedTetrahedron, (&mut _, &mut _))| {
                let corners = planned.corners.map(|n| nodes.current[n as usize]);
                let velocities = planned.corners.map(|n| nodes.velocity[n as usize]);
                let law = &laws[planned.material as usize];
                let (cauchy, volume) =
                    tetrahedron::cauchy_stress(law, &planned.reference, &corners, &velocities);
                *forces = tetrahedron::nodal_forces(&cauchy, &corners);
                if keeps_stress {
                    *stress = cauchy;
                }
                if volume > 0.0 { u32::MAX } else { planned.element }
            };
        let slots = tetrahedron_slots.par_iter_mut().zip(stress);
        let elements = plan.tetrahedra.par_iter().zip(slots).with_min_len(GRAIN);
        let inverted = elements.map(exert).reduce(|| u32::MAX, u32::min);
        let slots = &*tetrahedron_slots;
        let shares = &plan.tetrahedron_shares;
        force.par_iter_mut().enumerate().with_min_len(GRAIN).for_each(|(n, force)| {
            *force = shares.of(n).iter().fold(nalgebra::zero(), |sum, &slot| {
                sum + slots[slot as usize / 4][slot as usize % 4]
            });
        });
        if inverted != u32::MAX && self.first_inversion.is_none() {
            self.first_inversion = Some((self.step, inverted as usize));
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
        let Self { scene, plan, joint_slots, joint_force, .. } = self;
        let points = scene.joint_points.points();
        let places = &scene.nodes.current;
        plan.joints.par_iter().zip(&mut *joint_slots).with_min_len(GRAIN / 4).for_each(
            |(joint, response)| {
                *response = if joint.is_live {
                    let law = &scene.cohesive_laws[joint.law as usize];
                    joint3::evaluate(law, &points, &joint.corners.map(|n| places[n as usize]))
                } else {
                    JointResponse::default()
                };
            },
        );
        let (slots, shares) = (&*joint_slots, &plan.joint_shares);
        joint_force.par_iter_mut().enumerate().with_min_len(GRAIN).for_each(|(n, force)| {
            *force = shares.of(n).iter().fold(nalgebra::zero(), |sum, &slot| {
                let (joint, corner) = (slot as usize / 6, slot as usize % 6);
                let response = &slots[joint].pair_forces;
                if corner < 3 { sum - response[corner] } else { sum + response[corner - 3] }
            });
        });
        for joint in 0..self.plan.joints.len() {
            if self.joint_slots[joint].fails {
                self.record_failure(joint);
            }
        }
    }

    fn record_failure(&mut self, joint: usize) {
        let planned = &mut self.plan.joints[joint];
        planned.is_live = false;
        let (element, law) = (planned.element as usize, planned.law as usize);
        let corners = planned.corners.map(|n| self.scene.nodes.current[n as usize]);
        self.scene.elements.joint_kind[element] = JointKind::Broken;
        let points = self.scene.joint_points.points();
        let state = joint3::state(&self.scene.cohesive_laws[law], &points, &corners);
        self.failures.push(FaceFailure {
            element,
            step: self.step,
            time: self.time,
            mode: state.mode,
            law,
            place: corners.iter().sum::<crate::mechanics::Vec3>() / 6.0,
            area: joint3::area(&corners),
        });
    }
}
