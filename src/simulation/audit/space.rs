//! The audit of a simulation of tetrahedra.

use super::{super::spatial::SpatialSimulation, Ledger, Stored, joint_energy};

/// Energies and works of a simulation in space.
///
/// Contacts have no potential there: what they store is what they have taken.
#[derive(Debug, Clone)]
pub struct SpaceAudit {
    ledger: Ledger<3>,
}

impl SpaceAudit {
    /// An audit that begins with the next step.
    #[must_use]
    pub fn new() -> Self {
        Self { ledger: Ledger::new() }
    }

    /// Looks at a state after its forces were evaluated.
    pub fn after_forces(&mut self, simulation: &SpatialSimulation) {
        let scene = simulation.scene();
        let nodes = &scene.nodes;
        let points = scene.joint_points.points();
        let joints = simulation.live_joints().map(|(law, corners)| {
            joint_energy::of_face_joint(&scene.cohesive_laws[law], &points, &corners)
        });
        self.ledger.look(&nodes.current, &nodes.velocity, |forces| Stored {
            strain: simulation.forces_by_origin(forces),
            joints: joints.sum(),
            contact: None,
            friction: 0.0,
        });
    }

    /// Looks at it after it has moved.
    pub fn after_motion(&mut self, simulation: &SpatialSimulation) {
        let scene = simulation.scene();
        self.ledger.close(&scene.nodes.velocity, simulation.masses(), scene.control.time_step);
    }

    /// Energies and works so far.
    #[must_use]
    pub fn ledger(&self) -> &Ledger<3> {
        &self.ledger
    }

    /// Goes on with the works of an earlier audit of the same run; false if they are not complete.
    #[must_use]
    pub fn go_on_with(&mut self, ledger: Ledger<3>) -> bool {
        self.ledger = ledger;
        self.ledger.is_whole()
    }
}

impl Default for SpaceAudit {
    fn default() -> Self {
        Self::new()
    }
}
