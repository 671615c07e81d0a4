//! Couples that certainly have no effect in a step, four at a time.
//!
//! The rule is that of [`super::locate`]: a couple has no effect if every edge of each triangle
//! lies clear of the other triangle. There, area coordinates are held against the tolerance; here,
//! the twice-areas over which they are fractions are held against the tolerance times the area,
//! less a margin for rounding. No division is needed, and what is found clear is clear there, too:
//! a quotient below T(1 - 4ε) rounds to a number below T. Triangles with a coordinate that is no
//! number have an area that is none and are never certain.

use super::bodies::{Body, Triangles, edges_of};
use crate::{
    TOLERANCE,
    lanes::{LANES, Lanes, each},
    mechanics::Vec2,
};

/// The tolerance, less more than two roundings.
const CERTAIN: f64 = TOLERANCE * (1.0 - 8.0 * f64::EPSILON);

/// Lanes in which no edge of either triangle has to be cut. Lanes with a triangle that is not
/// counter-clockwise are never certain.
#[inline(always)]
pub(super) fn certainly_clear<L: Lanes>(
    target: &Triangles<L>,
    contactor: &Triangles<L>,
) -> L::Mask {
    let couple = [target, contactor];
    let limit = each!(2, |t| couple[t].double_area * L::splat(CERTAIN));
    let zero = L::splat(0.0);
    let mut certain = zero.lt(limit[0]) & zero.lt(limit[1]);
    let never = !certain & certain;
    // whether both ends of an edge are below an edge of the other triangle
    let mut outside = [[never; 3]; 2];
    // whether all corners of the other triangle are on one side of an edge
    let mut off_line = [[never; 3]; 2];
    for t in 0..2 {
        let (own, other) = (couple[t], couple[1 - t]);
        let (low, high) = (limit[1 - t], -limit[1 - t]);
        // of each edge's higher end, over the edges of the other triangle
        let mut lowest = [low; 3];
        for e in 0..3 {
            let [nx, ny] = other.normal(e);
            let [a, b, c] =
                each!(3, |i| (other.x[e] - own.x[i]) * nx + (other.y[e] - own.y[i]) * ny);
            let upper = [a.larger(b), b.larger(c), c.larger(a)];
            each!(3, |i| lowest[i] = lowest[i].smaller(upper[i]));
            let (top, bottom) = (upper[0].larger(c), a.smaller(b).smaller(c));
            off_line[1 - t][e] = top.lt(low) | bottom.gt(high);
        }
        outside[t] = each!(3, |i| lowest[i].lt(low));
    }
    for t in 0..2 {
        for i in 0..3 {
            certain = certain & (outside[t][i] | off_line[t][i]);
        }
    }
    certain
}

/// An edge of the target and one of the contactor, each of which may have all of the other triangle
/// outside. Then every edge of either triangle is outside that one edge of the other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Separator(u8);

impl Separator {
    /// The edges with the other triangle furthest outside.
    pub fn of(target: &[Vec2; 3], contactor: &[Vec2; 3]) -> Self {
        Self(Self::furthest(target, contactor) << 2 | Self::furthest(contactor, target))
    }

    fn furthest(own: &[Vec2; 3], other: &[Vec2; 3]) -> u8 {
        let mut best = (f64::INFINITY, 0);
        for e in 0..3u8 {
            let (start, end) = (own[usize::from(e)], own[(usize::from(e) + 1) % 3]);
            let inside = |p: &Vec2| (end - start).perp(&(p - start));
            let nearest = other.iter().map(inside).fold(f64::NEG_INFINITY, f64::max);
            if nearest < best.0 {
                best = (nearest, e);
            }
        }
        best.1
    }

    /// From what [`Self::bits`] gave.
    #[inline(always)]
    pub fn from_bits(bits: u8) -> Self {
        Self(bits)
    }

    pub fn bits(self) -> u8 {
        self.0
    }

    #[inline(always)]
    fn of_target(self) -> u8 {
        self.0 >> 2 & 3
    }

    #[inline(always)]
    fn of_contactor(self) -> u8 {
        self.0 & 3
    }
}

/// Lanes in which [`certainly_clear`] holds because of the separator. Most couples that are clear
/// are so because of the same edges for a long time, and two edges are looked at much faster than
/// six.
#[inline(always)]
pub(super) fn certainly_separated<L: Lanes>(
    bodies: &[[&Body; 2]; LANES],
    separators: [Separator; LANES],
) -> L::Mask {
    let bodies = each!(2, |t| each!(4, |k| bodies[k][t]));
    let edges = [
        edges_of::<L>(bodies[0], each!(4, |k| separators[k].of_target())),
        edges_of::<L>(bodies[1], each!(4, |k| separators[k].of_contactor())),
    ];
    let triangles = each!(2, |t| Triangles::<L>::new(bodies[t]));
    let zero = L::splat(0.0);
    let [target, contactor] = each!(2, |t| {
        let (own, other) = (&triangles[t], &triangles[1 - t]);
        let [x0, y0, x1, y1] = edges[t];
        let (nx, ny) = (y1 - y0, x0 - x1);
        let [a, b, c] = each!(3, |i| (x0 - other.x[i]) * nx + (y0 - other.y[i]) * ny);
        let limit = own.double_area * L::splat(CERTAIN);
        zero.lt(limit) & a.larger(b).larger(c).lt(limit)
    });
    target & contactor
}
