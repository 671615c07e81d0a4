//! Evaluates the couples of a step, on all threads where there are many.
//!
//! Couples are independent of each other but for the sums of their forces, which are made in the
//! order of the list: they round the same on any number of threads.

use super::{
    Vec3,
    clearance3::{ALL_PAIRS, Asked, Clearance},
    overlap3::{FaceForce, overlap_in},
    surfaces::Surfaces,
    visits::Visits,
};
use crate::lanes::{self, Kernel, Lanes};
use rayon::prelude::*;

/// Couples in a chunk.
const CHUNK: usize = 64;
/// From so many couples on, threads pay.
const PARALLEL_FROM: usize = 512;
/// Chunks of a round for each thread, to even out couples that touch and couples that do not.
const CHUNKS_PER_THREAD: usize = 8;

/// What the couples of a step see.
#[derive(Clone, Copy)]
pub(super) struct Step<'a> {
    pub visits: &'a Visits,
    pub surfaces: &'a Surfaces,
    pub rests: bool,
}

impl Step<'_> {
    /// Which pairs of faces of a couple can be left out while no node moves further than
    /// `horizon`.
    fn clearance(&self, couple: u32, horizon: f64) -> Clearance {
        if !self.rests {
            return Clearance { active: ALL_PAIRS, free: f64::INFINITY };
        }
        let bodies = &self.visits.bodies;
        let places = self.visits.list[couple as usize].participants.map(|place| place as usize);
        let asked = Asked {
            nodes: places.map(|place| &bodies.nodes[place]),
            bodies: places.map(|place| &bodies.targets[place]),
            faces: places.map(|place| &bodies.contactors[place]),
        };
        asked.clearance(horizon)
    }
}

/// The forces of some couples in a row.
#[derive(Debug, Clone, Default)]
struct Chunk(Vec<([u32; 2], FaceForce)>);

impl Chunk {
    fn evaluate(&mut self, step: &Step<'_>, couples: &[u32]) {
        lanes::run(Evaluation { chunk: self, step, couples });
    }

    #[inline(always)]
    fn evaluate_in<L: Lanes>(&mut self, step: &Step<'_>, couples: &[u32]) {
        self.0.clear();
        let bodies = &step.visits.bodies;
        for &couple in couples {
            let visit = &step.visits.list[couple as usize];
            let [target, contactor] = visit.participants.map(|place| place as usize);
            let penalty = step.surfaces.pair(visit.rank).penalty;
            overlap_in::<L>(
                &bodies.targets[target],
                &bodies.contactors[contactor],
                step.visits.active(couple),
                penalty,
                |force| self.0.push((visit.participants, force)),
            );
        }
    }

    fn scatter(&self, step: &Step<'_>, forces: &mut [Vec3]) {
        for (participants, force) in &self.0 {
            let [target, contactor] =
                participants.map(|place| &step.visits.bodies.nodes[place as usize]);
            force.scatter(target, contactor, forces);
        }
    }
}

/// Evaluates the couples of a chunk.
struct Evaluation<'a, 'b> {
    chunk: &'a mut Chunk,
    step: &'a Step<'b>,
    couples: &'a [u32],
}

impl Kernel for Evaluation<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        self.chunk.evaluate_in::<L>(self.step, self.couples);
    }
}

/// Buffers reused from step to step: while the couples of one bank are evaluated, those of the other
/// add their forces.
#[derive(Debug, Clone, Default)]
pub(super) struct Evaluator {
    banks: [Vec<Chunk>; 2],
    pub due: Vec<u32>,
    pub awake: Vec<u32>,
    pub clearances: Vec<Clearance>,
}

impl Evaluator {
    /// Asks the couples that are due.
    pub fn ask(&mut self, step: &Step<'_>, horizon: f64) {
        let Self { due, clearances, .. } = self;
        clearances.clear();
        if rayon::current_num_threads() > 1 && due.len() >= PARALLEL_FROM {
            clearances.resize(due.len(), Clearance { active: ALL_PAIRS, free: 0.0 });
            let couples = due.par_iter().with_min_len(CHUNK).zip(clearances.par_iter_mut());
            couples.for_each(|(&couple, clearance)| *clearance = step.clearance(couple, horizon));
        } else {
            clearances.extend(due.iter().map(|&couple| step.clearance(couple, horizon)));
        }
    }

    /// Evaluates the couples that are awake and adds their forces, in the order of the list.
    pub fn evaluate(&mut self, step: &Step<'_>, forces: &mut [Vec3]) {
        let threads = rayon::current_num_threads();
        if threads > 1 && self.awake.len() >= PARALLEL_FROM {
            self.evaluate_on(threads, step, forces);
            return;
        }
        let [bank, _] = &mut self.banks;
        let chunk = &mut room_for(bank, 1)[0];
        for couples in self.awake.chunks(CHUNK) {
            chunk.evaluate(step, couples);
            chunk.scatter(step, forces);
        }
    }

    /// Round by round, so that what couples exert needs little memory.
    fn evaluate_on(&mut self, threads: usize, step: &Step<'_>, forces: &mut [Vec3]) {
        let scatter = |chunks: &[Chunk], forces: &mut [Vec3]| {
            chunks.iter().for_each(|chunk| chunk.scatter(step, forces));
        };
        // how many of the other bank have not added their forces yet
        let mut waiting = 0;
        for round in self.awake.chunks(threads * CHUNKS_PER_THREAD * CHUNK) {
            let [bank, other] = &mut self.banks;
            let chunks = round.len().div_ceil(CHUNK);
            let bank = room_for(bank, chunks);
            rayon::join(
                || scatter(&other[..waiting], forces),
                || {
                    let pairs = round.par_chunks(CHUNK).zip(&mut *bank);
                    pairs.for_each(|(couples, chunk)| chunk.evaluate(step, couples));
                },
            );
            waiting = chunks;
            self.banks.swap(0, 1);
        }
        scatter(&self.banks[1][..waiting], forces);
    }
}

/// The first chunks of a bank.
fn room_for(bank: &mut Vec<Chunk>, chunks: usize) -> &mut [Chunk] {
    if bank.len() < chunks {
        bank.resize_with(chunks, Chunk::default);
    }
    &mut bank[..chunks]
}
