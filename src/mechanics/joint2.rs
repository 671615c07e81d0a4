//! Cohesive joint between two triangle edges (spec `y2d3d.md` D.6,
//! `mechanics.md` 4).
//!
//! Nodes a, b lie along one side, c faces b and d faces a. Opening and sliding
//! are taken along the middle line at its two ends and its middle; each point
//! softens with the combined damage of the two modes.

pub mod classic;
mod geometry;
pub mod intact;
mod separation;

use super::Vec2;
use geometry::Geometry;

pub use separation::{Limits, PointState, Rules, SplitRules, YGeoRules, evaluate, points, state};

/// Result of one evaluation of a joint.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct JointResponse {
    /// Force carried across the joint at its start, middle and end, N. Node a
    /// loses points 0 and 1 in turn and d gains them; b loses points 1 and 2
    /// and c gains them.
    pub point_forces: [Vec2; 3],
    /// The second of the three points that has lost all strength, if two have:
    /// the joint fails there.
    pub failed_point: Option<u8>,
    /// Whether a point softens.
    pub softens: bool,
}

/// State of a joint for output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointState {
    /// Opening (positive) or overlap (negative) in the middle, m.
    pub opening: f64,
    /// Sliding in the middle, m.
    pub sliding: f64,
    /// Largest damage of the three points, in [0, 1].
    pub damage: f64,
    /// 1 where the damage comes from opening alone, 2 from sliding alone, 1.5
    /// from both alike; 0 without damage.
    pub mode: f64,
}

impl JointResponse {
    /// Adds the joint's forces to those of its nodes a, b, c, d, point by point.
    #[inline]
    pub fn scatter(&self, nodes: [usize; 4], forces: &mut [Vec2]) {
        let [a, b, c, d] = nodes;
        for (point, force) in self.point_forces.iter().enumerate() {
            if point < 2 {
                forces[a] -= force;
                forces[d] += force;
            }
            if point > 0 {
                forces[b] -= force;
                forces[c] += force;
            }
        }
    }
}

/// Opening and sliding in the middle of a joint that carries nothing any more, m.
#[must_use]
pub fn separation(corners: &[Vec2; 4]) -> (f64, f64) {
    let geometry = Geometry::new(corners);
    (geometry.opening[1], geometry.sliding[1])
}
