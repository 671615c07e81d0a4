//! On which sides of each other's edges the corners of a section and of a face lie.

use super::{Frame, Point, section::Section};
use crate::{
    TOLERANCE,
    lanes::{Lanes, Mask},
};

/// Corners of a section and of a face, a bit each: bit `i` that of the section, bit `j` of the
/// face, bit `4j + i` a pair.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Signs {
    /// Corners of the section inside the face.
    pub section_inside: u32,
    /// Corners of the face inside the section.
    pub face_inside: u32,
    /// Edges from `i` on and from `j` on that cross.
    pub crossings: u32,
}

impl Signs {
    /// Corners that both have in common.
    #[inline(always)]
    pub fn corners(self) -> u32 {
        self.section_inside.count_ones()
            + self.face_inside.count_ones()
            + self.crossings.count_ones()
    }

    #[inline(always)]
    pub fn of<L: Lanes>(section: &Section, frame: &Frame) -> Self {
        let (u, v) = (L::load(&section.u), L::load(&section.v));
        let [u0, u1, u2, u3] = section.u;
        let [v0, v1, v2, v3] = section.v;
        let (next_u, next_v) = (L::new([u1, u2, u3, u0]), L::new([v1, v2, v3, v0]));
        let (edge_u, edge_v) = (next_u - u, next_v - v);
        let corner = |j: usize| -> Point { frame.corners[j] };
        let (zero, low, high) = (L::splat(0.0), L::splat(-TOLERANCE), L::splat(TOLERANCE));
        let real = (1 << section.len) - 1;
        let (mut section_inside, mut face_inside) = (real, 0);
        // of the face's corners from the section's edges, above and below the tolerance
        let (mut above, mut below) = ([0; 3], [0; 3]);
        let mut of_edges = [0; 3];
        for j in 0..3 {
            let [pu, pv] = corner(j);
            let side = edge_u * (L::splat(pv) - v) - edge_v * (L::splat(pu) - u);
            face_inside |= u32::from(zero.le(side).all()) << j;
            (above[j], below[j]) = (side.gt(high).bits(), side.lt(low).bits());
            let [qu, qv] = corner((j + 1) % 3);
            let side =
                L::splat(qu - pu) * (v - L::splat(pv)) - L::splat(qv - pv) * (u - L::splat(pu));
            section_inside &= zero.le(side).bits();
            let (above, below) = (side.gt(high).bits(), side.lt(low).bits());
            of_edges[j] = above & turned(below) | below & turned(above);
        }
        let mut crossings = 0;
        for j in 0..3 {
            let k = (j + 1) % 3;
            let of_corners = above[j] & below[k] | below[j] & above[k];
            crossings |= (of_corners & of_edges[j] & real) << (4 * j);
        }
        Self { section_inside, face_inside, crossings }
    }
}

/// Bit `i` is that of the corner after `i`.
#[inline(always)]
fn turned(bits: u32) -> u32 {
    bits >> 1 | (bits & 1) << 3
}
