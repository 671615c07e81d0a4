//! What output reads of a simulation.

use super::{Simulation, StressUse, plan::stress_law};
use crate::{
    contact::{CoupleWork, Tally},
    insertion::InsertionReport,
    mechanics::{
        Vec2,
        joint2::{self, JointState, SplitRules, YGeoRules},
        triangle::{Kinematics, ReferenceShape, cauchy_stress, strain_energy},
    },
    scene::{CohesiveModel, ElementKind, JointKind, Scene},
};
use nalgebra::Matrix2;
use serde::{Deserialize, Serialize};
use std::collections::HashMap;

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

    /// Contact forces of the last evaluation, where they are summed apart
    /// (classic); empty elsewhere, N.
    #[must_use]
    pub fn contact_forces(&self) -> &[Vec2] {
        &self.contact_force
    }

    /// Contactor, target and sliding of all couples: contactors ascending, the
    /// newest couple of each first.
    #[must_use]
    pub fn couples(&self) -> Vec<([u32; 2], [f64; 6])> {
        self.contact.as_ref().map_or_else(Vec::new, crate::contact::Contact::couples)
    }

    /// Shear strength of a joint, Pa (split and Y-Geo).
    #[must_use]
    pub fn joint_strength(&self, element: usize) -> f64 {
        self.strength.get(element).copied().unwrap_or(0.0)
    }

    /// From now on [`Self::stresses`] are up to date only in the steps that `stress_use` names.
    pub fn keep_stresses(&mut self, stress_use: StressUse) {
        self.stress_use = stress_use;
    }

    /// Cauchy stresses of the last evaluation, one per element up to the last that is no joint, Pa,
    /// if [`Self::keep_stresses`] has not said that nobody wants to know.
    #[must_use]
    pub fn stresses(&self) -> &[Matrix2<f64>] {
        &self.stress
    }

    /// Values of the history outputs.
    #[must_use]
    pub fn probe_values(&self) -> &[f64] {
        &self.probe_values
    }

    /// Factor on pressure and traction of each node set.
    #[must_use]
    pub fn edge_factors(&self) -> &[f64] {
        &self.edge_factors
    }

    /// Contact forces of each element in the last output step (classic).
    #[must_use]
    pub fn contact_tally(&self) -> &Tally {
        &self.tally
    }

    /// Joints that began to yield in this step, in the order of their evaluation.
    #[must_use]
    pub fn yielded_now(&self) -> &[usize] {
        &self.yielded_now
    }

    /// Cauchy stress of an elastic triangle where its nodes are now, Pa.
    #[must_use]
    pub fn present_stress(&self, element: usize) -> Option<Matrix2<f64>> {
        Some(self.present_state(element)?.0)
    }

    /// Cauchy stress, Pa, and strain ½(B − I) of an elastic triangle where its
    /// nodes are now.
    #[must_use]
    pub fn present_state(&self, element: usize) -> Option<(Matrix2<f64>, Matrix2<f64>)> {
        let scene = &self.scene;
        let material = scene.material_of(element)?;
        if material.kind != ElementKind::ElasticTriangle {
            return None;
        }
        let nodes = scene.elements.corners::<3>(element);
        let reference = ReferenceShape::new(&nodes.map(|n| scene.nodes.initial[n]));
        let law = stress_law(material, scene.conventions.volumetric);
        let corners = nodes.map(|n| scene.nodes.current[n]);
        let velocities = nodes.map(|n| scene.nodes.velocity[n]);
        let kinematics = Kinematics::new(&reference, &corners, &velocities);
        Some((cauchy_stress(&law, &reference, &corners, &velocities), kinematics.strain()))
    }

    /// Strain energy of an elastic triangle where its nodes are now, J; `None` for other
    /// elements.
    #[must_use]
    pub fn strain_energy(&self, element: usize) -> Option<f64> {
        let scene = &self.scene;
        let material = scene.material_of(element)?;
        if material.kind != ElementKind::ElasticTriangle {
            return None;
        }
        let nodes = scene.elements.corners::<3>(element);
        let reference = ReferenceShape::new(&nodes.map(|n| scene.nodes.initial[n]));
        let law = stress_law(material, scene.conventions.volumetric);
        Some(strain_energy(&law, &reference, &nodes.map(|n| scene.nodes.current[n])))
    }

    /// From now on contact forces can be told apart ([`Self::contact_share`]).
    pub fn watch_contact_forces(&mut self) {
        self.watches_contact = true;
        self.contact_share.resize(self.scene.nodes.len(), Vec2::zeros());
    }

    /// Contact forces of the last evaluation, N: those summed apart (classic), elsewhere what
    /// contact added to the nodal forces, right to rounding of these. Empty unless
    /// [`Self::watch_contact_forces`] was called or they are summed apart.
    #[must_use]
    pub fn contact_share(&self) -> &[Vec2] {
        if self.contact_force.is_empty() { &self.contact_share } else { &self.contact_force }
    }

    /// Times at which they were refreshed last, s.
    #[must_use]
    pub fn probe_times(&self) -> &[f64] {
        &self.probe_times
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

    /// Joints that failed so far, in the order of their failure.
    #[must_use]
    pub fn failures(&self) -> &[JointFailure] {
        &self.failures
    }

    /// Whether a result state is due at this step.
    #[must_use]
    pub fn is_output_step(&self) -> bool {
        let control = &self.scene.control;
        let interval = match control.refined_output {
            Some(refined) if self.failures.len() as u64 > refined.broken_joints => refined.interval,
            _ => control.output_interval,
        };
        self.step.is_multiple_of(interval)
    }

    /// Elements that are triangles, ascending.
    pub fn triangles(&self) -> impl Iterator<Item = usize> + '_ {
        let scene = &self.scene;
        (0..scene.elements.len()).filter(|&e| scene.material_of(e).is_some())
    }

    /// Damage of each element, if the scene has softening triangles: 0 where
    /// there is none, −1 for triangles that have detached.
    #[must_use]
    pub fn triangle_damage(&self) -> Option<Vec<f64>> {
        let softens = |e: usize| {
            let material = self.scene.material_of(e);
            material.filter(|m| m.kind == ElementKind::SofteningTriangle)
        };
        let elements = &self.scene.elements;
        (0..elements.len()).any(|e| softens(e).is_some()).then(|| {
            let damage = |e| softens(e).map_or(0.0, |m| elements.state[m.damage_row as usize][e]);
            (0..elements.len()).map(damage).collect()
        })
    }
}

/// How a joint is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointCondition {
    /// Below its strength everywhere.
    Intact = 0,
    /// Softening at one point at least.
    Softening = 1,
    /// Failed: carries nothing any more.
    Broken = 2,
}

/// When and how a joint failed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct JointFailure {
    /// Element number.
    pub element: usize,
    /// Step index.
    pub step: u64,
    /// Physical time, s.
    pub time: f64,
    /// 1 in tension, 2 in shear, between them in both.
    pub mode: f64,
    /// Cohesive law.
    pub law: usize,
    /// Mean of the joint's four nodes then, m.
    pub place: Vec2,
    /// Length of its first side then, m.
    pub length: f64,
}

/// A joint as output shows it.
#[derive(Debug, Clone, Copy)]
pub struct JointView {
    /// Element number.
    pub element: usize,
    /// Cohesive law that it has or had.
    pub law: usize,
    /// Nodes a, b, c, d.
    pub nodes: [usize; 4],
    /// Condition.
    pub condition: JointCondition,
    /// Largest damage of its points, in [0, 1].
    pub damage: f64,
    /// Opening in the middle, m.
    pub opening: f64,
    /// Sliding in the middle, m.
    pub sliding: f64,
    /// When and how it failed.
    pub failure: Option<JointFailure>,
}

/// All joints, live and broken, elements ascending; closed edges and joints
/// without cohesive law are left out.
pub fn joint_views(simulation: &Simulation) -> impl Iterator<Item = JointView> + '_ {
    let scene = &simulation.scene;
    let failures: HashMap<usize, JointFailure> =
        simulation.failures.iter().map(|failure| (failure.element, *failure)).collect();
    let first_law = scene.materials.len();
    (0..scene.elements.len()).filter_map(move |element| {
        let property = scene.elements.property[element];
        let kind = scene.elements.joint_kind[element];
        if matches!(kind, JointKind::NoJoint | JointKind::FreeEdge) {
            return None;
        }
        let nodes = scene.elements.corners::<4>(element);
        let corners = nodes.map(|n| scene.nodes.current[n]);
        if kind.is_fracture() {
            let failure = failures.get(&element).copied();
            let (opening, sliding) = joint2::separation(&corners);
            let (condition, damage) = (JointCondition::Broken, 1.0);
            let own = usize::try_from(property).ok().and_then(|p| p.checked_sub(first_law));
            let law = failure.map(|f| f.law).or(own).unwrap_or(0);
            return Some(JointView {
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
        let law = usize::try_from(property).ok()?.checked_sub(first_law)?;
        let cohesive = scene.cohesive_laws.get(law).filter(|l| l.is_cohesive)?;
        let strength = simulation.strength[element];
        let state = match scene.conventions.cohesive {
            CohesiveModel::Split => joint2::state::<SplitRules>(cohesive, &corners, strength),
            CohesiveModel::YGeo => joint2::state::<YGeoRules>(cohesive, &corners, strength),
            CohesiveModel::Classic => {
                let strengths = simulation.classic.strengths(element);
                joint2::classic::state(cohesive, &corners, strengths)
            }
        };
        let condition =
            if state.damage > 0.0 { JointCondition::Softening } else { JointCondition::Intact };
        let JointState { opening, sliding, damage, .. } = state;
        Some(JointView { element, law, nodes, condition, damage, opening, sliding, failure: None })
    })
}
