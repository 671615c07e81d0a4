//! Decks with more than one `$YDOIT`: time and steps go on, what a stage names changes, and
//! everything else stays as the run has left it.

mod support;

use assert_cmd::Command;
use std::fs;
use support::{
    spoilt_deck::{base, base_of, edited, write},
    state_file::StateFile,
};
use tempfile::TempDir;
use yformat::{d3plot::FamilyReader, diagnostic::Diagnostic, source::SourceMap};
use ypsilon::{
    scene::Profile,
    session::{Format, Observer, RunError, RunOptions, RunSummary, load, run},
    simulation::SolverOptions,
};

/// A free elastic triangle so soft that its nodes fly on their own.
const FLIGHT: &str = "\
/YD/YDC/MCSTEP 4 /YD/YDC/DCSTEC 0.01 /YD/YDC/DCGRAY 0
/YD/YDN/MNODIM 2 /YD/YDN/NNODIM 2 /YD/YDN/MNOPO 3 /YD/YDN/NNOPO 3
/YD/YDN/D2NCI 21 2 3   0 0  1 0  0 1
/YD/YDN/D2NCC 21 2 3   0 0  1 0  0 1
/YD/YDN/D2NVC 21 2 3   3 4  3 4  3 4
/YD/YDN/I1NOPR 3   0 0 0
/YD/YDE/MELEM 1 /YD/YDE/NELEM 1 /YD/YDE/MELNO 3
/YD/YDE/I1ELPR 1   0
/YD/YDE/I2ELTO 21 3 1   0 1 2
/YD/YDPE/MPROP 1 /YD/YDPE/NPROP 1 /YD/YDPE/I1PTYP 1 1
/YD/YDPE/D1PELA 1 1e-9 /YD/YDPE/D1PEMU 1 1e-9 /YD/YDPE/D1PERO 1 1000
/YD/YDPN/MPNSET 1 /YD/YDPN/NPNSET 1 /YD/YDPN/I1PNFX 1 1 /YD/YDPN/I1PNFY 1 1
/YD/YDPN/D1PNAX 1 0 /YD/YDPN/D1PNAY 1 0
$YDOIT
";

/// Remembers what was said during a run.
#[derive(Default)]
struct Said(Vec<String>);

impl Observer for Said {
    fn findings(&mut self, findings: &[Diagnostic], _sources: &SourceMap) {
        self.0.extend(findings.iter().map(|finding| finding.code.to_owned()));
    }
}

/// A finished run of a deck, with states after some steps.
struct Run {
    folder: TempDir,
    outcome: Result<RunSummary, RunError>,
    said: Vec<String>,
}

impl Run {
    fn of(deck: &str, states: &[u64]) -> Self {
        let folder = TempDir::new().expect("a temporary folder");
        let path = write(folder.path(), "deck.y", deck.as_bytes());
        let loaded = load(&path, None, Profile::default(), SolverOptions::default());
        let options = RunOptions {
            formats: vec![Format::D3plot, Format::Yh],
            states: states.to_vec(),
            legacy_d3plot: true,
            ..RunOptions::new(path, folder.path())
        };
        let mut said = Said::default();
        let outcome = run(loaded.expect("a sound first stage"), &options, &mut said);
        Self { folder, outcome, said: said.0 }
    }

    fn state(&self, step: u64) -> StateFile {
        StateFile::read(&self.folder.path().join(format!("deck.state_{step}.txt")))
            .expect("a state")
    }

    fn file(&self, name: &str) -> Vec<u8> {
        fs::read(self.folder.path().join(name)).expect("a result file")
    }
}

fn velocities(state: &StateFile) -> Vec<[f64; 2]> {
    state.nodes.iter().map(|row| [row[2], row[3]]).collect()
}

fn positions(state: &StateFile) -> Vec<[f64; 2]> {
    state.nodes.iter().map(|row| [row[0], row[1]]).collect()
}

fn close(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    a.len() == b.len()
        && a.iter().flatten().zip(b.iter().flatten()).all(|(a, b)| (a - b).abs() < 1e-9)
}

#[test]
fn steps_go_on_and_changed_gravity_acts() {
    let second = "/YD/YDC/MCSTEP 10 /YD/YDC/DCGRAY -10\n$YDOIT\n";
    let run = Run::of(&format!("{FLIGHT}{second}"), &[4, 10]);
    let summary = run.outcome.as_ref().expect("a run");
    assert_eq!(summary.steps, 10);
    assert!((summary.time - 0.1).abs() < 1e-12);
    assert!(close(&velocities(&run.state(4)), &[[3.0, 4.0]; 3]));
    // six steps of free fall: 4 m/s less 6 x 0.01 s x 10 m/s2
    assert!(close(&velocities(&run.state(10)), &[[3.0, 3.4]; 3]));
}

#[test]
fn a_stage_that_raises_no_step_count_does_nothing_and_says_so() {
    let run = Run::of(&format!("{FLIGHT}$YDOIT\n"), &[4]);
    assert_eq!(run.outcome.as_ref().expect("a run").steps, 4);
    assert_eq!(run.said.last().map(String::as_str), Some("scene::step-count"));
}

#[test]
fn restated_velocities_replace_all_old_ones() {
    let second = "/YD/YDC/MCSTEP 5 /YD/YDN/D2NVC 21 2 1   7 0\n$YDOIT\n";
    let run = Run::of(&format!("{FLIGHT}{second}"), &[5]);
    assert!(run.outcome.is_ok());
    // entries that are not given are filled with the default, 0
    assert!(close(&velocities(&run.state(5)), &[[7.0, 0.0], [0.0, 0.0], [0.0, 0.0]]));
}

#[test]
fn nodes_without_restated_set_never_move_again() {
    let second = "/YD/YDC/MCSTEP 5 /YD/YDN/I1NOPR 1   0\n$YDOIT\n";
    let run = Run::of(&format!("{FLIGHT}{second}"), &[4, 5]);
    assert!(run.outcome.is_ok());
    assert!(run.said.contains(&"scene::node-set".to_owned()), "{:?}", run.said);
    let (before, after) = (positions(&run.state(4)), positions(&run.state(5)));
    assert!(close(&[after[0]], &[[before[0][0] + 0.03, before[0][1] + 0.04]]));
    assert_eq!(before[1..], after[1..]);
}

#[test]
fn restated_positions_move_nodes_at_once() {
    let second = "/YD/YDC/MCSTEP 5 /YD/YDN/D2NCC 21 2 3   10 0  11 0  10 1\n$YDOIT\n";
    let run = Run::of(&format!("{FLIGHT}{second}"), &[5]);
    assert!(run.outcome.is_ok());
    assert!(close(&positions(&run.state(5)), &[[10.03, 0.04], [11.03, 0.04], [10.03, 1.04]]));
}

#[test]
fn one_stage_equals_two_to_the_last_bit() {
    // joints, contact, a load-time table and output are all under way when the stage ends
    let whole = edited(&[("MCSTEP 20", "MCSTEP 230"), ("D1PNAX 2 0 5e3", "D1PNAX 2 0 5e6")]);
    let staged = whole
        .replace("MCSTEP 230", "MCSTEP 107")
        .replace("$YDOIT\n", "$YDOIT\n/YD/YDC/MCSTEP 230\n$YDOIT\n");
    let steps = [107, 108, 230];
    let (whole, staged) = (Run::of(&whole, &steps), Run::of(&staged, &steps));
    assert!(whole.outcome.is_ok() && staged.outcome.is_ok());
    for step in steps {
        assert!(whole.state(step) == staged.state(step), "the states after {step} steps differ");
    }
    assert_eq!(whole.file("deck.yh0"), staged.file("deck.yh0"));
    assert!(whole.file("deck") == staged.file("deck"), "the d3plot files differ");
}

#[test]
fn a_contact_run_in_stages_is_the_same_run() {
    let path =
        concat!(env!("CARGO_MANIFEST_DIR"), "/tests/data/split2d/x_tower_slides/x_tower_slides.y");
    let deck = fs::read_to_string(path).expect("the reference deck");
    let count = deck.lines().find_map(|line| line.strip_prefix("/YD/YDC/MCSTEP ")).expect("steps");
    let total: u64 = count.trim().parse().expect("a number of steps");
    let whole = deck.replace(&format!("MCSTEP {count}"), "MCSTEP 400");
    assert!(total >= 400, "the deck is long enough");
    let staged = whole
        .replace("MCSTEP 400", "MCSTEP 151")
        .replace("$YDOIT", "$YDOIT\n/YD/YDC/MCSTEP 400\n$YDOIT");
    let (whole, staged) = (Run::of(&whole, &[400]), Run::of(&staged, &[400]));
    assert!(whole.outcome.is_ok() && staged.outcome.is_ok());
    assert!(whole.state(400) == staged.state(400));
}

#[test]
fn mistakes_of_later_stages_spare_the_results_of_earlier_ones() {
    for (second, place) in [
        ("/YD/YDN/NNOPO 4\n", "deck.y:94:15"),
        ("/YD/YDE/NELEM 2\n", "deck.y:94:15"),
        ("/YD/YDE/I1ELPR 7 0 0 1 -1000 -1000 5 -1000\n", "deck.y:94:36"),
        ("/YD/YDPE/D1PERO 1 -1\n", "deck.y:94:19"),
        ("/YD/YDC/DCSTEC 0\n", "deck.y:94:16"),
        ("/YD/YDO/NOHYS 0\n", "deck.y:94:15"),
    ] {
        let folder = TempDir::new().expect("a temporary folder");
        let deck =
            base().replace("$YDOIT\n", &format!("$YDOIT\n{second}/YD/YDC/MCSTEP 40\n$YDOIT\n"));
        write(folder.path(), "deck.y", deck.as_bytes());
        let mut ypsilon = Command::new(env!("CARGO_BIN_EXE_ypsilon"));
        let output = ypsilon.current_dir(&folder).arg("deck.y").output().expect("the program runs");
        let said = String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(1), "{second}{said}");
        assert!(said.contains(place), "{second}{said}");
        assert!(said.contains("results of the earlier stages are complete"), "{second}{said}");
        let d3plot = FamilyReader::open(&folder.path().join("deck")).expect("a d3plot file");
        assert_eq!(d3plot.state_count(), 2, "{second}");
        for file in fs::read_dir(&folder).expect("the folder").flatten() {
            assert!(!file.file_name().to_string_lossy().ends_with(".part"), "{second}{file:?}");
        }
    }
}

#[test]
fn a_stage_of_a_classic_deck_changes_what_it_names() {
    let first =
        base_of("classic_glued").replace("$YSTOP\n", "").replace("I1PEMN 4 3", "I1PEMN 4 0");
    let push = "/YD/YDC/MCSTEP 21 /YD/YDP/D1PNAX 4 0 0 0 7e3\n";
    let fix = "/YD/YDC/MCSTEP 21 /YD/YDP/I1PNFX 4 0 0 3 3 /YD/YDP/D1PNAX 4 0 0 0 0.25\n";
    let ramp = "/YD/YDC/MCSTEP 21 /YD/YDP/I1PNFX 4 0 0 3 3 /YD/YDP/D1PNAX 4 0 0 0 0.25
/YD/YDC/DCGRST 1 /YD/YDC/DCRMPT 1\n";
    let speeds = |stage: &str| {
        let run = Run::of(&format!("{first}{stage}$YDOIT\n"), &[20, 21]);
        assert_eq!(run.outcome.as_ref().expect("a run").steps, 21, "{:?}", run.said);
        [run.state(20), run.state(21)].map(|state| velocities(&state)[1][0])
    };
    let [before, pushed] = speeds(push);
    // mass of the node: a third of its triangles
    let mass = 2500.0 * 0.5 / 3.0;
    let [_, further] = speeds("/YD/YDC/MCSTEP 21\n");
    assert!(((pushed - further) * mass / 1e-6 - 2e3).abs() < 1e-3);
    assert_eq!(speeds(fix), [before, 0.25]);
    assert_eq!(speeds(ramp), [before, 0.0]);
}

#[test]
fn mesh_codes_of_a_classic_deck_act_once() {
    let first = base_of("classic_glued").replace("$YSTOP\n", "");
    let again = "/YD/YDC/MCSTEP 30 /YD/YDP/D1PEKS 4 1e3 0 0 0\n$YDOIT\n";
    let run = Run::of(&format!("{first}{again}"), &[]);
    let summary = run.outcome.as_ref().expect("a run");
    assert_eq!((summary.steps, summary.nodes, summary.triangles), (30, 10, 2));
}
