use super::super::Vec2;
use crate::TOLERANCE;

/// Middle line and relative displacements of a joint.
#[derive(Debug, Clone, Copy)]
pub(super) struct Geometry {
    /// Length of the middle line, m.
    pub length: f64,
    /// Direction of the middle line.
    pub tangent: Vec2,
    pub opening: [f64; 3],
    pub sliding: [f64; 3],
}

impl Geometry {
    #[inline]
    pub fn new([a, b, c, d]: &[Vec2; 4]) -> Self {
        let middle = Vec2::new(0.5 * (b.x + c.x - a.x - d.x), 0.5 * (b.y + c.y - a.y - d.y));
        let length = (middle.x * middle.x + middle.y * middle.y).sqrt();
        let e = Vec2::new(middle.x / (length + TOLERANCE), middle.y / (length + TOLERANCE));
        let (at_start, at_end) = (a - d, b - c);
        let sliding = |delta: Vec2| delta.y * e.y + delta.x * e.x;
        let opening = |delta: Vec2| delta.y * e.x - delta.x * e.y;
        let (s0, s2) = (sliding(at_start), sliding(at_end));
        let (o0, o2) = (opening(at_start), opening(at_end));
        Self {
            length,
            tangent: e,
            opening: [o0, 0.5 * (o0 + o2), o2],
            sliding: [s0, 0.5 * (s0 + s2), s2],
        }
    }

    /// Force on the upper face of point `point` by the stresses across the joint, N.
    #[inline]
    pub fn point_force(&self, point: usize, normal: f64, shear: f64) -> Vec2 {
        let e = self.tangent;
        let traction = Vec2::new(shear * e.x - normal * e.y, shear * e.y + normal * e.x);
        let weight = if point == 1 { self.length / 3.0 } else { self.length / 6.0 };
        weight * traction
    }
}
