//! Where two triangles lie relative to each other's edges.
//!
//! Everything is laid out in arrays of four lanes, one per corner and one of
//! padding, so that the compiler turns the loops over them into vector code.
//! Vector operations round like scalar ones: bits do not depend on it.

use crate::{TOLERANCE, mechanics::Vec2};
use wide::{CmpGt, CmpLt, f64x4};

/// Stands for "no distance known".
const FAR: f64 = 1e15;

/// One value per corner or edge of a triangle; the fourth lane repeats the first.
pub type Lanes = [f64; 4];

/// Area coordinates of a triangle's corners in another triangle: `[e][i]` of
/// corner `i` relative to edge `e` of the other (0 on it, positive inside).
pub type AreaCoordinates = [Lanes; 3];

/// Shape of a triangle at one instant.
#[derive(Debug, Clone, Copy, Default)]
pub struct Shape {
    x: Lanes,
    y: Lanes,
    /// Outward edge normals, as long as the edges; edge `i` starts at corner `i`.
    normal_x: Lanes,
    normal_y: Lanes,
    double_area: f64,
}

/// Velocities of a triangle's corners.
#[derive(Debug, Clone, Copy, Default)]
pub struct Motion {
    pub(super) x: Lanes,
    pub(super) y: Lanes,
}

impl Motion {
    /// Motion of the triangle whose corners have these velocities, m/s.
    #[inline(always)]
    #[must_use]
    pub fn new([p, q, r]: [Vec2; 3]) -> Self {
        Self { x: [p.x, q.x, r.x, p.x], y: [p.y, q.y, r.y, p.y] }
    }
}

impl Shape {
    /// Shape of the triangle with these corners (counter-clockwise).
    #[inline(always)]
    #[must_use]
    pub fn new([p, q, r]: [Vec2; 3]) -> Self {
        let (x, y) = ([p.x, q.x, r.x, p.x], [p.y, q.y, r.y, p.y]);
        let (next_x, next_y) = ([q.x, r.x, p.x, q.x], [q.y, r.y, p.y, q.y]);
        let mut shape = Self { x, y, ..Self::default() };
        for i in 0..4 {
            shape.normal_x[i] = next_y[i] - y[i];
            shape.normal_y[i] = x[i] - next_x[i];
        }
        shape.double_area = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
        shape
    }

    /// Outward normal of edge `i`, as long as the edge.
    #[inline(always)]
    #[must_use]
    pub fn normal(&self, i: usize) -> Vec2 {
        Vec2::new(self.normal_x[i], self.normal_y[i])
    }

    /// Corners.
    #[must_use]
    pub fn corners(&self) -> [Vec2; 3] {
        [0, 1, 2].map(|i| Vec2::new(self.x[i], self.y[i]))
    }

    /// Area coordinates of the corners of `other` in this triangle.
    #[inline(always)]
    fn locate(&self, other: &Self) -> AreaCoordinates {
        let mut coordinates = [[0.0; 4]; 3];
        for e in 0..3 {
            let (x, y) = (self.x[e], self.y[e]);
            let (normal_x, normal_y) = (self.normal_x[e], self.normal_y[e]);
            for i in 0..4 {
                coordinates[e][i] =
                    ((x - other.x[i]) * normal_x + (y - other.y[i]) * normal_y) / self.double_area;
            }
        }
        coordinates
    }

    /// Whether each corner with these area coordinates is further from the
    /// edge line that it violates most than the root of `distance_squared`.
    fn keeps_away(&self, coordinates: &AreaCoordinates, distance_squared: f64) -> bool {
        (0..3).all(|i| {
            let a = [coordinates[0][i], coordinates[1][i], coordinates[2][i]];
            let m = if a[0] <= a[1] && a[0] <= a[2] {
                0
            } else if a[1] <= a[0] && a[1] <= a[2] {
                1
            } else {
                2
            };
            let n = self.normal(m);
            let squared_length = n.x * n.x + n.y * n.y;
            let squared = a[m] * a[m] / (squared_length / (self.double_area * self.double_area));
            // not the negation: the original's minimum passes over what does not compare
            let is_close = squared < FAR && squared <= distance_squared;
            !is_close
        })
    }
}

/// The corners of two triangles in each other's area coordinates.
pub(super) struct Placement {
    /// Entry `t`: corners of triangle `t` in the other.
    pub coordinates: [AreaCoordinates; 2],
}

impl Placement {
    #[inline(always)]
    pub fn new(shapes: [&Shape; 2]) -> Self {
        Self { coordinates: [shapes[1].locate(shapes[0]), shapes[0].locate(shapes[1])] }
    }

    /// Bit `i` of entry `t`: edge `i` of triangle `t` has to be cut. It lies
    /// clear of the other triangle if its line does not cut it or if both its
    /// ends lie outside one of the other's edges.
    #[inline(always)]
    pub fn edges_to_cut(&self) -> [u32; 2] {
        let (mut outside, mut off_line) = ([0u32; 2], [0u32; 2]);
        for t in 0..2 {
            for e in 0..3 {
                let lanes = f64x4::new(self.coordinates[t][e]);
                let below = lanes.cmp_lt(f64x4::splat(TOLERANCE)).move_mask() as u32;
                let above = lanes.cmp_gt(f64x4::splat(-TOLERANCE)).move_mask() as u32;
                // the padding lane repeats corner 0: bit 3 closes the triangle
                outside[t] |= below & (below >> 1);
                // all corners of t on one side of the line of edge e of the other:
                // only 7, the mask of three corners, carries into bit 3
                let on_one_side = (((below & 7) + 1) | ((above & 7) + 1)) >> 3;
                off_line[1 - t] |= on_one_side << e;
            }
        }
        [7 & !(outside[0] | off_line[0]), 7 & !(outside[1] | off_line[1])]
    }

    /// Whether all corners keep away from the other triangle's edge lines by
    /// more than the root of `distance_squared`.
    pub fn is_beyond(&self, shapes: [&Shape; 2], distance_squared: f64) -> bool {
        shapes[1].keeps_away(&self.coordinates[0], distance_squared)
            && shapes[0].keeps_away(&self.coordinates[1], distance_squared)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shape(corners: [(f64, f64); 3]) -> Shape {
        Shape::new(corners.map(|(x, y)| Vec2::new(x, y)))
    }

    #[test]
    fn corners_have_area_coordinates() {
        let unit = shape([(0.0, 0.0), (1.0, 0.0), (0.0, 1.0)]);
        let inner = shape([(0.25, 0.25), (0.5, 0.25), (0.25, 0.5)]);
        let coordinates = unit.locate(&inner);
        // edge 0 lies along y = 0, edge 1 on the hypotenuse, edge 2 along x = 0
        assert_eq!([0, 1, 2].map(|e| coordinates[e][0]), [0.25, 0.5, 0.25]);
        assert_eq!([0, 1, 2].map(|e| coordinates[e][1]), [0.25, 0.25, 0.5]);
    }

    #[test]
    fn only_edges_that_reach_inside_are_cut() {
        let target = shape([(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)]);
        let contactor = shape([(0.5, -1.0), (1.5, -1.0), (0.9, 0.3)]);
        assert_eq!(Placement::new([&target, &contactor]).edges_to_cut(), [0b001, 0b110]);
    }
}
