//! The contact potential along the piece of an edge inside a triangle.

use crate::TOLERANCE;

/// A point on an edge: parameter from 0 at its start to 1 at its end, and the
/// potential there.
type Point = (f64, f64);

/// Integrals of the potential along the piece of an edge inside a triangle,
/// exact for the piecewise linear potential.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Integrals {
    /// 2∫P ds.
    pub total: f64,
    /// 6∫P s ds.
    pub moment: f64,
    /// Mean parameter of the profile's points: where the sliding velocity is taken.
    pub mean_parameter: f64,
}

impl Integrals {
    /// Integrals along an edge whose ends have the area coordinates `a` and
    /// `b`; `None` if nothing of it lies inside.
    #[inline(always)]
    pub fn along(a: &[f64; 3], b: &[f64; 3]) -> Option<Self> {
        let (mut low, mut high) = (0.0f64, 1.0f64);
        for m in 0..3 {
            if a[m] < 0.0 && b[m] > TOLERANCE {
                low = larger(low, a[m] / (a[m] - b[m]));
            }
            if a[m] > TOLERANCE && b[m] < 0.0 {
                high = smaller(high, a[m] / (a[m] - b[m]));
            }
        }
        if high <= low {
            return None;
        }
        let slope = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let at = |m: usize, s: f64| a[m] + s * slope[m];
        let lowest = |s: f64| smaller(smaller(at(0, s), at(1, s)), at(2, s));
        let (start, end) = ((low, lowest(low)), (high, lowest(high)));
        let mut kinks = [(0.0, 0.0); 3];
        let mut count = 0;
        for (k, l, third) in [(0, 1, 2), (0, 2, 1), (1, 2, 0)] {
            let difference = slope[k] + a[l] - b[l];
            if difference.abs() > TOLERANCE {
                let s = (a[l] - a[k]) / difference;
                let here = at(k, s);
                if low < s && s < high && here < at(third, s) {
                    kinks[count] = (s, here);
                    count += 1;
                }
            }
        }
        // one case for each number of points, so that each is straight code
        Some(match count {
            0 => integrate([start, end]),
            1 => integrate([start, kinks[0], end]),
            2 => {
                sort(&mut kinks[..2]);
                integrate([start, kinks[0], kinks[1], end])
            }
            _ => {
                sort(&mut kinks);
                integrate([start, kinks[0], kinks[1], kinks[2], end])
            }
        })
    }
}

/// Trapezoid rule over the points of a profile, in the original's order of terms.
#[inline(always)]
fn integrate<const POINTS: usize>(p: [Point; POINTS]) -> Integrals {
    let n = POINTS - 1;
    let mut parameters = 0.0;
    for point in &p {
        parameters += point.0;
    }
    let mut total = p[0].1 * (p[1].0 - p[0].0) + p[n].1 * (p[n].0 - p[n - 1].0);
    let mut moment = p[0].1 * (p[1].0 - p[0].0) * (p[1].0 + 2.0 * p[0].0)
        + p[n].1 * (p[n].0 - p[n - 1].0) * (p[n - 1].0 + 2.0 * p[n].0);
    for k in 1..n {
        let (before, here, after) = (p[k - 1].0, p[k].0, p[k + 1].0);
        total += p[k].1 * (after - before);
        moment += p[k].1
            * ((here - before) * (before + 2.0 * here) + (after - here) * (after + 2.0 * here));
    }
    Integrals { total, moment, mean_parameter: parameters / POINTS as f64 }
}

/// Exchange sort of the inner points (the ends are in place): points with equal
/// parameters end in the original's order.
#[inline(always)]
fn sort(points: &mut [Point]) {
    for i in 1..points.len() {
        for j in i..points.len() {
            if points[i - 1].0 > points[j].0 {
                points.swap(i - 1, j);
            }
        }
    }
}

#[inline(always)]
fn smaller(a: f64, b: f64) -> f64 {
    if b < a { b } else { a }
}

#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// From a triangle's corner to a point of the opposite edge the potential
    /// rises to 1/5 at s = 4/5 and falls to 0.
    #[test]
    fn the_potential_is_a_tent_over_the_edge() {
        let integrals = Integrals::along(&[1.0, 0.0, 0.0], &[0.0, 0.25, 0.75]).expect("inside");
        assert!((integrals.total - 2.0 * 0.5 * 0.2).abs() < 1e-15);
        assert!((integrals.mean_parameter - (0.0 + 0.8 + 1.0) / 3.0).abs() < 1e-15);
        // 6∫P s ds over the two slopes
        let moment = 6.0 * (0.25 * 0.8f64.powi(3) / 3.0 + (0.5 - 1.0 / 3.0 - 0.32 + 0.512 / 3.0));
        assert!((integrals.moment - moment).abs() < 1e-14);
    }

    #[test]
    fn an_edge_that_leaves_before_it_enters_has_no_piece_inside() {
        assert_eq!(Integrals::along(&[-0.5, 0.25, 1.0], &[0.5, -0.75, 1.0]), None);
    }
}
