//! Results of a deck in a folder that vanishes with them.

use std::fs;
use tempfile::TempDir;
use yformat::deck::Deck;
use ypsilon::{
    output::{Monitor, MonitorPlan},
    scene::Profile,
    session::{Format, RunOptions, Silent, load, run},
    simulation::SolverOptions,
};

/// Runs a deck as `plate.y`, with VTU and d3plot files and the monitors given.
pub fn results(deck: &Deck, monitors: &[&str], interval: u64) -> TempDir {
    let folder = TempDir::new().expect("a temporary folder");
    let path = folder.path().join("plate.y");
    fs::write(&path, deck.to_text()).expect("a deck");
    let loaded = load(&path, None, Profile::Windows, SolverOptions::default())
        .unwrap_or_else(|fault| panic!("{fault:?}"));
    let monitors: Vec<Monitor> = monitors.iter().map(|m| m.parse().expect("a monitor")).collect();
    let options = RunOptions {
        formats: vec![Format::Vtu, Format::D3plot],
        monitors: MonitorPlan { monitors, interval },
        ..RunOptions::new(path, folder.path())
    };
    run(loaded, &options, &mut Silent).expect("a run");
    folder
}
