//! A run that is killed at any instant leaves complete files only, and goes on from its last
//! checkpoint to the same bits; a disk that is full, a folder that is read-only or gone ends a run
//! with a clear error.
#![cfg(unix)]

mod support;

use std::{
    collections::BTreeMap,
    fs,
    os::unix::fs::PermissionsExt as _,
    path::Path,
    process::{Command, Output, Stdio},
    thread::sleep,
    time::{Duration, Instant},
};
use support::spoilt_deck::{edited, write};
use tempfile::TempDir;

const STEPS: &str = "MCSTEP 40000";

/// Flags of all runs: files of all kinds that a run goes on with, and checkpoints.
const RUN: [&str; 5] = ["--formats", "native,vtu", "--quiet", "--checkpoint-every", "400"];

fn folder() -> TempDir {
    let folder = TempDir::new().expect("a temporary folder");
    let deck = edited(&[
        ("MCSTEP 20", STEPS),
        ("DCSTEC 1e-5", "DCSTEC 1e-8"),
        ("ICOUTF 10", "ICOUTF 250"),
    ]);
    write(folder.path(), "deck.y", deck.as_bytes());
    folder
}

fn command(folder: &Path, arguments: &[&str]) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
    command.current_dir(folder).args(arguments).stdin(Stdio::null());
    command
}

fn stderr(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).into_owned()
}

/// Result files by name: what is not complete ends in `.part`; dates and durations are left out.
fn results(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let entries = fs::read_dir(folder).expect("the folder").flatten();
    let named = entries.map(|entry| (entry.file_name().to_string_lossy().into_owned(), entry));
    named
        .filter(|(name, _)| !["Ytmp", "deck.y", "deck.checkpoint"].contains(&name.as_str()))
        .filter_map(|(name, entry)| Some((name, fs::read(entry.path()).ok()?)))
        .collect()
}

/// Whether a collection is the beginning of the whole one, and all its files are complete.
fn lists_what_is_there(collection: &[u8], whole: &[u8], found: &BTreeMap<String, Vec<u8>>) -> bool {
    let (text, whole) = (String::from_utf8_lossy(collection), String::from_utf8_lossy(whole));
    let files = |text: &str| -> Vec<String> {
        let names = text.split("file=\"").skip(1).filter_map(|rest| rest.split('"').next());
        names.map(str::to_owned).collect()
    };
    text.lines().last() == whole.lines().last()
        && text.lines().all(|line| whole.lines().any(|other| other == line))
        && files(&text).iter().all(|name| found.contains_key(name))
}

/// Kills a run so many times at random instants, and goes on with it each time.
fn survives(kills: u32, seed: u64) {
    let straight = folder();
    let started = Instant::now();
    let output = command(straight.path(), &["run", "deck.y"]).args(RUN).output();
    let output = output.expect("the program runs");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let whole = started.elapsed();
    let expected = results(straight.path());
    assert!(expected.len() > 100, "{}", expected.len());

    let mut state = seed;
    let mut random = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64
    };
    let (mut done, mut gone_on, mut from_start, mut finished) = (0, 0, 0, 0);
    while done < kills {
        let killed = folder();
        // one run, killed several times on its way
        for _ in 0..10 {
            let has_checkpoint = killed.path().join("deck.checkpoint").exists();
            let mut run = if has_checkpoint {
                gone_on += 1;
                command(
                    killed.path(),
                    &["run", "deck.y", "--resume", "--quiet", "--checkpoint-every", "400"],
                )
            } else {
                from_start += 1;
                let mut run = command(killed.path(), &["run", "deck.y"]);
                run.args(RUN);
                run
            };
            let child = run.stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
            let mut child = child.expect("the program starts");
            sleep(whole.mul_f64(random() * 0.3));
            if child.try_wait().expect("the program is there").is_some() {
                break;
            }
            child.kill().expect("it can be killed");
            let output = child.wait_with_output().expect("it ends");
            if output.status.code().is_some() {
                break;
            }
            done += 1;
            let found = results(killed.path());
            for (name, bytes) in found.iter().filter(|(name, _)| !name.ends_with(".part")) {
                let is_complete = match name.ends_with(".pvd") {
                    true => lists_what_is_there(bytes, &expected[name], &found),
                    false => expected.get(name) == Some(bytes),
                };
                assert!(is_complete, "{name} is not complete, kill {done}");
            }
        }
        let last = if killed.path().join("deck.checkpoint").exists() {
            command(killed.path(), &["run", "deck.y", "--resume", "--quiet"]).output()
        } else {
            command(killed.path(), &["run", "deck.y"]).args(RUN).output()
        };
        let last = last.expect("the program runs");
        assert_eq!(last.status.code(), Some(0), "{}", stderr(&last));
        finished += 1;
        let found = results(killed.path());
        let names = |files: &BTreeMap<String, Vec<u8>>| -> Vec<String> {
            files.keys().filter(|name| !name.ends_with(".part")).cloned().collect()
        };
        assert_eq!(names(&found), names(&expected));
        for (name, bytes) in &expected {
            assert!(found.get(name) == Some(bytes), "{name} differs after {done} kills");
        }
    }
    println!(
        "{done} kills, {finished} runs: {gone_on} starts from a checkpoint, {from_start} anew"
    );
    assert!(gone_on > 0, "no run was gone on with");
}

#[test]
fn twelve_kills_lose_nothing() {
    survives(12, 0x2545_F491_4F6C_DD1D);
}

#[test]
#[ignore = "minutes"]
fn two_hundred_kills_lose_nothing() {
    survives(200, 0x9E37_79B9_7F4A_7C15);
}

/// A limit on the size of files stands for the end of the disk.
#[test]
fn a_full_disk_ends_the_run_with_an_error_and_complete_files() {
    let full = folder();
    // no file may grow beyond 16 blocks of 1024 bytes; the signal that says so is ignored
    let program = env!("CARGO_BIN_EXE_ypsilon");
    let script = format!(
        "trap '' XFSZ; ulimit -f 16; exec {program} run deck.y --formats yh,d3plot,vtu --quiet --out out"
    );
    let output = Command::new("bash").args(["-c", &script]).current_dir(&full).output();
    let output = output.expect("a shell");
    assert_eq!(output.status.code(), Some(3), "{}", stderr(&output));
    assert!(stderr(&output).contains("out/deck"), "{}", stderr(&output));
    let straight = folder();
    let arguments = ["run", "deck.y", "--formats", "yh,d3plot,vtu", "--out", "out"];
    let output = command(straight.path(), &arguments).output().expect("the program runs");
    assert_eq!(output.status.code(), Some(0), "{}", stderr(&output));
    let expected = results(&straight.path().join("out"));
    let found = results(&full.path().join("out"));
    // collections list what is there, and the last file of a family may end early
    for (name, bytes) in found.iter().filter(|(name, _)| name.ends_with(".vtu")) {
        assert!(expected.get(name) == Some(bytes), "{name} is not complete");
    }
}

#[test]
fn a_folder_that_is_read_only_ends_with_code_3_and_nothing_is_written() {
    let work = folder();
    let out = work.path().join("out");
    fs::create_dir(&out).expect("a folder");
    fs::set_permissions(&out, fs::Permissions::from_mode(0o555)).expect("permissions");
    fs::set_permissions(work.path(), fs::Permissions::from_mode(0o755)).expect("permissions");
    let arguments = ["run", "deck.y", "--quiet", "--out", "out"];
    let mut run = command(work.path(), &arguments);
    if fs::write(out.join("probe"), "").is_ok() {
        // root may write everywhere: the program runs as somebody else
        fs::remove_file(out.join("probe")).expect("the probe");
        run = Command::new("setpriv");
        run.args(["--reuid=65534", "--regid=65534", "--clear-groups"]);
        run.arg(env!("CARGO_BIN_EXE_ypsilon")).args(arguments).current_dir(work.path());
    }
    let output = run.output().expect("the program runs");
    assert_eq!(output.status.code(), Some(3), "{}", stderr(&output));
    assert!(stderr(&output).contains("out"), "{}", stderr(&output));
    fs::set_permissions(&out, fs::Permissions::from_mode(0o755)).expect("permissions");
    assert_eq!(fs::read_dir(&out).expect("it").count(), 0);
}

#[test]
fn a_folder_that_vanishes_ends_the_run_with_code_3() {
    let work = folder();
    let mut run = command(work.path(), &["run", "deck.y", "--out", "out"]);
    let child = run.args(RUN).stdout(Stdio::null()).stderr(Stdio::piped()).spawn();
    let child = child.expect("the program starts");
    let out = work.path().join("out");
    let started = Instant::now();
    while !out.join("deck.checkpoint").exists() {
        assert!(started.elapsed() < Duration::from_secs(60), "no checkpoint");
        sleep(Duration::from_millis(2));
    }
    // the run may be making a file in it at this moment
    let removed =
        (0..1000).any(|_| fs::remove_dir_all(&out).or_else(|_| fs::remove_dir_all(&out)).is_ok());
    assert!(removed, "it can be removed");
    let output = child.wait_with_output().expect("it ends");
    assert_eq!(output.status.code(), Some(3), "{}", stderr(&output));
    let text = stderr(&output);
    assert!(text.contains("out/deck") && text.contains("error"), "{text}");
}
