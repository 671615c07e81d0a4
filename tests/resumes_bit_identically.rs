//! A run that is stopped and gone on with is the same run: states, histories and all other
//! result files, to the last bit.

mod support;

use proptest::prelude::*;
use std::{
    cell::Cell,
    collections::{BTreeMap, BTreeSet},
    fs,
    path::{Path, PathBuf},
};
use support::{
    grid_deck::jointed_wall,
    scenes::step,
    spoilt_deck::{base, edited, write},
};
use tempfile::TempDir;
use yformat::checksum::Checksum;
use ypsilon::{
    scene::Profile,
    session::{
        Checkpoint, CheckpointError, Checkpoints, Format, RunError, RunOptions, RunSummary, Silent,
        load, run_with,
    },
    simulation::{AnySimulation, Simulation, SimulationState, SolverOptions},
};

/// Longest part of a reference run that is looked at.
const LONGEST: u64 = 1500;
/// Steps that a restored simulation goes on beside the one that never stopped.
const BESIDE: u64 = 120;

fn folder(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

/// All decks of a folder of cases.
fn decks(name: &str) -> Vec<PathBuf> {
    let mut decks = Vec::new();
    for entry in fs::read_dir(folder(name)).expect("committed decks").flatten() {
        let path = entry.path();
        if path.extension().is_some_and(|e| e == "y") {
            decks.push(path);
        } else {
            let case = path.file_name().expect("a name").to_string_lossy().into_owned();
            decks.extend(Some(path.join(format!("{case}.y"))).filter(|deck| deck.is_file()));
        }
    }
    decks.sort();
    decks
}

fn simulation(deck: &Path) -> Simulation {
    let loaded = load(deck, None, Profile::default(), SolverOptions::default());
    loaded
        .expect("a sound deck")
        .simulation
        .and_then(AnySimulation::into_plane)
        .expect("a deck that runs")
}

/// All bits of a state: floats are kept as they are.
fn bytes(simulation: &Simulation) -> Vec<u8> {
    postcard::to_stdvec(&simulation.state()).expect("a state can be written")
}

/// What tells that something happened in a step.
fn events(simulation: &Simulation) -> (usize, usize, u64, usize) {
    let detections = simulation.couple_work().map_or(0, |work| work.detections);
    let (failures, couples) = (simulation.failures().len(), simulation.couples().len());
    (failures, couples, detections, simulation.scene().nodes.len())
}

/// Runs a deck, and beside it simulations restored at odd places and after joints broke, couples
/// came and went, detections, and fractures. Returns how many places there were, and the kinds
/// of events among them.
fn compare_restored(deck: &Path) -> (usize, BTreeSet<&'static str>) {
    let mut straight = simulation(deck);
    let first = straight.step_index();
    let end = straight.scene().control.end_step.min(first + LONGEST);
    let mut beside: Vec<(u64, Simulation)> = Vec::new();
    let (mut stops, mut seen) = (0, BTreeSet::new());
    let mut before = events(&straight);
    loop {
        let now = straight.step_index();
        let after = events(&straight);
        // the first few events of each kind
        let kinds = [
            ("failure", after.0 != before.0),
            ("new couple", after.1 > before.1),
            ("dropped couple", after.1 < before.1),
            ("detection", after.2 != before.2),
            ("fracture", after.3 != before.3),
        ];
        let is_event = kinds
            .into_iter()
            .any(|(kind, happened)| happened && (0..2).any(|nth| seen.insert((kind, nth))));
        before = after;
        if is_event || [0, 1, 7, 403].contains(&(now - first)) {
            let saved = bytes(&straight);
            let state: SimulationState = postcard::from_bytes(&saved).expect("the state");
            let mut restored = simulation(deck);
            restored.restore(state).expect("a state of this deck");
            assert!(bytes(&restored) == saved, "{deck:?}: restored at step {now}");
            beside.push((now, restored));
            stops += 1;
        }
        if now >= end {
            break;
        }
        step(&mut straight);
        for (_, restored) in &mut beside {
            step(restored);
        }
        let next = straight.step_index();
        beside.retain(|(from, restored)| {
            let is_over = next - from >= BESIDE || next >= end;
            if is_over {
                let same = bytes(restored) == bytes(&straight);
                assert!(same, "{deck:?}: from step {from}, at step {next}");
            }
            !is_over
        });
    }
    (stops, seen.into_iter().map(|(kind, _)| kind).collect())
}

/// Compares all decks of a folder; at least so many stops per deck, and these kinds of events.
fn compare_all(name: &str, least: usize, kinds: &[&str]) {
    let decks = decks(name);
    let (mut stops, mut seen) = (0, BTreeSet::new());
    for deck in &decks {
        let of_deck = compare_restored(deck);
        stops += of_deck.0;
        seen.extend(of_deck.1);
    }
    assert!(stops > least * decks.len(), "{stops} stops in {} decks", decks.len());
    assert!(kinds.iter().all(|kind| seen.contains(kind)), "{seen:?}");
}

#[test]
fn states_of_the_split_dialect() {
    compare_all("split2d", 3, &["failure", "new couple", "dropped couple", "detection"]);
}

#[test]
fn states_of_the_classic_dialect() {
    compare_all("classic", 4, &["failure", "new couple", "dropped couple", "detection"]);
}

#[test]
fn states_of_the_y_geo_dialect() {
    compare_all("ygeo", 3, &["failure", "new couple", "detection"]);
    compare_all("resume", 3, &["failure", "new couple", "detection"]);
}

/// Softening triangles that are pulled apart.
fn softening() -> String {
    edited(&[
        ("MCSTEP 20", "MCSTEP 260"),
        ("MNOPO 10", "MNOPO 40"),
        ("D1PNAX 2 0 5e3", "D1PNAX 2 0 5e7"),
        ("1 3 0\n", "1 0 0\n"),
        ("D1PSEM 1 0", "D1PSEM 1 1e-5"),
        ("D1PJFS 1 2e6", "D1PJFS 1 0.9"),
        ("/I1PTYP 1 1\n", "/I1PTYP 1 4\n/YD/YDPE/I1PEFR 1 1\n/YD/YDPE/I1PEJP 1 0\n"),
    ])
}

#[test]
fn softening_triangles_go_on_softening() {
    let folder = TempDir::new().expect("a temporary folder");
    let path = write(folder.path(), "deck.y", softening().as_bytes());
    let (stops, kinds) = compare_restored(&path);
    assert!(stops > 3 && kinds.contains("fracture"), "{stops} {kinds:?}");
    compare_files(&softening(), &[9, 42]);
}

/// A run of a deck in a folder of its own.
struct Runner {
    folder: TempDir,
    deck: PathBuf,
    formats: Vec<Format>,
}

impl Runner {
    fn new(deck: &str) -> Self {
        let folder = TempDir::new().expect("a temporary folder");
        let path = write(folder.path(), "deck.y", deck.as_bytes());
        let formats =
            vec![Format::Native, Format::D3plot, Format::Yh, Format::Vtu, Format::Ym, Format::Json];
        Self { folder, deck: path, formats }
    }

    fn out(&self) -> PathBuf {
        self.folder.path().join("out")
    }

    fn run(&self, steps: Option<u64>, checkpoints: Checkpoints) -> Result<RunSummary, RunError> {
        let loaded = load(&self.deck, None, Profile::default(), SolverOptions::default());
        let options = RunOptions {
            formats: self.formats.clone(),
            states: vec![2, 40, 110, 111, 200, 260],
            steps,
            ..RunOptions::new(self.deck.clone(), self.out())
        };
        run_with(loaded.expect("a sound deck"), &options, checkpoints, &mut Silent)
    }

    fn checkpoint(&self) -> PathBuf {
        self.out().join("deck.checkpoint")
    }

    fn resume(&self, steps: Option<u64>) -> Result<RunSummary, RunError> {
        let checkpoint = Checkpoint::read(&self.checkpoint())?;
        let resume = Some(checkpoint);
        self.run(steps, Checkpoints { at_end: true, resume, ..Checkpoints::default() })
    }

    /// Names and bytes of the result files; of the log what is not a date or a duration.
    fn files(&self) -> BTreeMap<String, Vec<u8>> {
        let mut files = BTreeMap::new();
        for entry in fs::read_dir(self.out()).expect("results").flatten() {
            let name = entry.file_name().to_string_lossy().into_owned();
            let mut bytes = fs::read(entry.path()).expect("a result file");
            if name == "Ytmp" {
                let log = String::from_utf8(bytes).expect("text");
                let log = log.replace(&self.folder.path().display().to_string(), "");
                let known = |line: &str| line.get(..25).unwrap_or(line).to_owned() + "\n";
                bytes = log.lines().map(known).collect::<String>().into_bytes();
            }
            if name != "deck.checkpoint" && name != "deck.run.json" {
                files.insert(name, bytes);
            }
        }
        files
    }
}

fn at_end() -> Checkpoints {
    Checkpoints { at_end: true, ..Checkpoints::default() }
}

fn assert_same(straight: &Runner, resumed: &Runner, what: &str) {
    let (straight, resumed) = (straight.files(), resumed.files());
    let names = |files: &BTreeMap<String, Vec<u8>>| files.keys().cloned().collect::<Vec<_>>();
    assert_eq!(names(&straight), names(&resumed), "{what}");
    for (name, bytes) in &straight {
        assert!(bytes == &resumed[name], "{what}: {name} differs");
    }
}

/// Stops a deck's run after each of some numbers of steps and compares all files with those of
/// a run that was not stopped.
fn compare_files(deck: &str, stops: &[u64]) {
    let straight = Runner::new(deck);
    let whole = straight.run(None, at_end()).expect("a run");
    assert!(straight.files().len() > 5, "{:?}", straight.files().keys());
    for &stop in stops {
        let resumed = Runner::new(deck);
        resumed.run(Some(stop), at_end()).expect("the first part");
        let summary = resumed.resume(None).expect("the rest");
        assert_same(&straight, &resumed, &format!("stopped after {stop} steps"));
        let counts = |s: &RunSummary| {
            let work = (s.detections, s.couples_evaluated, s.couples_rested);
            (s.steps, s.time.to_bits(), s.broken_joints, work, s.warnings.len(), s.files.len())
        };
        assert_eq!(counts(&whole), counts(&summary));
        assert_eq!(summary.resumed_at, Some(stop));
    }
    // many stops, and files that went further than the checkpoint
    let resumed = Runner::new(deck);
    let every = Checkpoints { every: Some(29), ..Checkpoints::default() };
    resumed.run(Some(70), every).expect("the first part");
    let checkpoint = Checkpoint::read(&resumed.checkpoint()).expect("a checkpoint");
    assert_eq!(checkpoint.step_index(), 58);
    for _ in 0..4 {
        resumed.resume(Some(37)).expect("a part");
    }
    resumed.resume(None).expect("the rest");
    assert_same(&straight, &resumed, "stopped many times");
}

/// The deck with other numbers of steps and output intervals.
fn shortened(deck: &Path, steps: &str, interval: &str) -> String {
    let deck = fs::read_to_string(deck).expect("a committed deck");
    let set = |deck: String, name: &str, value: &str| -> String {
        let word = format!("/YD/YDC/{name} ");
        let line = |line: &str| match line.starts_with(&word) {
            true => format!("{word}{value}\n"),
            false => format!("{line}\n"),
        };
        deck.lines().map(line).collect()
    };
    set(set(deck, "MCSTEP", steps), "ICOUTF", interval)
}

#[test]
fn files_of_the_split_dialect() {
    let joints = edited(&[("MCSTEP 20", "MCSTEP 260"), ("D1PNAX 2 0 5e3", "D1PNAX 2 0 5e6")]);
    compare_files(&joints, &[0, 1, 110, 259]);
    let slides = folder("split2d/x_tower_slides/x_tower_slides.y");
    compare_files(&shortened(&slides, "260", "13"), &[3, 131]);
}

#[test]
fn files_of_the_classic_dialect() {
    for case in ["j_wall_jointed_mono", "g_joint_mixed", "h_bc_ramp"] {
        let deck = folder("classic").join(case).join(format!("{case}.y"));
        compare_files(&shortened(&deck, "260", "17"), &[0, 119, 204]);
    }
}

#[test]
fn files_of_the_y_geo_dialect() {
    for case in ["j_wall_jointed_mono", "g_joint_mixed"] {
        let deck = shortened(&folder("resume").join(format!("{case}.y")), "260", "17");
        compare_files(&deck, &[0, 119, 204]);
    }
}

#[test]
fn families_of_d3plot_files_go_on() {
    // a mesh of so many triangles and joints that a file holds few states
    let deck = jointed_wall(12, 12, 260).to_text();
    let deck = deck.replace("ICOUTF 1000000", "ICOUTF 1");
    let straight = Runner { formats: vec![Format::D3plot], ..Runner::new(&deck) };
    straight.run(None, at_end()).expect("a run");
    let members = straight.files().keys().filter(|name| name.starts_with("deck0")).count();
    assert!(members > 1, "{:?}", straight.files().keys());
    for stop in [13, 111, 170, 259] {
        let resumed = Runner { formats: vec![Format::D3plot], ..Runner::new(&deck) };
        resumed.run(Some(stop), at_end()).expect("the first part");
        resumed.resume(None).expect("the rest");
        assert_same(&straight, &resumed, &format!("stopped after {stop} steps"));
    }
}

/// Two more stages: other gravity and loads, another scale of the history, and triangles
/// separated halfway.
fn staged() -> String {
    let first = edited(&[
        ("MCSTEP 20", "MCSTEP 107"),
        ("D1PNAX 2 0 5e3", "D1PNAX 2 0 5e6"),
        ("MNOPO 10", "MNOPO 40"),
        ("MELEM 7", "MELEM 40"),
    ]);
    first.replace(
        "$YDOIT\n",
        "$YDOIT\n/YD/YDC/MCSTEP 180 /YD/YDC/DCGRAY -30 /YD/YDPN/D1PNAX 2 0 2e6\n$YDOIT\n\
         /YD/YDC/MCSTEP 260 /YD/YDPE/D1PEKS 1 2e3 /YD/YDO/D1OHYF 1 2\n\
         /YD/YDPM/I2PMSET 21 3 1 1 4 0\n$YDOIT\n",
    )
}

#[test]
fn stages() {
    compare_files(&staged(), &[50, 107, 108, 179, 180, 181, 250]);
}

#[test]
fn stages_of_the_other_dialects() {
    for deck in ["classic/g_joint_mixed/g_joint_mixed.y", "resume/g_joint_mixed.y"] {
        let deck = shortened(&folder(deck), "130", "17");
        let more = "$YDOIT\n/YD/YDC/MCSTEP 260\n/YD/YDC/DCGRAY -50\n$YDOIT";
        compare_files(&deck.replace("$YDOIT", more), &[20, 130, 131, 222]);
    }
}

#[test]
fn excavation_and_support_in_a_later_stage() {
    let deck = shortened(&folder("resume/j_wall_jointed_mono.y"), "130", "17");
    for work in ["I1PEXC 1\n1", "I1PSUP 1\n1"] {
        let more = format!(
            "$YDOIT\n/YD/YDC/MCSTEP 180\n/YD/YDPE/{work}\n$YDOIT\n/YD/YDC/MCSTEP 260\n$YDOIT"
        );
        compare_files(&deck.replace("$YDOIT", &more), &[20, 130, 150, 180, 181]);
    }
}

#[test]
fn a_finished_run_can_be_made_longer() {
    for (deck, last) in [(edited(&[("MCSTEP 20", "MCSTEP 120")]), 120), (staged(), 260)] {
        let (was, now) = (format!("MCSTEP {last}"), format!("MCSTEP {}", last + 90));
        let straight = Runner::new(&deck.replace(&was, &now));
        straight.run(None, at_end()).expect("a run");
        let longer = Runner::new(&deck);
        longer.run(None, at_end()).expect("the short run");
        write(longer.folder.path(), "deck.y", deck.replace(&was, &now).as_bytes());
        let summary = longer.resume(None).expect("the longer run");
        assert_eq!(summary.steps, last + 90);
        let (mut straight, mut longer) = (straight.files(), longer.files());
        // the log tells the MCSTEP of the first run
        let log =
            |files: &mut BTreeMap<String, Vec<u8>>| files.remove("Ytmp").expect("a log").len();
        assert!(log(&mut straight).abs_diff(log(&mut longer)) < 3);
        assert!(straight == longer, "{:?}", straight.keys());
    }
}

#[test]
fn another_deck_is_refused() {
    let runner = Runner::new(&staged());
    runner.run(Some(150), at_end()).expect("a run");
    let said = |deck: String| {
        write(runner.folder.path(), "deck.y", deck.as_bytes());
        runner.resume(None).expect_err("a refusal")
    };
    let is_other = |error| matches!(error, RunError::Checkpoint(CheckpointError::OtherDeck { .. }));
    assert!(is_other(said(staged().replace("DCGRAY -30", "DCGRAY -31"))));
    assert!(is_other(said(format!("{} ", staged()))));
    match said(staged().replace("MCSTEP 107", "MCSTEP 108")) {
        RunError::Checkpoint(CheckpointError::EarlierStage { stage: 1, was: 107, now: 108 }) => {}
        other => panic!("{other}"),
    }
    match said(staged().replace("MCSTEP 180", "MCSTEP 149")) {
        RunError::Checkpoint(CheckpointError::Passed { step: 150, end: 149 }) => {}
        other => panic!("{other}"),
    }
    write(runner.folder.path(), "deck.y", staged().as_bytes());
    runner.resume(None).expect("the deck itself");
}

#[test]
fn an_included_file_that_was_changed_is_noticed() {
    let runner = Runner::new(&base().replace("$YDOIT", "$YINCL gravity.y\n$YDOIT"));
    let include = |text: &str| write(runner.folder.path(), "gravity.y", text.as_bytes());
    include("/YD/YDC/DCGRAY -5\n");
    runner.run(Some(5), at_end()).expect("a run");
    include("/YD/YDC/DCGRAY -6\n");
    let error = runner.resume(None).expect_err("a refusal");
    assert!(matches!(error, RunError::Checkpoint(CheckpointError::OtherDeck { .. })), "{error}");
    include("/YD/YDC/DCGRAY -5\n");
    runner.resume(None).expect("the same deck");
}

#[test]
fn files_that_were_changed_or_lost_are_not_gone_on_with() {
    for (file, change) in [
        ("deck.yh0", Some(b"1 2\n" as &[u8])),
        ("deck.yh0", None),
        ("deck", None),
        ("deck_0000000.vtu", None),
        ("deck.state_2.txt", None),
    ] {
        let runner = Runner::new(&edited(&[("MCSTEP 20", "MCSTEP 200")]));
        runner.run(Some(140), at_end()).expect("a run");
        let path = runner.out().join(file);
        match change {
            Some(bytes) => fs::write(path, bytes).expect("writable"),
            None => fs::remove_file(path).expect("there"),
        }
        let error = runner.resume(None).expect_err("a refusal");
        assert!(matches!(error, RunError::Output(_)), "{file}: {error}");
        assert!(error.to_string().contains(file), "{file}: {error}");
    }
}

#[test]
fn other_formats_are_refused() {
    let mut runner = Runner::new(&base());
    runner.run(Some(5), at_end()).expect("a run");
    runner.formats = vec![Format::D3plot];
    let error = runner.resume(None).expect_err("a refusal").to_string();
    assert!(error.contains("yh, d3plot, vtu, state"), "{error}");
}

/// A small deck with joints and contact.
fn small() -> String {
    edited(&[("MCSTEP 20", "MCSTEP 260"), ("D1PNAX 2 0 5e3", "D1PNAX 2 0 5e6")])
}

/// A run of a deck with a checkpoint, and the checkpoint's bytes.
fn sample(deck: &str) -> (Runner, Vec<u8>) {
    let runner = Runner::new(deck);
    runner.run(Some(115), at_end()).expect("a run");
    let bytes = fs::read(runner.checkpoint()).expect("a checkpoint");
    (runner, bytes)
}

#[test]
fn cut_and_changed_checkpoints_are_refused() {
    let (runner, bytes) = sample(&small());
    let refused = |bytes: &[u8]| {
        fs::write(runner.checkpoint(), bytes).expect("writable");
        Checkpoint::read(&runner.checkpoint()).expect_err("a refusal").to_string()
    };
    for length in (0..bytes.len()).step_by(7).chain([bytes.len() - 1]) {
        refused(&bytes[..length]);
    }
    for place in (0..bytes.len()).step_by(11) {
        let mut changed = bytes.clone();
        changed[place] ^= 1 << (place % 8);
        refused(&changed);
    }
    assert!(refused(&[&bytes, &b"x"[..]].concat()).contains("longer"));
    assert!(refused(b"/YD/YDC/MCSTEP 3").contains("no checkpoint"));
    let mut other = bytes.clone();
    other[19] += 1;
    assert!(refused(&other).contains("was written by Ypsilon"), "another format");
    let mut huge = bytes.clone();
    let length = huge.windows(5).position(|w| w == b"0.1.0").expect("the version") + 5;
    huge[length..length + 8].fill(0xff);
    assert!(refused(&huge).contains("too early"));
}

/// Puts the right checksum under changed bytes.
fn signed(mut bytes: Vec<u8>) -> Vec<u8> {
    let end = bytes.len() - 8;
    let checksum = Checksum::of(&bytes[..end]).to_le_bytes();
    bytes[end..].copy_from_slice(&checksum);
    bytes
}

#[test]
fn forged_checkpoints_panic_not() {
    forge(&small());
    for deck in ["classic/g_joint_mixed/g_joint_mixed.y", "resume/g_joint_mixed.y"] {
        forge(&shortened(&folder(deck), "260", "1"));
    }
}

/// Runs from checkpoints with wrong bytes under the right checksum.
fn forge(deck: &str) {
    let (runner, bytes) = sample(deck);
    let header = bytes.windows(5).position(|w| w == b"0.1.0").expect("the version") + 13;
    let cases = (header..bytes.len() - 8, any::<u8>(), 1usize..9);
    let mut proptest = proptest::test_runner::TestRunner::new(ProptestConfig {
        cases: 100,
        failure_persistence: None,
        ..ProptestConfig::default()
    });
    let (refused, run) = (Cell::new(0), Cell::new(0));
    proptest
        .run(&cases, |(place, value, length)| {
            let mut forged = bytes.clone();
            let end = (place + length).min(bytes.len() - 8);
            forged[place..end].fill(value);
            fs::write(runner.checkpoint(), signed(forged)).expect("writable");
            // whatever it says, it is an error or a run
            match runner.resume(Some(2)) {
                Err(_) => refused.set(refused.get() + 1),
                Ok(_) => run.set(run.get() + 1),
            }
            Ok(())
        })
        .expect("no panic");
    let counts = (refused.get(), run.get());
    assert!(counts.0 > 5 && counts.1 > 5, "{counts:?} refused and run");
}
