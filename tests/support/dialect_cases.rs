//! Cases of a dialect: decks with the original's records after chosen numbers of
//! steps and its result files.

use super::dump::Dump;
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
use ypsilon::{
    scene::Profile,
    session::load,
    simulation::{AnySimulation, SolverOptions},
};

/// Whether bits have to be equal, not only close.
const BITS: bool = cfg!(all(target_os = "linux", target_arch = "x86_64", target_env = "gnu"));

#[derive(Default)]
struct Tally {
    states: AtomicUsize,
    equal: AtomicUsize,
}

/// Runs all cases of a dialect.
pub fn main(dialect: &str) -> ExitCode {
    let arguments = Arguments::from_args();
    let tally = Arc::new(Tally::default());
    let trials = cases(dialect).into_iter().map(|(name, folder)| {
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

/// Folders of all cases of a dialect by name.
pub fn cases(dialect: &str) -> BTreeMap<String, PathBuf> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let beside = ["../shared/reference", "../shared/thirdparty/reference"];
    let beside = beside.map(|folder| root.join(folder).join(dialect));
    for folder in beside.iter().filter(|folder| !folder.is_dir()) {
        println!("skipping further cases: {} is absent", folder.display());
    }
    let mut cases = BTreeMap::new();
    // the folders beside the repository hold more states of the same cases
    let own = root.join("tests/data").join(dialect);
    for folder in beside.into_iter().chain([own]) {
        for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            cases.entry(name).or_insert_with(|| entry.path());
        }
    }
    cases
}

fn check_case(name: &str, folder: &Path, tally: &Tally) -> Result<(), Failed> {
    let deck = folder.join(format!("{name}.y"));
    let loaded = load(&deck, None, Profile::Windows, SolverOptions::default())
        .map_err(|fault| format!("{fault:?}"))?;
    let mut simulation =
        loaded.simulation.and_then(AnySimulation::into_plane).ok_or("nothing runs")?;
    let mut reports = Vec::new();
    for step in steps(folder)? {
        while simulation.step_index() < step {
            simulation.evaluate_forces();
            simulation.advance();
        }
        let [plain, packed] = ["txt", "txt.gz"].map(|e| folder.join(format!("state_{step}.{e}")));
        let original = Dump::read(if plain.exists() { &plain } else { &packed })?;
        let ours = Dump::of(&simulation, step == 0);
        let comparison = original.compare(&ours, "NTJC");
        tally.states.fetch_add(1, Ordering::Relaxed);
        if comparison.different == 0 {
            tally.equal.fetch_add(1, Ordering::Relaxed);
        } else if BITS || comparison.worst > 1e-10 {
            reports.push(format!(
                "step {step}: {} numbers differ, by {:.1e} at most; {}",
                comparison.different, comparison.worst, comparison.first
            ));
        }
    }
    if reports.is_empty() { Ok(()) } else { Err(reports.join("\n").into()) }
}

fn steps(folder: &Path) -> Result<Vec<u64>, Failed> {
    let mut steps = Vec::new();
    for entry in fs::read_dir(folder)? {
        let name = entry?.file_name().to_string_lossy().into_owned();
        let name = name.strip_suffix(".gz").unwrap_or(&name);
        if let Some(step) = name.strip_prefix("state_").and_then(|n| n.strip_suffix(".txt")) {
            steps.push(step.parse()?);
        }
    }
    steps.sort_unstable();
    Ok(steps)
}
