use super::{ClassicJoints, Simulation, phases::Phase};
use crate::{
    contact::{Bonds, FractureFace, FractureFaces},
    scene::{BondedPairs, ContactSum, Elements},
};

impl Simulation {
    /// Detection when it is due, then the forces of all couples.
    pub(super) fn add_contact_forces(&mut self) {
        let is_output_step = self.is_output_step();
        if self.watches_contact {
            self.contact_share.copy_from_slice(&self.force);
        }
        self.add_couples(is_output_step);
        if self.watches_contact {
            for (share, sum) in self.contact_share.iter_mut().zip(&self.force) {
                *share = sum - *share;
            }
        }
    }

    fn add_couples(&mut self, is_output_step: bool) {
        let Some(contact) = &mut self.contact else { return };
        let scene = &mut self.scene;
        let (dt, team) = (scene.control.time_step, &self.options.team);
        let bonds = match scene.conventions.bonded {
            BondedPairs::MayTouch => None,
            BondedPairs::Excluded => Some(Bonds { edge_joint: &self.classic.edge_joint }),
        };
        contact.detect(&scene.nodes, &mut scene.elements, &scene.materials, bonds, dt, team);
        self.clock.lap(Phase::Detection);
        match scene.conventions.contact_sum {
            ContactSum::WithInternal => {
                contact.interact(&scene.nodes, dt, &mut self.force, team);
            }
            ContactSum::Apart => {
                let faces = Faces { joints: &self.classic, elements: &scene.elements };
                let tally = is_output_step.then(|| {
                    self.tally.clear(scene.elements.len());
                    &mut self.tally
                });
                let forces = &mut self.contact_force;
                contact.interact_in_order(&scene.nodes, dt, &faces, tally, forces);
            }
        }
    }
}

/// Joints of the scene as contact sees them.
struct Faces<'a> {
    joints: &'a ClassicJoints,
    elements: &'a Elements,
}

impl FractureFaces for Faces<'_> {
    fn face(&self, triangle: u32, edge: usize) -> Option<FractureFace> {
        let joint = usize::try_from(self.joints.edge_joint[triangle as usize][edge]).ok()?;
        let aperture = self.joints.aperture(joint)?;
        let (stress, pressure) = (aperture.normal_stress, aperture.fluid_pressure);
        let fluid_share = pressure / stress;
        Some(FractureFace {
            kind: self.elements.joint_kind[joint],
            effective_share: if stress > 0.0 {
                1.0 - if fluid_share > 1.0 { 1.0 } else { fluid_share }
            } else {
                1.0
            },
            asperity_angle: aperture.asperity_angle,
        })
    }
}
