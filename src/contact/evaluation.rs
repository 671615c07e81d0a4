//! Evaluates the couples of a step, on all threads where there are many.
//!
//! Couples are independent of each other but for the sums of their forces, which are made in the
//! order of the list: they round the same on any number of threads.

use super::{
    bodies::{Bodies, Body},
    chunk::Chunk,
    clearance::{Clearance, clearance, faces},
    facing::Facing,
    friction::PairTable,
    placement::Placement,
    respites::{Respites, RespitesMut, is_due, rounded_down},
    sliding::Sliding,
    visits::{Chains, Visit},
};
use crate::{lanes::each, mechanics::Vec2, team::Team};
use std::iter::once;

/// Evaluations in a turn.
const TURN: u32 = 64;
/// A couple that could not be let rest is asked again after so many turns.
const PATIENCE: u16 = 1;
/// The same for a couple that touches at a point, as bonded neighbours do.
const PATIENCE_TOUCHING: u16 = 8;
/// Facing edges that do not tell are chosen anew in one of so many evaluations.
const PATIENCE_FACING: u32 = 32;

/// Steps at the present speed that a rest must promise.
const WORTHWHILE_STEPS: f64 = 4.0;

/// Couples in a chunk: many, so that there are enough alike, but what they exert stays in the cache.
const CHUNK: usize = 512;
/// The least in a chunk where few couples are shared among threads.
const LEAST_CHUNK: usize = 128;
/// From so many couples on, threads pay (measured, `docs/src/performance.md`).
const PARALLEL_FROM: usize = 512;
/// Chunks of a round for each thread, to even out couples that rest and couples that touch.
const CHUNKS_PER_THREAD: usize = 4;
/// Rounds at least, so that most forces are added while others are computed.
const ROUNDS: usize = 2;

/// What the couples of a step see.
#[derive(Clone, Copy)]
pub(super) struct Step<'a> {
    pub bodies: &'a Bodies,
    /// Velocities of the nodes, m/s.
    pub velocities: &'a [Vec2],
    pub pairs: &'a PairTable,
    pub dt: f64,
    pub buffer: f64,
    /// Path of the fastest node since the list was made, m, and the part of the last step.
    pub path: f64,
    pub advance: f64,
    pub rests: bool,
    /// Evaluations before this one.
    pub evaluation: u32,
}

/// The turn of an evaluation.
#[inline(always)]
pub(super) fn turn(evaluation: u32) -> u16 {
    (evaluation / TURN) as u16
}

impl Step<'_> {
    /// Whether a couple may be asked again whether it can rest.
    #[inline(always)]
    pub fn may_ask(&self, respites: &RespitesMut<'_>, index: usize) -> bool {
        is_due(respites.ask[index], turn(self.evaluation))
    }

    /// Path up to which a couple rests that may do so while no node moves further than `free`;
    /// none if that is not worth it for some steps or not resolved by the sum of the path.
    #[inline(always)]
    pub(super) fn rest(&self, free: f64) -> Option<f32> {
        (free > WORTHWHILE_STEPS * self.advance && free > 1e-9 * self.path)
            .then_some(rounded_down(self.path + free))
    }

    /// Square of the distance beyond which a couple is dropped, m².
    pub fn drop_distance_squared(&self) -> f64 {
        4.0 * self.buffer * self.buffer
    }

    /// Whether couples that did not touch are asked whether they can rest, those that may be.
    #[inline(always)]
    pub fn asks_all(&self) -> bool {
        self.evaluation.is_multiple_of(TURN)
    }

    #[inline(always)]
    pub fn bodies_of(&self, facing: Facing) -> [&Body; 2] {
        let places = facing.bodies();
        each!(2, |t| &self.bodies.bodies[places[t] as usize])
    }

    #[inline(always)]
    pub fn nodes_of(&self, bodies: [u32; 2]) -> [&[u32; 3]; 2] {
        each!(2, |t| &self.bodies.corners[bodies[t] as usize])
    }

    /// Finds out for how long a couple without effect can be left alone.
    #[cold]
    #[inline(never)]
    pub fn ask(&self, facing: &mut Facing, respites: &mut RespitesMut<'_>, index: usize) {
        let nodes = self.nodes_of(facing.bodies());
        let corners = self.bodies_of(*facing).map(Body::corners);
        let Clearance { rest, stay } = clearance(nodes, &corners, self.buffer);
        if let Some(path) = self.rest(rest) {
            respites.rest[index] = path;
        } else {
            let patience = if rest == 0.0 { PATIENCE_TOUCHING } else { PATIENCE };
            respites.ask[index] = turn(self.evaluation).wrapping_add(patience);
        }
        if let Some(path) = self.rest(stay) {
            respites.stay[index] = path;
        }
        self.face(facing, respites, index);
    }

    /// The same for a couple whose facing edges did not tell that it has none; `slot` deals out the
    /// work evenly, whoever does it and after whichever checkpoint.
    #[inline(always)]
    pub fn ask_later(
        &self,
        slot: u32,
        facing: &mut Facing,
        respites: &mut RespitesMut<'_>,
        index: usize,
    ) {
        if self.may_ask(respites, index) {
            self.ask(facing, respites, index);
        } else if self.evaluation.wrapping_add(slot).is_multiple_of(PATIENCE_FACING) {
            self.face(facing, respites, index);
        }
    }

    /// Chooses the edges that face each other.
    #[cold]
    #[inline(never)]
    fn face(&self, facing: &mut Facing, respites: &mut RespitesMut<'_>, index: usize) {
        let nodes = self.nodes_of(facing.bodies());
        let corners = self.bodies_of(*facing).map(Body::corners);
        respites.face[index] = 0.0;
        let Some(faces) = faces(nodes, &corners) else { return };
        *facing = facing.with_edges(faces.edges);
        respites.limit[index] = rounded_down(faces.limit);
        if let Some(path) = self.rest(faces.reach) {
            respites.face[index] = path.min(respites.stay[index]);
        }
    }

    /// Whether a couple of which no edge is cut is dropped.
    #[cold]
    #[inline(never)]
    pub fn is_beyond(&self, facing: Facing) -> bool {
        let [target, contactor] = self.bodies_of(facing).map(Body::shape);
        let shapes = [&target, &contactor];
        Placement::new(shapes).is_beyond(shapes, self.drop_distance_squared())
    }
}

/// All couples in the order of the list.
pub(super) struct Couples<'a> {
    pub visits: &'a mut [Visit],
    /// Their places among the bodies, and their facing edges.
    pub facing: &'a mut [Facing],
    pub respites: &'a mut Respites,
    pub sliding: &'a mut Sliding,
    pub chains: &'a mut Chains,
    /// Takes the places of those that came apart.
    pub dropped: &'a mut Vec<u32>,
}

/// Some couples in the order of the list, while they are evaluated.
pub(super) struct Part<'a> {
    pub visits: &'a [Visit],
    pub facing: &'a mut [Facing],
    pub respites: RespitesMut<'a>,
    pub sliding: &'a Sliding,
}

impl Couples<'_> {
    /// So many couples each, from `first` to before `end`.
    fn parts(&mut self, first: usize, end: usize, size: usize) -> impl Iterator<Item = Part<'_>> {
        let Self { visits, facing, respites, sliding, .. } = self;
        let respites = respites.range_mut(first..end).chunks(size);
        let facing = facing[first..end].chunks_mut(size);
        let sliding = &**sliding;
        visits[first..end]
            .chunks(size)
            .zip(facing)
            .zip(respites)
            .map(move |((visits, facing), respites)| Part { visits, facing, respites, sliding })
    }

    /// Takes over what became of the couples of a chunk, of which the first has the place `first`.
    fn take_over(&mut self, chunk: &Chunk, first: usize) {
        chunk.keep_sliding(&mut self.visits[first..], self.sliding);
        self.dropped.extend(chunk.dropped().iter().map(|&couple| first as u32 + couple));
    }
}

/// What a thread does at a time.
enum Task<'a, 'b> {
    /// Adds the forces of some chunks.
    Scatter(&'b [Chunk], &'b mut [Vec2]),
    /// Evaluates some couples.
    Evaluate(Part<'a>, &'b mut Chunk),
}

/// Buffers reused from step to step: while the couples of one bank are evaluated, those of the other
/// add their forces.
#[derive(Debug, Clone, Default)]
pub(super) struct Evaluator {
    banks: [Vec<Chunk>; 2],
}

impl Evaluator {
    /// Evaluates the couples and adds their forces, in the order of the list; how many of them
    /// had to be evaluated.
    pub fn evaluate(
        &mut self,
        step: &Step<'_>,
        couples: &mut Couples<'_>,
        forces: &mut [Vec2],
        team: &Team,
    ) -> u64 {
        if team.size() > 1 && couples.visits.len() >= PARALLEL_FROM {
            self.evaluate_on(team, step, couples, forces)
        } else {
            self.evaluate_alone(step, couples, forces)
        }
    }

    fn evaluate_alone(
        &mut self,
        step: &Step<'_>,
        couples: &mut Couples<'_>,
        forces: &mut [Vec2],
    ) -> u64 {
        let [bank, _] = &mut self.banks;
        let chunk = &mut room_for(bank, 1)[0];
        let mut evaluated = 0;
        let count = couples.visits.len();
        for first in (0..count).step_by(CHUNK) {
            let end = count.min(first + CHUNK);
            for part in couples.parts(first, end, CHUNK) {
                chunk.evaluate(step, part);
            }
            couples.take_over(chunk, first);
            chunk.scatter(step, forces);
            evaluated += chunk.evaluated();
        }
        evaluated
    }

    /// Round by round, so that what couples exert needs little memory.
    fn evaluate_on(
        &mut self,
        team: &Team,
        step: &Step<'_>,
        couples: &mut Couples<'_>,
        forces: &mut [Vec2],
    ) -> u64 {
        let scatter = |chunks: &[Chunk], forces: &mut [Vec2]| {
            chunks.iter().for_each(|chunk| chunk.scatter(step, forces));
        };
        let work = |task: Task<'_, '_>| match task {
            Task::Scatter(chunks, forces) => scatter(chunks, forces),
            Task::Evaluate(couples, chunk) => chunk.evaluate(step, couples),
        };
        let mut evaluated = 0;
        // how many of the other bank have not added their forces yet
        let mut waiting = 0;
        let count = couples.visits.len();
        let in_a_round = team.size() * CHUNKS_PER_THREAD;
        let chunk = count.div_ceil(ROUNDS * in_a_round).clamp(LEAST_CHUNK, CHUNK);
        for first in (0..count).step_by(in_a_round * chunk) {
            let end = count.min(first + in_a_round * chunk);
            let [bank, other] = &mut self.banks;
            let chunks = (end - first).div_ceil(chunk);
            let bank = room_for(bank, chunks);
            let parts = couples.parts(first, end, chunk).zip(&mut *bank);
            let tasks = parts.map(|(part, chunk)| Task::Evaluate(part, chunk));
            team.share(once(Task::Scatter(&other[..waiting], forces)).chain(tasks), work);
            for (chunk_of_bank, first) in bank.iter().zip((first..end).step_by(chunk)) {
                couples.take_over(chunk_of_bank, first);
                evaluated += chunk_of_bank.evaluated();
            }
            waiting = chunks;
            self.banks.swap(0, 1);
        }
        scatter(&self.banks[1][..waiting], forces);
        evaluated
    }
}

/// The first chunks of a bank, with all the room that they can need.
fn room_for(bank: &mut Vec<Chunk>, chunks: usize) -> &mut [Chunk] {
    if bank.len() < chunks {
        bank.resize_with(chunks, || Chunk::with_room_for(CHUNK));
    }
    &mut bank[..chunks]
}
