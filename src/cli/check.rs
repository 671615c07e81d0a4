use super::{Exit, console::say, deck_report, run::parse_dialect};
use crate::{
    scene::Profile,
    session::{SceneSize, load},
    simulation::SolverOptions,
};
use clap::Args;
use std::path::PathBuf;
use yformat::{diagnostic::Severity, dialect::Dialect};

/// What to check.
#[derive(Debug, Args)]
pub(super) struct CheckArguments {
    /// Input decks
    #[arg(required = true)]
    decks: Vec<PathBuf>,
    /// Take the decks for ones of this dialect instead of recognising it
    #[arg(long, value_name = "NAME", value_parser = parse_dialect)]
    dialect: Option<Dialect>,
}

/// Checks decks: findings, then what they hold.
pub(super) fn main(arguments: &CheckArguments) -> Exit {
    let mut exit = Exit::Done;
    for deck in &arguments.decks {
        match load(deck, arguments.dialect, Profile::default(), SolverOptions::default()) {
            Err(fault) => exit = deck_report::print_fault(&fault, false),
            Ok(loaded) => {
                deck_report::print(&loaded.findings, loaded.deck.sources(), Severity::Note);
                match &loaded.simulation {
                    None => say(&format!("{}: nothing runs", deck.display())),
                    Some(simulation) => {
                        let size = SceneSize::of(simulation);
                        say(&format!(
                            "{}: {}, {}, {}, {}: ready to run",
                            deck.display(),
                            counted(loaded.stages.len(), "stage"),
                            counted(size.nodes, "node"),
                            size.bodies_in_words(),
                            counted(size.joints, "joint")
                        ));
                    }
                }
            }
        }
    }
    exit
}

/// `1 stage`, `2 stages`.
fn counted(count: usize, what: &str) -> String {
    let plural = if count == 1 { "" } else { "s" };
    format!("{count} {what}{plural}")
}
