//! `ypsilon sweep`: parameter studies as their users see them.
#![cfg(unix)]

mod support;

use std::{
    collections::BTreeMap,
    fs,
    path::Path,
    process::{Command, Output},
    time::SystemTime,
};
use support::{
    block_deck::{DENSITY, LAMBDA, block, lengths},
    child::{command, signal, start, wait_until},
    spoilt_deck::{base, edited, write},
};
use tempfile::TempDir;

/// Two parameters of the base deck, three outputs.
const STUDY: &str = r#"title = "two triangles"
base = "deck.y"

[parameters.stiffness]
target = ["D1PELA[0]", "YDPE/D1PEMU[0]"]
values = [0.5, 1, 2]
factor = true

[parameters.friction]
target = "/YD/YDPE/D1PEFR[0]"
values = [0.25, 0.5]

[outputs.right]
what = "history"
field = "ux"
node = 1

[outputs.kinetic]
what = "energy"
at = "max"

[outputs.steps]
what = "run"
column = "steps"
"#;

fn folder(study: &str) -> TempDir {
    let folder = TempDir::new().expect("a temporary folder");
    write(folder.path(), "deck.y", base().as_bytes());
    write(folder.path(), "study.toml", study.as_bytes());
    folder
}

/// A study of runs that take a while: cases of so many steps.
fn long(steps: &str) -> TempDir {
    let study = "base = 'deck.y'\n[run]\ncheckpoint_every = 400\n\
                 [parameters.density]\ntarget = 'D1PERO[0]'\nvalues = [2000, 2400, 2800]\n\
                 [outputs.right]\nwhat = 'history'\nfield = 'ux'\nnode = 1\n\
                 [outputs.energy]\nwhat = 'yh'\n";
    let folder = folder(study);
    let deck = edited(&[
        ("MCSTEP 20", steps),
        ("DCSTEC 1e-5", "DCSTEC 1e-8"),
        ("ICOUTF 10", "ICOUTF 250"),
    ]);
    write(folder.path(), "deck.y", deck.as_bytes());
    folder
}

fn run(folder: &TempDir, arguments: &[&str]) -> Output {
    command(folder, arguments).output().expect("the program runs")
}

/// Runs the program, which must end with this code; what it printed.
fn ends(folder: &TempDir, arguments: &[&str], code: i32) -> String {
    let output = run(folder, arguments);
    let said = [&output.stdout[..], &output.stderr[..]].concat();
    let said = String::from_utf8_lossy(&said).into_owned();
    assert_eq!(output.status.code(), Some(code), "{arguments:?}: {said}");
    said
}

fn text(folder: &TempDir, name: &str) -> String {
    let read = fs::read_to_string(folder.path().join(name));
    read.unwrap_or_else(|error| panic!("{name}: {error}"))
}

/// Headings and rows of a table.
fn table(folder: &TempDir, name: &str) -> (Vec<String>, Vec<Vec<f64>>) {
    let text = text(folder, name);
    let mut lines = text.lines();
    let headings = lines.next().expect("headings").split(',').map(str::to_owned).collect();
    let numbers =
        |line: &str| line.split(',').map(|cell| cell.parse().expect("a number")).collect();
    (headings, lines.map(numbers).collect())
}

fn column(table: &(Vec<String>, Vec<Vec<f64>>), heading: &str) -> Vec<f64> {
    let index = table.0.iter().position(|h| h == heading);
    let index = index.unwrap_or_else(|| panic!("no {heading} in {:?}", table.0));
    table.1.iter().map(|row| row[index]).collect()
}

/// When the record of each case was written.
fn times(folder: &TempDir) -> BTreeMap<String, SystemTime> {
    let entries = fs::read_dir(folder.path().join("study")).expect("the folder").flatten();
    let time = |path: &Path| fs::metadata(path.join("case.json")).and_then(|m| m.modified()).ok();
    let named =
        entries.map(|entry| (entry.file_name().to_string_lossy().into_owned(), entry.path()));
    named.filter_map(|(name, path)| Some((name, time(&path)?))).collect()
}

#[test]
fn a_grid_runs_every_combination_and_makes_one_table() {
    let folder = folder(STUDY);
    let said = ends(&folder, &["sweep", "study.toml", "--jobs", "2"], 0);
    assert!(said.contains("6 cases; 2 at a time"), "{said}");
    assert!(said.contains("6 of 6 cases done: ") && said.contains("study/results.csv"), "{said}");
    let found = table(&folder, "study/results.csv");
    assert_eq!(
        found.0,
        ["case", "stiffness", "friction", "status", "right (m)", "kinetic (J)", "steps"]
    );
    assert_eq!(column(&found, "case"), [1.0, 2.0, 3.0, 4.0, 5.0, 6.0]);
    assert_eq!(column(&found, "stiffness"), [0.5, 0.5, 1.0, 1.0, 2.0, 2.0]);
    assert_eq!(column(&found, "friction"), [0.25, 0.5, 0.25, 0.5, 0.25, 0.5]);
    assert_eq!(column(&found, "status"), [0.0; 6]);
    assert_eq!(column(&found, "steps"), [20.0; 6]);

    // the deck of a case is the base with other numbers, byte for byte
    let by_hand = edited(&[
        ("D1PELA 1 1e9", "D1PELA 1 2000000000.0"),
        ("D1PEMU 1 2e9", "D1PEMU 1 4000000000.0"),
        ("D1PEFR 1 0.6", "D1PEFR 1 0.25"),
    ]);
    assert_eq!(text(&folder, "study/case-0005/deck.y"), by_hand);

    // and its numbers are those of a run and of `extract`; the joint has taken the triangle away
    // from the deck's node 1, so that the first corner at its place is meant
    write(folder.path(), "hand.y", by_hand.as_bytes());
    ends(&folder, &["run", "hand.y", "--out", "hand", "--quiet"], 0);
    let extract = ["extract", "hand/hand.pvd", "--what", "history", "--fields", "ux"];
    let said = ends(&folder, &[&extract[..], &["--nearest", "1,0"]].concat(), 0);
    let last = said.lines().last().and_then(|line| line.split(',').nth(1)).expect("a number");
    assert_ne!(last, "0");
    assert_eq!(last.parse(), Ok(column(&found, "right (m)")[4]), "{said}");
    let raw = ends(&folder, &[&extract[..], &["--node", "1"]].concat(), 0);
    assert!(raw.lines().skip(1).all(|line| line.ends_with(",0")), "{raw}");
}

#[test]
fn a_list_has_rows_and_whole_numbers_stay_whole() {
    let folder = folder(
        "base = 'deck.y'\n[sampling]\nmethod = 'list'\n\
         [parameters.steps]\ntarget = 'MCSTEP'\nlinspace = { from = 5, to = 12, count = 3 }\n\
         round = true\n\
         [parameters.step]\ntarget = 'DCSTEC'\nlogspace = { from = 1e-6, to = 1e-5, count = 3 }\n\
         [outputs.done]\nwhat = 'run'\ncolumn = 'steps'\n[outputs.end]\nwhat = 'run'\ncolumn = 'time'\n",
    );
    ends(&folder, &["sweep", "study.toml", "--quiet"], 0);
    let found = table(&folder, "study/results.csv");
    assert_eq!(found.0[2], "step (s)");
    assert_eq!(column(&found, "done"), [5.0, 9.0, 12.0]);
    assert_eq!(column(&found, "steps"), [5.0, 9.0, 12.0]);
    assert_eq!(column(&found, "step (s)")[0], 1e-6);
    assert_eq!(column(&found, "step (s)")[2], 1e-5);
    let middle = column(&found, "step (s)")[1];
    assert!((middle / 1e-11f64.sqrt() - 1.0).abs() < 1e-15, "{middle}");
    assert!(text(&folder, "study/case-0002/deck.y").contains("MCSTEP 9\n"));
    let end = column(&found, "end (s)")[1];
    assert!((end / (9.0 * middle) - 1.0).abs() < 1e-12, "{end}");
}

#[test]
fn a_latin_hypercube_meets_each_stratum_once_and_is_the_same_every_time() {
    let study = "base = 'deck.y'\n[sampling]\nmethod = 'latin-hypercube'\nsamples = 9\nseed = 4\n\
                 [parameters.density]\ntarget = 'D1PERO[0]'\nuniform = [1800, 2700]\n\
                 [parameters.mu]\ntarget = 'D1PEMU[0]'\nlog_uniform = [1e8, 1e10]\n\
                 [outputs.right]\nwhat = 'history'\nfield = 'ux'\npoint = [0.9, 0.2]\n";
    let folder = folder(study);
    ends(&folder, &["sweep", "study.toml", "--quiet", "--jobs", "3"], 0);
    let found = table(&folder, "study/results.csv");
    let strata = |heading: &str, share: &dyn Fn(f64) -> f64| {
        let mut strata: Vec<usize> =
            column(&found, heading).iter().map(|&x| (share(x) * 9.0) as usize).collect();
        strata.sort_unstable();
        strata
    };
    let all: Vec<usize> = (0..9).collect();
    assert_eq!(strata("density (kg/m³)", &|x| (x - 1800.0) / 900.0), all);
    assert_eq!(strata("mu (Pa)", &|x| (x.log10() - 8.0) / 2.0), all);
    let bytes = text(&folder, "study/results.csv");
    ends(&folder, &["sweep", "study.toml", "--quiet", "--jobs", "1", "--out", "again"], 0);
    assert_eq!(text(&folder, "again/results.csv"), bytes);
    write(folder.path(), "study.toml", study.replace("seed = 4", "seed = 5").as_bytes());
    ends(&folder, &["sweep", "study.toml", "--quiet", "--out", "other"], 0);
    assert_ne!(text(&folder, "other/results.csv"), bytes);
}

#[test]
fn scenarios_are_varied_by_the_names_of_their_parameters() {
    let folder = folder(
        "base = 'cubes.toml'\n\
         [parameters.young]\ntarget = 'column.stone.young_pa'\nvalues = [1e9, 2e9]\n\
         [parameters.blocks]\ntarget = 'column.blocks'\nvalues = [2, 3]\n\
         [outputs.foot]\nwhat = 'monitors'\ncolumn = 'foot reaction-y'\nat = 'max-abs'\n\
         [outputs.steps]\nwhat = 'run'\ncolumn = 'steps'\n",
    );
    let scenario = "[column]\nblocks = 4\n[run]\nend_s = 2e-3\nmonitor_interval = 1\n[[monitors]]\n\
                    name = 'foot'\nnodes = 'box:,:0.001'\nquantities = ['reaction-y']\n";
    write(folder.path(), "cubes.toml", scenario.as_bytes());
    ends(&folder, &["sweep", "study.toml", "--quiet"], 0);
    let found = table(&folder, "study/results.csv");
    assert_eq!(found.0[..4], ["case", "young (Pa)", "blocks", "status"]);
    assert_eq!(column(&found, "blocks"), [2.0, 3.0, 2.0, 3.0]);
    assert!(column(&found, "foot").iter().all(|force| force.abs() > 0.0));
    assert!(column(&found, "steps").iter().all(|steps| *steps > 1.0));
    let foot = column(&found, "foot");
    assert!(foot[0] != foot[2] && foot[1] != foot[3], "{foot:?}");
    let scenario = text(&folder, "study/case-0004/cubes.toml");
    assert!(scenario.contains("blocks = 3") && scenario.contains("young_pa = 2000000000.0"));
}

#[test]
fn decks_of_tetrahedra_have_all_outputs() {
    const STRETCH: [f64; 3] = [0.99, 1.001, 1.002];
    let outputs = "\
        [outputs.stress]\nwhat = 'history'\nfield = 'szz'\npoint = [0.21, 0.13, 0.08]\n\
        [outputs.corner]\nwhat = 'history'\nfield = 'uz'\nnearest = [0.4, 0.2, 0.21]\nat = 'start'\n\
        [outputs.node]\nwhat = 'history'\nfield = 'vz'\nnode = 3\n\
        [outputs.place]\nwhat = 'extremes'\nfield = 'uz'\ncolumn = 'z of max'\nat = 'start'\n\
        [outputs.push]\nwhat = 'reaction'\nnodes = 'box:0.399:,,'\ndirection = 'x'\nat = 'start'\n\
        [outputs.up]\nwhat = 'mean-displacement'\nnodes = 'line:0,0,0.2,0.4,0,0.2'\n\
        direction = 'z'\nat = 'start'\n\
        [outputs.kinetic]\nwhat = 'energy'\n";
    let study = format!(
        "base = 'deck.y'\n[parameters.shear]\ntarget = 'D1PEMU[0]'\nvalues = [1e8, 3e8]\n{outputs}"
    );
    let folder = folder(&study);
    let stretched = |x: [f64; 3]| std::array::from_fn(|axis| STRETCH[axis] * x[axis]);
    let deck = block(stretched, [0.0, 0.0, 5.0], 3, 1).to_text();
    write(folder.path(), "deck.y", deck.as_bytes());
    ends(&folder, &["sweep", "study.toml", "--quiet"], 0);
    let found = table(&folder, "study/results.csv");
    let near = |found: f64, expected: f64| {
        assert!((found / expected - 1.0).abs() < 1e-9, "{found}, expected {expected}");
    };
    let [length, width, height] = lengths();
    let j: f64 = STRETCH.iter().product();
    for (case, mu) in [1e8, 3e8].into_iter().enumerate() {
        let stress =
            |axis: usize| mu / j * (STRETCH[axis].powi(2) - 1.0) + 0.5 * LAMBDA * (j - 1.0 / j);
        let at = |heading: &str| column(&found, heading)[case];
        near(at("stress (Pa)"), stress(2));
        near(at("push (N)"), stress(0) * STRETCH[1] * width * STRETCH[2] * height);
        near(at("corner (m)"), 0.002 * height);
        near(at("up (m)"), 0.002 * height);
        near(at("place (m)"), 1.002 * height);
        near(at("node (m/s)"), 5.0);
        near(at("kinetic (J)"), 0.5 * DENSITY * length * width * height * 25.0);
    }

    // what is meant for the plane
    for (wrong, message) in [
        (
            "what = 'history'\nfield = 'szz'\npoint = [0.21, 0.13]\n",
            "output `o`: the point 0.21,0.13 has 2 coordinates, but the results are of bodies in \
             space; expected X,Y,Z",
        ),
        (
            "what = 'reaction'\ndirection = 'x'\nnodes = 'box:,:0.01'\n",
            "output `o`: the selection box::,:0.01 does not fit results of bodies in space; \
             expected box:X0:X1,Y0:Y1,Z0:Z1",
        ),
        (
            "what = 'monitors'\ncolumn = 'foot'\n",
            "output `o`: monitors are sums over bodies in the plane: take `reaction`, \
             `mean-displacement` or `energy`",
        ),
    ] {
        let wrong = study.replace(outputs, &format!("[outputs.o]\n{wrong}"));
        write(folder.path(), "study.toml", wrong.as_bytes());
        let said = ends(&folder, &["sweep", "study.toml", "--quiet", "--out", "wrong"], 1);
        assert!(said.contains(message), "{said}");
        assert!(!folder.path().join("wrong").exists(), "nothing is run");
    }
}

#[test]
fn outputs_of_space_are_none_of_the_plane() {
    for (output, message) in [
        (
            "what = 'reaction'\nnodes = 'all'\ndirection = 'z'",
            "output `o`: there is no direction z; expected x or y",
        ),
        (
            "what = 'history'\nnode = 0\nfield = 'uz'",
            "output `o`: bodies in the plane have no field uz; expected u, ux, uy",
        ),
    ] {
        let folder = folder(&format!(
            "base = 'deck.y'\n[parameters.density]\ntarget = 'D1PERO[0]'\nvalues = [2000]\n\
             [outputs.o]\n{output}\n"
        ));
        let said = ends(&folder, &["sweep", "study.toml", "--quiet"], 1);
        assert!(said.contains(message) && said.contains("study.toml:5"), "{said}");
        assert!(!folder.path().join("study").exists(), "nothing is run");
    }
}

#[test]
fn a_case_that_fails_is_a_row_and_stops_no_other() {
    let folder = folder(
        "base = 'deck.y'\n[run]\nflags = ['--on-instability', 'stop']\n\
         [parameters.step]\ntarget = 'DCSTEC'\nvalues = [1e-5, 1.0]\n\
         [parameters.density]\ntarget = 'D1PERO[0]'\nvalues = [2400, -1]\n\
         [outputs.right]\nwhat = 'history'\nfield = 'ux'\nnode = 1\n",
    );
    let said = ends(&folder, &["sweep", "study.toml", "--jobs", "2"], 6);
    let found = table(&folder, "study/results.csv");
    assert_eq!(column(&found, "status"), [0.0, 1.0, 4.0, 1.0]);
    assert!(column(&found, "right (m)")[0].is_finite());
    assert!(column(&found, "right (m)")[1..].iter().all(|x| x.is_nan()));
    assert!(said.contains("1 of 4 cases done, 3 failed"), "{said}");
    assert!(said.contains("case 3 (step 1, density 2400): the run has become unstable"), "{said}");
    assert!(said.contains("case 2 (step 1e-5, density -1): error[scene::"), "{said}");

    // failed cases are over; --retry runs them once more, and no other
    let before = times(&folder);
    let said = ends(&folder, &["sweep", "study.toml"], 6);
    assert!(said.contains("4 cases, 4 are over already"), "{said}");
    assert_eq!(times(&folder), before);
    ends(&folder, &["sweep", "study.toml", "--retry", "--quiet"], 6);
    let after = times(&folder);
    assert_eq!(after["case-0001"], before["case-0001"]);
    assert!(
        ["case-0002", "case-0003", "case-0004"].iter().all(|case| after[*case] > before[*case])
    );
    assert_eq!(table(&folder, "study/results.csv").1.len(), 4);
}

/// A sweep is ended by a signal in the midst of its second case, and gone on with.
fn goes_on_after(name: &str, code: Option<i32>) {
    let steps = "MCSTEP 40000";
    let straight = long(steps);
    ends(&straight, &["sweep", "study.toml", "--quiet", "--jobs", "1"], 0);

    let folder = long(steps);
    let mut child = start(command(&folder, &["sweep", "study.toml", "--jobs", "1"]));
    let checkpoint = folder.path().join("study/case-0002/deck.checkpoint");
    wait_until("no checkpoint of the second case", || checkpoint.exists());
    signal(&child, name);
    assert_eq!(child.wait().expect("it ends").code(), code);
    // the run of the case ends with the sweep that started it: its files are complete then
    let state = || text(&folder, "study/case-0002/deck.pvd");
    wait_until("the case runs on", || folder.path().join("study/case-0002/deck.run.json").exists());
    assert!(state().contains("</VTKFile>"));
    assert!(checkpoint.exists());
    assert!(!folder.path().join("study/case-0003/case.json").exists());
    let first = times(&folder)["case-0001"];

    let said = ends(&folder, &["sweep", "study.toml", "--jobs", "2"], 0);
    assert!(said.contains("3 cases, 1 are over already"), "{said}");
    assert_eq!(times(&folder)["case-0001"], first);
    let summary = text(&folder, "study/case-0002/deck.run.json");
    assert!(!summary.contains("\"resumed_at\": null"), "it began anew: {summary}");
    assert_eq!(text(&folder, "study/results.csv"), text(&straight, "study/results.csv"));
    assert!(!checkpoint.exists(), "checkpoints of cases that are over are taken away");
}

#[test]
fn ctrl_c_leaves_a_sweep_that_goes_on() {
    goes_on_after("-INT", Some(130));
}

#[test]
fn a_sweep_that_is_killed_goes_on() {
    goes_on_after("-KILL", None);
}

#[test]
fn a_checkpoint_of_no_use_makes_a_case_begin_anew() {
    let folder = long("MCSTEP 2000");
    ends(&folder, &["sweep", "study.toml", "--quiet"], 0);
    let before = text(&folder, "study/results.csv");
    let record = text(&folder, "study/case-0002/case.json").replace("\"ended\"", "\"running\"");
    write(folder.path(), "study/case-0002/case.json", record.as_bytes());
    write(folder.path(), "study/case-0002/deck.checkpoint", b"no checkpoint");
    ends(&folder, &["sweep", "study.toml", "--quiet"], 0);
    assert_eq!(text(&folder, "study/results.csv"), before);
    assert!(text(&folder, "study/case-0002/deck.run.json").contains("\"resumed_at\": null"));
}

#[test]
fn a_study_that_has_changed_is_told_and_updated() {
    let folder = folder(STUDY);
    ends(&folder, &["sweep", "study.toml", "--quiet"], 0);
    let (before, old) = (times(&folder), text(&folder, "study/results.csv"));

    // other outputs: nothing is run
    let other = STUDY.replace("at = \"max\"", "at = \"start\"");
    write(folder.path(), "study.toml", other.as_bytes());
    ends(&folder, &["sweep", "collect", "study.toml", "--quiet"], 0);
    let found = table(&folder, "study/results.csv");
    assert_ne!(text(&folder, "study/results.csv"), old);
    assert_eq!(column(&found, "kinetic (J)"), [0.0; 6]);
    write(folder.path(), "study.toml", STUDY.as_bytes());
    let said = ends(&folder, &["sweep", "study.toml"], 0);
    assert!(said.contains("6 are over already"), "{said}");
    assert_eq!(text(&folder, "study/results.csv"), old);

    // other values
    let changed = STUDY.replace("[0.5, 1, 2]", "[0.5, 1, 4]");
    write(folder.path(), "study.toml", changed.as_bytes());
    for arguments in [&["sweep", "study.toml"][..], &["sweep", "collect", "study.toml"]] {
        let said = ends(&folder, arguments, 1);
        assert!(said.contains("study.toml has changed since study was made"), "{said}");
        assert!(
            said.contains("case 5: was stiffness 2, friction 0.25; is stiffness 4, friction 0.25"),
            "{said}"
        );
        assert!(said.contains("--update") && said.contains("--out"), "{said}");
    }
    let said = ends(&folder, &["sweep", "run-case", "study.toml", "5"], 1);
    assert!(said.contains("case 5 was run with other inputs"), "{said}");
    let between = times(&folder);
    ends(&folder, &["sweep", "study.toml", "--update", "--quiet"], 0);
    let after = times(&folder);
    for case in 1..=6 {
        let name = format!("case-000{case}");
        assert_eq!(after[&name] == between[&name], case < 5, "{name}");
        assert!(after[&name] >= before[&name]);
    }
    let found = table(&folder, "study/results.csv");
    assert_eq!(column(&found, "stiffness")[4..], [4.0, 4.0]);

    // cases that are added leave the others what they are
    let longer = changed.replace("[0.5, 1, 4]", "[0.5, 1, 4, 8]");
    write(folder.path(), "study.toml", longer.as_bytes());
    let said = ends(&folder, &["sweep", "study.toml"], 0);
    assert!(said.contains("8 cases, 6 are over already"), "{said}");
    // cases that are gone are told
    write(folder.path(), "study.toml", changed.as_bytes());
    let said = ends(&folder, &["sweep", "study.toml"], 0);
    assert!(
        said.contains("case-0007, case-0008 of an earlier study are not in the table"),
        "{said}"
    );
    assert_eq!(table(&folder, "study/results.csv").1.len(), 6);

    // another base
    write(folder.path(), "deck.y", edited(&[("DCGRAY -9.81", "DCGRAY -9.8")]).as_bytes());
    let said = ends(&folder, &["sweep", "study.toml"], 1);
    assert!(said.contains("the base, its targets or [run] flags"), "{said}");
}

#[test]
fn results_that_are_not_kept_leave_their_numbers() {
    let study =
        STUDY.replace("[parameters.stiffness]", "[run]\nkeep = false\n\n[parameters.stiffness]");
    let slim = folder(&study);
    ends(&slim, &["sweep", "study.toml", "--quiet"], 0);
    let whole = folder(STUDY);
    ends(&whole, &["sweep", "study.toml", "--quiet"], 0);
    assert_eq!(text(&slim, "study/results.csv"), text(&whole, "study/results.csv"));
    let entries = fs::read_dir(slim.path().join("study/case-0001")).expect("the folder").flatten();
    let mut names: Vec<_> = entries.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    assert_eq!(names, ["case.json", "deck.y", "run.log"]);
    write(slim.path(), "study.toml", study.replace("\"ux\"", "\"uy\"").as_bytes());
    let said = ends(&slim, &["sweep", "study.toml"], 6);
    assert!(said.contains("results were not kept"), "{said}");
    // the numbers that were asked for before are still there
    write(slim.path(), "study.toml", study.as_bytes());
    ends(&slim, &["sweep", "study.toml", "--quiet"], 0);
    assert_eq!(text(&slim, "study/results.csv"), text(&whole, "study/results.csv"));
    write(slim.path(), "study.toml", study.replace("\"ux\"", "\"uy\"").as_bytes());
    ends(&slim, &["sweep", "study.toml", "--retry", "--quiet"], 0);
    assert_ne!(text(&slim, "study/results.csv"), text(&whole, "study/results.csv"));
}

#[test]
fn parquet_is_written_or_refused_before_anything_is_run() {
    let folder = folder(STUDY);
    if cfg!(feature = "parquet") {
        ends(&folder, &["sweep", "study.toml", "--parquet"], 0);
        let bytes = fs::read(folder.path().join("study/results.parquet")).expect("the table");
        assert!(bytes.starts_with(b"PAR1") && bytes.ends_with(b"PAR1"));
    } else {
        let said = ends(&folder, &["sweep", "study.toml", "--parquet"], 2);
        assert!(said.contains("--features parquet"), "{said}");
        assert!(!folder.path().join("study").exists());
    }
}

#[test]
fn a_dry_run_lists_the_cases_and_writes_nothing() {
    let folder = folder(STUDY);
    let said = ends(&folder, &["sweep", "study.toml", "--dry-run"], 0);
    assert!(said.contains("two triangles\n"), "{said}");
    assert!(said.contains("     4  not run   stiffness 1, friction 0.5\n"), "{said}");
    assert!(!folder.path().join("study").exists());
    ends(&folder, &["sweep", "run-case", "study.toml", "4", "--quiet"], 0);
    let said = ends(&folder, &["sweep", "study.toml", "--dry-run"], 0);
    assert!(said.contains("     4  done      stiffness 1, friction 0.5\n"), "{said}");
    let said = ends(&folder, &["sweep", "collect", "study.toml"], 6);
    assert!(said.contains("1 of 6 cases done, 5 still to be run"), "{said}");
    assert_eq!(table(&folder, "study/results.csv").1.len(), 1);
}

/// The lines of a job list do what GNU Parallel would do with them: any shell, any order.
#[test]
fn exported_jobs_make_the_same_table() {
    let local = folder(STUDY);
    ends(&local, &["sweep", "study.toml", "--quiet"], 0);
    let expected = text(&local, "study/results.csv");
    let program = Path::new(env!("CARGO_BIN_EXE_ypsilon")).parent().expect("its folder");
    let path = format!("{}:{}", program.display(), std::env::var("PATH").unwrap_or_default());
    let shell = |folder: &TempDir, script: &str| {
        let mut bash = Command::new("bash");
        let bash = bash.args(["-c", script]).current_dir(folder.path().join("study"));
        let output = bash.env("PATH", &path).output().expect("a shell");
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    };

    let parallel = folder(STUDY);
    let said = ends(&parallel, &["sweep", "export", "study.toml", "--to", "parallel"], 0);
    assert!(said.contains("study/parallel.sh"), "{said}");
    assert_eq!(text(&parallel, "study/jobs.txt").lines().count(), 6);
    assert_eq!(
        text(&parallel, "study/jobs.txt").lines().nth(1),
        Some("ypsilon sweep run-case ../study.toml 2 --out .")
    );
    shell(
        &parallel,
        "bash -n parallel.sh && tac jobs.txt | while read -r job; do eval \"$job\" || exit; done",
    );
    ends(&parallel, &["sweep", "collect", "study.toml", "--quiet"], 0);
    assert_eq!(text(&parallel, "study/results.csv"), expected);

    let slurm = folder(STUDY);
    ends(&slurm, &["sweep", "export", "study.toml", "--to", "slurm"], 0);
    assert!(text(&slurm, "study/slurm.sh").contains("#SBATCH --array=1-6\n"));
    shell(
        &slurm,
        "bash -n slurm.sh && for i in 1 2 3 4 5 6; do SLURM_ARRAY_TASK_ID=$i bash slurm.sh || exit; done",
    );
    ends(&slurm, &["sweep", "collect", "study.toml", "--quiet"], 0);
    assert_eq!(text(&slurm, "study/results.csv"), expected);
}

#[test]
fn arrays_of_slurm_have_at_most_a_thousand_jobs() {
    let values = (0..1001).map(|k| format!("0.{k:04}")).collect::<Vec<_>>().join(", ");
    let study = format!(
        "base = 'deck.y'\n[parameters.friction]\ntarget = 'D1PEFR[0]'\nvalues = [{values}]\n"
    );
    let folder = folder(&study);
    ends(&folder, &["sweep", "export", "study.toml", "--to", "slurm"], 0);
    assert!(text(&folder, "study/slurm.sh").contains("#SBATCH --array=1-501\n"));
    // two cases a job, the last has one
    let script = "ypsilon() { echo \"$@\"; }; exec() { \"$@\"; }; . ./slurm.sh";
    let mut bash = Command::new("bash");
    bash.args(["-c", script]).current_dir(folder.path().join("study"));
    let output = bash.env("SLURM_ARRAY_TASK_ID", "501").output().expect("a shell");
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(said.contains("run-case ../study.toml 1001-1001 --out ."), "{said}");
}

#[test]
fn included_files_are_copied_into_every_case() {
    let folder = folder(
        "base = 'main.y'\n[parameters.mu]\ntarget = 'D1PEMU[0]'\nvalues = [1e9, 3e9]\n\
         [outputs.right]\nwhat = 'history'\nfield = 'ux'\nnode = 1\n",
    );
    let deck = base();
    let (front, back) = deck.split_once("/YD/YDPJ/MPJSET").expect("the deck");
    fs::create_dir(folder.path().join("lib")).expect("a folder");
    let (front, properties) = front.split_once("/YD/YDPE/MPROP").expect("the deck");
    write(folder.path(), "lib/stone", format!("/YD/YDPE/MPROP{properties}").as_bytes());
    let main = format!("{front}$YINCL lib/stone\n/YD/YDPJ/MPJSET{back}");
    write(folder.path(), "main.y", main.as_bytes());
    ends(&folder, &["sweep", "study.toml", "--quiet"], 0);
    assert_eq!(text(&folder, "study/case-0002/main.y"), main);
    let expected =
        format!("/YD/YDPE/MPROP{properties}").replace("D1PEMU 1 2e9", "D1PEMU 1 3000000000.0");
    assert_eq!(text(&folder, "study/case-0002/lib/stone"), expected);
    let right = column(&table(&folder, "study/results.csv"), "right (m)");
    assert_ne!(right[0], right[1]);
}

/// Edits of the study and what is said about each: one finding, with its line.
#[test]
fn bad_studies_are_refused_with_the_line() {
    let cases: &[(&str, &str, &str)] = &[
        ("no base", "base = \"deck.y\"\n", ""),
        ("no such base", "deck.y", "other.y"),
        ("not TOML", "values = [0.25, 0.5]", "values = [0.25, 0.5"),
        ("a key that does not exist", "field = \"ux\"", "fields = \"ux\""),
        ("a keyword that does not exist", "D1PELA[0]", "D1PELB[0]"),
        ("no index", "D1PELA[0]", "D1PELA"),
        ("an index beyond the array", "D1PELA[0]", "D1PELA[1]"),
        ("a keyword that is not given", "D1PELA[0]", "DCTIME"),
        ("no values", "values = [0.25, 0.5]", ""),
        ("values of two kinds", "values = [0.25, 0.5]", "values = [0.25]\nuniform = [0, 1]"),
        ("an empty list", "values = [0.25, 0.5]", "values = []"),
        ("a word for a number", "values = [0.25, 0.5]", "values = ['low', 'high']"),
        ("a range in a grid", "values = [0.25, 0.5]", "uniform = [0.25, 0.5]"),
        ("an empty range", "values = [0.25, 0.5]", "uniform = [0.5, 0.25]"),
        (
            "a logarithm of nothing",
            "values = [0.25, 0.5]",
            "logspace = { from = 0, to = 1, count = 3 }",
        ),
        (
            "one value from end to end",
            "values = [0.25, 0.5]",
            "linspace = { from = 0, to = 1, count = 1 }",
        ),
        ("rows of a list", "title = \"two triangles\"", "sampling = { method = 'list' }"),
        ("no samples", "title = \"two triangles\"", "sampling = { method = 'latin-hypercube' }"),
        ("no such method", "title = \"two triangles\"", "sampling = { method = 'random' }"),
        ("half a step", "/YD/YDPE/D1PEFR[0]", "MCSTEP"),
        ("no such output", "what = \"energy\"", "what = \"work\""),
        ("no such field", "field = \"ux\"", "field = \"ur\""),
        ("a field of bodies in space", "field = \"ux\"", "field = \"uz\""),
        ("no place", "node = 1\n", ""),
        ("two columns of one name", "[outputs.steps]", "[outputs.friction]"),
        (
            "a flag that does not exist",
            "title = \"two triangles\"",
            "run = { flags = ['--setle'] }",
        ),
        ("a flag of the sweep", "title = \"two triangles\"", "run = { flags = ['--out', 'x'] }"),
        ("no such table", "title = \"two triangles\"", "table = ['xlsx']"),
    ];
    let mut all = String::new();
    for (what, old, new) in cases {
        assert_eq!(STUDY.matches(old).count(), 1, "`{old}` must stand in the study once");
        let folder = folder(&STUDY.replacen(old, new, 1));
        let output = run(&folder, &["sweep", "study.toml"]);
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert_eq!(output.status.code(), Some(1), "{what}: {said}");
        assert!(!folder.path().join("study").exists(), "{what}");
        let findings = said.lines().filter(|line| line.starts_with("error")).count();
        assert_eq!(findings, 1, "{what}: {said}");
        assert!(said.contains("study.toml:"), "{what} has no place: {said}");
        all.push_str(&format!("# {what}\n{said}\n"));
    }
    insta::assert_snapshot!(all);
}

#[test]
fn a_base_with_errors_and_wrong_numbers_of_cases_are_told() {
    let folder = folder(STUDY);
    let said = ends(&folder, &["sweep", "run-case", "study.toml", "5-7"], 2);
    assert!(said.contains("there is no case 7: cases are numbered from 1 to 6"), "{said}");
    ends(&folder, &["sweep", "run-case", "study.toml", "0"], 2);
    ends(&folder, &["sweep", "run-case", "study.toml", "x"], 2);
    ends(&folder, &["sweep", "nothing.toml"], 1);
    write(folder.path(), "deck.y", base().replace("/YD/YDC/DCSTEC", "/YD/YDC/DCSTEK").as_bytes());
    let said = ends(&folder, &["sweep", "study.toml"], 1);
    assert!(said.contains("DCSTEK") && said.contains("deck.y:3"), "{said}");
}

#[test]
fn folders_of_others_stay_as_they_are() {
    let folder = folder(STUDY);
    fs::create_dir_all(folder.path().join("study/case-0002")).expect("a folder");
    write(folder.path(), "study/case-0002/thesis.tex", b"years of work");
    let said = ends(&folder, &["sweep", "study.toml", "--jobs", "1"], 3);
    assert!(said.contains("was not made by a sweep"), "{said}");
    assert_eq!(text(&folder, "study/case-0002/thesis.tex"), "years of work");
}
