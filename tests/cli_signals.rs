//! Runs that are interrupted, and screens that go away.
#![cfg(unix)]

mod support;

use std::{fs, os::unix::process::ExitStatusExt, process::Child};
use support::{
    child::{self, command, signal, wait_until},
    spoilt_deck::{edited, write},
};
use tempfile::TempDir;
use yformat::d3plot::FamilyReader;

/// The program in a folder with a deck of so many steps, its output in pipes.
fn start(folder: &TempDir, steps: &str, arguments: &[&str]) -> Child {
    let deck = edited(&[("MCSTEP 20", steps), ("DCSTEC 1e-5", "DCSTEC 1e-9")]);
    write(folder.path(), "deck.y", deck.as_bytes());
    child::start(command(folder, arguments))
}

/// Waits until the d3plot file has got some states.
fn wait_for_states(folder: &TempDir) {
    let size = || fs::metadata(folder.path().join("deck.part")).map_or(0, |file| file.len());
    wait_until("the run does not get on", || size() >= 20_000);
}

#[test]
fn an_interrupted_run_completes_its_files() {
    let folder = TempDir::new().expect("a temporary folder");
    let child = start(&folder, "MCSTEP 2000000000", &["deck.y", "--formats", "d3plot,yh,json"]);
    wait_for_states(&folder);
    signal(&child, "-INT");
    let output = child.wait_with_output().expect("the program ends");
    assert_eq!(output.status.code(), Some(130));
    let said = String::from_utf8_lossy(&output.stdout);
    assert!(said.contains("interrupted: all files are complete"), "{said}");
    let d3plot = FamilyReader::open(&folder.path().join("deck")).expect("a d3plot file");
    assert!(d3plot.state_count() > 1);
    assert!(d3plot.notices().is_empty(), "only whole states: {:?}", d3plot.notices());
    let history = fs::read_to_string(folder.path().join("deck.yh0")).expect("a history");
    assert!(history.ends_with('\n') && history.lines().all(|line| line.len() == 35), "whole lines");
    let summary = fs::read_to_string(folder.path().join("deck.run.json")).expect("the summary");
    assert!(summary.contains("\"stop\": \"interrupted\""), "{summary}");
    for file in fs::read_dir(&folder).expect("the folder").flatten() {
        assert!(!file.file_name().to_string_lossy().ends_with(".part"), "{file:?}");
    }
}

#[test]
fn a_closed_pipe_ends_no_run() {
    let folder = TempDir::new().expect("a temporary folder");
    let mut child = start(&folder, "MCSTEP 3000", &["deck.y"]);
    drop((child.stdout.take(), child.stderr.take()));
    let status = child.wait().expect("the program ends");
    assert_eq!((status.code(), status.signal()), (Some(0), None));
    assert!(folder.path().join("deck.pvd").exists());
}

#[test]
fn messages_into_a_closed_pipe_panic_not() {
    for (arguments, code) in
        [(&["no-deck.y"][..], 1), (&["check", "deck.y"], 5), (&["convert", "deck.y"], 1)]
    {
        let folder = TempDir::new().expect("a temporary folder");
        let mut child = start(&folder, "MCSTEP 20", arguments);
        drop((child.stdout.take(), child.stderr.take()));
        let status = child.wait().expect("the program ends");
        assert_eq!((status.code(), status.signal()), (Some(code), None), "{arguments:?}");
    }
}
