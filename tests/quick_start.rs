//! The quick start and the tutorial of the manual: their commands, typed one after the other, leave what they say.
#![cfg(unix)]

use std::{env, fs, os::unix::fs::symlink, path::Path, process::Command};
use tempfile::TempDir;
use ypsilon_post::{field::Field, results::Results};

const TEXT: &str = include_str!("../docs/src/quick-start.md");
/// What it says of a bridge's own weight, Pa.
const LARGEST_COMPRESSION: f64 = 0.43e6;

/// Commands of the numbered steps, without those that get the program.
fn commands() -> Vec<&'static str> {
    let steps = TEXT.split("## Look at it with other programs").next().expect("the steps");
    let blocks =
        steps.split("```sh\n").skip(1).map(|rest| rest.split("```").next().expect("an end"));
    let lines = blocks.flat_map(str::lines);
    lines.filter(|line| line.starts_with("ypsilon ")).collect()
}

/// A folder that looks like the repository, with what `sh` prints for a command typed there.
struct Desk(TempDir);

impl Desk {
    fn new() -> Self {
        let folder = TempDir::new().expect("a temporary folder");
        let examples = concat!(env!("CARGO_MANIFEST_DIR"), "/examples");
        symlink(examples, folder.path().join("examples")).expect("a link");
        Self(folder)
    }

    fn type_in(&self, line: &str) -> (i32, String) {
        let program = Path::new(env!("CARGO_BIN_EXE_ypsilon")).parent().expect("its folder");
        let path = format!("{}:{}", program.display(), env::var("PATH").unwrap_or_default());
        let mut command = Command::new("sh");
        let output = command.args(["-c", line]).current_dir(&self.0).env("PATH", path).output();
        let output = output.expect("a shell");
        let said =
            String::from_utf8_lossy(&output.stdout) + String::from_utf8_lossy(&output.stderr);
        (output.status.code().expect("an exit code"), said.into_owned())
    }

    /// Words after an option, among all commands.
    fn files_of(option: &str) -> Vec<&'static str> {
        let after = |line: &'static str| {
            line.split_whitespace().skip_while(move |word| *word != option).nth(1)
        };
        commands().into_iter().filter_map(after).collect()
    }
}

#[test]
fn its_commands_lead_to_the_stresses_of_a_bridge() {
    let desk = Desk::new();
    let commands = commands();
    assert!(commands.len() > 8, "{commands:?}");
    let mut said = Vec::new();
    for line in commands {
        let (code, words) = desk.type_in(line);
        // the text says that there are warnings about the narrow bridge
        assert_eq!(code, if line.contains(" check ") { 5 } else { 0 }, "{line}: {words}");
        said.push(words);
    }
    let run = said.iter().find(|words| words.contains("joints have failed")).expect("a run");
    for words in
        ["863 triangles", "Settled in", "25001 steps", "166 joints have failed", "62 more files"]
    {
        assert!(run.contains(words), "{words}: {run}");
    }
    let pictures = [Desk::files_of("-o"), Desk::files_of("--picture")].concat();
    for name in pictures.iter().filter(|name| name.ends_with(".png")) {
        let picture = fs::read(desk.0.path().join(name)).expect("a picture");
        assert!(picture.starts_with(b"\x89PNG") && picture.len() > 10_000, "{name}");
    }
    let mut results =
        Results::open(&desk.0.path().join("results/bridge/bridge.pvd")).expect("results");
    let frame = results.frame(0).expect("the state at rest");
    let stress = Field::StressYy.values(&frame).expect("stresses");
    let least = stress.all().iter().copied().fold(f64::INFINITY, f64::min);
    assert!((least + LARGEST_COMPRESSION).abs() < 0.01e6, "{least}");
    let crown = fs::read_to_string(desk.0.path().join("crown.csv")).expect("a table");
    let uy = |line: &str| line.split(',').nth(1).and_then(|word| word.parse::<f64>().ok());
    let uy: Vec<f64> = crown.lines().filter_map(uy).collect();
    assert!((uy[0] + 0.16e-3).abs() < 0.01e-3, "{crown}");
    assert!((uy[uy.len() - 1] + 2.9e-3).abs() < 0.05e-3, "{crown}");
    let last = results.len() - 1;
    let frame = results.frame(last).expect("the cracked state");
    let least = Field::StressYy.values(&frame).expect("stresses");
    let least = least.all().iter().copied().fold(f64::INFINITY, f64::min);
    assert!(least < -2e6, "{least}");
}

#[test]
fn the_tutorial_leads_to_a_tower_that_rocks() {
    let text = include_str!("../docs/src/tutorial.md");
    let sources = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/src");
    let desk = Desk::new();
    let deck = desk.0.path().join("tower.y");
    fs::copy(sources.join("tower.y"), &deck).expect("the deck");
    let commands = text.lines().filter_map(|line| line.strip_prefix("$ "));
    let said: Vec<String> = commands
        .map(|line| {
            let (code, words) = desk.type_in(line);
            assert_eq!(code, 0, "{line}: {words}");
            words
        })
        .collect();
    assert_eq!(said.len(), 3);
    for line in
        text.lines().filter(|line| line.starts_with("  time step") || line.starts_with("tower.y:"))
    {
        assert!(said[0].contains(line), "{line}: {}", said[0]);
    }
    assert!(said[1].contains("80001 steps"), "{}", said[1]);
    let speed = fs::read_to_string(desk.0.path().join("tower/tower.yh1")).expect("a history");
    let last = speed.split_whitespace().next_back().expect("a value");
    assert!((last.parse::<f64>().expect("a number") - 0.64).abs() < 0.005, "{last}");
    let mut results = Results::open(&desk.0.path().join("tower")).expect("results");
    let frame = results.frame(results.len() - 1).expect("the last state");
    let base = frame.displacement.expect("displacements")[0][0];
    assert!((base - 0.14).abs() < 0.005, "{base}");
    assert!(desk.0.path().join("tower.png").exists());
    // and Octave makes this deck
    let script = sources.join("tower.m");
    let made =
        Command::new("octave-cli").arg("--no-gui").arg(&script).current_dir(&desk.0).output();
    if made.is_err() {
        println!("skipped: octave-cli is not installed, the deck of the tutorial is not made anew");
        return;
    }
    let (made, kept) = (fs::read(deck).expect("a deck"), fs::read(sources.join("tower.y")));
    assert!(made == kept.expect("the deck"), "tower.m makes another deck than tower.y");
}
