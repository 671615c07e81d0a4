//! What output reads of a simulation.

use super::Simulation;
use crate::{
    contact::CoupleWork,
    insertion::InsertionReport,
    mechanics::{Vec2, joint2, joint2::JointState},
    scene::{BROKEN_JOINT, CLOSED_EDGE, Scene},
};
use nalgebra::Matrix2;

impl Simulation {
    /// The scene with nodes and elements as they are now.
    #[must_use]
    pub fn scene(&self) -> &Scene {
        &self.scene
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

    /// Nodal forces of the last evaluation, N.
    #[must_use]
    pub fn forces(&self) -> &[Vec2] {
        &self.force
    }

    /// Nodal masses, kg.
    #[must_use]
    pub fn masses(&self) -> &[f64] {
        &self.mass
    }

    /// Cauchy stresses of the last evaluation, one per element, Pa.
    #[must_use]
    pub fn stresses(&self) -> &[Matrix2<f64>] {
        &self.stress
    }

    /// Values of the history outputs.
    #[must_use]
    pub fn probe_values(&self) -> &[f64] {
        &self.probe_values
    }

    /// Kinetic energy at the end of the previous step (0 before the first), J,
    /// as output states carry it. Only up to date in steps that write one or
    /// in scenes that record it.
    #[must_use]
    pub fn previous_kinetic_energy(&self) -> f64 {
        self.kinetic_energy
    }

    /// Contact work done so far.
    #[must_use]
    pub fn couple_work(&self) -> Option<CoupleWork> {
        self.contact.as_ref().map(crate::contact::Contact::work)
    }

    /// What meshing did in the first step.
    #[must_use]
    pub fn insertion_report(&self) -> Option<InsertionReport> {
        self.insertion_report
    }

    /// Number of joints that failed so far.
    #[must_use]
    pub fn broken_joints(&self) -> usize {
        self.broken_joints
    }
}

/// A joint as output shows it.
#[derive(Debug, Clone, Copy)]
pub struct JointView {
    /// Element number.
    pub element: usize,
    /// Cohesive law, unless the joint is broken.
    pub law: Option<usize>,
    /// Nodes a, b, c, d.
    pub nodes: [usize; 4],
    /// Opening, sliding and damage, for live joints.
    pub state: Option<JointState>,
}

/// All joints, live and broken; closed edges are left out.
pub fn joint_views(simulation: &Simulation) -> impl Iterator<Item = JointView> + '_ {
    let scene = &simulation.scene;
    (0..scene.elements.len()).filter_map(move |element| {
        let property = scene.elements.property[element];
        let nodes = scene.elements.nodes[element];
        if property == CLOSED_EDGE || nodes[3] < 0 {
            return None;
        }
        let nodes = [0, 1, 2, 3].map(|i| nodes[i] as usize);
        if property == BROKEN_JOINT {
            return Some(JointView { element, law: None, nodes, state: None });
        }
        let law = usize::try_from(property).ok()?.checked_sub(scene.materials.len())?;
        let cohesive = scene.cohesive_laws.get(law)?;
        let corners = nodes.map(|n| scene.nodes.current[n]);
        let state = joint2::state(cohesive, &corners, simulation.strength[element]);
        Some(JointView { element, law: Some(law), nodes, state: Some(state) })
    })
}
