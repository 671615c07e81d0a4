//! Pressure and traction on triangle edges (spec `y2d3d.md` C.1): follower
//! loads on the current geometry, distributed to the edge's two nodes.

use super::Vec2;
use crate::TOLERANCE;

/// Load intensity at the two ends of an edge, Pa, before the load-time factor.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct EdgeIntensity {
    /// Intensity at the end nodes.
    pub value: [f64; 2],
    /// Load-time factor at the end nodes.
    pub factor: [f64; 2],
}

impl EdgeIntensity {
    /// Whether both ends are loaded: otherwise the edge carries nothing.
    #[inline]
    #[must_use]
    pub fn is_active(&self) -> bool {
        self.value[0].abs() > TOLERANCE && self.value[1].abs() > TOLERANCE
    }
}

/// Subtracts the nodal forces of a pressure on the edge with outward `normal`
/// (as long as the edge) from the forces of its end nodes.
#[inline]
pub fn apply_pressure(load: &EdgeIntensity, normal: Vec2, from: &mut Vec2, to: &mut Vec2) {
    let [p0, p1] = load.value;
    let [a0, a1] = load.factor;
    for k in 0..2 {
        from[k] = from[k] - p0 * a0 * normal[k] / 3.0 - p1 * a1 * normal[k] / 6.0;
        to[k] = to[k] - p0 * a0 * normal[k] / 6.0 - p1 * a1 * normal[k] / 3.0;
    }
}

/// Adds the nodal forces of a traction along the counter-clockwise edge.
#[inline]
pub fn apply_traction(load: &EdgeIntensity, normal: Vec2, from: &mut Vec2, to: &mut Vec2) {
    let [q0, q1] = load.value;
    let [a0, a1] = load.factor;
    let edge = Vec2::new(-normal.y, normal.x);
    for k in 0..2 {
        from[k] = from[k] + q0 * a0 * edge[k] / 3.0 + q1 * a1 * edge[k] / 6.0;
        to[k] = to[k] + q0 * a0 * edge[k] / 6.0 + q1 * a1 * edge[k] / 3.0;
    }
}
