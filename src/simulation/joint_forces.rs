use super::{JointFailure, Simulation};
use crate::{
    mechanics::joint2,
    scene::{BROKEN_JOINT, ElementKind},
};

impl Simulation {
    /// Forces of all live joints, joint sets ascending, elements ascending.
    /// A joint that fails still acts in this step.
    pub(super) fn add_joint_forces(&mut self) {
        let failed_before = self.failures.len();
        for joint in &self.plan.joints {
            let element = joint.element as usize;
            let corners = joint.corners.map(|n| self.scene.nodes.current[n as usize]);
            let law = &self.scene.cohesive_laws[joint.law as usize];
            let response = joint2::evaluate(law, &corners, &mut self.strength[element]);
            response.scatter(joint.corners.map(|n| n as usize), &mut self.force);
            if response.fails {
                self.scene.elements.property[element] = BROKEN_JOINT;
                let mode = joint2::state(law, &corners, self.strength[element]).mode;
                self.failures.push(JointFailure {
                    element,
                    step: self.step,
                    time: self.time,
                    mode,
                    law: joint.law as usize,
                });
            }
        }
        if self.failures.len() > failed_before {
            let property = &self.scene.elements.property;
            self.plan.joints.retain(|j| property[j.element as usize] != BROKEN_JOINT);
        }
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
                    .map_or(0.0, crate::scene::CohesiveLaw::initial_shear_strength),
            }
        };
        self.strength = scene.elements.property.iter().map(|&p| strength(p)).collect();
    }
}
