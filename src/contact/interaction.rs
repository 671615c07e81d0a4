//! Contact of the whole scene: when to detect, which couples to evaluate in
//! which order, and what becomes of them.

use super::{
    bodies::Bodies,
    bonds::Bonds,
    couples::CoupleList,
    detection::{Detector, Participants},
    evaluation::{Evaluator, Step, turn},
    friction::PairTable,
    in_order::{FractureFaces, Tally, evaluate_in_order},
    respites::Respites,
    sliding::Sliding,
    visits::{Kept, Visits},
};
use crate::{
    mechanics::Vec2,
    scene::{ChainAfterDrop, ContactSettings, ElementKind, Elements, Material, Nodes, Scene},
    team::Team,
};
use serde::{Deserialize, Serialize};
use std::{
    ops::Range,
    sync::atomic::{AtomicU64, Ordering},
};

/// From so many nodes on, threads pay for the search of the fastest: about 5 µs of work for one.
const PARALLEL_FROM: usize = 4096;

/// How much contact work was done since the start.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
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

/// More contacts than any run evaluates.
const MOST_COUNTED: u64 = 1 << 60;

/// What contact keeps from step to step.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct ContactState {
    couples: CoupleList<Kept>,
    sliding: Sliding,
    /// How long the couples can be left alone, in the order of their evaluation, and which of their
    /// edges face each other.
    respites: Respites,
    facing_edges: Vec<u8>,
    evaluations: u32,
    travel: f64,
    path: f64,
    advance: f64,
    rests: bool,
    work: CoupleWork,
}

/// Contact of a simulation.
#[derive(Debug, Clone)]
pub struct Contact {
    settings: ContactSettings,
    couples: CoupleList<Kept>,
    detector: Detector,
    pairs: PairTable,
    visits: Visits,
    evaluator: Evaluator,
    /// Travel accumulated since the last detection, m.
    travel: f64,
    /// Path of the fastest node since the couples were listed: no node has moved further, m.
    path: f64,
    /// Part of the path covered in the last step, m.
    advance: f64,
    /// Whether separated couples may rest.
    rests: bool,
    /// Nodes of elements that take part in contact, in runs of numbers.
    moving_nodes: Vec<Range<u32>>,
    work: CoupleWork,
    /// Steps in which couples were evaluated, up to the largest number.
    evaluations: u32,
    /// Whether a dropped couple changes the next of its chain.
    is_chained: bool,
}

impl Contact {
    /// Contact with an empty couple list.
    ///
    /// With `rests`, couples that provably have no effect are not evaluated;
    /// results do not depend on it.
    #[must_use]
    pub fn new(settings: ContactSettings, rests: bool) -> Self {
        let mut visits = Visits::default();
        let initial = settings.initial_sliding.iter().map(|row| {
            let mut kept = Kept::default();
            visits.sliding.keep(&mut kept.sliding, row);
            kept
        });
        let initial = initial.collect();
        Self {
            path: 0.0,
            advance: 0.0,
            is_chained: false,
            rests,
            travel: settings.initial_travel,
            couples: CoupleList::new(initial),
            settings,
            detector: Detector::default(),
            pairs: PairTable::default(),
            visits,
            evaluator: Evaluator::default(),
            moving_nodes: Vec::new(),
            work: CoupleWork::default(),
            evaluations: 0,
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

    /// Contactor, target and sliding of all couples: contactors ascending, the
    /// newest couple of each first.
    #[must_use]
    pub fn couples(&self) -> Vec<([u32; 2], [f64; 6])> {
        let mut couples = self.couples.clone();
        self.visits.store(self.path, &mut couples);
        let listed = |contactor| {
            let (couples, sliding) = (&couples, &self.visits.sliding);
            couples.of(contactor).map(move |slot| {
                let slid = sliding.of(couples.kept(slot).sliding);
                ([contactor, couples.target(slot)], *slid)
            })
        };
        (0..couples.contactors() as u32).flat_map(listed).collect()
    }

    /// Makes the next step detect, as the original does after meshing
    /// (`buffers` = 2) and fracture (5).
    pub fn force_detection(&mut self, buffers: f64) {
        self.travel = buffers * self.settings.buffer;
    }

    /// Sets the travel since the last detection, m.
    pub fn force_travel(&mut self, travel: f64) {
        self.travel = travel;
    }

    /// Takes over changed elements and materials.
    pub fn rebuild(&mut self, scene: &Scene) {
        self.take_over(scene);
        self.couples.resize(scene.elements.len());
        self.visits.store(self.path, &mut self.couples);
        self.couples.all_kept().for_each(|kept| kept.rest = 0.0);
        self.list_couples(&scene.elements);
    }

    /// Takes over what does not depend on the couples.
    fn take_over(&mut self, scene: &Scene) {
        let Scene { elements, materials, .. } = scene;
        self.pairs = PairTable::new(materials, &self.settings.pairs)
            .with_fractures(scene.fracture_network.as_ref());
        self.is_chained = scene.conventions.after_drop == ChainAfterDrop::NextLosesSliding;
        let mut moves = vec![false; scene.nodes.len()];
        for element in 0..elements.len() {
            let property = elements.property[element];
            if self.pairs.rank(property, property).is_some() {
                elements.corners::<3>(element).into_iter().for_each(|node| moves[node] = true);
            }
        }
        let mut first = 0;
        self.moving_nodes.clear();
        for alike in moves.chunk_by(|a, b| a == b) {
            let end = first + alike.len() as u32;
            if alike[0] {
                self.moving_nodes.push(first..end);
            }
            first = end;
        }
        // a rigid triangle's nodes may move further than their velocities tell
        let jumps = |m: &Material| m.kind == ElementKind::RigidTriangle || m.is_excavated;
        self.rests &= !materials.iter().any(jumps);
    }

    /// Everything that steps change and that does not follow from the scene.
    #[must_use]
    pub fn state(&self) -> ContactState {
        let mut couples = self.couples.clone();
        self.visits.store(self.path, &mut couples);
        ContactState {
            couples,
            sliding: self.visits.sliding.clone(),
            respites: self.visits.respites.clone(),
            facing_edges: self.visits.facing.iter().map(|facing| facing.edge_bits()).collect(),
            evaluations: self.evaluations,
            travel: self.travel,
            path: self.path,
            advance: self.advance,
            rests: self.rests,
            work: self.work,
        }
    }

    /// Goes on with the state of an earlier run for the same scene.
    ///
    /// # Errors
    /// If the state is not one of this scene; contact is of no use then.
    pub fn restore(&mut self, state: ContactState, scene: &Scene) -> Result<(), &'static str> {
        let ContactState {
            mut couples,
            sliding,
            respites,
            facing_edges,
            evaluations,
            travel,
            path,
            advance,
            rests,
            work,
        } = state;
        couples.check(scene.elements.len())?;
        let counts = [work.detections, work.evaluated, work.rested];
        if counts.into_iter().any(|count| count > MOST_COUNTED) {
            return Err("a count of contacts is too large");
        }
        if !couples.all_kept().all(|kept| sliding.has(kept.sliding)) {
            return Err("a couple has a sliding that is not there");
        }
        (self.travel, self.advance, self.work) = (travel, advance, work);
        self.rests &= rests;
        self.take_over(scene);
        self.couples = couples;
        self.visits.sliding = sliding;
        self.list_couples(&scene.elements);
        let count = self.visits.list.len();
        if !respites.is_of(count) || facing_edges.len() != count {
            return Err("the couples are not those of the elements");
        }
        self.visits.respites = respites;
        for (facing, bits) in self.visits.facing.iter_mut().zip(facing_edges) {
            *facing = facing.with_edge_bits(bits);
        }
        (self.path, self.evaluations) = (path, evaluations);
        Ok(())
    }

    /// Accumulates travel and detects when it has used up the buffer.
    pub fn detect(
        &mut self,
        nodes: &Nodes<2>,
        elements: &mut Elements,
        materials: &[Material],
        bonds: Option<Bonds<'_>>,
        dt: f64,
        team: &Team,
    ) {
        let fastest = self.fastest_squared(nodes, team);
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
            selection: self.settings.selection,
            bonds,
        };
        self.visits.store(self.path, &mut self.couples);
        self.detector.update(&scene, elements, &mut self.couples);
        self.work.most_couples = self.work.most_couples.max(self.couples.len());
        self.list_couples(elements);
    }

    /// Square of the largest velocity of a node that takes part, m²/s².
    fn fastest_squared(&self, nodes: &Nodes<2>, team: &Team) -> f64 {
        let fastest_of = |velocities: &[Vec2]| {
            velocities.iter().fold(0.0, |fastest, v| {
                let squared = v.x * v.x + v.y * v.y;
                if squared > fastest { squared } else { fastest }
            })
        };
        let runs = self.moving_nodes.iter();
        let runs = runs.map(|run| &nodes.velocity[run.start as usize..run.end as usize]);
        if team.size() == 1 || nodes.len() < PARALLEL_FROM {
            return runs.map(fastest_of).fold(0.0, f64::max);
        }
        // numbers from zero up compare as their bits do
        let fastest = AtomicU64::new(0);
        let part = nodes.len().div_ceil(team.size());
        team.share(runs.flat_map(|run| run.chunks(part)), |part| {
            fastest.fetch_max(fastest_of(part).to_bits(), Ordering::Relaxed);
        });
        f64::from_bits(fastest.into_inner())
    }

    /// Lists the couples as they were stored; paths count from now on.
    fn list_couples(&mut self, elements: &Elements) {
        let now = turn(self.evaluations);
        self.visits.sort(&self.couples, &self.pairs, elements, self.is_chained, now);
        self.path = 0.0;
    }

    /// Adds the contact forces of all couples and drops those that came apart.
    pub fn interact(&mut self, nodes: &Nodes<2>, dt: f64, forces: &mut [Vec2], team: &Team) {
        self.visits.bodies.update(nodes, team);
        let mut visits = std::mem::take(&mut self.visits);
        let mut evaluator = std::mem::take(&mut self.evaluator);
        let (bodies, mut couples) = visits.couples();
        let step = self.step(bodies, nodes, dt);
        let evaluated = evaluator.evaluate(&step, &mut couples, forces, team);
        (self.visits, self.evaluator) = (visits, evaluator);
        self.take_stock(evaluated);
    }

    /// The same for scenes with fractures, couple after couple. `tally` takes
    /// the sums of each element.
    pub fn interact_in_order(
        &mut self,
        nodes: &Nodes<2>,
        dt: f64,
        faces: &impl FractureFaces,
        tally: Option<&mut Tally>,
        forces: &mut [Vec2],
    ) {
        self.visits.bodies.update_shapes(nodes);
        let mut visits = std::mem::take(&mut self.visits);
        let (bodies, couples) = visits.couples();
        let (step, model) = (self.step(bodies, nodes, dt), self.settings.friction);
        let evaluated = evaluate_in_order(&step, couples, model, faces, tally, forces);
        self.visits = visits;
        self.take_stock(evaluated);
    }

    fn step<'a>(&'a self, bodies: &'a Bodies, nodes: &'a Nodes<2>, dt: f64) -> Step<'a> {
        Step {
            bodies,
            velocities: &nodes.velocity,
            pairs: &self.pairs,
            dt,
            buffer: self.settings.buffer,
            path: self.path,
            advance: self.advance,
            rests: self.rests,
            evaluation: self.evaluations,
        }
    }

    fn take_stock(&mut self, evaluated: u64) {
        self.evaluations = self.evaluations.saturating_add(1);
        self.work.evaluated += evaluated;
        self.work.rested += self.visits.list.len() as u64 - evaluated;
        if !self.visits.dropped.is_empty() {
            self.visits.remove_dropped(&mut self.couples);
        }
    }
}
