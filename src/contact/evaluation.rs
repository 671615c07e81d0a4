//! Evaluates the couples of a step, four at a time and on all threads where there are many.
//!
//! A chunk of couples goes through these passes: couples that rest or certainly have no effect
//! are passed over ([`certain`](super::certain)); the others are evaluated
//! ([`exertion`](super::exertion)); the forces are added in the order of the list. Couples are
//! independent of each other but for that last pass, so that sums round the same on any number
//! of threads.

use super::{
    bodies::{Bodies, Body, Triangles},
    certain::{Separator, certainly_clear, certainly_separated},
    clearance::{Clearance, clearance},
    exertion::{Bench, CORNERS, Exertion, Quartet},
    friction::PairTable,
    placement::Placement,
    visits::{RespitesMut, Traits, Visit},
};
use crate::{
    lanes::{self, Kernel, LANES, Lanes, Mask, each},
    mechanics::Vec2,
};
use rayon::prelude::*;

/// A couple that could not be let rest is asked again after so many evaluations.
const PATIENCE: f64 = 64.0;
/// The same for a couple that touches at a point, as bonded neighbours do.
const PATIENCE_TOUCHING: f64 = 512.0;

/// Steps at the present speed that a rest must promise.
const WORTHWHILE_STEPS: f64 = 4.0;

/// Couples in a chunk when one thread does all: many, so that there are enough alike, but what
/// they exert stays in the cache.
const SERIAL_CHUNK: usize = 512;
/// From so many couples on, threads pay (measured, `docs/src/performance.md`).
const PARALLEL_FROM: usize = 4096;
/// Chunks for each thread, to even out couples that rest and couples that touch.
const CHUNKS_PER_THREAD: usize = 4;

/// What the couples of a step see.
#[derive(Clone, Copy)]
pub(super) struct Step<'a> {
    pub bodies: &'a Bodies,
    pub pairs: &'a PairTable,
    pub dt: f64,
    pub buffer: f64,
    /// Path of the fastest node, m, and the part of the last step.
    pub path: f64,
    pub advance: f64,
    pub rests: bool,
    /// Evaluations before this one.
    pub evaluation: f64,
}

/// What evaluation did.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Done {
    pub evaluated: u64,
    /// Whether a couple came apart.
    pub dropped: bool,
}

impl Done {
    fn and(self, other: Self) -> Self {
        Self { evaluated: self.evaluated + other.evaluated, dropped: self.dropped || other.dropped }
    }
}

impl Step<'_> {
    /// Path up to which a couple rests that may do so while no node moves further than `free`;
    /// none if that is not worth it for some steps or not resolved by the sum of the path.
    #[inline(always)]
    pub(super) fn rest(&self, free: f64) -> Option<f64> {
        (free > WORTHWHILE_STEPS * self.advance && free > 1e-9 * self.path)
            .then_some(self.path + free)
    }

    /// Square of the distance beyond which a couple is dropped, m².
    pub fn drop_distance_squared(&self) -> f64 {
        4.0 * self.buffer * self.buffer
    }

    #[inline(always)]
    pub fn bodies_of(&self, participants: [u32; 2]) -> [&Body; 2] {
        each!(2, |t| &self.bodies.bodies[participants[t] as usize])
    }

    #[inline(always)]
    pub fn nodes_of(&self, participants: [u32; 2]) -> [&[u32; 3]; 2] {
        each!(2, |t| &self.bodies.corners[participants[t] as usize])
    }

    /// Finds out for how long a couple without effect can be left alone.
    #[cold]
    #[inline(never)]
    fn ask(&self, participants: [u32; 2], respites: &mut RespitesMut<'_>, index: usize) {
        let nodes = self.nodes_of(participants);
        let corners = self.bodies_of(participants).map(Body::corners);
        let Clearance { rest, stay } = clearance(nodes, &corners, self.buffer);
        if let Some(path) = self.rest(rest) {
            respites.rest[index] = path;
        } else {
            let patience = if rest == 0.0 { PATIENCE_TOUCHING } else { PATIENCE };
            respites.ask[index] = self.evaluation + patience;
        }
        if let Some(path) = self.rest(stay) {
            respites.stay[index] = path;
        }
        respites.separators[index] = Separator::of(&corners[0], &corners[1]).bits();
    }

    /// Whether a couple of which no edge is cut is dropped.
    #[cold]
    #[inline(never)]
    fn is_beyond(&self, participants: [u32; 2]) -> bool {
        let [target, contactor] = self.bodies_of(participants).map(Body::shape);
        let shapes = [&target, &contactor];
        Placement::new(shapes).is_beyond(shapes, self.drop_distance_squared())
    }
}

/// Sets of edges of a couple that can be cut.
const EDGE_SETS: usize = 1 << CORNERS;

/// Passes of a chunk of couples. Couples are named by their places in the chunk.
#[derive(Debug, Clone, Default)]
struct Chunk {
    /// Couples to be evaluated.
    asked: Places,
    /// Couples that did not touch in the last step.
    separated: Places,
    /// Those of them that the edges which separated them last do not separate now, in any order.
    unsure: Places,
    /// Those of them that are not certainly clear, in any order.
    close: Places,
    /// Places among the asked, those with the same edges cut in the last evaluation together.
    alike: Vec<u32>,
    /// What is known of each asked couple.
    traits: Vec<Traits>,
    /// What the asked couples exert.
    exertions: Vec<Exertion>,
    done: Done,
}

/// All bits of the lanes.
const ALL: u32 = (1 << LANES) - 1;

/// Places of couples in a chunk, ascending where nothing else is said. There is always room for more than there can be, so
/// that the list grows without branches.
#[derive(Debug, Clone, Default)]
struct Places {
    places: Vec<u32>,
    count: usize,
}

impl Places {
    /// Makes room for the couples of a chunk of that size.
    fn reserve(&mut self, size: usize) {
        if self.places.len() < size + LANES {
            self.places.resize(size + LANES, 0);
        }
    }

    #[inline(always)]
    fn clear(&mut self) {
        self.count = 0;
    }

    #[inline(always)]
    fn is_empty(&self) -> bool {
        self.count == 0
    }

    #[inline(always)]
    fn get(&self) -> &[u32] {
        &self.places[..self.count]
    }

    /// The four places from `at` on, and a bit for each that there is; a last quartet that is not
    /// full repeats its first place.
    #[inline(always)]
    fn quartet(&self, at: usize) -> ([usize; LANES], u32) {
        let places = &self.get()[at..];
        let count = places.len().min(LANES);
        (each!(4, |k| places[if k < count { k } else { 0 }] as usize), (1 << count) - 1)
    }

    /// Adds the places `first` + `k` for every bit `k`.
    #[inline(always)]
    fn push_lanes(&mut self, first: usize, bits: u32) {
        if bits == 0 {
            return;
        }
        let room: &mut [u32; LANES] = &mut self.places[self.count..].as_chunks_mut().0[0];
        // no branches: which couples are meant cannot be predicted
        let mut count = 0;
        for lane in 0..LANES {
            room[count % LANES] = (first + lane) as u32;
            count += (bits >> lane & 1) as usize;
        }
        self.count += count;
    }

    #[cold]
    fn sort(&mut self) {
        self.places[..self.count].sort_unstable();
    }

    /// Adds places that are not among these.
    #[cold]
    fn insert_sorted(&mut self, others: &Self) {
        let (mut mine, mut theirs) = (self.count, others.count);
        self.count += others.count;
        let mut end = self.count;
        while theirs > 0 {
            end -= 1;
            let other = others.places[theirs - 1];
            if mine > 0 && self.places[mine - 1] > other {
                self.places[end] = self.places[mine - 1];
                mine -= 1;
            } else {
                self.places[end] = other;
                theirs -= 1;
            }
        }
    }
}

/// Some couples in the order of the list.
pub(super) struct Couples<'a> {
    pub visits: &'a mut [Visit],
    /// Their places among the bodies.
    pub participants: &'a [[u32; 2]],
    pub respites: RespitesMut<'a>,
}

/// Buffers reused from step to step.
#[derive(Debug, Clone, Default)]
pub(super) struct Evaluator {
    chunks: Vec<Chunk>,
}

impl Evaluator {
    /// Evaluates the couples and adds their forces, in the order of the list.
    pub fn evaluate(&mut self, step: &Step<'_>, couples: Couples<'_>, forces: &mut [Vec2]) -> Done {
        let Couples { visits: list, participants, respites } = couples;
        let threads = rayon::current_num_threads();
        let mut done = Done::default();
        if threads > 1 && list.len() >= PARALLEL_FROM {
            let size = list.len().div_ceil(threads * CHUNKS_PER_THREAD).next_multiple_of(LANES);
            let chunks = list.len().div_ceil(size);
            self.prepare(chunks, size);
            list.par_chunks_mut(size)
                .zip(participants.par_chunks(size))
                .zip(respites.par_chunks(size))
                .zip(&mut self.chunks)
                .for_each(|(((visits, participants), respites), chunk)| {
                    chunk.evaluate(step, Couples { visits, participants, respites });
                });
            for chunk in &self.chunks[..chunks] {
                chunk.scatter(step, forces);
                done = done.and(chunk.done);
            }
        } else {
            self.prepare(1, SERIAL_CHUNK);
            let chunk = &mut self.chunks[0];
            let lists = list.chunks_mut(SERIAL_CHUNK).zip(participants.chunks(SERIAL_CHUNK));
            for ((visits, participants), respites) in lists.zip(respites.chunks(SERIAL_CHUNK)) {
                chunk.evaluate(step, Couples { visits, participants, respites });
                chunk.scatter(step, forces);
                done = done.and(chunk.done);
            }
        }
        done
    }

    /// Makes room for all that chunks of so many couples can need.
    fn prepare(&mut self, chunks: usize, size: usize) {
        if self.chunks.len() < chunks {
            self.chunks.resize_with(chunks, Chunk::default);
        }
        for chunk in &mut self.chunks[..chunks] {
            let couples = size.next_multiple_of(LANES);
            let Chunk { asked, separated, unsure, close, .. } = chunk;
            for places in [asked, separated, unsure, close] {
                places.reserve(couples);
            }
            if chunk.alike.len() < couples {
                chunk.alike.resize(couples, 0);
                chunk.traits.resize(couples, Traits::default());
                chunk.exertions.resize(couples, Exertion::default());
            }
        }
    }
}

impl Chunk {
    fn evaluate(&mut self, step: &Step<'_>, couples: Couples<'_>) {
        lanes::run(Evaluation { chunk: self, step, couples });
    }

    /// Adds the forces in the order of the couples.
    fn scatter(&self, step: &Step<'_>, forces: &mut [Vec2]) {
        for exertion in &self.exertions[..self.asked.count] {
            exertion.scatter(step, forces);
        }
    }
}

/// The passes of a chunk up to its forces.
struct Evaluation<'a, 'b> {
    chunk: &'a mut Chunk,
    step: &'a Step<'b>,
    couples: Couples<'a>,
}

impl Kernel for Evaluation<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(mut self) {
        self.pass_over::<L>();
        self.chunk.done = Done { evaluated: self.chunk.asked.count as u64, dropped: false };
        self.put_alike_together();
        self.exert_asked::<L>();
    }
}

impl Evaluation<'_, '_> {
    /// Lists the couples that neither rest nor are certain to have no effect.
    #[inline(always)]
    fn pass_over<L: Lanes>(&mut self) {
        let Chunk { asked, separated, unsure, close, .. } = &mut *self.chunk;
        for list in [asked, separated, unsure, close] {
            list.clear();
        }
        let path = L::splat(self.step.path);
        let tests = if self.step.rests { ALL } else { 0 };
        let (blocks, others) = self.couples.participants.as_chunks::<LANES>();
        for (block, participants) in blocks.iter().enumerate() {
            let first = block * LANES;
            let respites = &self.couples.respites;
            let awake = (!path.lt(lanes_at(respites.rest, first))).bits();
            if awake == 0 {
                continue;
            }
            let stays = path.lt(lanes_at::<L>(respites.stay, first)).bits();
            // what touched a step ago most likely does so now
            let edges = respites.edges[first..].as_chunks::<LANES>().0[0];
            let mut touched = 0;
            if edges != [0; LANES] {
                each!(4, |k| touched |= u32::from(edges[k] != 0) << k);
            }
            let tested = awake & stays & !touched & tests;
            self.chunk.asked.push_lanes(first, awake & !tested);
            if tested == ALL {
                self.try_separators::<L>(each!(4, |k| first + k), participants, ALL);
            } else {
                self.chunk.separated.push_lanes(first, tested);
            }
        }
        for index in blocks.len() * LANES..blocks.len() * LANES + others.len() {
            if self.step.path >= self.couples.respites.rest[index] {
                self.chunk.asked.push_lanes(index, 1);
            }
        }
        for at in (0..self.chunk.separated.count).step_by(LANES) {
            let (of_lane, valid) = self.chunk.separated.quartet(at);
            let participants = each!(4, |k| self.couples.participants[of_lane[k]]);
            self.try_separators::<L>(of_lane, &participants, valid);
        }
        for at in (0..self.chunk.unsure.count).step_by(LANES) {
            let (of_lane, valid) = self.chunk.unsure.quartet(at);
            self.try_all_edges::<L>(of_lane, valid);
        }
        let Chunk { asked, close, .. } = &mut *self.chunk;
        if !close.is_empty() {
            close.sort();
            asked.insert_sorted(close);
        }
    }

    /// Lists those of the `valid` couples that their separators do not separate, and those that
    /// may be asked whether they can rest.
    #[inline(always)]
    fn try_separators<L: Lanes>(
        &mut self,
        of_lane: [usize; LANES],
        participants: &[[u32; 2]; LANES],
        valid: u32,
    ) {
        let Self { chunk, step, couples } = self;
        let RespitesMut { separators, ask, .. } = &couples.respites;
        let bodies = each!(4, |k| step.bodies_of(participants[k]));
        let separators = each!(4, |k| Separator::from_bits(separators[of_lane[k]]));
        let separated = certainly_separated::<L>(&bodies, separators);
        let due = L::new(each!(4, |k| ask[of_lane[k]])).le(L::splat(step.evaluation));
        let mut unsure = (!separated | due).bits() & valid;
        while unsure != 0 {
            chunk.unsure.push_lanes(of_lane[unsure.trailing_zeros() as usize % LANES], 1);
            unsure &= unsure - 1;
        }
    }

    /// Lists those of the `valid` couples that are not certain to have no effect; lets the others
    /// rest.
    #[inline(always)]
    fn try_all_edges<L: Lanes>(&mut self, of_lane: [usize; LANES], valid: u32) {
        let Self { chunk, step, couples } = self;
        let participants = each!(4, |k| couples.participants[of_lane[k]]);
        let bodies = each!(4, |k| step.bodies_of(participants[k]));
        let target = Triangles::<L>::new(each!(4, |k| bodies[k][0]));
        let contactor = Triangles::new(each!(4, |k| bodies[k][1]));
        let clear = certainly_clear(&target, &contactor).bits() & valid;
        let asks = L::new(each!(4, |k| couples.respites.ask[of_lane[k]]));
        let mut due = asks.le(L::splat(step.evaluation)).bits() & clear;
        while due != 0 {
            let lane = due.trailing_zeros() as usize % LANES;
            due &= due - 1;
            step.ask(participants[lane], &mut couples.respites, of_lane[lane]);
        }
        let mut unclear = valid & !clear;
        while unclear != 0 {
            chunk.close.push_lanes(of_lane[unclear.trailing_zeros() as usize % LANES], 1);
            unclear &= unclear - 1;
        }
    }

    /// Sorts the asked couples by the edges cut in their last evaluation: couples that are
    /// evaluated together should have the same edges to cut.
    #[inline(always)]
    fn put_alike_together(&mut self) {
        let Self { chunk, couples, .. } = self;
        let Chunk { asked, alike, traits, .. } = &mut **chunk;
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
        for ((at, &couple), traits) in asked.iter().enumerate().zip(traits) {
            // read here, one after the other, which brings the couples into the cache
            *traits = couples.visits[couple as usize].traits;
            let place = &mut places[set(couple)];
            alike[*place as usize] = at as u32;
            *place += 1;
        }
    }

    /// Evaluates the listed couples; drops those that came apart.
    #[inline(always)]
    fn exert_asked<L: Lanes>(&mut self) {
        let Self { chunk, step, couples } = self;
        let Chunk { asked, alike, traits, exertions, done, .. } = &mut **chunk;
        let asked = asked.get();
        let mut bench = Bench::<L>::new();
        for places in alike[..asked.len()].chunks(LANES) {
            // a last block that is not full repeats its first couple
            let place = each!(4, |k| places[if k < places.len() { k } else { 0 }] as usize);
            let of_lane = each!(4, |k| asked[place[k]] as usize);
            let quartet = Quartet {
                couples: of_lane,
                participants: each!(4, |k| couples.participants[of_lane[k]]),
                traits: each!(4, |k| traits[place[k]]),
                count: places.len(),
            };
            let edges = quartet.exert(step, couples.visits, &mut bench, place, exertions);
            for lane in 0..places.len() {
                let couple = of_lane[lane];
                couples.respites.edges[couple] = edges[lane];
                if edges[lane] != 0 {
                    continue;
                }
                let participants = quartet.participants[lane];
                if step.is_beyond(participants) {
                    couples.visits[couple].is_dropped = true;
                    done.dropped = true;
                } else if step.rests && couples.respites.ask[couple] <= step.evaluation {
                    step.ask(participants, &mut couples.respites, couple);
                }
            }
        }
    }
}

/// Four numbers from one on.
#[inline(always)]
fn lanes_at<L: Lanes>(values: &[f64], first: usize) -> L {
    L::load(&values[first..].as_chunks().0[0])
}
