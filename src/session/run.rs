use super::{
    Format,
    load::{LoadedDeck, capacity_finding},
    observer::{Observer, Progress},
    restage::restage,
    summary::{RunSummary, StopReason},
};
use crate::{
    output::{
        D3plotOutput, HistoryOutput, MonitorOutput, MonitorPlan, OutputError, OutputNames,
        RestartDeckOutput, ResultWriter, RunTable, SnapshotOutput, StateFileOutput, TABLE_HEADER,
        VtuOutput, table_row,
    },
    scene::Profile,
    simulation::Simulation,
};
use std::{
    io::Write as _,
    ops::Range,
    path::PathBuf,
    time::{Duration, Instant},
};
use thiserror::Error;
use yformat::{
    d3plot::StartDate, deck::Deck, diagnostic::Diagnostic, part_file::PartFile, source::SourceMap,
};

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
    /// Program followed for later stages of the deck.
    pub profile: Profile,
}

/// Why a run failed.
#[derive(Debug, Error)]
pub enum RunError {
    /// A result file could not be written.
    #[error(transparent)]
    Output(#[from] OutputError),
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
    /// A later stage of the deck cannot be run.
    #[error("a later stage of the deck has errors; results of the earlier stages are complete")]
    Stage {
        /// Sources that the findings point into.
        sources: Box<SourceMap>,
        /// Findings, errors among them.
        findings: Vec<Diagnostic>,
    },
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
    let names = OutputNames::new(&options.deck, &options.folder);
    std::fs::create_dir_all(&options.folder).map_err(OutputError::io(&options.folder))?;
    check_names(&names)?;
    let mut log = RunTable::create(&names.log())?;
    observer.findings(&loaded.findings, loaded.deck.sources());
    let warnings: Vec<String> = loaded.findings.iter().map(ToString::to_string).collect();
    let Some(simulation) = &loaded.simulation else {
        for line in loaded.deck.echo_lines().iter().chain(&warnings) {
            log.line(line)?;
        }
        return Ok(empty_summary(options, warnings));
    };
    let writers = open_writers(options, &names, simulation)?;
    let mut session = Session {
        options,
        observer,
        log,
        writers,
        warnings,
        started: Instant::now(),
        last_progress: Instant::now(),
        done: 0,
        triangle_steps: 0,
    };
    let (simulation, outcome) = session.run_stages(loaded);
    session.complete(&simulation, outcome, &names)
}

fn open_writers(
    options: &RunOptions,
    names: &OutputNames,
    simulation: &Simulation,
) -> Result<Vec<Box<dyn ResultWriter>>, OutputError> {
    let mut writers: Vec<Box<dyn ResultWriter>> = Vec::new();
    let formats = Format::expand(&options.formats, simulation.scene().conventions.dialect);
    if !options.monitors.is_empty() {
        writers.push(Box::new(MonitorOutput::open(names, &options.monitors, simulation)?));
    }
    if formats.contains(&Format::Yh) {
        writers.push(Box::new(HistoryOutput::open(names, simulation)?));
    }
    let is_classic = simulation.classic_joints().is_some();
    if is_classic && formats.contains(&Format::Ym) {
        writers.push(Box::new(SnapshotOutput::open(names, simulation)?));
    }
    if is_classic && formats.contains(&Format::Restart) {
        writers.push(Box::new(RestartDeckOutput::new(names)));
    }
    if formats.contains(&Format::D3plot) {
        let today = jiff::Zoned::now().date();
        let start = StartDate {
            day: today.day().unsigned_abs(),
            month: today.month().unsigned_abs(),
            year: today.year().unsigned_abs(),
        };
        writers.push(Box::new(D3plotOutput::new(names, start, options.legacy_d3plot)));
    }
    if formats.contains(&Format::Vtu) {
        writers.push(Box::new(VtuOutput::new(names)));
    }
    if !options.states.is_empty() {
        writers.push(Box::new(StateFileOutput::new(names, options.states.iter().copied())));
    }
    Ok(writers)
}

struct Session<'a> {
    options: &'a RunOptions,
    observer: &'a mut dyn Observer,
    log: RunTable,
    writers: Vec<Box<dyn ResultWriter>>,
    warnings: Vec<String>,
    started: Instant,
    last_progress: Instant,
    done: u64,
    triangle_steps: u64,
}

impl Session<'_> {
    fn run_stages(&mut self, loaded: LoadedDeck) -> (Simulation, Result<StopReason, RunError>) {
        let LoadedDeck { deck, mut database, stages, simulation, .. } = loaded;
        let Some(mut simulation) = simulation else {
            unreachable!("a run without simulation ends before its stages");
        };
        if self.options.monitors.needs_contact_forces() {
            simulation.watch_contact_forces();
        }
        let outcome = (|| {
            for (index, stage) in stages.iter().enumerate() {
                self.echo(&deck, stage.items.clone())?;
                if index == 0 {
                    for warning in &self.warnings {
                        self.log.line(warning)?;
                    }
                    self.log.line(TABLE_HEADER)?;
                } else {
                    let profile = self.options.profile;
                    let findings = restage(&deck, stage, &mut database, &mut simulation, profile)
                        .and_then(|found| match simulation.prepare() {
                            Ok(()) => Ok(found),
                            Err(e) => Err(vec![capacity_finding(&deck, &database, &e, None)]),
                        })
                        .map_err(|findings| {
                            let sources = Box::new(deck.sources().clone());
                            RunError::Stage { sources, findings }
                        })?;
                    self.report_new(&findings, deck.sources())?;
                }
                for writer in &mut self.writers {
                    writer.begin_stage(&deck, &database)?;
                }
                if self.run_stage(&mut simulation)? == StopReason::Interrupted {
                    return Ok(StopReason::Interrupted);
                }
            }
            let read = stages.last().map_or(0, |stage| stage.items.end);
            self.echo(&deck, read..deck.items().len())?;
            Ok(StopReason::Finished)
        })();
        (simulation, outcome)
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

    /// Writes the words of some items to the log.
    fn echo(&mut self, deck: &Deck, items: Range<usize>) -> Result<(), OutputError> {
        items.filter_map(|item| deck.echo_of(item)).try_for_each(|line| self.log.line(&line))
    }

    fn run_stage(&mut self, simulation: &mut Simulation) -> Result<StopReason, RunError> {
        let control = &simulation.scene().control;
        let interval = control.table_interval;
        let to_do = control.end_step.saturating_sub(simulation.step_index());
        let limit = self.options.steps.map_or(to_do, |n| to_do.min(n.saturating_sub(self.done)));
        let total = self.done + limit;
        let deck = self.options.deck.display().to_string();
        self.observer.stage_starts(&deck, simulation, limit);
        let triangles = simulation.triangles().count() as u64;
        for _ in 0..limit {
            if self.observer.wants_stop() {
                return Ok(StopReason::Interrupted);
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
            simulation.evaluate_forces();
            for writer in &mut self.writers {
                writer.after_forces(simulation)?;
            }
            simulation.move_bodies();
            for writer in &mut self.writers {
                writer.after_motion(simulation)?;
            }
            simulation.complete_step();
            self.done += 1;
            self.triangle_steps += triangles;
            for writer in &mut self.writers {
                writer.after_step(simulation)?;
            }
        }
        check_stability(&self.progress(simulation, total))?;
        Ok(StopReason::Finished)
    }

    fn row(&mut self, simulation: &Simulation, total: u64) -> Result<(), RunError> {
        let progress = self.progress(simulation, total);
        let date = jiff::Zoned::now().strftime("%d/%m/%Y %H:%M:%S").to_string();
        let row = table_row(progress.step, progress.time, &date, progress.seconds);
        self.log.line(&row)?;
        self.observer.row(&row, &progress);
        check_stability(&progress)
    }

    fn progress(&self, simulation: &Simulation, total: u64) -> Progress {
        Progress {
            done: self.done,
            total,
            step: simulation.step_index(),
            time: simulation.time(),
            kinetic_energy: simulation.sum_kinetic_energy(),
            seconds: self.started.elapsed().as_secs_f64(),
        }
    }

    /// Completes all files, also after a failure, and sums the run up.
    fn complete(
        self,
        simulation: &Simulation,
        outcome: Result<StopReason, RunError>,
        names: &OutputNames,
    ) -> Result<RunSummary, RunError> {
        let seconds = self.started.elapsed().as_secs_f64();
        let mut files = Vec::new();
        let mut failure = None;
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
        let work = simulation.couple_work().unwrap_or_default();
        let mut summary = RunSummary {
            stop,
            steps: self.done,
            time: simulation.time(),
            nodes: simulation.scene().nodes.len(),
            triangles: simulation.triangles().count(),
            broken_joints: simulation.failures().len(),
            kinetic_energy: simulation.sum_kinetic_energy(),
            seconds,
            triangle_steps_per_second: self.triangle_steps as f64 / seconds.max(1e-9),
            detections: work.detections,
            couples_evaluated: work.evaluated,
            couples_rested: work.rested,
            files,
            ..empty_summary(self.options, self.warnings)
        };
        if self.options.formats.contains(&Format::Json) {
            summary.files.push(write_summary(names.summary(), &summary)?);
        }
        self.observer.finished(&summary);
        Ok(summary)
    }
}

/// Energy that is no number comes from positions or velocities that are none.
fn check_stability(progress: &Progress) -> Result<(), RunError> {
    let energy = progress.kinetic_energy;
    if energy.is_finite() {
        return Ok(());
    }
    Err(RunError::Unstable { step: progress.step, time: progress.time, energy })
}

/// Results cannot take the place of a folder: better said before the run than after it.
fn check_names(names: &OutputNames) -> Result<(), OutputError> {
    for path in [names.d3plot(), names.pvd(), names.history(0), names.log()] {
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
        broken_joints: 0,
        kinetic_energy: 0.0,
        seconds: 0.0,
        triangle_steps_per_second: 0.0,
        detections: 0,
        couples_evaluated: 0,
        couples_rested: 0,
        warnings,
        files: Vec::new(),
    }
}
