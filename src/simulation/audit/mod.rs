//! Where the energy of a run is and where it goes.
//!
//! The step takes v from one half of it to the next while x stands at whole ones, so the kinetic
//! energy that belongs to x_n is ½ Σ m v_n·v_{n+1}. With it and with works by the mean of the forces
//! at both ends of a step, ½ (f_n + f_{n+1})·(x_{n+1} − x_n), a linear system keeps its energy to
//! rounding at every stable step; what is left over elsewhere is the error of the step. Energies
//! that are stored are computed from the state alone, so that the balance tests the forces.
//!
//! Nothing here touches the simulation: it is looked at after the forces and after the motion.

mod joint_energy;
mod overlap_energy;
mod plane;
mod space;
pub(super) mod strain;

pub(super) use overlap_energy::potential as overlap_potential;
pub use plane::PlaneAudit;
pub use space::SpaceAudit;

use crate::TOLERANCE;
use nalgebra::SVector;
use serde::{Deserialize, Serialize};

/// Energies at one instant and works up to then, J (J/m of thickness in the plane).
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct EnergyBalance {
    /// Of motion.
    pub kinetic: f64,
    /// Stored in elements.
    pub strain: f64,
    /// Stored in joints: what they would give back if they closed along a parabola.
    pub joint_recoverable: f64,
    /// Taken by joints for good, and by softening triangles.
    pub joint_dissipated: f64,
    /// Stored in overlaps.
    pub contact_stored: f64,
    /// Stored in tangential springs of contacts that stick.
    pub friction_stored: f64,
    /// Taken by friction for good.
    pub friction_dissipated: f64,
    /// Taken by viscosity.
    pub viscous_dissipated: f64,
    /// Brought in by gravity, loads and supports.
    pub external_work: f64,
    /// Energy and losses less external work, against the start.
    pub error: f64,
    /// The error by the largest energy so far.
    pub relative_error: f64,
}

impl EnergyBalance {
    /// Names of the values, in the order of [`Self::values`].
    pub const NAMES: [&str; 11] = [
        "kinetic (J)",
        "strain (J)",
        "joints recoverable (J)",
        "joints dissipated (J)",
        "contact stored (J)",
        "friction stored (J)",
        "friction dissipated (J)",
        "viscous dissipated (J)",
        "external work (J)",
        "balance error (J)",
        "relative error",
    ];

    /// All values.
    #[must_use]
    pub fn values(&self) -> [f64; 11] {
        [
            self.kinetic,
            self.strain,
            self.joint_recoverable,
            self.joint_dissipated,
            self.contact_stored,
            self.friction_stored,
            self.friction_dissipated,
            self.viscous_dissipated,
            self.external_work,
            self.error,
            self.relative_error,
        ]
    }

    fn stored(&self) -> f64 {
        self.kinetic
            + self.strain
            + self.joint_recoverable
            + self.contact_stored
            + self.friction_stored
    }

    fn lost(&self) -> f64 {
        self.joint_dissipated + self.friction_dissipated + self.viscous_dissipated
    }
}

/// Who exerts a force.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Origin {
    Strain = 0,
    Viscosity = 1,
    Joints = 2,
    Contact = 3,
    Friction = 4,
    /// All others: loads, gravity, supports.
    External = 5,
}

pub(super) const ORIGINS: usize = 6;

/// What a state stores, as it is computed from the state.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
struct Stored {
    /// None where there is no formula: then it is what forces have taken.
    strain: Option<f64>,
    joints: f64,
    contact: Option<f64>,
    friction: f64,
}

/// Forces of the last instant and works since the first: all that an audit needs to go on.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct Ledger<const D: usize> {
    place: Vec<SVector<f64, D>>,
    forces: [Vec<SVector<f64, D>>; ORIGINS],
    // of use between the two looks of a step
    #[serde(skip)]
    velocity: Vec<SVector<f64, D>>,
    #[serde(skip)]
    before: [Vec<SVector<f64, D>>; ORIGINS],
    #[serde(skip)]
    place_before: Vec<SVector<f64, D>>,
    work: [f64; ORIGINS],
    first: Option<(Stored, f64)>,
    stored: Stored,
    largest: f64,
    balance: EnergyBalance,
    worst: f64,
}

impl<const D: usize> Ledger<D> {
    fn new() -> Self {
        Self {
            place: Vec::new(),
            velocity: Vec::new(),
            forces: Default::default(),
            before: Default::default(),
            place_before: Vec::new(),
            work: [0.0; ORIGINS],
            first: None,
            stored: Stored::default(),
            largest: 0.0,
            balance: EnergyBalance::default(),
            worst: 0.0,
        }
    }

    /// Whether a state has been looked at and has moved on.
    #[must_use]
    pub fn has_begun(&self) -> bool {
        self.first.is_some()
    }

    /// The balance of the last state looked at.
    #[must_use]
    pub fn balance(&self) -> EnergyBalance {
        self.balance
    }

    /// Largest relative error so far, without its sign.
    #[must_use]
    pub fn worst_error(&self) -> f64 {
        self.worst
    }

    /// Whether every node has a place and a force of each origin.
    fn is_whole(&self) -> bool {
        self.forces.iter().all(|forces| forces.len() == self.place.len())
    }

    /// Takes over a state with its forces, before it moves. `fill` adds forces of all origins but
    /// the external ones and says what is stored.
    fn look(
        &mut self,
        place: &[SVector<f64, D>],
        velocity: &[SVector<f64, D>],
        fill: impl FnOnce(&mut [Vec<SVector<f64, D>>; ORIGINS]) -> Stored,
    ) {
        std::mem::swap(&mut self.forces, &mut self.before);
        std::mem::swap(&mut self.place, &mut self.place_before);
        self.place.clear();
        self.place.extend_from_slice(place);
        self.velocity.clear();
        self.velocity.extend_from_slice(velocity);
        for forces in &mut self.forces {
            forces.clear();
            forces.resize(place.len(), SVector::zeros());
        }
        self.stored = fill(&mut self.forces);
    }

    /// Completes the balance of the state looked at, now that it is known how it moves on.
    fn close(&mut self, velocity: &[SVector<f64, D>], mass: &[f64], dt: f64) {
        let mut kinetic = 0.0;
        for (n, (&new, &mass)) in velocity.iter().zip(mass).enumerate() {
            let old = self.velocity[n];
            let massive = if mass >= TOLERANCE { mass } else { 0.0 };
            kinetic += 0.5 * massive * old.dot(&new);
            let inner: SVector<f64, D> =
                (0..Origin::External as usize).map(|origin| self.forces[origin][n]).sum();
            self.forces[Origin::External as usize][n] = (new - old) * (massive / dt) - inner;
        }
        // a mesh that has grown begins with works anew from here
        if self.place_before.len() == self.place.len() && self.first.is_some() {
            for origin in 0..ORIGINS {
                let pairs = self.forces[origin].iter().zip(&self.before[origin]);
                let ways = self.place.iter().zip(&self.place_before);
                let work: f64 = pairs.zip(ways).map(|((f, g), (x, y))| (f + g).dot(&(x - y))).sum();
                self.work[origin] += 0.5 * work;
            }
        }
        self.settle(kinetic);
    }

    fn settle(&mut self, kinetic: f64) {
        let (first, kinetic_at_first) = *self.first.get_or_insert((self.stored, kinetic));
        let taken = |origin: Origin| -self.work[origin as usize];
        let (now, joints) = (self.stored, taken(Origin::Joints));
        let mut balance = EnergyBalance {
            kinetic,
            strain: now.strain.unwrap_or(taken(Origin::Strain)),
            joint_recoverable: now.joints,
            joint_dissipated: joints - (now.joints - first.joints),
            contact_stored: now.contact.unwrap_or(taken(Origin::Contact)),
            friction_stored: now.friction,
            friction_dissipated: taken(Origin::Friction) - (now.friction - first.friction),
            viscous_dissipated: taken(Origin::Viscosity),
            external_work: self.work[Origin::External as usize],
            error: 0.0,
            relative_error: 0.0,
        };
        let start = kinetic_at_first
            + first.strain.unwrap_or(0.0)
            + first.joints
            + first.contact.unwrap_or(0.0)
            + first.friction;
        balance.error = balance.stored() + balance.lost() - balance.external_work - start;
        let size = balance.kinetic.abs()
            + balance.strain
            + balance.joint_recoverable
            + balance.contact_stored.abs()
            + balance.friction_stored;
        self.largest = self.largest.max(size);
        balance.relative_error =
            if self.largest > 0.0 { balance.error / self.largest } else { 0.0 };
        self.worst = match balance.relative_error.abs() {
            error if error <= self.worst => self.worst,
            error => error,
        };
        self.balance = balance;
    }
}
