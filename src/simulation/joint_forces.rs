use super::{JointFailure, Simulation, plan::PlannedJoint};
use crate::{
    mechanics::joint2::{self, JointResponse},
    scene::{BROKEN_JOINT, CohesiveLaw, ElementKind},
};
use rayon::prelude::*;

/// From so many joints on, threads pay (measured, `docs/src/performance.md`).
const PARALLEL_FROM: usize = 16_384;
/// Least number of joints that a thread takes at a time.
const GRAIN: usize = 256;

/// What a joint exerts, and its shear strength afterwards.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct EvaluatedJoint {
    response: JointResponse,
    strength: f64,
}

impl Simulation {
    /// Forces of all live joints, joint sets ascending, elements ascending.
    /// A joint that fails still acts in this step.
    ///
    /// Responses may come from any thread; they are added in this order.
    pub(super) fn add_joint_forces(&mut self) {
        let failed_before = self.failures.len();
        let joints = std::mem::take(&mut self.plan.joints);
        if joints.len() >= PARALLEL_FROM && rayon::current_num_threads() > 1 {
            let mut evaluated = std::mem::take(&mut self.evaluated_joints);
            evaluated.resize(joints.len(), EvaluatedJoint::default());
            let this = &*self;
            joints.par_iter().zip(&mut evaluated).with_min_len(GRAIN).for_each(|(joint, out)| {
                *out = this.evaluate_joint(joint);
            });
            for (joint, evaluated) in joints.iter().zip(&evaluated) {
                self.add_joint(joint, evaluated);
            }
            self.evaluated_joints = evaluated;
        } else {
            for joint in &joints {
                let evaluated = self.evaluate_joint(joint);
                self.add_joint(joint, &evaluated);
            }
        }
        self.plan.joints = joints;
        if self.failures.len() > failed_before {
            let property = &self.scene.elements.property;
            self.plan.joints.retain(|j| property[j.element as usize] != BROKEN_JOINT);
        }
    }

    #[inline]
    fn evaluate_joint(&self, joint: &PlannedJoint) -> EvaluatedJoint {
        let corners = joint.corners.map(|n| self.scene.nodes.current[n as usize]);
        let law = &self.scene.cohesive_laws[joint.law as usize];
        let mut strength = self.strength[joint.element as usize];
        let response = joint2::evaluate(law, &corners, &mut strength);
        EvaluatedJoint { response, strength }
    }

    #[inline]
    fn add_joint(&mut self, joint: &PlannedJoint, evaluated: &EvaluatedJoint) {
        let element = joint.element as usize;
        self.strength[element] = evaluated.strength;
        evaluated.response.scatter(joint.corners.map(|n| n as usize), &mut self.force);
        if evaluated.response.fails {
            self.record_failure(joint);
        }
    }

    fn record_failure(&mut self, joint: &PlannedJoint) {
        let (element, law) = (joint.element as usize, joint.law as usize);
        self.scene.elements.property[element] = BROKEN_JOINT;
        let corners = joint.corners.map(|n| self.scene.nodes.current[n as usize]);
        let cohesive = &self.scene.cohesive_laws[law];
        let mode = joint2::state(cohesive, &corners, self.strength[element]).mode;
        let (step, time) = (self.step, self.time);
        self.failures.push(JointFailure { element, step, time, mode, law });
    }

    /// Strengths at the start of a run.
    pub(super) fn set_initial_strengths(&mut self) {
        let scene = &self.scene;
        let law = |set: i32| usize::try_from(set).ok().and_then(|s| scene.cohesive_laws.get(s));
        let strength = |property: i32| {
            let material = usize::try_from(property).ok().and_then(|p| scene.materials.get(p));
            match material {
                Some(m) if m.kind == ElementKind::SofteningTriangle => {
                    law(m.joint_set).map_or(0.0, |l| l.shear_strength)
                }
                Some(_) => 0.0,
                None => law(property - scene.materials.len() as i32)
                    .map_or(0.0, CohesiveLaw::initial_shear_strength),
            }
        };
        self.strength = scene.elements.property.iter().map(|&p| strength(p)).collect();
    }
}
