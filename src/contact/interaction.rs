//! Contact of the whole scene: when to detect, which couples to evaluate in
//! which order, and what becomes of them.

use super::{
    couples::CoupleList,
    detection::{Detector, Participants},
    evaluation::{Evaluator, Step},
    friction::PairTable,
    placement::{Motion, Shape},
    visits::Visits,
};
use crate::{
    mechanics::Vec2,
    scene::{ContactSettings, ElementKind, Elements, Material, Nodes},
};

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
    visits: Visits,
    evaluator: Evaluator,
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
            visits: Visits::default(),
            evaluator: Evaluator::default(),
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
        self.visits.store(&mut self.couples);
        self.couples.wake_all();
        // a rigid triangle's nodes may move further than their velocities tell
        self.rests &= materials.iter().all(|m| m.kind != ElementKind::RigidTriangle);
        self.visits.sort(&self.couples, &self.pairs, elements);
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
        self.visits.store(&mut self.couples);
        self.detector.update(&scene, elements, &mut self.couples);
        self.work.most_couples = self.work.most_couples.max(self.couples.len());
        self.visits.sort(&self.couples, &self.pairs, elements);
    }

    /// Adds the contact forces of all couples and drops those that came apart.
    pub fn interact(&mut self, nodes: &Nodes<2>, dt: f64, forces: &mut [Vec2]) {
        let Visits { list, corners, shapes, motions, .. } = &mut self.visits;
        update_participants(corners, nodes, shapes, motions);
        let step = Step {
            shapes,
            motions,
            corners,
            pairs: &self.pairs,
            dt,
            buffer: self.settings.buffer,
            path: self.path,
            advance: self.advance,
            rests: self.rests,
        };
        let done = self.evaluator.evaluate(&step, list, forces);
        self.work.evaluated += done.evaluated;
        self.work.rested += list.len() as u64 - done.evaluated;
        if done.dropped {
            self.visits.remove_dropped(&mut self.couples);
        }
    }
}

/// Present shapes and velocities of the elements that take part in couples.
fn update_participants(
    corners: &[[u32; 3]],
    nodes: &Nodes<2>,
    shapes: &mut [Shape],
    motions: &mut [Motion],
) {
    for ((shape, motion), &[p, q, r]) in shapes.iter_mut().zip(motions).zip(corners) {
        let of = |values: &[Vec2]| [values[p as usize], values[q as usize], values[r as usize]];
        *shape = Shape::new(of(&nodes.current));
        *motion = Motion::new(of(&nodes.velocity));
    }
}
