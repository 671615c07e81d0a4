//! What steps change: enough to go on with a simulation in another run, bit for bit.

use super::{ClassicJoints, JointFailure, JointRecord, Simulation, plan::Plan, state_check};
use crate::{
    contact::{ContactState, Tally},
    insertion::InsertionReport,
    mechanics::Vec2,
    scene::{Elements, Nodes},
};
use nalgebra::Matrix2;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// State of a simulation between two steps.
///
/// It holds what steps change and what does not follow from it: materials, boundary conditions
/// and all other settings come from the deck; plans and buffers are made anew.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct SimulationState {
    pub(super) step: u64,
    pub(super) time: f64,
    pub(super) nodes: Nodes<2>,
    pub(super) elements: Elements,
    pub(super) force: Vec<Vec2>,
    pub(super) mass: Vec<f64>,
    pub(super) stress: Vec<Matrix2<f64>>,
    pub(super) strength: Vec<f64>,
    pub(super) contact_force: Vec<Vec2>,
    pub(super) edge_factors: Vec<f64>,
    pub(super) joint_records: Vec<JointRecord>,
    pub(super) yielded_now: Vec<usize>,
    pub(super) classic: ClassicJoints,
    pub(super) tally: Tally,
    pub(super) probe_values: Vec<f64>,
    pub(super) probe_times: Vec<f64>,
    pub(super) kinetic_energy: f64,
    pub(super) insertion_report: Option<InsertionReport>,
    pub(super) failures: Vec<JointFailure>,
    pub(super) contact: Option<ContactState>,
}

/// A state that is not one of the scene.
#[derive(Debug, Clone, PartialEq, Eq, Error)]
#[error("the state is not one of this scene: {0}")]
pub struct StateFault(pub(super) &'static str);

impl StateFault {
    /// A state of triangles for tetrahedra, or the other way round.
    pub const OTHER_DIMENSION: Self = Self("it has another number of dimensions");
}

impl SimulationState {
    /// Index of the step that comes next.
    #[must_use]
    pub fn step_index(&self) -> u64 {
        self.step
    }

    /// Physical time, s.
    #[must_use]
    pub fn time(&self) -> f64 {
        self.time
    }
}

impl Simulation {
    /// The state after the last completed step.
    #[must_use]
    pub fn state(&self) -> SimulationState {
        // every field is named, so that none that is new can be forgotten
        let Self {
            scene,
            plan: _,
            contact,
            options: _,
            step,
            time,
            force,
            mass,
            stress,
            strength,
            contact_force,
            edge_factors,
            joint_records,
            yielded_now,
            classic,
            tally,
            probe_values,
            probe_times,
            kinetic_energy,
            stress_use: _,
            // made anew in every step
            keeps_triangles: _,
            watches_contact: _,
            contact_share: _,
            domains: _,
            parts: _,
            evaluated_joints: _,
            insertion_report,
            failures,
            clock: _,
        } = self;
        SimulationState {
            step: *step,
            time: *time,
            nodes: scene.nodes.clone(),
            elements: scene.elements.clone(),
            force: force.clone(),
            mass: mass.clone(),
            stress: stress.clone(),
            strength: strength.clone(),
            contact_force: contact_force.clone(),
            edge_factors: edge_factors.clone(),
            joint_records: joint_records.clone(),
            yielded_now: yielded_now.clone(),
            classic: classic.clone(),
            tally: tally.clone(),
            probe_values: probe_values.clone(),
            probe_times: probe_times.clone(),
            kinetic_energy: *kinetic_energy,
            insertion_report: *insertion_report,
            failures: failures.clone(),
            contact: contact.as_ref().map(crate::contact::Contact::state),
        }
    }

    /// Goes on with a state that [`Self::state`] gave for a simulation with the same settings.
    /// The next step gives the same bits as it would have given there.
    ///
    /// # Errors
    /// If the state is not one of this scene; the simulation is of no use then.
    pub fn restore(&mut self, state: SimulationState) -> Result<(), StateFault> {
        state_check::check(&state, &self.scene)?;
        self.scene.nodes = state.nodes;
        self.scene.elements = state.elements;
        self.plan = Plan::new(&self.scene);
        (self.step, self.time) = (state.step, state.time);
        self.force = state.force;
        self.mass = state.mass;
        self.stress = state.stress;
        self.strength = state.strength;
        self.contact_force = state.contact_force;
        self.edge_factors = state.edge_factors;
        self.joint_records = state.joint_records;
        self.yielded_now = state.yielded_now;
        self.classic = state.classic;
        self.tally = state.tally;
        self.probe_values = state.probe_values;
        self.probe_times = state.probe_times;
        self.kinetic_energy = state.kinetic_energy;
        self.insertion_report = state.insertion_report;
        self.failures = state.failures;
        // room for every joint's failure: the step loop allocates nothing
        self.failures.reserve(self.plan.joints.len());
        if let (Some(contact), Some(state)) = (&mut self.contact, state.contact) {
            contact.restore(state, &self.scene).map_err(StateFault)?;
        }
        self.divide();
        Ok(())
    }
}
