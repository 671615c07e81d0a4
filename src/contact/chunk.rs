//! Evaluates some couples in a row, in passes, four couples at a time.
//!
//! 1. Couples that rest or certainly have no effect are passed over ([`super::certain`]).
//! 2. The others are sorted by the edges that they had to cut a step ago.
//! 3. Four that are alike are evaluated together ([`super::exertion`]).
//! 4. Forces are added in the order of the list.

use super::{
    bodies::Triangles,
    certain::{Separator, certainly_clear, certainly_separated},
    evaluation::{Couples, Done, Step},
    exertion::{Bench, CORNERS, Exertion, Quartet},
    places::{ALL, Places, quartet},
    visits::{RespitesMut, Traits},
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

impl Chunk {
    /// A chunk that can be used for so many couples.
    pub fn with_room_for(couples: usize) -> Self {
        let places = || Places::with_room_for(couples);
        Self {
            asked: places(),
            separated: places(),
            unsure: places(),
            close: places(),
            alike: vec![0; couples],
            traits: vec![Traits::default(); couples],
            exertions: vec![Exertion::default(); couples],
            done: Done::default(),
        }
    }

    /// What the last evaluation did.
    pub fn done(&self) -> Done {
        self.done
    }

    /// Evaluates couples: finds out what they exert.
    pub fn evaluate(&mut self, step: &Step<'_>, couples: Couples<'_>) {
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
    couples: Couples<'a>,
}

impl Kernel for Evaluation<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(mut self) {
        self.pass_over::<L>();
        self.chunk.done = Done { evaluated: self.chunk.asked.len() as u64, dropped: false };
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
        for at in (0..self.chunk.separated.len()).step_by(LANES) {
            let (of_lane, count) = quartet(&self.chunk.separated.get()[at..]);
            let participants = each!(4, |k| self.couples.participants[of_lane[k]]);
            self.try_separators::<L>(of_lane, &participants, (1 << count) - 1);
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
        chunk.unsure.push_those(of_lane, (!separated | due).bits() & valid);
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
        chunk.close.push_those(of_lane, valid & !clear);
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
            let (place, count) = quartet(places);
            let of_lane = each!(4, |k| asked[place[k]] as usize);
            let four = Quartet {
                couples: of_lane,
                participants: each!(4, |k| couples.participants[of_lane[k]]),
                traits: each!(4, |k| traits[place[k]]),
                count,
            };
            let edges = four.exert(step, couples.visits, &mut bench, place, exertions);
            for lane in 0..count {
                let couple = of_lane[lane];
                couples.respites.edges[couple] = edges[lane];
                if edges[lane] != 0 {
                    continue;
                }
                let participants = four.participants[lane];
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
