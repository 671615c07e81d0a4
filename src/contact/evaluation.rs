//! Evaluates the couples of a step, four at a time and on all threads where there are many.
//!
//! A chunk of couples goes through these passes: couples that rest or certainly have no effect
//! are passed over ([`certain`](super::certain)); the others are evaluated
//! ([`exertion`](super::exertion)); the forces are added in the order of the list. Couples are
//! independent of each other but for that last pass, so that sums round the same on any number
//! of threads.

use super::{
    bodies::{Bodies, Body, Triangles},
    certain::certainly_clear,
    clearance::{Clearance, clearance},
    exertion::{Exertion, Quartet},
    friction::PairTable,
    placement::Placement,
    visits::{RespitesMut, Visit},
};
use crate::{
    lanes::{self, Kernel, LANES, Lanes, Mask, each},
    mechanics::Vec2,
};
use rayon::prelude::*;

/// A couple that could not be let rest is asked again after so many evaluations.
const PATIENCE: f64 = 16.0;
/// The same for a couple that touches at a point, as bonded neighbours do.
const PATIENCE_TOUCHING: f64 = 128.0;

/// Steps at the present speed that a rest must promise.
const WORTHWHILE_STEPS: f64 = 4.0;

/// Couples in a chunk when one thread does all: what it keeps stays in the cache.
const SERIAL_CHUNK: usize = 64;
/// From so many couples on, threads pay (measured, `docs/src/performance.md`).
const PARALLEL_FROM: usize = 4096;
/// Chunks for each thread, to even out couples that rest and couples that touch.
const CHUNKS_PER_THREAD: usize = 4;

/// What the couples of a step see.
#[derive(Clone, Copy)]
pub(super) struct Step<'a> {
    pub bodies: &'a Bodies,
    /// Velocities of all nodes.
    pub velocities: &'a [Vec2],
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

    #[inline(always)]
    pub fn velocity(&self, node: u32) -> &[f64; 2] {
        &self.velocities[node as usize].data.0[0]
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

/// What the triangles of a couple that touches exert on each other.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Touch {
    pub participants: [u32; 2],
    pub exertion: Exertion,
}

/// Passes of a chunk of couples. Lists keep their length from step to step; the counts tell how
/// much of them is valid.
#[derive(Debug, Clone, Default)]
struct Chunk {
    counts: Counts,
    /// Couples to be evaluated, by their place in the chunk.
    asked: Vec<u32>,
    touches: Vec<Touch>,
    done: Done,
}

/// Valid entries of a chunk's lists.
#[derive(Debug, Clone, Copy, Default)]
struct Counts {
    asked: usize,
    touches: usize,
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
            if chunk.asked.len() < couples + LANES {
                // more than there can be, so that lists grow without branches
                chunk.asked.resize(couples + LANES, 0);
                chunk.touches.resize(couples + LANES, Touch::default());
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
        for touch in &self.touches[..self.counts.touches] {
            touch.exertion.scatter(step.nodes_of(touch.participants), forces);
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
        self.chunk.done = Done::default();
        self.chunk.counts = Counts::default();
        self.pass_over::<L>();
        self.chunk.done.evaluated = self.chunk.counts.asked as u64;
        self.exert_asked::<L>();
    }
}

impl Evaluation<'_, '_> {
    /// Lists the couples that neither rest nor are certain to have no effect.
    #[inline(always)]
    fn pass_over<L: Lanes>(&mut self) {
        let Self { chunk, step, couples } = self;
        let mut count = 0;
        let path = L::splat(step.path);
        let (blocks, rest) = couples.participants.as_chunks::<LANES>();
        for (block, participants) in blocks.iter().enumerate() {
            let first = block * LANES;
            let awake = !path.lt(lanes_at(couples.respites.rest, first));
            if !awake.any() {
                continue;
            }
            let mut asked = awake.bits();
            let known = path.lt(lanes_at::<L>(couples.respites.stay, first)) & awake;
            if step.rests && known.any() {
                let bodies = each!(4, |k| step.bodies_of(participants[k]));
                let target = Triangles::<L>::new(each!(4, |k| bodies[k][0]));
                let contactor = Triangles::new(each!(4, |k| bodies[k][1]));
                let clear = certainly_clear(&target, &contactor) & known;
                asked &= !clear.bits();
                let due = lanes_at::<L>(couples.respites.ask, first).le(L::splat(step.evaluation));
                let mut due = (due & clear).bits();
                while due != 0 {
                    let lane = due.trailing_zeros() as usize;
                    due &= due - 1;
                    step.ask(participants[lane], &mut couples.respites, first + lane);
                }
            }
            // no branches: which couples are asked cannot be predicted
            for lane in 0..LANES {
                chunk.asked[count] = (first + lane) as u32;
                count += (asked >> lane & 1) as usize;
            }
        }
        let first = couples.participants.len() - rest.len();
        for index in first..couples.participants.len() {
            if step.path >= couples.respites.rest[index] {
                chunk.asked[count] = index as u32;
                count += 1;
            }
        }
        chunk.counts.asked = count;
    }

    /// Evaluates the listed couples; drops those that came apart.
    #[inline(always)]
    fn exert_asked<L: Lanes>(&mut self) {
        let Self { chunk, step, couples } = self;
        let mut touches = 0;
        for asked in chunk.asked[..chunk.counts.asked].chunks(LANES) {
            // a last block that is not full repeats its first couple
            let of_lane = each!(4, |k| asked[if k < asked.len() { k } else { 0 }] as usize);
            let quartet = Quartet {
                couples: of_lane,
                participants: each!(4, |k| couples.participants[of_lane[k]]),
                count: asked.len(),
            };
            let out = &mut chunk.touches[touches..].as_chunks_mut().0[0];
            let touching = quartet.exert::<L>(step, couples.visits, out);
            touches += touching.count_ones() as usize;
            let mut apart = !touching & ((1 << asked.len()) - 1);
            while apart != 0 {
                let lane = apart.trailing_zeros() as usize;
                apart &= apart - 1;
                let (couple, participants) = (of_lane[lane], quartet.participants[lane]);
                if step.is_beyond(participants) {
                    couples.visits[couple].is_dropped = true;
                    chunk.done.dropped = true;
                } else if step.rests && couples.respites.ask[couple] <= step.evaluation {
                    step.ask(participants, &mut couples.respites, couple);
                }
            }
        }
        chunk.counts.touches = touches;
    }
}

/// Four numbers from one on.
#[inline(always)]
fn lanes_at<L: Lanes>(values: &[f64], first: usize) -> L {
    L::load(&values[first..].as_chunks().0[0])
}
