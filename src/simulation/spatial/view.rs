//! What output reads of a simulation in three dimensions.

use super::{FaceFailure, SpatialSimulation};
use crate::{
    insertion::InsertionReport,
    mechanics::{Vec3, joint3, tetrahedron},
    scene::{JointKind, Scene},
    simulation::{JointCondition, SolverOptions, StressUse},
};
use nalgebra::Matrix3;
use std::collections::HashMap;

impl SpatialSimulation {
    /// The scene with nodes and elements as they are now.
    #[must_use]
    pub fn scene(&self) -> &Scene<3> {
        &self.scene
    }

    /// What the deck does not say.
    #[must_use]
    pub fn options(&self) -> &SolverOptions {
        &self.options
    }

    /// Index of the step to be done or being done.
    #[must_use]
    pub fn step_index(&self) -> u64 {
        self.step
    }

    /// Physical time at the start of that step, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }

    /// Nodal forces of tetrahedra and contact of the last evaluation, N.
    #[must_use]
    pub fn forces(&self) -> &[Vec3] {
        &self.force
    }

    /// Nodal forces of joints of the last evaluation, N.
    #[must_use]
    pub fn joint_forces(&self) -> &[Vec3] {
        &self.joint_force
    }

    /// Nodal masses, kg.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.mass
    }

    /// From now on [`Self::stress`] is up to date only in the steps that `stress_use` names.
    pub fn keep_stresses(&mut self, stress_use: StressUse) {
        self.stress_use = stress_use;
    }

    /// Cauchy stress of a tetrahedron (with ten nodes: the mean of its points) in the last evaluation, Pa, if [`Self::keep_stresses`] has
    /// not said that nobody wants to know; zero for other elements.
    #[must_use]
    pub fn stress(&self, element: usize) -> Matrix3<f64> {
        let slot = self.plan.slot_of_element.get(element).copied().flatten();
        let quadratic = self.plan.quadratic_of_element.get(element).copied().flatten();
        match (slot, quadratic) {
            (Some(slot), _) => {
                let [block, lane] = self.plan.tetrahedra[slot as usize].place;
                self.tetrahedron_slots[block as usize].stress(lane as usize)
            }
            (None, Some(slot)) => self.quadratic_slots[slot as usize].stress,
            (None, None) => Matrix3::zeros(),
        }
    }

    /// Strain energy of a tetrahedron where its nodes are now, J; `None` for other elements.
    #[must_use]
    pub fn strain_energy(&self, element: usize) -> Option<f64> {
        let slot = self.plan.slot_of_element.get(element).copied().flatten()?;
        let planned = &self.plan.tetrahedra[slot as usize];
        let law = &self.plan.laws[planned.material as usize];
        let corners = planned.corners.map(|n| self.scene.nodes.current[n as usize]);
        Some(tetrahedron::strain_energy(law, &self.plan.reference(planned), &corners))
    }

    /// Values of the history outputs.
    #[must_use]
    pub fn probe_values(&self) -> &[f64] {
        &self.probe_values
    }

    /// Kinetic energy at the end of the previous step (0 before the first), J, as output states
    /// carry it. Only up to date in steps that write one or in scenes that record it.
    #[must_use]
    pub fn previous_kinetic_energy(&self) -> f64 {
        self.kinetic_energy
    }

    /// What joint insertion did in the first step.
    #[must_use]
    pub fn insertion_report(&self) -> Option<InsertionReport> {
        self.insertion_report
    }

    /// Joints that failed so far, in the order of their failure.
    #[must_use]
    pub fn failures(&self) -> &[FaceFailure] {
        &self.failures
    }

    /// Step and element of the first tetrahedron that turned inside out, if one has.
    #[must_use]
    pub fn first_inversion(&self) -> Option<(u64, usize)> {
        self.first_inversion
    }

    /// Whether a result state is due at this step.
    #[must_use]
    pub fn is_output_step(&self) -> bool {
        self.step.is_multiple_of(self.scene.control.output_interval)
    }

    /// Elements that are tetrahedra, ascending.
    pub fn tetrahedra(&self) -> impl Iterator<Item = usize> + '_ {
        (0..self.scene.elements.len()).filter(|&e| self.scene.material_of(e).is_some())
    }

    /// Strain energy of all tetrahedra with four nodes, J, materials ascending, elements ascending.
    #[must_use]
    pub fn sum_strain_energy(&self) -> f64 {
        let places = &self.scene.nodes.current;
        let energies = self.plan.tetrahedra.iter().map(|planned| {
            let corners = planned.corners.map(|n| places[n as usize]);
            let law = &self.plan.laws[planned.material as usize];
            tetrahedron::strain_energy(law, &self.plan.reference(planned), &corners)
        });
        energies.sum()
    }
}

/// A joint between tetrahedra as output shows it.
#[derive(Debug, Clone, Copy)]
pub struct FaceJointView {
    /// Element number.
    pub element: usize,
    /// Cohesive law that it has or had.
    pub law: usize,
    /// Nodes: three of the upper face, then those that face them.
    pub nodes: [usize; 6],
    /// Condition.
    pub condition: JointCondition,
    /// Largest damage of its points, in [0, 1].
    pub damage: f64,
    /// Opening in the middle, m.
    pub opening: f64,
    /// Sliding in the middle, m.
    pub sliding: f64,
    /// When and how it failed.
    pub failure: Option<FaceFailure>,
}

/// All joints, live and broken, elements ascending; closed faces and joints without cohesive law
/// are left out.
pub fn face_joint_views(
    simulation: &SpatialSimulation,
) -> impl Iterator<Item = FaceJointView> + '_ {
    let scene = &simulation.scene;
    let failures: HashMap<usize, FaceFailure> =
        simulation.failures.iter().map(|failure| (failure.element, *failure)).collect();
    let first_law = scene.materials.len();
    let points = scene.joint_points.points();
    (0..scene.elements.len()).filter_map(move |element| {
        let kind = scene.elements.joint_kind[element];
        if matches!(kind, JointKind::NoJoint | JointKind::FreeEdge) {
            return None;
        }
        let own = usize::try_from(scene.elements.property[element])
            .ok()
            .and_then(|property| property.checked_sub(first_law));
        let nodes = scene.elements.corners::<6>(element);
        let corners = nodes.map(|n| scene.nodes.current[n]);
        if kind.is_fracture() {
            let failure = failures.get(&element).copied();
            let (opening, sliding) = joint3::separation(&corners);
            let law = failure.map(|f| f.law).or(own).unwrap_or(0);
            let (condition, damage) = (JointCondition::Broken, 1.0);
            return Some(FaceJointView {
                element,
                law,
                nodes,
                condition,
                damage,
                opening,
                sliding,
                failure,
            });
        }
        let law = own?;
        let cohesive = scene.cohesive_laws.get(law).filter(|l| l.is_cohesive)?;
        let joint3::JointState { opening, sliding, damage, .. } =
            joint3::state(cohesive, &points, &corners);
        let condition =
            if damage > 0.0 { JointCondition::Softening } else { JointCondition::Intact };
        let failure = None;
        Some(FaceJointView { element, law, nodes, condition, damage, opening, sliding, failure })
    })
}
