//! `ypsilon sweep`: parameter studies.

use super::{
    Exit,
    console::{say, warn},
    deck_report, interrupt, run,
    sweep_progress::Display,
};
use crate::sweep::{
    Case, Record, Runner, Scheduler, State, Study, StudyError, StudyTable, SweepError,
    jobs_and_threads, parquet_is_there,
};
use clap::{Args, Subcommand, ValueEnum};
use std::{
    path::{Path, PathBuf},
    thread::available_parallelism,
};
use yformat::{dialect::Dialect, source::SourceMap};

/// What is told below the help.
pub(super) const HELP: &str = "\
A study is a TOML file:

  base = \"wall.y\"                       # a deck, or a scenario (.toml)

  [parameters.young]
  target = [\"YDPE/D1PELA[0]\", \"YDPE/D1PEMU[0]\"]
  values = [0.5, 1, 2]
  factor = true                         # times what the deck has

  [outputs.crown]
  what = \"history\"
  field = \"uy\"
  nearest = [0.0, 2.4]

Examples:
  ypsilon sweep study.toml --dry-run
  ypsilon sweep study.toml --jobs 8
  ypsilon sweep export study.toml --to slurm
  ypsilon sweep collect study.toml

Exit codes:
  0    all cases are done, the table is written
  1    the study or its base cannot be read or has errors, or has changed since its folder was made
  2    the command line is wrong
  3    a file cannot be written
  6    some cases have failed or are missing; the table has the others
  130  interrupted; the same command goes on";

/// Study and subcommands.
#[derive(Debug, Args)]
#[command(args_conflicts_with_subcommands = true, arg_required_else_help = true)]
pub(super) struct SweepArguments {
    #[command(subcommand)]
    command: Option<SweepCommand>,
    #[command(flatten)]
    local: Option<LocalArguments>,
}

#[derive(Debug, Subcommand)]
enum SweepCommand {
    /// Write the cases and a job list for a cluster
    Export(ExportArguments),
    /// Run single cases, as job lists do
    RunCase(RunCaseArguments),
    /// Make the table from the cases that are over
    Collect(CollectArguments),
}

#[derive(Debug, Args)]
struct LocalArguments {
    /// Study (.toml)
    study: PathBuf,
    /// Folder of the cases and the table [default: the study's name without its ending, beside it]
    #[arg(long = "out", value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Cases that run at once [default: one for each core]
    #[arg(long, short, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Threads of each case [default: what the study says, or the cores that --jobs leaves]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// List the cases and what has become of them; run nothing
    #[arg(long)]
    dry_run: bool,
    /// Run cases anew whose inputs have changed since they were run
    #[arg(long)]
    update: bool,
    /// Run cases that failed once more
    #[arg(long)]
    retry: bool,
    /// Write the table as Parquet, too
    #[arg(long)]
    parquet: bool,
    /// Print nothing but errors
    #[arg(long, short)]
    quiet: bool,
}

#[derive(Debug, Args)]
struct ExportArguments {
    /// Study (.toml)
    study: PathBuf,
    /// Folder of the cases and the table [default: the study's name without its ending, beside it]
    #[arg(long = "out", value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Whom the jobs are for
    #[arg(long, value_enum, value_name = "WHOM")]
    to: SchedulerName,
    /// Write the files of cases anew whose inputs have changed
    #[arg(long)]
    update: bool,
}

/// Who runs jobs.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
enum SchedulerName {
    /// An array of jobs: slurm.sh
    Slurm,
    /// GNU Parallel: jobs.txt and parallel.sh
    Parallel,
}

#[derive(Debug, Args)]
struct RunCaseArguments {
    /// Study (.toml)
    study: PathBuf,
    /// Numbers of cases, from 1: 7, or 7-12
    #[arg(required = true, value_name = "CASE", value_parser = case_numbers)]
    cases: Vec<(usize, usize)>,
    /// Folder of the cases [default: the study's name without its ending, beside it]
    #[arg(long = "out", value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Threads of the case [default: what the study says, or 1]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    threads: Option<u16>,
    /// Run the case once more if it failed
    #[arg(long)]
    retry: bool,
    /// Print nothing but errors
    #[arg(long, short)]
    quiet: bool,
}

#[derive(Debug, Args)]
struct CollectArguments {
    /// Study (.toml)
    study: PathBuf,
    /// Folder of the cases and the table [default: the study's name without its ending, beside it]
    #[arg(long = "out", value_name = "DIR")]
    folder: Option<PathBuf>,
    /// Write the table as Parquet, too
    #[arg(long)]
    parquet: bool,
    /// Print nothing but errors
    #[arg(long, short)]
    quiet: bool,
}

fn case_numbers(words: &str) -> Result<(usize, usize), String> {
    let (first, last) = words.split_once('-').unwrap_or((words, words));
    match (first.parse(), last.parse()) {
        (Ok(first), Ok(last)) if first <= last => Ok((first, last)),
        _ => Err("expected a number such as 7, or two such as 7-12".to_owned()),
    }
}

fn read(study: &Path, folder: Option<&Path>) -> Result<Study, SweepError> {
    Ok(Study::read(study, folder, &check_flags)?)
}

/// Flags of a study, by the parser of `ypsilon run`.
fn check_flags(flags: &[String]) -> Result<Option<Dialect>, String> {
    #[derive(clap::Parser)]
    struct Run {
        #[command(flatten)]
        run: run::RunArguments,
    }
    let words = ["ypsilon run", "deck.y"].into_iter().chain(flags.iter().map(String::as_str));
    match <Run as clap::Parser>::try_parse_from(words) {
        Ok(parsed) => Ok(parsed.run.dialect()),
        Err(error) => {
            let text = error.to_string();
            let first = text.lines().next().unwrap_or_default();
            Err(first.trim_start_matches("error: ").to_owned())
        }
    }
}

/// Runs a study, or what a subcommand says.
pub(super) fn main(arguments: &SweepArguments) -> Exit {
    let outcome = match (&arguments.command, &arguments.local) {
        (Some(SweepCommand::Export(export)), _) => run_export(export),
        (Some(SweepCommand::RunCase(case)), _) => run_cases(case),
        (Some(SweepCommand::Collect(collect)), _) => run_collect(collect),
        (None, Some(local)) => run_locally(local),
        (None, None) => return Exit::Usage,
    };
    outcome.unwrap_or_else(|error| report(&error))
}

fn run_locally(arguments: &LocalArguments) -> Result<Exit, SweepError> {
    let study = read(&arguments.study, arguments.folder.as_deref())?;
    let parquet = arguments.parquet || study.plan.parquet;
    if parquet {
        parquet_is_there()?;
    }
    if arguments.dry_run {
        list(&study);
        return study.compare_with_folder().map(|()| Exit::Done);
    }
    study.settle_folder(arguments.update)?;
    let cases = study.to_do(arguments.retry)?;
    let cores = available_parallelism().map_or(1, usize::from);
    let threads = arguments.threads.map(usize::from).or(study.plan.threads);
    let jobs = arguments.jobs.map(usize::from);
    let (jobs, threads) = jobs_and_threads(cores, cases.len(), jobs, threads);
    let runner = Runner {
        program: this_program()?,
        threads,
        retries: arguments.retry,
        updates: arguments.update,
    };
    interrupt::install();
    let mut display = Display::new(&study, cases.len(), jobs, threads, arguments.quiet);
    study.run_cases(&cases, jobs, &runner, &interrupt::is_requested, &mut |event| {
        display.show(&study, &event);
    })?;
    display.close();
    finish(&study, parquet, arguments.quiet)
}

/// Writes the table and says how the cases ended.
fn finish(study: &Study, parquet: bool, quiet: bool) -> Result<Exit, SweepError> {
    let records = study.records()?;
    let written = StudyTable::of(study, &records).write(&study.folder, parquet)?;
    let known = || records.iter().flatten();
    let failed: Vec<&Record> = known().filter(|record| record.has_failed()).collect();
    let done = known().filter(|record| record.is_done()).count();
    let missing = study.cases.len() - done - failed.len();
    if !quiet {
        let mut counts = format!("{done} of {} cases done", study.cases.len());
        if !failed.is_empty() {
            counts.push_str(&format!(", {} failed", failed.len()));
        }
        if missing > 0 {
            counts.push_str(&format!(", {missing} still to be run"));
        }
        let files: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
        say(&format!("{counts}: {}", files.join(", ")));
        let left = study.left_over();
        if !left.is_empty() {
            say(&format!(
                "{} of an earlier study {} not in the table",
                left.join(", "),
                if left.len() == 1 { "is" } else { "are" }
            ));
        }
    }
    for record in &failed {
        warn(&format!("case {} ({}): {}", record.case, record.values, record.message));
    }
    Ok(match (failed.is_empty(), missing) {
        _ if interrupt::is_requested() && missing > 0 => Exit::Interrupted,
        (true, 0) => Exit::Done,
        _ => Exit::SomeFailed,
    })
}

fn run_export(arguments: &ExportArguments) -> Result<Exit, SweepError> {
    let study = read(&arguments.study, arguments.folder.as_deref())?;
    let scheduler = match arguments.to {
        SchedulerName::Slurm => Scheduler::Slurm,
        SchedulerName::Parallel => Scheduler::Parallel,
    };
    let written = study.export(scheduler, arguments.update)?;
    let first = written.first().map(|path| path.display().to_string()).unwrap_or_default();
    let folder = study.folder.display();
    say(&match scheduler {
        Scheduler::Slurm => format!("{first}: submit it in {folder} with `sbatch slurm.sh`"),
        Scheduler::Parallel => format!("{first}: start it with `{first} --jobs N`"),
    });
    Ok(Exit::Done)
}

fn run_cases(arguments: &RunCaseArguments) -> Result<Exit, SweepError> {
    let study = read(&arguments.study, arguments.folder.as_deref())?;
    let last = study.cases.len();
    let mut cases: Vec<&Case> = Vec::new();
    for &(from, to) in &arguments.cases {
        for asked in from..=to.min(last.max(from)) {
            cases.push(study.case(asked).ok_or(SweepError::NoCase { asked, last })?);
        }
        if to > last {
            return Err(SweepError::NoCase { asked: to, last });
        }
    }
    let threads = arguments.threads.map(usize::from).or(study.plan.threads).unwrap_or(1);
    let program = this_program()?;
    let runner = Runner { program, threads, retries: arguments.retry, updates: false };
    interrupt::install();
    let mut exit = Exit::Done;
    for case in cases {
        let record = study.run_case(case, &runner, &interrupt::is_requested)?;
        if !arguments.quiet {
            say(&ended(case, &record));
        }
        if record.state == State::Interrupted {
            return Ok(Exit::Interrupted);
        }
        if record.has_failed() {
            exit = Exit::SomeFailed;
        }
        if interrupt::is_requested() {
            return Ok(Exit::Interrupted);
        }
    }
    Ok(exit)
}

fn run_collect(arguments: &CollectArguments) -> Result<Exit, SweepError> {
    let study = read(&arguments.study, arguments.folder.as_deref())?;
    let parquet = arguments.parquet || study.plan.parquet;
    if parquet {
        parquet_is_there()?;
    }
    study.settle_folder(false)?;
    finish(&study, parquet, arguments.quiet)
}

/// Lists the cases and what has become of them.
fn list(study: &Study) {
    if let Some(title) = &study.title {
        say(title);
    }
    for case in &study.cases {
        let state = match study.record(case) {
            None => "not run",
            Some(record) if record.is_done() => "done",
            Some(record) if record.has_failed() => "failed",
            Some(record) if record.state == State::Ready => "not run",
            Some(_) => "begun",
        };
        say(&format!("{:>6}  {state:<8}  {}", case.number, study.words(case)));
    }
    say(&format!("{} cases in {}", study.cases.len(), study.folder.display()));
}

/// What is said when a case is over.
pub(super) fn ended(case: &Case, record: &Record) -> String {
    let what = match (record.state, record.status) {
        (State::Interrupted, _) => "interrupted".to_owned(),
        (_, 0) => "done".to_owned(),
        (_, status) => format!("failed with {status}: {}", record.message),
    };
    format!("case {} ({}): {what}", case.number, record.values)
}

fn this_program() -> Result<PathBuf, SweepError> {
    std::env::current_exe()
        .map_err(|source| SweepError::Io { path: PathBuf::from("this program"), source })
}

fn report(error: &SweepError) -> Exit {
    match error {
        SweepError::Study(StudyError::Finding { sources, finding }) => {
            print(sources, finding);
            Exit::Input
        }
        SweepError::Study(StudyError::Deck { sources, findings }) => {
            let fault = crate::session::DeckFault::Findings {
                sources: sources.clone(),
                findings: findings.clone(),
            };
            deck_report::print_fault(&fault, true)
        }
        other => {
            warn(&format!("error: {other}"));
            match other {
                SweepError::Io { .. } | SweepError::Foreign(_) => Exit::Output,
                SweepError::NoCase { .. } | SweepError::Unsupported(_) => Exit::Usage,
                _ => Exit::Input,
            }
        }
    }
}

fn print(sources: &SourceMap, finding: &yformat::diagnostic::Diagnostic) {
    warn(finding.render(sources).trim_end_matches('\n'));
}
