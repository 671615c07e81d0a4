//! Settling (`--settle`) ends in the equilibrium that waiting ends in.

mod support;

use std::fs;
use support::{
    grid_deck::jointed_wall,
    scenes::{bits, on_threads, scene},
    settling::{difference, prepared, ratio, scene_of, settle, settled, stresses, waited},
};
use tempfile::TempDir;
use yformat::dialect::Dialect;
use ypsilon::{
    scene::{Condition, ElementKind, PairRule, Profile, Scene},
    session::{
        Checkpoint, Checkpoints, Format, RunError, RunOptions, RunSummary, Silent, load, run_with,
    },
    simulation::{
        SettlingFault, SettlingOptions, SettlingOutcome, Simulation, SolverOptions, Unsettleable,
    },
};
use ypsilon_converters::dialects::convert_deck;

/// Four dry blocks on a held one.
const COLUMN: &str = "[column]\nblocks = 5\nwidth_m = 0.5\nheight_m = 0.25\ncells = [2, 1]\n";

/// A bridge of few large blocks in mortar, with soil and contact.
const BRIDGE: &str = "\
[bridge]
span_m = 6.0
height_m = 3.6
arch_diameter_m = 3.4
ring_thickness_m = 0.5
block_length_m = 1.0
courses = 4
soil_width_m = 1.0
[run]
end_s = 1.0
";

const GRAVITY: f64 = 9.81;

/// The mean stress of a block in equilibrium follows from statics alone: ∫ σyy dA is the moment of
/// its weight and of the force on its foot about the vertical position, whatever is inside.
#[test]
fn a_column_carries_its_weight_as_waiting_finds_it() {
    let scene = scene_of(COLUMN, 1.0);
    let (settled, report) = settled(&scene);
    assert!(report.ratio <= 1e-4, "{report:?}");
    let density = scene.materials[0].density;
    let top = 5.0 * 0.25;
    for block in 1..5 {
        let middle = (block as f64 + 0.5) * 0.25;
        let (mut sum, mut area) = (0.0, 0.0);
        for (stress, a, at) in stresses(&settled) {
            if (at[1] - middle).abs() < 0.125 {
                sum += stress[2] * a;
                area += a;
            }
        }
        let (found, expected) = (sum / area, -density * GRAVITY * (top - middle));
        let error = (found / expected - 1.0).abs();
        assert!(error < 1e-3, "block {block}: {found} Pa, not {expected} Pa");
    }
    let (waited, steps) = waited(&scene, 0);
    let difference = difference(&waited, &settled);
    println!("column: {} iterations, {steps} steps, {difference:.2e}", report.iterations);
    assert!(difference < 0.005, "{difference}");
    assert!(report.iterations < steps / 2, "{} against {steps}", report.iterations);
}

/// Softened mortar and contact without friction depend on no path: waiting ends in the same state
/// although its stresses overshoot.
#[test]
fn a_bridge_without_friction_settles_to_what_sudden_gravity_comes_to() {
    let mut scene = scene_of(BRIDGE, 1.0);
    scene.materials.iter_mut().for_each(|m| m.friction = 0.0);
    let (settled, report) = settled(&scene);
    let (waited, steps) = waited(&scene, 0);
    let difference = difference(&waited, &settled);
    println!("no friction: {} iterations, {steps} steps, {difference:.2e}", report.iterations);
    assert!(difference < 0.005, "{difference}");
    assert!(report.iterations < steps / 5, "{} against {steps}", report.iterations);
}

/// With friction the state depends on the path. Settling follows that of gravity that comes
/// slowly.
#[test]
fn a_bridge_settles_to_what_slow_gravity_comes_to() {
    let scene = scene_of(BRIDGE, 1.0);
    assert!(matches!(scene.contact.as_ref().map(|c| &c.pairs), Some(PairRule::SmallerOfEach)));
    let (settled, report) = settled(&scene);
    let (waited, steps) = waited(&scene, 20_000);
    let difference = difference(&waited, &settled);
    println!("bridge: {} iterations, {steps} steps, {difference:.2e}", report.iterations);
    assert!(difference < 0.005, "{difference}");
    assert_eq!(settled.failures().len(), waited.failures().len());
    assert!(report.iterations < steps / 5, "{} against {steps}", report.iterations);
}

/// A dry column is pushed at its top: friction alone carries the push down.
#[test]
fn friction_carries_the_push_on_a_dry_column() {
    let mut scene = scene_of(COLUMN, 1.0);
    let top: Vec<usize> =
        (0..scene.nodes.len()).filter(|&n| scene.nodes.initial[n].y > 1.25 - 1e-9).collect();
    let free = scene.nodes.set[top[0]] as usize;
    let mut pushed = scene.node_sets[free].clone();
    assert_eq!(pushed.conditions, [Condition::Force; 2]);
    // a twentieth of the weight of a block in all: the column neither slides nor tips
    let push = 0.05 * scene.materials[0].density * 0.5 * 0.25 * GRAVITY;
    pushed.amplitudes = [push / top.len() as f64, 0.0];
    top.iter().for_each(|&n| scene.nodes.set[n] = scene.node_sets.len() as i32);
    scene.node_sets.push(pushed);
    scene.load_history = None;
    let (settled, report) = settled(&scene);
    for block in 1..4 {
        let middle = (block as f64 + 0.5) * 0.25;
        let shear = stresses(&settled)
            .iter()
            .filter(|(_, _, at)| (at[1] - middle).abs() < 0.125)
            .fold(0.0, |sum, (stress, a, _)| sum + stress[1] * a);
        // ∫ σxy dA = push × height
        let error = (shear / (push * 0.25) - 1.0).abs();
        assert!(error < 0.005, "block {block}: {shear} N m, {report:?}");
    }
    let slid = settled.scene().nodes.current[top[0]].x - settled.scene().nodes.initial[top[0]].x;
    assert!(slid.abs() < 1e-3, "the top has moved by {slid} m");
}

/// What is asked of the forces is true of the forces: a test of its own, from masses and forces.
#[test]
fn residual_forces_fall_with_the_tolerance() {
    let scene = scene_of(BRIDGE, 1.0);
    let mut start = prepared(&scene);
    start.evaluate_forces();
    assert!(ratio(&start) > 0.5, "at rest, but not in balance: {}", ratio(&start));
    for tolerance in [1e-2, 1e-5] {
        let mut simulation = prepared(&scene);
        let options = SettlingOptions { tolerance, ..SettlingOptions::default() };
        let report = settle(&mut simulation, options).expect("a scene that settles");
        assert!(simulation.scene().nodes.velocity.iter().all(|v| v.x == 0.0 && v.y == 0.0));
        assert_eq!(simulation.sum_kinetic_energy(), 0.0);
        simulation.evaluate_forces();
        let found = ratio(&simulation);
        assert!(found <= 1.000_001 * tolerance, "{found} after {report:?}");
        assert!((found / report.ratio - 1.0).abs() < 1e-6, "{found} against {report:?}");
    }
}

/// With enough viscosity everything creeps, so that velocities say nothing about balance.
/// Settling does not know viscosity: it ends in the same bits.
#[test]
fn creeping_is_not_taken_for_rest() {
    let (settled, _) = settled(&scene_of(COLUMN, 1.0));
    let mut thick = prepared(&scene_of(COLUMN, 1000.0));
    let viscosity = thick.scene().materials[0].viscosity;
    settle(&mut thick, SettlingOptions::default()).expect("a scene that settles");
    assert_eq!(thick.scene().materials[0].viscosity, viscosity);
    thick.evaluate_forces();
    assert!(bits(&thick) == bits(&settled));
}

/// After settling nothing happens any more.
#[test]
fn a_settled_bridge_stays_as_it_is() {
    let scene = scene_of(BRIDGE, 1.0);
    let (mut simulation, _) = settled(&scene);
    assert_eq!((simulation.step_index(), simulation.time()), (0, 0.0));
    let before = simulation.clone();
    let masses = {
        let mut fresh = prepared(&scene);
        fresh.evaluate_forces();
        fresh.masses().to_vec()
    };
    assert_eq!(simulation.masses(), masses);
    for _ in 0..2000 {
        simulation.advance();
        simulation.evaluate_forces();
    }
    let difference = difference(&before, &simulation);
    assert!(difference < 0.001, "{difference}");
}

#[test]
fn all_dialects_settle() {
    let deck = jointed_wall(6, 6, 1000);
    for dialect in [Dialect::Split, Dialect::YGeo, Dialect::Classic] {
        let deck = match dialect {
            Dialect::Split => deck.clone(),
            _ => convert_deck(&deck, dialect).expect("a sound deck").deck,
        };
        let mut scene = scene(&deck);
        // the push of the full wall would break this one
        scene.node_sets.iter_mut().for_each(|set| set.amplitudes[0] *= 0.02);
        let (simulation, report) = settled(&scene);
        let found = ratio(&simulation);
        assert!(found <= 1.000_001e-4, "{dialect}: {found}, {report:?}");
        // the wall leans away from the push and is lower than it was
        let (now, before) = (&simulation.scene().nodes.current, &simulation.scene().nodes.initial);
        let last = before.iter().enumerate().max_by(|a, b| a.1.y.total_cmp(&b.1.y));
        let (top, _) = last.expect("a node");
        assert!(now[top].x > before[top].x && now[top].y < before[top].y, "{dialect}");
        assert!(simulation.failures().is_empty(), "{dialect}");
    }
}

/// The wall is above every threshold from which threads are used.
#[test]
fn any_number_of_threads_settles_to_the_same_bits() {
    let scene = scene(&jointed_wall(96, 96, 1000));
    let options = SettlingOptions { tolerance: 1e-4, most_iterations: 25 };
    let run = |threads| {
        let mut simulation = on_threads(&scene, threads);
        simulation.prepare().expect("the deck leaves room for its joints");
        let fault = settle(&mut simulation, options).expect_err("too few iterations");
        assert!(matches!(fault, SettlingFault::NotSettled { .. }), "{fault}");
        (bits(&simulation), fault.to_string())
    };
    let alone = run(1);
    for threads in [2, 3] {
        assert!(run(threads) == alone, "{threads} threads give other bits");
    }
}

fn refusal(change: impl FnOnce(&mut Scene)) -> SettlingFault {
    let mut scene = scene_of(COLUMN, 1.0);
    change(&mut scene);
    let options = SettlingOptions { most_iterations: 1000, ..SettlingOptions::default() };
    settle(&mut prepared(&scene), options).expect_err("nothing to settle")
}

#[test]
fn scenes_without_rest_are_refused() {
    let condition = |scene: &mut Scene, condition| {
        scene.node_sets.iter_mut().for_each(|s| s.conditions = [condition; 2]);
    };
    let refused = |why: Unsettleable, change: &dyn Fn(&mut Scene)| {
        assert_eq!(refusal(change), SettlingFault::Refused(why));
    };
    refused(Unsettleable::RigidTriangles, &|s| {
        s.materials.iter_mut().for_each(|m| m.kind = ElementKind::RigidTriangle);
    });
    refused(Unsettleable::BreakingTriangles, &|s| {
        for m in &mut s.materials {
            (m.kind, m.fractures, m.damage_row) = (ElementKind::SofteningTriangle, true, 0);
        }
        s.elements.state.push(vec![0.0; s.elements.len()]);
    });
    refused(Unsettleable::Excavation, &|s| {
        s.materials.iter_mut().for_each(|m| m.is_excavated = true);
    });
    refused(Unsettleable::AbsorbingBoundaries, &|s| condition(s, Condition::Absorbing));
    refused(Unsettleable::NoFreeNode, &|s| condition(s, Condition::Velocity));
    refused(Unsettleable::NothingHeld, &|s| condition(s, Condition::Force));
    refused(Unsettleable::NoLoad, &|s| s.control.gravity = [0.0; 3]);
    refused(Unsettleable::Moving { node: 20 }, &|s| s.nodes.velocity[20].x = 1.0);
    let mut simulation = prepared(&scene_of(COLUMN, 1.0));
    let options = SettlingOptions { tolerance: f64::NAN, ..SettlingOptions::default() };
    let fault = settle(&mut simulation, options).expect_err("no tolerance");
    assert!(matches!(fault, SettlingFault::Tolerance(_)), "{fault}");
}

/// A block that nothing holds up falls: it is not said to be at rest.
#[test]
fn what_falls_does_not_settle() {
    let fault = refusal(|scene| scene.contact = None);
    let SettlingFault::NotSettled { iterations, .. } = fault else { panic!("{fault}") };
    assert_eq!(iterations, 1000);
}

#[test]
fn settling_can_be_stopped() {
    let mut simulation = prepared(&scene_of(COLUMN, 1.0));
    let mut seen = 0;
    let outcome = simulation.settle(SettlingOptions::default(), &mut |progress| {
        seen = progress.iterations;
        seen < 10
    });
    assert_eq!(outcome, Ok(SettlingOutcome::Stopped));
    assert_eq!(seen, 10);
}

/// A run with its results in a folder.
struct Folder(TempDir);

impl Folder {
    fn new() -> Self {
        let folder = TempDir::new().expect("a temporary folder");
        let generated = ypsilon::meshing::Scenario::parse(COLUMN)
            .and_then(|s| s.generate())
            .expect("a sound scenario");
        fs::write(folder.path().join("deck.y"), generated.deck.to_text()).expect("a deck");
        Self(folder)
    }

    fn run(&self, steps: u64, checkpoints: Checkpoints) -> Result<RunSummary, RunError> {
        let deck = self.0.path().join("deck.y");
        let loaded = load(&deck, None, Profile::default(), SolverOptions::default());
        let settling = checkpoints.resume.is_none().then(SettlingOptions::default);
        let options = RunOptions { settling, ..self.options(steps) };
        run_with(loaded.expect("a sound deck"), &options, checkpoints, &mut Silent)
    }

    fn options(&self, steps: u64) -> RunOptions {
        RunOptions {
            formats: vec![Format::Json],
            states: vec![0, 40],
            steps: Some(steps),
            ..RunOptions::new(self.0.path().join("deck.y"), self.0.path())
        }
    }

    fn checkpoint(&self) -> Checkpoint {
        Checkpoint::read(&self.0.path().join("deck.checkpoint")).expect("a checkpoint")
    }
}

#[test]
fn runs_go_on_from_checkpoints_after_settling() {
    let at_end = || Checkpoints { at_end: true, ..Checkpoints::default() };
    let (straight, stopped) = (Folder::new(), Folder::new());
    let whole = straight.run(60, at_end()).expect("a run");
    stopped.run(25, at_end()).expect("the first part");
    let resume = || Checkpoints { resume: Some(stopped.checkpoint()), ..at_end() };
    let rest = stopped.run(35, resume()).expect("the rest");
    let summary = whole.settling.expect("a settled run");
    assert!(summary.settled.ratio <= summary.tolerance && summary.seconds > 0.0);
    let again = rest.settling.expect("the run was settled before its checkpoint");
    assert_eq!(again.settled, summary.settled);
    assert_eq!((whole.steps, rest.steps), (60, 60));
    let state =
        |folder: &Folder| fs::read(folder.0.path().join("deck.state_40.txt")).expect("a state");
    assert!(state(&straight) == state(&stopped), "states after 40 steps differ");
    // what has run cannot be settled any more
    let loaded =
        load(&stopped.0.path().join("deck.y"), None, Profile::default(), SolverOptions::default());
    let options = RunOptions { settling: Some(SettlingOptions::default()), ..stopped.options(10) };
    let refused = run_with(loaded.expect("a sound deck"), &options, resume(), &mut Silent);
    let resumed = SettlingFault::Refused(Unsettleable::Resumed);
    assert!(matches!(refused, Err(RunError::Settling(fault)) if fault == resumed));
}

/// The first output shows the settled state.
#[test]
fn the_first_output_is_at_rest() {
    let folder = Folder::new();
    folder.run(1, Checkpoints::default()).expect("a run");
    let summary = fs::read_to_string(folder.0.path().join("deck.run.json")).expect("a summary");
    let summary: serde_json::Value = serde_json::from_str(&summary).expect("JSON");
    let settling = &summary["settling"];
    assert!(settling["settled"]["iterations"].as_u64().is_some_and(|n| n > 10), "{settling}");
    assert!(
        settling["settled"]["ratio"].as_f64().is_some_and(|r| r > 0.0 && r <= 1e-4),
        "{settling}"
    );
    let mut expected: Simulation = prepared(&scene_of(COLUMN, 1.0));
    settle(&mut expected, SettlingOptions::default()).expect("a scene that settles");
    let energy = summary["kinetic_energy"].as_f64().expect("a number");
    expected.evaluate_forces();
    expected.advance();
    let own = expected.sum_kinetic_energy();
    assert!((energy - own).abs() <= 1e-12 * own, "{energy} J, not {own} J");
}
