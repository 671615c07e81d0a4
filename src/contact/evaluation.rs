//! Evaluates the couples of a step, on all threads where there are many.
//!
//! Couples are independent of each other but for the forces that they add to
//! shared nodes. Each chunk of couples keeps what its couples exert; the forces
//! are then added in the order of the list, so that sums round the same on any
//! number of threads.

use super::{
    clearance::clearance,
    friction::PairTable,
    overlap2::{Couple, Proximity, SideForces, overlap},
    placement::{Motion, Shape},
    visits::Visit,
};
use crate::mechanics::Vec2;
use multiversion::multiversion;
use rayon::prelude::*;

/// A couple that could not be let rest is asked again after so many evaluations.
const PATIENCE: u8 = 15;

/// Steps at the present speed that a rest must promise.
const WORTHWHILE_STEPS: f64 = 4.0;

/// Couples in a chunk when one thread does all: its forces stay in the cache.
const SERIAL_CHUNK: usize = 64;
/// From so many couples on, threads pay (measured, `docs/src/performance.md`).
const PARALLEL_FROM: usize = 4096;
/// Chunks for each thread, to even out couples that rest and couples that touch.
const CHUNKS_PER_THREAD: usize = 4;

/// What the couples of a step see.
#[derive(Clone, Copy)]
pub(super) struct Step<'a> {
    /// Shapes, velocities and corner nodes of the participants.
    pub shapes: &'a [Shape],
    pub motions: &'a [Motion],
    pub corners: &'a [[u32; 3]],
    pub pairs: &'a PairTable,
    pub dt: f64,
    pub buffer: f64,
    /// Path of the fastest node, m, and the part of the last step.
    pub path: f64,
    pub advance: f64,
    pub rests: bool,
}

/// What evaluation did.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Done {
    pub evaluated: u64,
    /// Whether a couple came apart.
    pub dropped: bool,
}

/// Forces of a couple that touches.
#[derive(Debug, Clone, Copy, Default)]
struct Touch {
    participants: [u32; 2],
    sides: [SideForces; 2],
}

/// What a chunk of couples exerts.
#[derive(Debug, Clone, Default)]
struct Chunk {
    /// The first `count` are valid; the others keep their place in memory, so
    /// that couples are evaluated in place.
    touches: Vec<Touch>,
    count: usize,
    done: Done,
}

impl Chunk {
    fn scatter(&self, corners: &[[u32; 3]], forces: &mut [Vec2]) {
        for touch in &self.touches[..self.count] {
            let [target, contactor] = touch.participants.map(|p| &corners[p as usize]);
            touch.sides[0].scatter(target, contactor, forces);
            touch.sides[1].scatter(contactor, target, forces);
        }
    }
}

/// Buffers reused from step to step.
#[derive(Debug, Clone, Default)]
pub(super) struct Evaluator {
    chunks: Vec<Chunk>,
}

impl Evaluator {
    /// Evaluates the couples and adds their forces, in the order of the list.
    pub fn evaluate(&mut self, step: &Step<'_>, visits: &mut [Visit], forces: &mut [Vec2]) -> Done {
        let threads = rayon::current_num_threads();
        let mut done = Done::default();
        if threads > 1 && visits.len() >= PARALLEL_FROM {
            let size = visits.len().div_ceil(threads * CHUNKS_PER_THREAD);
            let chunks = visits.len().div_ceil(size);
            self.chunks.resize_with(chunks.max(self.chunks.len()), Chunk::default);
            visits
                .par_chunks_mut(size)
                .zip(&mut self.chunks)
                .for_each(|(visits, chunk)| evaluate_chunk(step, visits, chunk));
            for chunk in &self.chunks[..chunks] {
                chunk.scatter(step.corners, forces);
                done = done.and(chunk.done);
            }
        } else {
            if self.chunks.is_empty() {
                let touches = vec![Touch::default(); SERIAL_CHUNK];
                self.chunks.push(Chunk { touches, ..Chunk::default() });
            }
            let chunk = &mut self.chunks[0];
            for visits in visits.chunks_mut(SERIAL_CHUNK) {
                evaluate_chunk(step, visits, chunk);
                chunk.scatter(step.corners, forces);
                done = done.and(chunk.done);
            }
        }
        done
    }
}

impl Done {
    fn and(self, other: Self) -> Self {
        Self { evaluated: self.evaluated + other.evaluated, dropped: self.dropped || other.dropped }
    }
}

impl Visit {
    /// Lets the couple rest while no node moves further than `free`, if that is
    /// worth it for some steps and resolved by the sum of the path.
    #[inline(always)]
    pub(super) fn let_rest(&mut self, step: &Step<'_>, free: f64) {
        if free > WORTHWHILE_STEPS * step.advance && free > 1e-9 * step.path {
            self.rest = step.path + free;
        } else {
            self.patience = PATIENCE;
        }
    }
}

/// Compiled for several instruction sets and chosen at run time; all give the
/// same bits, because nothing is fused or reassociated.
#[multiversion(targets("x86_64+avx2+bmi1+bmi2+lzcnt", "x86_64+avx"))]
fn evaluate_chunk(step: &Step<'_>, visits: &mut [Visit], chunk: &mut Chunk) {
    chunk.count = 0;
    chunk.done = Done::default();
    for visit in visits {
        if step.path < visit.rest {
            continue;
        }
        chunk.done.evaluated += 1;
        let [target, contactor] = [visit.participants[0] as usize, visit.participants[1] as usize];
        let couple = Couple {
            shapes: [&step.shapes[target], &step.shapes[contactor]],
            motions: [&step.motions[target], &step.motions[contactor]],
            pair: step.pairs.properties(visit.pair),
            dt: step.dt,
            drop_distance_squared: 4.0 * step.buffer * step.buffer,
        };
        if chunk.touches.len() == chunk.count {
            chunk.touches.push(Touch::default());
        }
        let touch = &mut chunk.touches[chunk.count];
        match overlap(&couple, &mut { couple.pair }, &mut visit.sliding, &mut touch.sides) {
            Proximity::Near => {
                touch.participants = visit.participants;
                chunk.count += 1;
            }
            Proximity::Beyond => {
                visit.is_dropped = true;
                chunk.done.dropped = true;
            }
            Proximity::Clear if !step.rests => {}
            Proximity::Clear if visit.patience > 0 => visit.patience -= 1,
            Proximity::Clear => {
                let ids = [&step.corners[target], &step.corners[contactor]];
                let corners = [couple.shapes[0].corners(), couple.shapes[1].corners()];
                visit.let_rest(step, clearance(ids, &corners, step.buffer));
            }
        }
    }
}
