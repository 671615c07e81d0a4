//! Forces on edges that lie inside another triangle, four edges at a time: [`super::profile`] and
//! the forces of [`super::overlap2`] over lanes, with the same terms in the same order.

use crate::{
    TOLERANCE,
    lanes::{Lanes, Mask, each},
};

/// Ends of edges in the other triangle's area coordinates, one edge per lane.
#[derive(Clone, Copy)]
pub(super) struct Ends<L> {
    /// Where they start and where they end.
    pub start: [L; 3],
    pub end: [L; 3],
}

/// Integrals of the potential along the pieces inside.
#[derive(Clone, Copy)]
pub(super) struct Integrals<L> {
    /// Where the pieces begin and end; what does not begin before it ends is not there.
    pub low: L,
    pub high: L,
    /// 2∫P ds.
    pub total: L,
    /// 6∫P s ds.
    pub moment: L,
    /// Mean parameter of the profile's points.
    pub mean_parameter: L,
}

impl<L: Lanes> Integrals<L> {
    /// The same number everywhere.
    #[inline(always)]
    pub fn all(value: L) -> Self {
        Self { low: value, high: value, total: value, moment: value, mean_parameter: value }
    }

    /// Edges of which a piece lies inside.
    #[inline(always)]
    pub fn is_inside(&self) -> L::Mask {
        !self.high.le(self.low)
    }
}

/// A point where the smallest coordinate changes; infinite where there is none.
#[derive(Clone, Copy)]
struct Kink<L> {
    parameter: L,
    potential: L,
}

impl<L: Lanes> Ends<L> {
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

    /// The integrals along the pieces inside; those of lanes not `wanted` mean nothing.
    #[inline(always)]
    pub fn integrals(&self, wanted: L::Mask) -> Integrals<L> {
        let (a, b) = (&self.start, &self.end);
        let (low, high) = self.piece();
        let slope = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
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
            (is_kink, Kink { parameter: L::select(is_kink, at_kink, nowhere), potential: here })
        });
        let profile =
            Profile { low, high, start: lowest(a, &slope, low), end: lowest(a, &slope, high) };
        let [(is_first, first), (is_second, second), (is_third, third)] = kinks;
        let several = is_first & is_second | is_third & (is_first | is_second);
        if (several & wanted).any() {
            // the exchange sort of the scalar code; kinks that are not there move to the end
            let (first, second) = in_order(first, second);
            let (first, third) = in_order(first, third);
            let (second, third) = in_order(second, third);
            profile.integrals([first, second, third])
        } else {
            let kink = Kink::select(is_second, second, first);
            profile.integrals([Kink::select(is_third, third, kink)])
        }
    }
}

/// The potential along pieces inside: linear between its points.
struct Profile<L> {
    /// Parameters where pieces begin and end.
    low: L,
    high: L,
    /// The potential there.
    start: L,
    end: L,
}

impl<L: Lanes> Profile<L> {
    /// The integrals with these kinks, in order.
    #[inline(always)]
    fn integrals<const N: usize>(self, kinks: [Kink<L>; N]) -> Integrals<L> {
        let Self { low, high, start, end } = self;
        let (two, nowhere) = (L::splat(2.0), L::splat(f64::INFINITY));
        // where a kink is not there, the next point is the end
        let mut points_at = [high; N];
        let mut last = low;
        let mut k = 0;
        while k < N {
            let parameter = kinks[k].parameter;
            points_at[k] = parameter.smaller(high);
            last = L::select(parameter.lt(nowhere), parameter, last);
            k += 1;
        }
        let first = points_at[0];
        let mut parameters = low;
        let mut points = two;
        let mut total = start * (first - low) + end * (high - last);
        let mut moment =
            start * (first - low) * (first + two * low) + end * (high - last) * (last + two * high);
        let mut before = low;
        let mut k = 0;
        while k < N {
            let has = kinks[k].parameter.lt(nowhere);
            // few edges have three kinks
            if k < 2 || has.any() {
                let s = points_at[k];
                let next = if k + 1 < N { points_at[k + 1] } else { high };
                let p = kinks[k].potential;
                let more = p * (next - before);
                let around = (s - before) * (before + two * s) + (next - s) * (next + two * s);
                total = L::select(has, total + more, total);
                moment = L::select(has, moment + p * around, moment);
                parameters = L::select(has, parameters + s, parameters);
                points = L::select(has, points + L::splat(1.0), points);
                before = s;
            }
            k += 1;
        }
        Integrals { low, high, total, moment, mean_parameter: (parameters + high) / points }
    }
}

impl<L: Lanes> Kink<L> {
    #[inline(always)]
    fn select(mask: L::Mask, yes: Self, no: Self) -> Self {
        Self {
            parameter: L::select(mask, yes.parameter, no.parameter),
            potential: L::select(mask, yes.potential, no.potential),
        }
    }
}

/// Edges of which a piece lies inside, one per lane.
#[derive(Clone, Copy)]
pub(super) struct Edges<'a, L> {
    pub ends: Ends<L>,
    /// Outward normals, as long as the edges, m.
    pub normal: [L; 2],
    /// Velocities of starts and ends, m/s.
    pub velocity: [[L; 2]; 2],
    /// Velocities of the other triangle's corners, m/s.
    pub other_velocity: [[L; 2]; 3],
    /// Sliding accumulated before the step, m².
    pub sliding: L,
    pub pair: &'a Pairs<L>,
}

/// Contact properties of pairs of materials, one pair per lane.
#[derive(Clone, Copy)]
pub(super) struct Pairs<L> {
    /// Contact penalty, Pa.
    pub penalty: L,
    /// Tangential penalty, Pa.
    pub tangential_penalty: L,
    /// Coulomb's coefficient.
    pub friction: L,
}

/// What edges exert.
#[derive(Clone, Copy)]
pub(super) struct EdgeForces<L> {
    /// Sliding after the step, m².
    pub sliding: L,
    /// Normal force borne by start and end, by the length of the edge, N/m.
    pub normal: [L; 2],
    /// Tangential force borne by start and end, by the length of the edge, N/m.
    pub tangential: [L; 2],
}

impl<L: Lanes> Edges<'_, L> {
    /// Velocity of the other triangle relative to the edge, at the parameter `s`, m/s.
    #[inline(always)]
    fn relative_velocity(&self, s: L) -> [L; 2] {
        let rest = L::splat(1.0) - s;
        let Ends { start, end } = &self.ends;
        let inside = each!(3, |m| start[m] * rest + end[m] * s);
        let other = &self.other_velocity;
        each!(2, |k| {
            let there = other[2][k] * inside[0] + other[0][k] * inside[1] + other[1][k] * inside[2];
            there - (self.velocity[0][k] * rest + self.velocity[1][k] * s)
        })
    }

    /// Forces of the edges; `dt` is the time step, s. Those of lanes not `wanted` mean nothing.
    #[inline(always)]
    pub fn forces(&self, wanted: L::Mask, integrals: &Integrals<L>, dt: f64) -> EdgeForces<L> {
        let Pairs { penalty, tangential_penalty, friction } = *self.pair;
        let [nx, ny] = self.normal;
        let [x, y] = self.relative_velocity(integrals.mean_parameter);
        let velocity = -x * ny + y * nx;
        let mut sliding = self.sliding + velocity * L::splat(dt);
        let total = integrals.total * penalty * L::splat(1.5);
        let at_end = integrals.moment * penalty * L::splat(0.5);
        let at_start = total - at_end;
        let mut tangential = sliding * tangential_penalty;
        let slips = tangential.abs().gt(friction * total.abs());
        if (slips & wanted).any() {
            let limited = tangential * (friction * total / tangential).abs();
            sliding = L::select(slips, limited / tangential_penalty, sliding);
            tangential = L::select(slips, limited, tangential);
        }
        let zero = L::splat(0.0);
        // no normal force carries no tangential force
        let is_zero = zero.le(total) & total.le(zero);
        let normal = [at_start, at_end];
        let tangential = each!(2, |end| L::select(is_zero, zero, tangential * normal[end] / total));
        EdgeForces { sliding, normal, tangential }
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

/// Two kinks, exchanged where the first parameter is larger.
#[inline(always)]
fn in_order<L: Lanes>(a: Kink<L>, b: Kink<L>) -> (Kink<L>, Kink<L>) {
    let swap = a.parameter.gt(b.parameter);
    (Kink::select(swap, b, a), Kink::select(swap, a, b))
}
