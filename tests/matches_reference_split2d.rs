//! States of the original, bit for bit.
//!
//! Every case under `tests/data/split2d` (and, where it is there, under
//! `../shared/reference/split2d`) holds a deck, the original's states after
//! chosen numbers of steps to 17 digits, its histories and its d3plot file.
//! Ypsilon must give the same bits: coordinates, velocities, forces, masses,
//! flags, properties and nodes; the same history text; the same d3plot bytes
//! after the title, which holds a date.
//!
//! The cohesive law uses `exp` and `pow` of the platform's C library. Where
//! that is not glibc, states must agree to the tolerance of the cases'
//! `meta.txt` instead.

mod support;

use libtest_mimic::{Arguments, Failed, Trial};
use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
    process::ExitCode,
    sync::{
        Arc,
        atomic::{AtomicUsize, Ordering},
    },
};
use support::state_file::{StateFile, compare};
use ypsilon::{
    scene::Profile,
    session::{Format, RunOptions, Silent, load, run},
    simulation::SolverOptions,
};

/// Whether bits have to be equal, not only close.
const BITS: bool = cfg!(all(target_os = "linux", target_arch = "x86_64", target_env = "gnu"));
/// Bytes of a d3plot title.
const TITLE: usize = 40;

#[derive(Default)]
struct Tally {
    states: AtomicUsize,
    equal: AtomicUsize,
}

fn main() -> ExitCode {
    let arguments = Arguments::from_args();
    let tally = Arc::new(Tally::default());
    let trials = cases().into_iter().map(|(name, folder)| {
        let tally = Arc::clone(&tally);
        Trial::test(name.clone(), move || check_case(&name, &folder, &tally))
    });
    let conclusion = libtest_mimic::run(&arguments, trials.collect());
    println!(
        "{} of {} states are equal to the original's bit for bit",
        tally.equal.load(Ordering::Relaxed),
        tally.states.load(Ordering::Relaxed)
    );
    conclusion.exit_code()
}

/// All cases by name: those of the repository, and those beside it.
fn cases() -> BTreeMap<String, PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let shared = root.join("../shared/reference/split2d");
    if !shared.is_dir() {
        println!("skipping the large cases: {} is absent", shared.display());
    }
    let mut cases = BTreeMap::new();
    for folder in [root.join("tests/data/split2d"), shared] {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            cases.entry(name).or_insert_with(|| entry.path());
        }
    }
    cases
}

fn check_case(name: &str, folder: &Path, tally: &Tally) -> Result<(), Failed> {
    let steps = reference_steps(folder)?;
    if steps.is_empty() {
        return Err("the case has no states".into());
    }
    let deck = folder.join(format!("{name}.y"));
    let out = tempfile::tempdir()?;
    let loaded = load(&deck, None, Profile::Source, SolverOptions::default())
        .map_err(|fault| format!("{fault:?}"))?;
    let options = RunOptions {
        formats: vec![Format::D3plot, Format::Yh],
        states: steps.clone(),
        legacy_d3plot: true,
        profile: Profile::Source,
        ..RunOptions::new(deck, out.path())
    };
    run(loaded, &options, &mut Silent)?;
    for step in steps {
        let ours = StateFile::read(&out.path().join(format!("{name}.state_{step}.txt")))?;
        let original = StateFile::read(&folder.join(format!("state_{step}.txt")))?;
        tally.states.fetch_add(1, Ordering::Relaxed);
        if ours == original {
            tally.equal.fetch_add(1, Ordering::Relaxed);
        } else {
            let worst = compare(&original, &ours);
            let report = format!("step {step}: {worst:?}");
            if BITS || !worst.within(1e-12, 1e-10) {
                return Err(report.into());
            }
            println!("{name}: {report}");
        }
    }
    if BITS {
        check_files(folder, out.path(), name)?;
    }
    Ok(())
}

fn reference_steps(folder: &Path) -> Result<Vec<u64>, Failed> {
    let mut steps = Vec::new();
    for entry in fs::read_dir(folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        if let Some(step) = name.strip_prefix("state_").and_then(|n| n.strip_suffix(".txt")) {
            steps.push(step.parse()?);
        }
    }
    steps.sort_unstable();
    Ok(steps)
}

/// Histories and d3plot files must be equal to the byte.
fn check_files(folder: &Path, out: &Path, name: &str) -> Result<(), Failed> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let original = fs::read(&path)?;
        if file.contains(".yh") {
            let ours = fs::read(out.join(&file))?;
            if ours != original {
                return Err(format!("history {file} differs").into());
            }
        } else if file.ends_with(".d3plot") {
            let ours = fs::read(out.join(name))?;
            if ours.get(TITLE..) != original.get(TITLE..) {
                return Err("the d3plot file differs".into());
            }
        }
    }
    Ok(())
}
