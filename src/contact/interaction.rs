//! Contact of the whole scene: when to detect, which couples to evaluate in
//! which order, and what becomes of them.

use super::{
    couples::CoupleList,
    detection::{Detector, Participants},
    friction::PairTable,
    overlap2::{Body, Overlap, overlap},
};
use crate::{
    mechanics::Vec2,
    scene::{ContactSettings, Elements, Material, Nodes},
};

/// A couple in the order of evaluation.
#[derive(Debug, Clone, Copy)]
struct Visit {
    rank: u32,
    contactor: u32,
    target: u32,
    slot: u32,
}

/// Slot of a visit whose couple has been removed since the last sorting.
const REMOVED: u32 = u32::MAX;

/// How much contact work was done since the start.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct CoupleWork {
    /// Detections.
    pub detections: u64,
    /// Couples evaluated.
    pub evaluated: u64,
    /// Largest number of couples at one time.
    pub most_couples: usize,
}

/// Contact state of a simulation.
#[derive(Debug, Clone)]
pub struct Contact {
    settings: ContactSettings,
    couples: CoupleList,
    detector: Detector,
    pairs: PairTable,
    visits: Vec<Visit>,
    /// Travel accumulated since the last detection, m.
    travel: f64,
    /// Nodes of elements that take part in contact.
    moving_nodes: Vec<u32>,
    work: CoupleWork,
}

impl Contact {
    /// Contact with an empty couple list.
    #[must_use]
    pub fn new(settings: ContactSettings) -> Self {
        Self {
            travel: settings.initial_travel,
            couples: CoupleList::new(settings.initial_sliding.clone()),
            settings,
            detector: Detector::default(),
            pairs: PairTable::default(),
            visits: Vec::new(),
            moving_nodes: Vec::new(),
            work: CoupleWork::default(),
        }
    }

    /// Work done so far.
    #[must_use]
    pub fn work(&self) -> CoupleWork {
        self.work
    }

    /// Number of couples that the deck has room for.
    #[must_use]
    pub fn capacity(&self) -> usize {
        self.settings.capacity
    }

    /// Makes the next step detect, as the original does after meshing
    /// (`buffers` = 2) and fracture (5).
    pub fn force_detection(&mut self, buffers: f64) {
        self.travel = buffers * self.settings.buffer;
    }

    /// Takes over changed elements and materials.
    pub fn rebuild(&mut self, elements: &Elements, materials: &[Material]) {
        self.pairs = PairTable::new(materials);
        self.moving_nodes.clear();
        for element in 0..elements.len() {
            let property = elements.property[element];
            if self.pairs.rank(property, property).is_some() {
                self.moving_nodes.extend(elements.corners::<3>(element).map(|n| n as u32));
            }
        }
        self.moving_nodes.sort_unstable();
        self.moving_nodes.dedup();
        self.couples.resize(elements.len());
        self.sort_visits(elements);
    }

    /// Accumulates travel and detects when it has used up the buffer.
    pub fn detect(
        &mut self,
        nodes: &Nodes<2>,
        elements: &mut Elements,
        materials: &[Material],
        dt: f64,
    ) {
        let mut fastest = 0.0;
        for &node in &self.moving_nodes {
            let v = nodes.velocity[node as usize];
            let squared = v.x * v.x + v.y * v.y;
            if squared > fastest {
                fastest = squared;
            }
        }
        self.travel += 2.0 * dt * fastest.sqrt();
        if self.travel < self.settings.buffer {
            return;
        }
        self.travel = 0.0;
        self.work.detections += 1;
        let scene = Participants {
            nodes,
            materials,
            buffer: self.settings.buffer,
            all_elements: self.settings.all_elements,
        };
        self.detector.update(&scene, elements, &mut self.couples);
        self.work.most_couples = self.work.most_couples.max(self.couples.len());
        self.sort_visits(elements);
    }

    /// Adds the contact forces of all couples and drops those that came apart.
    pub fn interact(&mut self, nodes: &Nodes<2>, elements: &Elements, dt: f64, forces: &mut [Vec2]) {
        let drop_distance = 4.0 * self.settings.buffer * self.settings.buffer;
        let mut removed = false;
        for visit in &mut self.visits {
            let corners = [corner_nodes(elements, visit.target), corner_nodes(elements, visit.contactor)];
            let bodies = corners.map(|c| Body {
                corners: c.map(|n| nodes.current[n as usize]),
                velocities: c.map(|n| nodes.velocity[n as usize]),
            });
            let pair = self.pairs.properties(visit.rank);
            let result = overlap(&bodies, &pair, dt, self.couples.sliding_mut(visit.slot));
            apply(&result, &corners, forces);
            if !result.near && result.distance_squared > drop_distance {
                self.couples.remove(visit.contactor, visit.slot);
                visit.slot = REMOVED;
                removed = true;
            }
        }
        self.work.evaluated += self.visits.len() as u64;
        if removed {
            self.visits.retain(|visit| visit.slot != REMOVED);
        }
    }

    /// Orders the couples: by material pair, then contactor, then newest first.
    fn sort_visits(&mut self, elements: &Elements) {
        self.visits.clear();
        for contactor in 0..elements.len() as u32 {
            for slot in self.couples.of(contactor) {
                let target = self.couples.target(slot);
                let property = |e: u32| elements.property[e as usize];
                if let Some(rank) = self.pairs.rank(property(contactor), property(target)) {
                    self.visits.push(Visit { rank, contactor, target, slot });
                }
            }
        }
        // stable: keeps the order of contactors and of their chains
        self.visits.sort_by_key(|visit| visit.rank);
    }
}

fn corner_nodes(elements: &Elements, element: u32) -> [u32; 3] {
    elements.corners::<3>(element as usize).map(|n| n as u32)
}

fn apply(result: &Overlap, corners: &[[u32; 3]; 2], forces: &mut [Vec2]) {
    for t in 0..2 {
        if let Some(side) = &result.sides[t] {
            side.scatter(&corners[t], &corners[1 - t], forces);
        }
    }
}
