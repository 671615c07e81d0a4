//! Runs whose motion makes no sense any more: what is said, when, and what is left of them.

mod support;

use assert_cmd::Command;
use serde_json::Value;
use std::{fs, path::Path};
use support::spoilt_deck::{Edits, edited, write};
use tempfile::TempDir;

/// Beyond the critical step of the two triangles alone, 4.9e-4 s.
const TOO_LONG: Edits<'_> =
    &[("DCSTEC 1e-5", "DCSTEC 6e-4"), ("MCSTEP 20", "MCSTEP 3000"), ("ICOUTF 10", "ICOUTF 1000")];

struct Finished {
    code: Option<i32>,
    stderr: String,
    folder: TempDir,
}

impl Finished {
    fn read(&self, name: &str) -> Option<Vec<u8>> {
        fs::read(self.folder.path().join("out").join(name)).ok()
    }

    fn summary(&self) -> Value {
        serde_json::from_slice(&self.read("deck.run.json").expect("a summary")).expect("JSON")
    }
}

fn in_folder(folder: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
    let output = command.current_dir(folder).args(arguments).output();
    let output = output.expect("the program starts");
    (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
}

fn run(edits: Edits<'_>, more: &[&str]) -> Finished {
    let folder = TempDir::new().expect("a temporary folder");
    write(folder.path(), "deck.y", edited(edits).as_bytes());
    let arguments: Vec<&str> = ["run", "deck.y", "--formats", "json", "--out", "out"]
        .iter()
        .chain(more)
        .copied()
        .collect();
    let (code, stderr) = in_folder(folder.path(), &arguments);
    Finished { code, stderr, folder }
}

/// Step that a message tells of.
fn step_in(message: &str) -> u64 {
    let after = message.split("in step ").nth(1).expect("a step");
    after.split_whitespace().next().expect("a number").parse().expect("a number")
}

#[test]
fn a_run_stops_at_the_first_step_that_makes_no_sense() {
    let stopped = run(TOO_LONG, &["--on-instability", "stop", "--quiet"]);
    assert_eq!(stopped.code, Some(4), "{}", stopped.stderr);
    for words in [
        "has become unstable in step",
        ", element ",
        ", at (",
        "longer than the critical one of this state",
        " sets",
    ] {
        assert!(stopped.stderr.contains(words), "{words}: {}", stopped.stderr);
    }
    let step = step_in(&stopped.stderr);
    assert!(step > 0 && step < 3000, "{step}");
    // the state just before is that of a run of so many steps
    let state = stopped.read("deck.unstable.state.txt").expect("a state");
    let steps = step.to_string();
    let plain = run(TOO_LONG, &["--steps", &steps, "--states", &steps, "--quiet"]);
    let expected = plain.read(&format!("deck.state_{step}.txt")).expect("a state");
    assert_eq!(String::from_utf8_lossy(&state), String::from_utf8_lossy(&expected));
    // and of all steps that one is the first: one more makes no sense, this one does
    let text = String::from_utf8(state).expect("text");
    assert!(!text.contains("NaN") && !text.contains("inf"));
    // ParaView shows it with its stresses
    assert!(stopped.stderr.contains("deck.unstable.vtu"), "{}", stopped.stderr);
    let picture = stopped.folder.path().join("out/deck.unstable.vtu");
    let mut results = ypsilon_post::results::Results::open(&picture).expect("results");
    let frame = results.frame(0).expect("a frame");
    assert_eq!(frame.elements.len(), 2);
    let stress = frame.stress.expect("stresses");
    assert!(stress.iter().flatten().all(|s| s.is_finite()) && stress[0][0] != 0.0, "{stress:?}");
}

#[test]
fn the_bound_of_the_energy_error_can_be_chosen() {
    // far from unstable, but the balance of energies is never exact
    let loose = run(&[], &["--energy=1", "--on-instability", "stop", "--quiet"]);
    assert_eq!(loose.code, Some(0), "{}", loose.stderr);
    let watched = ["--energy=1", "--energy-limit", "1e-15", "--on-instability", "stop", "--quiet"];
    let strict = run(&[], &watched);
    assert_eq!(strict.code, Some(4), "{}", strict.stderr);
    assert!(strict.stderr.contains("balance of energies is off"), "{}", strict.stderr);
    // it ends at the first step after which the balance is off
    let table = fs::read_to_string(strict.folder.path().join("out/deck.energy.csv"));
    let table = table.expect("the table of energies");
    let lines: Vec<Vec<f64>> = table
        .lines()
        .skip(1)
        .map(|line| line.split(',').map(|word| word.parse().expect("a number")).collect())
        .collect();
    let is_off: Vec<bool> = lines.iter().map(|line| line[line.len() - 1].abs() > 1e-15).collect();
    let (last, before) = is_off.split_last().expect("lines");
    assert!(*last && before.iter().all(|off| !off), "{table}");
    assert_eq!(step_in(&strict.stderr), is_off.len() as u64 - 1);
    let wrong = run(&[], &["--energy", "--energy-limit", "0"]);
    assert_eq!(wrong.code, Some(2), "{}", wrong.stderr);
    assert!(wrong.stderr.contains("expected a number above 0"), "{}", wrong.stderr);
}

#[test]
fn the_checkpoint_just_before_can_be_gone_on_from() {
    let stopped = run(TOO_LONG, &["--on-instability", "stop", "--quiet"]);
    let step = step_in(&stopped.stderr);
    let arguments = [
        "run",
        "deck.y",
        "--resume=out/deck.unstable.checkpoint",
        "--steps",
        "1",
        "--out",
        "again",
    ];
    let (code, stderr) = in_folder(stopped.folder.path(), &arguments);
    assert!(matches!(code, Some(0 | 4)), "{stderr}");
    assert!(stopped.folder.path().join("again/deck.checkpoint").exists(), "{stderr}");
    assert!(step > 0);
}

#[test]
fn a_warning_is_said_once_and_nothing_else_changes() {
    let plain = run(TOO_LONG, &["--steps", "600", "--states", "64,128"]);
    let warned =
        run(TOO_LONG, &["--steps", "600", "--states", "64,128", "--on-instability", "warn"]);
    assert_eq!(warned.code, Some(0), "{}", warned.stderr);
    assert_eq!(warned.stderr.matches("run::instability").count(), 1, "{}", warned.stderr);
    let warnings = warned.summary()["warnings"].to_string();
    assert_eq!(warnings.matches("has become unstable before step").count(), 1, "{warnings}");
    // without the option the run ends where it finds that there are no numbers
    assert_eq!(plain.code, Some(4), "{}", plain.stderr);
    assert!(plain.read("deck.state_64.txt").is_some());
    assert_eq!(plain.read("deck.state_64.txt"), warned.read("deck.state_64.txt"));
    assert!(warned.read("deck.state_128.txt").is_some());
}

#[test]
fn sound_runs_end_alike_whatever_is_to_be_done() {
    let plain = run(&[], &["--states", "20"]);
    for what in ["warn", "stop"] {
        let watched = run(&[], &["--states", "20", "--on-instability", what]);
        assert_eq!(watched.code, Some(0), "{}", watched.stderr);
        assert_eq!(plain.read("deck.state_20.txt"), watched.read("deck.state_20.txt"));
        assert!(watched.read("deck.unstable.state.txt").is_none());
        assert_eq!(plain.summary()["warnings"], watched.summary()["warnings"]);
    }
}

/// Nodes that are moved with a thousand times the speed of sound.
#[test]
fn runaway_nodes_are_named() {
    let fast = &[
        ("MCSTEP 20", "MCSTEP 200"),
        ("I1PNFX 2 3 1", "I1PNFX 2 3 3"),
        ("D1PNAX 2 0 5e3", "D1PNAX 2 0 1e6"),
        ("0.0 0.0 0.1 1.0 1.0 1.0", "0.0 1.0 0.1 1.0 1.0 1.0"),
        ("DCSTEC 1e-5", "DCSTEC 1e-12"),
    ];
    let stopped = run(fast, &["--on-instability", "stop", "--quiet"]);
    assert_eq!(stopped.code, Some(4), "{}", stopped.stderr);
    assert!(stopped.stderr.contains("times as fast as waves"), "{}", stopped.stderr);
    assert_eq!(step_in(&stopped.stderr), 0);
}

/// Energies that are off end a run that watches them.
#[test]
fn an_energy_error_stops_a_run_that_watches_energies() {
    let stopped = run(TOO_LONG, &["--energy", "--on-instability", "stop", "--quiet"]);
    assert_eq!(stopped.code, Some(4), "{}", stopped.stderr);
}
