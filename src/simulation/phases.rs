use super::{Simulation, SpatialSimulation, plan::ForcePhase};
use serde::{Deserialize, Serialize};
use std::time::{Duration, Instant};

/// What the time of a step goes into.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Phase {
    Triangles,
    Joints,
    Detection,
    Overlap,
    Integration,
}

impl From<&ForcePhase> for Phase {
    fn from(phase: &ForcePhase) -> Self {
        match phase {
            ForcePhase::Triangles(_) | ForcePhase::LoadStep(_) => Self::Triangles,
            ForcePhase::Joints | ForcePhase::EveryJoint(_) => Self::Joints,
        }
    }
}

/// Wall-clock time of the phases of all steps so far, s.
#[derive(Debug, Clone, Copy, Default, PartialEq, Serialize, Deserialize)]
pub struct PhaseTimes {
    /// Stresses and nodal forces of triangles or tetrahedra, edge loads, and adding them up.
    pub triangles: f64,
    /// Stresses and nodal forces of joints, and adding them up.
    pub joints: f64,
    /// How far bodies have moved, and the search for couples when it is due.
    pub detection: f64,
    /// Contact forces of couples, and adding them up.
    pub overlap: f64,
    /// New velocities and positions, clearing of forces, fracture of softening triangles.
    pub integration: f64,
}

impl PhaseTimes {
    /// All of it, s.
    #[must_use]
    pub fn sum(&self) -> f64 {
        self.triangles + self.joints + self.detection + self.overlap + self.integration
    }
}

/// Takes the time of phases, if somebody wants to know.
#[derive(Debug, Clone, Default)]
pub(super) struct PhaseClock(Option<Running>);

#[derive(Debug, Clone)]
struct Running {
    since: Instant,
    times: [Duration; 5],
}

impl PhaseClock {
    /// Whether somebody wants to know.
    #[inline]
    pub fn is_running(&self) -> bool {
        self.0.is_some()
    }

    /// A phase begins.
    #[inline]
    pub fn start(&mut self) {
        if let Some(running) = &mut self.0 {
            running.since = Instant::now();
        }
    }

    /// A phase is over, and the next one begins.
    #[inline]
    pub fn lap(&mut self, phase: Phase) {
        if let Some(running) = &mut self.0 {
            let now = Instant::now();
            running.times[phase as usize] += now - running.since;
            running.since = now;
        }
    }
}

impl PhaseClock {
    /// A clock that takes times from now on.
    pub fn running() -> Self {
        Self(Some(Running { since: Instant::now(), times: Default::default() }))
    }

    /// Times so far, if they are taken.
    pub fn times(&self) -> Option<PhaseTimes> {
        let seconds = |phase: Phase| Some(self.0.as_ref()?.times[phase as usize].as_secs_f64());
        Some(PhaseTimes {
            triangles: seconds(Phase::Triangles)?,
            joints: seconds(Phase::Joints)?,
            detection: seconds(Phase::Detection)?,
            overlap: seconds(Phase::Overlap)?,
            integration: seconds(Phase::Integration)?,
        })
    }
}

impl Simulation {
    /// From now on the time of each phase is taken ([`Self::phase_times`]).
    pub fn watch_phases(&mut self) {
        self.clock = PhaseClock::running();
    }

    /// Time of each phase since [`Self::watch_phases`]; `None` without it.
    #[must_use]
    pub fn phase_times(&self) -> Option<PhaseTimes> {
        self.clock.times()
    }
}

impl SpatialSimulation {
    /// From now on the time of each phase is taken ([`Self::phase_times`]).
    pub fn watch_phases(&mut self) {
        self.clock = PhaseClock::running();
    }

    /// Time of each phase since [`Self::watch_phases`]; `None` without it.
    #[must_use]
    pub fn phase_times(&self) -> Option<PhaseTimes> {
        self.clock.times()
    }
}
