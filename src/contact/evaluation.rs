//! Evaluates the couples of a step, on all threads where there are many.
//!
//! Couples are independent of each other but for the sums of their forces, which are made in the
//! order of the list: they round the same on any number of threads.

use super::{
    bodies::{Bodies, Body},
    certain::Separator,
    chunk::Chunk,
    clearance::{Clearance, clearance},
    friction::PairTable,
    placement::Placement,
    visits::{RespitesMut, Visit},
};
use crate::{lanes::each, mechanics::Vec2, team::Team};
use std::iter::once;

/// A couple that could not be let rest is asked again after so many evaluations.
const PATIENCE: f64 = 64.0;
/// The same for a couple that touches at a point, as bonded neighbours do.
const PATIENCE_TOUCHING: f64 = 512.0;

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
    pub fn ask(&self, participants: [u32; 2], respites: &mut RespitesMut<'_>, index: usize) {
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
    pub fn is_beyond(&self, participants: [u32; 2]) -> bool {
        let [target, contactor] = self.bodies_of(participants).map(Body::shape);
        let shapes = [&target, &contactor];
        Placement::new(shapes).is_beyond(shapes, self.drop_distance_squared())
    }
}

/// Some couples in the order of the list.
pub(super) struct Couples<'a> {
    pub visits: &'a mut [Visit],
    /// Their places among the bodies.
    pub participants: &'a [[u32; 2]],
    pub respites: RespitesMut<'a>,
}

impl<'a> Couples<'a> {
    /// So many couples each.
    fn chunks(self, size: usize) -> impl Iterator<Item = Couples<'a>> + Send {
        let lists = self.visits.chunks_mut(size).zip(self.participants.chunks(size));
        lists.zip(self.respites.chunks(size)).map(|((visits, participants), respites)| Couples {
            visits,
            participants,
            respites,
        })
    }
}

/// What a thread does at a time.
enum Task<'a, 'b> {
    /// Adds the forces of some chunks.
    Scatter(&'b [Chunk], &'b mut [Vec2]),
    /// Evaluates some couples.
    Evaluate(Couples<'a>, &'b mut Chunk),
}

/// Buffers reused from step to step: while the couples of one bank are evaluated, those of the other
/// add their forces.
#[derive(Debug, Clone, Default)]
pub(super) struct Evaluator {
    banks: [Vec<Chunk>; 2],
}

impl Evaluator {
    /// Evaluates the couples and adds their forces, in the order of the list.
    pub fn evaluate(
        &mut self,
        step: &Step<'_>,
        couples: Couples<'_>,
        forces: &mut [Vec2],
        team: &Team,
    ) -> Done {
        if team.size() > 1 && couples.visits.len() >= PARALLEL_FROM {
            self.evaluate_on(team, step, couples, forces)
        } else {
            self.evaluate_alone(step, couples, forces)
        }
    }

    fn evaluate_alone(
        &mut self,
        step: &Step<'_>,
        couples: Couples<'_>,
        forces: &mut [Vec2],
    ) -> Done {
        let [bank, _] = &mut self.banks;
        let chunk = &mut room_for(bank, 1)[0];
        let mut done = Done::default();
        for couples in couples.chunks(CHUNK) {
            chunk.evaluate(step, couples);
            chunk.scatter(step, forces);
            done = done.and(chunk.done());
        }
        done
    }

    /// Round by round, so that what couples exert needs little memory.
    fn evaluate_on(
        &mut self,
        team: &Team,
        step: &Step<'_>,
        couples: Couples<'_>,
        forces: &mut [Vec2],
    ) -> Done {
        let mut done = Done::default();
        let scatter = |chunks: &[Chunk], forces: &mut [Vec2]| {
            chunks.iter().for_each(|chunk| chunk.scatter(step, forces));
        };
        let work = |task: Task<'_, '_>| match task {
            Task::Scatter(chunks, forces) => scatter(chunks, forces),
            Task::Evaluate(couples, chunk) => chunk.evaluate(step, couples),
        };
        // how many of the other bank have not added their forces yet
        let mut waiting = 0;
        let in_a_round = team.size() * CHUNKS_PER_THREAD;
        let chunk = couples.visits.len().div_ceil(ROUNDS * in_a_round).clamp(LEAST_CHUNK, CHUNK);
        for round in couples.chunks(in_a_round * chunk) {
            let [bank, other] = &mut self.banks;
            let chunks = round.visits.len().div_ceil(chunk);
            let bank = room_for(bank, chunks);
            let pairs = round.chunks(chunk).zip(&mut *bank);
            let tasks = pairs.map(|(couples, chunk)| Task::Evaluate(couples, chunk));
            team.share(once(Task::Scatter(&other[..waiting], forces)).chain(tasks), work);
            done = bank.iter().fold(done, |done, chunk| done.and(chunk.done()));
            waiting = chunks;
            self.banks.swap(0, 1);
        }
        scatter(&self.banks[1][..waiting], forces);
        done
    }
}

/// The first chunks of a bank, with all the room that they can need.
fn room_for(bank: &mut Vec<Chunk>, chunks: usize) -> &mut [Chunk] {
    if bank.len() < chunks {
        bank.resize_with(chunks, || Chunk::with_room_for(CHUNK));
    }
    &mut bank[..chunks]
}
