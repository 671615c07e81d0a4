use super::{Frame, Point, Tetrahedron, Vec3, cross, dot};
use crate::{TOLERANCE, contact::spatial::FACES};

/// The centroid's place among the points of a [`View`].
const CENTROID: usize = 4;

/// A target as seen from a face of the contactor: its four nodes and its centroid.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    /// Relative to the face's origin, m.
    pub points: [Vec3; 5],
    /// Distance from the face's plane, positive on the contactor's side, m.
    pub heights: [f64; 5],
    /// In the plane, m.
    pub places: [Point; 5],
    /// Bit `i`: point `i` is above (below) the plane by more than the tolerance.
    above: u32,
    below: u32,
}

impl View {
    pub fn new(target: &Tetrahedron, frame: &Frame) -> Self {
        let [a, b, c, d] = target.corners;
        let points = [a, b, c, d, target.centroid].map(|x| x - frame.origin);
        let heights = points.map(|p| dot(&frame.normal, &p));
        let places = points.map(|p| frame.axes.map(|axis| dot(&p, &axis)));
        let bits = |holds: fn(f64) -> bool| {
            (0..5).fold(0, |bits, i| bits | u32::from(holds(heights[i])) << i)
        };
        Self {
            points,
            heights,
            places,
            above: bits(|d| d > TOLERANCE),
            below: bits(|d| d < -TOLERANCE),
        }
    }

    /// Whether the plane cuts the sub-tetrahedron of a target face in three or four points: none
    /// of its nodes lies in the plane, and they lie on both sides. A face of which no node is
    /// above the plane does not count.
    #[inline(always)]
    pub fn cuts(&self, face: usize) -> bool {
        let [a, b, c, _] = FACES[face];
        let base = 1 << a | 1 << b | 1 << c;
        let all = base | 1 << CENTROID;
        self.above & base != 0 && self.below & all != 0 && (self.above | self.below) & all == all
    }

    /// The cut, counter-clockwise.
    pub fn section(&self, face: usize) -> Section {
        let [a, b, c, _] = FACES[face];
        let nodes = [a, b, c, CENTROID];
        let mut section = Section { points: [[0.0; 2]; 4], len: 0 };
        for i in 0..3 {
            for other in [3, (i + 1) % 3] {
                let (from, to) = (nodes[i], nodes[other]);
                let (bit, opposite) = (1 << from, 1 << to);
                let crosses = self.above & bit != 0 && self.below & opposite != 0
                    || self.below & bit != 0 && self.above & opposite != 0;
                if crosses && section.len < 4 {
                    section.points[section.len] = self.crossing(from, to);
                    section.len += 1;
                }
            }
        }
        let points = &mut section.points[..section.len];
        if cross(points[0], points[1], points[2]) < 0.0 {
            points.reverse();
        }
        section
    }

    #[inline(always)]
    fn crossing(&self, from: usize, to: usize) -> Point {
        let (d, end) = (self.heights[from], self.heights[to]);
        let weight = (d / (d - end).abs()).abs();
        let (start, end) = (self.places[from], self.places[to]);
        [0, 1].map(|k| weight * end[k] + (1.0 - weight) * start[k])
    }
}

/// The cut of a sub-tetrahedron with the plane of a face: three or four points.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section {
    points: [Point; 4],
    len: usize,
}

impl Section {
    pub fn points(&self) -> &[Point] {
        &self.points[..self.len]
    }
}
