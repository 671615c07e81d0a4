//! `ypsilon bench`: how fast scenes run, and what accuracy costs.

use super::{
    Exit,
    console::{say, warn},
    deck_report,
};
use crate::{
    bench::{
        BenchError, Plan, Program, Report, SCENES, Scene, Subject, Work, found_decks, markdown,
        run_suite, work, work_precision,
    },
    team::Team,
};
use clap::Args;
use std::path::{Path, PathBuf};

/// What is told below the help.
pub(super) const HELP: &str = "\
Without --scene and --deck all scenes that Ypsilon makes itself are run, and the Granada masonry
deck if it lies at ../shared/thirdparty/masonry. Every run has a process of its own.

Examples:
  ypsilon bench
  ypsilon bench --scene jointed --scene elastic --threads 1,2 --repeat 5
  ypsilon bench --deck bridge.y --steps 2000 --json bridge.json
  ypsilon bench --growth --instructions --markdown docs/src/performance.md
  ypsilon bench --work-precision --out work-precision

Exit codes:
  0    everything is measured
  1    a deck cannot be run, or a document has no place for the tables
  2    the command line is wrong
  3    a file cannot be written";

/// Sizes of growth series, triangles.
const GROWTH: [usize; 5] = [2000, 5000, 20_000, 80_000, 200_000];

/// What to measure.
#[derive(Debug, Args)]
pub(super) struct BenchArguments {
    /// Scene to run, repeatable: those of --list
    #[arg(long = "scene", value_name = "NAME", value_delimiter = ',')]
    scenes: Vec<String>,
    /// Deck to run, repeatable
    #[arg(long = "deck", value_name = "FILE", num_args = 1..)]
    decks: Vec<PathBuf>,
    /// List scenes and the decks that are found
    #[arg(long)]
    list: bool,
    /// Steps of each run [default: each scene's own number, or what the deck says]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u64).range(1..))]
    steps: Option<u64>,
    /// Numbers of threads [default: 1, and all cores]
    #[arg(long, value_name = "N,N,...", value_delimiter = ',',
          value_parser = clap::value_parser!(u16).range(1..))]
    threads: Vec<u16>,
    /// Runs of each scene with each number of threads
    #[arg(long, value_name = "N", default_value_t = 3,
          value_parser = clap::value_parser!(u16).range(1..))]
    repeat: u16,
    /// Write the figures as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Put the tables between the markers of a Markdown document, or make it
    #[arg(long, value_name = "FILE")]
    markdown: Option<PathBuf>,
    /// Run the scenes in sizes from 2 to 200 thousand triangles as well
    #[arg(long)]
    growth: bool,
    /// Count instructions per triangle-step (needs valgrind)
    #[arg(long)]
    instructions: bool,
    /// Compare solutions with exact answers over time step, penalty, contact buffer, mesh and
    /// viscosity instead: tables (CSV) and curves
    #[arg(long, conflicts_with_all = ["scenes", "decks", "steps", "json", "markdown", "growth", "instructions"])]
    work_precision: bool,
    /// Problem of --work-precision, repeatable [default: all]
    #[arg(
        long = "problem",
        value_name = "NAME",
        value_delimiter = ',',
        requires = "work_precision"
    )]
    problems: Vec<String>,
    /// Folder of the results of --work-precision
    #[arg(long = "out", value_name = "DIR", default_value = "work-precision")]
    folder: PathBuf,
    /// Do one run of this deck and print its measurement
    #[arg(long, value_name = "DECK", hide = true)]
    worker: Option<PathBuf>,
    #[arg(long, value_name = "DIR", hide = true, default_value = ".")]
    worker_folder: PathBuf,
    #[arg(long, hide = true)]
    worker_phases: bool,
}

/// Measures.
pub(super) fn main(arguments: &BenchArguments) -> Exit {
    let outcome = if let Some(deck) = &arguments.worker {
        run_worker(arguments, deck)
    } else if arguments.list {
        list();
        Ok(())
    } else if arguments.work_precision {
        work_precision::run(
            &arguments.problems,
            usize::from(arguments.repeat),
            &arguments.folder,
            &mut |line| say(line),
        )
    } else {
        run(arguments)
    };
    match outcome {
        Ok(()) => Exit::Done,
        Err(BenchError::Deck(fault)) => deck_report::print_fault(&fault, true),
        Err(error) => {
            warn(&format!("error: {error}"));
            exit_of(&error)
        }
    }
}

fn exit_of(error: &BenchError) -> Exit {
    use crate::session::RunError;
    match error {
        BenchError::NoScene { .. } => Exit::Usage,
        BenchError::Io { .. } | BenchError::Run(RunError::Output(_)) | BenchError::Post(_) => {
            Exit::Output
        }
        BenchError::Run(RunError::Unstable { .. }) => Exit::Unstable,
        _ => Exit::Input,
    }
}

fn run_worker(arguments: &BenchArguments, deck: &Path) -> Result<(), BenchError> {
    let threads = arguments.threads.first().copied().unwrap_or(1);
    let team = Team::new(threads.into()).map_err(BenchError::io("threads"))?;
    let task = Work {
        deck: deck.to_path_buf(),
        folder: arguments.worker_folder.clone(),
        steps: arguments.steps,
        takes_phases: arguments.worker_phases,
    };
    let measurement = work(&task, team)?;
    let text = serde_json::to_string(&measurement);
    say(&text.map_err(|error| BenchError::io("the measurement")(error.into()))?);
    Ok(())
}

fn list() {
    for scene in &SCENES {
        say(&format!("{:<22} {}", scene.name, scene.about));
    }
    for (name, path) in found_decks(Path::new(".")) {
        say(&format!("{name:<22} {}", path.display()));
    }
}

/// Scenes and decks that the command line names.
fn subjects(arguments: &BenchArguments) -> Result<Vec<Subject>, BenchError> {
    let found = found_decks(Path::new("."));
    let deck =
        |(name, path): &(String, PathBuf)| Subject::Deck { name: name.clone(), path: path.clone() };
    let mut subjects = Vec::new();
    for name in &arguments.scenes {
        let own = Scene::find(name).map(Subject::Scene);
        let known = own.or_else(|| found.iter().find(|(n, _)| n == name).map(deck));
        subjects.push(known.ok_or_else(|| {
            BenchError::NoScene {
                name: name.clone(),
                known: SCENES
                    .iter()
                    .map(|scene| scene.name.to_owned())
                    .chain(found.iter().map(|(name, _)| name.clone()))
                    .collect(),
            }
        })?);
    }
    subjects.extend(arguments.decks.iter().map(|path| Subject::Deck {
        name: path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
        path: path.clone(),
    }));
    if subjects.is_empty() {
        subjects.extend(SCENES.iter().map(Subject::Scene));
        subjects.extend(found.iter().filter(|(name, _)| name == "granada").map(deck));
    }
    Ok(subjects)
}

fn run(arguments: &BenchArguments) -> Result<(), BenchError> {
    let mut threads: Vec<usize> = arguments.threads.iter().copied().map(usize::from).collect();
    if threads.is_empty() {
        threads = vec![1, std::thread::available_parallelism().map_or(1, usize::from)];
        threads.dedup();
    }
    let plan = Plan {
        subjects: subjects(arguments)?,
        steps: arguments.steps,
        threads,
        repeats: usize::from(arguments.repeat),
        growth: if arguments.growth { GROWTH.to_vec() } else { Vec::new() },
        counts_instructions: arguments.instructions,
    };
    let report = run_suite(&plan, &Program::this()?, &mut |line| warn(line))?;
    say(markdown::tables(&report).trim());
    if let Some(path) = &arguments.json {
        write_json(&report, path)?;
    }
    if let Some(path) = &arguments.markdown {
        markdown::write(&report, path)?;
    }
    Ok(())
}

fn write_json(report: &Report, path: &Path) -> Result<(), BenchError> {
    let text = report.to_json().map_err(|error| BenchError::io(path)(error.into()))?;
    std::fs::write(path, text + "\n").map_err(BenchError::io(path))
}
