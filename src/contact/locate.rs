//! The corners of two triangles in each other's area coordinates, four couples at a time:
//! [`super::placement`] over lanes.

use super::bodies::Triangles;
use crate::{
    TOLERANCE,
    lanes::{Lanes, each},
};

/// Area coordinates of four couples: `[t][e][i]` of corner `i` of triangle `t` relative to edge
/// `e` of the other, one couple per lane.
pub(super) type Coordinates<L> = [[[L; 3]; 3]; 2];

/// Edges of four couples: `[t][i]` edge `i` of triangle `t`.
pub(super) type EdgeMasks<L> = [[<L as Lanes>::Mask; 3]; 2];

/// Area coordinates of four couples, and which edges have to be cut.
#[inline(always)]
pub(super) fn locate<L: Lanes>(
    target: &Triangles<L>,
    contactor: &Triangles<L>,
) -> (Coordinates<L>, EdgeMasks<L>) {
    let couple = [target, contactor];
    let (tolerance, minus) = (L::splat(TOLERANCE), L::splat(-TOLERANCE));
    let mut coordinates = [[[tolerance; 3]; 3]; 2];
    let never = tolerance.lt(minus);
    let mut outside = [[never; 3]; 2];
    let mut off_line = [[never; 3]; 2];
    for t in 0..2 {
        let (own, other) = (couple[t], couple[1 - t]);
        for e in 0..3 {
            let [nx, ny] = other.normal(e);
            let mut below = [never; 3];
            let mut above = [never; 3];
            for i in 0..3 {
                let twice_area = (other.x[e] - own.x[i]) * nx + (other.y[e] - own.y[i]) * ny;
                let coordinate = twice_area / other.double_area;
                coordinates[t][e][i] = coordinate;
                below[i] = coordinate.lt(tolerance);
                above[i] = coordinate.gt(minus);
            }
            for i in 0..3 {
                outside[t][i] = outside[t][i] | below[i] & below[(i + 1) % 3];
            }
            off_line[1 - t][e] = below[0] & below[1] & below[2] | above[0] & above[1] & above[2];
        }
    }
    let cut = each!(2, |t| each!(3, |i| !(outside[t][i] | off_line[t][i])));
    (coordinates, cut)
}
