//! The corners of two triangles in each other's area coordinates, four couples at a time:
//! [`super::placement`] over lanes.

use super::bodies::Triangles;
use crate::{TOLERANCE, lanes::Lanes};

/// Where the corners of four couples lie, one couple per lane. Corners 0 to 2 are those of the
/// target, 3 to 5 those of the contactor; the rest is empty.
pub(super) struct Located<L: Lanes> {
    /// Area coordinates of each corner in the other triangle.
    pub points: [[L; 3]; 8],
    /// Which edges have to be cut; edge `c` begins at corner `c`.
    pub cut: [L::Mask; 8],
}

/// Area coordinates of four couples, and which edges have to be cut.
#[inline(always)]
pub(super) fn locate<L: Lanes>(target: &Triangles<L>, contactor: &Triangles<L>) -> Located<L> {
    let couple = [target, contactor];
    let (tolerance, minus) = (L::splat(TOLERANCE), L::splat(-TOLERANCE));
    let mut points = [[tolerance; 3]; 8];
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
                points[3 * t + i][e] = coordinate;
                below[i] = coordinate.lt(tolerance);
                above[i] = coordinate.gt(minus);
            }
            for i in 0..3 {
                outside[t][i] = outside[t][i] | below[i] & below[(i + 1) % 3];
            }
            off_line[1 - t][e] = below[0] & below[1] & below[2] | above[0] & above[1] & above[2];
        }
    }
    let mut cut = [never; 8];
    for t in 0..2 {
        for i in 0..3 {
            cut[3 * t + i] = !(outside[t][i] | off_line[t][i]);
        }
    }
    Located { points, cut }
}
