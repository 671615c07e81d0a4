//! What a session does with a simulation, in the plane or in space.

mod plane;
mod spatial;

use super::{run::RunOptions, settle::SettlingSummary};
use crate::{
    contact::CoupleWork,
    insertion::CapacityError,
    output::{Background, OutputError, OutputNames, ResultWriter},
    scene::{Control, Profile},
    session::{Observer, RunError},
    simulation::{
        AnySimulation, PhaseTimes, SettlingFault, SettlingOptions, SimulationState, SpatialState,
        StateFault, Trouble,
    },
    stability::Limits,
};
use serde::{Deserialize, Serialize};
use std::{collections::BTreeSet, io};
use yformat::{database::Database, deck::Deck, diagnostic::Diagnostic};
use ypsilon_converters::vtk::UnstructuredGrid;

/// What a scene holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct SceneSize {
    /// Nodes.
    pub nodes: usize,
    /// Triangles.
    pub triangles: usize,
    /// Tetrahedra.
    pub tetrahedra: usize,
    /// Joints, live and broken.
    pub joints: usize,
    /// Element property sets.
    pub materials: usize,
}

impl SceneSize {
    /// What the scene of a simulation holds.
    #[must_use]
    pub fn of(simulation: &AnySimulation) -> Self {
        match simulation {
            AnySimulation::Plane(simulation) => simulation.size(),
            AnySimulation::Spatial(simulation) => simulation.size(),
        }
    }

    /// Elements that are no joints.
    #[must_use]
    pub fn bodies(&self) -> usize {
        self.triangles + self.tetrahedra
    }

    /// `4 triangles`, `1 tetrahedron`.
    #[must_use]
    pub fn bodies_in_words(&self) -> String {
        match (self.tetrahedra, self.triangles) {
            (0, 1) => "1 triangle".to_owned(),
            (0, count) => format!("{count} triangles"),
            (1, _) => "1 tetrahedron".to_owned(),
            (count, _) => format!("{count} tetrahedra"),
        }
    }
}

/// State of a simulation between two steps.
#[derive(Debug, Clone, Serialize, Deserialize)]
pub(super) enum ModelState {
    /// In the plane.
    Plane(Box<SimulationState>),
    /// In space.
    Spatial(Box<SpatialState>),
}

impl ModelState {
    pub fn step_index(&self) -> u64 {
        match self {
            Self::Plane(state) => state.step_index(),
            Self::Spatial(state) => state.step_index(),
        }
    }

    pub fn time(&self) -> f64 {
        match self {
            Self::Plane(state) => state.time(),
            Self::Spatial(state) => state.time(),
        }
    }
}

/// The writers of a run of a simulation `M`.
pub(super) type Writers<M> = Vec<Box<dyn ResultWriter<M>>>;

/// A simulation as sessions see it.
pub(super) trait Model: Sized {
    /// Time stepping and intervals.
    fn control(&self) -> &Control;
    /// Index of the step to be done.
    fn step_index(&self) -> u64;
    /// Physical time, s.
    fn time(&self) -> f64;
    /// What the scene holds.
    fn size(&self) -> SceneSize;
    /// Elements that are no joints.
    fn bodies(&self) -> usize;
    /// Joints that failed so far.
    fn broken_joints(&self) -> usize;
    /// Kinetic energy, J.
    fn kinetic_energy(&self) -> f64;
    /// Contact work done so far.
    fn contact_work(&self) -> CoupleWork;
    /// Where the time went, if it was taken.
    fn phases(&self) -> Option<PhaseTimes>;
    /// What is wrong with the present state, if anything is.
    fn trouble(&self) -> Option<Trouble>;
    /// How long a time step the present state bears.
    fn limits(&self) -> Limits;
    /// Writes the present state as text.
    ///
    /// # Errors
    /// If `output` refuses.
    fn write_state(&self, output: &mut dyn io::Write) -> io::Result<()>;
    /// Evaluates forces and stresses of the present state: its blocks for VTU files, each with what it adds to
    /// their names.
    fn grids(&mut self) -> Vec<(&'static str, UnstructuredGrid)>;
    /// What is to be said about the last step, once.
    fn notice(&self) -> Option<String>;

    /// Gets ready for what a run is to write.
    fn begin(&mut self, options: &RunOptions);
    /// Meshing and lists before the first step of a stage.
    ///
    /// # Errors
    /// If meshing needs more room than the deck leaves.
    fn mesh(&mut self) -> Result<(), CapacityError>;
    /// Forces of a step.
    fn evaluate(&mut self);
    /// Motion of a step.
    fn move_on(&mut self);
    /// End of a step.
    fn complete(&mut self);

    /// The state after the last completed step.
    fn save(&self) -> ModelState;
    /// Goes on with a state.
    ///
    /// # Errors
    /// If it is not one of this scene.
    fn load(&mut self, state: ModelState) -> Result<(), StateFault>;

    /// Applies what a later stage of the deck names, unless there are errors among the findings.
    fn restage(
        &mut self,
        deck: &Deck,
        database: &Database,
        named: &BTreeSet<String>,
        profile: Profile,
    ) -> Vec<Diagnostic>;
    /// Takes over the settings of a stage that an earlier run has passed.
    fn replay(
        &mut self,
        deck: &Deck,
        database: &Database,
        named: &BTreeSet<String>,
        profile: Profile,
    );

    /// Whether the scene can be settled.
    ///
    /// # Errors
    /// If it cannot.
    fn check_settling(&self, options: SettlingOptions) -> Result<(), SettlingFault>;
    /// Brings the scene to rest if the run is asked to; none if the observer wanted the end.
    ///
    /// # Errors
    /// If it does not come to rest.
    fn settle(
        &mut self,
        options: &RunOptions,
        observer: &mut dyn Observer,
    ) -> Result<Option<SettlingSummary>, RunError>;

    /// The writers of a run; those of a run that goes on from a checkpoint have no files yet.
    /// They hand over to `background` what takes long.
    ///
    /// # Errors
    /// If a file cannot be opened.
    fn writers(
        &self,
        options: &RunOptions,
        names: &OutputNames,
        background: &Background,
        is_resumed: bool,
    ) -> Result<Writers<Self>, OutputError>;
}
