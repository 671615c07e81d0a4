//! Decks that others have published are read, written back, and run.
//!
//! They lie under `../shared/thirdparty`; without that folder the tests are skipped.

use std::{
    fs,
    path::{Path, PathBuf},
};
use yformat::deck::Deck;
use ypsilon::{
    scene::Profile,
    session::{Format, RunError, RunOptions, Silent, load, run},
    simulation::SolverOptions,
};

/// Steps that each deck runs.
const STEPS: u64 = 300;
/// Decks whose time step is too long: they blow up, in the original, too.
const UNSTABLE: &[&str] = &["test4.y", "test12.y"];

fn decks() -> Vec<PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/thirdparty");
    let mut folders = vec![root.clone()];
    let mut decks = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let path = entry.path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "y") {
                decks.push(path);
            }
        }
    }
    decks.sort();
    if decks.is_empty() {
        println!("skipped: {} is absent", root.display());
    }
    decks
}

#[test]
fn published_decks_are_written_back_byte_for_byte() {
    for path in decks() {
        let outcome = Deck::read(&path).expect("readable");
        assert!(!outcome.has_errors(), "{}: {:?}", path.display(), outcome.diagnostics);
        let mut text = Vec::new();
        outcome.deck.write_to(&mut text).expect("writable");
        assert!(text == fs::read(&path).expect("readable"), "{}", path.display());
    }
}

/// Restart decks end where they begin: with more steps they go on.
fn going_on(deck: &Path, folder: &Path) -> PathBuf {
    let name = deck.file_name().unwrap_or_default();
    if !name.to_string_lossy().contains("_restart") {
        return deck.to_path_buf();
    }
    let text = fs::read_to_string(deck).expect("a deck of text");
    let (before, after) = text.split_once("/YD/YDC/MCSTEP").expect("a number of steps");
    let (_, rest) = after.split_once('\n').expect("more lines");
    let longer = folder.join(name);
    fs::write(&longer, format!("{before}/YD/YDC/MCSTEP 999999\n{rest}")).expect("writable");
    longer
}

#[test]
fn published_decks_run() {
    for deck in decks() {
        let folder = tempfile::tempdir().expect("a temporary folder");
        let name = deck.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let deck = going_on(&deck, folder.path());
        let loaded = load(&deck, None, Profile::default(), SolverOptions::default());
        let loaded = loaded.unwrap_or_else(|fault| panic!("{name}: {fault:?}"));
        let options = RunOptions {
            formats: vec![Format::Native, Format::Vtu],
            steps: Some(STEPS),
            ..RunOptions::new(deck, folder.path())
        };
        let unstable = UNSTABLE.contains(&name.as_str());
        match run(loaded, &options, &mut Silent) {
            Ok(summary) => assert!(!unstable && summary.steps > 0, "{name}: {summary:?}"),
            Err(RunError::Unstable { .. }) => assert!(unstable, "{name} has become unstable"),
            Err(error) => panic!("{name}: {error}"),
        }
    }
}
