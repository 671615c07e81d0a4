//! The step loop in three dimensions (spec `y2d3d.md` B): tetrahedra, joints between them,
//! contact, motion of nodes.
//!
//! Responses of elements go into slots, from any thread; then each node sums what its elements
//! do to it, in the original's order. Sums round the same on any number of threads.

mod audit;
mod forces;
mod joints;
mod motion;
mod plan;
mod probes;
mod state;
mod view;

use super::{
    SolverOptions, StressUse,
    phases::{Phase, PhaseClock},
};
use crate::{
    contact::{
        CoupleWork,
        spatial::{Contact3, Motion3},
    },
    insertion::{self, CapacityError, Families, InsertionReport},
    mechanics::{Vec3, tetrahedron10},
    scene::{ContactSettings, PairProperties, Scene},
};
use forces::TetrahedronResponses;
use joints::JointResponses;
use motion::Drive;
use plan::Plan;
use serde::{Deserialize, Serialize};

pub use state::SpatialState;
pub use view::{FaceJointView, face_joint_views};

/// When and how a joint between tetrahedra failed.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct FaceFailure {
    /// Element number.
    pub element: usize,
    /// Step index.
    pub step: u64,
    /// Physical time, s.
    pub time: f64,
    /// 1 in tension, 2 in shear, between them in both.
    pub mode: f64,
    /// Cohesive law.
    pub law: usize,
    /// Mean of the joint's six nodes then, m.
    pub place: Vec3,
    /// Area of its middle surface then, m².
    pub area: f64,
}

/// A scene in motion in three dimensions.
#[derive(Debug, Clone)]
pub struct SpatialSimulation {
    scene: Scene<3>,
    plan: Plan,
    contact: Option<Contact3>,
    options: SolverOptions,
    step: u64,
    time: f64,
    /// Nodal forces of tetrahedra and contact of the last evaluation, N.
    force: Vec<Vec3>,
    /// Nodal forces of joints of the last evaluation, N.
    joint_force: Vec<Vec3>,
    /// Nodal masses, kg.
    mass: Vec<f64>,
    stress_use: StressUse,
    probe_values: Vec<f64>,
    /// Kinetic energy at the end of the last step that computed it, J.
    kinetic_energy: f64,
    insertion_report: Option<InsertionReport>,
    /// Which nodes are copies of the same one.
    families: Families,
    failures: Vec<FaceFailure>,
    /// Step and element of the first tetrahedron that turned inside out.
    first_inversion: Option<(u64, usize)>,
    /// What each block of tetrahedra does to its nodes.
    tetrahedron_slots: Vec<TetrahedronResponses>,
    /// What each planned ten-node tetrahedron does to its nodes.
    quadratic_slots: Vec<tetrahedron10::Response>,
    /// What each block of joints does to its nodes.
    joint_slots: Vec<JointResponses>,
    /// Boundary conditions of the present step.
    drives: Vec<Drive>,
    pub(super) clock: PhaseClock,
}

impl SpatialSimulation {
    /// A simulation at the scene's first step.
    #[must_use]
    pub fn new(scene: Scene<3>) -> Self {
        Self::with_options(scene, SolverOptions::default())
    }

    /// The same with explicit solver options.
    #[must_use]
    pub fn with_options(scene: Scene<3>, options: SolverOptions) -> Self {
        let contact = |settings| contact_of(settings, &options);
        Self {
            contact: scene.contact.clone().map(contact),
            options,
            step: scene.control.first_step,
            time: scene.control.start_time,
            probe_values: scene.probes.iter().map(|p| p.initial_value).collect(),
            scene,
            plan: Plan::default(),
            force: Vec::new(),
            joint_force: Vec::new(),
            mass: Vec::new(),
            stress_use: StressUse::default(),
            kinetic_energy: 0.0,
            insertion_report: None,
            families: Families::default(),
            failures: Vec::new(),
            first_inversion: None,
            tetrahedron_slots: Vec::new(),
            quadratic_slots: Vec::new(),
            joint_slots: Vec::new(),
            drives: Vec::new(),
            clock: PhaseClock::default(),
        }
    }

    /// Joint insertion and element lists: once before the first step of each stage of the deck.
    ///
    /// # Errors
    /// If joints need more nodes or elements than the deck leaves room for.
    pub fn prepare(&mut self) -> Result<(), CapacityError> {
        let scene = &mut self.scene;
        if let Some(insertion) = &mut scene.insertion {
            let (nodes, elements) = (&mut scene.nodes, &mut scene.elements);
            let (materials, families) = (&mut scene.materials, &mut self.families);
            let report =
                insertion::execute_in_space(insertion, nodes, elements, materials, families)?;
            self.insertion_report = Some(report);
        }
        self.rebuild();
        Ok(())
    }

    /// Goes on with a scene that a later stage of the deck has changed; [`Self::prepare`] comes
    /// next. `travel` restates how far nodes have travelled since the last contact detection, m.
    pub fn continue_with(&mut self, scene: Scene<3>, travel: Option<f64>) {
        self.step = scene.control.first_step;
        self.time = scene.control.start_time;
        self.contact = match (self.contact.take(), &scene.contact) {
            (Some(mut contact), Some(settings)) => {
                contact.restate(settings.clone(), travel);
                Some(contact)
            }
            (None, Some(settings)) => Some(contact_of(settings.clone(), &self.options)),
            (_, None) => None,
        };
        for (value, (old, new)) in
            self.probe_values.iter_mut().zip(self.scene.probes.iter().zip(&scene.probes))
        {
            if old != new {
                *value = new.initial_value;
            }
        }
        self.scene = scene;
    }

    /// Takes over the settings of a later stage on the way to a state that is restored next:
    /// what [`Self::continue_with`] and [`Self::prepare`] do without the mesh.
    pub fn replay_stage(&mut self, mut scene: Scene<3>) {
        if let Some(insertion) = &mut scene.insertion {
            insertion::skip(insertion, &mut scene.materials);
        }
        self.continue_with(scene, None);
    }

    /// First half of a step: forces of tetrahedra, joints and contact.
    pub fn evaluate_forces(&mut self) {
        self.clock.start();
        self.add_tetrahedron_forces();
        self.add_face_pressures();
        self.clock.lap(Phase::Triangles);
        self.add_joint_forces();
        self.clock.lap(Phase::Joints);
        self.add_contact_forces();
        self.record_nodal_forces();
    }

    /// Second half of a step: motion, time.
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

    /// What follows the motion: time.
    pub fn complete_step(&mut self) {
        self.time += self.scene.control.time_step;
        self.step += 1;
    }

    /// Takes over a changed mesh.
    fn rebuild(&mut self) {
        self.plan = Plan::new(&self.scene);
        let nodes = self.scene.nodes.len();
        self.force.resize(nodes, Vec3::zeros());
        self.joint_force.resize(nodes, Vec3::zeros());
        self.mass.clone_from(&self.plan.nodal_mass);
        if let Some(contact) = &mut self.contact {
            contact.rebuild(&self.scene.elements, &surfaces(&self.scene));
        }
        self.make_room();
    }

    fn add_contact_forces(&mut self) {
        let Some(contact) = &mut self.contact else { return };
        let Scene { nodes, elements, control, .. } = &mut self.scene;
        let (motion, dt) = (Motion3::from(&*nodes), control.time_step);
        contact.detect(motion, elements, dt);
        self.clock.lap(Phase::Detection);
        contact.interact(motion, dt, &mut self.force);
        self.clock.lap(Phase::Overlap);
    }

    /// Contact work done so far.
    #[must_use]
    pub fn couple_work(&self) -> Option<CoupleWork> {
        self.contact.as_ref().map(Contact3::work)
    }

    /// Buffers of the step loop, which allocates nothing.
    fn make_room(&mut self) {
        self.tetrahedron_slots =
            vec![TetrahedronResponses::default(); self.plan.tetrahedron_blocks.len()];
        self.quadratic_slots = vec![tetrahedron10::Response::default(); self.plan.quadratic.len()];
        self.joint_slots = vec![JointResponses::default(); self.plan.joint_blocks.len()];
        self.failures.reserve(self.plan.joints.len());
    }
}

fn contact_of(settings: ContactSettings, options: &SolverOptions) -> Contact3 {
    Contact3::new(settings, options.skip_separated_couples).shared_by(options.team.clone())
}

/// Contact properties of each property set; `None` where its elements take no part.
fn surfaces(scene: &Scene<3>) -> Vec<Option<PairProperties>> {
    scene
        .materials
        .iter()
        .map(|m| {
            m.kind.takes_part_in_contact().then_some(PairProperties {
                penalty: m.contact_penalty,
                tangential_penalty: m.tangential_penalty,
                friction: m.friction,
            })
        })
        .collect()
}
