//! Runs cases and writes their READMEs and the report.

use clap::{Parser, Subcommand};
use std::{
    path::{Path, PathBuf},
    process::ExitCode,
    sync::{
        Mutex, PoisonError,
        atomic::{AtomicUsize, Ordering},
    },
};
use ypsilon_examples::{
    Bench, Case, CaseError, Finding, Length, Obtained, cases,
    record::Record,
    report::{self, short},
};

/// Cases with known answers.
#[derive(Debug, Parser)]
#[command(version)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// List the cases
    List,
    /// Run one case and print what it finds
    Run {
        /// The case
        name: String,
        /// Run as much as the test suite does
        #[arg(long)]
        short: bool,
        /// Where decks and results go
        #[arg(long, default_value = "target/cases")]
        work: PathBuf,
        /// Take finished runs of the same decks that lie there instead of running them again
        #[arg(long)]
        reuse: bool,
    },
    /// Run cases, write their results.json, README.md and pictures, and examples/REPORT.md
    Report {
        /// Run these cases only; the others keep their results
        #[arg(long, num_args = 1.., value_name = "NAME")]
        only: Vec<String>,
        /// Run nothing: write the texts from the results that are there
        #[arg(long, conflicts_with = "only")]
        texts: bool,
        /// Where decks and results go
        #[arg(long, default_value = "target/cases")]
        work: PathBuf,
        /// Take finished runs of the same decks that lie there instead of running them again
        #[arg(long)]
        reuse: bool,
    },
}

fn main() -> ExitCode {
    let outcome = match Arguments::parse().command {
        Command::List => {
            for case in cases::all() {
                println!("{:12} {:24} {}", case.group.folder(), case.name, case.title);
            }
            Ok(true)
        }
        Command::Run { name, short, work, reuse } => run_one(&name, short, &work, reuse),
        Command::Report { only, texts, work, reuse } => report(&only, texts, &work, reuse),
    };
    match outcome {
        Ok(true) => ExitCode::SUCCESS,
        Ok(false) => ExitCode::FAILURE,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::from(2)
        }
    }
}

fn find(name: &str) -> Result<&'static Case, CaseError> {
    cases::find(name).ok_or_else(|| {
        let names: Vec<&str> = cases::all().iter().map(|case| case.name).collect();
        CaseError::missing(format!("there is no case `{name}`; there are {}", names.join(", ")))
    })
}

fn run_one(name: &str, short: bool, work: &Path, reuse: bool) -> Result<bool, CaseError> {
    let length = if short { Length::Short } else { Length::Full };
    let (record, _) = evaluate(find(name)?, work, length, reuse)?;
    print(&record.outcome.findings);
    println!("{:.1} s, {} triangle-steps", record.seconds, record.triangle_steps);
    Ok(record.outcome.findings.iter().all(Finding::agrees))
}

/// Runs a case.
fn evaluate(
    case: &Case,
    work: &Path,
    length: Length,
    reuse: bool,
) -> Result<(Record, f64), CaseError> {
    let bench = Bench::new(case, work, length).reusing(reuse);
    let started = std::time::Instant::now();
    let outcome = (case.evaluate)(&bench)?;
    let (seconds, triangle_steps) = bench.tally();
    let version = env!("CARGO_PKG_VERSION").to_owned();
    let record = Record { version, outcome, seconds, triangle_steps };
    Ok((record, started.elapsed().as_secs_f64()))
}

fn print(findings: &[Finding]) {
    for finding in findings {
        let expected = match &finding.expected {
            ypsilon_examples::Expected::Value(v) => short(*v),
            ypsilon_examples::Expected::Range([a, b]) => format!("{} to {}", short(*a), short(*b)),
            ypsilon_examples::Expected::Text(text) => text.clone(),
        };
        let obtained = match &finding.obtained {
            Obtained::Value(v) => short(*v),
            Obtained::Text { text, .. } => text.clone(),
        };
        let mark = match (finding.is_judged(), finding.agrees()) {
            (false, _) => ' ',
            (true, true) => '+',
            (true, false) => '-',
        };
        println!(
            "{mark} {}: expected {expected}, obtained {obtained} {}",
            finding.quantity, finding.unit
        );
    }
}

/// Independent cases run two at a time.
fn report(only: &[String], texts: bool, work: &Path, reuse: bool) -> Result<bool, CaseError> {
    let every = cases::all();
    let chosen: Vec<&'static Case> = match (texts, only) {
        (true, _) => Vec::new(),
        (false, []) => every.clone(),
        (false, names) => names.iter().map(|name| find(name)).collect::<Result<_, _>>()?,
    };
    let next = AtomicUsize::new(0);
    let faults = Mutex::new(Vec::new());
    std::thread::scope(|scope| {
        for _ in 0..2 {
            scope.spawn(|| {
                while let Some(case) = chosen.get(next.fetch_add(1, Ordering::Relaxed)) {
                    let done =
                        evaluate(case, work, Length::Full, reuse).and_then(|(record, seconds)| {
                            let findings = &record.outcome.findings;
                            let agree = findings.iter().filter(|f| f.agrees()).count();
                            let all = findings.len();
                            println!(
                                "{}: {agree} of {all} findings agree, {seconds:.1} s",
                                case.name
                            );
                            record.write(case)
                        });
                    if let Err(error) = done {
                        eprintln!("error: {}: {error}", case.name);
                        let mut faults = faults.lock().unwrap_or_else(PoisonError::into_inner);
                        faults.push(case.name);
                    }
                }
            });
        }
    });
    for case in &every {
        if let Some(record) = Record::read(case)? {
            report::readme(case, &record)?;
        }
    }
    report::all(&every)?;
    Ok(faults.into_inner().unwrap_or_else(PoisonError::into_inner).is_empty())
}
