//! Evaluates the couples of a step, four at a time and on all threads where there are many.
//!
//! A chunk of couples goes through these passes: couples that rest or certainly have no effect
//! are passed over ([`certain`](super::certain)); the others are located exactly
//! ([`locate`](super::locate)); the edges that have to be cut are collected and cut
//! ([`edges`](super::edges)); the forces are added in the order of the list. Couples are
//! independent of each other but for that last pass, so that sums round the same on any number
//! of threads.

use super::{
    bodies::{Bodies, Body, Triangles},
    certain::certainly_clear,
    clearance::{Clearance, clearance},
    edges::Edges,
    friction::PairTable,
    locate::{Coordinates, locate},
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

    #[inline(always)]
    fn bodies_of(&self, participants: [u32; 2]) -> [&Body; 2] {
        each!(2, |t| &self.bodies.bodies[participants[t] as usize])
    }

    #[inline(always)]
    fn velocity(&self, node: u32) -> &[f64; 2] {
        &self.velocities[node as usize].data.0[0]
    }

    /// Finds out for how long a couple without effect can be left alone.
    #[cold]
    #[inline(never)]
    fn ask(&self, participants: [u32; 2], respites: &mut RespitesMut<'_>, index: usize) {
        let ids = participants.map(|p| &self.bodies.corners[p as usize]);
        let corners = self.bodies_of(participants).map(Body::corners);
        let Clearance { rest, stay } = clearance(ids, &corners, self.buffer);
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
        Placement::new(shapes).is_beyond(shapes, 4.0 * self.buffer * self.buffer)
    }
}

/// A couple with edges to cut.
#[derive(Debug, Clone, Copy, Default)]
struct Touch {
    participants: [u32; 2],
    /// Place in the chunk.
    couple: u32,
    /// Where its area coordinates are.
    block: u32,
    lane: u32,
    /// First cut that is not its own any more.
    end: u32,
}

/// An edge to cut: place of the couple among those that touch, and bit of the edge.
#[derive(Debug, Clone, Copy, Default)]
struct Cut {
    touch: u32,
    /// 0 to 2: edges of the target; 3 to 5: edges of the contactor.
    bit: u32,
}

/// What an edge exerts.
#[derive(Debug, Clone, Copy, Default)]
struct CutForces {
    /// What is subtracted from the forces on start and end, N: normal and tangential part.
    subtracted: [[f64; 4]; 2],
    /// Whether a piece of the edge lies inside.
    acts: bool,
}

/// Passes of a chunk of couples. Lists keep their length from step to step; the counts tell how
/// much of them is valid.
#[derive(Debug, Clone, Default)]
struct Chunk {
    counts: Counts,
    /// Couples to be located, by their place in the chunk.
    asked: Vec<u32>,
    /// Area coordinates of those that touch, four couples a block.
    coordinates: Vec<Coordinates>,
    touches: Vec<Touch>,
    cuts: Vec<Cut>,
    forces: Vec<CutForces>,
    done: Done,
}

/// Valid entries of a chunk's lists.
#[derive(Debug, Clone, Copy, Default)]
struct Counts {
    asked: usize,
    touches: usize,
    cuts: usize,
}

/// The couples of a chunk.
struct Couples<'a> {
    visits: &'a mut [Visit],
    participants: &'a [[u32; 2]],
    respites: RespitesMut<'a>,
}

/// Buffers reused from step to step.
#[derive(Debug, Clone, Default)]
pub(super) struct Evaluator {
    chunks: Vec<Chunk>,
}

impl Evaluator {
    /// Evaluates the couples and adds their forces, in the order of the list.
    pub fn evaluate(
        &mut self,
        step: &Step<'_>,
        list: &mut [Visit],
        participants: &[[u32; 2]],
        respites: RespitesMut<'_>,
        forces: &mut [Vec2],
    ) -> Done {
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
                chunk.scatter(&step.bodies.corners, forces);
                done = done.and(chunk.done);
            }
        } else {
            self.prepare(1, SERIAL_CHUNK);
            let chunk = &mut self.chunks[0];
            let lists = list.chunks_mut(SERIAL_CHUNK).zip(participants.chunks(SERIAL_CHUNK));
            for ((visits, participants), respites) in lists.zip(respites.chunks(SERIAL_CHUNK)) {
                chunk.evaluate(step, Couples { visits, participants, respites });
                chunk.scatter(&step.bodies.corners, forces);
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
            let blocks = size.div_ceil(LANES);
            if chunk.coordinates.len() < blocks {
                let couples = blocks * LANES;
                chunk.coordinates.resize(blocks, Coordinates::default());
                // one entry more than can be, so that lists grow without branches
                chunk.asked.resize(couples + 1, 0);
                chunk.touches.resize(couples + 1, Touch::default());
                chunk.cuts.resize(6 * couples + 1, Cut::default());
                chunk.forces.resize(6 * couples, CutForces::default());
            }
        }
    }
}

impl Chunk {
    fn evaluate(&mut self, step: &Step<'_>, couples: Couples<'_>) {
        lanes::run(Evaluation { chunk: self, step, couples });
    }

    /// Adds the forces in the order of the couples.
    fn scatter(&self, corners: &[[u32; 3]], forces: &mut [Vec2]) {
        let mut first = 0;
        for touch in &self.touches[..self.counts.touches] {
            let cuts = first..touch.end as usize;
            first = cuts.end;
            let coordinates = &self.coordinates[touch.block as usize];
            let nodes = each!(2, |t| &corners[touch.participants[t] as usize]);
            let cut_forces = self.cuts[cuts.clone()].iter().zip(&self.forces[cuts]);
            let mut own = [[[0.0; 2]; 3]; 2];
            let mut acts = [false; 2];
            for (cut, exerted) in cut_forces.filter(|(_, exerted)| exerted.acts) {
                let (side, start) = SIDE_AND_EDGE[cut.bit as usize];
                acts[side] = true;
                for (corner, [nx, ny, tx, ty]) in
                    [start, NEXT[start]].into_iter().zip(exerted.subtracted)
                {
                    let f = &mut own[side][corner];
                    *f = [f[0] - nx - tx, f[1] - ny - ty];
                }
            }
            for side in 0..2 {
                if acts[side] {
                    let lane = touch.lane as usize;
                    let shares = each!(3, |e| each!(3, |i| coordinates[side][e][i][lane]));
                    scatter_side(&own[side], &shares, nodes[side], nodes[1 - side], forces);
                }
            }
        }
    }
}

/// Side and number of the edge of a bit.
const SIDE_AND_EDGE: [(usize, usize); 6] = [(0, 0), (0, 1), (0, 2), (1, 0), (1, 1), (1, 2)];
/// The corner after each corner.
const NEXT: [usize; 3] = [1, 2, 0];

/// Adds the forces on the corners of a triangle and what the other bears of them, in the
/// original's order, which matters where the two triangles share a node.
#[inline(always)]
fn scatter_side(
    own: &[[f64; 2]; 3],
    shares: &[[f64; 3]; 3],
    nodes: &[u32; 3],
    others: &[u32; 3],
    forces: &mut [Vec2],
) {
    for i in 0..3 {
        let force = &mut forces[nodes[i] as usize];
        force.x += own[i][0];
        force.y += own[i][1];
        let force = &mut forces[others[i] as usize];
        let share = &shares[(i + 1) % 3];
        for m in 0..3 {
            force.x -= own[m][0] * share[m];
            force.y -= own[m][1] * share[m];
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
        self.locate_asked::<L>();
        self.cut_edges::<L>();
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

    /// Locates the listed couples: lists the edges to cut, drops couples that came apart.
    #[inline(always)]
    fn locate_asked<L: Lanes>(&mut self) {
        let Self { chunk, step, couples } = self;
        let (mut block, mut touches, mut cuts) = (0, 0, 0);
        for asked in chunk.asked[..chunk.counts.asked].chunks(LANES) {
            // a last block that is not full repeats its first couple
            let of_lane = each!(4, |k| asked[if k < asked.len() { k } else { 0 }] as usize);
            let participants = each!(4, |k| couples.participants[of_lane[k]]);
            let bodies = each!(4, |k| step.bodies_of(participants[k]));
            let target = Triangles::<L>::new(each!(4, |k| bodies[k][0]));
            let contactor = Triangles::new(each!(4, |k| bodies[k][1]));
            let edges = locate(&target, &contactor, &mut chunk.coordinates[block]);
            let touches_before = touches;
            for lane in 0..asked.len() {
                let (couple, edges) = (of_lane[lane], edges[lane]);
                for bit in 0..6 {
                    chunk.cuts[cuts] = Cut { touch: touches as u32, bit };
                    cuts += (edges >> bit & 1) as usize;
                }
                chunk.touches[touches] = Touch {
                    participants: participants[lane],
                    couple: couple as u32,
                    block: block as u32,
                    lane: lane as u32,
                    end: cuts as u32,
                };
                touches += usize::from(edges != 0);
                if edges == 0 {
                    if step.is_beyond(participants[lane]) {
                        couples.visits[couple].is_dropped = true;
                        chunk.done.dropped = true;
                    } else if step.rests && couples.respites.ask[couple] <= step.evaluation {
                        step.ask(participants[lane], &mut couples.respites, couple);
                    }
                }
            }
            block += usize::from(touches > touches_before);
        }
        (chunk.counts.touches, chunk.counts.cuts) = (touches, cuts);
    }

    /// Cuts the listed edges.
    #[inline(always)]
    fn cut_edges<L: Lanes>(&mut self) {
        let Self { chunk, step, couples } = self;
        let cuts = chunk.cuts[..chunk.counts.cuts].chunks(LANES);
        let exerted = chunk.forces[..chunk.counts.cuts].chunks_mut(LANES);
        for (cuts, exerted) in cuts.zip(exerted) {
            // as for couples: a last block that is not full repeats its first edge
            let sites = each!(4, |k| {
                let cut = &cuts[if k < cuts.len() { k } else { 0 }];
                Site::new(cut, &chunk.touches, &chunk.coordinates, step, couples.visits)
            });
            let forces = edges_at::<L>(&sites, step).forces(step.dt);
            let place = each!(4, |k| (sites[k].couple, sites[k].sliding_index));
            let acts = forces.acts.bits();
            let sliding = forces.sliding.array();
            let [start, end] = forces.subtracted;
            let (start, end) = (L::transpose(start), L::transpose(end));
            let (start, end) = (each!(4, |k| start[k].array()), each!(4, |k| end[k].array()));
            for (lane, exerted) in exerted.iter_mut().enumerate() {
                let (couple, index) = place[lane];
                couples.visits[couple].sliding[index] = sliding[lane];
                *exerted =
                    CutForces { subtracted: [start[lane], end[lane]], acts: acts >> lane & 1 == 1 };
            }
        }
    }
}

/// What is needed to cut an edge.
#[derive(Clone, Copy)]
struct Site<'a> {
    /// Area coordinates of the edge's triangle in the other one, of four couples.
    coordinates: &'a [[[f64; LANES]; 3]; 3],
    lane: usize,
    /// Corners at the edge's start and end.
    ends: [usize; 2],
    body: &'a Body,
    /// Nodes of the triangle and of the other one.
    nodes: [&'a [u32; 3]; 2],
    visit: &'a Visit,
    couple: usize,
    sliding_index: usize,
}

impl<'a> Site<'a> {
    #[inline(always)]
    fn new(
        cut: &Cut,
        touches: &[Touch],
        coordinates: &'a [Coordinates],
        step: &Step<'a>,
        visits: &'a [Visit],
    ) -> Self {
        let touch = &touches[cut.touch as usize];
        let (side, start) = SIDE_AND_EDGE[cut.bit as usize];
        let [own, other] = [touch.participants[side], touch.participants[1 - side]];
        Self {
            coordinates: &coordinates[touch.block as usize][side],
            lane: touch.lane as usize,
            ends: [start, NEXT[start]],
            body: &step.bodies.bodies[own as usize],
            nodes: [&step.bodies.corners[own as usize], &step.bodies.corners[other as usize]],
            visit: &visits[touch.couple as usize],
            couple: touch.couple as usize,
            sliding_index: cut.bit as usize,
        }
    }

    /// Area coordinates of an end of the edge.
    #[inline(always)]
    fn coordinate(&self, end: usize, e: usize) -> f64 {
        self.coordinates[e][self.ends[end]][self.lane]
    }

    #[inline(always)]
    fn corner(&self, end: usize) -> &[f64; 2] {
        self.body.corner(self.ends[end])
    }
}

/// Gathers four edges.
#[inline(always)]
fn edges_at<L: Lanes>(s: &[Site<'_>; LANES], step: &Step<'_>) -> Edges<L> {
    let [start_x, start_y] = L::pairs(each!(4, |k| s[k].corner(0)));
    let [end_x, end_y] = L::pairs(each!(4, |k| s[k].corner(1)));
    let pairs = each!(4, |k| s[k].visit.pair);
    let first = step.pairs.properties(pairs[0]);
    let (penalty, tangential_penalty, friction);
    if pairs == [pairs[0]; LANES] {
        penalty = L::splat(first.penalty);
        tangential_penalty = L::splat(first.tangential_penalty);
        friction = L::splat(first.friction);
    } else {
        let of = each!(4, |k| step.pairs.properties(pairs[k]));
        penalty = L::new(each!(4, |k| of[k].penalty));
        tangential_penalty = L::new(each!(4, |k| of[k].tangential_penalty));
        friction = L::new(each!(4, |k| of[k].friction));
    }
    Edges {
        start: each!(3, |e| L::new(each!(4, |k| s[k].coordinate(0, e)))),
        end: each!(3, |e| L::new(each!(4, |k| s[k].coordinate(1, e)))),
        normal: [end_y - start_y, start_x - end_x],
        velocity: each!(2, |end| L::pairs(each!(4, |k| {
            step.velocity(s[k].nodes[0][s[k].ends[end]])
        }))),
        other_velocity: each!(3, |i| L::pairs(each!(4, |k| step.velocity(s[k].nodes[1][i])))),
        sliding: L::new(each!(4, |k| s[k].visit.sliding[s[k].sliding_index])),
        penalty,
        tangential_penalty,
        friction,
    }
}

/// Four numbers from one on.
#[inline(always)]
fn lanes_at<L: Lanes>(values: &[f64], first: usize) -> L {
    L::load(&values[first..].as_chunks().0[0])
}
