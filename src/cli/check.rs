mod json;
mod words;

use super::{Exit, console::say, deck_report, run::parse_dialect};
use crate::{
    assessment::assess,
    scene::Profile,
    session::{DeckFault, load},
    simulation::SolverOptions,
};
use clap::Args;
use std::path::PathBuf;
use yformat::{
    diagnostic::{Diagnostic, Severity},
    dialect::Dialect,
};

/// Examples and exit codes, as the help shows them.
pub(super) const HELP: &str = "\
Examples:
  ypsilon check arch.y
  ypsilon check --json decks/*.y | jq '.[] | {deck, safety: .assessment.safety_factor}'

Exit codes:
  0    nothing is to be changed
  1    a deck cannot be read, has errors, or would diverge
  2    the command line is wrong
  5    a deck runs, but there are warnings";

/// What to check.
#[derive(Debug, Args)]
pub(super) struct CheckArguments {
    /// Input decks
    #[arg(required = true)]
    decks: Vec<PathBuf>,
    /// Take the decks for ones of this dialect instead of recognising it
    #[arg(long, value_name = "NAME", value_parser = parse_dialect)]
    dialect: Option<Dialect>,
    /// Print findings and figures as JSON, one object for each deck
    #[arg(long)]
    json: bool,
}

/// Checks decks: findings, then what they hold and what a run will come to.
pub(super) fn main(arguments: &CheckArguments) -> Exit {
    let mut worst = None;
    let mut reports = Vec::new();
    for deck in &arguments.decks {
        let loaded = load(deck, arguments.dialect, Profile::default(), SolverOptions::default());
        let loaded = match loaded {
            Ok(loaded) => loaded,
            Err(fault) => {
                worst = Some(Severity::Error);
                if arguments.json {
                    reports.push(json::fault(deck, &fault));
                } else {
                    deck_report::print_fault(&fault, false);
                }
                continue;
            }
        };
        let assessment = assess(&loaded);
        let assessed = assessment.iter().flat_map(|assessment| &assessment.findings);
        let severities = loaded.findings.iter().chain(assessed).map(|finding| finding.severity);
        worst = worst.max(severities.max());
        if arguments.json {
            reports.push(json::report(deck, &loaded, assessment.as_ref()));
        } else {
            deck_report::print(&loaded.findings, loaded.deck.sources(), Severity::Note);
            say(&words::report(deck, &loaded, assessment.as_ref()));
        }
    }
    if arguments.json {
        say(&format!("{:#}", serde_json::Value::Array(reports)));
    }
    match worst {
        Some(Severity::Error) => Exit::Input,
        Some(Severity::Warning) => Exit::Doubtful,
        Some(Severity::Note) | None => Exit::Done,
    }
}

/// Findings of a deck that cannot be run.
fn findings_of(fault: &DeckFault) -> &[Diagnostic] {
    match fault {
        DeckFault::Io { .. } => &[],
        DeckFault::Findings { findings, .. } => findings,
    }
}
