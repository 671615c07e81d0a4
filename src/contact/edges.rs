//! Forces on edges that lie inside another triangle, four edges at a time: [`super::profile`] and
//! the forces of [`super::overlap2`] over lanes, with the same terms in the same order.

use crate::{
    TOLERANCE,
    lanes::{Lanes, Mask, each},
};

/// Four edges, one per lane.
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

/// What four edges exert.
#[derive(Clone, Copy)]
pub(super) struct EdgeForces<L: Lanes> {
    /// Edges of which a piece lies inside; the others exert nothing.
    pub acts: L::Mask,
    /// Sliding after the step, m².
    pub sliding: L,
    /// What is subtracted from the forces on start and end, N: of each the normal part, then the
    /// tangential part.
    pub subtracted: [[L; 4]; 2],
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
        for m in 0..3 {
            let crossing = a[m] / (a[m] - b[m]);
            let enters = a[m].lt(zero) & b[m].gt(tolerance);
            let leaves = a[m].gt(tolerance) & b[m].lt(zero);
            low = L::select(enters, low.larger(crossing), low);
            high = L::select(leaves, high.smaller(crossing), high);
        }
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
        let mut s = [nowhere; 3];
        let mut p = [L::splat(0.0); 3];
        for (kink, k, l, third) in [(0, 0, 1, 2), (1, 0, 2, 1), (2, 1, 2, 0)] {
            let difference = slope[k] + a[l] - b[l];
            let at_kink = (a[l] - a[k]) / difference;
            let here = at(a, &slope, k, at_kink);
            let is_kink = difference.abs().gt(L::splat(TOLERANCE))
                & low.lt(at_kink)
                & at_kink.lt(high)
                & here.lt(at(a, &slope, third, at_kink));
            s[kink] = L::select(is_kink, at_kink, nowhere);
            p[kink] = here;
        }
        // the exchange sort of the scalar code; kinks that are not there move to the end
        for (i, j) in [(0, 1), (0, 2), (1, 2)] {
            let swap = s[i].gt(s[j]);
            (s[i], s[j]) = (L::select(swap, s[j], s[i]), L::select(swap, s[i], s[j]));
            (p[i], p[j]) = (L::select(swap, p[j], p[i]), L::select(swap, p[i], p[j]));
        }
        let has = each!(3, |k| s[k].lt(nowhere));
        // where a kink is not there, the next point is the end
        let s = each!(3, |k| s[k].smaller(high));
        let next = [s[1], s[2], high];
        let before = [low, s[0], s[1]];
        let mut last = low;
        for k in 0..3 {
            last = L::select(has[k], s[k], last);
        }
        let two = L::splat(2.0);
        let mut parameters = low;
        let mut points = two;
        let mut total = start * (s[0] - low) + end * (high - last);
        let mut moment =
            start * (s[0] - low) * (s[0] + two * low) + end * (high - last) * (last + two * high);
        for k in 0..3 {
            // few edges have three kinks
            if k == 2 && !has[k].any() {
                break;
            }
            let more = p[k] * (next[k] - before[k]);
            let around = (s[k] - before[k]) * (before[k] + two * s[k])
                + (next[k] - s[k]) * (next[k] + two * s[k]);
            total = L::select(has[k], total + more, total);
            moment = L::select(has[k], moment + p[k] * around, moment);
            parameters = L::select(has[k], parameters + s[k], parameters);
            points = L::select(has[k], points + L::splat(1.0), points);
        }
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
        let at_ends = [at_start, at_end];
        let subtracted = each!(2, |end| {
            let normal = at_ends[end];
            let tangential = L::select(is_zero, zero, tangential * normal / total);
            [normal * nx, normal * ny, tangential * ny, -(tangential * nx)]
        });
        let acts = integrals.is_inside;
        EdgeForces { acts, sliding: L::select(acts, sliding, self.sliding), subtracted }
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
