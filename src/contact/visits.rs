//! The couples in the order of their evaluation, with the shapes of the
//! elements that they need.

use super::{
    couples::CoupleList,
    friction::PairTable,
    placement::{Motion, Shape},
};
use crate::scene::Elements;

/// No place among the participants.
const NOWHERE: u32 = u32::MAX;

/// A couple in the order of evaluation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Visit {
    /// Path length up to which the couple rests, m.
    pub rest: f64,
    /// Sliding accumulated on the edges of target and contactor, m²: lent by
    /// the couple's slot until the list is made anew or the couple is dropped.
    pub sliding: [f64; 6],
    /// Rank of the pair of materials.
    pub rank: u32,
    /// Places of target and contactor among the participants.
    pub participants: [u32; 2],
    /// Evaluations to go before it is asked again whether the couple may rest.
    pub patience: u8,
    /// Whether the couple came apart in this step.
    pub is_dropped: bool,
    contactor: u32,
    slot: u32,
    /// Order of listing: by contactor, then newest first.
    listed: u32,
}

/// All couples, and the elements that take part in one.
#[derive(Debug, Clone, Default)]
pub(super) struct Visits {
    pub list: Vec<Visit>,
    /// Corner nodes of the participants.
    pub corners: Vec<[u32; 3]>,
    /// Present shapes of the participants.
    pub shapes: Vec<Shape>,
    /// Present velocities of the participants' corners.
    pub motions: Vec<Motion>,
    /// Place of each element among the participants.
    place: Vec<u32>,
}

impl Visits {
    /// Gives sliding and rest of all couples back to their slots.
    pub fn store(&self, couples: &mut CoupleList) {
        for visit in &self.list {
            *couples.sliding_mut(visit.slot) = visit.sliding;
            couples.set_rest(visit.slot, visit.rest);
        }
    }

    /// Lists the couples anew: by material pair, then contactor, then newest
    /// first. What the old list holds must have been stored.
    pub fn sort(&mut self, couples: &CoupleList, pairs: &PairTable, elements: &Elements) {
        self.list.clear();
        self.corners.clear();
        self.place.clear();
        self.place.resize(elements.len(), NOWHERE);
        for contactor in 0..elements.len() as u32 {
            for slot in couples.of(contactor) {
                let target = couples.target(slot);
                let property = |e: u32| elements.property[e as usize];
                let Some(rank) = pairs.rank(property(contactor), property(target)) else {
                    continue;
                };
                let visit = Visit {
                    rest: couples.rest(slot),
                    sliding: *couples.sliding(slot),
                    rank,
                    participants: [target, contactor].map(|e| self.place_of(e, elements)),
                    patience: 0,
                    is_dropped: false,
                    contactor,
                    slot,
                    listed: self.list.len() as u32,
                };
                self.list.push(visit);
            }
        }
        // the order of listing as second key makes the sort stable, without the
        // buffer that a stable sort allocates
        self.list.sort_unstable_by_key(|visit| (visit.rank, visit.listed));
        self.shapes.resize(self.corners.len(), Shape::default());
        self.motions.resize(self.corners.len(), Motion::default());
    }

    fn place_of(&mut self, element: u32, elements: &Elements) -> u32 {
        let place = &mut self.place[element as usize];
        if *place == NOWHERE {
            *place = self.corners.len() as u32;
            self.corners.push(elements.corners::<3>(element as usize).map(|n| n as u32));
        }
        *place
    }

    /// Removes the couples that came apart, in the order of evaluation: the
    /// slot freed last is the first to be used again.
    pub fn remove_dropped(&mut self, couples: &mut CoupleList) {
        for visit in self.list.iter().filter(|visit| visit.is_dropped) {
            *couples.sliding_mut(visit.slot) = visit.sliding;
            couples.remove(visit.contactor, visit.slot);
        }
        self.list.retain(|visit| !visit.is_dropped);
    }
}
