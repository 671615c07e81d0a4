//! What the audit of energies reads.

use super::SpatialSimulation;
use crate::{
    mechanics::{Vec3, face_load, tetrahedron, tetrahedron10},
    scene::JointKind,
    simulation::audit::{ORIGINS, Origin, strain},
};

impl SpatialSimulation {
    /// Adds the forces of the present state by their origin: the strain energy, J, where all
    /// elements have a formula for it.
    pub(in crate::simulation) fn forces_by_origin(
        &self,
        forces: &mut [Vec<Vec3>; ORIGINS],
    ) -> Option<f64> {
        let nodes = &self.scene.nodes;
        let still = |law: &tetrahedron::SolidLaw| {
            let mut elastic = *law;
            elastic.elasticity.viscosity = 0.0;
            elastic
        };
        for planned in &self.plan.tetrahedra {
            let law = &self.plan.laws[planned.material as usize];
            let corners = planned.corners.map(|n| nodes.current[n as usize]);
            let velocities = planned.corners.map(|n| nodes.velocity[n as usize]);
            let reference = self.plan.reference(planned);
            let of = |law: &tetrahedron::SolidLaw| {
                tetrahedron::cauchy_stress(law, &reference, &corners, &velocities).0
            };
            let (stress, whole) = (of(&still(law)), of(law));
            let strain = tetrahedron::nodal_forces(&stress, &corners);
            let viscous = tetrahedron::nodal_forces(&(whole - stress), &corners);
            for (i, &n) in planned.corners.iter().enumerate() {
                forces[Origin::Strain as usize][n as usize] += strain[i];
                forces[Origin::Viscosity as usize][n as usize] += viscous[i];
            }
        }
        for planned in &self.plan.quadratic {
            let law = &self.plan.laws[planned.material as usize];
            let places = planned.nodes.map(|n| nodes.current[n as usize]);
            let velocities = planned.nodes.map(|n| nodes.velocity[n as usize]);
            let of = |law: &tetrahedron::SolidLaw| {
                tetrahedron10::evaluate(law, &planned.reference, &places, &velocities).forces
            };
            let (strain, whole) = (of(&still(law)), of(law));
            for (i, &n) in planned.nodes.iter().enumerate() {
                forces[Origin::Strain as usize][n as usize] += strain[i];
                forces[Origin::Viscosity as usize][n as usize] += whole[i] - strain[i];
            }
        }
        let mut loads = vec![Vec3::zeros(); nodes.len()];
        let rise = self.scene.pressure_ramp;
        let factor = if rise > 0.0 { (self.time / rise).min(1.0) } else { 1.0 };
        for (face, pressure) in &self.plan.pressed_faces {
            let corners = face.map(|n| nodes.current[n as usize]);
            let share = face_load::nodal_force(&corners, pressure * factor);
            face.iter().for_each(|&n| loads[n as usize] += share);
        }
        for n in 0..nodes.len() {
            forces[Origin::Joints as usize][n] =
                self.joint_force.get(n).copied().unwrap_or_default();
            if self.contact.is_some() {
                let elements =
                    forces[Origin::Strain as usize][n] + forces[Origin::Viscosity as usize][n];
                forces[Origin::Contact as usize][n] = self.force[n] - elements - loads[n];
            }
        }
        let energies = self.plan.tetrahedra.iter().map(|planned| {
            let law = &self.plan.laws[planned.material as usize];
            let of = |places: &[Vec3]| planned.corners.map(|n| places[n as usize]);
            let places = [&of(&nodes.initial), &of(&nodes.current)];
            strain::of_tetrahedron(law, &self.plan.reference(planned), places)
        });
        self.plan.quadratic.is_empty().then(|| energies.sum())
    }

    /// Laws and corners of the joints that hold.
    pub(in crate::simulation) fn live_joints(
        &self,
    ) -> impl Iterator<Item = (usize, [Vec3; 6])> + '_ {
        let joints = self.plan.joints.iter().filter(|joint| joint.is_live);
        let holds =
            |element: u32| self.scene.elements.joint_kind[element as usize] == JointKind::Intact;
        joints.filter(move |joint| holds(joint.element)).map(|joint| {
            let corners = joint.corners.map(|n| self.scene.nodes.current[n as usize]);
            (joint.law as usize, corners)
        })
    }
}
