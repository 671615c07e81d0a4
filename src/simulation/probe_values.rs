//! Values of the history outputs. A stored value changes only when the new one
//! differs by the deck's threshold; the original compares with the magnitude
//! of the stored value (spec `y2d3d.md` C.1), which is kept.

use super::Simulation;
use crate::{
    TOLERANCE,
    mechanics::{
        Vec2,
        triangle::{Kinematics, cauchy_stress},
    },
    scene::{ProbeQuantity, Refresh},
};

impl Simulation {
    /// Updates the probes inside elastic triangles.
    pub(super) fn record_element_probes(&mut self) {
        for i in 0..self.plan.probes.len() {
            let (probe, element) =
                (self.plan.probes[i].probe, self.plan.probes[i].element as usize);
            let quantity = self.scene.probes[probe].quantity;
            let value = self.element_value(quantity, element);
            self.store_if_changed(probe, value);
            if quantity == ProbeQuantity::StressOutOfPlane {
                self.probe_times[probe] = self.time;
            }
        }
        if !self.plan.strain_energy_probes.is_empty() {
            let energy = self.sum_strain_energy();
            for i in 0..self.plan.strain_energy_probes.len() {
                let probe = self.plan.strain_energy_probes[i];
                (self.probe_values[probe], self.probe_times[probe]) = (energy, self.time);
            }
        }
    }

    /// Elastic energy of all triangles, J: half the product of elastic stress and
    /// strain ½(B − I) times the area, elements in the order of their forces.
    ///
    /// Y-Geo takes the Lamé constants for all isotropic materials and a mixture of
    /// stiffness and compliance for layered ones; here each material's own law counts.
    fn sum_strain_energy(&self) -> f64 {
        let mut sum = 0.0;
        for batch in &self.plan.batches {
            let law = batch.law.without_viscosity();
            for planned in &batch.triangles {
                let at = |values: &[Vec2]| planned.corners.map(|n| values[n as usize]);
                let corners = at(&self.scene.nodes.current);
                let velocities = at(&self.scene.nodes.velocity);
                let kinematics = Kinematics::new(&planned.reference, &corners, &velocities);
                let strain = kinematics.strain();
                let stress = cauchy_stress(&law, &planned.reference, &corners, &velocities);
                sum += 0.5 * strain.dot(&stress) * (kinematics.double_area / 2.0);
            }
        }
        sum
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
