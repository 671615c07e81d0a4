//! The couples in the order of their evaluation, with the shapes of the
//! elements that they need.

use super::{
    couples::CoupleList,
    friction::PairTable,
    placement::{Motion, Shape},
};
use crate::{
    mechanics::Vec2,
    scene::{Elements, Nodes},
};

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
    /// Rank of the pair of materials in the order of visits.
    pub rank: u32,
    /// Index of the couple's contact properties.
    pub pair: u32,
    /// Places of target and contactor among the participants.
    pub participants: [u32; 2],
    /// Evaluations to go before it is asked again whether the couple may rest.
    pub patience: u8,
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

/// All couples, and the elements that take part in one.
#[derive(Debug, Clone, Default)]
pub(super) struct Visits {
    pub list: Vec<Visit>,
    pub bodies: Bodies,
    /// Couples in the order of listing.
    order: Vec<u32>,
}

/// The elements that take part in a couple.
#[derive(Debug, Clone, Default)]
pub(super) struct Bodies {
    /// Corner nodes.
    pub corners: Vec<[u32; 3]>,
    /// Present shapes.
    pub shapes: Vec<Shape>,
    /// Present velocities of the corners.
    pub motions: Vec<Motion>,
    /// Place of each element among them.
    place: Vec<u32>,
}

impl Bodies {
    fn clear(&mut self, elements: usize) {
        self.corners.clear();
        self.place.clear();
        self.place.resize(elements, NOWHERE);
    }

    fn place_of(&mut self, element: u32, elements: &Elements) -> u32 {
        let place = &mut self.place[element as usize];
        if *place == NOWHERE {
            *place = self.corners.len() as u32;
            self.corners.push(elements.corners::<3>(element as usize).map(|n| n as u32));
        }
        *place
    }

    fn complete(&mut self) {
        self.shapes.resize(self.corners.len(), Shape::default());
        self.motions.resize(self.corners.len(), Motion::default());
    }

    /// Takes over the present positions and velocities.
    pub fn update(&mut self, nodes: &Nodes<2>) {
        let Self { corners, shapes, motions, .. } = self;
        for ((shape, motion), &[p, q, r]) in shapes.iter_mut().zip(motions).zip(&*corners) {
            let of = |values: &[Vec2]| [values[p as usize], values[q as usize], values[r as usize]];
            *shape = Shape::new(of(&nodes.current));
            *motion = Motion::new(of(&nodes.velocity));
        }
    }
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
        self.bodies.clear(elements.len());
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
                    pair: pairs.along_fracture(elements, contactor, target).unwrap_or(rank),
                    participants: [target, contactor].map(|e| self.bodies.place_of(e, elements)),
                    patience: 0,
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
        self.bodies.complete();
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
        self.list.retain(|visit| !visit.is_dropped);
    }
}
