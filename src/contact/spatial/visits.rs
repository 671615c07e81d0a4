//! The couples in the order of their evaluation, and what they can be spared.

use super::{
    bodies::Bodies,
    clearance3::{ALL_PAIRS, Clearance, FacePairs},
    surfaces::Surfaces,
};
use crate::{contact::CoupleList, scene::Elements};
use serde::{Deserialize, Serialize};

/// Couples in a block.
const BLOCK: usize = 64;

/// A couple in the order of evaluation.
#[derive(Debug, Clone, Copy)]
pub(super) struct Visit {
    /// Rank of the pair of property sets.
    pub rank: u32,
    pub slot: u32,
    /// Places of target and contactor among the bodies.
    pub participants: [u32; 2],
    /// Order of listing: by contactor, then newest first.
    listed: u32,
}

/// What couples can be spared, in the order of the list.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Respites3 {
    /// Pairs of faces of each couple that may do something.
    active: Vec<FacePairs>,
    /// Path up to which no other pair of its faces does anything, m.
    until: Vec<f64>,
}

/// All couples. Paths are those of the fastest node since the start: no node has moved further.
#[derive(Debug, Clone, Default)]
pub(super) struct Visits {
    pub list: Vec<Visit>,
    pub bodies: Bodies,
    respites: Respites3,
    /// The least path of each block up to which all of its couples can be spared something, m.
    block_until: Vec<f64>,
    /// Couples of each block with active pairs, a bit each.
    awake: Vec<u64>,
}

impl Visits {
    /// Lists the couples anew: by pair of property sets, then contactor, then newest first.
    /// All of them are due.
    pub fn sort<S: Copy + Default>(
        &mut self,
        couples: &CoupleList<S>,
        surfaces: &Surfaces,
        elements: &Elements,
    ) {
        let Self { list, bodies, .. } = self;
        list.clear();
        bodies.clear(elements.len());
        for contactor in 0..elements.len() as u32 {
            for slot in couples.of(contactor) {
                let target = couples.target(slot);
                let property = |element: u32| elements.property[element as usize];
                let Some(rank) = surfaces.rank(property(contactor), property(target)) else {
                    continue;
                };
                let participants = [target, contactor].map(|e| bodies.place_of(e, elements));
                list.push(Visit { rank, slot, participants, listed: list.len() as u32 });
            }
        }
        list.sort_unstable_by_key(|visit| (visit.rank, visit.listed));
        bodies.settle();
        let count = list.len();
        self.respites.active.clear();
        self.respites.active.resize(count, ALL_PAIRS);
        self.respites.until.clear();
        self.respites.until.resize(count, 0.0);
        self.sum_up_blocks();
    }

    /// What couples can be spared.
    pub fn respites(&self) -> &Respites3 {
        &self.respites
    }

    /// Takes over what is known of couples; whether it is of so many.
    pub fn recall(&mut self, respites: Respites3) -> bool {
        let lengths = [respites.active.len(), respites.until.len()];
        let fits = lengths == [self.list.len(); 2];
        if fits {
            self.respites = respites;
            self.sum_up_blocks();
        }
        fits
    }

    /// Forgets what couples can be spared.
    pub fn wake_all(&mut self) {
        self.respites.active.fill(ALL_PAIRS);
        self.respites.until.fill(0.0);
        self.sum_up_blocks();
    }

    fn sum_up_blocks(&mut self) {
        let Respites3 { active, until } = &self.respites;
        let least = |until: &[f64]| until.iter().fold(f64::INFINITY, |a, &b| a.min(b));
        self.block_until.clear();
        self.block_until.extend(until.chunks(BLOCK).map(least));
        let bits = |active: &[FacePairs]| {
            let bit = |(i, &active): (usize, &FacePairs)| u64::from(active != 0) << i;
            active.iter().enumerate().map(bit).fold(0, std::ops::BitOr::bitor)
        };
        self.awake.clear();
        self.awake.extend(active.chunks(BLOCK).map(bits));
    }

    /// Lists the couples of which it is not known any more which pairs of faces do nothing.
    pub fn list_due(&self, path: f64, due: &mut Vec<u32>) {
        due.clear();
        for (block, until) in self.block_until.iter().enumerate() {
            if path < *until {
                continue;
            }
            let first = block * BLOCK;
            let of_block = self.respites.until[first..].iter().take(BLOCK).enumerate();
            due.extend(
                of_block.filter(|(_, until)| path >= **until).map(|(i, _)| (first + i) as u32),
            );
        }
    }

    /// Takes over what is known of couples from now on.
    pub fn learn(&mut self, path: f64, couples: &[u32], clearances: &[Clearance]) {
        for (&couple, clearance) in couples.iter().zip(clearances) {
            let couple = couple as usize;
            // a bound that the sum of the path does not resolve is none
            let is_bound = clearance.free > 1e-9 * path && clearance.free > 0.0;
            let active = if is_bound { clearance.active } else { ALL_PAIRS };
            self.respites.active[couple] = active;
            self.respites.until[couple] = if is_bound { path + clearance.free } else { path };
            let (block, bit) = (couple / BLOCK, 1 << (couple % BLOCK));
            if active == 0 {
                self.awake[block] &= !bit;
            } else {
                self.awake[block] |= bit;
            }
        }
        let mut before = usize::MAX;
        for &couple in couples {
            let block = couple as usize / BLOCK;
            if block != before {
                before = block;
                let of_block = self.respites.until[block * BLOCK..].iter().take(BLOCK);
                self.block_until[block] = of_block.fold(f64::INFINITY, |a, &b| a.min(b));
            }
        }
    }

    /// Lists the couples with active pairs of faces.
    pub fn list_awake(&self, awake: &mut Vec<u32>) {
        awake.clear();
        for (block, &bits) in self.awake.iter().enumerate() {
            let mut bits = bits;
            while bits != 0 {
                awake.push((block * BLOCK) as u32 + bits.trailing_zeros());
                bits &= bits - 1;
            }
        }
    }

    /// Pairs of faces of a couple that may do something.
    pub fn active(&self, couple: u32) -> FacePairs {
        self.respites.active[couple as usize]
    }
}
