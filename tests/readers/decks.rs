//! Decks, down to the first steps of what they describe.

use super::folder;
use std::{io, path::Path};
use yformat::{
    classic_output::RestartDeck,
    deck::{Deck, DeckReader},
    dialect::Dialect,
};
use ypsilon::{
    scene::Profile,
    session::{RunOptions, Silent, prepare, run},
    simulation::{AnySimulation, SolverOptions},
};
use ypsilon_converters::{detect::detect, dialects::convert_deck, restart::restart_to_vtu};

/// Steps that a scene makes: the first one does everything for the first time.
const STEPS: u64 = 1;

pub fn split(bytes: &[u8]) {
    deck(bytes, Dialect::Split);
}

pub fn classic(bytes: &[u8]) {
    deck(bytes, Dialect::Classic);
}

pub fn ygeo(bytes: &[u8]) {
    deck(bytes, Dialect::YGeo);
}

pub fn y3d(bytes: &[u8]) {
    deck(bytes, Dialect::Y3d);
}

/// A classic deck as results of an earlier run.
pub fn restart_deck(bytes: &[u8]) {
    if RestartDeck::parse("deck.y", bytes.to_vec()).is_ok() {
        let folder = folder();
        let input = folder.path().join("deck.y");
        std::fs::write(&input, bytes).expect("a writable folder");
        let _ = restart_to_vtu(&input, folder.path(), "deck");
    }
}

/// Reads a deck, writes it, converts it, and runs what it describes. It may include one file,
/// itself.
fn deck(bytes: &[u8], dialect: Dialect) {
    detect(bytes);
    let itself = |name: &str| match name {
        "deck.y" => Ok(bytes.to_vec()),
        _ => Err(io::Error::from(io::ErrorKind::NotFound)),
    };
    let outcome = DeckReader::new().dialect(dialect).includes(itself).parse("deck.y", bytes);
    for finding in &outcome.diagnostics {
        let _ = finding.clone().located(outcome.deck.sources()).render(outcome.deck.sources());
    }
    if !outcome.has_errors() {
        let text = outcome.deck.to_text();
        Deck::parse("again.y", text);
        for to in [Dialect::Split, Dialect::Classic, Dialect::YGeo] {
            let _ = convert_deck(&outcome.deck, to);
        }
    }
    let path = Path::new("deck.y");
    let Ok(mut loaded) = prepare(outcome, path, Profile::default(), SolverOptions::default())
    else {
        return;
    };
    if loaded.stages.len() > 1 {
        let folder = folder();
        // motion may become unstable and later stages may be wrong
        let _ = run(loaded, &run_options(folder.path()), &mut Silent);
    } else if let Some(mut simulation) = loaded.simulation.take() {
        step(&mut simulation, STEPS);
    }
}

/// So many steps.
pub(super) fn step(simulation: &mut AnySimulation, steps: u64) {
    for _ in 0..steps {
        match simulation {
            AnySimulation::Plane(simulation) => {
                simulation.evaluate_forces();
                simulation.advance();
            }
            AnySimulation::Spatial(simulation) => {
                simulation.evaluate_forces();
                simulation.advance();
            }
        }
    }
}

/// A run of a few steps without result files but the log.
pub(super) fn run_options(folder: &Path) -> RunOptions {
    RunOptions {
        formats: Vec::new(),
        steps: Some(STEPS),
        ..RunOptions::new(folder.join("deck.y"), folder)
    }
}
