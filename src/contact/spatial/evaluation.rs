//! Evaluates the couples of a step, on all threads where there are many.
//!
//! Couples are independent of each other but for the sums of their forces, which are made in the
//! order of the list: they round the same on any number of threads.

use super::{
    Slip, Vec3,
    clearance3::{ALL_PAIRS, Asked, Clearance},
    friction3::{Contact, Pressure, velocity},
    overlap3::{FaceForce, overlap_in},
    potential::Shape3,
    surfaces::Surfaces,
    two_sided::TwoSided,
    visits::{Visit, Visits},
};
use crate::{
    contact::CoupleList,
    lanes::{self, Kernel, Lanes},
    mechanics::tetrahedron10::EDGES,
    scene::{PairProperties, PressedFaces, SpatialContact},
    team::Team,
};
use std::iter::once;

/// Couples in a chunk.
const CHUNK: usize = 64;
/// The least in a chunk where few couples are shared among threads.
const LEAST_CHUNK: usize = 8;
/// From so many couples on, threads pay: about 20 µs of work for one.
const PARALLEL_FROM: usize = 32;
/// Chunks of a round for each thread, to even out couples that touch and couples that do not.
const CHUNKS_PER_THREAD: usize = 8;
/// Rounds at least, so that most forces are added while others are computed.
const ROUNDS: usize = 2;

/// What the couples of a step see.
#[derive(Clone, Copy)]
pub(super) struct Step<'a> {
    pub visits: &'a Visits,
    pub surfaces: &'a Surfaces,
    pub couples: &'a CoupleList<Slip>,
    pub velocities: &'a [Vec3],
    pub dt: f64,
    pub law: SpatialContact,
    pub rests: bool,
}

impl Step<'_> {
    /// Which pairs of faces of a couple can be left out while no node moves further than
    /// `horizon`.
    fn clearance(&self, couple: u32, horizon: f64) -> Clearance {
        if !self.rests {
            return Clearance { active: ALL_PAIRS, free: f64::INFINITY };
        }
        let bodies = &self.visits.bodies;
        let places = self.visits.list[couple as usize].participants.map(|place| place as usize);
        let asked = Asked {
            nodes: places.map(|place| &bodies.nodes[place]),
            bodies: places.map(|place| &bodies.targets[place]),
            faces: places.map(|place| &bodies.contactors[place]),
        };
        match self.law.pressed {
            PressedFaces::Contactor => asked.clearance(horizon),
            PressedFaces::Both => asked.clearance_of_bodies(horizon),
        }
    }

    /// Target and contactor of a couple with what their shape functions need.
    fn shapes(&self, visit: &Visit) -> [Shape3; 2] {
        let targets = &self.visits.bodies.targets;
        visit.participants.map(|place| Shape3::new(targets[place as usize].corners))
    }

    /// Friction of a couple whose bodies press on each other, and the stretch of its spring then.
    fn friction(
        &self,
        visit: &Visit,
        bodies: [&Shape3; 2],
        contact: &Contact,
        pair: &PairProperties,
    ) -> ([[Vec3; 4]; 2], Slip) {
        let nodes = visit.participants.map(|place| &self.visits.bodies.nodes[place as usize]);
        let [(target, on_target), (contactor, on_contactor)] = [0, 1].map(|t| {
            let velocities = nodes[t].map(|node| self.velocities[node as usize]);
            velocity(bodies[t], &velocities, &contact.centre)
        });
        let mut slip = *self.couples.kept(visit.slot);
        let force = contact.friction(&mut slip, &(contactor - target), pair, self.dt);
        ([on_target.map(|n| force * -n), on_contactor.map(|n| force * n)], slip)
    }
}

/// Forces on the nodes of the bodies of a couple.
#[derive(Debug, Clone, Copy)]
enum Exerted {
    /// Of two faces: the original's law, under which there are no ten-node tetrahedra.
    Faces(FaceForce),
    /// Of the bodies as a whole.
    Bodies([[Vec3; 4]; 2]),
}

/// The forces of some couples in a row.
#[derive(Debug, Clone, Default)]
struct Chunk {
    /// With the places of target and contactor.
    exerted: Vec<([u32; 2], Exerted)>,
    /// Slots and how far their springs of friction are stretched.
    slips: Vec<(u32, Slip)>,
}

impl Chunk {
    fn evaluate(&mut self, step: &Step<'_>, couples: &[u32]) {
        lanes::run(Evaluation { chunk: self, step, couples });
    }

    #[inline(always)]
    fn evaluate_in<L: Lanes>(&mut self, step: &Step<'_>, couples: &[u32]) {
        self.exerted.clear();
        self.slips.clear();
        match step.law {
            SpatialContact { pressed: PressedFaces::Contactor, has_friction: false } => {
                for &couple in couples {
                    self.press_faces::<L>(step, couple, |_, _, _| {});
                }
            }
            SpatialContact { pressed: PressedFaces::Contactor, has_friction: true } => {
                for &couple in couples {
                    let mut pressure = Pressure::default();
                    self.press_faces::<L>(step, couple, |corners, force, double_area| {
                        pressure.add(corners, force, double_area);
                    });
                    let visit = &step.visits.list[couple as usize];
                    let contact = pressure.contact().map(|contact| (contact, step.shapes(visit)));
                    self.rub(step, couple, contact);
                }
            }
            SpatialContact { pressed: PressedFaces::Both, .. } => {
                couples.iter().for_each(|&couple| self.press_bodies(step, couple));
            }
        }
    }

    /// The original's law: `see` is told the corners of the contactor, each force on a face of it,
    /// and twice the area on which that acts.
    #[inline(always)]
    fn press_faces<L: Lanes>(
        &mut self,
        step: &Step<'_>,
        couple: u32,
        mut see: impl FnMut(&[Vec3; 4], &FaceForce, f64),
    ) {
        let bodies = &step.visits.bodies;
        let visit = &step.visits.list[couple as usize];
        let [target, contactor] = visit.participants.map(|place| place as usize);
        overlap_in::<L>(
            &bodies.targets[target],
            &bodies.contactors[contactor],
            step.visits.active(couple),
            step.surfaces.pair(visit.rank).penalty,
            |force, double_area| {
                see(&bodies.targets[contactor].corners, &force, double_area);
                self.exerted.push((visit.participants, Exerted::Faces(force)));
            },
        );
    }

    /// The law under which both bodies press.
    fn press_bodies(&mut self, step: &Step<'_>, couple: u32) {
        let visit = &step.visits.list[couple as usize];
        let pair = step.surfaces.pair(visit.rank);
        let shapes = step.shapes(visit);
        let [target, contactor] = &shapes;
        let found = TwoSided::new([target, contactor], pair.penalty);
        if let Some(both) = &found {
            self.exerted.push((visit.participants, Exerted::Bodies(both.forces)));
        }
        if step.law.has_friction {
            let contact = found.and_then(|both| {
                let [on_contactor, on_target] = &both.pressed;
                let pressed = [&on_contactor.faces, &on_target.faces];
                Contact::new([target, contactor], pressed, pair.penalty)
            });
            self.rub(step, couple, contact.map(|contact| (contact, shapes)));
        }
    }

    /// Friction of a couple in contact, with its bodies; the spring of one that is not is let go.
    fn rub(&mut self, step: &Step<'_>, couple: u32, contact: Option<(Contact, [Shape3; 2])>) {
        let visit = &step.visits.list[couple as usize];
        let mut slip = Slip::default();
        if let Some((contact, [target, contactor])) = &contact {
            let pair = step.surfaces.pair(visit.rank);
            let (forces, stretched) = step.friction(visit, [target, contactor], contact, &pair);
            self.exerted.push((visit.participants, Exerted::Bodies(forces)));
            slip = stretched;
        }
        self.slips.push((visit.slot, slip));
    }

    fn scatter(&self, step: &Step<'_>, forces: &mut [Vec3], slips: &mut Vec<(u32, Slip)>) {
        slips.extend_from_slice(&self.slips);
        for (participants, exerted) in &self.exerted {
            let bodies = &step.visits.bodies;
            let nodes = participants.map(|place| &bodies.nodes[place as usize]);
            match exerted {
                Exerted::Faces(force) => force.scatter(nodes[0], nodes[1], forces),
                Exerted::Bodies(forces_of) => {
                    for ((&place, nodes), on_corners) in
                        participants.iter().zip(nodes).zip(forces_of)
                    {
                        let edges = bodies.edge_nodes[place as usize].as_ref();
                        spread(on_corners, nodes, edges, forces);
                    }
                }
            }
        }
    }
}

/// Adds the forces on the corners of a body; a ten-node tetrahedron bears them with all its nodes
/// (spec `y3d.md` 3.3).
fn spread(
    on_corners: &[Vec3; 4],
    corners: &[u32; 4],
    edge_nodes: Option<&[u32; 6]>,
    forces: &mut [Vec3],
) {
    let Some(edge_nodes) = edge_nodes else {
        for (&node, force) in corners.iter().zip(on_corners) {
            forces[node as usize] += force;
        }
        return;
    };
    for (&node, force) in corners.iter().zip(on_corners) {
        forces[node as usize] += force * CORNER_PART;
    }
    for (&node, [a, b]) in edge_nodes.iter().zip(EDGES) {
        forces[node as usize] += (on_corners[a] + on_corners[b]) * EDGE_PART;
    }
}

/// What a corner keeps of its force, and what each of its three edges bears of it.
const CORNER_PART: f64 = 0.4;
const EDGE_PART: f64 = 0.2;

/// Evaluates the couples of a chunk.
struct Evaluation<'a, 'b> {
    chunk: &'a mut Chunk,
    step: &'a Step<'b>,
    couples: &'a [u32],
}

impl Kernel for Evaluation<'_, '_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        self.chunk.evaluate_in::<L>(self.step, self.couples);
    }
}

/// Buffers reused from step to step: while the couples of one bank are evaluated, those of the other
/// add their forces.
#[derive(Debug, Clone, Default)]
pub(super) struct Evaluator {
    banks: [Vec<Chunk>; 2],
    pub due: Vec<u32>,
    pub awake: Vec<u32>,
    pub clearances: Vec<Clearance>,
    /// Slots and how far their springs of friction are stretched after the step.
    pub slips: Vec<(u32, Slip)>,
}

impl Evaluator {
    /// Asks the couples that are due.
    pub fn ask(&mut self, step: &Step<'_>, horizon: f64, team: &Team) {
        let Self { due, clearances, .. } = self;
        clearances.clear();
        if team.size() > 1 && due.len() >= PARALLEL_FROM {
            clearances.resize(due.len(), Clearance { active: ALL_PAIRS, free: 0.0 });
            let parts = due.chunks(CHUNK).zip(clearances.chunks_mut(CHUNK));
            team.share(parts, |(couples, clearances)| {
                for (&couple, clearance) in couples.iter().zip(clearances) {
                    *clearance = step.clearance(couple, horizon);
                }
            });
        } else {
            clearances.extend(due.iter().map(|&couple| step.clearance(couple, horizon)));
        }
    }

    /// Evaluates the couples that are awake and adds their forces, in the order of the list.
    pub fn evaluate(&mut self, step: &Step<'_>, forces: &mut [Vec3], team: &Team) {
        self.slips.clear();
        if team.size() > 1 && self.awake.len() >= PARALLEL_FROM {
            self.evaluate_on(team, step, forces);
            return;
        }
        let [bank, _] = &mut self.banks;
        let chunk = &mut room_for(bank, 1)[0];
        for couples in self.awake.chunks(CHUNK) {
            chunk.evaluate(step, couples);
            chunk.scatter(step, forces, &mut self.slips);
        }
    }

    /// Round by round, so that what couples exert needs little memory.
    fn evaluate_on(&mut self, team: &Team, step: &Step<'_>, forces: &mut [Vec3]) {
        let Self { banks, slips, awake, .. } = self;
        let work = |task: Task<'_>| match task {
            Task::Scatter(chunks, forces, slips) => scatter(chunks, step, forces, slips),
            Task::Evaluate(couples, chunk) => chunk.evaluate(step, couples),
        };
        // how many of the other bank have not added their forces yet
        let mut waiting = 0;
        let in_a_round = team.size() * CHUNKS_PER_THREAD;
        let size = awake.len().div_ceil(ROUNDS * in_a_round).clamp(LEAST_CHUNK, CHUNK);
        for round in awake.chunks(in_a_round * size) {
            let [bank, other] = &mut *banks;
            let chunks = round.len().div_ceil(size);
            let bank = room_for(bank, chunks);
            let pairs = round.chunks(size).zip(&mut *bank);
            let tasks = pairs.map(|(couples, chunk)| Task::Evaluate(couples, chunk));
            team.share(once(Task::Scatter(&other[..waiting], forces, slips)).chain(tasks), work);
            waiting = chunks;
            banks.swap(0, 1);
        }
        scatter(&banks[1][..waiting], step, forces, slips);
    }
}

/// What a thread does at a time.
enum Task<'a> {
    /// Adds the forces of some chunks.
    Scatter(&'a [Chunk], &'a mut [Vec3], &'a mut Vec<(u32, Slip)>),
    /// Evaluates some couples.
    Evaluate(&'a [u32], &'a mut Chunk),
}

fn scatter(chunks: &[Chunk], step: &Step<'_>, forces: &mut [Vec3], slips: &mut Vec<(u32, Slip)>) {
    for chunk in chunks {
        chunk.scatter(step, forces, slips);
    }
}

/// The first chunks of a bank.
fn room_for(bank: &mut Vec<Chunk>, chunks: usize) -> &mut [Chunk] {
    if bank.len() < chunks {
        bank.resize_with(chunks, Chunk::default);
    }
    &mut bank[..chunks]
}
