//! `ypsilon bench`: what it prints and writes.

use assert_cmd::Command;
use serde_json::Value;
use std::{fs, path::Path, process::Output};
use tempfile::TempDir;

fn ypsilon(folder: &Path, arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
    command.current_dir(folder).args(arguments).output().expect("the program starts")
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("a number, not {value}"))
}

#[test]
fn figures_of_a_scene_are_sane() {
    let folder = TempDir::new().expect("a folder");
    let arguments = "bench --scene jointed --steps 20 --repeat 2 --threads 1,2 --json figures.json \
                     --markdown tables.md";
    let output = ypsilon(folder.path(), &arguments.split_whitespace().collect::<Vec<_>>());
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{said}");
    let text = fs::read_to_string(folder.path().join("figures.json")).expect("the figures");
    let report: Value = serde_json::from_str(&text).expect("JSON");
    let scene = &report["scenes"][0];
    assert_eq!(scene["name"], "jointed");
    assert_eq!([&scene["triangles"], &scene["joints"], &scene["steps"]], [5000, 7400, 20]);
    assert_eq!(scene["runs"].as_array().map(Vec::len), Some(2));
    for (run, threads) in scene["runs"].as_array().into_iter().flatten().zip([1, 2]) {
        assert_eq!(run["threads"], threads);
        for speed in [&run["process"], &run["step_loop"]] {
            let [least, middle, most] = ["min", "median", "max"].map(|k| number(&speed[k]));
            assert!(0.0 < least && least <= middle && middle <= most, "{speed}");
        }
        // reading the deck takes time, too
        assert!(number(&run["process"]["max"]) < number(&run["step_loop"]["max"]), "{run}");
        let phases = &run["phases"];
        let names = ["triangles", "joints", "detection", "overlap", "integration"];
        let times = names.map(|name| number(&phases[name]));
        assert!(times.iter().all(|&t| t > 0.0), "{phases}");
        assert!(times.iter().sum::<f64>() <= number(&run["phases_of_seconds"]), "{run}");
        assert!(number(&run["couples_per_step"]) + number(&run["rested_per_step"]) > 5000.0);
        assert_eq!(run["detections"], 1);
        if cfg!(target_os = "linux") {
            let per_triangle = number(&run["memory_per_triangle"]);
            assert!((200.0..100_000.0).contains(&per_triangle), "{per_triangle}");
        }
    }
    assert_eq!(number(&scene["runs"][0]["speed_up"]), 1.0);
    let tables = fs::read_to_string(folder.path().join("tables.md")).expect("the tables");
    assert!(tables.contains("| 5000 | 7400 | 20 | 1 |"), "{tables}");
    // no work files are left beside them
    let names = fs::read_dir(folder.path()).expect("the folder").flatten();
    let mut names: Vec<_> = names.map(|entry| entry.file_name()).collect();
    names.sort();
    assert_eq!(names, ["figures.json", "tables.md"]);
}

#[test]
fn scenes_without_contact_spend_nothing_on_it() {
    let folder = TempDir::new().expect("a folder");
    let arguments =
        ["bench", "--scene", "elastic", "--steps", "20", "--repeat", "1", "--threads", "1"];
    let output = ypsilon(folder.path(), &[&arguments[..], &["--json", "x.json"]].concat());
    assert_eq!(output.status.code(), Some(0));
    let text = fs::read_to_string(folder.path().join("x.json")).expect("the figures");
    let report: Value = serde_json::from_str(&text).expect("JSON");
    let run = &report["scenes"][0]["runs"][0];
    assert_eq!([number(&run["couples_per_step"]), number(&run["detections"])], [0.0; 2]);
    let [contact, triangles] = ["overlap", "triangles"].map(|name| number(&run["phases"][name]));
    assert!(contact < 0.1 * triangles, "{run}");
}

#[test]
fn mistakes_are_told() {
    let folder = TempDir::new().expect("a folder");
    let told = |arguments: &[&str], code: i32, words: &[&str]| {
        let output = ypsilon(folder.path(), arguments);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
        assert!(words.iter().all(|word| said.contains(word)), "{said}");
    };
    told(&["bench", "--scene", "castle"], 2, &["castle", "elastic", "debris"]);
    told(&["bench", "--threads", "0"], 2, &["--threads"]);
    told(&["bench", "--work-precision", "--problem", "tower"], 2, &["tower", "bar-wave"]);
    told(&["bench", "--deck", "missing.y"], 1, &["missing.y"]);
    fs::write(folder.path().join("notes.md"), "mine\n").expect("a file");
    let run = ["bench", "--scene", "elastic", "--steps", "1", "--repeat", "1", "--threads", "1"];
    told(&[&run[..], &["--markdown", "notes.md"]].concat(), 1, &["notes.md", "begin"]);
}

#[test]
fn work_precision_writes_tables_and_curves() {
    let folder = TempDir::new().expect("a folder");
    let arguments =
        ["bench", "--work-precision", "--problem", "patch", "--repeat", "1", "--out", "wp"];
    let output = ypsilon(folder.path(), &arguments);
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    let wp = folder.path().join("wp");
    let csv = fs::read_to_string(wp.join("patch_time-step.csv")).expect("the table");
    assert!(csv.starts_with("time step by the stable one,run time (s),error,"), "{csv}");
    let rows: Vec<Vec<f64>> = csv
        .lines()
        .skip(1)
        .map(|row| row.split(',').map(|cell| cell.parse().expect("a number")).collect())
        .collect();
    assert_eq!(rows.iter().filter(|row| row[3] == 1.0).count(), 1, "one default");
    for file in [
        "patch.png",
        "patch.svg",
        "time-step.png",
        "time-step-cost.svg",
        "all.csv",
        "recommended.csv",
    ] {
        assert!(fs::metadata(wp.join(file)).is_ok_and(|meta| meta.len() > 200), "{file}");
    }
}
