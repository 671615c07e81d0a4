//! Evaluates some couples in a row, in passes, four couples at a time.
//!
//! 1. Couples that rest or certainly have no effect are passed over ([`super::certain`]).
//! 2. The others are sorted by the edges that they had to cut a step ago.
//! 3. Four that are alike are evaluated together ([`super::exertion`]).
//! 4. Forces are added in the order of the list.

use super::{
    bodies::Triangles,
    certain::certainly_clear,
    evaluation::{Part, Step},
    exertion::{Bench, CORNERS, Exertion, Quartet},
    facing::face_apart,
    places::{ALL, Places, quartet},
    sliding::Sliding,
    visits::Visit,
};
use crate::{
    lanes::{self, Kernel, LANES, Lanes, Mask, each},
    mechanics::Vec2,
};

/// Sets of edges of a couple that can be cut.
const EDGE_SETS: usize = 1 << CORNERS;

/// Some couples in a row, and what is found out about them. Couples are named by their places in the
/// chunk.
#[derive(Debug, Clone, Default)]
pub(super) struct Chunk {
    /// Couples to be evaluated.
    asked: Places,
    /// Couples that did not touch in the last step and whose facing edges can tell whether they do
    /// now.
    facing: Places,
    /// Couples that did not touch in the last step of which facing edges do not tell that they have
    /// no effect, in any order.
    unsure: Places,
    /// Those of them that are not certainly clear, in any order.
    close: Places,
    /// Places among the asked, those with the same edges cut in the last evaluation together.
    alike: Vec<u32>,
    /// What is known of each asked couple.
    visits: Vec<Visit>,
    /// What the asked couples exert.
    exertions: Vec<Exertion>,
    /// Couples that came apart.
    dropped: Vec<u32>,
}

impl Chunk {
    /// A chunk that can be used for so many couples.
    pub fn with_room_for(couples: usize) -> Self {
        let places = || Places::with_room_for(couples);
        Self {
            asked: places(),
            facing: places(),
            unsure: places(),
            close: places(),
            alike: vec![0; couples],
            visits: vec![Visit::default(); couples],
            exertions: vec![Exertion::default(); couples],
            dropped: Vec::with_capacity(couples),
        }
    }

    /// How many couples were evaluated.
    pub fn evaluated(&self) -> u64 {
        self.asked.len() as u64
    }

    /// Couples that came apart, ascending.
    pub fn dropped(&self) -> &[u32] {
        &self.dropped
    }

    /// Keeps the sliding of the couples; the first of `visits` is the chunk's first.
    pub fn keep_sliding(&self, visits: &mut [Visit], sliding: &mut Sliding) {
        for (&couple, exertion) in self.asked.get().iter().zip(&self.exertions) {
            if let Some(row) = exertion.sliding() {
                sliding.keep(&mut visits[couple as usize].sliding, row);
            }
        }
    }

    /// Evaluates couples: finds out what they exert.
    pub fn evaluate(&mut self, step: &Step<'_>, couples: Part<'_>) {
        lanes::run(Evaluation { chunk: self, step, couples });
    }

    /// Adds the forces in the order of the couples.
    pub fn scatter(&self, step: &Step<'_>, forces: &mut [Vec2]) {
        for exertion in &self.exertions[..self.asked.len()] {
            exertion.scatter(step, forces);
        }
    }
}

/// The passes of a chunk up to its forces.
struct Evaluation<'a, 'b> {
    chunk: &'a mut Chunk,
    step: &'a Step<'b>,
    couples: Part<'a>,
}

impl Kernel for Evaluation<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(mut self) {
        self.pass_over::<L>();
        self.put_alike_together();
        self.exert_asked::<L>();
    }
}

impl Evaluation<'_, '_> {
    /// Lists the couples that neither rest nor are certain to have no effect.
    #[inline(always)]
    fn pass_over<L: Lanes>(&mut self) {
        let Chunk { asked, facing, unsure, close, .. } = &mut *self.chunk;
        for list in [asked, facing, unsure, close] {
            list.clear();
        }
        let path = L::splat(self.step.path);
        let tests = if self.step.rests { ALL } else { 0 };
        let faces = if self.step.asks_all() { 0 } else { tests };
        let (blocks, others) = self.couples.facing.as_chunks::<LANES>();
        let (rest, _) = self.couples.respites.rest.as_chunks::<LANES>();
        let (stay, _) = self.couples.respites.stay.as_chunks::<LANES>();
        let (face, _) = self.couples.respites.face.as_chunks::<LANES>();
        let (limit, _) = self.couples.respites.limit.as_chunks::<LANES>();
        let (edges, _) = self.couples.respites.edges.as_chunks::<LANES>();
        let paths = rest.iter().zip(stay).zip(face.iter().zip(limit)).zip(edges);
        for ((block, couples), (((rest, stay), (face, limit)), edges)) in
            blocks.iter().enumerate().zip(paths)
        {
            let first = block * LANES;
            let awake = (!path.lt(L::widen(rest))).bits();
            if awake == 0 {
                continue;
            }
            // what touched a step ago most likely does so now
            let mut apart = awake & tests;
            if *edges != [0; LANES] {
                each!(4, |k| apart &= !(u32::from(edges[k] != 0) << k));
            }
            let facing = apart & faces & path.lt(L::widen(face)).bits();
            if facing == ALL {
                let apart = face_apart(self.step.bodies, couples, L::widen(limit));
                self.chunk.unsure.push_lanes(first, ALL & !apart);
                continue;
            }
            let unsure = apart & !facing & path.lt(L::widen(stay)).bits();
            self.chunk.facing.push_lanes(first, facing);
            self.chunk.unsure.push_lanes(first, unsure);
            self.chunk.asked.push_lanes(first, awake & !(facing | unsure));
        }
        for index in blocks.len() * LANES..blocks.len() * LANES + others.len() {
            if self.step.path >= f64::from(self.couples.respites.rest[index]) {
                self.chunk.asked.push_lanes(index, 1);
            }
        }
        for at in (0..self.chunk.facing.len()).step_by(LANES) {
            let (of_lane, count) = quartet(&self.chunk.facing.get()[at..]);
            let couples = each!(4, |k| self.couples.facing[of_lane[k]]);
            let limit = L::widen(&each!(4, |k| self.couples.respites.limit[of_lane[k]]));
            let apart = face_apart(self.step.bodies, &couples, limit);
            self.chunk.unsure.push_those(of_lane, !apart & ((1 << count) - 1));
        }
        for at in (0..self.chunk.unsure.len()).step_by(LANES) {
            let (of_lane, count) = quartet(&self.chunk.unsure.get()[at..]);
            self.try_all_edges::<L>(of_lane, (1 << count) - 1);
        }
        let Chunk { asked, close, .. } = &mut *self.chunk;
        if !close.is_empty() {
            close.sort();
            asked.insert_sorted(close);
        }
    }

    /// Lists those of the `valid` couples that are not certain to have no effect; finds out of the
    /// others how long they can be left alone.
    #[inline(always)]
    fn try_all_edges<L: Lanes>(&mut self, of_lane: [usize; LANES], valid: u32) {
        let Self { chunk, step, couples } = self;
        let bodies = each!(4, |k| step.bodies_of(couples.facing[of_lane[k]]));
        let target = Triangles::<L>::new(each!(4, |k| bodies[k][0]));
        let contactor = Triangles::new(each!(4, |k| bodies[k][1]));
        let clear = certainly_clear(&target, &contactor).bits() & valid;
        for lane in 0..LANES {
            if clear >> lane & 1 != 0 {
                let index = of_lane[lane];
                let slot = couples.visits[index].slot;
                step.ask_later(slot, &mut couples.facing[index], &mut couples.respites, index);
            }
        }
        chunk.close.push_those(of_lane, valid & !clear);
    }

    /// Sorts the asked couples by the edges cut in their last evaluation: couples that are
    /// evaluated together should have the same edges to cut.
    #[inline(always)]
    fn put_alike_together(&mut self) {
        let Self { chunk, couples, .. } = self;
        let Chunk { asked, alike, visits, .. } = &mut **chunk;
        let asked = asked.get();
        let edges = &*couples.respites.edges;
        let mut places = [0u32; EDGE_SETS];
        let set = |couple: u32| edges[couple as usize] as usize % EDGE_SETS;
        for &couple in asked {
            places[set(couple)] += 1;
        }
        let mut sum = 0;
        for place in &mut places {
            (*place, sum) = (sum, sum + *place);
        }
        for ((at, &couple), visit) in asked.iter().enumerate().zip(visits) {
            // read here, one after the other, which brings the couples into the cache
            *visit = couples.visits[couple as usize];
            let place = &mut places[set(couple)];
            alike[*place as usize] = at as u32;
            *place += 1;
        }
    }

    /// Evaluates the listed couples; lists those that came apart.
    #[inline(always)]
    fn exert_asked<L: Lanes>(&mut self) {
        let Self { chunk, step, couples } = self;
        let Chunk { asked, alike, visits, exertions, dropped, .. } = &mut **chunk;
        dropped.clear();
        let asked = asked.get();
        let mut bench = Bench::<L>::new();
        for places in alike[..asked.len()].chunks(LANES) {
            let (place, count) = quartet(places);
            let of_lane = each!(4, |k| asked[place[k]] as usize);
            let visits = each!(4, |k| visits[place[k]]);
            let four = Quartet {
                couples: each!(4, |k| couples.facing[of_lane[k]]),
                traits: each!(4, |k| visits[k].traits),
                sliding: each!(4, |k| couples.sliding.of(visits[k].sliding)),
                count,
            };
            let edges = four.exert(step, &mut bench, place, exertions);
            for lane in 0..count {
                let couple = of_lane[lane];
                couples.respites.edges[couple] = edges[lane];
                if edges[lane] != 0 {
                    continue;
                }
                if step.is_beyond(four.couples[lane]) {
                    dropped.push(couple as u32);
                } else if step.rests && step.may_ask(&couples.respites, couple) {
                    step.ask(&mut couples.facing[couple], &mut couples.respites, couple);
                }
            }
        }
        dropped.sort_unstable();
    }
}
