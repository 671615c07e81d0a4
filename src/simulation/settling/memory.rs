//! What settling leaves behind in a simulation, and what not.

use super::super::{Emission, EmissionStage, JointRecord, Simulation, SimulationState};
use crate::mechanics::Vec2;

impl Simulation {
    /// Puts back what settling changed beside positions, damage, sliding and broken joints: it
    /// knows no time, so that histories, factors and energies measured over time stay as they
    /// were at the start.
    pub(super) fn end_settling(&mut self, start: &SimulationState) {
        self.scene.nodes.velocity.fill(Vec2::zeros());
        self.edge_factors.clone_from(&start.edge_factors);
        self.probe_values.clone_from(&start.probe_values);
        self.probe_times.clone_from(&start.probe_times);
        self.kinetic_energy = 0.0;
        self.yielded_now.clear();
        // a joint that yields is found to yield in the first step
        for (record, before) in self.joint_records.iter_mut().zip(&start.joint_records) {
            *record = JointRecord { largest_damage: record.largest_damage, ..*before };
        }
        for (emission, before) in self.classic.emissions.iter_mut().zip(&start.classic.emissions) {
            let is_broken = emission.stage == EmissionStage::Broken;
            *emission = Emission {
                stage: if is_broken { emission.stage } else { before.stage },
                ..*before
            };
        }
        self.rebuild();
    }
}
