//! The corners of two triangles in each other's area coordinates, four couples at a time:
//! [`super::placement`] over lanes.

use super::bodies::Triangles;
use crate::{
    TOLERANCE,
    lanes::{LANES, Lanes, Mask},
};

/// Area coordinates of four couples: `[t][e][i]` of corner `i` of triangle `t` relative to edge
/// `e` of the other, one couple per lane.
pub(super) type Coordinates = [[[[f64; LANES]; 3]; 3]; 2];

/// Writes the area coordinates of four couples. The result has for each lane the edges that have
/// to be cut: bits 0 to 2 those of the target, 3 to 5 those of the contactor.
#[inline(always)]
pub(super) fn locate<L: Lanes>(
    target: &Triangles<L>,
    contactor: &Triangles<L>,
    coordinates: &mut Coordinates,
) -> [u32; LANES] {
    let couple = [target, contactor];
    let (tolerance, minus) = (L::splat(TOLERANCE), L::splat(-TOLERANCE));
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
                coordinate.store(&mut coordinates[t][e][i]);
                below[i] = coordinate.lt(tolerance);
                above[i] = coordinate.gt(minus);
            }
            for i in 0..3 {
                outside[t][i] = outside[t][i] | below[i] & below[(i + 1) % 3];
            }
            off_line[1 - t][e] = below[0] & below[1] & below[2] | above[0] & above[1] & above[2];
        }
    }
    let mut cut = [0; LANES];
    for t in 0..2 {
        for i in 0..3 {
            let clear = (outside[t][i] | off_line[t][i]).bits();
            for (lane, cut) in cut.iter_mut().enumerate() {
                *cut |= (!clear >> lane & 1) << (3 * t + i);
            }
        }
    }
    cut
}
