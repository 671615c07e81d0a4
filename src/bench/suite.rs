//! The suite: which runs are done, and what their measurements amount to.

use super::{
    BenchError, Counted, Growth, Machine, Measurement, Program, Report, Run, Scene, SceneReport,
    Spread, Work, growth_exponent,
};
use std::path::{Path, PathBuf};
use tempfile::TempDir;

/// What is measured.
#[derive(Debug, Clone)]
pub enum Subject {
    /// A scene that Ypsilon makes.
    Scene(&'static Scene),
    /// A deck.
    Deck {
        /// Its name in the report.
        name: String,
        /// The file.
        path: PathBuf,
    },
}

/// What a suite does.
#[derive(Debug, Clone)]
pub struct Plan {
    /// Scenes and decks, in the order of the report.
    pub subjects: Vec<Subject>,
    /// Steps of each run; each scene's own number, and what decks say, without it.
    pub steps: Option<u64>,
    /// Numbers of threads.
    pub threads: Vec<usize>,
    /// Runs of each scene with each number of threads; at least one is done.
    pub repeats: usize,
    /// Sizes of growth series, in triangles; no series if there are none.
    pub growth: Vec<usize>,
    /// Whether instructions are counted.
    pub counts_instructions: bool,
}

/// Triangle-steps of each run of a growth series.
const GROWTH_WORK: u64 = 4_000_000;
/// Least steps of such a run.
const GROWTH_STEPS: u64 = 100;
/// Steps of the two runs whose instructions are compared.
const COUNTED_STEPS: [u64; 2] = [10, 60];

/// Runs a suite. `say` is told what is being done.
///
/// # Errors
/// If a scene cannot be made or a run fails.
pub fn run_suite(
    plan: &Plan,
    program: &Program,
    say: &mut dyn FnMut(&str),
) -> Result<Report, BenchError> {
    let machine = Machine::here();
    let folder = TempDir::new().map_err(BenchError::io("a temporary folder"))?;
    let mut suite = Suite {
        plan,
        program,
        folder: folder.path(),
        notes: Vec::from_iter(machine.caution()),
        say,
    };
    let mut jobs = Vec::new();
    for subject in &plan.subjects {
        jobs.push(suite.job(subject)?);
    }
    let scenes = suite.measure(&jobs, plan.counts_instructions)?;
    let mut growth = Vec::new();
    for subject in &plan.subjects {
        if let Subject::Scene(scene) = subject
            && scene.grows()
            && !plan.growth.is_empty()
        {
            growth.extend(suite.growth(scene)?);
        }
    }
    Ok(Report {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        date: jiff::Zoned::now().strftime("%Y-%m-%d").to_string(),
        machine,
        repeats: plan.repeats.max(1),
        scenes,
        growth,
        notes: suite.notes,
    })
}

struct Suite<'a> {
    plan: &'a Plan,
    program: &'a Program,
    folder: &'a Path,
    notes: Vec<String>,
    say: &'a mut dyn FnMut(&str),
}

/// A deck to be run.
struct Job {
    name: String,
    about: String,
    deck: PathBuf,
    steps: Option<u64>,
}

/// Measurements of a job with a number of threads.
#[derive(Default)]
struct Taken {
    /// Measurement and seconds of the process of each run.
    runs: Vec<(Measurement, f64)>,
    timed: Option<Measurement>,
}

impl Suite<'_> {
    fn job(&self, subject: &Subject) -> Result<Job, BenchError> {
        match subject {
            Subject::Scene(scene) => {
                self.made(scene, scene.triangles, self.plan.steps.unwrap_or(scene.steps))
            }
            Subject::Deck { name, path } => Ok(Job {
                name: name.clone(),
                about: "a deck".to_owned(),
                deck: path.clone(),
                steps: self.plan.steps,
            }),
        }
    }

    /// Makes a scene's deck.
    fn made(&self, scene: &Scene, triangles: usize, steps: u64) -> Result<Job, BenchError> {
        let deck = self.folder.join(format!("{}-{triangles}.y", scene.name));
        // the deck of the instruction count is the same: it must allow those steps, too
        let most = steps.max(COUNTED_STEPS[1]);
        let text = scene.deck(triangles, most)?.to_text();
        std::fs::write(&deck, text).map_err(BenchError::io(&deck))?;
        let (name, about) = (scene.name.to_owned(), scene.about.to_owned());
        Ok(Job { name, about, deck, steps: Some(steps) })
    }

    /// Measures jobs: all of them once, then all of them again, so that a machine that is busy
    /// for a while does not spoil all runs of one scene.
    fn measure(
        &mut self,
        jobs: &[Job],
        counts_instructions: bool,
    ) -> Result<Vec<SceneReport>, BenchError> {
        let Plan { threads, repeats, .. } = self.plan;
        let repeats = (*repeats).max(1);
        let mut taken: Vec<Vec<Taken>> =
            jobs.iter().map(|_| threads.iter().map(|_| Taken::default()).collect()).collect();
        for repeat in 0..repeats {
            for (job, taken) in jobs.iter().zip(&mut taken) {
                for (&threads, taken) in threads.iter().zip(taken) {
                    (self.say)(&format!(
                        "{}: run {} of {repeats} on {threads} thread(s)",
                        job.name,
                        repeat + 1
                    ));
                    taken.runs.push(self.run(job, threads, false)?);
                }
            }
        }
        let mut reports = Vec::new();
        for (job, taken) in jobs.iter().zip(&mut taken) {
            for (&threads, taken) in threads.iter().zip(taken.iter_mut()) {
                (self.say)(&format!("{}: phases on {threads} thread(s)", job.name));
                taken.timed = Some(self.run(job, threads, true)?.0);
            }
            let instructions = match counts_instructions {
                true => self.instructions(job)?,
                false => None,
            };
            reports.extend(report(job, threads, taken, instructions));
        }
        Ok(reports)
    }

    fn run(
        &self,
        job: &Job,
        threads: usize,
        takes_phases: bool,
    ) -> Result<(Measurement, f64), BenchError> {
        let work = Work {
            deck: job.deck.clone(),
            folder: self.folder.join("results"),
            steps: job.steps,
            takes_phases,
        };
        self.program.measure(&work, threads)
    }

    /// Instructions for each triangle-step: the difference of two runs, so that reading the deck,
    /// the first detection and the first output cancel out.
    fn instructions(&mut self, job: &Job) -> Result<Option<f64>, BenchError> {
        (self.say)(&format!("{}: counting instructions", job.name));
        let mut counts = [0; 2];
        let mut done = [0; 2];
        let mut triangles = 0;
        for (k, steps) in COUNTED_STEPS.into_iter().enumerate() {
            let folder = self.folder.join("results");
            let steps = Some(steps);
            let work = Work { deck: job.deck.clone(), folder, steps, takes_phases: false };
            let (measurement, _) = self.program.measure(&work, 1)?;
            (done[k], triangles) = (measurement.steps, measurement.triangles as u64);
            counts[k] = match self.program.count(&work)? {
                Counted::Instructions(count) => count,
                Counted::Impossible(reason) => {
                    if !self.notes.contains(&reason) {
                        (self.say)(&reason);
                        self.notes.push(reason);
                    }
                    return Ok(None);
                }
            };
        }
        let work = triangles * done[1].saturating_sub(done[0]);
        let more = counts[1].saturating_sub(counts[0]);
        Ok((work > 0).then(|| more as f64 / work as f64))
    }

    /// A scene in several sizes, for each number of threads.
    fn growth(&mut self, scene: &Scene) -> Result<Vec<Growth>, BenchError> {
        let mut jobs = Vec::new();
        for &triangles in &self.plan.growth {
            let steps = (GROWTH_WORK / triangles.max(1) as u64).max(GROWTH_STEPS);
            jobs.push(self.made(scene, triangles, self.plan.steps.unwrap_or(steps))?);
        }
        let sizes = self.measure(&jobs, false)?;
        let series = self.plan.threads.iter().enumerate().map(|(k, &threads)| {
            let sizes: Vec<SceneReport> = sizes
                .iter()
                .map(|size| SceneReport {
                    runs: size.runs.get(k).cloned().into_iter().collect(),
                    ..size.clone()
                })
                .collect();
            let points = |of: &dyn Fn(&SceneReport, &Run) -> Option<f64>| -> Vec<[f64; 2]> {
                let runs = sizes.iter().filter_map(|size| Some((size, size.runs.first()?)));
                runs.filter_map(|(size, run)| Some([size.triangles as f64, of(size, run)?]))
                    .collect()
            };
            let time =
                |size: &SceneReport, run: &Run| Some(size.triangles as f64 / run.step_loop.median);
            let memory = |_: &SceneReport, run: &Run| Some(run.peak_memory? as f64);
            Growth {
                name: scene.name.to_owned(),
                threads,
                time_exponent: growth_exponent(&points(&time)),
                memory_exponent: growth_exponent(&points(&memory)),
                sizes,
            }
        });
        Ok(series.collect())
    }
}

/// What the measurements of a job amount to; `None` if nothing was measured.
fn report(
    job: &Job,
    threads: &[usize],
    taken: &[Taken],
    instructions: Option<f64>,
) -> Option<SceneReport> {
    let (first, _) = taken.first()?.runs.first()?;
    let mut runs: Vec<Run> =
        threads.iter().zip(taken).filter_map(|(&n, taken)| run(n, taken)).collect();
    let base = runs.iter().min_by_key(|run| run.threads).map(|run| run.step_loop.median)?;
    for run in &mut runs {
        run.speed_up = run.step_loop.median / base;
    }
    Some(SceneReport {
        name: job.name.clone(),
        about: job.about.clone(),
        triangles: first.triangles,
        joints: first.joints,
        nodes: first.nodes,
        steps: first.steps,
        runs,
        instructions_per_triangle_step: instructions,
    })
}

fn run(threads: usize, taken: &Taken) -> Option<Run> {
    let speeds = |seconds: &dyn Fn(&(Measurement, f64)) -> f64| -> Vec<f64> {
        let speed = |run: &(Measurement, f64)| {
            let work = run.0.triangles as f64 * run.0.steps as f64;
            work / seconds(run).max(1e-9)
        };
        taken.runs.iter().map(speed).collect()
    };
    let timed = taken.timed.as_ref()?;
    let (last, _) = taken.runs.last()?;
    let peak_memory = taken.runs.iter().filter_map(|(m, _)| m.peak_memory).max();
    let per_step = |count: u64| count as f64 / last.steps.max(1) as f64;
    Some(Run {
        threads,
        process: Spread::of(&speeds(&|run| run.1))?,
        step_loop: Spread::of(&speeds(&|run| run.0.loop_seconds))?,
        speed_up: 1.0,
        phases_of_seconds: timed.loop_seconds,
        phases: timed.phases.unwrap_or_default(),
        broken_joints: last.broken_joints,
        detections: last.detections,
        couples_per_step: per_step(last.couples_evaluated),
        rested_per_step: per_step(last.couples_rested),
        peak_memory,
        memory_per_triangle: peak_memory.map(|m| m as f64 / last.triangles.max(1) as f64),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::simulation::PhaseTimes;

    fn measurement(loop_seconds: f64, memory: u64) -> Measurement {
        Measurement {
            steps: 100,
            nodes: 300,
            triangles: 200,
            joints: 250,
            broken_joints: 1,
            loop_seconds,
            detections: 2,
            couples_evaluated: 5000,
            couples_rested: 700,
            phases: Some(PhaseTimes { overlap: 0.5 * loop_seconds, ..PhaseTimes::default() }),
            peak_memory: Some(memory),
        }
    }

    #[test]
    fn measurements_become_figures() {
        let job =
            Job { name: "x".to_owned(), about: "y".to_owned(), deck: PathBuf::new(), steps: None };
        let taken = |seconds: [f64; 3]| Taken {
            runs: seconds.map(|s| (measurement(s, 1_000_000), 2.0 * s)).to_vec(),
            timed: Some(measurement(seconds[0], 9_000_000)),
        };
        let taken = [taken([0.1, 0.4, 0.2]), taken([0.1, 0.1, 0.1])];
        let report = report(&job, &[1, 2], &taken, Some(700.0)).expect("a report");
        let [one, two] = report.runs.as_slice() else { panic!("two runs") };
        assert!((one.step_loop.median - 1e5).abs() < 1e-6, "{one:?}");
        assert!((one.step_loop.min - 5e4).abs() < 1e-6 && (one.step_loop.max - 2e5).abs() < 1e-6);
        assert!((one.process.median - 5e4).abs() < 1e-6);
        assert!((two.speed_up - 2.0).abs() < 1e-12 && one.speed_up == 1.0);
        // the process that takes the time of phases is not one of those measured
        assert_eq!((one.peak_memory, one.memory_per_triangle), (Some(1_000_000), Some(5000.0)));
        assert_eq!((one.couples_per_step, one.rested_per_step), (50.0, 7.0));
        assert!((one.output_seconds() - 0.05).abs() < 1e-12);
    }
}
