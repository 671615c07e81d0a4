//! The program as its users call it: arguments, files, messages, exit codes.

mod support;

use assert_cmd::Command;
use std::{
    collections::BTreeSet,
    fs,
    path::{Path, PathBuf},
};
use support::spoilt_deck::{Edits, edited, write};
use tempfile::TempDir;
use yformat::{d3plot::FamilyReader, history::History};

/// A folder with a deck in it.
struct Workplace {
    folder: TempDir,
}

impl Workplace {
    fn new(edits: Edits<'_>) -> Self {
        let folder = TempDir::new().expect("a temporary folder");
        write(folder.path(), "deck.y", edited(edits).as_bytes());
        Self { folder }
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    fn ypsilon(&self, arguments: &[&str]) -> Finished {
        let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
        let output = command.current_dir(&self.folder).args(arguments).output();
        let output = output.expect("the program starts");
        Finished {
            code: output.status.code(),
            stdout: String::from_utf8_lossy(&output.stdout).into_owned(),
            stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }

    /// Names of the files in a folder below.
    fn files(&self, folder: &str) -> BTreeSet<String> {
        file_names(&self.path(folder))
    }
}

/// What a call of the program came to.
#[derive(Debug)]
struct Finished {
    code: Option<i32>,
    stdout: String,
    stderr: String,
}

fn file_names(folder: &Path) -> BTreeSet<String> {
    let entries = fs::read_dir(folder).into_iter().flatten().flatten();
    entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect()
}

fn names(of: &[&str]) -> BTreeSet<String> {
    of.iter().map(|&name| name.to_owned()).collect()
}

#[test]
fn a_deck_alone_writes_its_results_beside_itself() {
    let work = Workplace::new(&[]);
    let finished = work.ypsilon(&["deck.y"]);
    assert_eq!((finished.code, finished.stderr.as_str()), (Some(0), ""));
    assert!(finished.stdout.contains("NEW INPUT: deck.y"));
    assert!(finished.stdout.contains("Y HAS ORDERLY FINISHED"));
    let expected = [
        "Ytmp",
        "deck",
        "deck.pvd",
        "deck.y",
        "deck.yh0",
        "deck_0000000.vtu",
        "deck_0000010.vtu",
        "deck_joints_0000000.vtu",
        "deck_joints_0000010.vtu",
    ];
    assert_eq!(work.files("."), names(&expected));
    let d3plot = FamilyReader::open(&work.path("deck")).expect("a d3plot file");
    assert_eq!(d3plot.times(), [0.0, 1e-4]);
    let history = fs::read(work.path("deck.yh0")).expect("a history");
    assert_eq!(History::parse(&history).expect("a history").points.len(), 1);
}

#[test]
fn the_log_echoes_what_is_read_when_it_is_read() {
    let work = Workplace::new(&[("DCGRAY -9.81", "DCGRAY -9.81 /YD/YDC/DCGRAX 1 /* no effect */")]);
    assert_eq!(work.ypsilon(&["deck.y"]).code, Some(0));
    let log = fs::read_to_string(work.path("Ytmp")).expect("the log");
    let lines: Vec<&str> = log.lines().collect();
    assert_eq!(
        lines[..4],
        ["/YD/YDC/MCSTEP", "/YD/YDC/DCSTEC", "/YD/YDC/DCGRAY", "/YD/YDC/DCGRAX"]
    );
    let run = lines.iter().position(|&line| line == "$YDOIT").expect("the command is echoed");
    assert!(lines[run + 1].contains("warning[scene::no-effect]"), "{}", lines[run + 1]);
    assert_eq!(lines[run + 2], "  Ncycle      Physi. time         Date and Time   Elapsed time");
    assert!(lines[run + 3].starts_with("       0    0.0000000e+00   "), "{}", lines[run + 3]);
    assert_eq!(lines[run + 4..], ["$YSTOP"]);
}

#[test]
fn options_choose_folder_files_and_steps() {
    let work = Workplace::new(&[]);
    let arguments = [
        "run",
        "deck.y",
        "--out",
        "a/b",
        "--formats",
        "yh,json",
        "--steps",
        "5",
        "--states",
        "2,5",
    ];
    let finished = work.ypsilon(&[&arguments[..], &["--threads", "1", "--quiet"]].concat());
    assert_eq!(
        (finished.code, finished.stdout.as_str(), finished.stderr.as_str()),
        (Some(0), "", "")
    );
    let expected = ["Ytmp", "deck.run.json", "deck.state_2.txt", "deck.state_5.txt", "deck.yh0"];
    assert_eq!(work.files("a/b"), names(&expected));
    assert_eq!(work.files("."), names(&["a", "deck.y"]));
    let summary = fs::read_to_string(work.path("a/b/deck.run.json")).expect("the summary");
    assert!(summary.contains("\"steps\": 5"), "{summary}");
}

#[test]
fn the_legacy_d3plot_differs_in_its_header_only() {
    let work = Workplace::new(&[]);
    let run = |folder: &str, more: &[&str]| {
        let arguments = ["run", "deck.y", "--formats", "d3plot", "--out", folder];
        assert_eq!(work.ypsilon(&[&arguments[..], more].concat()).code, Some(0));
        fs::read(work.path(folder).join("deck")).expect("a d3plot file")
    };
    let (today, legacy) = (run("today", &[]), run("legacy", &["--legacy-d3plot"]));
    assert_ne!(today[..256], legacy[..256]);
    assert_eq!(today[256..], legacy[256..]);
}

#[test]
fn a_check_says_what_a_deck_holds_and_writes_nothing() {
    let work = Workplace::new(&[]);
    let finished = work.ypsilon(&["check", "deck.y"]);
    // its joints are soft
    assert_eq!(finished.code, Some(5));
    let holds = "deck.y: 1 stage, 10 nodes, 2 triangles, 1 joint: ready to run\n";
    assert!(finished.stdout.starts_with(holds), "{}", finished.stdout);
    assert_eq!(work.files("."), names(&["deck.y"]));
}

#[test]
fn results_are_converted_by_what_they_hold() {
    let work = Workplace::new(&[]);
    assert_eq!(work.ypsilon(&["deck.y", "--formats", "d3plot,yh"]).code, Some(0));
    let finished = work.ypsilon(&["convert", "deck", "deck.yh0", "--out", "converted"]);
    assert_eq!((finished.code, finished.stderr.as_str()), (Some(0), ""));
    let files = work.files("converted");
    for file in ["deck.pvd", "deck_0.vtu", "deck_1.vtu", "deck.yh0.csv"] {
        assert!(files.contains(file), "{file} is missing among {files:?}");
    }
    let refused = work.ypsilon(&["convert", "deck.y", "--out", "converted"]);
    assert_eq!(refused.code, Some(1));
    assert!(refused.stderr.contains("deck.y"), "{}", refused.stderr);
}

#[test]
fn keywords_are_explained() {
    let work = Workplace::new(&[]);
    let finished = work.ypsilon(&["keywords", "DIEZON"]);
    assert_eq!(finished.code, Some(0));
    assert!(finished.stdout.contains("| DIEZON | real |"), "{}", finished.stdout);
    let classic = work.ypsilon(&["keywords", "--dialect", "classic", "D1PEFT"]);
    assert!(classic.stdout.contains("D1PEFT"), "{}", classic.stdout);
}

#[test]
fn a_deck_with_errors_touches_no_file() {
    let work = Workplace::new(&[("D1PERO 1 2400", "D1PERO 1 -2400")]);
    for arguments in [&["deck.y"][..], &["run", "deck.y", "--out", "results"], &["check", "deck.y"]]
    {
        let finished = work.ypsilon(arguments);
        assert_eq!(finished.code, Some(1), "{arguments:?}");
        assert!(finished.stderr.contains("deck.y:44:19"), "{}", finished.stderr);
        assert!(finished.stderr.contains("no file was written"), "{}", finished.stderr);
        assert_eq!(work.files("."), names(&["deck.y"]), "{arguments:?}");
    }
    let missing = work.ypsilon(&["no-deck.y"]);
    assert_eq!(missing.code, Some(1));
    assert!(missing.stderr.starts_with("error: cannot read no-deck.y"), "{}", missing.stderr);
    assert_eq!(work.files("."), names(&["deck.y"]));
}

#[test]
fn wrong_command_lines_end_with_code_2() {
    let work = Workplace::new(&[]);
    for arguments in [
        &[][..],
        &["run"],
        &["run", "deck.y", "--formats", "netcdf"],
        &["run", "deck.y", "--threads", "0"],
        &["run", "deck.y", "--steps", "-1"],
        &["run", "deck.y", "--dialect", "fortran"],
        &["deck.y", "--unknown"],
    ] {
        let finished = work.ypsilon(arguments);
        assert_eq!(finished.code, Some(2), "{arguments:?}: {}", finished.stderr);
        assert_eq!(work.files("."), names(&["deck.y"]), "{arguments:?}");
    }
}

#[test]
fn a_folder_that_cannot_be_made_ends_with_code_3() {
    let work = Workplace::new(&[]);
    let finished = work.ypsilon(&["run", "deck.y", "--out", "deck.y/results"]);
    assert_eq!(finished.code, Some(3));
    assert!(finished.stderr.contains("cannot write deck.y/results"), "{}", finished.stderr);
}

#[test]
fn a_result_that_cannot_take_its_name_ends_with_code_3() {
    let work = Workplace::new(&[]);
    fs::create_dir(work.path("deck.yh0")).expect("a folder in the place of a result");
    let finished = work.ypsilon(&["deck.y"]);
    assert_eq!(finished.code, Some(3));
    assert!(finished.stderr.contains("deck.yh0"), "{}", finished.stderr);
    // said before hours are spent, not after them
    assert!(finished.stderr.contains("there is a folder of this name"), "{}", finished.stderr);
    assert_eq!(work.files("."), names(&["deck.y", "deck.yh0"]));
}

#[test]
fn unstable_motion_is_an_error_with_advice_and_complete_files() {
    // long enough for the table to show it, and too short for that
    for steps in ["MCSTEP 1000", "MCSTEP 90"] {
        let work = Workplace::new(&[("DCSTEC 1e-5", "DCSTEC 1e-2"), ("MCSTEP 20", steps)]);
        let finished = work.ypsilon(&["deck.y"]);
        assert_eq!(finished.code, Some(4), "{steps}");
        assert!(
            finished.stderr.contains("try a shorter time step (DCSTEC)"),
            "{}",
            finished.stderr
        );
        let d3plot = FamilyReader::open(&work.path("deck")).expect("a d3plot file");
        assert!(d3plot.state_count() > 1, "{steps}");
        assert!(d3plot.notices().is_empty(), "{:?}", d3plot.notices());
        let files = work.files(".");
        assert!(files.contains("deck.pvd"), "{files:?}");
        assert!(!files.iter().any(|name| name.ends_with(".part")), "{files:?}");
    }
}

#[test]
fn a_deck_that_never_runs_says_so() {
    let work = Workplace::new(&[("$YDOIT\n", "")]);
    let finished = work.ypsilon(&["deck.y"]);
    assert_eq!(finished.code, Some(0));
    assert!(finished.stderr.contains("the deck never asks to run"), "{}", finished.stderr);
    assert_eq!(work.files("."), names(&["Ytmp", "deck.y"]));
}

#[test]
fn the_help_shows_all_options_and_exit_codes() {
    let work = Workplace::new(&[]);
    insta::assert_snapshot!("help", work.ypsilon(&["--help"]).stdout);
    assert_eq!(
        work.ypsilon(&["--version"]).stdout,
        format!("ypsilon {}\n", env!("CARGO_PKG_VERSION"))
    );
}

#[test]
fn every_command_shows_examples() {
    let work = Workplace::new(&[]);
    let help = work.ypsilon(&["--help"]).stdout;
    let commands = help.split("Commands:\n").nth(1).expect("commands").lines();
    let commands: Vec<&str> = commands
        .take_while(|line| line.starts_with("  "))
        .filter(|line| !line.starts_with("   "))
        .filter_map(|line| line.split_whitespace().next())
        .filter(|command| *command != "help")
        .collect();
    assert!(commands.len() > 10, "{commands:?}");
    for command in commands {
        let help = work.ypsilon(&[command, "--help"]).stdout;
        let example = help.split("Example").nth(1).unwrap_or_default();
        assert!(example.contains(&format!("ypsilon {command} ")), "{help}");
    }
}

#[test]
fn packages_get_man_pages_and_completions() {
    let workplace = Workplace::new(&[]);
    let done = workplace.ypsilon(&["man", "--out", "pages"]);
    assert_eq!(done.code, Some(0), "{}", done.stderr);
    let pages = workplace.files("pages");
    for page in ["ypsilon.1", "ypsilon-run.1", "ypsilon-mesh.1", "ypsilon-bench.1"] {
        assert!(pages.contains(page), "{pages:?}");
    }
    let run = fs::read_to_string(workplace.path("pages/ypsilon-run.1")).expect("a page");
    assert!(run.contains("\\-\\-threads") && run.contains("Exit codes"), "{run}");
    for (shell, mark) in
        [("bash", "_ypsilon()"), ("zsh", "#compdef ypsilon"), ("fish", "complete -c ypsilon")]
    {
        let done = workplace.ypsilon(&["completions", shell]);
        assert_eq!(done.code, Some(0), "{}", done.stderr);
        assert!(done.stdout.contains(mark), "{shell}");
    }
    // a file is where the folder should be
    assert_eq!(workplace.ypsilon(&["man", "--out", "deck.y"]).code, Some(3));
}
