//! Contact of all tetrahedra of a scene: when to detect, which couples to evaluate in which order.

use super::{
    Slip, Vec3,
    bodies::Bodies,
    detection::{self, Participants},
    overlap3::{FaceForce, overlap},
    surfaces::Surfaces,
};
use crate::{
    contact::{CoupleList, CoupleWork, sweep::Sweep},
    scene::{ContactSettings, Elements, Nodes, PairProperties},
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
    travel: f64,
    path: f64,
    work: CoupleWork,
}

/// A couple in the order of evaluation.
#[derive(Debug, Clone, Copy)]
struct Visit {
    /// Rank of the pair of property sets.
    rank: u32,
    slot: u32,
    /// Places of target and contactor among the bodies.
    participants: [u32; 2],
    /// Order of listing: by contactor, then newest first.
    listed: u32,
}

/// Contact of a simulation in space.
#[derive(Debug, Clone)]
pub struct Contact3 {
    settings: ContactSettings,
    rests: bool,
    couples: CoupleList<Slip>,
    sweep: Sweep<3>,
    surfaces: Surfaces,
    bodies: Bodies,
    visits: Vec<Visit>,
    /// Nodes of elements that take part in contact.
    moving_nodes: Vec<u32>,
    /// Travel accumulated since the last detection, m.
    travel: f64,
    /// Path of the fastest node since the start: no node has moved further, m.
    path: f64,
    evaluations: u64,
    work: CoupleWork,
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
            sweep: Sweep::default(),
            surfaces: Surfaces::default(),
            bodies: Bodies::default(),
            visits: Vec::new(),
            moving_nodes: Vec::new(),
            travel: settings.initial_travel,
            path: 0.0,
            evaluations: 0,
            work: CoupleWork::default(),
            settings,
        }
    }

    /// Takes over settings of a later stage; the couples stay.
    pub fn restate(&mut self, settings: ContactSettings, travel: Option<f64>) {
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
        self.couples.wake_all();
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
            travel: self.travel,
            path: self.path,
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
        let ContactState3 { couples, travel, path, work } = state;
        couples.check(elements.len())?;
        (self.travel, self.path, self.work) = (travel, path, work);
        self.take_over(elements, surfaces);
        self.couples = couples;
        self.list_couples(elements);
        Ok(())
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
        self.path += dt * fastest.sqrt();
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
        detection::update(&mut self.sweep, &scene, &tags, &mut self.couples);
        elements.contact_tag = tags;
        self.work.most_couples = self.work.most_couples.max(self.couples.len());
        self.list_couples(elements);
    }

    /// Lists the couples by pair of property sets, then contactor, then newest first.
    fn list_couples(&mut self, elements: &Elements) {
        let Self { couples, surfaces, bodies, visits, .. } = self;
        visits.clear();
        bodies.clear(elements.len());
        for contactor in 0..elements.len() as u32 {
            for slot in couples.of(contactor) {
                let target = couples.target(slot);
                let property = |element: u32| elements.property[element as usize];
                let Some(rank) = surfaces.rank(property(contactor), property(target)) else {
                    continue;
                };
                let participants = [target, contactor].map(|e| bodies.place_of(e, elements));
                visits.push(Visit { rank, slot, participants, listed: visits.len() as u32 });
            }
        }
        visits.sort_unstable_by_key(|visit| (visit.rank, visit.listed));
        bodies.settle();
    }

    /// Adds the contact forces of all couples.
    pub fn interact(&mut self, motion: Motion3<'_>, _dt: f64, forces: &mut [Vec3]) {
        self.evaluations += 1;
        for visit in &self.visits {
            self.bodies.update(visit.participants, motion.positions, self.evaluations);
            let [target, contactor] = visit.participants.map(|place| place as usize);
            let penalty = self.surfaces.pair(visit.rank).penalty;
            let nodes = [target, contactor].map(|place| &self.bodies.nodes[place]);
            let exert = |force: FaceForce| force.scatter(nodes[0], nodes[1], forces);
            overlap(
                &self.bodies.targets[target],
                &self.bodies.contactors[contactor],
                penalty,
                exert,
            );
        }
        self.work.evaluated += self.visits.len() as u64;
    }
}
