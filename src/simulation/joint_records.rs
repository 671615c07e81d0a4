//! What Y-Geo keeps of each joint beside its strength: largest damage, yielding,
//! fracture energy, and the kinetic energy released when it breaks (spec
//! `mechanics.md` 4.3, 7.8).

use super::{Simulation, plan::PlannedJoint};
use crate::{
    mechanics::{
        Vec2,
        joint2::{self, JointResponse, YGeoRules},
    },
    scene::SeismicMethod,
};

use serde::{Deserialize, Serialize};

/// Failure mode of a joint beside an excavated triangle.
pub const EXCAVATED: f64 = 4.0;
/// Failure mode of a joint on a fracture that is open from the start.
pub const NETWORK: f64 = 5.0;
/// Points beyond their peak from which on a joint yields.
const YIELD_COUNT: u32 = 2;

/// How a joint yields.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum YieldMode {
    /// Not at all so far.
    #[default]
    None = 0,
    /// In opening and sliding.
    Mixed = 1,
    /// In opening.
    Tensile = 2,
    /// In sliding.
    Shear = 3,
}

/// When and where a joint began to yield.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct Yielding {
    /// How.
    pub mode: YieldMode,
    /// Step.
    pub step: u64,
    /// Physical time, s.
    pub time: f64,
    /// Mean of the four nodes, m.
    pub place: [f64; 2],
}

/// Kinetic energy around a joint since it yielded.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct EnergyRelease {
    /// Kinetic energy of its nodes that changes are measured from, J.
    reference: f64,
    /// Time of that energy, s.
    since: f64,
    /// Largest change so far, J.
    pub largest: f64,
    /// Time of the largest change, s.
    pub time: f64,
}

/// What is kept of a joint.
#[derive(Debug, Clone, Copy, PartialEq, Default, Serialize, Deserialize)]
pub struct JointRecord {
    /// Largest damage of each point so far.
    pub largest_damage: [f64; 3],
    /// When and where it yielded.
    pub yielding: Yielding,
    /// Energy that went into it, J.
    pub fracture_energy: f64,
    /// Kinetic energy released.
    pub release: EnergyRelease,
}

impl Simulation {
    /// Keeps what a joint did in this step, before its forces are added.
    pub(super) fn record_joint(&mut self, joint: &PlannedJoint, response: &JointResponse) {
        let element = joint.element as usize;
        let nodes = joint.corners.map(|n| n as usize);
        let velocity = nodes.map(|n| self.scene.nodes.velocity[n]);
        self.joint_records[element].fracture_energy +=
            self.scene.control.time_step * power(response, &velocity);
        if response.softens && self.joint_records[element].yielding.mode == YieldMode::None {
            self.record_yielding(joint);
        }
        if self.joint_records[element].yielding.mode != YieldMode::None {
            let energy = self.kinetic_energy_of(nodes);
            let fails = response.failed_point.is_some();
            self.joint_records[element].release.update(
                self.scene.seismic,
                self.time,
                energy,
                fails,
            );
        }
    }

    /// Kinetic energy of four nodes, J.
    fn kinetic_energy_of(&self, nodes: [usize; 4]) -> f64 {
        nodes.into_iter().fold(0.0, |sum, n| {
            let v = self.scene.nodes.velocity[n];
            sum + 0.5 * self.mass[n] * (v.x * v.x + v.y * v.y)
        })
    }

    /// Notes that the joint yields if enough of its points are beyond their peak:
    /// a point in opening counts twice, as in the original.
    fn record_yielding(&mut self, joint: &PlannedJoint) {
        let element = joint.element as usize;
        let corners = joint.corners.map(|n| self.scene.nodes.current[n as usize]);
        let law = self.law_of(joint, &corners);
        let (points, limits) = joint2::points::<YGeoRules>(&law, &corners, self.strength[element]);
        let mut count = 0;
        for point in points {
            if point.damage > 0.0 {
                count += 1;
                if count > YIELD_COUNT {
                    let opens = point.opening > limits.peak_opening;
                    let slides = point.slip > limits.peak_sliding;
                    let mode = match (opens, slides) {
                        (true, true) => YieldMode::Mixed,
                        (true, false) => YieldMode::Tensile,
                        _ => YieldMode::Shear,
                    };
                    let [a, b, c, d] = corners;
                    let place = (a + b + c + d) / 4.0;
                    let (step, time) = (self.step, self.time);
                    let energy = self.kinetic_energy_of(joint.corners.map(|n| n as usize));
                    let record = &mut self.joint_records[element];
                    record.yielding = Yielding { mode, step, time, place: place.into() };
                    record.release.reference = energy;
                    (record.release.since, record.release.time) = (time, time);
                    self.yielded_now.push(element);
                    return;
                }
                if point.opening > limits.peak_opening {
                    count += 1;
                }
            }
        }
    }

    /// Whether one of the joint's triangles is excavated.
    pub(super) fn touches_excavation(&self, element: usize) -> bool {
        self.plan.excavates
            && self.scene.elements.sides[element].into_iter().any(|side| {
                usize::try_from(side)
                    .ok()
                    .and_then(|e| self.scene.material_of(e))
                    .is_some_and(|m| m.is_excavated)
            })
    }

    /// What is kept of a joint, in scenes that keep it.
    #[must_use]
    pub fn joint_record(&self, element: usize) -> Option<&JointRecord> {
        self.joint_records.get(element)
    }
}

impl EnergyRelease {
    fn update(&mut self, method: SeismicMethod, time: f64, energy: f64, fails: bool) {
        let change = energy - self.reference;
        if change > self.largest {
            (self.largest, self.time) = (change, time);
        }
        match method {
            SeismicMethod::SinceYield => {}
            SeismicMethod::Window(length) => {
                if time >= self.since + length {
                    (self.reference, self.since) = (energy, time);
                }
            }
            SeismicMethod::AtFailure => {
                if fails {
                    (self.largest, self.time) = (energy, time);
                }
            }
        }
    }
}

/// Power of a joint's forces on its nodes, W.
fn power(response: &JointResponse, [a, b, c, d]: &[Vec2; 4]) -> f64 {
    let mut sum = 0.0;
    for (point, force) in response.point_forces.iter().enumerate() {
        if point < 2 {
            sum += force.dot(&(d - a));
        }
        if point > 0 {
            sum += force.dot(&(c - b));
        }
    }
    sum
}
