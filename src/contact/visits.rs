//! The couples in the order of their evaluation, with the shapes of the
//! elements that they need.

use super::{couples::CoupleList, friction::PairTable, placement::Shape};
use crate::scene::Elements;

/// Slot of a visit whose couple has been removed since the last sorting.
const REMOVED: u32 = u32::MAX;
/// No place among the participants.
const NOWHERE: u32 = u32::MAX;

/// A couple in the order of evaluation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Visit {
    /// Path length up to which the couple rests, m.
    pub rest: f64,
    /// Rank of the pair of materials.
    pub rank: u32,
    /// Slot of the couple; `REMOVED` once it is dropped.
    pub slot: u32,
    pub contactor: u32,
    /// Order of listing: by contactor, then newest first.
    listed: u32,
    /// Places of target and contactor among the participants.
    pub participants: [u32; 2],
    /// Evaluations to go before it is asked again whether the couple may rest.
    pub patience: u8,
}

impl Visit {
    /// Marks the couple as dropped.
    pub fn drop_couple(&mut self) {
        self.slot = REMOVED;
    }
}

/// All couples, and the elements that take part in one.
#[derive(Debug, Clone, Default)]
pub(super) struct Visits {
    pub list: Vec<Visit>,
    /// Corner nodes of the participants.
    pub corners: Vec<[u32; 3]>,
    /// Present shapes of the participants.
    pub shapes: Vec<Shape>,
    /// Place of each element among the participants.
    place: Vec<u32>,
}

impl Visits {
    /// Orders the couples: by material pair, then contactor, then newest first.
    pub fn sort(&mut self, couples: &CoupleList, pairs: &PairTable, elements: &Elements) {
        self.list.clear();
        self.corners.clear();
        self.place.clear();
        self.place.resize(elements.len(), NOWHERE);
        for contactor in 0..elements.len() as u32 {
            for slot in couples.of(contactor) {
                let target = couples.target(slot);
                let property = |e: u32| elements.property[e as usize];
                if let Some(rank) = pairs.rank(property(contactor), property(target)) {
                    let participants =
                        [target, contactor].map(|element| self.place_of(element, elements));
                    let rest = couples.rest(slot);
                    let listed = self.list.len() as u32;
                    self.list.push(Visit {
                        rest,
                        rank,
                        slot,
                        contactor,
                        listed,
                        participants,
                        patience: 0,
                    });
                }
            }
        }
        // the order of listing as second key makes the sort stable, without the
        // buffer that a stable sort allocates
        self.list.sort_unstable_by_key(|visit| (visit.rank, visit.listed));
        self.shapes.resize(self.corners.len(), Shape::default());
    }

    fn place_of(&mut self, element: u32, elements: &Elements) -> u32 {
        let place = &mut self.place[element as usize];
        if *place == NOWHERE {
            *place = self.corners.len() as u32;
            self.corners.push(elements.corners::<3>(element as usize).map(|n| n as u32));
        }
        *place
    }

    /// Takes out the couples that were dropped.
    pub fn forget_dropped(&mut self) {
        self.list.retain(|visit| visit.slot != REMOVED);
    }
}
