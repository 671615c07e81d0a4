//! Acoustic emission of joints in the classic dialect (spec `mechanics.md` 4.2.5).

use serde::{Deserialize, Serialize};

/// Magnitude of a joint that has emitted nothing.
const SILENT: f64 = -1e15;

/// Stage of a joint that emits.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum EmissionStage {
    /// It does not soften.
    #[default]
    None = 0,
    /// It softens.
    Yielding = 1,
    /// It has broken.
    Broken = 2,
}

/// What a joint has emitted.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Emission {
    /// Stage.
    pub stage: EmissionStage,
    /// Kinetic energy around the joint that rises are measured from, J.
    pub reference: f64,
    /// Largest rise, J.
    pub energy: f64,
    /// Magnitude of the event.
    pub magnitude: f64,
}

impl Default for Emission {
    fn default() -> Self {
        Self { stage: EmissionStage::None, reference: 0.0, energy: 0.0, magnitude: SILENT }
    }
}

impl Emission {
    /// Takes in the kinetic energy around a softening joint, J.
    pub(super) fn listen(&mut self, kinetic: f64) {
        match self.stage {
            EmissionStage::None => {
                (self.stage, self.reference, self.energy) = (EmissionStage::Yielding, kinetic, 0.0);
            }
            EmissionStage::Yielding if kinetic >= self.reference => {
                self.energy = self.energy.max(kinetic - self.reference);
                self.magnitude = 2.0 / 3.0 * (self.energy.log10() - 11.8);
            }
            EmissionStage::Yielding => {
                *self = Self { reference: kinetic, ..Self::default() };
            }
            EmissionStage::Broken => {}
        }
    }

    /// The joint has broken.
    pub(super) fn complete(&mut self) {
        self.stage = EmissionStage::Broken;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn energy_is_the_largest_rise_while_the_joint_softens() {
        let mut emission = Emission::default();
        for kinetic in [10.0, 12.0, 15.0, 13.0] {
            emission.listen(kinetic);
        }
        emission.complete();
        emission.listen(100.0);
        assert_eq!((emission.stage, emission.energy), (EmissionStage::Broken, 5.0));
        assert!((emission.magnitude - 2.0 / 3.0 * (5.0f64.log10() - 11.8)).abs() < 1e-15);
    }
}
