//! What steps change: enough to go on with a simulation in another run, bit for bit.

use super::{FaceFailure, SpatialSimulation, plan::Plan, surfaces};
use crate::{
    contact::spatial::{Contact3, ContactState3},
    insertion::{Families, InsertionReport},
    mechanics::Vec3,
    scene::{Elements, JointKind, Nodes, Scene},
    simulation::{
        StateFault,
        state_check::{LAST_STEP, check_kinds, require},
    },
};
use serde::{Deserialize, Serialize};

/// State of a simulation in three dimensions between two steps.
///
/// It holds what steps change and what does not follow from it: materials, boundary conditions
/// and all other settings come from the deck; plans and buffers are made anew.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct SpatialState {
    step: u64,
    time: f64,
    nodes: Nodes<3>,
    elements: Elements,
    force: Vec<Vec3>,
    joint_force: Vec<Vec3>,
    probe_values: Vec<f64>,
    kinetic_energy: f64,
    insertion_report: Option<InsertionReport>,
    families: Families,
    failures: Vec<FaceFailure>,
    first_inversion: Option<(u64, usize)>,
    contact: Option<ContactState3>,
}

impl SpatialState {
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

    /// States come from files, and a step trusts them.
    fn check(&self, scene: &Scene<3>) -> Result<(), StateFault> {
        let nodes = &self.nodes;
        let lengths = [
            nodes.initial.len(),
            nodes.velocity.len(),
            nodes.boundary_flag.len(),
            nodes.set.len(),
            self.force.len(),
            self.joint_force.len(),
        ];
        require(
            lengths.iter().all(|&len| len == nodes.len()) && i32::try_from(nodes.len()).is_ok(),
            "values of nodes are missing",
        )?;
        require(self.families.fits(nodes.len()), "a node is a copy of none")?;
        let elements = &self.elements;
        let lengths = [
            elements.nodes.len(),
            elements.joint_kind.len(),
            elements.fracture.len(),
            elements.sides.len(),
            elements.contact_tag.len(),
        ];
        let len = elements.len();
        require(
            lengths.iter().all(|&l| l == len)
                && elements.state.iter().all(|row| row.len() == len)
                && i32::try_from(len).is_ok(),
            "values of elements are missing",
        )?;
        require(
            elements.state.len() == scene.elements.state.len()
                && elements.table_rows == scene.elements.table_rows,
            "its elements have other values",
        )?;
        require(
            elements.edge_nodes == scene.elements.edge_nodes,
            "its ten-node tetrahedra have other nodes",
        )?;
        let is_node = |&n: &i32| usize::try_from(n).is_ok_and(|n| n < nodes.len());
        for (corners, kind) in elements.nodes.iter().zip(&elements.joint_kind) {
            let needed = if *kind == JointKind::NoJoint { 4 } else { 6 };
            require(
                corners[..needed].iter().all(is_node),
                "an element has a node that is not there",
            )?;
        }
        let is_element = |&e: &i32| e == -1 || usize::try_from(e).is_ok_and(|e| e < len);
        require(elements.sides.as_flattened().iter().all(is_element), "a joint has no sides")?;
        let sets = (scene.materials.len() + scene.cohesive_laws.len()) as i32;
        require(
            elements.property.iter().all(|&p| p < sets),
            "an element has a property set that is not there",
        )?;
        check_kinds(elements, scene.materials.len())?;
        let is_failure = |f: &FaceFailure| f.element < len && f.law < scene.cohesive_laws.len();
        require(self.failures.iter().all(is_failure), "a joint has failed that is not there")?;
        require(
            self.probe_values.len() == scene.probes.len(),
            "it has another number of histories",
        )?;
        require(
            self.contact.is_some() == scene.contact.is_some(),
            "only one of the two knows contact",
        )?;
        require(self.step <= LAST_STEP, "its step is beyond all steps")
    }
}

impl SpatialSimulation {
    /// The state after the last completed step.
    #[must_use]
    pub fn state(&self) -> SpatialState {
        // every field is named, so that none that is new can be forgotten
        let Self {
            scene,
            plan: _,
            contact,
            options: _,
            step,
            time,
            force,
            joint_force,
            // follows from the plan
            mass: _,
            stress_use: _,
            probe_values,
            kinetic_energy,
            insertion_report,
            families,
            failures,
            first_inversion,
            // made anew in every step
            tetrahedron_slots: _,
            quadratic_slots: _,
            joint_slots: _,
            drives: _,
            clock: _,
        } = self;
        SpatialState {
            step: *step,
            time: *time,
            nodes: scene.nodes.clone(),
            elements: scene.elements.clone(),
            force: force.clone(),
            joint_force: joint_force.clone(),
            probe_values: probe_values.clone(),
            kinetic_energy: *kinetic_energy,
            insertion_report: *insertion_report,
            families: families.clone(),
            failures: failures.clone(),
            first_inversion: *first_inversion,
            contact: contact.as_ref().map(Contact3::state),
        }
    }

    /// Goes on with a state that [`Self::state`] gave for a simulation with the same settings.
    /// The next step gives the same bits as it would have given there.
    ///
    /// # Errors
    /// If the state is not one of this scene; the simulation is of no use then.
    pub fn restore(&mut self, state: SpatialState) -> Result<(), StateFault> {
        state.check(&self.scene)?;
        self.scene.nodes = state.nodes;
        self.scene.elements = state.elements;
        self.plan = Plan::new(&self.scene);
        (self.step, self.time) = (state.step, state.time);
        self.force = state.force;
        self.joint_force = state.joint_force;
        self.mass.clone_from(&self.plan.nodal_mass);
        self.probe_values = state.probe_values;
        self.kinetic_energy = state.kinetic_energy;
        self.insertion_report = state.insertion_report;
        self.families = state.families;
        self.failures = state.failures;
        self.first_inversion = state.first_inversion;
        if let (Some(contact), Some(state)) = (&mut self.contact, state.contact) {
            contact
                .restore(state, &self.scene.elements, &surfaces(&self.scene))
                .map_err(StateFault)?;
        }
        self.make_room();
        Ok(())
    }
}
