use super::{
    JointFailure, Simulation,
    joint_records::{EXCAVATED, NETWORK},
    plan::PlannedJoint,
};
use crate::{
    mechanics::{
        Vec2,
        joint2::{self, JointResponse, SplitRules, YGeoRules},
    },
    scene::{CohesiveLaw, CohesiveModel, ElementKind, FractureTreatment, JointKind},
};
use std::borrow::Cow;

/// From so many joints on, threads pay (measured, `docs/src/performance.md`).
const PARALLEL_FROM: usize = 16_384;
/// Number of joints that a thread takes at a time.
const GRAIN: usize = 256;

/// What a joint exerts, and its memory afterwards.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct EvaluatedJoint {
    response: JointResponse,
    strength: f64,
    largest_damage: [f64; 3],
}

impl Simulation {
    /// Forces of all live joints that no domains hold, joint sets ascending, elements ascending.
    /// A joint that fails still acts in this step.
    ///
    /// Responses may come from any thread; they are added in this order.
    pub(super) fn add_joint_forces(&mut self) {
        let failed_before = self.failures.len();
        let joints = std::mem::take(&mut self.plan.joints);
        if joints.len() >= PARALLEL_FROM && self.options.team.size() > 1 {
            let mut evaluated = std::mem::take(&mut self.evaluated_joints);
            evaluated.resize(joints.len(), EvaluatedJoint::default());
            let this = &*self;
            let parts = joints.chunks(GRAIN).zip(evaluated.chunks_mut(GRAIN));
            this.options.team.share(parts, |(joints, evaluated)| {
                for (joint, evaluated) in joints.iter().zip(evaluated) {
                    *evaluated = this.evaluate_joint(joint);
                }
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
            let kind = &self.scene.elements.joint_kind;
            self.plan.joints.retain(|j| kind[j.element as usize] == JointKind::Intact);
        }
    }

    #[inline]
    fn evaluate_joint(&self, joint: &PlannedJoint) -> EvaluatedJoint {
        let element = joint.element as usize;
        let corners = joint.corners.map(|n| self.scene.nodes.current[n as usize]);
        let mut strength = self.strength[element];
        let mut largest_damage = [0.0; 3];
        let response = match self.scene.conventions.cohesive {
            CohesiveModel::YGeo => {
                let law = self.law_of(joint, &corners);
                largest_damage = self.joint_records[element].largest_damage;
                let memory = self.scene.hysteretic_joints.then_some(&mut largest_damage);
                joint2::evaluate::<YGeoRules>(&law, &corners, &mut strength, memory)
            }
            _ => {
                let law = &self.scene.cohesive_laws[joint.law as usize];
                joint2::evaluate::<SplitRules>(law, &corners, &mut strength, None)
            }
        };
        EvaluatedJoint { response, strength, largest_damage }
    }

    /// The law of a joint as its fracture network and its direction make it.
    pub(super) fn law_of(&self, joint: &PlannedJoint, corners: &[Vec2; 4]) -> Cow<'_, CohesiveLaw> {
        let law = &self.scene.cohesive_laws[joint.law as usize];
        let fracture = usize::try_from(self.scene.elements.fracture[joint.element as usize]).ok();
        if let (Some(network), Some(fracture)) = (&self.scene.fracture_network, fracture)
            && network.treatment(fracture) == FractureTreatment::Cohesive
        {
            return Cow::Owned(network.cohesive_law(law));
        }
        match &law.layering {
            None => Cow::Borrowed(law),
            Some(layering) => Cow::Owned(law.along(layering, corners[1] - corners[0])),
        }
    }

    #[inline]
    fn add_joint(&mut self, joint: &PlannedJoint, evaluated: &EvaluatedJoint) {
        let element = joint.element as usize;
        if self.scene.conventions.cohesive == CohesiveModel::YGeo {
            if self.touches_excavation(element) {
                self.record_failure(joint, EXCAVATED);
                return;
            }
            self.record_joint(joint, &evaluated.response);
            self.joint_records[element].largest_damage = evaluated.largest_damage;
        }
        let strength_before = std::mem::replace(&mut self.strength[element], evaluated.strength);
        evaluated.response.scatter(joint.corners.map(|n| n as usize), &mut self.force);
        if let Some(point) = evaluated.response.failed_point {
            let mode = self.failure_mode(joint, strength_before, usize::from(point));
            self.record_failure(joint, mode);
        } else if self.breaks_at_first_step(element) {
            self.record_failure(joint, NETWORK);
        }
    }

    /// Whether the joint lies on a fracture that is open from the start on,
    /// in a network that says so fracture by fracture.
    fn breaks_at_first_step(&self, element: usize) -> bool {
        let Some(network) = &self.scene.fracture_network else { return false };
        usize::try_from(self.scene.elements.fracture[element])
            .is_ok_and(|f| network.treatment(f) == FractureTreatment::Broken)
    }

    fn failure_mode(&self, joint: &PlannedJoint, strength_before: f64, point: usize) -> f64 {
        let corners = joint.corners.map(|n| self.scene.nodes.current[n as usize]);
        match self.scene.conventions.cohesive {
            CohesiveModel::YGeo => {
                let law = self.law_of(joint, &corners);
                let (points, limits) = joint2::points::<YGeoRules>(&law, &corners, strength_before);
                points[point].failure_mode(&limits)
            }
            _ => {
                let law = &self.scene.cohesive_laws[joint.law as usize];
                let strength = self.strength[joint.element as usize];
                joint2::state::<SplitRules>(law, &corners, strength).mode
            }
        }
    }

    /// Records a joint that has failed at a point, once its strength is that of this step
    /// (split dialect).
    pub(super) fn record_broken(&mut self, joint: &PlannedJoint, point: usize) {
        let strength = self.strength[joint.element as usize];
        let mode = self.failure_mode(joint, strength, point);
        self.record_failure(joint, mode);
    }

    fn record_failure(&mut self, joint: &PlannedJoint, mode: f64) {
        let (element, law) = (joint.element as usize, joint.law as usize);
        self.scene.elements.joint_kind[element] = JointKind::Broken;
        let [a, b, c, d] = joint.corners.map(|n| self.scene.nodes.current[n as usize]);
        self.failures.push(JointFailure {
            element,
            step: self.step,
            time: self.time,
            mode,
            law,
            place: (a + b + c + d) / 4.0,
            length: (a - b).norm(),
        });
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
