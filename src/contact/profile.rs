//! The contact potential along the piece of an edge inside a triangle.

use crate::TOLERANCE;

/// Piecewise linear potential along the inner piece of an edge.
pub(super) struct Profile {
    /// Edge parameter and potential of up to five points.
    points: [(f64, f64); 5],
    len: usize,
}

impl Profile {
    /// Potential along the piece of the edge inside the other triangle;
    /// `a` and `b` are the area coordinates of the edge's ends.
    #[inline(always)]
    pub fn new(a: &[f64; 3], b: &[f64; 3]) -> Option<Self> {
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
        let mut points = [(low, lowest(low)), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0), (0.0, 0.0)];
        let mut len = 1;
        for (k, l, third) in [(0, 1, 2), (0, 2, 1), (1, 2, 0)] {
            let difference = slope[k] + a[l] - b[l];
            if difference.abs() > TOLERANCE {
                let s = (a[l] - a[k]) / difference;
                if low < s && s < high && at(k, s) < at(third, s) {
                    points[len] = (s, at(k, s));
                    len += 1;
                }
            }
        }
        points[len] = (high, lowest(high));
        sort(&mut points[1..len]);
        Some(Self { points, len: len + 1 })
    }

    /// Points of the profile, from the edge's start to its end.
    #[inline(always)]
    fn points(&self) -> &[(f64, f64)] {
        &self.points[..self.len]
    }

    /// Mean parameter of the points: where the sliding velocity is taken.
    #[inline(always)]
    pub fn mean_parameter(&self) -> f64 {
        let mut sum = 0.0;
        for point in self.points() {
            sum += point.0;
        }
        sum / self.len as f64
    }

    /// Normal force per unit edge length and its share at the edge's end,
    /// 3·penalty·∫P ds and 3·penalty·∫P s ds by the trapezoid rule, exact for
    /// the piecewise linear potential.
    #[inline(always)]
    pub fn forces(&self, penalty: f64) -> (f64, f64) {
        let p = self.points();
        let n = p.len() - 1;
        let mut total = p[0].1 * (p[1].0 - p[0].0) + p[n].1 * (p[n].0 - p[n - 1].0);
        let mut moment = p[0].1 * (p[1].0 - p[0].0) * (p[1].0 + 2.0 * p[0].0)
            + p[n].1 * (p[n].0 - p[n - 1].0) * (p[n - 1].0 + 2.0 * p[n].0);
        for k in 1..n {
            let (before, here, after) = (p[k - 1].0, p[k].0, p[k + 1].0);
            total += p[k].1 * (after - before);
            moment += p[k].1
                * ((here - before) * (before + 2.0 * here) + (after - here) * (after + 2.0 * here));
        }
        (total * penalty * 1.5, moment * penalty * 0.5)
    }
}

/// Exchange sort of the inner points (the ends are in place): points with equal
/// parameters end in the original's order.
#[inline(always)]
fn sort(points: &mut [(f64, f64)]) {
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
