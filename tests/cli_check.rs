//! `ypsilon check`: what a run will come to, before it starts. Every finding names a setting and
//! the value that it should have; with that value it is gone.

mod support;

use assert_cmd::Command;
use serde_json::Value;
use support::spoilt_deck::{Edits, edited, write};
use tempfile::TempDir;

/// Changes that leave nothing to be found but gravity, which acts at once.
const SOUND: Edits<'_> = &[
    ("DCSTEC 1e-5", "DCSTEC 3e-5"),
    ("D1PJPE 1 1e10", "D1PJPE 1 1.1e11"),
    ("D1PEPE 1 1e10", "D1PEPE 1 4.7e10"),
    ("D1PJGF 1 100", "D1PJGF 1 3000"),
    ("0.0 0.0 0.1 1.0 1.0 1.0", "0.0 0.0 0.05 0.0 1.0 1.0"),
    ("0.0 1.0 0.1 1.0 1.0 1.0", "0.0 0.0 0.1 1.0 1.0 1.0"),
];

/// Exit code and report of a deck after some changes.
fn check(changes: Edits<'_>) -> (i32, Value) {
    let folder = TempDir::new().expect("a temporary folder");
    let edits: Vec<_> = SOUND.iter().chain(changes).copied().collect();
    write(folder.path(), "deck.y", edited(&edits).as_bytes());
    let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
    let output = command.current_dir(&folder).args(["check", "--json", "deck.y"]).output();
    let output = output.expect("the program starts");
    let reports: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    (output.status.code().expect("an exit code"), reports[0].clone())
}

fn finding<'a>(report: &'a Value, code: &str) -> Option<&'a Value> {
    report["findings"].as_array()?.iter().find(|f| f["code"] == code)
}

#[test]
fn a_sound_deck_ends_with_code_0() {
    let (code, report) = check(&[]);
    let worse: Vec<_> = report["findings"]
        .as_array()
        .into_iter()
        .flatten()
        .filter(|f| f["severity"] != "note")
        .collect();
    assert!(worse.is_empty(), "{worse:?}");
    assert_eq!(code, 0);
    let factor = report["assessment"]["safety_factor"].as_f64().expect("a factor");
    assert!((1.2..2.0).contains(&factor), "{factor}");
    assert_eq!(report["runs"], true);
    assert_eq!(report["scene"]["triangles"], 2);
    assert!(finding(&report, "check::sudden-gravity").is_some());
}

/// Each change, what it should be found as, how bad that is, the exit code.
#[test]
fn every_finding_names_its_setting_and_a_value() {
    let cases: &[(Edits<'_>, &str, &str, i32)] = &[
        (&[("DCSTEC 3e-5", "DCSTEC 3e-4")], "check::time-step", "error", 1),
        (&[("DCSTEC 3e-5", "DCSTEC 5.6e-5")], "check::time-step", "warning", 5),
        // too long for contacts only, which open again
        (&[("DCSTEC 3e-5", "DCSTEC 8e-5")], "check::time-step", "warning", 5),
        (&[("DCSTEC 3e-5", "DCSTEC 5.33e-5")], "check::impact-step", "warning", 5),
        (
            &[("D1PEPE 1 4.7e10", "D1PEPE 1 4e17"), ("DCSTEC 3e-5", "DCSTEC 3e-9")],
            "check::precision",
            "warning",
            5,
        ),
        (&[("D1PEKS 1 1e4", "D1PEKS 1 3e8")], "check::viscosity", "error", 1),
        (&[("D1PEKS 1 1e4", "D1PEKS 1 1e7")], "check::overdamped", "note", 0),
        (&[("D1PEKS 1 1e4", "D1PEKS 1 0")], "check::undamped", "note", 0),
        (&[("D1PEPE 1 4.7e10", "D1PEPE 1 4e8")], "check::penalty", "warning", 5),
        (
            &[("D1PEPE 1 4.7e10", "D1PEPE 1 4e12"), ("DCSTEC 3e-5", "DCSTEC 3e-6")],
            "check::penalty",
            "warning",
            5,
        ),
        (
            &[("I1PNFX 2 3 1", "I1PNFX 2 3 3"), ("D1PNAX 2 0 5e3", "D1PNAX 2 0 5e3")],
            "check::buffer",
            "error",
            1,
        ),
        (&[("DIEZON 0.1", "DIEZON 3")], "check::buffer", "note", 0),
        (&[("D1PJPE 1 1.1e11", "D1PJPE 1 2e10")], "check::joint-softening", "warning", 5),
        (&[("D1PJFT 1 1e6", "D1PJFT 1 6e8")], "check::joint-opening", "warning", 5),
        (&[("D1PJGF 1 3000", "D1PJGF 1 1")], "check::fracture-energy", "warning", 5),
        (&[("D1PJGF 1 3000", "D1PJGF 1 1")], "check::fracture-zone", "note", 5),
        (
            &[("0.0 0.0 0.05 0.0 1.0 1.0", "0.0 1.0 0.05 1.0 1.0 1.0")],
            "check::sudden-load",
            "note",
            0,
        ),
    ];
    for (change, code, severity, exit) in cases {
        let (ended, report) = check(change);
        let found = finding(&report, code).unwrap_or_else(|| panic!("{code}: {report:#}"));
        assert_eq!(found["severity"], *severity, "{found:#}");
        assert_eq!(ended, *exit, "{code}: {report:#}");
        let text = |field: &str| found[field].as_str().unwrap_or_default();
        assert!(text("place").starts_with("deck.y:"), "{found:#}");
        assert!(text("expected").contains(|c: char| c.is_ascii_digit()), "{found:#}");
        let (_, sound) = check(&[]);
        assert!(finding(&sound, code).is_none(), "{code} in the sound deck");
    }
}

/// The value that is asked for is enough.
#[test]
fn the_step_that_is_asked_for_is_sound() {
    let (_, report) = check(&[("DCSTEC 3e-5", "DCSTEC 3e-4")]);
    let expected = finding(&report, "check::time-step").expect("found")["expected"].clone();
    let step = expected.as_str().expect("text").split_whitespace().nth(2).expect("a number");
    let (code, report) = check(&[("DCSTEC 3e-5", &format!("DCSTEC {step}"))]);
    assert_eq!(code, 0, "{report:#}");
}

#[test]
fn decks_that_cannot_be_read_are_in_the_report() {
    let folder = TempDir::new().expect("a temporary folder");
    write(folder.path(), "bad.y", b"/YD/YDC/MCSTEP 2e1\n$YDOIT\n");
    let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
    let arguments = ["check", "--json", "bad.y", "none.y"];
    let output = command.current_dir(&folder).args(arguments).output().expect("it starts");
    assert_eq!(output.status.code(), Some(1));
    let reports: Value = serde_json::from_slice(&output.stdout).expect("JSON");
    assert_eq!(reports[0]["runs"], false);
    assert!(finding(&reports[0], "deck::glued-text").is_some(), "{reports:#}");
    assert!(finding(&reports[1], "deck::unreadable").is_some(), "{reports:#}");
}
