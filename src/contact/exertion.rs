//! What the triangles of couples exert on each other, four couples at a time.

use super::{
    bodies::Triangles,
    edges::Edges,
    evaluation::{Step, Touch},
    locate::{Coordinates, locate},
    visits::Visit,
};
use crate::{
    lanes::{LANES, Lanes, Mask, each},
    mechanics::Vec2,
};

/// Forces between the triangles of a couple.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Exertion {
    /// Entry `t`: what acts on the edges of triangle `t`.
    sides: [SideExertion; 2],
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
    /// Adds the forces to those of the nodes of target and contactor, in the original's order,
    /// which matters where the two triangles share a node.
    #[inline(always)]
    pub fn scatter(&self, nodes: [&[u32; 3]; 2], forces: &mut [Vec2]) {
        for (t, side) in self.sides.iter().enumerate() {
            for i in 0..3 {
                let force = &mut forces[nodes[t][i] as usize].data.0[0];
                *force = add(*force, side.own[i]);
                let force = &mut forces[nodes[1 - t][i] as usize].data.0[0];
                let [first, second, third] = side.borne[i];
                *force = subtract(subtract(subtract(*force, first), second), third);
            }
        }
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

/// Four couples to evaluate; behind the first `count` lanes come repetitions.
#[derive(Clone, Copy)]
pub(super) struct Quartet {
    /// Their places in the list.
    pub couples: [usize; LANES],
    pub participants: [[u32; 2]; LANES],
    pub count: usize,
}

impl Quartet {
    /// Evaluates the couples: updates their sliding and writes what they exert one after the
    /// other. The result has a bit for each that has an edge to cut; the others exert nothing and
    /// leave no entry.
    #[inline(always)]
    pub fn exert<L: Lanes>(
        &self,
        step: &Step<'_>,
        visits: &mut [Visit],
        out: &mut [Touch; LANES],
    ) -> u32 {
        let bodies = each!(4, |k| step.bodies_of(self.participants[k]));
        let triangles = [
            Triangles::<L>::new(each!(4, |k| bodies[k][0])),
            Triangles::new(each!(4, |k| bodies[k][1])),
        ];
        let (coordinates, cut) = locate(&triangles[0], &triangles[1]);
        let valid = (1 << self.count) - 1;
        let mut touching = 0;
        for t in 0..2 {
            for i in 0..3 {
                touching |= cut[t][i].bits();
            }
        }
        touching &= valid;
        if touching == 0 {
            return 0;
        }
        // place of each lane's entry; those without one are overwritten by the next
        let place = each!(4, |k| (touching & ((1 << k) - 1)).count_ones() as usize);
        for k in 0..LANES {
            out[place[k]].participants = self.participants[k];
        }
        let nodes = each!(4, |k| step.nodes_of(self.participants[k]));
        let velocity =
            each!(2, |t| each!(3, |i| L::pairs(each!(4, |k| step.velocity(nodes[k][t][i])))));
        let [penalty, tangential_penalty, friction] = self.properties::<L>(step, visits);
        let mut sliding = self.sliding::<L>(visits);
        let zero = L::splat(0.0);
        for t in 0..2 {
            let mut own = [[zero; 2]; 3];
            let mut acts = zero.lt(zero);
            let side = Side {
                coordinates: &coordinates[t],
                velocity: &velocity[t],
                other_velocity: &velocity[1 - t],
                penalty,
                tangential_penalty,
                friction,
                dt: step.dt,
            };
            // written out, so that forces and sliding stay in registers
            each!(3, |i| {
                if cut[t][i].any() {
                    let normal = triangles[t].normal(i);
                    let slid = sliding[t][i];
                    let (here, slid, own_i, own_j) =
                        side.cut(i, cut[t][i], normal, slid, own[i], own[NEXT[i]]);
                    acts = acts | here;
                    sliding[t][i] = slid;
                    own[i] = own_i;
                    own[NEXT[i]] = own_j;
                }
            });
            write_side(t, &own, acts, &coordinates, place, out);
        }
        self.keep_sliding(sliding, visits);
        touching
    }

    /// Contact penalties, tangential penalties and friction.
    #[inline(always)]
    fn properties<L: Lanes>(&self, step: &Step<'_>, visits: &[Visit]) -> [L; 3] {
        let pairs = each!(4, |k| visits[self.couples[k]].pair);
        let of = each!(4, |k| step.pairs.properties(pairs[k]));
        [
            L::new(each!(4, |k| of[k].penalty)),
            L::new(each!(4, |k| of[k].tangential_penalty)),
            L::new(each!(4, |k| of[k].friction)),
        ]
    }

    /// Sliding of the six edges.
    #[inline(always)]
    fn sliding<L: Lanes>(&self, visits: &[Visit]) -> [[L; 3]; 2] {
        let rows = each!(4, |k| &visits[self.couples[k]].sliding);
        let [a, b, c, d] = L::transpose(each!(4, |k| L::load(first(rows[k]))));
        let [_, _, e, f] = L::transpose(each!(4, |k| L::load(last(rows[k]))));
        [[a, b, c], [d, e, f]]
    }

    /// Takes over the sliding of the six edges.
    #[inline(always)]
    fn keep_sliding<L: Lanes>(&self, [[a, b, c], [d, e, f]]: [[L; 3]; 2], visits: &mut [Visit]) {
        let starts = L::transpose([a, b, c, d]);
        let ends = L::transpose([c, d, e, f]);
        for k in 0..self.count {
            let sliding = &mut visits[self.couples[k]].sliding;
            let (start, end) = (starts[k].array(), ends[k].array());
            *sliding = [start[0], start[1], start[2], start[3], end[2], end[3]];
        }
    }
}

/// Where the edges of one triangle are cut.
struct Side<'a, L> {
    coordinates: &'a [[L; 3]; 3],
    velocity: &'a [[L; 2]; 3],
    other_velocity: &'a [[L; 2]; 3],
    penalty: L,
    tangential_penalty: L,
    friction: L,
    dt: f64,
}

impl<L: Lanes> Side<'_, L> {
    /// Cuts edge `i` of the lanes `cut`. Gives the lanes in which it exerts something, its
    /// sliding, and the forces on its start and its end, which begin with those given.
    #[inline(always)]
    fn cut(
        &self,
        i: usize,
        cut: L::Mask,
        normal: [L; 2],
        sliding: L,
        at_start: [L; 2],
        at_end: [L; 2],
    ) -> (L::Mask, L, [L; 2], [L; 2]) {
        let j = NEXT[i];
        let edges = Edges {
            start: each!(3, |e| self.coordinates[e][i]),
            end: each!(3, |e| self.coordinates[e][j]),
            normal,
            velocity: [self.velocity[i], self.velocity[j]],
            other_velocity: *self.other_velocity,
            sliding,
            penalty: self.penalty,
            tangential_penalty: self.tangential_penalty,
            friction: self.friction,
        };
        let forces = edges.forces(self.dt);
        let here = forces.acts & cut;
        let [x, y] = normal;
        let before = [at_start, at_end];
        let [at_start, at_end] = each!(2, |end| {
            let (n, s) = (forces.normal[end], forces.tangential[end]);
            let [fx, fy] = before[end];
            [L::select(here, fx - n * x - s * y, fx), L::select(here, fy - n * y + s * x, fy)]
        });
        (here, L::select(here, forces.sliding, sliding), at_start, at_end)
    }
}

/// The corner after each corner.
const NEXT: [usize; 3] = [1, 2, 0];

/// Writes the forces on the corners of triangle `t` and what the other one bears of them.
#[inline(always)]
fn write_side<L: Lanes>(
    t: usize,
    own: &[[L; 2]; 3],
    acts: L::Mask,
    coordinates: &Coordinates<L>,
    place: [usize; LANES],
    out: &mut [Touch; LANES],
) {
    let zero = L::splat(0.0);
    for i in 0..3 {
        let pairs = L::unpair(own[i][0], own[i][1]);
        for k in 0..LANES {
            out[place[k]].exertion.sides[t].own[i] = pairs[k];
        }
        for m in 0..3 {
            // what does not act exerts nothing, even if a coordinate is no number
            let share = L::select(acts, coordinates[t][(i + 1) % 3][m], zero);
            let pairs = L::unpair(own[m][0] * share, own[m][1] * share);
            for k in 0..LANES {
                out[place[k]].exertion.sides[t].borne[i][m] = pairs[k];
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
            friction::PairTable, overlap,
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
                evaluation: 0.0,
            };
            let participants = scene.couples();
            let mut visits: Vec<Visit> = participants
                .iter()
                .zip(scene.sliding)
                .map(|(&participants, sliding)| Visit::between(participants, sliding))
                .collect();
            let quartet = Quartet { couples: [0, 1, 2, 3], participants, count: LANES };
            let mut out = [Touch::default(); LANES];
            let touching = quartet.exert::<L>(&step, &mut visits, &mut out);
            let mut forces = vec![Vec2::zeros(); scene.places.len()];
            for touch in &out[..touching.count_ones() as usize] {
                touch.exertion.scatter(step.nodes_of(touch.participants), &mut forces);
            }
            let sliding: Vec<_> = visits.iter().map(|visit| visit.sliding).collect();
            let of =
                |t: usize| Triangles::<L>::new(each!(4, |k| step.bodies_of(participants[k])[t]));
            let clear = certainly_clear(&of(0), &of(1)).bits();
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
