//! The couples in the order of their evaluation, with the shapes of the
//! elements that they need.

use super::{
    bodies::Bodies,
    couples::CoupleList,
    evaluation::Couples,
    facing::Facing,
    friction::PairTable,
    respites::{Respites, rounded_down},
    sliding::{RowPlace, Sliding, SlidingRow},
};
use crate::scene::Elements;
use serde::{Deserialize, Serialize};

/// No place in the list.
const NOWHERE: u32 = u32::MAX;

/// What a slot keeps of its couple from one list to the next.
#[derive(Debug, Clone, Copy, Default, Serialize, Deserialize)]
pub struct Kept {
    /// Its sliding.
    pub(super) sliding: RowPlace,
    /// Path from the list's making up to which it provably has no effect, m.
    pub(super) rest: f32,
}

/// What is known of a couple as long as it lasts.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Traits(u32);

impl Traits {
    const SHARES_NODE: u32 = 1 << 31;
    const IS_INSIDE: u32 = 1 << 30;

    /// Those of a couple with the contact properties of this index.
    pub fn new(pair: u32, shares_node: bool, is_inside: bool) -> Self {
        let mut bits = pair;
        if shares_node {
            bits |= Self::SHARES_NODE;
        }
        if is_inside {
            bits |= Self::IS_INSIDE;
        }
        Self(bits)
    }

    /// Index of the couple's contact properties.
    #[inline(always)]
    pub fn pair(self) -> u32 {
        self.0 & !(Self::SHARES_NODE | Self::IS_INSIDE)
    }

    /// Whether its triangles have a node in common.
    #[inline(always)]
    pub fn shares_node(self) -> bool {
        self.0 & Self::SHARES_NODE != 0
    }

    /// Whether its triangles are of one material.
    pub fn is_inside(self) -> bool {
        self.0 & Self::IS_INSIDE != 0
    }
}

/// A couple in the order of evaluation.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Visit {
    /// Its slot in the list of couples.
    pub slot: u32,
    pub sliding: RowPlace,
    pub traits: Traits,
}

/// Places in the list of the couples before and after a couple in the chain of its contactor,
/// [`NOWHERE`] if there are none.
#[derive(Debug, Clone, Copy)]
struct Link {
    before: u32,
    after: u32,
}

/// Chains of the couples of each contactor; empty where they do not matter.
#[derive(Debug, Clone, Default)]
pub(super) struct Chains(Vec<Link>);

impl Chains {
    /// Takes a couple that comes apart out of its chain. As in the original the
    /// next couple of the chain loses its last sliding.
    pub fn unlink(&mut self, list: &mut [Visit], sliding: &mut Sliding, index: usize) {
        let Some(&Link { before, after }) = self.0.get(index) else { return };
        if let Some(link) = self.0.get_mut(after as usize) {
            link.before = before;
            let visit = &mut list[after as usize];
            let mut row: SlidingRow = *sliding.of(visit.sliding);
            row[5] = 0.0;
            sliding.keep(&mut visit.sliding, &row);
        }
        if let Some(link) = self.0.get_mut(before as usize) {
            link.after = after;
        }
    }

    /// Forgets couples, which are in no chain any more. Their places ascend.
    fn remove(&mut self, removed: &[u32]) {
        let moved = |place: u32| {
            if place == NOWHERE {
                return NOWHERE;
            }
            place - removed.partition_point(|&gone| gone < place) as u32
        };
        let mut index = 0..;
        self.0.retain(|_| index.next().is_some_and(|i| removed.binary_search(&i).is_err()));
        for Link { before, after } in &mut self.0 {
            (*before, *after) = (moved(*before), moved(*after));
        }
    }
}

/// All couples, and the elements that take part in one.
#[derive(Debug, Clone, Default)]
pub(super) struct Visits {
    pub list: Vec<Visit>,
    /// Places of target and contactor of each couple among the bodies, and the edges of theirs that
    /// face each other.
    pub facing: Vec<Facing>,
    /// How long each couple of the list can be left alone.
    pub respites: Respites,
    pub bodies: Bodies,
    pub sliding: Sliding,
    pub chains: Chains,
    /// Places in the list of couples that came apart in this step, ascending.
    pub dropped: Vec<u32>,
    /// Where the next couple of each pair of materials is listed.
    places: Vec<u32>,
}

impl Visits {
    /// The participants and all couples.
    pub fn couples(&mut self) -> (&Bodies, Couples<'_>) {
        let Self { list, facing, respites, bodies, sliding, chains, dropped, .. } = self;
        (bodies, Couples { visits: list, facing, respites, sliding, chains, dropped })
    }

    /// Gives sliding and rest of all couples back to their slots; `path` is that of the fastest node
    /// since the list was made, m.
    pub fn store(&self, path: f64, couples: &mut CoupleList<Kept>) {
        for (visit, &rest) in self.list.iter().zip(&self.respites.rest) {
            let rest = rounded_down((f64::from(rest) - path).max(0.0));
            *couples.kept_mut(visit.slot) = Kept { sliding: visit.sliding, rest };
        }
    }

    /// Lists the couples anew: by material pair, then contactor, then newest
    /// first. What the old list holds must have been stored. They may be asked in this turn
    /// whether they can rest.
    pub fn sort(
        &mut self,
        couples: &CoupleList<Kept>,
        pairs: &PairTable,
        elements: &Elements,
        are_chained: bool,
        turn: u16,
    ) {
        let property = |e: u32| elements.property[e as usize];
        let contactors = 0..elements.len() as u32;
        // contactor, slot, target and rank of each couple, in the order of listing
        let listed = contactors.flat_map(|contactor| {
            couples.of(contactor).filter_map(move |slot| {
                let target = couples.target(slot);
                let rank = pairs.rank(property(contactor), property(target))?;
                Some((contactor, slot, target, rank))
            })
        });
        self.places.clear();
        self.places.resize(pairs.ranks(), 0);
        for (.., rank) in listed.clone() {
            self.places[rank as usize] += 1;
        }
        let mut count = 0;
        for place in &mut self.places {
            (*place, count) = (count, count + *place);
        }
        let count = count as usize;
        self.list.resize(count, Visit::default());
        self.facing.resize(count, Facing::default());
        self.respites.reset(count, turn);
        self.dropped.clear();
        self.dropped.reserve(count);
        self.sliding.reserve(couples.slots());
        self.chains.0.clear();
        if are_chained {
            self.chains.0.resize(count, Link { before: NOWHERE, after: NOWHERE });
        }
        let corners = |e: u32| elements.corners::<3>(e as usize);
        let mut last = (NOWHERE, NOWHERE);
        for (contactor, slot, target, rank) in listed {
            let place = self.places[rank as usize];
            self.places[rank as usize] += 1;
            let others = corners(target);
            let traits = Traits::new(
                pairs.along_fracture(elements, contactor, target).unwrap_or(rank),
                corners(contactor).iter().any(|node| others.contains(node)),
                pairs.is_inside(rank),
            );
            let Kept { sliding, rest } = *couples.kept(slot);
            self.list[place as usize] = Visit { slot, sliding, traits };
            self.respites.rest[place as usize] = rest;
            self.facing[place as usize] = Facing::between([target, contactor]);
            if are_chained {
                let before = if last.0 == contactor { last.1 } else { NOWHERE };
                self.chains.0[place as usize].before = before;
                if let Some(link) = self.chains.0.get_mut(before as usize) {
                    link.after = place;
                }
                last = (contactor, place);
            }
        }
        self.bodies.clear(elements.len());
        for facing in &mut self.facing {
            let elements_of = facing.bodies();
            *facing = Facing::between(elements_of.map(|e| self.bodies.place_of(e, elements)));
        }
    }

    /// Removes the couples that came apart, in the order of evaluation: the
    /// slot freed last is the first to be used again.
    pub fn remove_dropped(&mut self, couples: &mut CoupleList<Kept>) {
        let Self { list, facing, respites, bodies, chains, dropped, .. } = self;
        for &place in &*dropped {
            let visit = &list[place as usize];
            couples.kept_mut(visit.slot).sliding = visit.sliding;
            let [_, contactor] = facing[place as usize].bodies();
            couples.remove(bodies.elements[contactor as usize], visit.slot);
        }
        let is_kept = |place: usize| dropped.binary_search(&(place as u32)).is_err();
        respites.retain(is_kept);
        let mut places = 0..;
        facing.retain(|_| places.next().is_some_and(is_kept));
        let mut places = 0..;
        list.retain(|_| places.next().is_some_and(is_kept));
        chains.remove(dropped);
        dropped.clear();
    }
}
