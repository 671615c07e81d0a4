//! What the triangles of couples exert on each other, four couples at a time.

use super::{
    bodies::{Triangles, of_corners},
    edges::{Edges, Ends, Integrals, Pairs},
    evaluation::Step,
    facing::Facing,
    locate::{Located, locate},
    sliding::SlidingRow,
    visits::Traits,
};
use crate::{
    lanes::{LANES, Lanes, Mask, each},
    mechanics::Vec2,
};

/// Corners of a couple: those of the target, then those of the contactor. Edge `c` goes from
/// corner `c` to the next one.
pub(super) const CORNERS: usize = 6;

/// Corners that a table has place for: a power of two, so that places need no check.
const PLACES: usize = 8;

/// The corner after each corner on its triangle.
const NEXT: [usize; PLACES] = [1, 2, 0, 4, 5, 3, 0, 0];

/// All bits of [`Exertion::acts`].
const BOTH_SIDES: u32 = 0b11;

/// Forces between the triangles of a couple.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Exertion {
    /// Places of the triangles among the bodies.
    bodies: [u32; 2],
    shares_node: bool,
    /// Bit `t`: whether the edges of triangle `t` exert anything.
    acts: u32,
    /// Entry `t`: what acts on the edges of triangle `t`.
    sides: [SideExertion; 2],
    /// Sliding after the step.
    sliding: SlidingRow,
}

/// Forces by what acts on the edges of one triangle.
#[derive(Debug, Clone, Copy, Default)]
struct SideExertion {
    /// On its corners, N.
    own: [[f64; 2]; 3],
    /// What is subtracted from the force on corner `i` of the other triangle for corner `m`, N:
    /// entry `[i][m]`.
    borne: [[[f64; 2]; 3]; 3],
}

impl Exertion {
    /// Sliding after the step if the triangles exert anything.
    #[inline(always)]
    pub fn sliding(&self) -> Option<&SlidingRow> {
        (self.acts != 0).then_some(&self.sliding)
    }

    /// Adds the forces to those of the nodes, in the original's order: side by side, corner by
    /// corner.
    #[inline(always)]
    pub fn scatter(&self, step: &Step<'_>, forces: &mut [Vec2]) {
        let nodes = step.nodes_of(self.bodies);
        if self.acts == BOTH_SIDES && !self.shares_node {
            // each node once
            let [first, second] = &self.sides;
            for i in 0..3 {
                let force = &mut forces[nodes[0][i] as usize].data.0[0];
                *force = second.bear(i, add(*force, first.own[i]));
                let force = &mut forces[nodes[1][i] as usize].data.0[0];
                *force = add(first.bear(i, *force), second.own[i]);
            }
            return;
        }
        for (t, side) in self.sides.iter().enumerate() {
            if self.acts >> t & 1 == 0 {
                continue;
            }
            for i in 0..3 {
                let force = &mut forces[nodes[t][i] as usize].data.0[0];
                *force = add(*force, side.own[i]);
                let force = &mut forces[nodes[1 - t][i] as usize].data.0[0];
                *force = side.bear(i, *force);
            }
        }
    }
}

impl SideExertion {
    /// The force on corner `i` of the other triangle with what it bears.
    #[inline(always)]
    fn bear(&self, i: usize, force: [f64; 2]) -> [f64; 2] {
        let [first, second, third] = self.borne[i];
        subtract(subtract(subtract(force, first), second), third)
    }
}

#[inline(always)]
fn add(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] + b[0], a[1] + b[1]]
}

#[inline(always)]
fn subtract(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

/// Four couples to evaluate; behind the first `count` lanes come repetitions of the first.
#[derive(Clone, Copy)]
pub(super) struct Quartet<'a> {
    pub couples: [Facing; LANES],
    pub traits: [Traits; LANES],
    /// Sliding before the step.
    pub sliding: [&'a SlidingRow; LANES],
    pub count: usize,
}

/// What is known of the corners and edges of four couples, one couple per lane.
pub(super) struct Bench<L> {
    integrals: [Integrals<L>; PLACES],
    /// Velocities of the corners, m/s.
    velocity: [[L; 2]; PLACES],
    /// Outward normals of the edges, as long as the edges, m.
    normals: [[L; 2]; PLACES],
    /// Forces on the corners by what acts on the edges of their triangle, N.
    own: [[L; 2]; PLACES],
}

impl<L: Lanes> Bench<L> {
    /// With nothing known.
    #[inline(always)]
    pub fn new() -> Self {
        let zero = L::splat(0.0);
        let nothing = [[zero; 2]; PLACES];
        Self {
            integrals: [Integrals::all(zero); PLACES],
            velocity: nothing,
            normals: nothing,
            own: nothing,
        }
    }
}

impl Quartet<'_> {
    /// Evaluates the couples: writes what each exerts and how far it has slid to its place in `out`. The result has for each a bit for every edge that had to be cut; those without one
    /// exert nothing.
    ///
    /// What depends on each other in an edge takes long: the integrals of all edges come first,
    /// then their forces, so that edges overlap in time.
    #[inline(always)]
    pub fn exert<L: Lanes>(
        &self,
        step: &Step<'_>,
        bench: &mut Bench<L>,
        places: [usize; LANES],
        out: &mut [Exertion],
    ) -> [u8; LANES] {
        let Bench { integrals, velocity, normals, own } = bench;
        let bodies = each!(4, |k| step.bodies_of(self.couples[k]));
        let triangles = [
            Triangles::<L>::new(each!(4, |k| bodies[k][0])),
            Triangles::new(each!(4, |k| bodies[k][1])),
        ];
        let Located { points, cut } = locate(&triangles[0], &triangles[1]);
        let mut slots = 0;
        let mut by_edge = 0;
        for corner in 0..CORNERS {
            let bits = cut[corner].bits();
            slots |= u32::from(bits != 0) << corner;
            by_edge |= bits << (LANES * corner);
        }
        let edges = each!(4, |k| edges_of_lane(by_edge, k));
        if slots == 0 {
            for k in 0..self.count {
                out[places[k]].acts = 0;
            }
            return edges;
        }
        let zero = L::splat(0.0);
        let mut left = slots;
        while left != 0 {
            let corner = left.trailing_zeros() as usize % PLACES;
            left &= left - 1;
            let ends = Ends { start: points[corner], end: points[NEXT[corner]] };
            integrals[corner] = ends.integrals(cut[corner]);
        }
        let nodes = each!(4, |k| step.nodes_of(self.couples[k].bodies()));
        for t in 0..2 {
            let velocities = of_corners(step.velocities, each!(4, |k| nodes[k][t]));
            for i in 0..3 {
                velocity[3 * t + i] = velocities[i];
                normals[3 * t + i] = triangles[t].normal(i);
                own[3 * t + i] = [zero; 2];
            }
        }
        let pair = self.pair(step);
        let mut sliding = self.sliding::<L>();
        let never = zero.lt(zero);
        let mut acts = [never; 2];
        let mut left = slots;
        while left != 0 {
            let corner = left.trailing_zeros() as usize % PLACES;
            left &= left - 1;
            let next = NEXT[corner];
            let (side, other) = if corner < 3 { (0, 3) } else { (1, 0) };
            let here = cut[corner] & integrals[corner].is_inside();
            let edges = Edges {
                ends: Ends { start: points[corner], end: points[next] },
                normal: normals[corner],
                velocity: [velocity[corner], velocity[next]],
                other_velocity: [velocity[other], velocity[other + 1], velocity[other + 2]],
                sliding: sliding[corner],
                pair: &pair,
            };
            let forces = edges.forces(here, &integrals[corner], step.dt);
            sliding[corner] = L::select(here, forces.sliding, sliding[corner]);
            acts[side] = acts[side] | here;
            let [x, y] = normals[corner];
            for (end, at) in [corner, next].into_iter().enumerate() {
                // Zero force leaves a sum that began with zero as it is. Selecting sums instead
                // would become masked stores, which some machines do very slowly.
                let n = L::select(here, forces.normal[end], zero);
                let s = L::select(here, forces.tangential[end], zero);
                let [fx, fy] = own[at];
                own[at] = [fx - n * x - s * y, fy - n * y + s * x];
            }
        }
        for k in 0..LANES {
            let exertion = &mut out[places[k]];
            exertion.bodies = self.couples[k].bodies();
            exertion.shares_node = self.traits[k].shares_node();
            exertion.acts = (acts[0].bits() >> k & 1) | (acts[1].bits() >> k & 1) << 1;
        }
        write_side(0, own, &points, places, out);
        write_side(1, own, &points, places, out);
        write_sliding(&sliding, places, out);
        edges
    }

    /// Contact properties.
    #[inline(always)]
    fn pair<L: Lanes>(&self, step: &Step<'_>) -> Pairs<L> {
        let pairs = each!(4, |k| self.traits[k].pair());
        if pairs == [pairs[0]; LANES] {
            let pair = step.pairs.properties(pairs[0]);
            return Pairs {
                penalty: L::splat(pair.penalty),
                tangential_penalty: L::splat(pair.tangential_penalty),
                friction: L::splat(pair.friction),
            };
        }
        let of = each!(4, |k| step.pairs.properties(pairs[k]));
        Pairs {
            penalty: L::new(each!(4, |k| of[k].penalty)),
            tangential_penalty: L::new(each!(4, |k| of[k].tangential_penalty)),
            friction: L::new(each!(4, |k| of[k].friction)),
        }
    }

    /// Sliding of the six edges.
    #[inline(always)]
    fn sliding<L: Lanes>(&self) -> [L; PLACES] {
        let rows = self.sliding;
        let [a, b, c, d] = L::transpose(each!(4, |k| L::load(first(rows[k]))));
        let [_, _, e, f] = L::transpose(each!(4, |k| L::load(last(rows[k]))));
        let zero = L::splat(0.0);
        [a, b, c, d, e, f, zero, zero]
    }
}

/// Writes the sliding of the six edges.
#[inline(always)]
fn write_sliding<L: Lanes>(sliding: &[L; PLACES], places: [usize; LANES], out: &mut [Exertion]) {
    let &[a, b, c, d, e, f, ..] = sliding;
    let starts = L::transpose([a, b, c, d]);
    let ends = L::transpose([c, d, e, f]);
    for k in 0..LANES {
        let row = &mut out[places[k]].sliding;
        starts[k].store(&mut row.as_chunks_mut().0[0]);
        ends[k].store(&mut row[2..].as_chunks_mut().0[0]);
    }
}

/// The edges of lane `k` out of bits that are sorted by edge, then lane.
#[inline(always)]
fn edges_of_lane(by_edge: u32, k: usize) -> u8 {
    // bits 0, 4, 8, 12, 16, 20 move to 0, 1, 8, 9, 16, 17, then to 0 to 5
    let bits = by_edge >> k & 0x11_1111;
    let pairs = (bits | bits >> 3) & 0x03_0303;
    (pairs | pairs >> 6 | pairs >> 12) as u8 & 0x3F
}

/// Writes the forces on the corners of triangle `t` and what the other one bears of them.
#[inline(always)]
fn write_side<L: Lanes>(
    t: usize,
    own: &[[L; 2]; PLACES],
    points: &[[L; 3]; PLACES],
    places: [usize; LANES],
    out: &mut [Exertion],
) {
    for i in 0..3 {
        let [x, y] = own[3 * t + i];
        let pairs = L::unpair(x, y);
        for k in 0..LANES {
            out[places[k]].sides[t].own[i] = pairs[k];
        }
        for m in 0..3 {
            let [x, y] = own[3 * t + m];
            let share = points[3 * t + m][(i + 1) % 3];
            let pairs = L::unpair(x * share, y * share);
            for k in 0..LANES {
                out[places[k]].sides[t].borne[i][m] = pairs[k];
            }
        }
    }
}

#[inline(always)]
fn first(row: &[f64; 6]) -> &[f64; LANES] {
    &row.as_chunks().0[0]
}

#[inline(always)]
fn last(row: &[f64; 6]) -> &[f64; LANES] {
    &row[2..].as_chunks().0[0]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        contact::{
            Couple, Motion, Proximity, SideForces, bodies::Bodies, certain::certainly_clear,
            clearance::faces, facing::face_apart, friction::PairTable, overlap,
        },
        lanes::{self, Kernel},
        scene::PairProperties,
    };
    use proptest::prelude::*;

    const PAIR: PairProperties =
        PairProperties { penalty: 3e9, tangential_penalty: 4e8, friction: 0.3 };

    /// Four couples of triangles 2k and 2k + 1, and all that a step knows of them.
    #[derive(Debug, Clone)]
    struct Scene {
        corners: Vec<[u32; 3]>,
        places: Vec<Vec2>,
        velocities: Vec<Vec2>,
        sliding: [[f64; 6]; LANES],
    }

    /// What comes of a step, as bits.
    #[derive(Debug, Clone, PartialEq)]
    struct Outcome {
        touching: u32,
        forces: Vec<[u64; 2]>,
        sliding: Vec<[u64; 6]>,
    }

    impl Scene {
        fn couples(&self) -> [[u32; 2]; LANES] {
            [0, 1, 2, 3].map(|k| [2 * k, 2 * k + 1])
        }

        fn outcome(&self, touching: u32, forces: &[Vec2], sliding: &[[f64; 6]]) -> Outcome {
            Outcome {
                touching,
                forces: forces.iter().map(|f| [f.x.to_bits(), f.y.to_bits()]).collect(),
                sliding: sliding.iter().map(|s| s.map(f64::to_bits)).collect(),
            }
        }

        /// Couple after couple with scalar code.
        fn one_by_one(&self) -> Outcome {
            let bodies = Bodies::of(self.corners.clone(), &self.places);
            let shapes: Vec<_> = bodies.bodies.iter().map(|b| b.shape()).collect();
            let motion = |c: &[u32; 3]| Motion::new(c.map(|n| self.velocities[n as usize]));
            let motions: Vec<_> = self.corners.iter().map(motion).collect();
            let mut forces = vec![Vec2::zeros(); self.places.len()];
            let mut sliding = self.sliding;
            let mut touching = 0;
            for (k, [t, c]) in self.couples().into_iter().enumerate() {
                let [t, c] = [t as usize, c as usize];
                let couple = Couple {
                    shapes: [&shapes[t], &shapes[c]],
                    motions: [&motions[t], &motions[c]],
                    pair: &PAIR,
                    dt: 1e-3,
                    drop_distance_squared: 0.01,
                };
                let mut sides = [SideForces::default(); 2];
                let near = overlap(&couple, &mut { couple.pair }, &mut sliding[k], &mut sides);
                if near == Proximity::Near {
                    touching |= 1 << k;
                    sides[0].scatter(&self.corners[t], &self.corners[c], &mut forces);
                    sides[1].scatter(&self.corners[c], &self.corners[t], &mut forces);
                }
            }
            self.outcome(touching, &forces, &sliding)
        }
    }

    /// All four couples at once; also the lanes that are certainly clear.
    struct AtOnce<'a>(&'a Scene);

    impl Kernel for AtOnce<'_> {
        type Output = (Outcome, u32);

        #[inline(always)]
        fn run<L: Lanes>(self) -> (Outcome, u32) {
            let scene = self.0;
            let bodies = Bodies::of(scene.corners.clone(), &scene.places);
            let pairs = PairTable::of_one(PAIR);
            let step = Step {
                bodies: &bodies,
                velocities: &scene.velocities,
                pairs: &pairs,
                dt: 1e-3,
                buffer: 0.05,
                path: 0.0,
                advance: 0.0,
                rests: true,
                evaluation: 0,
            };
            let participants = scene.couples();
            let traits = participants.map(|[t, c]| {
                let others = &scene.corners[t as usize];
                let shares = scene.corners[c as usize].iter().any(|node| others.contains(node));
                Traits::new(0, shares, true)
            });
            let couples = participants.map(Facing::between);
            let quartet =
                Quartet { couples, traits, sliding: scene.sliding.each_ref(), count: LANES };
            let mut out = [Exertion::default(); LANES];
            let mut bench = Bench::<L>::new();
            let places = [2, 0, 3, 1];
            let edges = quartet.exert(&step, &mut bench, places, &mut out);
            let mut forces = vec![Vec2::zeros(); scene.places.len()];
            let exertions = places.map(|place| out[place]);
            for exertion in exertions {
                exertion.scatter(&step, &mut forces);
            }
            let touching = (0..LANES).map(|k| u32::from(edges[k] != 0) << k).sum();
            let sliding: Vec<_> = exertions
                .iter()
                .zip(scene.sliding)
                .map(|(exertion, before)| *exertion.sliding().unwrap_or(&before))
                .collect();
            let of = |t: usize| Triangles::<L>::new(each!(4, |k| step.bodies_of(couples[k])[t]));
            let clear = certainly_clear(&of(0), &of(1)).bits();
            // where facing edges tell that a couple has no effect, it has none
            let found = couples.map(|couple| {
                let corners = step.bodies_of(couple).map(|body| body.corners());
                faces(step.nodes_of(couple.bodies()), &corners)
            });
            let facing = each!(4, |k| found[k]
                .map_or(couples[k], |faces| couples[k].with_edges(faces.edges)));
            let limit = L::new(found.map(|found| found.map_or(0.0, |faces| faces.limit)));
            let apart = face_apart(&bodies, &facing, limit);
            for k in 0..LANES {
                if found[k].is_some() {
                    assert_ne!(apart & 1 << k, 0);
                    assert_eq!(exertions[k].acts, 0);
                }
            }
            (scene.outcome(touching, &forces, &sliding), clear)
        }
    }

    fn vector() -> impl Strategy<Value = Vec2> {
        ((-1000i32..=1000), (-1000i32..=1000))
            .prop_map(|(x, y)| Vec2::new(f64::from(x), f64::from(y)) / 1000.0)
    }

    /// Two triangles: apart, overlapping, one in the other, with common nodes, or with an edge
    /// or a corner of both in the same place up to a tiny gap.
    fn couple() -> impl Strategy<Value = ([Vec2; 6], [u32; 6])> {
        let gap = prop_oneof![
            Just(0.0),
            Just(1e-12),
            Just(-1e-12),
            Just(1e-9),
            Just(-1e-9),
            Just(1e-6),
            Just(-1e-6)
        ];
        (prop::array::uniform6(vector()), vector(), 0..3u32, 0..3u32, gap).prop_map(
            |(mut places, apart, shared, bonded, gap)| {
                for place in &mut places[3..] {
                    *place += 1.2 * apart;
                }
                let mut nodes = [0, 1, 2, 3, 4, 5];
                for k in 0..shared {
                    nodes[5 - k as usize] = k;
                    places[5 - k as usize] = places[k as usize];
                }
                for k in 0..bonded as usize {
                    places[5 - k] = places[k] + Vec2::new(gap, -0.5 * gap);
                }
                for t in [0, 3] {
                    let (a, b) = (places[t + 1] - places[t], places[t + 2] - places[t]);
                    if a.x * b.y - a.y * b.x < 0.0 {
                        places.swap(t + 1, t + 2);
                        nodes.swap(t + 1, t + 2);
                    }
                }
                (places, nodes)
            },
        )
    }

    fn scene() -> impl Strategy<Value = Scene> {
        let couples = prop::array::uniform4((
            couple(),
            prop::array::uniform6(vector()),
            prop::array::uniform6(-1e-3..1e-3),
        ));
        couples.prop_map(|couples| {
            let mut scene = Scene {
                corners: Vec::new(),
                places: vec![Vec2::zeros(); 24],
                velocities: vec![Vec2::zeros(); 24],
                sliding: [[0.0; 6]; LANES],
            };
            for (k, ((places, nodes), velocities, sliding)) in couples.into_iter().enumerate() {
                let nodes = nodes.map(|n| n + 6 * k as u32);
                for i in 0..6 {
                    scene.places[nodes[i] as usize] = places[i];
                    scene.velocities[nodes[i] as usize] = velocities[i];
                }
                scene
                    .corners
                    .extend([[nodes[0], nodes[1], nodes[2]], [nodes[3], nodes[4], nodes[5]]]);
                scene.sliding[k] = sliding;
            }
            scene
        })
    }

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(5_000))]

        /// Forces and sliding have the bits of the scalar code, and what is certainly clear is
        /// clear.
        #[test]
        fn four_couples_at_once_have_the_bits_of_one_by_one(scene in scene()) {
            let expected = scene.one_by_one();
            let (at_once, clear) = lanes::run(AtOnce(&scene));
            prop_assert_eq!(&at_once, &expected);
            prop_assert_eq!(clear & expected.touching, 0);
            let (portable, clear_portable) = lanes::run_portable(AtOnce(&scene));
            prop_assert_eq!(&portable, &expected);
            prop_assert_eq!(clear, clear_portable);
        }
    }
}
