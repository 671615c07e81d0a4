//! The edges of a couple's triangles that face each other, and whether they alone show that the
//! couple has no effect, four couples at a time.
//!
//! Of the corners, those of the facing edges are looked at in every step. The third corner of each
//! triangle is further off: it stays outside the other's facing edge while no node moves further
//! than a bound that is known ([`super::clearance::Faces`]). Then a couple has no effect
//!
//! - if each triangle lies outside the facing edge of the other, up to what the area coordinates'
//!   tolerance allows: every edge of either lies clear then ([`super::certain`]);
//! - if one triangle lies outside the facing edge of the other by more than rounding can undo. All
//!   edges of the first lie clear then. Of an edge of the other no piece is found inside. Say that the
//!   corners of the first are outside by twice-areas from μ to W. Every point of the edge has an area
//!   coordinate below -μ/2W then, as the coordinates weighted with those twice-areas sum up to
//!   nothing above zero. Coordinates and the parameters at which pieces begin and end are wrong by
//!   14 u D²/2A at most, with the unit roundoff u, the extent D of the couple and the area A; W is at
//!   most D times the length of the edge.
//!
//! The twice-areas are those of [`super::certain`], rounding included.

use super::bodies::Bodies;
use crate::lanes::{LANES, Lanes, Mask, each};

/// Share of the limit by which a triangle must lie outside the other if that alone is to prove that
/// the couple has no effect.
pub(super) const STRICT: f64 = 0.01;

/// Places for the edges of a body.
const PLACES: u32 = 4;

/// Which triangles are a couple, and which of their edges face each other: places of the edges of
/// target and contactor among those of all bodies.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(super) struct Facing([u32; 2]);

impl Facing {
    /// The couple of target and contactor at these places among the bodies; their first edges face
    /// each other.
    pub fn between(bodies: [u32; 2]) -> Self {
        Self(bodies.map(|place| place * PLACES))
    }

    /// Places of target and contactor among the bodies.
    #[inline(always)]
    pub fn bodies(self) -> [u32; 2] {
        each!(2, |t| self.0[t] / PLACES)
    }

    /// The same couple with these edges facing each other, each less than 3.
    pub fn with_edges(self, edges: [u8; 2]) -> Self {
        Self([0, 1].map(|t| self.0[t] / PLACES * PLACES + u32::from(edges[t].min(2))))
    }

    /// The edges as a number.
    pub fn edge_bits(self) -> u8 {
        (((self.0[0] % PLACES) << 2) | (self.0[1] % PLACES)) as u8
    }

    /// The same couple with the edges of such a number.
    pub fn with_edge_bits(self, bits: u8) -> Self {
        self.with_edges([bits >> 2 & 3, bits & 3])
    }
}

/// Bits of the couples whose facing edges show that they have no effect, if the third corners are
/// outside. By the `limit` at most they may reach into each other, twice an area, m².
#[inline(always)]
pub(super) fn face_apart<L: Lanes>(bodies: &Bodies, couples: &[Facing; LANES], limit: L) -> u32 {
    let edges = bodies.edges();
    let [[x0, y0, x1, y1], [u0, v0, u1, v1]] =
        each!(2, |t| L::transpose(each!(4, |k| L::load(edges.at(couples[k].0[t])))));
    let of_target = inside([x0, y0, x1, y1], [[u0, v0], [u1, v1]]);
    let of_contactor = inside([u0, v0, u1, v1], [[x0, y0], [x1, y1]]);
    let loosely = of_target.larger(of_contactor).lt(limit);
    let strictly = of_target.smaller(of_contactor).lt(limit * L::splat(-STRICT));
    (loosely | strictly).bits()
}

/// How far the ends of an edge lie inside another edge at most, twice an area.
#[inline(always)]
fn inside<L: Lanes>([x0, y0, x1, y1]: [L; 4], ends: [[L; 2]; 2]) -> L {
    let [nx, ny] = [y1 - y0, x0 - x1];
    let [start, end] = each!(2, |i| (x0 - ends[i][0]) * nx + (y0 - ends[i][1]) * ny);
    start.larger(end)
}
