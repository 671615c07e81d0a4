//! How far the nodes of a separated couple may move before it could matter.
//!
//! A couple whose six edges all lie clear of the other triangle exerts no
//! force, changes no sliding and, while it stays nearer than twice the buffer,
//! keeps its place in the list: it need not be evaluated. Each edge is clear
//! because some twice-areas ("numerators" of area coordinates) have the right
//! sign. When every node moves by at most `b`, a twice-area of points no
//! further apart than `D` changes by at most 4bD + 4b² ≤ 5bD for b ≤ D/4, so
//! that the signs hold for b up to the smallest such numerator over 5D. The
//! same bound on the numerators bounds the distance that decides when the
//! couple is dropped. The result is exact, not approximate: states with and
//! without skipping are equal bit for bit (`tests/skips_are_exact.rs`).
//!
//! A node shared by both triangles lies on the edges that start or end there
//! *identically*, rounding included: the two products of its numerator are
//! equal and opposite. Such numerators stay zero whatever moves.

use super::facing::STRICT;
use crate::{TOLERANCE, mechanics::Vec2};

/// Share of the bound that is used, for the rounding of the accumulated travel.
const SAFETY: f64 = 0.99;
/// What rounding can undo, by D³/2A times the length of an edge: see [`super::facing`]. 28 units of
/// roundoff, twice, for what moves.
const ROUNDING: f64 = 32.0 * f64::EPSILON;
/// Numerators below this share of D² are not trusted to have a sign.
const NOISE: f64 = 1e-9;

/// Displacements of any node up to which something provably holds for a couple.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Clearance {
    /// The couple stays without effect and in the list, m; 0 if it must be looked at every step.
    pub rest: f64,
    /// While no edge has to be cut and the triangles are counter-clockwise, the couple stays in
    /// the list, m.
    pub stay: f64,
}

/// How far the nodes of the couple of two triangles may move.
///
/// `nodes` are the node numbers, `corners` the current positions, of target
/// and contactor. `buffer` is the detection buffer.
#[must_use]
pub fn clearance(nodes: [&[u32; 3]; 2], corners: &[[Vec2; 3]; 2], buffer: f64) -> Clearance {
    Couple::new(nodes, corners).clearance(buffer)
}

/// Edges of target and contactor that face each other.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Faces {
    /// An edge of the target and one of the contactor.
    pub edges: [u8; 2],
    /// How far they may reach into each other, twice an area, m².
    pub limit: f64,
    /// Displacement of any node up to which the corner of each triangle that is not on its edge
    /// stays outside the other's edge, and up to which [`super::facing::face_apart`] tells the
    /// truth, m.
    pub reach: f64,
}

/// The edges of a couple that face each other: of those which show that it has no effect the ones
/// whose triangles' third corners may move furthest. `None` if there are none.
pub(super) fn faces(nodes: [&[u32; 3]; 2], corners: &[[Vec2; 3]; 2]) -> Option<Faces> {
    Couple::new(nodes, corners).faces()
}

/// The number if it is positive, else 0.
fn positive(bound: f64) -> f64 {
    if bound > 0.0 { bound } else { 0.0 }
}

/// Sign of a numerator and how safe it is.
#[derive(Debug, Clone, Copy)]
enum Side {
    /// Identically on the edge.
    On,
    /// Inside by this twice-area (outside if negative).
    Off(f64),
}

impl Side {
    fn slack_outside(self) -> f64 {
        match self {
            Self::On => f64::INFINITY,
            Self::Off(numerator) => -numerator,
        }
    }

    fn slack_inside(self) -> f64 {
        match self {
            Self::On => f64::INFINITY,
            Self::Off(numerator) => numerator,
        }
    }
}

struct Couple<'a> {
    nodes: [&'a [u32; 3]; 2],
    /// Numerator of corner `i` of triangle `t` at edge `e` of the other: `[t][i][e]`.
    sides: [[[Side; 3]; 3]; 2],
    /// Twice the areas.
    areas: [f64; 2],
    /// Squared edge lengths.
    edges: [[f64; 3]; 2],
    /// Diagonal of the box around both triangles.
    extent: f64,
}

impl<'a> Couple<'a> {
    fn new(nodes: [&'a [u32; 3]; 2], corners: &[[Vec2; 3]; 2]) -> Self {
        let twice_area = |from: Vec2, to: Vec2, p: Vec2| {
            (from.x - p.x) * (to.y - from.y) + (from.y - p.y) * (from.x - to.x)
        };
        let side = |t: usize, i: usize, e: usize| {
            let (u, f) = (1 - t, (e + 1) % 3);
            if nodes[t][i] == nodes[u][e] || nodes[t][i] == nodes[u][f] {
                Side::On
            } else {
                Side::Off(twice_area(corners[u][e], corners[u][f], corners[t][i]))
            }
        };
        let all = corners.as_flattened();
        let (mut low, mut high) = (all[0], all[0]);
        for p in all {
            low = low.inf(p);
            high = high.sup(p);
        }
        let mut sides = [[[Side::On; 3]; 3]; 2];
        for t in 0..2 {
            for i in 0..3 {
                for e in 0..3 {
                    sides[t][i][e] = side(t, i, e);
                }
            }
        }
        Self {
            nodes,
            sides,
            areas: [0, 1].map(|t| twice_area(corners[t][0], corners[t][1], corners[t][2])),
            edges: [0, 1].map(|t| {
                [0, 1, 2].map(|e| (corners[t][(e + 1) % 3] - corners[t][e]).norm_squared())
            }),
            extent: (high - low).norm(),
        }
    }

    fn clearance(&self, buffer: f64) -> Clearance {
        let mut slack = self.areas[0].min(self.areas[1]);
        for t in 0..2 {
            for edge in 0..3 {
                slack = slack.min(self.edge_slack(t, edge));
            }
        }
        let holds = self.displacement(slack);
        let stays = self.keeping_distance(buffer);
        let stay = positive(stays.min(self.extent / 4.0));
        Clearance { rest: positive(holds.min(stay)), stay }
    }

    /// Displacement up to which a twice-area with this slack keeps its sign, m.
    fn displacement(&self, slack: f64) -> f64 {
        let noise = NOISE * self.extent * self.extent;
        SAFETY * (slack - noise) / (5.0 * self.extent)
    }

    fn faces(&self) -> Option<Faces> {
        let area = self.areas[0].min(self.areas[1]);
        // areas, lengths and the extent change by a twentieth at most
        let limit = 0.9 * TOLERANCE * area;
        let strict = STRICT * limit;
        let rounding = ROUNDING * self.extent.powi(3) / area;
        let is_faithful = |squared: f64| rounding * squared.sqrt() < strict;
        // a common node lies on the edge, not outside
        let slack = |t: usize, corner: usize, edge: usize| match self.sides[t][corner][edge] {
            Side::On => 0.0,
            Side::Off(numerator) => -numerator,
        };
        let mut best: Option<Faces> = None;
        for e in (0..3).filter(|&e| is_faithful(self.edges[0][e])) {
            for f in (0..3).filter(|&f| is_faithful(self.edges[1][f])) {
                let of_target = slack(1, f, e).min(slack(1, (f + 1) % 3, e));
                let of_contactor = slack(0, e, f).min(slack(0, (e + 1) % 3, f));
                let tells =
                    of_target.max(of_contactor) > strict || of_target.min(of_contactor) > -limit;
                let thirds = slack(0, (e + 2) % 3, f).min(slack(1, (f + 2) % 3, e));
                let shorter = self.edges[0][e].min(self.edges[1][f]).sqrt();
                let reach = self.displacement(thirds.min(area / 20.0)).min(shorter / 40.0);
                if tells && reach > best.map_or(0.0, |best| best.reach) {
                    best = Some(Faces { edges: [e as u8, f as u8], limit, reach });
                }
            }
        }
        best
    }

    /// Slack of the safest reason why an edge lies clear: the other triangle
    /// wholly on one side of it, or both its ends outside one edge of the other.
    fn edge_slack(&self, t: usize, edge: usize) -> f64 {
        let end = (edge + 1) % 3;
        let others = &self.sides[1 - t];
        let least =
            |f: fn(Side) -> f64| (0..3).map(|m| f(others[m][edge])).fold(f64::INFINITY, f64::min);
        let mut best = least(Side::slack_outside).max(least(Side::slack_inside));
        for m in 0..3 {
            let ends = [self.sides[t][edge][m], self.sides[t][end][m]];
            best = best.max(ends[0].slack_outside().min(ends[1].slack_outside()));
        }
        best
    }

    /// Displacement up to which some edge start stays within twice the buffer
    /// of the edge line that it violates most, so that the couple is not dropped.
    fn keeping_distance(&self, buffer: f64) -> f64 {
        let reach = 2.0 * buffer * SAFETY;
        let mut best = 0.0f64;
        for t in 0..2 {
            let shortest = self.edges[1 - t].iter().fold(f64::INFINITY, |a, &b| a.min(b)).sqrt();
            for i in 0..3 {
                if self.nodes[1 - t].contains(&self.nodes[t][i]) {
                    return f64::INFINITY;
                }
                let lowest =
                    self.sides[t][i].iter().fold(f64::INFINITY, |a, s| a.min(s.slack_inside()));
                let room = reach * shortest - lowest.abs();
                best = best.max(SAFETY * room / (5.0 * self.extent + 2.0 * reach));
            }
        }
        best
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        contact::{
            Couple, Motion, Proximity, Shape, SideForces,
            bodies::Bodies,
            facing::{Facing, face_apart},
            overlap,
        },
        lanes::{self, Kernel, LANES, Lanes},
        scene::PairProperties,
    };
    use proptest::prelude::*;

    fn unit(at: Vec2) -> [Vec2; 3] {
        [at, at + Vec2::new(1.0, 0.0), at + Vec2::new(0.0, 1.0)]
    }

    #[test]
    fn separated_triangles_rest_for_part_of_their_gap() {
        let corners = [unit(Vec2::zeros()), unit(Vec2::new(0.0, 1.1))];
        let b = clearance([&[0, 1, 2], &[3, 4, 5]], &corners, 0.2).rest;
        assert!(b > 0.0 && b < 0.05, "{b}");
    }

    #[test]
    fn overlapping_triangles_never_rest() {
        let corners = [unit(Vec2::zeros()), unit(Vec2::new(0.0, 0.9))];
        assert_eq!(clearance([&[0, 1, 2], &[3, 4, 5]], &corners, 0.2).rest, 0.0);
    }

    #[test]
    fn couples_about_to_be_dropped_never_rest() {
        let corners = [unit(Vec2::zeros()), unit(Vec2::new(0.0, 1.1))];
        assert_eq!(clearance([&[0, 1, 2], &[3, 4, 5]], &corners, 0.01).rest, 0.0);
    }

    #[test]
    fn triangles_that_share_an_edge_rest_whatever_the_buffer() {
        let [a, b, c] = unit(Vec2::zeros());
        let d = Vec2::new(1.0, 1.0);
        let b_rest = clearance([&[0, 1, 2], &[2, 1, 3]], &[[a, b, c], [c, b, d]], 0.0).rest;
        assert!(b_rest > 0.1, "{b_rest}");
    }

    /// A number in [-1, 1] from a small integer, so that cases shrink well.
    fn unit_number() -> impl Strategy<Value = f64> {
        (-1000i32..=1000).prop_map(|n| f64::from(n) / 1000.0)
    }

    fn vector() -> impl Strategy<Value = Vec2> {
        (unit_number(), unit_number()).prop_map(|(x, y)| Vec2::new(x, y))
    }

    /// How close two triangles are, their sliding from none, and what they exert.
    fn evaluated(corners: &[[Vec2; 3]; 2], buffer: f64) -> (Proximity, [f64; 6], [SideForces; 2]) {
        let shapes = corners.map(Shape::new);
        let motion = Motion::new([Vec2::new(1.0, 2.0); 3]);
        let couple = Couple {
            shapes: [&shapes[0], &shapes[1]],
            motions: [&motion; 2],
            pair: &PairProperties { penalty: 1e9, tangential_penalty: 1e8, friction: 0.5 },
            dt: 1e-3,
            drop_distance_squared: 4.0 * buffer * buffer,
        };
        let (mut sliding, mut sides) = ([0.0; 6], [SideForces::default(); 2]);
        let proximity = overlap(&couple, &mut { couple.pair }, &mut sliding, &mut sides);
        (proximity, sliding, sides)
    }

    /// Whether these edges of two triangles show that the couple has no effect.
    struct Apart<'a>(&'a [[Vec2; 3]; 2], Faces);

    impl Kernel for Apart<'_> {
        type Output = bool;

        #[inline(always)]
        fn run<L: Lanes>(self) -> bool {
            let places = self.0.as_flattened();
            let bodies = Bodies::of(vec![[0, 1, 2], [3, 4, 5]], places);
            let couple = Facing::between([0, 1]).with_edges(self.1.edges);
            face_apart(&bodies, &[couple; LANES], L::splat(self.1.limit)) != 0
        }
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(20_000))]

        /// Whatever the nodes do within the clearance: no force, no sliding, and
        /// the couple keeps its place in the list.
        #[test]
        fn nothing_happens_within_the_clearance(
            corners in [vector(), vector(), vector(), vector(), vector(), vector()],
            moves in [vector(), vector(), vector(), vector(), vector(), vector()],
            apart in vector(),
            shared in 0usize..3,
            buffer in 0.0f64..1.0,
        ) {
            // up to two nodes of the contactor are nodes of the target
            let mut ids = [0u32, 1, 2, 3, 4, 5];
            for k in 0..shared {
                ids[5 - k] = k as u32;
            }
            let area = |c: &[Vec2; 3]| (c[1] - c[0]).perp(&(c[2] - c[0]));
            let mut nodes = [[ids[0], ids[1], ids[2]], [ids[3], ids[4], ids[5]]];
            let at = |nodes: &[[u32; 3]; 2], displacement: f64| -> [[Vec2; 3]; 2] {
                let node = |n: u32| {
                    let n = n as usize;
                    let base = if n > 2 { corners[n] + 1.5 * apart } else { corners[n] };
                    // a unit move is at most √2 long
                    base + moves[n] * (displacement / std::f64::consts::SQRT_2)
                };
                nodes.map(|corners| corners.map(node))
            };
            for t in 0..2 {
                if area(&at(&nodes, 0.0)[t]) < 0.0 {
                    nodes[t].swap(1, 2);
                }
            }
            let still = at(&nodes, 0.0);
            prop_assume!(area(&still[0]) > 1e-3 && area(&still[1]) > 1e-3);
            let Clearance { rest: free, stay } =
                clearance([&nodes[0], &nodes[1]], &still, buffer);
            prop_assert!(stay >= free);
            if let Some(facing) = faces([&nodes[0], &nodes[1]], &still) {
                prop_assert!(lanes::run(Apart(&still, facing)));
                for share in [0.0, 1e-9, 1e-3, 0.5, 1.0] {
                    let moved = at(&nodes, share * facing.reach);
                    if lanes::run(Apart(&moved, facing)) {
                        let (_, sliding, sides) = evaluated(&moved, buffer);
                        prop_assert_eq!(sliding, [0.0; 6]);
                        prop_assert!(!sides[0].acts && !sides[1].acts);
                    }
                }
            }
            let moved = at(&nodes, stay);
            if stay > 0.0 && area(&moved[0]) > 0.0 && area(&moved[1]) > 0.0 {
                prop_assert!(evaluated(&moved, buffer).0 != Proximity::Beyond);
            }
            let (proximity, sliding, sides) = evaluated(&at(&nodes, free), buffer);
            if free > 0.0 {
                prop_assert_eq!(proximity, Proximity::Clear);
                prop_assert_eq!(sliding, [0.0; 6]);
                prop_assert!(!sides[0].acts && !sides[1].acts);
            }
        }
    }
}
