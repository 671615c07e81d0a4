use super::{FACES, Frame, Point, Tetrahedron, Vec3, cross, dot};
use crate::{
    TOLERANCE,
    lanes::{LANES, Lanes, each},
};

/// The centroid's place among the points of a [`View`].
const CENTROID: usize = 4;

/// A target as seen from a face of the contactor: its four nodes and its centroid.
#[derive(Debug, Clone, Copy)]
pub(super) struct View {
    /// Relative to the face's origin, m.
    pub points: [Vec3; 5],
    /// Distance from the face's plane, positive on the contactor's side, m.
    pub heights: [f64; 5],
    /// In the plane, m: along both axes.
    pub along: [[f64; 5]; 2],
    /// Bit `i`: point `i` is above (below) the plane by more than the tolerance.
    above: u32,
    below: u32,
}

impl View {
    #[inline(always)]
    pub fn new(target: &Tetrahedron, frame: &Frame) -> Self {
        let [a, b, c, d] = target.corners;
        let mut view = Self {
            points: [a, b, c, d, target.centroid],
            heights: [0.0; 5],
            along: [[0.0; 5]; 2],
            above: 0,
            below: 0,
        };
        for i in 0..5 {
            let point = view.points[i] - frame.origin;
            view.points[i] = point;
            let height = dot(&frame.normal, &point);
            view.heights[i] = height;
            view.along[0][i] = dot(&point, &frame.axes[0]);
            view.along[1][i] = dot(&point, &frame.axes[1]);
            view.above |= u32::from(height > TOLERANCE) << i;
            view.below |= u32::from(height < -TOLERANCE) << i;
        }
        view
    }

    /// Where a point lies in the plane.
    #[inline(always)]
    pub fn place(&self, point: usize) -> Point {
        [self.along[0][point], self.along[1][point]]
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

    /// Which edges of the sub-tetrahedron of a target face are cut.
    #[inline(always)]
    fn edges(&self, face: usize) -> (&'static CutEdges, [usize; 4]) {
        let [a, b, c, _] = FACES[face];
        let nodes = [a, b, c, CENTROID];
        let above = each!(4, |i| self.above >> nodes[i] & 1);
        let pattern = above[0] | above[1] << 1 | above[2] << 2 | above[3] << 3;
        (&CUT_EDGES[pattern as usize], nodes)
    }

    /// The cut of the sub-tetrahedron of a target face, which [`Self::cuts`], counter-clockwise.
    #[inline(always)]
    pub fn section<L: Lanes>(&self, face: usize) -> Section {
        let (edges, nodes) = self.edges(face);
        let (from, to) = (each!(4, |k| nodes[edges.from[k]]), each!(4, |k| nodes[edges.to[k]]));
        let pick =
            |values: &[f64; 5], which: [usize; LANES]| L::new(each!(4, |k| values[which[k]]));
        let start = pick(&self.heights, from);
        let weight = (start / (start - pick(&self.heights, to)).abs()).abs();
        let rest = L::splat(1.0) - weight;
        let [u, v] = each!(2, |k| {
            let (start, end) = (pick(&self.along[k], from), pick(&self.along[k], to));
            (weight * end + rest * start).array()
        });
        Section { u, v, len: edges.len }.counter_clockwise()
    }
}

/// Edges of a sub-tetrahedron whose ends lie on both sides of a plane, in the order in which the
/// original finds them. The first is repeated at the end if there are three.
#[derive(Debug, Clone, Copy)]
struct CutEdges {
    from: [usize; LANES],
    to: [usize; LANES],
    len: usize,
}

/// By the nodes that are above the plane, a bit each.
const CUT_EDGES: [CutEdges; 16] = {
    let mut all = [CutEdges { from: [0; LANES], to: [0; LANES], len: 0 }; 16];
    let mut above = 0;
    while above < 16 {
        let edges = &mut all[above];
        let mut i = 0;
        while i < 6 {
            let from = i / 2;
            let to = if i % 2 == 0 { 3 } else { (from + 1) % 3 };
            if (above >> from & 1) != (above >> to & 1) {
                edges.from[edges.len] = from;
                edges.to[edges.len] = to;
                edges.len += 1;
            }
            i += 1;
        }
        if edges.len == 3 {
            edges.from[3] = edges.from[0];
            edges.to[3] = edges.to[0];
        }
        above += 1;
    }
    all
};

/// The cut of a sub-tetrahedron with the plane of a face: three or four points. The first is
/// repeated if there are three.
#[derive(Debug, Clone, Copy)]
pub(super) struct Section {
    pub u: [f64; LANES],
    pub v: [f64; LANES],
    pub len: usize,
}

impl Section {
    #[inline(always)]
    pub fn point(&self, i: usize) -> Point {
        [self.u[i], self.v[i]]
    }

    #[inline(always)]
    fn counter_clockwise(self) -> Self {
        if cross(self.point(0), self.point(1), self.point(2)) < 0.0 {
            let order: [usize; LANES] = if self.len == 3 { [2, 1, 0, 2] } else { [3, 2, 1, 0] };
            let turned = |values: &[f64; LANES]| each!(4, |k| values[order[k]]);
            Self { u: turned(&self.u), v: turned(&self.v), len: self.len }
        } else {
            self
        }
    }
}
