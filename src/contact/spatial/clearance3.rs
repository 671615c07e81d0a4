//! Which pairs of faces of a couple can do nothing, and how far its nodes may move before that may
//! change.
//!
//! A target face and a contactor face do nothing if
//!
//! 1. a node of the target face is one of the contactor face: it lies in the plane whatever moves,
//!    and a section has three points only if no node of its sub-tetrahedron lies in the plane;
//! 2. no node of the sub-tetrahedron is below the plane;
//! 3. no node of the target face is above it;
//! 4. the sub-tetrahedron and the contactor face are apart by more than rounding can bridge.
//!
//! For 2 and 3 the volumes det(c₁, c₂, t) decide. When every node moves by at most b, the three
//! vectors change by at most 2b, and the volume by at most 7bL² for b ≤ L/16 and points no further
//! apart than L. For 4, a gap shrinks by at most 2b.
//!
//! How wide a gap has to be: the section could be taken to hold a corner of the contactor face only
//! if that lies, within the rounding 4uL of the cross products per length of the section's edges,
//! inside all of them. A corner at a distance g from the section is outside one of them by
//! g·sin(α/2) at least, α the smallest angle of the section. A plane that no node is nearer to than
//! the tolerance ε meets an edge of the sub-tetrahedron under an angle of sine 2ε/L at least, so
//! that sin α ≥ 2εσ/L, σ the smallest sine of its dihedral angles; hence g > 4uL²/(εσ). Crossings
//! of edges count only if they exceed the tolerance, which is far above rounding; corners of the
//! section count as inside the face only within rounding. All this holds for tetrahedra that are
//! not flat, and large ones never rest: then all pairs of faces are evaluated.
//!
//! The result is exact, not approximate: forces with and without are equal bit for bit.

use super::{Contactor, FACES, Tetrahedron, Vec3, dot, vector_product};
use crate::{TOLERANCE, lanes::each};

/// Share of a bound that is used, for the rounding of the accumulated path.
const SAFETY: f64 = 0.99;
/// Volumes below this share of L³ are not trusted to have a sign.
const NOISE: f64 = 1e-9;
/// Gaps have to be larger than this times L²/σ: four times what is needed.
const BRIDGED: f64 = 16.0 * f64::EPSILON / 2.0 / TOLERANCE;
/// Heights above planes must be exact to a hundredth of the tolerance.
const HEIGHT_ERROR: f64 = 16.0 * f64::EPSILON / 2.0 * 100.0 / TOLERANCE;

/// Pairs of faces, bit `4 * target face + contactor face`.
pub(super) type FacePairs = u16;

/// All pairs of faces.
pub(super) const ALL_PAIRS: FacePairs = FacePairs::MAX;

/// What is known of a couple for a while.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Clearance {
    /// Pairs of faces that may do something.
    pub active: FacePairs,
    /// How far any node may move before one of the others may do something, m; 0 if not at all.
    pub free: f64,
}

/// A couple that is asked.
#[derive(Debug, Clone, Copy)]
pub(super) struct Asked<'a> {
    /// Numbers of the nodes of target and contactor.
    pub nodes: [&'a [u32; 4]; 2],
    pub bodies: [&'a Tetrahedron; 2],
    /// Their faces.
    pub faces: [&'a Contactor; 2],
}

impl Asked<'_> {
    /// Leaves out the pairs of faces that do nothing while no node moves by more than `horizon` at
    /// least.
    pub fn clearance(&self, horizon: f64) -> Clearance {
        let mut least = f64::INFINITY;
        let Some(scale) = Scale::new(self) else {
            return Clearance { active: ALL_PAIRS, free: 0.0 };
        };
        let heights = self.heights();
        let enough = scale.gap_for(horizon);
        let gaps = gaps_of_bodies(&heights);
        let apart = scale.free(gaps[0].max(gaps[1]));
        if apart > horizon {
            return Clearance { active: 0, free: SAFETY * apart };
        }
        let mut active = 0;
        for face in 0..4 {
            let of_face = scale.free(self.gap_of_contactor_face(&heights, face));
            for target_face in 0..4 {
                let mut free = apart.max(of_face);
                if free <= horizon {
                    free = free.max(self.sides(&scale, &heights, target_face, face));
                }
                if free <= horizon {
                    free = free.max(scale.free(self.gap_of_section(&heights, target_face)));
                }
                if free <= horizon {
                    free = free.max(scale.free(self.gap_of_faces(target_face, face, enough)));
                }
                if free > horizon {
                    least = least.min(free);
                } else {
                    active |= 1 << (4 * target_face + face);
                }
            }
        }
        Clearance { active, free: SAFETY * least.min(scale.most) }
    }

    /// The same where the faces of both are pressed: all pairs or none.
    pub fn clearance_of_bodies(&self, horizon: f64) -> Clearance {
        let apart = Scale::new(self).map_or(0.0, |scale| {
            let gaps = gaps_of_bodies(&self.heights());
            scale.free(gaps[0].max(gaps[1]))
        });
        if apart > horizon {
            Clearance { active: 0, free: SAFETY * apart }
        } else {
            Clearance { active: ALL_PAIRS, free: horizon }
        }
    }

    /// Of each node of the one above the faces of the other: `[t][face of t][node of the other]`.
    fn heights(&self) -> [[[f64; 4]; 4]; 2] {
        each!(2, |t| {
            let (frames, corners) = (&self.faces[t].frames, &self.bodies[1 - t].corners);
            each!(4, |f| {
                let frame = &frames[f];
                each!(4, |i| dot(&frame.normal, &(corners[i] - frame.origin)))
            })
        })
    }

    /// How far a contactor face lies outside the target.
    fn gap_of_contactor_face(&self, heights: &[[[f64; 4]; 4]; 2], face: usize) -> f64 {
        let [a, b, c, _] = FACES[face];
        let beyond = |above: &[f64; 4]| -larger(larger(above[a], above[b]), above[c]);
        heights[0].iter().map(beyond).fold(f64::NEG_INFINITY, larger)
    }

    /// How far the sub-tetrahedron of a target face lies outside the contactor.
    fn gap_of_section(&self, heights: &[[[f64; 4]; 4]; 2], target_face: usize) -> f64 {
        let [a, b, c, _] = FACES[target_face];
        let beyond = |above: &[f64; 4]| {
            let centroid = 0.25 * (above[0] + above[1] + above[2] + above[3]);
            -larger(larger(above[a], above[b]), larger(above[c], centroid))
        };
        heights[1].iter().map(beyond).fold(f64::NEG_INFINITY, larger)
    }

    /// How far nodes may move until reasons 1 to 3 may fail, 0 if they do not hold.
    fn sides(
        &self,
        scale: &Scale,
        heights: &[[[f64; 4]; 4]; 2],
        target_face: usize,
        face: usize,
    ) -> f64 {
        let base = &FACES[target_face][..3];
        let own = FACES[face].map(|node| self.nodes[1][node]);
        let is_in_plane = |node: usize| own[..3].contains(&self.nodes[0][node]);
        if base.iter().any(|&node| is_in_plane(node)) {
            return scale.most;
        }
        let above = &heights[1][face];
        let highest = base.iter().map(|&node| above[node]).fold(f64::NEG_INFINITY, f64::max);
        let centroid = 0.25 * (above[0] + above[1] + above[2] + above[3]);
        let lowest = base.iter().map(|&node| above[node]).fold(centroid, f64::min);
        let height = lowest.max(-highest);
        scale.free_of_volume(height * self.faces[1].frames[face].double_area)
    }

    /// How far apart the sub-tetrahedron of a target face and a contactor face are; no more than
    /// `enough` is looked for.
    fn gap_of_faces(&self, target_face: usize, face: usize, enough: f64) -> f64 {
        let [a, b, c, _] = FACES[target_face];
        let own = self.bodies[0];
        let sub = [own.corners[a], own.corners[b], own.corners[c], own.centroid];
        let [a, b, c, _] = FACES[face];
        let corners = &self.bodies[1].corners;
        let triangle = [corners[a], corners[b], corners[c]];
        let mut best = f64::NEG_INFINITY;
        let mut try_axis = |axis: Vec3| {
            let length = dot(&axis, &axis).sqrt();
            let (low, high) = interval(&sub, &axis);
            let (other_low, other_high) = interval(&triangle, &axis);
            let gap = (other_low - high).max(low - other_high) / length;
            if gap > best {
                best = gap;
            }
            best >= enough
        };
        for face in FACES {
            let [p, q, r, _] = face.map(|node| sub[node]);
            if try_axis(vector_product(&(q - p), &(r - p))) {
                return best;
            }
        }
        for [i, j] in [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]] {
            for k in 0..3 {
                let edge = triangle[(k + 1) % 3] - triangle[k];
                if try_axis(vector_product(&(sub[j] - sub[i]), &edge)) {
                    return best;
                }
            }
        }
        best
    }
}

fn interval(points: &[Vec3], axis: &Vec3) -> (f64, f64) {
    points
        .iter()
        .map(|p| dot(p, axis))
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), x| (l.min(x), h.max(x)))
}

/// How far each lies outside the other: the largest gap at one of its faces.
fn gaps_of_bodies(heights: &[[[f64; 4]; 4]; 2]) -> [f64; 2] {
    each!(2, |t| {
        let beyond =
            |above: &[f64; 4]| -larger(larger(above[0], above[1]), larger(above[2], above[3]));
        heights[t].iter().map(beyond).fold(f64::NEG_INFINITY, larger)
    })
}

/// The larger of two numbers; not a number if the first is none.
#[inline(always)]
fn larger(a: f64, b: f64) -> f64 {
    if b > a { b } else { a }
}

/// Sizes on which the bounds depend.
#[derive(Debug, Clone, Copy)]
struct Scale {
    /// Largest distance of two nodes of the couple, m.
    extent: f64,
    /// Gap that rounding cannot bridge, m.
    bridged: f64,
    /// No bound allows to move further, m.
    most: f64,
}

impl Scale {
    /// None if rounding is too large for any bound.
    fn new(asked: &Asked<'_>) -> Option<Self> {
        let mut low = asked.bodies[0].corners[0];
        let mut high = low;
        for body in asked.bodies {
            for x in &body.corners {
                for k in 0..3 {
                    low[k] = -larger(-low[k], -x[k]);
                    high[k] = larger(high[k], x[k]);
                }
            }
        }
        let extent = dot(&(high - low), &(high - low)).sqrt();
        let (mut flattest, mut smallest) = (f64::INFINITY, f64::INFINITY);
        let mut sine = f64::INFINITY;
        for t in 0..2 {
            let frames = &asked.faces[t].frames;
            let apex = asked.bodies[t].corners[FACES[0][3]] - frames[0].origin;
            let volume = dot(&frames[0].normal, &apex) * frames[0].double_area / 6.0;
            if volume.partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater) {
                return None;
            }
            let areas = each!(4, |f| 0.5 * frames[f].double_area);
            let largest = areas.iter().fold(0.0, |a, &b| larger(a, b));
            smallest = areas.iter().fold(smallest, |a, &b| -larger(-a, -b));
            flattest = -larger(-flattest, -3.0 * volume / largest);
            if t == 0 {
                // 3Ve/(2A₁A₂) for the edge e between two faces of a sub-tetrahedron: a quarter of
                // the volume, edges no shorter than three quarters of the least height
                sine = 0.84 * volume * volume / (largest * largest * largest);
            }
        }
        let scale =
            Self { extent, bridged: BRIDGED * extent * extent / sine, most: flattest / 16.0 };
        let is_exact = HEIGHT_ERROR * extent * extent * extent < smallest;
        (is_exact && scale.bridged >= 0.0 && flattest > 1e-3 * extent).then_some(scale)
    }

    /// How far nodes may move before a gap closes, 0 or less if not at all.
    fn free(&self, gap: f64) -> f64 {
        (0.5 * (gap - self.bridged)).min(self.most)
    }

    /// The gap that [`Self::free`] needs for a distance.
    fn gap_for(&self, free: f64) -> f64 {
        2.0 * free + self.bridged
    }

    /// How far nodes may move before a volume (six times it) may change its sign.
    fn free_of_volume(&self, volume: f64) -> f64 {
        let square = self.extent * self.extent;
        ((volume - NOISE * square * self.extent) / (7.0 * square)).min(self.most)
    }
}
