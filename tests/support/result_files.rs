//! Result files of a case against the original's.

use super::dialect_cases;
use libtest_mimic::{Arguments, Failed, Trial};
use std::{fs, path::Path, process::ExitCode};
use ypsilon::{
    scene::Profile,
    session::{Format, RunOptions, Silent, load, run},
    simulation::SolverOptions,
};

/// How the files of a dialect are compared.
#[derive(Clone, Copy)]
pub struct Comparison {
    /// The text of a file without what the original leaves to chance.
    pub comparable: fn(&str, &str) -> String,
    /// What else must hold between the folders of the original and of this run.
    pub agree: fn(&Path, &Path) -> bool,
}

/// Runs all cases of a dialect and compares all their files.
pub fn main(dialect: &str, comparison: Comparison) -> ExitCode {
    let trials = dialect_cases::cases(dialect).into_iter().map(|(name, folder)| {
        Trial::test(name.clone(), move || check_files(&name, &folder, comparison))
    });
    libtest_mimic::run(&Arguments::from_args(), trials.collect()).exit_code()
}

fn check_files(name: &str, folder: &Path, comparison: Comparison) -> Result<(), Failed> {
    let out = tempfile::tempdir()?;
    let deck = folder.join(format!("{name}.y"));
    let loaded = load(&deck, None, Profile::Windows, SolverOptions::default())
        .map_err(|fault| format!("{fault:?}"))?;
    let options = RunOptions { formats: vec![Format::Native], ..RunOptions::new(deck, out.path()) };
    run(loaded, &options, &mut Silent)?;
    let mut reports = Vec::new();
    let mut compared = 0;
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if file.starts_with("state_") || file == "meta.txt" || file == format!("{name}.y") {
            continue;
        }
        let original = fs::read_to_string(&path)?;
        let ours =
            fs::read_to_string(out.path().join(&file)).map_err(|e| format!("{file}: {e}"))?;
        let [original, ours] = [original, ours].map(|text| (comparison.comparable)(&file, &text));
        compared += 1;
        if let Some(report) = first_difference(&original, &ours) {
            reports.push(format!("{file}: {report}"));
        }
    }
    if !(comparison.agree)(folder, out.path()) {
        reports.push("numbers that are compared apart differ".to_owned());
    }
    if compared == 0 {
        return Err("the case has no files".into());
    }
    if reports.is_empty() { Ok(()) } else { Err(reports.join("\n").into()) }
}

fn first_difference(original: &str, ours: &str) -> Option<String> {
    if original == ours {
        return None;
    }
    let differs = |(a, b): &(&str, &str)| a != b;
    let lines = original.lines().zip(ours.lines());
    let count = lines.clone().filter(differs).count();
    Some(match lines.enumerate().find(|(_, pair)| differs(pair)) {
        Some((line, (a, b))) => {
            let cut = |s: &str| s.chars().take(160).collect::<String>();
            format!("{count} lines, the first is {}:\n  {}\n  {}", line + 1, cut(a), cut(b))
        }
        None => format!("{} lines against {}", original.lines().count(), ours.lines().count()),
    })
}
