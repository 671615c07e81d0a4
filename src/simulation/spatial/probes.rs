//! Values of the history outputs (spec `y2d3d.md` E.5, F.4). In 3D there are nodal forces and
//! the kinetic energy.

use super::SpatialSimulation;
use crate::{TOLERANCE, scene::ProbeQuantity};

impl SpatialSimulation {
    /// Updates the probes of nodal forces, those of joints left out.
    pub(super) fn record_nodal_forces(&mut self) {
        for &(probe, node) in &self.plan.force_probes {
            let force = self.force[node as usize];
            let along_x = self.scene.probes[probe].quantity == ProbeQuantity::ForceX;
            let value = if along_x { force.x } else { force.y };
            let stored = &mut self.probe_values[probe];
            if (value - magnitude(*stored)).abs() >= self.scene.probe_threshold {
                *stored = value;
            }
        }
    }

    /// Updates the probes of kinetic energy, whose threshold is relative.
    pub(super) fn record_kinetic_energy(&mut self) {
        for (probe, stored) in self.scene.probes.iter().zip(&mut self.probe_values) {
            if probe.quantity == ProbeQuantity::KineticEnergy {
                let change = (1.0 - self.kinetic_energy / magnitude(*stored)).abs();
                if change >= self.scene.probe_threshold {
                    *stored = self.kinetic_energy;
                }
            }
        }
    }
}

/// The original compares with the size of the stored value.
fn magnitude(stored: f64) -> f64 {
    stored.abs().max(TOLERANCE)
}
