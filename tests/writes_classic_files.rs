//! Result files of the classic dialect, equal to the original's to the byte.
//!
//! Documented exceptions: columns 3 and 4 of `contactforce.txt` and the column
//! of strengths behind the third in restart decks show memory that the original
//! never sets; restart decks hold the number of masses, which the original
//! writes as 0 and cannot read. The dilation of fractures is summed over all
//! steps: the order of one product in it is unknown, so that it may differ in its
//! last digits (D1JDLC, 1e-14).

mod support;

use libtest_mimic::{Arguments, Failed, Trial};
use std::{fs, path::Path, process::ExitCode};
use ypsilon::{
    scene::Profile,
    session::{Format, RunOptions, Silent, load, run},
    simulation::SolverOptions,
};

fn main() -> ExitCode {
    let cases = support::dialect_cases::cases("classic");
    let trials = cases
        .into_iter()
        .map(|(name, folder)| Trial::test(name.clone(), move || check_files(&name, &folder)));
    libtest_mimic::run(&Arguments::from_args(), trials.collect()).exit_code()
}

fn check_files(name: &str, folder: &Path) -> Result<(), Failed> {
    let out = tempfile::tempdir()?;
    let deck = folder.join(format!("{name}.y"));
    let loaded = load(&deck, None, Profile::Windows, SolverOptions::default())
        .map_err(|fault| format!("{fault:?}"))?;
    let options = RunOptions {
        deck,
        folder: out.path().to_path_buf(),
        formats: vec![Format::Native],
        states: Vec::new(),
        steps: None,
        legacy_d3plot: false,
        monitors: Default::default(),
        profile: Profile::Windows,
    };
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
        let (original, ours) = (comparable(&file, &original), comparable(&file, &ours));
        compared += 1;
        if let Some(report) = first_difference(&original, &ours) {
            reports.push(format!("{file}: {report}"));
        }
    }
    if name_of_restart(folder).is_some_and(|file| !dilations_agree(folder, out.path(), &file)) {
        reports.push("the dilations differ".to_owned());
    }
    if compared == 0 {
        return Err("the case has no files".into());
    }
    if reports.is_empty() { Ok(()) } else { Err(reports.join("\n").into()) }
}

/// The text without what the original leaves to chance.
fn comparable(file: &str, text: &str) -> String {
    if file == "contactforce.txt" {
        let sums = |line: &str| line.split(' ').take(2).collect::<Vec<_>>().join(" ");
        return text.lines().map(sums).collect::<Vec<_>>().join("\n");
    }
    if !file.ends_with("_restart.y") {
        return text.to_owned();
    }
    let mut lines = Vec::new();
    let (mut in_strengths, mut in_dilations) = (false, false);
    for line in text.lines() {
        if line.starts_with("/YD/YDN/D1NMCT") || std::mem::take(&mut in_dilations) {
            continue;
        }
        if in_strengths && line.is_empty() {
            in_strengths = false;
        }
        if in_strengths {
            let strengths: Vec<&str> = line.split_whitespace().take(3).collect();
            lines.push(strengths.join(" "));
        } else {
            lines.push(line.to_owned());
        }
        in_dilations = line.starts_with(DILATIONS);
        in_strengths |= line.starts_with("/YD/YDE/D2ELFS");
    }
    lines.join("\n")
}

/// Keyword of the dilations of all joints.
const DILATIONS: &str = "/YD/YDJ/D1JDLC";

fn name_of_restart(folder: &Path) -> Option<String> {
    let names = fs::read_dir(folder).ok()?.flatten();
    let mut names = names.map(|entry| entry.file_name().to_string_lossy().into_owned());
    names.find(|name| name.ends_with("_restart.y"))
}

/// Whether the dilations of two restart decks agree but for rounding.
fn dilations_agree(original: &Path, ours: &Path, file: &str) -> bool {
    let [a, b] = [original, ours].map(|folder| {
        let text = fs::read_to_string(folder.join(file)).unwrap_or_default();
        let mut lines = text.lines().skip_while(|line| !line.starts_with(DILATIONS)).skip(1);
        let values = lines.next().unwrap_or_default().split_whitespace();
        values.map(str::parse::<f64>).collect::<Result<Vec<_>, _>>()
    });
    let (Ok(a), Ok(b)) = (a, b) else { return false };
    let largest = a.iter().fold(0.0, |l: f64, x| l.max(x.abs()));
    a.len() == b.len() && a.iter().zip(&b).all(|(x, y)| (x - y).abs() <= 1e-14 * largest)
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
