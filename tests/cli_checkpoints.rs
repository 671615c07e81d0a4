//! Runs that are stopped or killed and gone on with, as their users see it.
#![cfg(unix)]

mod support;

use std::{fs, path::Path, process::Output};
use support::{
    child::{command, signal, start, wait_until},
    spoilt_deck::{edited, write},
};
use tempfile::TempDir;

/// A folder with a deck of so many steps, which writes a state every 50.
fn folder(steps: &str) -> TempDir {
    let folder = TempDir::new().expect("a temporary folder");
    let deck =
        edited(&[("MCSTEP 20", steps), ("DCSTEC 1e-5", "DCSTEC 1e-9"), ("ICOUTF 10", "ICOUTF 50")]);
    write(folder.path(), "deck.y", deck.as_bytes());
    folder
}

fn run(folder: &TempDir, arguments: &[&str]) -> Output {
    command(folder, arguments).output().expect("the program runs")
}

fn stdout(output: &Output) -> String {
    String::from_utf8_lossy(&output.stdout).into_owned()
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Names and bytes of all result files that tell nothing of dates and durations.
fn results(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).expect("the folder").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if !["Ytmp", "deck.y", "deck.checkpoint", "deck.run.json"].contains(&name.as_str()) {
            files.push((name, fs::read(entry.path()).expect("a result")));
        }
    }
    files.sort();
    files
}

fn assert_same(resumed: &TempDir, straight: &TempDir) {
    let (resumed, straight) = (results(resumed.path()), results(straight.path()));
    let names = |files: &[(String, Vec<u8>)]| -> Vec<String> {
        files.iter().map(|(name, _)| name.clone()).collect()
    };
    assert_eq!(names(&resumed), names(&straight));
    for ((name, resumed), (_, straight)) in resumed.iter().zip(&straight) {
        assert!(resumed == straight, "{name} differs");
    }
}

const STEPS: &str = "MCSTEP 400000";

/// A run of all steps that nobody stops.
fn straight(formats: &str) -> TempDir {
    let straight = folder(STEPS);
    let output = run(&straight, &["deck.y", "--formats", formats, "-q"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    straight
}

fn part_length(folder: &TempDir) -> u64 {
    fs::metadata(folder.path().join("deck.part")).map_or(0, |file| file.len())
}

#[test]
fn an_interrupted_run_goes_on_where_it_stopped() {
    let stopped = folder(STEPS);
    let child = start(command(&stopped, &["deck.y", "--formats", "d3plot,yh", "--checkpoint"]));
    wait_until("the run gets on", || part_length(&stopped) > 20_000);
    signal(&child, "-INT");
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(output.status.code(), Some(130));
    assert!(
        stdout(&output).contains("with `ypsilon resume ./deck.checkpoint`"),
        "{}",
        stdout(&output)
    );
    // formats are those of the first part
    let output = run(&stopped, &["deck.y", "--resume"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).contains("400000 steps"), "{}", stdout(&output));
    assert_same(&stopped, &straight("d3plot,yh"));
}

#[test]
fn a_killed_run_goes_on_from_its_last_checkpoint() {
    let killed = folder(STEPS);
    let arguments = ["deck.y", "--formats", "d3plot,yh", "--checkpoint-every", "17000"];
    let mut child = start(command(&killed, &arguments));
    let checkpoint = killed.path().join("deck.checkpoint");
    wait_until("the run gets on", || checkpoint.exists() && part_length(&killed) > 50_000);
    signal(&child, "-KILL");
    child.wait().expect("it ends");
    assert!(killed.path().join("deck.part").exists(), "it was killed on the way");
    // and killed once more
    let mut arguments = arguments.to_vec();
    arguments.push("--resume");
    let before = part_length(&killed);
    let mut child = start(command(&killed, &arguments));
    wait_until("the run gets on", || part_length(&killed) > before + 30_000);
    signal(&child, "-KILL");
    child.wait().expect("it ends");
    let output = run(&killed, &["deck.y", "--resume", "-q"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_same(&killed, &straight("d3plot,yh"));
}

#[test]
fn what_cannot_be_gone_on_with_is_refused_by_name() {
    let folder = folder("MCSTEP 400");
    let code = |arguments: &[&str]| {
        let output = run(&folder, arguments);
        (output.status.code(), stderr(&output))
    };
    let (exit, said) = code(&["deck.y", "--resume"]);
    assert_eq!(exit, Some(1));
    assert!(said.contains("cannot read the checkpoint ./deck.checkpoint"), "{said}");
    assert!(results(folder.path()).is_empty(), "no file was touched");

    let (exit, said) = code(&["deck.y", "--steps", "90", "--checkpoint", "-q"]);
    assert_eq!((exit, said.as_str()), (Some(0), ""));
    let (exit, said) = code(&["deck.y", "--resume=deck.y"]);
    assert_eq!(exit, Some(1));
    assert!(said.contains("deck.y is no checkpoint of Ypsilon"), "{said}");
    let (exit, said) = code(&["deck.y", "--resume", "--formats", "d3plot"]);
    assert_eq!(exit, Some(1));
    assert!(said.contains("it wrote yh, d3plot, vtu"), "{said}");
    let (exit, said) = code(&["deck.y", "--resume", "--dialect", "classic"]);
    assert_eq!(exit, Some(2), "{said}");

    let deck = fs::read_to_string(folder.path().join("deck.y")).expect("the deck");
    write(folder.path(), "deck.y", deck.replace("MCSTEP 400", "MCSTEP 80").as_bytes());
    let (exit, said) = code(&["deck.y", "--resume"]);
    assert_eq!(exit, Some(1));
    assert!(said.contains("at step 90, but MCSTEP of the deck is 80"), "{said}");
    write(folder.path(), "deck.y", deck.replace("D1PNAX 2 0 5e3", "D1PNAX 2 0 5e4").as_bytes());
    let (exit, said) = code(&["deck.y", "--resume"]);
    assert_eq!(exit, Some(1));
    assert!(said.contains("deck.y is not the deck of the checkpoint"), "{said}");

    write(folder.path(), "deck.y", deck.as_bytes());
    let history = folder.path().join("deck.yh0");
    let kept = fs::read(&history).expect("a history");
    fs::write(&history, b"0 0\n").expect("writable");
    let (exit, said) = code(&["deck.y", "--resume"]);
    assert_eq!(exit, Some(3));
    assert!(said.contains("cannot go on with ./deck.yh0"), "{said}");
    fs::write(&history, kept).expect("writable");
    let (exit, said) = code(&["deck.y", "--resume", "-q"]);
    assert_eq!((exit, said.as_str()), (Some(0), ""));
}

/// A cube that falls on another one and slides on it.
const SLIDING_CUBE: &str = include_str!("data/split3d/t3d_friction/t3d_friction.y");

#[test]
fn a_resumed_run_keeps_the_law_of_contact_of_tetrahedra() {
    let law = ["--contact", "two-sided", "--contact-friction"];
    let folder = || {
        let folder = TempDir::new().expect("a temporary folder");
        write(folder.path(), "deck.y", SLIDING_CUBE.as_bytes());
        folder
    };
    let common = ["deck.y", "--formats", "json", "--states", "900", "-q"];
    let go = |folder: &TempDir, more: &[&str]| {
        let output = run(folder, &[&common[..], more].concat());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    };
    let (straight, resumed, original) = (folder(), folder(), folder());
    go(&straight, &[&law[..], &["--steps", "900"]].concat());
    go(&original, &["--steps", "900"]);
    go(&resumed, &[&law[..], &["--steps", "400", "--checkpoint"]].concat());
    let output = run(&resumed, &["deck.y", "--resume", "--steps", "500", "-q"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_same(&resumed, &straight);
    assert_ne!(results(straight.path()), results(original.path()), "the law has an effect");
    let output = run(&resumed, &["deck.y", "--resume", "--contact", "one-sided"]);
    assert_eq!(output.status.code(), Some(2), "the law cannot change halfway");
}

/// Tables that add up over the whole run: works of forces, and what nodes do together.
#[test]
fn tables_of_energies_and_monitors_are_gone_on_with() {
    let watched = [
        "--energy=10",
        "--monitor",
        "top=nodes:2,3:uy,force-y,kinetic-energy",
        "--monitor",
        "all=box:,:0.5:reaction-x,strain-energy",
        "--monitor-every",
        "25",
    ];
    let (straight, resumed) = (folder("MCSTEP 2000"), folder("MCSTEP 2000"));
    for (folder, more) in
        [(&straight, &["-q"][..]), (&resumed, &["-q", "--checkpoint", "--steps", "777"])]
    {
        let output = run(folder, &[&["deck.y", "--formats", "yh"], &watched[..], more].concat());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    }
    let half = fs::read_to_string(resumed.path().join("deck.energy.csv")).expect("a table");
    // what is watched is that of the first part
    let output = run(&resumed, &["resume", ".", "-q"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_same(&resumed, &straight);
    let whole = fs::read_to_string(resumed.path().join("deck.energy.csv")).expect("a table");
    assert_eq!((half.lines().count(), whole.lines().count()), (79, 201));
    assert!(whole.starts_with(&half));
    let output = run(&resumed, &["deck.y", "--resume", "--energy=20"]);
    assert_eq!(output.status.code(), Some(2), "a table cannot get other lines halfway");
}

#[test]
fn the_table_of_energies_is_gone_on_with_in_space() {
    let folder = || {
        let folder = TempDir::new().expect("a temporary folder");
        write(folder.path(), "deck.y", SLIDING_CUBE.as_bytes());
        folder
    };
    let (straight, resumed) = (folder(), folder());
    let common = ["deck.y", "--formats", "yh", "--energy=20", "--contact", "two-sided", "-q"];
    let output = run(&straight, &[&common[..], &["--steps", "600"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let output = run(&resumed, &[&common[..], &["--steps", "250", "--checkpoint"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let output = run(&resumed, &["resume", "deck.checkpoint", "--steps", "350", "-q"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert_same(&resumed, &straight);
}

#[test]
fn a_run_is_gone_on_with_by_the_name_of_its_folder() {
    let (straight, stopped) = (folder("MCSTEP 400"), folder("MCSTEP 400"));
    for (folder, more) in
        [(&straight, &["-q"][..]), (&stopped, &["-q", "--steps", "150", "--checkpoint"])]
    {
        let deck = ["run", "deck.y", "--out", "out", "--formats", "d3plot,yh"];
        let output = run(folder, &[&deck[..], more].concat());
        assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    }
    let out = |folder: &TempDir| results(&folder.path().join("out"));
    // the deck is found from wherever the program is started
    let elsewhere = TempDir::new().expect("a temporary folder");
    let at = stopped.path().join("out").display().to_string();
    let output = run(&elsewhere, &["resume", &at, "--steps", "100"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(stdout(&output).contains("with `ypsilon resume"), "{}", stdout(&output));
    // and if it has gone away, it is asked for
    let deck = stopped.path().join("deck.y");
    let moved = elsewhere.path().join("deck.y");
    fs::rename(&deck, &moved).expect("moved");
    let output = run(&elsewhere, &["resume", &at, "-q"]);
    assert_eq!(output.status.code(), Some(1));
    let said = stderr(&output);
    assert!(said.contains("deck.y, which is not there any more: say with --deck"), "{said}");
    let output = run(&elsewhere, &["resume", &at, "-q", "--deck", "deck.y"]);
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    assert!(out(&stopped) == out(&straight));
}

#[test]
fn a_folder_without_or_with_several_checkpoints_is_refused() {
    let folder = folder("MCSTEP 20");
    let code = |arguments: &[&str]| {
        let output = run(&folder, arguments);
        (output.status.code(), stderr(&output))
    };
    let (exit, said) = code(&["resume", "."]);
    assert_eq!(exit, Some(1));
    assert!(
        said.contains("there is no checkpoint in .: runs write one with --checkpoint"),
        "{said}"
    );
    let (exit, said) = code(&["resume", "nowhere"]);
    assert_eq!(exit, Some(1));
    assert!(said.contains("cannot read the checkpoint nowhere"), "{said}");
    for name in ["a.checkpoint", "b.checkpoint", "c.unstable.checkpoint"] {
        write(folder.path(), name, b"");
    }
    let (exit, said) = code(&["resume", "."]);
    assert_eq!(exit, Some(1));
    assert!(said.contains("name one of them: ./a.checkpoint, ./b.checkpoint\n"), "{said}");
}

#[test]
fn laws_of_contact_of_tetrahedra_are_refused_in_the_plane() {
    let folder = folder("MCSTEP 20");
    for law in [&["--contact", "two-sided"][..], &["--contact-friction"]] {
        let output = run(&folder, &[&["deck.y"], law].concat());
        let said = stderr(&output);
        assert_eq!(output.status.code(), Some(2));
        assert!(said.contains("deck.y is a deck in the plane (NNODIM 2)"), "{said}");
        assert!(results(folder.path()).is_empty(), "no file was touched");
    }
}
