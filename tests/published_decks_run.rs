//! Decks that others have published: each is read and written back without a difference, loads,
//! and runs some hundred steps, or is refused for a reason that is known.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};
use tempfile::TempDir;
use yformat::deck::DeckReader;
use ypsilon::{
    scene::Profile,
    session::{DeckFault, Format, RunOptions, Silent, load, run},
    simulation::SolverOptions,
};

/// Steps of each deck.
const STEPS: u64 = 300;

/// Decks that are refused and why: all their triangles run clockwise, so that masses are negative
/// and nothing ever moves. They were made to look at a geometry: one step, one snapshot.
const REFUSED: [(&str, &str); 3] = [
    ("acse/decks/finalgeometry2_test.y", "scene::clockwise-triangle"),
    ("acse/decks/test10.y", "scene::clockwise-triangle"),
    ("acse/decks/test11.y", "scene::clockwise-triangle"),
];

/// Restart decks that were written after the last step of their run: nothing is left to do.
const COMPLETE: [&str; 2] =
    ["acse/test/test99_restart.y", "reference/classic/k_real_test4/k_real_test41_restart.y"];

/// What became of a deck.
enum Fate {
    /// Done this many steps.
    Ran(u64),
    /// Refused with these codes.
    Refused(Vec<&'static str>),
}

fn published() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/thirdparty")
}

/// All decks in a folder and below, by their names.
fn decks(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let path = entry.path();
        if path.is_dir() {
            found.extend(decks(&path));
        } else if path.extension().is_some_and(|extension| extension == "y") {
            found.push(path);
        }
    }
    found.sort();
    found
}

fn try_out(path: &Path) -> Fate {
    let bytes = fs::read(path).expect("a readable deck");
    let outcome = DeckReader::new().read(path).expect("a readable deck");
    assert_eq!(outcome.deck.to_bytes(), bytes, "{}: written otherwise", path.display());
    let loaded = match load(path, None, Profile::default(), SolverOptions::default()) {
        Ok(loaded) => loaded,
        Err(DeckFault::Findings { sources, findings }) => {
            let errors = findings.iter().filter(|f| f.is_error());
            assert!(errors.clone().all(|f| !f.render(&sources).is_empty()));
            return Fate::Refused(errors.map(|f| f.code).collect());
        }
        Err(fault) => panic!("{}: {fault}", path.display()),
    };
    let folder = TempDir::new().expect("a temporary folder");
    let options = RunOptions {
        deck: path.to_path_buf(),
        folder: folder.path().to_path_buf(),
        formats: vec![Format::Yh],
        states: Vec::new(),
        steps: Some(STEPS),
        legacy_d3plot: false,
        profile: Profile::default(),
    };
    match run(loaded, &options, &mut Silent) {
        Ok(summary) => Fate::Ran(summary.steps),
        Err(error) => panic!("{}: {error}", path.display()),
    }
}

#[test]
fn each_runs_or_is_refused_for_a_known_reason() {
    let folder = published();
    let decks = decks(&folder);
    if decks.is_empty() {
        println!("skipping published decks: {} is absent", folder.display());
        return;
    }
    let refused = BTreeMap::from(REFUSED);
    for path in decks {
        let name = path.strip_prefix(&folder).expect("a deck below the folder");
        let name = name.to_string_lossy();
        match (try_out(&path), refused.get(&*name)) {
            (Fate::Ran(steps), None) if COMPLETE.contains(&&*name) => {
                assert_eq!(steps, 0, "{name}")
            }
            (Fate::Ran(steps), None) => {
                println!("{name}: {steps} steps");
                assert!(steps > 0, "{name} does nothing");
            }
            (Fate::Refused(codes), Some(code)) => assert_eq!(codes, [*code], "{name}"),
            (Fate::Ran(_), Some(code)) => panic!("{name} runs, but {code} was expected"),
            (Fate::Refused(codes), None) => panic!("{name} is refused: {codes:?}"),
        }
    }
}
