use super::{Model, ModelState, SceneSize};
use crate::{
    contact::CoupleWork,
    insertion::CapacityError,
    output::{Background, OutputError, OutputNames, ResultWriter, grids, write_state},
    scene::{Control, Profile, SpatialContact, replay_settings, update_scene},
    session::{
        Observer, RunError, RunOptions,
        settle::{self, SettlingSummary},
        writers::open_writers,
    },
    simulation::{
        PhaseTimes, SettlingFault, SettlingOptions, Simulation, StateFault, StressUse, Trouble,
        joint_views,
    },
    stability::Limits,
};
use std::{collections::BTreeSet, io};
use yformat::{database::Database, deck::Deck, diagnostic::Diagnostic};
use ypsilon_converters::vtk::UnstructuredGrid;

impl Model for Simulation {
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
            triangles: self.triangles().count(),
            tetrahedra: 0,
            joints: joint_views(self).count(),
            materials: self.scene().materials.len(),
        }
    }

    fn bodies(&self) -> usize {
        self.triangles().count()
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
        Limits::of_plane(self.scene())
    }

    fn write_state(&self, output: &mut dyn io::Write) -> io::Result<()> {
        write_state(output, self)
    }

    fn grids(&mut self) -> Vec<(&'static str, UnstructuredGrid)> {
        self.keep_stresses(StressUse::EveryStep);
        self.evaluate_forces();
        grids(self)
    }

    fn notice(&self) -> Option<String> {
        None
    }

    fn begin(&mut self, options: &RunOptions) {
        if options.monitors.needs_contact_forces() || options.watch.energy_interval.is_some() {
            self.watch_contact_forces();
        }
        if options.watch.energy_interval.is_some() {
            self.keep_triangles();
        }
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
        ModelState::Plane(Box::new(self.state()))
    }

    fn load(&mut self, state: ModelState) -> Result<(), StateFault> {
        match state {
            ModelState::Plane(state) => self.restore(*state),
            ModelState::Spatial(_) => Err(StateFault::OTHER_DIMENSION),
        }
    }

    fn restage(
        &mut self,
        deck: &Deck,
        database: &Database,
        named: &BTreeSet<String>,
        profile: Profile,
    ) -> Vec<Diagnostic> {
        let outcome = update_scene(deck, database, self.scene(), named, profile);
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
        let contact = SpatialContact::default();
        replay_settings(deck, database, &mut scene, named, profile, contact);
        self.replay_stage(scene);
    }

    fn check_settling(&self, options: SettlingOptions) -> Result<(), SettlingFault> {
        self.check_settling(options)
    }

    fn settle(
        &mut self,
        options: &RunOptions,
        observer: &mut dyn Observer,
    ) -> Result<Option<SettlingSummary>, RunError> {
        settle::settle(options, self, observer)
    }

    fn writers(
        &self,
        options: &RunOptions,
        names: &OutputNames,
        background: &Background,
        is_resumed: bool,
    ) -> Result<Vec<Box<dyn ResultWriter>>, OutputError> {
        open_writers(options, names, background, self, is_resumed)
    }
}
