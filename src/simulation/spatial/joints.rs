//! Forces of joints between tetrahedra.

use super::{
    FaceFailure, SpatialSimulation,
    forces::{for_blocks, for_each, gather, scatter, vector},
    plan::{JointBlock, PlannedJoint},
};
use crate::{
    lanes::{Kernel, LANES, Lanes, run},
    mechanics::{
        Vec3,
        joint3::{self, JointResponse, Points, intact},
    },
    scene::{CohesiveLaw, ContactSelection, FailedJoints, JointKind, JointPoints, Scene},
};

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

/// Forces of four joints across their faces.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub(super) struct JointResponses {
    /// Of each lane the three pairs of nodes; vectors are filled up with 0.
    pair_forces: [[f64; LANES]; 3 * LANES],
    /// Bit `i` is set where joint `i` fails.
    fails: u32,
}

impl JointResponses {
    fn set(&mut self, lane: usize, response: &JointResponse) {
        for (slot, force) in self.pair_forces[3 * lane..].iter_mut().zip(&response.pair_forces) {
            *slot = [force.x, force.y, force.z, 0.0];
        }
        self.fails |= u32::from(response.fails) << lane;
    }
}

/// Evaluates blocks of joints: those that soften one by one.
struct Joints<'a> {
    blocks: &'a [JointBlock],
    responses: &'a mut [JointResponses],
    joints: &'a [PlannedJoint],
    laws: &'a [CohesiveLaw],
    points: Points,
    places: &'a [Vec3],
}

impl Kernel for Joints<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        for (block, response) in self.blocks.iter().zip(self.responses) {
            let joints = &self.joints[block.joints()];
            let law = &self.laws[block.law as usize];
            response.fails = 0;
            // joints to be evaluated one by one, a bit each
            let mut alone = (1 << joints.len()) - 1;
            if intact::covers(law) {
                let mut corners = [[L::splat(0.0); 3]; 6];
                for i in 0..6 {
                    corners[i] = gather::<L>(self.places, &block.corners[i]);
                }
                let law = intact::LawLanes::<L>::new(law);
                let found = intact::evaluate(&law, &self.points, &corners);
                for i in 0..3 {
                    let forces = scatter(found.pair_forces[i]);
                    for lane in 0..LANES {
                        forces[lane].store(&mut response.pair_forces[3 * lane + i]);
                    }
                }
                alone &= found.softening;
            }
            for lane in 0..joints.len() {
                if !joints[lane].is_live {
                    // what has failed adds zeros, which change no sum
                    response.pair_forces[3 * lane..3 * lane + 3].fill([0.0; LANES]);
                } else if alone & 1 << lane != 0 {
                    let joint = &joints[lane];
                    let places = joint.corners.map(|n| self.places[n as usize]);
                    response.set(
                        lane,
                        &joint3::evaluate(&self.laws[joint.law as usize], &self.points, &places),
                    );
                }
            }
        }
    }
}

impl SpatialSimulation {
    /// Sets the nodal forces of joints: joint sets ascending, elements ascending. A joint that
    /// fails still acts in this step.
    pub(super) fn add_joint_forces(&mut self) {
        if self.plan.joints.is_empty() {
            return;
        }
        let Self { scene, plan, joint_slots, joint_force, options, .. } = self;
        let team = &options.team;
        let points = scene.joint_points.points();
        for_blocks(team, joint_slots, |first, responses| {
            run(Joints {
                blocks: &plan.joint_blocks[first..],
                responses,
                joints: &plan.joints,
                laws: &scene.cohesive_laws,
                points,
                places: &scene.nodes.current,
            });
        });
        let slots = &*joint_slots;
        for_each(team, joint_force, |n, force| {
            *force = Vec3::zeros();
            for &share in plan.joint_shares.of(n) {
                let pair = share as usize / 2;
                let response = vector(&slots[pair / (3 * LANES)].pair_forces[pair % (3 * LANES)]);
                // the upper node loses it
                if share % 2 == 1 {
                    *force -= response;
                } else {
                    *force += response;
                }
            }
        });
        let before = self.failures.len();
        for block in 0..self.plan.joint_blocks.len() {
            let mut fails = self.joint_slots[block].fails;
            while fails != 0 {
                let first = self.plan.joint_blocks[block].first;
                self.record_failure((first + fails.trailing_zeros()) as usize);
                fails &= fails - 1;
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
