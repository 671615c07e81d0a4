//! The step loop (spec `y2d3d.md` B).
//!
//! After [`Simulation::prepare`] one step is [`Simulation::evaluate_forces`], then output of the state that
//! belongs to those forces, then [`Simulation::advance`].

mod audit;
mod classic_joints;
mod contact_step;
mod disjoint;
mod domains;
mod element_forces;
mod emission;
mod excavation;
mod extra_loads;
mod fracture;
mod fracture_lines;
mod free_motion;
mod guard;
mod joint_forces;
mod joint_records;
mod motion;
mod phases;
mod plan;
mod probe_values;
mod settling;
mod spatial;
mod state;
mod state_check;
mod view;

use crate::{
    contact::{Contact, Tally},
    insertion::{self, CapacityError, InsertionReport},
    mechanics::Vec2,
    scene::{CohesiveModel, ContactSum, Scene, SpatialContact},
    team::Team,
};
use disjoint::Disjoint;
use domains::Domains;
use joint_forces::EvaluatedJoint;
use nalgebra::Matrix2;
use phases::{Phase, PhaseClock};
use plan::Plan;
pub(crate) use plan::stress_law;
use std::ops::Range;

pub use audit::{EnergyBalance, Ledger, PlaneAudit, SpaceAudit};
pub use classic_joints::ClassicJoints;
pub use emission::{Emission, EmissionStage};
pub use guard::{Trouble, Wrong};
pub use joint_records::{EnergyRelease, JointRecord, YieldMode, Yielding};
pub use phases::PhaseTimes;
pub use settling::{
    Settled, SettlingFault, SettlingOptions, SettlingOutcome, SettlingProgress, Unsettleable,
};
pub use spatial::{FaceFailure, FaceJointView, SpatialSimulation, SpatialState, face_joint_views};
pub use state::{SimulationState, StateFault};
pub use view::{JointCondition, JointFailure, JointView, joint_views};

/// Choices that a deck cannot make.
#[derive(Debug, Clone)]
pub struct SolverOptions {
    /// Whether couples that provably have no effect are left out: this changes how fast a
    /// simulation runs, never its results.
    pub skip_separated_couples: bool,
    /// The law of contact of tetrahedra. Nothing in the plane.
    pub spatial_contact: SpatialContact,
    /// The threads that share the work: they change how fast a simulation runs, too.
    pub team: Team,
}

impl Default for SolverOptions {
    fn default() -> Self {
        Self {
            skip_separated_couples: true,
            spatial_contact: SpatialContact::default(),
            team: Team::alone(),
        }
    }
}

/// A simulation in the plane or in space.
#[derive(Debug, Clone)]
pub enum AnySimulation {
    /// Of triangles.
    Plane(Box<Simulation>),
    /// Of tetrahedra.
    Spatial(Box<SpatialSimulation>),
}

impl AnySimulation {
    /// The simulation if it is one in the plane.
    #[must_use]
    pub fn into_plane(self) -> Option<Simulation> {
        match self {
            Self::Plane(simulation) => Some(*simulation),
            Self::Spatial(_) => None,
        }
    }

    /// The simulation if it is one in space.
    #[must_use]
    pub fn into_spatial(self) -> Option<SpatialSimulation> {
        match self {
            Self::Spatial(simulation) => Some(*simulation),
            Self::Plane(_) => None,
        }
    }
}

/// In which steps [`Simulation::stresses`] are wanted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum StressUse {
    /// In every step.
    #[default]
    EveryStep,
    /// In those in which output is due.
    OutputSteps,
}

/// A scene in motion.
#[derive(Debug, Clone)]
pub struct Simulation {
    scene: Scene,
    plan: Plan,
    contact: Option<Contact>,
    options: SolverOptions,
    step: u64,
    time: f64,
    /// Nodal forces of the last evaluation, N.
    force: Vec<Vec2>,
    /// Nodal masses, kg.
    mass: Vec<f64>,
    /// Cauchy stress of each element up to the last that has one, Pa, in the last step that
    /// needed it.
    stress: Vec<Matrix2<f64>>,
    stress_use: StressUse,
    /// Shear strength of joints and shrink ratio of softening triangles.
    strength: Vec<f64>,
    /// Contact forces, where they are summed apart (classic), N.
    contact_force: Vec<Vec2>,
    /// Whether the plan lists triangles that domains hold.
    keeps_triangles: bool,
    /// Whether somebody wants to know the contact forces by themselves.
    watches_contact: bool,
    /// What contact added to the nodal forces, where somebody wants to know, N.
    contact_share: Vec<Vec2>,
    /// Factor on pressure and traction of each node set.
    edge_factors: Vec<f64>,
    /// What Y-Geo keeps of each joint.
    joint_records: Vec<JointRecord>,
    /// Joints that began to yield in this step.
    yielded_now: Vec<usize>,
    /// What the classic dialect keeps of its joints.
    classic: ClassicJoints,
    /// Contact forces of each element in the last output step (classic).
    tally: Tally,
    probe_values: Vec<f64>,
    /// Time of the last refresh of each probe, s.
    probe_times: Vec<f64>,
    /// Kinetic energy at the end of the last step that computed it, J.
    kinetic_energy: f64,
    /// Parts of the mesh for the threads, and their number if somebody wants a certain one.
    domains: Domains,
    parts: Option<usize>,
    /// Buffer of the threads' responses, reused from step to step.
    evaluated_joints: Vec<EvaluatedJoint>,
    insertion_report: Option<InsertionReport>,
    failures: Vec<JointFailure>,
    clock: PhaseClock,
}

impl Simulation {
    /// A simulation at the scene's first step.
    #[must_use]
    pub fn new(scene: Scene) -> Self {
        Self::with_options(scene, SolverOptions::default())
    }

    /// The same with explicit solver options.
    #[must_use]
    pub fn with_options(scene: Scene, options: SolverOptions) -> Self {
        let contact = |settings| Contact::new(settings, options.skip_separated_couples);
        Self {
            step: scene.control.first_step,
            time: scene.control.start_time,
            contact: scene.contact.clone().map(contact),
            probe_values: scene.probes.iter().map(|p| p.initial_value).collect(),
            probe_times: scene.probes.iter().map(|p| p.initial_time).collect(),
            edge_factors: scene.node_sets.iter().map(|s| s.edge_factor).collect(),
            scene,
            plan: Plan::default(),
            options,
            force: Vec::new(),
            mass: Vec::new(),
            stress: Vec::new(),
            stress_use: StressUse::default(),
            strength: Vec::new(),
            contact_force: Vec::new(),
            keeps_triangles: false,
            watches_contact: false,
            contact_share: Vec::new(),
            joint_records: Vec::new(),
            yielded_now: Vec::new(),
            classic: ClassicJoints::default(),
            tally: Tally::default(),
            kinetic_energy: 0.0,
            domains: Domains::default(),
            parts: None,
            evaluated_joints: Vec::new(),
            insertion_report: None,
            failures: Vec::new(),
            clock: PhaseClock::default(),
        }
    }

    /// Meshing, initial strengths and element lists: once before the first
    /// step of each stage of the deck.
    ///
    /// # Errors
    /// If meshing needs more nodes or elements than the deck leaves room for.
    pub fn prepare(&mut self) -> Result<(), CapacityError> {
        let scene = &mut self.scene;
        if let Some(insertion) = &mut scene.insertion {
            let report = insertion::execute(
                insertion,
                &mut scene.nodes,
                &mut scene.elements,
                &mut scene.materials,
                scene.fracture_network.as_ref(),
            )?;
            self.insertion_report = Some(report);
            if let Some(contact) = self.contact.as_mut().filter(|_| report.executed > 0) {
                contact.force_detection(2.0);
            }
        }
        self.install_supports();
        self.put_excavated_nodes_into_their_set();
        if self.scene.conventions.cohesive == CohesiveModel::Classic {
            self.set_up_classic_joints();
        } else {
            self.set_initial_strengths();
        }
        self.rebuild();
        Ok(())
    }

    /// Goes on with a scene that a later stage of the deck has changed;
    /// [`Self::prepare`] comes next. `travel` restates how far nodes have
    /// travelled since the last contact detection, m.
    pub fn continue_with(&mut self, scene: Scene, travel: Option<f64>) {
        self.step = scene.control.first_step;
        self.time = scene.control.start_time;
        self.contact = match (self.contact.take(), &scene.contact) {
            (Some(mut contact), Some(settings)) => {
                contact.restate(settings.clone(), travel);
                Some(contact)
            }
            (None, Some(settings)) => {
                Some(Contact::new(settings.clone(), self.options.skip_separated_couples))
            }
            (_, None) => None,
        };
        for (value, (old, new)) in
            self.probe_values.iter_mut().zip(self.scene.probes.iter().zip(&scene.probes))
        {
            if old != new {
                *value = new.initial_value;
            }
        }
        for (factor, (old, new)) in
            self.edge_factors.iter_mut().zip(self.scene.node_sets.iter().zip(&scene.node_sets))
        {
            if old.edge_factor != new.edge_factor {
                *factor = new.edge_factor;
            }
        }
        self.edge_factors.resize(scene.node_sets.len(), 1.0);
        self.scene = scene;
    }

    /// Takes over the settings of a later stage on the way to a state that is restored next:
    /// what [`Self::continue_with`] and [`Self::prepare`] do without the mesh.
    pub fn replay_stage(&mut self, mut scene: Scene) {
        if let Some(insertion) = &mut scene.insertion {
            insertion::skip(insertion, &mut scene.materials);
        }
        for material in &mut scene.materials {
            material.resets_shape = false;
        }
        self.continue_with(scene, None);
    }

    /// First half of a step: internal forces, joints, contact detection and
    /// contact forces.
    pub fn evaluate_forces(&mut self) {
        self.clock.start();
        self.clear_forces();
        self.clock.lap(Phase::Integration);
        self.add_internal_forces();
        self.record_element_probes();
        self.clock.start();
        self.add_contact_forces();
        self.clock.lap(Phase::Overlap);
        self.record_nodal_forces();
    }

    /// Second half of a step: motion, fracture of softening triangles, time.
    pub fn advance(&mut self) {
        self.move_bodies();
        self.complete_step();
    }

    /// New velocities and positions, and the kinetic energy that they have.
    pub fn move_bodies(&mut self) {
        self.clock.start();
        self.integrate();
        self.clock.lap(Phase::Integration);
        self.update_kinetic_energy();
    }

    /// What follows the motion: fracture of softening triangles, time.
    pub fn complete_step(&mut self) {
        self.clock.start();
        self.fracture_triangles();
        self.clock.lap(Phase::Integration);
        self.time += self.scene.control.time_step;
        self.step += 1;
    }

    /// Takes over a changed mesh.
    fn rebuild(&mut self) {
        self.plan = Plan::new(&self.scene);
        self.force.resize(self.scene.nodes.len(), Vec2::zeros());
        self.mass.resize(self.scene.nodes.len(), 0.0);
        self.stress.resize(self.scene.elements.stressed(), Matrix2::zeros());
        self.strength.resize(self.scene.elements.len(), 0.0);
        self.mass.copy_from_slice(&self.plan.nodal_mass);
        if self.watches_contact {
            self.contact_share.resize(self.scene.nodes.len(), Vec2::zeros());
        }
        if self.scene.conventions.contact_sum == ContactSum::Apart {
            self.contact_force.resize(self.scene.nodes.len(), Vec2::zeros());
        }
        if self.scene.conventions.cohesive == CohesiveModel::YGeo {
            self.joint_records.resize(self.scene.elements.len(), JointRecord::default());
        }
        // room for every joint's failure: the step loop allocates nothing
        self.failures.reserve(self.plan.joints.len());
        if let Some(contact) = &mut self.contact {
            contact.rebuild(&self.scene);
        }
        self.divide();
    }

    fn clear_forces(&mut self) {
        let force = Disjoint::new(&mut self.force);
        let parts = self.domains.node_parts();
        self.options.team.share_places(parts.len(), |place| {
            // SAFETY: parts have no nodes in common
            let part = unsafe { force.part(as_usize(&parts[place])) };
            part.fill(Vec2::zeros());
        });
        self.yielded_now.clear();
        self.contact_force.fill(Vec2::zeros());
        if self.plan.masses_change {
            self.mass.copy_from_slice(&self.plan.nodal_mass);
        }
    }
}

fn as_usize(range: &Range<u32>) -> Range<usize> {
    range.start as usize..range.end as usize
}
