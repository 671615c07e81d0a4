use super::{Model, ModelState, SceneSize};
use crate::{
    contact::CoupleWork,
    insertion::CapacityError,
    output::{
        Background, OutputError, OutputNames, ResultWriter, spatial_grids, write_spatial_state,
    },
    scene::{Control, Profile, replay_settings, update_spatial_scene},
    session::{Observer, RunError, RunOptions, settle::SettlingSummary, writers::open_in_space},
    simulation::{
        PhaseTimes, SettlingFault, SettlingOptions, SpatialSimulation, StateFault, StressUse,
        Trouble, Unsettleable, face_joint_views,
    },
    stability::Limits,
};
use std::{collections::BTreeSet, io};
use yformat::{database::Database, deck::Deck, diagnostic::Diagnostic};
use ypsilon_converters::vtk::UnstructuredGrid;

impl Model for SpatialSimulation {
    fn control(&self) -> &Control {
        &self.scene().control
    }

    fn step_index(&self) -> u64 {
        self.step_index()
    }

    fn time(&self) -> f64 {
        self.time()
    }

    fn size(&self) -> SceneSize {
        SceneSize {
            nodes: self.scene().nodes.len(),
            triangles: 0,
            tetrahedra: self.tetrahedra().count(),
            joints: face_joint_views(self).count(),
            materials: self.scene().materials.len(),
        }
    }

    fn bodies(&self) -> usize {
        self.tetrahedra().count()
    }

    fn broken_joints(&self) -> usize {
        self.failures().len()
    }

    fn kinetic_energy(&self) -> f64 {
        self.sum_kinetic_energy()
    }

    fn contact_work(&self) -> CoupleWork {
        self.couple_work().unwrap_or_default()
    }

    fn phases(&self) -> Option<PhaseTimes> {
        self.phase_times()
    }

    fn trouble(&self) -> Option<Trouble> {
        self.trouble()
    }

    fn limits(&self) -> Limits {
        Limits::of_space(self.scene())
    }

    fn write_state(&self, output: &mut dyn io::Write) -> io::Result<()> {
        write_spatial_state(output, self)
    }

    fn grids(&mut self) -> Vec<(&'static str, UnstructuredGrid)> {
        self.keep_stresses(StressUse::EveryStep);
        self.evaluate_forces();
        spatial_grids(self)
    }

    /// The original says so of every such element in every step; here the first is named.
    fn notice(&self) -> Option<String> {
        let (step, element) = self.first_inversion()?;
        Some(format!("{step:10}  Negative Jacobian for element {element:5}"))
    }

    fn begin(&mut self, _options: &RunOptions) {
        self.keep_stresses(StressUse::OutputSteps);
    }

    fn mesh(&mut self) -> Result<(), CapacityError> {
        self.prepare()
    }

    fn evaluate(&mut self) {
        self.evaluate_forces();
    }

    fn move_on(&mut self) {
        self.move_bodies();
    }

    fn complete(&mut self) {
        self.complete_step();
    }

    fn save(&self) -> ModelState {
        ModelState::Spatial(Box::new(self.state()))
    }

    fn load(&mut self, state: ModelState) -> Result<(), StateFault> {
        match state {
            ModelState::Spatial(state) => self.restore(*state),
            ModelState::Plane(_) => Err(StateFault::OTHER_DIMENSION),
        }
    }

    fn restage(
        &mut self,
        deck: &Deck,
        database: &Database,
        named: &BTreeSet<String>,
        profile: Profile,
    ) -> Vec<Diagnostic> {
        let outcome = update_spatial_scene(
            deck,
            database,
            self.scene(),
            named,
            profile,
            self.options().spatial_contact,
        );
        if let Some(scene) = outcome.scene {
            let travel = named.contains("YDI/DIEDI").then(|| database.real("YDI/DIEDI"));
            self.continue_with(scene, travel);
        }
        outcome.findings
    }

    fn replay(
        &mut self,
        deck: &Deck,
        database: &Database,
        named: &BTreeSet<String>,
        profile: Profile,
    ) {
        let mut scene = self.scene().clone();
        let contact = self.options().spatial_contact;
        replay_settings(deck, database, &mut scene, named, profile, contact);
        self.replay_stage(scene);
    }

    fn check_settling(&self, _options: SettlingOptions) -> Result<(), SettlingFault> {
        Err(Unsettleable::Space.into())
    }

    fn settle(
        &mut self,
        options: &RunOptions,
        _observer: &mut dyn Observer,
    ) -> Result<Option<SettlingSummary>, RunError> {
        match options.settling {
            Some(_) => Err(SettlingFault::from(Unsettleable::Space).into()),
            None => Ok(None),
        }
    }

    fn writers(
        &self,
        options: &RunOptions,
        names: &OutputNames,
        background: &Background,
        is_resumed: bool,
    ) -> Result<Vec<Box<dyn ResultWriter<Self>>>, OutputError> {
        open_in_space(options, names, background, self, is_resumed)
    }
}
