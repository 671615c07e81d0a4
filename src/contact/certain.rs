//! Couples that certainly have no effect in a step, four at a time.
//!
//! The rule is that of [`super::locate`]: a couple has no effect if every edge of each triangle
//! lies clear of the other triangle. There, area coordinates are held against the tolerance; here,
//! the twice-areas over which they are fractions are held against the tolerance times the area,
//! less a margin for rounding. No division is needed, and what is found clear is clear there, too:
//! a quotient below T(1 - 4ε) rounds to a number below T.

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
    // [t][e][i]: corner i of t is not inside edge e of the other / not outside it
    let never = !certain & certain;
    let mut below = [[[never; 3]; 3]; 2];
    let mut above = [[[never; 3]; 3]; 2];
    for i in 0..3 {
        for k in 0..3 {
            // from corner i of the target to corner k of the contactor
            let dx = contactor.x[k] - target.x[i];
            let dy = contactor.y[k] - target.y[i];
            let [nx, ny] = contactor.normal(k);
            let twice_area = dx * nx + dy * ny;
            below[0][k][i] = twice_area.lt(limit[1]);
            above[0][k][i] = twice_area.gt(-limit[1]);
            let [nx, ny] = target.normal(i);
            // the other way round with the sign reversed
            let negative = dx * nx + dy * ny;
            below[1][i][k] = negative.gt(-limit[0]);
            above[1][i][k] = negative.lt(limit[0]);
        }
    }
    for t in 0..2 {
        for i in 0..3 {
            let j = (i + 1) % 3;
            let [own, other] = [&below[t], &below[1 - t]];
            let outside = own[0][i] & own[0][j] | own[1][i] & own[1][j] | own[2][i] & own[2][j];
            let beyond = other[i][0] & other[i][1] & other[i][2];
            let within = above[1 - t][i][0] & above[1 - t][i][1] & above[1 - t][i][2];
            certain = certain & (outside | beyond | within);
        }
    }
    certain
}
