//! Forces on edges that lie inside another triangle, four edges at a time: [`super::profile`] and
//! the forces of [`super::overlap2`] over lanes, with the same terms in the same order.

use crate::{
    TOLERANCE,
    lanes::{Lanes, Mask, each},
};

/// Edges, one per lane.
#[derive(Clone, Copy)]
pub(super) struct Edges<L> {
    /// Area coordinates of the edges' starts and ends in the other triangle.
    pub start: [L; 3],
    pub end: [L; 3],
    /// Outward normals, as long as the edges, m.
    pub normal: [L; 2],
    /// Velocities of starts and ends, m/s.
    pub velocity: [[L; 2]; 2],
    /// Velocities of the other triangle's corners, m/s.
    pub other_velocity: [[L; 2]; 3],
    /// Sliding accumulated before the step, m².
    pub sliding: L,
    /// Contact penalty of the pair, Pa.
    pub penalty: L,
    /// Tangential penalty of the pair, Pa.
    pub tangential_penalty: L,
    /// Coulomb's coefficient of the pair.
    pub friction: L,
}

/// What edges exert.
#[derive(Clone, Copy)]
pub(super) struct EdgeForces<L: Lanes> {
    /// Edges of which a piece lies inside; the others exert nothing.
    pub acts: L::Mask,
    /// Sliding after the step, m².
    pub sliding: L,
    /// Normal force borne by start and end, by the length of the edge, N/m.
    pub normal: [L; 2],
    /// Tangential force borne by start and end, by the length of the edge, N/m.
    pub tangential: [L; 2],
}

/// Integrals of the potential along the pieces inside.
struct Integrals<L: Lanes> {
    is_inside: L::Mask,
    /// 2∫P ds.
    total: L,
    /// 6∫P s ds.
    moment: L,
    /// Mean parameter of the profile's points.
    mean_parameter: L,
}

impl<L: Lanes> Edges<L> {
    /// The piece of each edge inside the other triangle: parameters where it begins and ends.
    #[inline(always)]
    fn piece(&self) -> (L, L) {
        let (a, b) = (&self.start, &self.end);
        let (zero, tolerance) = (L::splat(0.0), L::splat(TOLERANCE));
        let (mut low, mut high) = (zero, L::splat(1.0));
        each!(3, |m| {
            let crossing = a[m] / (a[m] - b[m]);
            let enters = a[m].lt(zero) & b[m].gt(tolerance);
            let leaves = a[m].gt(tolerance) & b[m].lt(zero);
            low = L::select(enters, low.larger(crossing), low);
            high = L::select(leaves, high.smaller(crossing), high);
        });
        (low, high)
    }

    #[inline(always)]
    fn integrals(&self) -> Integrals<L> {
        let (a, b) = (&self.start, &self.end);
        let (low, high) = self.piece();
        let slope = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
        let (start, end) = (lowest(a, &slope, low), lowest(a, &slope, high));
        // parameters where the smallest coordinate changes; infinite where there is no such kink
        let nowhere = L::splat(f64::INFINITY);
        let kinks = each!(3, |kink| {
            let [k, l, third] = [[0, 1, 2], [0, 2, 1], [1, 2, 0]][kink];
            let difference = slope[k] + a[l] - b[l];
            let at_kink = (a[l] - a[k]) / difference;
            let here = at(a, &slope, k, at_kink);
            let is_kink = difference.abs().gt(L::splat(TOLERANCE))
                & low.lt(at_kink)
                & at_kink.lt(high)
                & here.lt(at(a, &slope, third, at_kink));
            (L::select(is_kink, at_kink, nowhere), here)
        });
        // the exchange sort of the scalar code; kinks that are not there move to the end
        let [k0, k1, k2] = kinks;
        let (k0, k1) = in_order(k0, k1);
        let (k0, k2) = in_order(k0, k2);
        let (k1, k2) = in_order(k1, k2);
        let (s, p) = ([k0.0, k1.0, k2.0], [k0.1, k1.1, k2.1]);
        let has = each!(3, |k| s[k].lt(nowhere));
        // where a kink is not there, the next point is the end
        let s = each!(3, |k| s[k].smaller(high));
        let next = [s[1], s[2], high];
        let before = [low, s[0], s[1]];
        let mut last = low;
        each!(3, |k| last = L::select(has[k], s[k], last));
        let two = L::splat(2.0);
        let mut parameters = low;
        let mut points = two;
        let mut total = start * (s[0] - low) + end * (high - last);
        let mut moment =
            start * (s[0] - low) * (s[0] + two * low) + end * (high - last) * (last + two * high);
        each!(3, |k| {
            // few edges have three kinks
            if k < 2 || has[k].any() {
                let more = p[k] * (next[k] - before[k]);
                let around = (s[k] - before[k]) * (before[k] + two * s[k])
                    + (next[k] - s[k]) * (next[k] + two * s[k]);
                total = L::select(has[k], total + more, total);
                moment = L::select(has[k], moment + p[k] * around, moment);
                parameters = L::select(has[k], parameters + s[k], parameters);
                points = L::select(has[k], points + L::splat(1.0), points);
            }
        });
        Integrals {
            is_inside: !high.le(low),
            total,
            moment,
            mean_parameter: (parameters + high) / points,
        }
    }

    /// Velocity of the other triangle relative to the edge, where its mean point lies, m/s.
    #[inline(always)]
    fn relative_velocity(&self, s: L) -> [L; 2] {
        let rest = L::splat(1.0) - s;
        let inside = each!(3, |m| self.start[m] * rest + self.end[m] * s);
        let other = &self.other_velocity;
        each!(2, |k| {
            let there = other[2][k] * inside[0] + other[0][k] * inside[1] + other[1][k] * inside[2];
            there - (self.velocity[0][k] * rest + self.velocity[1][k] * s)
        })
    }

    /// Forces of the edges; `dt` is the time step, s.
    #[inline(always)]
    pub fn forces(&self, dt: f64) -> EdgeForces<L> {
        let integrals = self.integrals();
        let [nx, ny] = self.normal;
        let [x, y] = self.relative_velocity(integrals.mean_parameter);
        let velocity = -x * ny + y * nx;
        let mut sliding = self.sliding + velocity * L::splat(dt);
        let total = integrals.total * self.penalty * L::splat(1.5);
        let at_end = integrals.moment * self.penalty * L::splat(0.5);
        let at_start = total - at_end;
        let mut tangential = sliding * self.tangential_penalty;
        let slips = tangential.abs().gt(self.friction * total.abs());
        let limited = tangential * (self.friction * total / tangential).abs();
        sliding = L::select(slips, limited / self.tangential_penalty, sliding);
        tangential = L::select(slips, limited, tangential);
        let zero = L::splat(0.0);
        // no normal force carries no tangential force
        let is_zero = zero.le(total) & total.le(zero);
        let normal = [at_start, at_end];
        let tangential = each!(2, |end| L::select(is_zero, zero, tangential * normal[end] / total));
        let acts = integrals.is_inside;
        EdgeForces { acts, sliding, normal, tangential }
    }
}

/// Area coordinate `m` at the parameter `s` of an edge.
#[inline(always)]
fn at<L: Lanes>(start: &[L; 3], slope: &[L; 3], m: usize, s: L) -> L {
    start[m] + s * slope[m]
}

/// The potential at the parameter `s` of an edge.
#[inline(always)]
fn lowest<L: Lanes>(start: &[L; 3], slope: &[L; 3], s: L) -> L {
    at(start, slope, 0, s).smaller(at(start, slope, 1, s)).smaller(at(start, slope, 2, s))
}

/// Parameter and potential of two kinks, exchanged where the first parameter is larger.
#[inline(always)]
fn in_order<L: Lanes>(a: (L, L), b: (L, L)) -> ((L, L), (L, L)) {
    let swap = a.0.gt(b.0);
    let first = (L::select(swap, b.0, a.0), L::select(swap, b.1, a.1));
    let second = (L::select(swap, a.0, b.0), L::select(swap, a.1, b.1));
    (first, second)
}
