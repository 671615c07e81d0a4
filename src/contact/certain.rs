//! Couples that certainly have no effect in a step, four at a time.
//!
//! The rule is that of [`super::locate`]: a couple has no effect if every edge of each triangle
//! lies clear of the other triangle. There, area coordinates are held against the tolerance; here,
//! the twice-areas over which they are fractions are held against the tolerance times the area,
//! less a margin for rounding. No division is needed, and what is found clear is clear there, too:
//! a quotient below T(1 - 4ε) rounds to a number below T. Triangles with a coordinate that is no
//! number have an area that is none and are never certain.

use super::bodies::Triangles;
use crate::{
    TOLERANCE,
    lanes::{Lanes, each},
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
