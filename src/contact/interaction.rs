//! Contact of the whole scene: when to detect, which couples to evaluate in
//! which order, and what becomes of them.

use super::{
    clearance::clearance,
    couples::CoupleList,
    detection::{Detector, Participants},
    friction::PairTable,
    overlap2::{Proximity, SideForces, overlap},
};
use crate::{
    mechanics::Vec2,
    scene::{ContactSettings, ElementKind, Elements, Material, Nodes},
};

/// A couple in the order of evaluation.
#[derive(Debug, Clone, Copy)]
struct Visit {
    rank: u32,
    contactor: u32,
    slot: u32,
    target_nodes: [u32; 3],
    contactor_nodes: [u32; 3],
    /// Path length up to which the couple rests.
    rest: f64,
    /// Evaluations to go before it is asked again whether the couple may rest.
    patience: u8,
}

/// Slot of a visit whose couple has been removed since the last sorting.
const REMOVED: u32 = u32::MAX;

/// A couple that could not be let rest is asked again after so many evaluations.
const PATIENCE: u8 = 15;

/// Steps at the present speed that a rest must promise.
const WORTHWHILE_STEPS: f64 = 4.0;

/// How much contact work was done since the start.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct CoupleWork {
    /// Detections.
    pub detections: u64,
    /// Couples evaluated.
    pub evaluated: u64,
    /// Couples that rested.
    pub rested: u64,
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
    /// Path of the fastest node since the start: no node has moved further, m.
    path: f64,
    /// Part of the path covered in the last step, m.
    advance: f64,
    /// Whether separated couples may rest.
    rests: bool,
    /// Nodes of elements that take part in contact.
    moving_nodes: Vec<u32>,
    work: CoupleWork,
}

impl Contact {
    /// Contact with an empty couple list.
    ///
    /// With `rests`, couples that provably have no effect are not evaluated;
    /// results do not depend on it.
    #[must_use]
    pub fn new(settings: ContactSettings, rests: bool) -> Self {
        Self {
            path: 0.0,
            advance: 0.0,
            rests,
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

    /// Takes over settings of a later stage; the couples stay.
    pub fn restate(&mut self, settings: ContactSettings, travel: Option<f64>) {
        self.settings = settings;
        if let Some(travel) = travel {
            self.travel = travel;
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
        self.couples.wake_all();
        // a rigid triangle's nodes may move further than their velocities tell
        self.rests &= materials.iter().all(|m| m.kind != ElementKind::RigidTriangle);
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
        self.advance = dt * fastest.sqrt();
        self.path += self.advance;
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
    pub fn interact(&mut self, nodes: &Nodes<2>, dt: f64, forces: &mut [Vec2]) {
        let drop_distance = 4.0 * self.settings.buffer * self.settings.buffer;
        let mut sides = [SideForces::default(); 2];
        let (mut removed, mut evaluated) = (false, 0);
        for visit in &mut self.visits {
            if self.path < visit.rest {
                continue;
            }
            evaluated += 1;
            let ids = [visit.target_nodes, visit.contactor_nodes];
            let mut corners = [[Vec2::zeros(); 3]; 2];
            for t in 0..2 {
                for i in 0..3 {
                    corners[t][i] = nodes.current[ids[t][i] as usize];
                }
            }
            let pair = self.pairs.properties(visit.rank);
            let sliding = self.couples.sliding_mut(visit.slot);
            let velocity = |t: usize, i: usize| nodes.velocity[ids[t][i] as usize];
            let result = overlap(&corners, velocity, &pair, dt, sliding, &mut sides);
            sides[0].scatter(&ids[0], &ids[1], forces);
            sides[1].scatter(&ids[1], &ids[0], forces);
            let Proximity::Apart { distance_squared } = result else { continue };
            if distance_squared > drop_distance {
                self.couples.remove(visit.contactor, visit.slot);
                visit.slot = REMOVED;
                removed = true;
            } else if self.rests && visit.patience > 0 {
                visit.patience -= 1;
            } else if self.rests {
                let free = clearance(&ids, &corners, self.settings.buffer);
                // worth it for some steps, and resolved by the sum of the path
                if free > WORTHWHILE_STEPS * self.advance && free > 1e-9 * self.path {
                    visit.rest = self.path + free;
                    self.couples.set_rest(visit.slot, visit.rest);
                } else {
                    visit.patience = PATIENCE;
                }
            }
        }
        self.work.evaluated += evaluated;
        self.work.rested += self.visits.len() as u64 - evaluated;
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
                    let rest = self.couples.rest(slot);
                    let (target_nodes, contactor_nodes) =
                        (corner_nodes(elements, target), corner_nodes(elements, contactor));
                    self.visits.push(Visit {
                        rest,
                        patience: 0,
                        rank,
                        contactor,
                        slot,
                        target_nodes,
                        contactor_nodes,
                    });
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
