//! Contact of all tetrahedra of a scene: when to detect, which couples to evaluate in which order.

use super::{
    Slip, Vec3,
    detection::{self, Detector, Participants},
    evaluation::{Evaluator, Step},
    surfaces::Surfaces,
    visits::{Respites3, Visits},
};
use crate::{
    contact::{CoupleList, CoupleWork},
    scene::{ContactSettings, Elements, Nodes, PairProperties},
    team::Team,
};
use serde::{Deserialize, Serialize};

/// Where the nodes are and how they move.
#[derive(Debug, Clone, Copy)]
pub struct Motion3<'a> {
    /// Current coordinates, m.
    pub positions: &'a [Vec3],
    /// Velocities, m/s.
    pub velocities: &'a [Vec3],
    /// Boundary flags: elements with a node flagged 1 take part in contact.
    pub boundary_flags: &'a [i32],
}

impl<'a> From<&'a Nodes<3>> for Motion3<'a> {
    fn from(nodes: &'a Nodes<3>) -> Self {
        Self {
            positions: &nodes.current,
            velocities: &nodes.velocity,
            boundary_flags: &nodes.boundary_flag,
        }
    }
}

/// What contact keeps from step to step.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub struct ContactState3 {
    couples: CoupleList<Slip>,
    /// What the couples can be spared, in the order of their evaluation.
    respites: Respites3,
    travel: f64,
    path: f64,
    advance: f64,
    work: CoupleWork,
}

/// More contacts than any run evaluates.
const MOST_COUNTED: u64 = 1 << 60;

/// Steps at the present speed for which pairs of faces that do nothing are to be left out.
const HORIZON_STEPS: f64 = 32.0;
/// They are left out for this share of the buffer at least.
const HORIZON_SHARE: f64 = 1.0 / 128.0;

/// Contact of a simulation in space.
#[derive(Debug, Clone)]
pub struct Contact3 {
    settings: ContactSettings,
    rests: bool,
    couples: CoupleList<Slip>,
    detector: Detector,
    surfaces: Surfaces,
    visits: Visits,
    evaluator: Evaluator,
    /// Nodes of elements that take part in contact.
    moving_nodes: Vec<u32>,
    /// Travel accumulated since the last detection, m.
    travel: f64,
    /// Path of the fastest node since the start: no node has moved further, m.
    path: f64,
    /// Part of the path covered in the last step, m.
    advance: f64,
    evaluations: u64,
    work: CoupleWork,
    /// The threads that share the work.
    team: Team,
}

impl Contact3 {
    /// Contact without couples. Of the settings, buffer, travel and selection count.
    ///
    /// With `rests`, couples that provably have no effect are not evaluated; results do not depend
    /// on it.
    #[must_use]
    pub fn new(settings: ContactSettings, rests: bool) -> Self {
        Self {
            rests,
            couples: CoupleList::default(),
            detector: Detector::default(),
            surfaces: Surfaces::default(),
            visits: Visits::default(),
            evaluator: Evaluator::default(),
            moving_nodes: Vec::new(),
            travel: settings.initial_travel,
            path: 0.0,
            advance: 0.0,
            evaluations: 0,
            work: CoupleWork::default(),
            team: Team::alone(),
            settings,
        }
    }

    /// The same on the threads of a team.
    #[must_use]
    pub fn shared_by(self, team: Team) -> Self {
        Self { team, ..self }
    }

    /// Takes over settings of a later stage; the couples stay.
    pub fn restate(&mut self, settings: ContactSettings, travel: Option<f64>) {
        if settings.spatial != self.settings.spatial {
            self.visits.wake_all();
        }
        self.settings = settings;
        if let Some(travel) = travel {
            self.travel = travel;
        }
    }

    /// Takes over changed elements. `surfaces` are the contact properties of each property set,
    /// `None` where its elements take no part. Elements that take part have four nodes, and
    /// (x₁−x₀)×(x₂−x₀) points towards x₃.
    pub fn rebuild(&mut self, elements: &Elements, surfaces: &[Option<PairProperties>]) {
        self.take_over(elements, surfaces);
        self.couples.resize(elements.len());
        self.list_couples(elements);
    }

    fn take_over(&mut self, elements: &Elements, surfaces: &[Option<PairProperties>]) {
        self.surfaces = Surfaces::new(surfaces);
        self.moving_nodes.clear();
        for element in 0..elements.len() {
            if self.surfaces.touches(elements.property[element]) {
                self.moving_nodes.extend(elements.corners::<4>(element).map(|node| node as u32));
            }
        }
        self.moving_nodes.sort_unstable();
        self.moving_nodes.dedup();
    }

    /// Everything that steps change and that does not follow from the scene. Contact tags are
    /// part of the elements.
    #[must_use]
    pub fn state(&self) -> ContactState3 {
        ContactState3 {
            couples: self.couples.clone(),
            respites: self.visits.respites().clone(),
            travel: self.travel,
            path: self.path,
            advance: self.advance,
            work: self.work,
        }
    }

    /// Goes on with the state of an earlier run for the same scene.
    ///
    /// # Errors
    /// If the state is not one of this scene; contact is of no use then.
    pub fn restore(
        &mut self,
        state: ContactState3,
        elements: &Elements,
        surfaces: &[Option<PairProperties>],
    ) -> Result<(), &'static str> {
        let ContactState3 { couples, respites, travel, path, advance, work } = state;
        couples.check(elements.len())?;
        if [work.detections, work.evaluated, work.rested].iter().any(|&count| count > MOST_COUNTED)
        {
            return Err("a count of contacts is too large");
        }
        (self.travel, self.path, self.advance, self.work) = (travel, path, advance, work);
        self.take_over(elements, surfaces);
        self.couples = couples;
        self.list_couples(elements);
        if !self.visits.recall(respites) {
            return Err("the couples are not those of the elements");
        }
        Ok(())
    }

    /// Makes the next step detect: what may touch has changed.
    pub fn detect_next(&mut self) {
        self.travel = self.travel.max(self.settings.buffer);
    }

    /// Work done so far.
    #[must_use]
    pub fn work(&self) -> CoupleWork {
        self.work
    }

    /// Contactor and target of all couples: contactors ascending, the newest couple of each first.
    #[must_use]
    pub fn couples(&self) -> Vec<[u32; 2]> {
        let of = |contactor| {
            self.couples.of(contactor).map(move |slot| [contactor, self.couples.target(slot)])
        };
        (0..self.couples.contactors() as u32).flat_map(of).collect()
    }

    /// Detection when it is due, then the forces of all couples.
    ///
    /// `elements` are those that [`Self::rebuild`] was given; detection tags those at the boundary.
    pub fn add_forces(
        &mut self,
        motion: Motion3<'_>,
        elements: &mut Elements,
        dt: f64,
        forces: &mut [Vec3],
    ) {
        self.detect(motion, elements, dt);
        self.interact(motion, dt, forces);
    }

    /// Accumulates travel and detects when it has used up the buffer.
    pub fn detect(&mut self, motion: Motion3<'_>, elements: &mut Elements, dt: f64) {
        let mut fastest = 0.0;
        for &node in &self.moving_nodes {
            let v = &motion.velocities[node as usize];
            let squared = super::dot(v, v);
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
        let mut tags = std::mem::take(&mut elements.contact_tag);
        let scene = Participants {
            elements,
            positions: motion.positions,
            boundary_flags: motion.boundary_flags,
            surfaces: &self.surfaces,
            buffer: self.settings.buffer,
            selection: self.settings.selection,
        };
        scene.tag_boundary_elements(&mut tags);
        detection::update(&mut self.detector, &scene, &tags, &mut self.couples);
        elements.contact_tag = tags;
        self.work.most_couples = self.work.most_couples.max(self.couples.len());
        self.list_couples(elements);
    }

    /// Makes couples of pairs of elements that are none yet, in this order; −1 is no element.
    pub fn couple(&mut self, pairs: impl Iterator<Item = [i32; 2]>, elements: &Elements) {
        let before = self.couples.len();
        for pair in pairs {
            let [Ok(a), Ok(b)] = pair.map(u32::try_from) else { continue };
            let (contactor, target) = (a.max(b), a.min(b));
            if contactor != target && self.couples.find(contactor, target).is_none() {
                self.couples.insert(contactor, target);
            }
        }
        if self.couples.len() > before {
            self.work.most_couples = self.work.most_couples.max(self.couples.len());
            self.list_couples(elements);
        }
    }

    fn list_couples(&mut self, elements: &Elements) {
        self.visits.sort(&self.couples, &self.surfaces, elements);
    }

    /// Adds the contact forces of all couples.
    pub fn interact(&mut self, motion: Motion3<'_>, dt: f64, forces: &mut [Vec3]) {
        self.evaluations += 1;
        let mut evaluator = std::mem::take(&mut self.evaluator);
        self.visits.list_due(self.path, &mut evaluator.due);
        if !evaluator.due.is_empty() {
            self.bring_up(&evaluator.due, motion.positions);
            let horizon = (HORIZON_STEPS * self.advance).max(HORIZON_SHARE * self.settings.buffer);
            evaluator.ask(&self.step(motion, dt), horizon, &self.team);
            self.visits.learn(self.path, &evaluator.due, &evaluator.clearances);
            self.let_go(&evaluator.due);
        }
        self.visits.list_awake(&mut evaluator.awake);
        self.bring_up(&evaluator.awake, motion.positions);
        evaluator.evaluate(&self.step(motion, dt), forces, &self.team);
        for &(slot, slip) in &evaluator.slips {
            *self.couples.kept_mut(slot) = slip;
        }
        let evaluated = evaluator.awake.len() as u64;
        self.work.evaluated += evaluated;
        self.work.rested += self.visits.list.len() as u64 - evaluated;
        self.evaluator = evaluator;
    }

    fn step<'a>(&'a self, motion: Motion3<'a>, dt: f64) -> Step<'a> {
        Step {
            visits: &self.visits,
            surfaces: &self.surfaces,
            couples: &self.couples,
            velocities: motion.velocities,
            dt,
            law: self.settings.spatial,
            rests: self.rests,
        }
    }

    /// Takes over the positions of the bodies of some couples.
    fn bring_up(&mut self, couples: &[u32], positions: &[Vec3]) {
        for &couple in couples {
            let participants = self.visits.list[couple as usize].participants;
            self.visits.bodies.update(participants, positions, self.evaluations);
        }
    }

    /// Lets go the springs of friction of couples that came apart.
    fn let_go(&mut self, couples: &[u32]) {
        if self.settings.spatial.has_friction {
            for &couple in couples.iter().filter(|&&couple| self.visits.active(couple) == 0) {
                let slot = self.visits.list[couple as usize].slot;
                *self.couples.kept_mut(slot) = Slip::default();
            }
        }
    }
}
