//! `ypsilon convert` as its users call it.

mod support;

use assert_cmd::Command;
use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
};
use support::spoilt_deck::{edited, write};
use tempfile::TempDir;

const MESHES: &str = "converters/tests/data/gmsh";
const YGEO: &str = "converters/tests/data/ygeo";

/// What the program did.
struct Finished {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

/// A folder to work in.
struct Workplace(TempDir);

impl Workplace {
    fn new() -> Self {
        Self(TempDir::new().expect("a temporary folder"))
    }

    fn path(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    /// Copies a file of the repository.
    fn take(&self, name: &str) {
        let from = Path::new(env!("CARGO_MANIFEST_DIR")).join(name);
        fs::copy(&from, self.path(from.file_name().unwrap().to_str().unwrap())).expect("a copy");
    }

    fn ypsilon(&self, arguments: &[&str]) -> Finished {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
        let output = command.current_dir(&self.0).args(arguments).output();
        let output = output.expect("the program starts");
        Finished {
            code: output.status.code(),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }

    fn files(&self, folder: &str) -> BTreeSet<String> {
        let entries = fs::read_dir(self.path(folder)).expect("a folder");
        entries.map(|e| e.unwrap().file_name().to_string_lossy().into_owned()).collect()
    }
}

fn names(of: &[&str]) -> BTreeSet<String> {
    of.iter().map(|&name| name.to_owned()).collect()
}

#[test]
fn meshes_become_decks_that_run() {
    for mesh in ["wall_22", "wall_41", "wall_saveall_41", "plain_22"] {
        let work = Workplace::new();
        work.take(&format!("{MESHES}/{mesh}.msh"));
        let finished = work.ypsilon(&["convert", &format!("{mesh}.msh")]);
        assert_eq!(finished.code, Some(0), "{}", finished.stderr);
        assert_eq!(finished.stdout, format!("{mesh}.msh -> ./{mesh}.y\n"));
        let deck = format!("{mesh}.y");
        let checked = work.ypsilon(&["check", &deck]);
        assert_eq!(checked.stderr, "", "{mesh}");
        assert!(checked.stdout.contains(": ready to run\n"), "{}", checked.stdout);
        let run = work.ypsilon(&["run", &deck, "--steps", "20", "--out", "out", "--quiet"]);
        assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""), "{mesh}");
        // With joints, as the deck's comments say.
        let text = fs::read_to_string(work.path(&deck)).expect("the deck");
        let record = text.find("I2PMSET").expect("a mesh record");
        let (before, after) = text.split_at(record);
        let jointed = format!("{before}{}", after.replacen(" 0 0", " 3 0", 1));
        assert_ne!(jointed, text);
        fs::write(work.path("jointed.y"), jointed).expect("another deck");
        let run = work.ypsilon(&["run", "jointed.y", "--steps", "20", "--out", "out", "--quiet"]);
        assert_eq!((run.code, run.stderr.as_str()), (Some(0), ""), "{mesh} with joints");
    }
}

#[test]
fn supports_stay_and_the_rest_falls() {
    let work = Workplace::new();
    work.take(&format!("{MESHES}/wall_41.msh"));
    work.ypsilon(&["convert", "wall_41.msh"]);
    let run = work.ypsilon(&["run", "wall_41.y", "--steps", "50", "--states", "50", "--quiet"]);
    assert_eq!(run.code, Some(0), "{}", run.stderr);
    let state = support::state_file::StateFile::read(&work.path("wall_41.state_50.txt")).unwrap();
    for (node, [_, set]) in state.nodes.iter().zip(&state.flags) {
        match set {
            1 => assert_eq!(node[2..4], [0.0, 0.0]),
            _ => assert!(node[3] < 0.0, "{node:?}"),
        }
    }
}

#[test]
fn a_folder_is_converted_by_what_is_in_it() {
    let work = Workplace::new();
    write(work.0.path(), "deck.y", edited(&[]).as_bytes());
    let run = ["run", "deck.y", "--out", "results", "--formats", "d3plot,yh", "--legacy-d3plot"];
    assert_eq!(work.ypsilon(&run).code, Some(0));
    work.take(&format!("{MESHES}/plain_22.msh"));
    fs::rename(work.path("plain_22.msh"), work.path("results/body.msh")).unwrap();
    fs::write(work.path("results/notes.txt"), "nothing to convert").unwrap();
    fs::rename(work.path("deck.y"), work.path("results/deck.y")).unwrap();
    // Header word 11 of the original's d3plot files is 0, others expect 1.
    let d3plot = fs::read(work.path("results/deck")).unwrap();
    assert_eq!(d3plot[44..48], [0; 4]);
    let finished = work.ypsilon(&["convert", "results", "--out", "all"]);
    assert_eq!((finished.code, finished.stderr.as_str()), (Some(0), ""));
    let files = work.files("all");
    let expected = ["body.y", "deck.pvd", "deck.yh0.csv", "deck_0.vtu", "deck_1.vtu"];
    assert!(names(&expected).is_subset(&files), "{files:?}");
    assert!(!files.contains("deck_split.y") && !files.contains("notes.txt.csv"), "{files:?}");
    // What is asked for picks the files.
    let finished = work.ypsilon(&["convert", "results", "--out", "tables", "--to", "csv"]);
    assert_eq!((finished.code, finished.stderr.as_str()), (Some(0), ""));
    assert_eq!(work.files("tables"), names(&["deck.yh0.csv"]));
}

#[test]
fn a_run_of_ygeo_becomes_one_collection() {
    let work = Workplace::new();
    let data = Path::new(env!("CARGO_MANIFEST_DIR")).join(YGEO);
    let data = data.to_str().unwrap();
    let finished = work.ypsilon(&["convert", data, "--out", "linked"]);
    assert_eq!((finished.code, finished.stderr.as_str()), (Some(0), ""));
    assert_eq!(finished.stdout.lines().count(), 1, "{}", finished.stdout);
    assert_eq!(work.files("linked"), names(&["g_joint_pair.y.pvd"]));
    let finished = work.ypsilon(&["convert", data, "--out", "copied", "--to", "vtu"]);
    assert_eq!((finished.code, finished.stderr.as_str()), (Some(0), ""));
    assert_eq!(work.files("copied").len(), 15);
}

#[test]
fn decks_change_their_dialect() {
    let work = Workplace::new();
    work.take(&format!("{YGEO}/g_joint_pair.y"));
    let arguments = ["convert", "g_joint_pair.y", "--to", "deck", "--out", "split"];
    let finished = work.ypsilon(&arguments);
    assert_eq!(finished.code, Some(0));
    assert_eq!(finished.stdout, "g_joint_pair.y -> split/g_joint_pair_split.y\n");
    assert!(finished.stderr.contains("fracture energy of opening"), "{}", finished.stderr);
    let checked = work.ypsilon(&["check", "split/g_joint_pair_split.y"]);
    assert_eq!(checked.stderr, "");
    assert!(checked.stdout.contains(": ready to run\n"), "{}", checked.stdout);
    // A deck is not replaced: it may have been changed by hand.
    let again = work.ypsilon(&arguments);
    assert_eq!(again.code, Some(1));
    assert!(again.stderr.contains("exists and is not replaced"), "{}", again.stderr);
    let classic = work.ypsilon(&[
        "convert",
        "split/g_joint_pair_split.y",
        "--to",
        "deck",
        "--dialect",
        "classic",
    ]);
    assert_eq!(classic.code, Some(0), "{}", classic.stderr);
    assert!(work.path("g_joint_pair_split_classic.y").exists());
    let alone = work.ypsilon(&["convert", "g_joint_pair.y"]);
    assert_eq!(alone.code, Some(1));
    assert!(alone.stderr.contains("--to deck --dialect"), "{}", alone.stderr);
}

#[test]
fn broken_inputs_do_not_keep_others_from_being_converted() {
    let work = Workplace::new();
    write(work.0.path(), "deck.y", edited(&[]).as_bytes());
    assert_eq!(work.ypsilon(&["deck.y", "--formats", "d3plot,yh"]).code, Some(0));
    let d3plot = fs::read(work.path("deck")).unwrap();
    fs::write(work.path("short"), &d3plot[..300]).unwrap();
    let mut wrong = d3plot.clone();
    let first_shell = 256 + 12 * u32::from_le_bytes(d3plot[64..68].try_into().unwrap()) as usize;
    wrong[first_shell..first_shell + 4].copy_from_slice(&99_i32.to_le_bytes());
    fs::write(work.path("wrong"), wrong).unwrap();
    fs::write(work.path("broken.yh0"), "+0.0e+00 +0.0e+00\n+1.0e+00 what\n").unwrap();
    fs::write(work.path("cut.msh"), "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n$Nodes\n1 5").unwrap();
    fs::write(work.path("no_step.vtp"), "<VTKFile type='PolyData' version='0.1'>").unwrap();
    fs::write(work.path("text.txt"), "what?").unwrap();
    let broken =
        ["short", "wrong", "broken.yh0", "cut.msh", "no_step.vtp", "text.txt", "missing.yh0"];
    let finished = work
        .ypsilon(&[&["convert"][..], &broken[..], &["deck.yh0", "--out", "converted"]].concat());
    assert_eq!(finished.code, Some(1));
    for name in broken {
        let said = finished.stderr.lines().filter(|line| line.starts_with("error: "));
        let count = said.filter(|line| line.contains(name)).count();
        assert_eq!(count, 1, "{name}:\n{}", finished.stderr);
    }
    assert_eq!(finished.stdout, "deck.yh0 -> converted/deck.yh0.csv\n");
    assert_eq!(work.files("converted"), names(&["deck.yh0.csv"]));
}

#[test]
fn two_inputs_never_become_the_same_file() {
    let work = Workplace::new();
    for folder in ["a", "b"] {
        fs::create_dir(work.path(folder)).unwrap();
        fs::write(work.path(folder).join("run.yh0"), "+0.0e+00 +0.0e+00\n").unwrap();
    }
    let finished = work.ypsilon(&["convert", "a", "b", "a/run.yh0"]);
    assert_eq!(finished.code, Some(1));
    let said = "error: a/run.yh0 and b/run.yh0 would both become ./run.yh0.csv; convert them into \
                different folders\n";
    assert_eq!(finished.stderr, said);
    assert_eq!(finished.stdout, "a/run.yh0 -> ./run.yh0.csv\n");
}

#[test]
fn what_does_not_suit_the_input_is_refused() {
    let work = Workplace::new();
    fs::write(work.path("run.yh0"), "+0.0e+00 +0.0e+00\n").unwrap();
    let finished = work.ypsilon(&["convert", "run.yh0", "--to", "pvd"]);
    assert_eq!(finished.code, Some(1));
    assert_eq!(
        finished.stderr,
        "error: run.yh0 cannot become pvd; inputs of its kind become csv\n"
    );
    assert_eq!(work.ypsilon(&["convert", "run.yh0", "--to", "stl"]).code, Some(2));
    // A folder in the place of the output.
    fs::create_dir_all(work.path("out/run.yh0.csv")).unwrap();
    let finished = work.ypsilon(&["convert", "run.yh0", "--out", "out"]);
    assert_eq!(finished.code, Some(3), "{}", finished.stderr);
    assert_eq!(work.files("out"), names(&["run.yh0.csv"]));
}
