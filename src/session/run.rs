use super::{
    Format,
    checkpoint::{Checkpoint, CheckpointError, Checkpoints, DeckPrint, Position, RunSettings},
    guard::{self, Guard, OnInstability, Verdict},
    load::{LoadedDeck, capacity_finding},
    model::Model,
    observer::{Observer, Progress},
    restage::{Entry, restage},
    resume::resume,
    settle,
    summary::{RunSummary, StopReason},
};
use crate::{
    output::{
        Background, MonitorPlan, OutputError, OutputNames, ResultWriter, RunTable, TABLE_HEADER,
        table_row,
    },
    scene::Profile,
    simulation::{AnySimulation, SettlingFault, SettlingOptions},
};
use serde::{Deserialize, Serialize};
use std::{
    io::Write as _,
    ops::Range,
    path::PathBuf,
    time::{Duration, Instant},
};
use thiserror::Error;
use yformat::{deck::Deck, diagnostic::Diagnostic, part_file::PartFile, source::SourceMap};

/// Time between two looks at the progress.
const PROGRESS_INTERVAL: Duration = Duration::from_millis(100);
/// Steps between two looks at the clock.
const CLOCK_INTERVAL: u64 = 16;

/// What to write and where.
#[derive(Debug, Clone)]
pub struct RunOptions {
    /// The deck, for names and messages.
    pub deck: PathBuf,
    /// Folder of the results.
    pub folder: PathBuf,
    /// Kinds of result files.
    pub formats: Vec<Format>,
    /// Numbers of completed steps after which a full-precision state is written.
    pub states: Vec<u64>,
    /// Steps to do at most, whatever the deck says.
    pub steps: Option<u64>,
    /// Whether d3plot headers are exactly the original's.
    pub legacy_d3plot: bool,
    /// What is watched during the run.
    pub monitors: MonitorPlan,
    /// What is looked after during the run.
    pub watch: Watch,
    /// Program followed for later stages of the deck.
    pub profile: Profile,
    /// Whether the scene is brought to rest before its first step, and when it counts as settled.
    pub settling: Option<SettlingOptions>,
}

impl RunOptions {
    /// A run of a deck to its end, whose results lie in a folder: what the original writes, and VTU files.
    #[must_use]
    pub fn new(deck: impl Into<PathBuf>, folder: impl Into<PathBuf>) -> Self {
        Self {
            deck: deck.into(),
            folder: folder.into(),
            formats: vec![Format::Native, Format::Vtu],
            states: Vec::new(),
            steps: None,
            legacy_d3plot: false,
            monitors: MonitorPlan::default(),
            watch: Watch::default(),
            profile: Profile::default(),
            settling: None,
        }
    }
}

/// What is looked after during a run.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Watch {
    /// Steps between two lines of the table of energies, if there is one.
    pub energy_interval: Option<u64>,
    /// Error of the balance of energies by the largest energy beyond which the motion makes no sense.
    pub energy_limit: f64,
    /// What to do when it makes no sense any more.
    pub on_instability: OnInstability,
}

impl Watch {
    /// A tenth of the largest energy.
    pub const ENERGY_LIMIT: f64 = 0.1;
}

impl Default for Watch {
    fn default() -> Self {
        Self {
            energy_interval: None,
            energy_limit: Self::ENERGY_LIMIT,
            on_instability: OnInstability::default(),
        }
    }
}

/// Why a run failed.
#[derive(Debug, Error)]
pub enum RunError {
    /// A result file could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
    /// The checkpoint cannot be gone on from.
    #[error(transparent)]
    Checkpoint(#[from] CheckpointError),
    /// The scene was not brought to rest.
    #[error(transparent)]
    Settling(#[from] SettlingFault),
    /// Positions or velocities are no numbers any more.
    #[error(
        "the run has become unstable: at step {step} (time {time:.6e} s) the kinetic energy is {energy}; \
         try a shorter time step (DCSTEC), smaller penalties or more viscosity (D1PEKS). \
         Results up to then are complete"
    )]
    Unstable {
        /// Step at which it was found.
        step: u64,
        /// Physical time, s.
        time: f64,
        /// The offending value.
        energy: f64,
    },
    /// The motion makes no sense any more, and the run was to stop then.
    #[error(
        "the run has become unstable in step {step} (time {time:.6e} s): {trouble}; {cause}. \
         Results up to then are complete{}",
        files_before(files)
    )]
    Instability {
        /// The first step whose end makes no sense.
        step: u64,
        /// Physical time of that step, s.
        time: f64,
        /// What is wrong, and where.
        trouble: String,
        /// The likely cause.
        cause: String,
        /// The state just before, and a checkpoint of it.
        files: Vec<PathBuf>,
    },
    /// A later stage of the deck cannot be run.
    #[error("a later stage of the deck has errors; results of the earlier stages are complete")]
    Stage {
        /// Sources that the findings point into.
        sources: Box<SourceMap>,
        /// Findings, errors among them.
        findings: Vec<Diagnostic>,
    },
}

/// `; the state just before is in A and B`.
fn files_before(files: &[PathBuf]) -> String {
    if files.is_empty() {
        return String::new();
    }
    let names: Vec<String> = files.iter().map(|file| file.display().to_string()).collect();
    format!("; the state just before is in {}", names.join(" and "))
}

/// Runs all stages of a deck.
///
/// # Errors
/// If a file cannot be written, the motion becomes unstable, or a later stage
/// has errors. Files of complete states are completed all the same.
pub fn run(
    loaded: LoadedDeck,
    options: &RunOptions,
    observer: &mut dyn Observer,
) -> Result<RunSummary, RunError> {
    run_with(loaded, options, Checkpoints::default(), observer)
}

/// Runs all stages of a deck, with checkpoints; goes on from one if `checkpoints` says so. Results
/// are the same, to the last bit, as if the run had never stopped.
///
/// # Errors
/// As [`run`]; also if a checkpoint cannot be written or gone on from.
pub fn run_with(
    mut loaded: LoadedDeck,
    options: &RunOptions,
    checkpoints: Checkpoints,
    observer: &mut dyn Observer,
) -> Result<RunSummary, RunError> {
    match loaded.simulation.take() {
        Some(AnySimulation::Plane(simulation)) => {
            run_model(loaded, *simulation, options, checkpoints, observer)
        }
        Some(AnySimulation::Spatial(simulation)) => {
            run_model(loaded, *simulation, options, checkpoints, observer)
        }
        None => run_nothing(&loaded, options, &checkpoints, observer),
    }
}

/// A deck in which nothing runs leaves the log of its words.
fn run_nothing(
    loaded: &LoadedDeck,
    options: &RunOptions,
    checkpoints: &Checkpoints,
    observer: &mut dyn Observer,
) -> Result<RunSummary, RunError> {
    let (names, warnings) = start(loaded, options, checkpoints, observer)?;
    if checkpoints.resume.is_some() {
        return Err(CheckpointError::OtherDeck { deck: options.deck.clone() }.into());
    }
    let mut log = RunTable::create(&names.log())?;
    for line in loaded.deck.echo_lines().iter().chain(&warnings) {
        log.line(line)?;
    }
    Ok(empty_summary(options, warnings))
}

/// The names of the results, in a folder that is there, and the warnings about the deck.
fn start(
    loaded: &LoadedDeck,
    options: &RunOptions,
    checkpoints: &Checkpoints,
    observer: &mut dyn Observer,
) -> Result<(OutputNames, Vec<String>), RunError> {
    let names = OutputNames::new(&options.deck, &options.folder);
    std::fs::create_dir_all(&options.folder).map_err(OutputError::io(&options.folder))?;
    check_names(&names, checkpoints)?;
    observer.findings(&loaded.findings, loaded.deck.sources());
    Ok((names, loaded.findings.iter().map(ToString::to_string).collect()))
}

fn run_model<M: Model>(
    mut loaded: LoadedDeck,
    mut simulation: M,
    options: &RunOptions,
    checkpoints: Checkpoints,
    observer: &mut dyn Observer,
) -> Result<RunSummary, RunError> {
    settle::check_start(options, checkpoints.resume.is_some(), Some(&simulation))?;
    let (names, warnings) = start(&loaded, options, &checkpoints, observer)?;
    let background = Background::new();
    let (resumed_at, mut here, mut writers, log) = match &checkpoints.resume {
        Some(checkpoint) => {
            let step = checkpoint.step_index();
            let (position, writers) =
                resume(checkpoint, &mut loaded, &mut simulation, options, &names, &background)?;
            let log = match position.log {
                Some(log) => RunTable::resume(&names.log(), log)?,
                None => RunTable::create(&names.log())?,
            };
            (Some(step), position, writers, log)
        }
        None => {
            let log = RunTable::create(&names.log())?;
            let writers = simulation.writers(options, &names, &background, false)?;
            (None, Position { warnings, ..Position::default() }, writers, log)
        }
    };
    let warnings = std::mem::take(&mut here.warnings);
    if checkpoints.are_written() {
        // better refused before the run than after it
        for writer in &mut writers {
            writer.mark()?;
        }
    }
    let mut session = Session {
        options,
        observer,
        log,
        writers,
        background,
        warnings,
        started: Instant::now(),
        last_progress: Instant::now(),
        done: 0,
        triangle_steps: 0,
        print: DeckPrint::of(&loaded.deck),
        checkpoints,
        names: names.clone(),
        here,
        resumed_at,
        last_checkpoint: None,
        guard: Guard::new(&options.watch),
    };
    let outcome = session.run_stages(loaded, &mut simulation);
    session.complete(&simulation, outcome, &names)
}

struct Session<'a, M> {
    options: &'a RunOptions,
    observer: &'a mut dyn Observer,
    log: RunTable,
    writers: Vec<Box<dyn ResultWriter<M>>>,
    /// Where the writers' files are written.
    background: Background,
    warnings: Vec<String>,
    started: Instant,
    last_progress: Instant,
    /// Steps and work of this run, without what came before its checkpoint.
    done: u64,
    triangle_steps: u64,
    print: DeckPrint,
    checkpoints: Checkpoints,
    names: OutputNames,
    /// Stages entered, and what was done before this run.
    here: Position,
    resumed_at: Option<u64>,
    /// Step of the checkpoint written last.
    last_checkpoint: Option<u64>,
    guard: Guard,
}

/// Why the steps of a stage ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum StageEnd {
    /// All are done.
    Done,
    /// No more were asked for (`--steps`).
    Enough,
    /// The observer asked for it.
    Interrupted,
}

/// What the log says of the words of some items.
fn echo(deck: &Deck, items: Range<usize>) -> Vec<String> {
    items.filter_map(|item| deck.echo_of(item)).collect()
}

impl<M: Model> Session<'_, M> {
    fn run_stages(
        &mut self,
        loaded: LoadedDeck,
        simulation: &mut M,
    ) -> Result<StopReason, RunError> {
        let LoadedDeck { deck, mut database, stages, .. } = loaded;
        // let go when the last stage begins: as large as what is simulated
        let mut deck = Some(deck);
        simulation.begin(self.options);
        // a run that goes on from a checkpoint has entered this many already
        let entered = self.here.ends.len();
        // what the log says of the words behind the last stage, once the deck is let go
        let mut tail = Vec::new();
        let mut read = 0;
        for (index, stage) in stages.iter().enumerate().skip(entered.saturating_sub(1)) {
            let Some(of_deck) = &deck else { break };
            read = stage.items.end;
            let is_entered = index < entered;
            if !is_entered {
                self.echo(echo(of_deck, stage.items.clone()))?;
            }
            if is_entered {
                // its settings are in force, and its findings have been said
            } else if index == 0 {
                for warning in &self.warnings {
                    self.log.line(warning)?;
                }
                self.log.line(TABLE_HEADER)?;
            } else {
                let profile = self.options.profile;
                self.here.entries.push(Entry::of(simulation));
                let findings = restage(of_deck, stage, &mut database, simulation, profile)
                    .and_then(|found| match simulation.mesh() {
                        Ok(()) => Ok(found),
                        Err(e) => Err(vec![capacity_finding(of_deck, &database, &e, None)]),
                    })
                    .map_err(|findings| {
                        let sources = Box::new(of_deck.sources().clone());
                        RunError::Stage { sources, findings }
                    })?;
                self.report_new(&findings, of_deck.sources())?;
            }
            for writer in &mut self.writers {
                writer.begin_stage(of_deck, &database)?;
            }
            let is_last = index + 1 == stages.len();
            if is_last {
                tail = echo(of_deck, read..of_deck.items().len());
                deck = None;
            }
            if !is_entered {
                self.here.ends.push(database.integer("YDC/MCSTEP"));
            }
            if index == 0 && !is_entered && self.options.settling.is_some() {
                self.here.settling = simulation.settle(self.options, self.observer)?;
                if self.here.settling.is_none() {
                    return Ok(StopReason::Interrupted);
                }
                // the speed of a run is that of its steps
                self.started = Instant::now();
            }
            let end = self.run_stage(simulation)?;
            if self.checkpoints.at_end && (end != StageEnd::Done || is_last) {
                self.write_checkpoint(simulation)?;
            }
            match end {
                StageEnd::Done => {}
                StageEnd::Enough => break,
                StageEnd::Interrupted => return Ok(StopReason::Interrupted),
            }
        }
        let rest = deck.map_or(tail, |deck| echo(&deck, read..deck.items().len()));
        self.echo(rest)?;
        Ok(StopReason::Finished)
    }

    /// Reports what was not said about an earlier stage.
    fn report_new(
        &mut self,
        findings: &[Diagnostic],
        sources: &SourceMap,
    ) -> Result<(), OutputError> {
        for finding in findings {
            let line = finding.to_string();
            if !self.warnings.contains(&line) {
                self.observer.findings(std::slice::from_ref(finding), sources);
                self.log.line(&line)?;
                self.warnings.push(line);
            }
        }
        Ok(())
    }

    /// Writes lines to the log.
    fn echo(&mut self, lines: Vec<String>) -> Result<(), OutputError> {
        lines.iter().try_for_each(|line| self.log.line(line))
    }

    fn run_stage(&mut self, simulation: &mut M) -> Result<StageEnd, RunError> {
        let control = simulation.control();
        let (interval, time_step) = (control.table_interval, control.time_step);
        let to_do = control.end_step.saturating_sub(simulation.step_index());
        let limit = self.options.steps.map_or(to_do, |n| to_do.min(n.saturating_sub(self.done)));
        let total = self.done + limit;
        let end = if limit < to_do { StageEnd::Enough } else { StageEnd::Done };
        let deck = self.options.deck.display().to_string();
        self.observer.stage_starts(&deck, simulation.size(), limit, time_step);
        let bodies = simulation.bodies() as u64;
        let mut has_notice = simulation.notice().is_some();
        self.guard.remember(simulation);
        for _ in 0..limit {
            if self.observer.wants_stop() {
                return Ok(StageEnd::Interrupted);
            }
            if simulation.step_index().is_multiple_of(interval) {
                self.row(simulation, total)?;
            } else if self.done.is_multiple_of(CLOCK_INTERVAL)
                && self.last_progress.elapsed() > PROGRESS_INTERVAL
            {
                self.last_progress = Instant::now();
                let progress = self.progress(simulation, total);
                self.observer.progress(&progress);
            }
            simulation.evaluate();
            if !has_notice && let Some(notice) = simulation.notice() {
                has_notice = true;
                self.log.line(&notice)?;
                self.warnings.push(notice);
            }
            for writer in &mut self.writers {
                writer.after_forces(simulation)?;
            }
            simulation.move_on();
            for writer in &mut self.writers {
                writer.after_motion(simulation)?;
            }
            simulation.complete();
            self.done += 1;
            self.triangle_steps += bodies;
            for writer in &mut self.writers {
                writer.after_step(simulation)?;
            }
            let step = simulation.step_index();
            let is_off = self.energy_error().is_some_and(|error| self.guard.wants_look(error));
            if is_off || step.is_multiple_of(guard::INTERVAL) {
                self.look(simulation)?;
            }
            if self.checkpoints.every.is_some_and(|steps| steps > 0 && step.is_multiple_of(steps)) {
                self.check_stability(&self.progress(simulation, total))?;
                self.write_checkpoint(simulation)?;
            }
        }
        self.look(simulation)?;
        self.check_stability(&self.progress(simulation, total))?;
        Ok(end)
    }

    /// Writes what a later run needs to go on from here, if it does not stand there already.
    fn write_checkpoint(&mut self, simulation: &M) -> Result<(), RunError> {
        let step = simulation.step_index();
        if self.last_checkpoint == Some(step) {
            return Ok(());
        }
        self.background.wait()?;
        let mut marks = Vec::with_capacity(self.writers.len());
        for writer in &mut self.writers {
            marks.push((writer.kind().to_owned(), writer.mark()?));
        }
        let checkpoint = Checkpoint {
            settings: self.settings(),
            deck: self.print,
            deck_file: self.deck_file(),
            position: self.position(),
            state: simulation.save(),
            marks,
        };
        let path = self.names.checkpoint();
        checkpoint.write(&path).map_err(OutputError::io(&path))?;
        self.last_checkpoint = Some(step);
        self.observer.checkpoint(&path, step);
        Ok(())
    }

    /// Where the deck is, whatever folder a later run is started in.
    fn deck_file(&self) -> String {
        let deck = &self.options.deck;
        std::path::absolute(deck).unwrap_or_else(|_| deck.clone()).to_string_lossy().into_owned()
    }

    /// What the run was asked for.
    fn settings(&self) -> RunSettings {
        let options = self.options;
        RunSettings {
            formats: options.formats.clone(),
            states: options.states.clone(),
            legacy_d3plot: options.legacy_d3plot,
            profile: options.profile,
            dialect: self.checkpoints.dialect.clone(),
            spatial_contact: self.checkpoints.spatial_contact,
            monitors: options.monitors.clone(),
            watch: options.watch.clone(),
        }
    }

    /// Where the run stands.
    fn position(&self) -> Position {
        Position {
            steps: self.here.steps + self.done,
            triangle_steps: self.here.triangle_steps + self.triangle_steps,
            seconds: self.here.seconds + self.started.elapsed().as_secs_f64(),
            warnings: self.warnings.clone(),
            log: Some(self.log.position()),
            ..self.here.clone()
        }
    }

    fn row(&mut self, simulation: &M, total: u64) -> Result<(), RunError> {
        let progress = self.progress(simulation, total);
        let date = jiff::Zoned::now().strftime("%d/%m/%Y %H:%M:%S").to_string();
        let seconds = self.here.seconds + progress.seconds;
        let row = table_row(progress.step, progress.time, &date, seconds);
        self.log.line(&row)?;
        self.observer.row(&row, &progress);
        self.check_stability(&progress)
    }

    /// Energy that is no number comes from positions or velocities that are none.
    fn check_stability(&self, progress: &Progress) -> Result<(), RunError> {
        let energy = progress.kinetic_energy;
        if energy.is_finite() || self.guard.mode == OnInstability::Warn {
            return Ok(());
        }
        Err(RunError::Unstable { step: progress.step, time: progress.time, energy })
    }

    /// Relative error of the balance of energies, if that is watched.
    fn energy_error(&self) -> Option<f64> {
        self.options.watch.energy_interval?;
        let energy = self.writers.iter().find_map(|writer| writer.energy());
        energy.map(|energy| energy.last.relative_error)
    }

    /// Looks whether the motion still makes sense.
    fn look(&mut self, simulation: &mut M) -> Result<(), RunError> {
        let error = self.energy_error();
        let here = simulation.step_index();
        let mut guard = std::mem::replace(&mut self.guard, Guard::new(&Watch::default()));
        let verdict = guard.look(simulation, error, &self.names, |simulation, path| {
            let checkpoint = Checkpoint {
                // its result files end where the run does
                settings: RunSettings {
                    formats: Vec::new(),
                    states: Vec::new(),
                    monitors: MonitorPlan::default(),
                    watch: Watch::default(),
                    ..self.settings()
                },
                marks: Vec::new(),
                position: {
                    let back = here - simulation.step_index();
                    let position = self.position();
                    let steps = position.steps.saturating_sub(back);
                    Position { log: None, steps, ..position }
                },
                deck: self.print,
                deck_file: self.deck_file(),
                state: simulation.save(),
            };
            checkpoint.write(&path).map_err(|e| OutputError::io(&path)(e).into())
        });
        self.guard = guard;
        match verdict {
            Verdict::Sound => {}
            Verdict::Warn(warning) => {
                let finding = Diagnostic::warning("run::instability", warning);
                self.observer.findings(std::slice::from_ref(&finding), &SourceMap::new());
                self.warnings.push(finding.to_string());
            }
            Verdict::End(error) => return Err(error),
        }
        Ok(())
    }

    fn progress(&self, simulation: &M, total: u64) -> Progress {
        Progress {
            done: self.done,
            total,
            step: simulation.step_index(),
            time: simulation.time(),
            kinetic_energy: simulation.kinetic_energy(),
            seconds: self.started.elapsed().as_secs_f64(),
        }
    }

    /// Completes all files, also after a failure, and sums the run up.
    fn complete(
        self,
        simulation: &M,
        outcome: Result<StopReason, RunError>,
        names: &OutputNames,
    ) -> Result<RunSummary, RunError> {
        let seconds = self.here.seconds + self.started.elapsed().as_secs_f64();
        let triangle_steps = self.here.triangle_steps + self.triangle_steps;
        let mut files = Vec::new();
        let mut failure = self.background.wait().err();
        let energy = self.writers.iter().find_map(|writer| writer.energy());
        for writer in self.writers {
            match writer.finish() {
                Ok(finished) => files.extend(finished),
                Err(error) => failure = failure.or(Some(error)),
            }
        }
        let stop = outcome?;
        if let Some(error) = failure {
            return Err(error.into());
        }
        let (work, size) = (simulation.contact_work(), simulation.size());
        let mut summary = RunSummary {
            stop,
            steps: self.here.steps + self.done,
            resumed_at: self.resumed_at,
            settling: self.here.settling,
            time: simulation.time(),
            nodes: size.nodes,
            triangles: size.triangles,
            tetrahedra: size.tetrahedra,
            broken_joints: simulation.broken_joints(),
            kinetic_energy: simulation.kinetic_energy(),
            seconds,
            triangle_steps_per_second: triangle_steps as f64 / seconds.max(1e-9),
            detections: work.detections,
            couples_evaluated: work.evaluated,
            couples_rested: work.rested,
            phases: simulation.phases(),
            energy,
            files,
            ..empty_summary(self.options, self.warnings)
        };
        if self.last_checkpoint.is_some() {
            summary.files.push(names.checkpoint());
        }
        if self.options.formats.contains(&Format::Json) {
            summary.files.push(write_summary(names.summary(), &summary)?);
        }
        self.observer.finished(&summary);
        Ok(summary)
    }
}

/// Results cannot take the place of a folder: better said before the run than after it.
fn check_names(names: &OutputNames, checkpoints: &Checkpoints) -> Result<(), OutputError> {
    let checkpoint = checkpoints.are_written().then(|| names.checkpoint());
    let results = [names.d3plot(), names.pvd(), names.history(0), names.log()];
    for path in results.into_iter().chain(checkpoint) {
        if path.is_dir() {
            let source = std::io::Error::other("there is a folder of this name");
            return Err(OutputError::Io { path, source });
        }
    }
    Ok(())
}

fn write_summary(path: PathBuf, summary: &RunSummary) -> Result<PathBuf, OutputError> {
    let write = || {
        let mut file = PartFile::create(&path)?;
        serde_json::to_writer_pretty(&mut file, summary)?;
        writeln!(file)?;
        file.complete()
    };
    write().map_err(OutputError::io(path.clone()))
}

fn empty_summary(options: &RunOptions, warnings: Vec<String>) -> RunSummary {
    RunSummary {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        deck: options.deck.clone(),
        stop: StopReason::Finished,
        steps: 0,
        time: 0.0,
        nodes: 0,
        triangles: 0,
        tetrahedra: 0,
        broken_joints: 0,
        kinetic_energy: 0.0,
        seconds: 0.0,
        triangle_steps_per_second: 0.0,
        detections: 0,
        couples_evaluated: 0,
        couples_rested: 0,
        settling: None,
        phases: None,
        energy: None,
        resumed_at: None,
        warnings,
        files: Vec::new(),
    }
}
