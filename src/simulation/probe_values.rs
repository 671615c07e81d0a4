//! Values of the history outputs. A stored value changes only when the new one
//! differs by the deck's threshold; the original compares with the magnitude
//! of the stored value (spec `y2d3d.md` C.1), which is kept.

use super::Simulation;
use crate::{
    TOLERANCE,
    scene::{ProbeQuantity, Refresh},
};

impl Simulation {
    /// Updates the probes inside elastic triangles.
    pub(super) fn record_element_probes(&mut self) {
        for i in 0..self.plan.probes.len() {
            let (probe, element) =
                (self.plan.probes[i].probe, self.plan.probes[i].element as usize);
            let value = self.element_value(self.scene.probes[probe].quantity, element);
            self.store_if_changed(probe, value);
        }
    }

    fn element_value(&self, quantity: ProbeQuantity, element: usize) -> f64 {
        let stress = &self.stress[element];
        let v = self.scene.elements.corners::<3>(element).map(|n| self.scene.nodes.velocity[n]);
        let mean = |f: [f64; 3]| (f[0] + f[1] + f[2]) / 3.0;
        match quantity {
            ProbeQuantity::StressXx => stress[(0, 0)],
            ProbeQuantity::StressXy => stress[(0, 1)],
            ProbeQuantity::StressYy => stress[(1, 1)],
            ProbeQuantity::Speed => mean(v.map(|v| (v.x * v.x + v.y * v.y).sqrt())),
            ProbeQuantity::VelocityX => mean(v.map(|v| v.x)),
            ProbeQuantity::VelocityY => mean(v.map(|v| v.y)),
            _ => 0.0,
        }
    }

    /// Updates the probes of nodal forces.
    pub(super) fn record_nodal_forces(&mut self) {
        for i in 0..self.plan.force_probes.len() {
            let (probe, node) = self.plan.force_probes[i];
            let force = self.force[node as usize];
            let along_x = self.scene.probes[probe].quantity == ProbeQuantity::ForceX;
            self.store_if_changed(probe, if along_x { force.x } else { force.y });
        }
    }

    /// Updates the probes of kinetic energy, whose threshold is relative.
    pub(super) fn record_kinetic_energy(&mut self) {
        let stored = self.probe_values.iter_mut().zip(&mut self.probe_times);
        for (probe, (stored, refreshed)) in self.scene.probes.iter().zip(stored) {
            if probe.quantity == ProbeQuantity::KineticEnergy {
                let change = (1.0 - self.kinetic_energy / magnitude(*stored)).abs();
                let is_due = match self.scene.conventions.energy_refresh {
                    Refresh::AtThreshold => change >= self.scene.probe_threshold,
                    Refresh::AboveThreshold => change > self.scene.probe_threshold,
                };
                if is_due {
                    (*stored, *refreshed) = (self.kinetic_energy, self.time);
                }
            }
        }
    }

    fn store_if_changed(&mut self, probe: usize, value: f64) {
        let stored = &mut self.probe_values[probe];
        if (value - magnitude(*stored)).abs() >= self.scene.probe_threshold {
            *stored = value;
            self.probe_times[probe] = self.time;
        }
    }
}

fn magnitude(stored: f64) -> f64 {
    stored.abs().max(TOLERANCE)
}
