use super::{Frame, Point, cross, dot, polygon::Polygon, section::View, vector_product};
use crate::{TOLERANCE, contact::spatial::FACES, lanes::each};

/// The potential of a target's sub-tetrahedron in the plane of a face: linear, 0 on the outer
/// face, 1 in the centroid.
#[derive(Debug, Clone, Copy)]
pub(super) struct Potential {
    at_origin: f64,
    slopes: [f64; 2],
    /// Six times the volume of the sub-tetrahedron, m³.
    pub volume: f64,
}

impl Potential {
    pub fn new(view: &View, frame: &Frame, face: usize) -> Self {
        let [a, b, c, _] = FACES[face];
        let points = &view.points;
        let base = points[a];
        let normal = vector_product(&(points[b] - base), &(points[c] - base));
        let volume = dot(&(points[4] - base), &normal);
        Self {
            at_origin: dot(&-base, &normal) / volume,
            slopes: each!(2, |k| dot(&frame.axes[k], &normal) / volume),
            volume,
        }
    }

    #[inline(always)]
    fn at(&self, [u, v]: Point) -> f64 {
        self.at_origin + u * self.slopes[0] + v * self.slopes[1]
    }
}

/// A force in the plane of a face: how large, and where.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Resultant {
    /// N.
    pub force: f64,
    pub centre: Point,
}

impl Resultant {
    /// The potential integrated over a polygon, times six times the penalty.
    pub fn of(polygon: &Polygon, potential: &Potential, penalty: f64) -> Self {
        let points = polygon.points();
        let mut sum = Self::default();
        let first = potential.at(points[0]);
        let mut end = potential.at(points[1]);
        for triangle in points.windows(2).skip(1) {
            let start = end;
            end = potential.at(triangle[1]);
            let total = first + start + end;
            if total > TOLERANCE {
                sum.add([points[0], triangle[0], triangle[1]], [first, start, end], total, penalty);
            }
        }
        sum
    }

    /// Adds a triangle with the potential in its corners, whose sum is `total`.
    #[inline(always)]
    fn add(&mut self, corners: [Point; 3], [p, q, r]: [f64; 3], total: f64, penalty: f64) {
        let force = cross(corners[0], corners[1], corners[2]) * total * penalty;
        if (force + self.force).abs() <= TOLERANCE {
            return;
        }
        let first = (0.5 * p + 0.25 * (q + r)) / total;
        let second = (0.5 * q + 0.25 * (p + r)) / total;
        let third = 1.0 - first - second;
        let sum = self.force + force;
        self.centre = each!(2, |k| {
            let place = first * corners[0][k] + second * corners[1][k] + third * corners[2][k];
            (self.force * self.centre[k] + force * place) / sum
        });
        self.force = sum;
    }
}
