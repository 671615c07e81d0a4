//! The couples in the order of their evaluation, with the shapes of the
//! elements that they need.

use super::{bodies::Bodies, couples::CoupleList, evaluation::Couples, friction::PairTable};
use crate::scene::Elements;
use serde::{Deserialize, Serialize};

/// No place in the list.
const NOWHERE: u32 = u32::MAX;

/// What is known of a couple as long as it lasts.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Traits {
    /// Index of the couple's contact properties.
    pub pair: u32,
    /// Whether its triangles have a node in common.
    pub shares_node: bool,
}

/// A couple in the order of evaluation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Visit {
    /// Sliding accumulated on the edges of target and contactor, m²: lent by
    /// the couple's slot until the list is made anew or the couple is dropped.
    pub sliding: [f64; 6],
    /// Rank of the pair of materials in the order of visits.
    pub rank: u32,
    pub traits: Traits,
    /// Whether the couple came apart in this step.
    pub is_dropped: bool,
    pub contactor: u32,
    pub target: u32,
    pub slot: u32,
    /// Places in the list of the couples before and after this one in the chain
    /// of its contactor, [`NOWHERE`] if there are none.
    before: u32,
    after: u32,
    /// Order of listing: by contactor, then newest first.
    listed: u32,
}

#[cfg(test)]
impl Visit {
    /// A couple of these elements with some sliding.
    pub fn between([target, contactor]: [u32; 2], sliding: [f64; 6]) -> Self {
        Self {
            sliding,
            rank: 0,
            traits: Traits::default(),
            is_dropped: false,
            contactor,
            target,
            slot: 0,
            before: NOWHERE,
            after: NOWHERE,
            listed: 0,
        }
    }
}

/// How long couples can be left alone, in the order of the list. Paths are those of the fastest
/// node since the start: no node has moved further.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Respites {
    /// Path up to which the couple provably has no effect, m.
    pub rest: Vec<f64>,
    /// Path up to which it provably is not dropped, m.
    pub stay: Vec<f64>,
    /// Evaluation from which on it may be asked again whether it can rest.
    pub ask: Vec<f64>,
    /// Edges cut in the last evaluation, a bit each.
    pub edges: Vec<u8>,
    /// Bits of the edges that separate the triangles.
    pub separators: Vec<u8>,
}

impl Respites {
    /// Whether they are those of so many couples.
    pub fn is_of(&self, couples: usize) -> bool {
        let paths = [&self.rest, &self.stay, &self.ask];
        paths.into_iter().all(|values| values.len() == couples)
            && [&self.edges, &self.separators].into_iter().all(|bits| bits.len() == couples)
    }

    /// All of them.
    pub fn as_mut(&mut self) -> RespitesMut<'_> {
        let Self { rest, stay, ask, edges, separators } = self;
        RespitesMut { rest, stay, ask, edges, separators }
    }

    fn clear(&mut self) {
        self.rest.clear();
        self.stay.clear();
        self.ask.clear();
        self.edges.clear();
        self.separators.clear();
    }

    fn push(&mut self, rest: f64) {
        self.rest.push(rest);
        self.stay.push(0.0);
        self.ask.push(0.0);
        self.edges.push(0);
        self.separators.push(0);
    }

    /// Keeps the couples for which `keep` holds.
    fn retain(&mut self, keep: impl Fn(usize) -> bool) {
        fn retain<T>(values: &mut Vec<T>, keep: impl Fn(usize) -> bool) {
            let mut index = 0..;
            values.retain(|_| index.next().is_some_and(&keep));
        }
        retain(&mut self.rest, &keep);
        retain(&mut self.stay, &keep);
        retain(&mut self.ask, &keep);
        retain(&mut self.edges, &keep);
        retain(&mut self.separators, &keep);
    }
}

/// [`Respites`] of some couples in a row.
pub(super) struct RespitesMut<'a> {
    pub rest: &'a mut [f64],
    pub stay: &'a mut [f64],
    pub ask: &'a mut [f64],
    pub edges: &'a mut [u8],
    pub separators: &'a mut [u8],
}

/// Parts of the arrays of [`RespitesMut`], as zipped iterators give them.
type Zipped<'a> = ((&'a mut [f64], &'a mut [f64]), (&'a mut [f64], (&'a mut [u8], &'a mut [u8])));

impl<'a> RespitesMut<'a> {
    fn zipped(((rest, stay), (ask, (edges, separators))): Zipped<'a>) -> Self {
        Self { rest, stay, ask, edges, separators }
    }

    /// Those of so many couples each.
    pub fn chunks(self, size: usize) -> impl Iterator<Item = RespitesMut<'a>> + Send {
        let paths = self.rest.chunks_mut(size).zip(self.stay.chunks_mut(size));
        let bits = self.edges.chunks_mut(size).zip(self.separators.chunks_mut(size));
        let others = self.ask.chunks_mut(size).zip(bits);
        paths.zip(others).map(Self::zipped)
    }
}

/// All couples, and the elements that take part in one.
#[derive(Debug, Clone, Default)]
pub(super) struct Visits {
    pub list: Vec<Visit>,
    /// Places of target and contactor of each couple among the participants.
    pub participants: Vec<[u32; 2]>,
    /// How long each couple of the list can be left alone.
    pub respites: Respites,
    pub bodies: Bodies,
    /// Couples in the order of listing.
    order: Vec<u32>,
}

/// Takes a couple that comes apart out of its chain. As in the original the
/// next couple of the chain loses its last sliding.
pub(super) fn unlink(list: &mut [Visit], index: usize) {
    let (before, after) = (list[index].before, list[index].after);
    if let Some(visit) = list.get_mut(after as usize) {
        visit.sliding[5] = 0.0;
        visit.before = before;
    }
    if let Some(visit) = list.get_mut(before as usize) {
        visit.after = after;
    }
}

impl Visits {
    /// The participants and all couples.
    pub fn couples(&mut self) -> (&Bodies, Couples<'_>) {
        let Self { list, participants, respites, bodies, .. } = self;
        (bodies, Couples { visits: list, participants, respites: respites.as_mut() })
    }

    /// Gives sliding and rest of all couples back to their slots.
    pub fn store(&self, couples: &mut CoupleList) {
        for (visit, &rest) in self.list.iter().zip(&self.respites.rest) {
            *couples.sliding_mut(visit.slot) = visit.sliding;
            couples.set_rest(visit.slot, rest);
        }
    }

    /// Lists the couples anew: by material pair, then contactor, then newest
    /// first. What the old list holds must have been stored.
    pub fn sort(&mut self, couples: &CoupleList, pairs: &PairTable, elements: &Elements) {
        self.list.clear();
        self.bodies.clear(elements.len());
        for contactor in 0..elements.len() as u32 {
            for slot in couples.of(contactor) {
                let target = couples.target(slot);
                let property = |e: u32| elements.property[e as usize];
                let Some(rank) = pairs.rank(property(contactor), property(target)) else {
                    continue;
                };
                let corners = |e: u32| elements.corners::<3>(e as usize);
                let others = corners(target);
                let traits = Traits {
                    pair: pairs.along_fracture(elements, contactor, target).unwrap_or(rank),
                    shares_node: corners(contactor).iter().any(|node| others.contains(node)),
                };
                let visit = Visit {
                    sliding: *couples.sliding(slot),
                    rank,
                    traits,
                    is_dropped: false,
                    contactor,
                    target,
                    slot,
                    before: NOWHERE,
                    after: NOWHERE,
                    listed: self.list.len() as u32,
                };
                self.list.push(visit);
            }
        }
        // the order of listing as second key makes the sort stable, without the
        // buffer that a stable sort allocates
        self.list.sort_unstable_by_key(|visit| (visit.rank, visit.listed));
        self.respites.clear();
        self.participants.clear();
        for visit in &self.list {
            self.respites.push(couples.rest(visit.slot));
            let couple = [visit.target, visit.contactor];
            self.participants.push(couple.map(|e| self.bodies.place_of(e, elements)));
        }
    }

    /// Links the couples of each contactor in the order of their chain.
    pub fn link(&mut self) {
        for visit in &mut self.list {
            (visit.before, visit.after) = (NOWHERE, NOWHERE);
        }
        self.order.clear();
        self.order.extend(0..self.list.len() as u32);
        let list = &self.list;
        self.order.sort_unstable_by_key(|&index| list[index as usize].listed);
        for pair in 0..self.order.len().saturating_sub(1) {
            let (a, b) = (self.order[pair], self.order[pair + 1]);
            if self.list[a as usize].contactor == self.list[b as usize].contactor {
                self.list[a as usize].after = b;
                self.list[b as usize].before = a;
            }
        }
    }

    /// Removes the couples that came apart, in the order of evaluation: the
    /// slot freed last is the first to be used again.
    pub fn remove_dropped(&mut self, couples: &mut CoupleList) {
        for visit in self.list.iter().filter(|visit| visit.is_dropped) {
            *couples.sliding_mut(visit.slot) = visit.sliding;
            couples.remove(visit.contactor, visit.slot);
        }
        let list = &self.list;
        self.respites.retain(|index| !list[index].is_dropped);
        let mut places = list.iter();
        self.participants.retain(|_| places.next().is_some_and(|visit| !visit.is_dropped));
        self.list.retain(|visit| !visit.is_dropped);
    }
}
