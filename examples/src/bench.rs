//! Where and how long a case runs, with helpers to run scenarios.

use crate::{
    Case, CaseError,
    case::Figure,
    measure::{self, Moving},
};
use std::{
    ops::ControlFlow,
    path::{Path, PathBuf},
    sync::Mutex,
    time::Instant,
};
use ypsilon::{
    meshing::{AnyKind, Generated, Scenario, SpatialGenerated, TimeStepBounds},
    scene::{Profile, SpatialContact},
    session::{self, Checkpoints, DeckFault, Format, RunOptions, RunSummary, Silent, StopReason},
    simulation::{AnySimulation, Simulation, SolverOptions, SpatialSimulation},
    team::Team,
};
use ypsilon_post::{plot::Picture, results::Results, table::Table};

/// How a structure in space is run, beyond its deck. The default is what the thesis's program does.
#[derive(Debug, Clone, Copy, Default)]
pub struct InSpace {
    /// Law of contact.
    pub contact: SpatialContact,
    /// Program that is followed.
    pub profile: Profile,
}

impl From<SpatialContact> for InSpace {
    fn from(contact: SpatialContact) -> Self {
        Self { contact, ..Self::default() }
    }
}

/// How much of a case is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Length {
    /// All of it.
    Full,
    /// What the test suite has time for.
    Short,
}

/// Where and how long a case runs.
#[derive(Debug)]
pub struct Bench {
    /// The folder of the case: scenario files.
    folder: PathBuf,
    /// Where decks and results go.
    work: PathBuf,
    /// Where pictures go.
    pictures: PathBuf,
    length: Length,
    /// Whether finished runs of the same deck are taken instead of running it again.
    reuse: bool,
    /// Seconds and triangle-steps of all runs so far.
    tally: Mutex<(f64, u64)>,
}

/// A run through a session, with its results.
#[derive(Debug)]
pub struct Run {
    /// What was made from the scenario.
    pub generated: Generated,
    /// What the run did.
    pub summary: RunSummary,
    /// The deck; results lie beside it.
    pub deck: PathBuf,
    /// Wall-clock seconds.
    pub seconds: f64,
    /// Triangles times steps.
    pub triangle_steps: u64,
}

impl Run {
    /// The results that the run wrote, VTU files before d3plot ones.
    ///
    /// # Errors
    /// If it wrote none or they cannot be read.
    pub fn results(&self) -> Result<Results, CaseError> {
        let pvd = self.deck.with_extension("pvd");
        let path = if pvd.exists() { pvd } else { self.deck.with_extension("") };
        Ok(Results::open(&path)?)
    }

    /// The table of the monitors.
    ///
    /// # Errors
    /// If there were none.
    pub fn monitors(&self) -> Result<Table, CaseError> {
        Ok(Table::read(&self.deck.with_extension("monitors.csv"))?)
    }
}

/// A simulation in the plane or in space that was watched step by step.
pub struct WatchedAny {
    /// What the time step may be.
    pub bounds: TimeStepBounds,
    /// The simulation where it stopped.
    pub simulation: Box<dyn Moving>,
    /// Whether velocities are no numbers any more.
    pub is_unstable: bool,
}

/// A simulation in space that was watched step by step.
#[derive(Debug)]
pub struct WatchedInSpace {
    /// What was made from the scenario.
    pub generated: SpatialGenerated,
    /// The simulation where it stopped.
    pub simulation: SpatialSimulation,
    /// Whether velocities are no numbers any more.
    pub is_unstable: bool,
    /// Wall-clock seconds.
    pub seconds: f64,
}

/// A simulation that was watched step by step.
#[derive(Debug)]
pub struct Watched {
    /// What was made from the scenario.
    pub generated: Generated,
    /// The simulation where it stopped.
    pub simulation: Simulation,
    /// Whether places or velocities are no numbers any more.
    pub is_unstable: bool,
    /// Wall-clock seconds.
    pub seconds: f64,
}

impl Bench {
    /// A bench for a case that works in a folder of its own under `work`. Pictures go to the
    /// case's folder if its length is full.
    #[must_use]
    pub fn new(case: &Case, work: &Path, length: Length) -> Self {
        let folder = case.folder();
        let work = work.join(case.name);
        let pictures = if length == Length::Full { folder.clone() } else { work.clone() };
        Self { folder, work, pictures, length, reuse: false, tally: Mutex::new((0.0, 0)) }
    }

    /// The same, but finished runs that lie in the working folder are taken instead of running
    /// the same deck again: for long cases whose evaluation changes.
    #[must_use]
    pub fn reusing(self, reuse: bool) -> Self {
        Self { reuse, ..self }
    }

    /// How much of the case is to be run.
    #[must_use]
    pub fn length(&self) -> Length {
        self.length
    }

    /// The first value for full cases, the second for short ones.
    #[must_use]
    pub fn pick<T>(&self, full: T, short: T) -> T {
        match self.length {
            Length::Full => full,
            Length::Short => short,
        }
    }

    /// Where decks and results go.
    #[must_use]
    pub fn work(&self) -> &Path {
        &self.work
    }

    /// Reads a scenario file of the case's folder.
    ///
    /// # Errors
    /// If it cannot be read.
    pub fn scenario(&self, file: &str) -> Result<Scenario, CaseError> {
        Ok(Scenario::read(&self.folder.join(file))?)
    }

    /// Runs a scenario through a session, as `ypsilon run SCENARIO` does, in a folder `name` of
    /// the working folder. Monitors of the scenario are written.
    ///
    /// # Errors
    /// If the scenario makes no deck, the run fails or files cannot be written.
    pub fn run(
        &self,
        scenario: &Scenario,
        name: &str,
        formats: &[Format],
    ) -> Result<Run, CaseError> {
        let generated = scenario.generate()?;
        if self.reuse
            && let Some((deck, summary)) = self.finished(&generated, name)
        {
            return Ok(self.done(generated, summary, deck, None));
        }
        let (generated, deck) = self.deck(scenario, name)?;
        let started = Instant::now();
        let loaded = load(&deck, Profile::default(), SolverOptions::default())?;
        let mut formats = formats.to_vec();
        formats.push(Format::Json);
        let options = RunOptions {
            formats,
            monitors: session::monitors(scenario, &deck)?,
            ..RunOptions::new(deck.clone(), self.work.join(name))
        };
        let summary = session::run_with(loaded, &options, Checkpoints::default(), &mut Silent)
            .map_err(Box::new)?;
        let seconds = started.elapsed().as_secs_f64();
        Ok(self.done(generated, summary, deck, Some(seconds)))
    }

    fn done(
        &self,
        generated: Generated,
        summary: RunSummary,
        deck: PathBuf,
        seconds: Option<f64>,
    ) -> Run {
        let seconds = seconds.unwrap_or(summary.seconds);
        let triangle_steps = (summary.triangle_steps_per_second * summary.seconds).round() as u64;
        self.count(seconds, triangle_steps);
        Run { generated, summary, deck, seconds, triangle_steps }
    }

    /// A finished run of the same deck, comments aside.
    fn finished(&self, generated: &Generated, name: &str) -> Option<(PathBuf, RunSummary)> {
        let deck = self.deck_path(name);
        let bare = |text: &str| -> Vec<String> {
            text.lines().filter(|line| !line.starts_with("/*")).map(str::to_owned).collect()
        };
        if bare(&std::fs::read_to_string(&deck).ok()?) != bare(&generated.deck.to_text()) {
            return None;
        }
        let text = std::fs::read_to_string(deck.with_extension("run.json")).ok()?;
        let summary: RunSummary = serde_json::from_str(&text).ok()?;
        (summary.stop == StopReason::Finished).then_some((deck, summary))
    }

    fn deck_path(&self, name: &str) -> PathBuf {
        self.work.join(name).join(format!("{name}.y"))
    }

    /// Runs the first stage of a scenario without result files. `watch` sees the simulation at
    /// the start of each step, with the forces of its place, and once at the end; it may stop it.
    /// Motion that becomes unstable stops as well.
    ///
    /// # Errors
    /// If the scenario makes no deck or the deck has errors.
    pub fn watch(
        &self,
        scenario: &Scenario,
        name: &str,
        mut watch: impl FnMut(&Simulation) -> ControlFlow<()>,
    ) -> Result<Watched, CaseError> {
        let (generated, deck) = self.deck(scenario, name)?;
        let loaded = load(&deck, Profile::default(), SolverOptions::default())?;
        let Some(mut simulation) = loaded.simulation.and_then(AnySimulation::into_plane) else {
            return Err(CaseError::missing(format!("{} runs nothing", deck.display())));
        };
        let (is_unstable, seconds) = self.step_through(&mut simulation, &mut watch);
        Ok(Watched { generated, simulation, is_unstable, seconds })
    }

    /// The same for a structure in space.
    ///
    /// # Errors
    /// As [`Bench::watch`].
    pub fn watch_in_space(
        &self,
        scenario: &Scenario,
        name: &str,
        how: impl Into<InSpace>,
        mut watch: impl FnMut(&SpatialSimulation) -> ControlFlow<()>,
    ) -> Result<WatchedInSpace, CaseError> {
        let generated = scenario.generate_in_space()?;
        let deck = self.deck_path(name);
        session::write_generated(&generated.deck, &deck)?;
        let InSpace { contact, profile } = how.into();
        let options = SolverOptions { spatial_contact: contact, ..SolverOptions::default() };
        let loaded = load(&deck, profile, options)?;
        let Some(mut simulation) = loaded.simulation.and_then(AnySimulation::into_spatial) else {
            return Err(CaseError::missing(format!("{} runs nothing", deck.display())));
        };
        let (is_unstable, seconds) = self.step_through(&mut simulation, &mut watch);
        Ok(WatchedInSpace { generated, simulation, is_unstable, seconds })
    }

    /// The same for a structure in the plane or in space; the law of contact is for the latter.
    ///
    /// # Errors
    /// As [`Bench::watch`].
    pub fn watch_any(
        &self,
        scenario: &Scenario,
        name: &str,
        contact: SpatialContact,
        mut watch: impl FnMut(&dyn Moving) -> ControlFlow<()>,
    ) -> Result<WatchedAny, CaseError> {
        Ok(match scenario.kind()? {
            (_, AnyKind::Plane(_)) => {
                let done = self.watch(scenario, name, |simulation| watch(simulation))?;
                let (bounds, is_unstable) = (done.generated.bounds, done.is_unstable);
                WatchedAny { bounds, simulation: Box::new(done.simulation), is_unstable }
            }
            (_, AnyKind::Spatial(_)) => {
                let seen = |simulation: &SpatialSimulation| watch(simulation);
                let done = self.watch_in_space(scenario, name, contact, seen)?;
                let (bounds, is_unstable) = (done.generated.bounds, done.is_unstable);
                WatchedAny { bounds, simulation: Box::new(done.simulation), is_unstable }
            }
        })
    }

    /// Steps to the end of the stage, or as long as it is watched and sound. Returns whether
    /// motion became unstable, and the time it took.
    fn step_through<S: Moving>(
        &self,
        simulation: &mut S,
        watch: &mut impl FnMut(&S) -> ControlFlow<()>,
    ) -> (bool, f64) {
        let started = Instant::now();
        let mut is_unstable = false;
        let first = simulation.step_index();
        loop {
            simulation.evaluate_forces();
            if watch(simulation).is_break() || simulation.step_index() >= simulation.end_step() {
                break;
            }
            simulation.advance();
            if simulation.step_index().is_multiple_of(64) && !is_sound(simulation) {
                is_unstable = true;
                break;
            }
        }
        is_unstable |= !is_sound(simulation);
        let seconds = started.elapsed().as_secs_f64();
        let steps = simulation.step_index() - first;
        self.count(seconds, steps * simulation.bodies().len() as u64);
        (is_unstable, seconds)
    }

    /// Writes a picture of the case.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn picture(
        &self,
        picture: &Picture,
        file: &str,
        caption: &str,
    ) -> Result<Figure, CaseError> {
        std::fs::create_dir_all(&self.pictures).map_err(CaseError::at(&self.pictures))?;
        picture.write(&self.pictures.join(file))?;
        Ok(Figure { file: file.to_owned(), caption: caption.to_owned() })
    }

    /// Seconds and triangle-steps of all runs so far.
    #[must_use]
    pub fn tally(&self) -> (f64, u64) {
        *self.tally.lock().unwrap_or_else(std::sync::PoisonError::into_inner)
    }

    fn count(&self, seconds: f64, triangle_steps: u64) {
        let mut tally = self.tally.lock().unwrap_or_else(std::sync::PoisonError::into_inner);
        tally.0 += seconds;
        tally.1 += triangle_steps;
    }

    fn deck(&self, scenario: &Scenario, name: &str) -> Result<(Generated, PathBuf), CaseError> {
        let generated = scenario.generate()?;
        let deck = self.deck_path(name);
        session::write_generated(&generated.deck, &deck)?;
        Ok((generated, deck))
    }
}

fn is_sound(simulation: &impl Moving) -> bool {
    measure::kinetic_energy(simulation).is_finite()
}

fn load(
    deck: &Path,
    profile: Profile,
    options: SolverOptions,
) -> Result<session::LoadedDeck, CaseError> {
    let team = Team::of_all_cores()
        .map_err(|source| CaseError::Io { path: deck.to_path_buf(), source })?;
    let options = SolverOptions { team, ..options };
    session::load(deck, None, profile, options).map_err(|fault| {
        let message = match &fault {
            DeckFault::Findings { findings, .. } => {
                findings.iter().map(ToString::to_string).collect::<Vec<_>>().join("; ")
            }
            DeckFault::Io { source, .. } => source.to_string(),
        };
        CaseError::Deck { deck: deck.to_path_buf(), message }
    })
}
