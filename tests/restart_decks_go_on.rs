//! Restart decks of the classic dialect go on where the run that wrote them was.
//!
//! They hold state to all digits and properties to 12, and neither sliding nor the shared store of
//! joint strengths, as in the original: bodies that only deform go on exactly, others closely.

mod support;

use std::{fs, path::Path};
use support::state_file::{StateFile, compare};
use ypsilon::{
    scene::Profile,
    session::{Format, RunOptions, Silent, load, run},
    simulation::SolverOptions,
};

/// Runs a deck and returns its state after `steps` steps.
fn state(deck: &Path, folder: &Path, steps: u64) -> StateFile {
    let loaded = load(deck, None, Profile::default(), SolverOptions::default()).expect("a deck");
    let options = RunOptions {
        formats: vec![Format::Native],
        states: vec![steps],
        ..RunOptions::new(deck, folder)
    };
    run(loaded, &options, &mut Silent).expect("a stable run");
    let name = deck.file_stem().unwrap_or_default().to_string_lossy().into_owned();
    StateFile::read(&folder.join(format!("{name}.state_{steps}.txt"))).expect("a state")
}

/// Differences at the end between a run in one go and one that goes on from a restart deck written
/// after `half` of `end` steps.
fn differences(case: &str, half: u64, end: u64) -> support::state_file::Differences {
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/classic");
    let folder = tempfile::tempdir().expect("a folder");
    let original = data.join(case).join(format!("{case}.y"));
    let whole = state(&original, &folder.path().join("whole"), end);

    let text = fs::read_to_string(original).expect("a deck");
    let replace = |text: &str, keyword: &str, value: u64| {
        let (before, after) = text.split_once(keyword).expect("the keyword");
        let (_, rest) = after.split_once('\n').expect("more lines");
        format!("{before}{keyword} {value}\n{rest}")
    };
    let shorter = replace(&text, "/YD/YDC/MCSTEP", half);
    let first = folder.path().join("first.y");
    fs::write(&first, replace(&shorter, "/YD/YDC/ICSAVF", half)).expect("writable");
    let _ = state(&first, folder.path(), half);
    let restart = fs::read_dir(folder.path())
        .expect("the folder")
        .flatten()
        .map(|entry| entry.path())
        .find(|path| path.to_string_lossy().ends_with("_restart.y"))
        .expect("a restart deck");
    let longer = replace(&fs::read_to_string(&restart).expect("text"), "/YD/YDC/MCSTEP", end);
    fs::write(&restart, longer).expect("writable");
    compare(&whole, &state(&restart, folder.path(), end))
}

#[test]
fn bodies_that_deform_go_on_exactly() {
    for (case, half, end) in
        [("a_freefall", 700, 2000), ("b_elastic_damped", 1111, 3000), ("h_bc_ramp", 500, 2000)]
    {
        let differences = differences(case, half, end);
        // properties have 12 digits in a restart deck
        assert!(differences.within(1e-12, 1e-10), "{case}: {differences:?}");
    }
}

#[test]
fn contact_and_joints_go_on_closely() {
    // broken joints stay broken: the structure is part of what must agree
    for (case, half, end, tolerance) in
        [("c_contact_normal", 1500, 4000, 1e-9), ("e_joint_tension", 1500, 3000, 1e-3)]
    {
        let differences = differences(case, half, end);
        assert!(differences.structure_agrees, "{case}: {differences:?}");
        assert!(differences.coordinates <= tolerance, "{case}: {differences:?}");
    }
}
