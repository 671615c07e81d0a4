//! Runs in three dimensions: the same bits on any number of threads and after a stop, files for
//! ParaView, later stages.

mod support;

use insta::assert_snapshot;
use std::{
    collections::BTreeMap,
    fmt::Write,
    fs,
    path::{Path, PathBuf},
};
use support::{
    block_deck::SIX_TETRAHEDRA,
    spoilt_deck::{base_of, edit, write},
};
use tempfile::TempDir;
use ypsilon::{
    meshing::{
        Scenario,
        spatial::kinds::{BrickBond, Wall3d},
    },
    scene::{PressedFaces, Profile, SpatialContact},
    session::{Checkpoint, Checkpoints, Format, RunOptions, RunSummary, Silent, load, run_with},
    simulation::{AnySimulation, SolverOptions, SpatialSimulation, SpatialState},
    team::Team,
};

fn case(name: &str) -> PathBuf {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    root.join("tests/data/split3d").join(name).join(format!("{name}.y"))
}

fn simulation(deck: &Path) -> SpatialSimulation {
    on_threads(deck, 1)
}

fn on_threads(deck: &Path, threads: usize) -> SpatialSimulation {
    let team = Team::new(threads).expect("threads");
    let options = SolverOptions { team, ..SolverOptions::default() };
    let loaded = load(deck, None, Profile::default(), options);
    let simulation = loaded.expect("a sound deck").simulation.expect("a deck that runs");
    simulation.into_spatial().expect("a deck in space")
}

fn step(simulation: &mut SpatialSimulation) {
    simulation.evaluate_forces();
    simulation.advance();
}

/// All bits of a state.
fn bytes(simulation: &SpatialSimulation) -> Vec<u8> {
    postcard::to_stdvec(&simulation.state()).expect("a state can be written")
}

/// A block of n³ cubes, each of six tetrahedra with joints between all of them, that falls.
fn jointed_block(n: usize) -> String {
    let side = n + 1;
    let at = |x: usize, y: usize, z: usize| x + side * (y + side * z);
    let (mut places, mut corners) = (String::new(), String::new());
    for z in 0..side {
        for y in 0..side {
            for x in 0..side {
                let _ =
                    writeln!(places, "{} {} {}", x as f64 * 0.1, y as f64 * 0.1, z as f64 * 0.1);
            }
        }
    }
    for z in 0..n {
        for y in 0..n {
            for x in 0..n {
                let c = |i: usize| at(x + (i & 1), y + (i >> 1 & 1), z + (i >> 2));
                for [a, b, d, e] in SIX_TETRAHEDRA {
                    let _ = writeln!(corners, "{} {} {} {}", c(a), c(b), c(d), c(e));
                }
            }
        }
    }
    let (nodes, elements) = (side.pow(3), 6 * n.pow(3));
    let [ones, zeros, sets] = ["1 ".repeat(nodes), "0 ".repeat(elements), "0 ".repeat(nodes)];
    format!(
        "/YD/YDC/MCSTEP 100 /YD/YDC/DCSTEC 1e-6 /YD/YDC/DCGRAZ -9.81 /YD/YDC/DCGRAX 2
/YD/YDN/MNODIM 3 /YD/YDN/NNODIM 3 /YD/YDN/MNOPO {} /YD/YDN/NNOPO {nodes}
/YD/YDN/D2NCI 21 3 {nodes} {places} /YD/YDN/D2NCC 21 3 {nodes} {places}
/YD/YDN/I1NOBF {nodes} {ones} /YD/YDN/I1NOPR {nodes} {sets}
/YD/YDE/MELEM {} /YD/YDE/NELEM {elements} /YD/YDE/MELST 1 /YD/YDE/MELNO 6
/YD/YDE/I1ELPR {elements} {zeros} /YD/YDE/I2ELTO 21 4 {elements} {corners}
/YD/YDI/MICOUP 100000 /YD/YDI/DIEZON 0.01 /YD/YDI/DIEDI 200
/YD/YDPE/MPROP 1 /YD/YDPE/NPROP 1 /YD/YDPE/I1PTYP 1 21
/YD/YDPE/D1PELA 1 1e9 /YD/YDPE/D1PEMU 1 1e9 /YD/YDPE/D1PERO 1 2400 /YD/YDPE/D1PEPE 1 1e10
/YD/YDPJ/MPJSET 1 /YD/YDPJ/NPJSET 1 /YD/YDPJ/I1PTYP 1 23
/YD/YDPJ/D1PJFS 1 2e6 /YD/YDPJ/D1PJFT 1 1e6 /YD/YDPJ/D1PJGF 1 100 /YD/YDPJ/D1PJPE 1 1e11
/YD/YDPM/MPMCOM 1 /YD/YDPM/MPMCOL 3 /YD/YDPM/I2PMSET 21 3 1 1 3 0
/YD/YDPM/MPMROW 1 /YD/YDPM/I2PMIJ 21 3 1 0 0 0
/YD/YDPN/MPNSET 1 /YD/YDPN/NPNSET 1
/YD/YDPN/I1PNFX 1 1 /YD/YDPN/I1PNFY 1 1 /YD/YDPN/I1PNFZ 1 1
/YD/YDPN/D1PNAX 1 0 /YD/YDPN/D1PNAY 1 0 /YD/YDPN/D1PNAZ 1 0
$YDOIT
",
        5 * nodes + 4 * elements,
        5 * elements
    )
}

/// The block is above the threshold from which threads are used.
#[test]
fn a_jointed_block_moves_alike_on_1_2_3_and_8_threads() {
    let folder = TempDir::new().expect("a temporary folder");
    let deck = write(folder.path(), "block.y", jointed_block(8).as_bytes());
    let run = |threads| {
        let mut simulation = on_threads(&deck, threads);
        assert!(simulation.tetrahedra().count() > 2048);
        (0..12).for_each(|_| step(&mut simulation));
        bytes(&simulation)
    };
    let alone = run(1);
    for threads in [2, 3, 8] {
        assert!(run(threads) == alone, "{threads} threads give other bits");
    }
}

/// Restored at odd places, and around the steps in which joints fail.
#[test]
fn a_restored_simulation_goes_on_with_the_same_bits() {
    for (name, steps) in [("t3d_joint_tension", 2990), ("t3d_impact", 1200), ("t3d_friction", 600)]
    {
        let deck = case(name);
        let mut straight = simulation(&deck);
        let mut failures = 0;
        for now in 0..steps {
            let broke = simulation_broke(&straight, &mut failures);
            if [0, 1, 7, 403, 1100].contains(&now) || broke {
                let saved = bytes(&straight);
                let state: SpatialState = postcard::from_bytes(&saved).expect("the state");
                let mut restored = simulation(&deck);
                restored.restore(state).expect("a state of this deck");
                assert!(bytes(&restored) == saved, "{name}: restored at step {now}");
                let mut beside = straight.clone();
                for _ in 0..40 {
                    step(&mut beside);
                    step(&mut restored);
                }
                assert!(bytes(&restored) == bytes(&beside), "{name}: from step {now}");
            }
            step(&mut straight);
        }
    }
}

fn simulation_broke(simulation: &SpatialSimulation, failures: &mut usize) -> bool {
    let now = simulation.failures().len();
    std::mem::replace(failures, now) != now
}

#[test]
fn a_state_of_another_scene_is_refused() {
    let state = simulation(&case("t3d_impact")).state();
    let folder = TempDir::new().expect("a temporary folder");
    let other = write(folder.path(), "base.y", base_of("3d").as_bytes());
    assert!(simulation(&other).restore(state).is_err());
}

fn options(deck: &Path, folder: &Path, steps: Option<u64>) -> RunOptions {
    RunOptions {
        formats: vec![Format::D3plot, Format::Yh, Format::Vtu],
        states: vec![30, 90],
        steps,
        ..RunOptions::new(deck, folder)
    }
}

fn run_deck(
    deck: &Path,
    folder: &Path,
    steps: Option<u64>,
    checkpoints: Checkpoints,
) -> RunSummary {
    let loaded = load(deck, None, Profile::default(), SolverOptions::default());
    let options = options(deck, folder, steps);
    run_with(loaded.expect("a sound deck"), &options, checkpoints, &mut Silent).expect("a run")
}

/// Result files by name; logs hold dates, checkpoints the time that runs took.
fn files(folder: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut files = BTreeMap::new();
    for entry in fs::read_dir(folder).expect("results").flatten() {
        let name = entry.file_name().to_string_lossy().into_owned();
        if name != "Ytmp" && !name.ends_with(".checkpoint") {
            files.insert(name, fs::read(entry.path()).expect("a file"));
        }
    }
    files
}

/// The deck of the tests that write files: 120 steps in two stages.
fn two_stages() -> String {
    edit(
        base_of("3d"),
        &[
            ("MCSTEP 20", "MCSTEP 60"),
            ("$YDOIT\n", "$YDOIT\n/YD/YDC/MCSTEP 120 /YD/YDC/DCGRAX 4 $YDOIT\n"),
        ],
    )
}

#[test]
fn a_run_that_stops_and_goes_on_writes_the_same_files() {
    let folder = TempDir::new().expect("a temporary folder");
    let deck = write(folder.path(), "two.y", two_stages().as_bytes());
    let [whole, parts] = ["whole", "parts"].map(|name| folder.path().join(name));
    run_deck(&deck, &whole, None, Checkpoints::default());
    let at_end = || Checkpoints { at_end: true, ..Checkpoints::default() };
    run_deck(&deck, &parts, Some(35), at_end());
    for steps in [50, 35] {
        let checkpoint = Checkpoint::read(&parts.join("two.checkpoint")).expect("a checkpoint");
        let going_on = Checkpoints { resume: Some(checkpoint), ..at_end() };
        run_deck(&deck, &parts, Some(steps), going_on);
    }
    let (whole, parts) = (files(&whole), files(&parts));
    assert_eq!(whole.keys().collect::<Vec<_>>(), parts.keys().collect::<Vec<_>>());
    for (name, contents) in &whole {
        assert!(parts[name] == *contents, "{name} differs");
    }
}

/// Gravity along x begins with the second stage; time and steps go on.
#[test]
fn a_later_stage_changes_what_it_names() {
    let folder = TempDir::new().expect("a temporary folder");
    let deck = write(folder.path(), "two.y", two_stages().as_bytes());
    let summary = run_deck(&deck, folder.path(), None, Checkpoints::default());
    assert_eq!((summary.steps, summary.tetrahedra, summary.triangles), (120, 3, 0));
    assert!((summary.time - 120e-5).abs() < 1e-12);
    let speed = |step: u64| {
        let text = fs::read_to_string(folder.path().join(format!("two.state_{step}.txt")));
        let text = text.expect("a state");
        let last = text.lines().take_while(|l| !l.starts_with("# element")).last();
        let words: Vec<f64> = last
            .expect("a node")
            .split_whitespace()
            .map(|w| w.parse().expect("a number"))
            .collect();
        words[4]
    };
    // the last tetrahedron flies freely
    assert!(speed(30).abs() < 1e-12);
    assert!((speed(90) - 4.0 * 30e-5).abs() < 1e-6, "{}", speed(90));
}

/// What a ParaView user gets: the XML without its numbers.
#[test]
fn vtu_files_hold_tetrahedra_and_wedges() {
    let folder = TempDir::new().expect("a temporary folder");
    let deck = write(folder.path(), "base.y", base_of("3d").as_bytes());
    run_deck(&deck, folder.path(), None, Checkpoints::default());
    let mut names: Vec<String> = files(folder.path()).into_keys().collect();
    names.sort();
    let mut said = names.join("\n");
    for name in names.iter().filter(|n| n.ends_with("10.vtu") || n.ends_with(".pvd")) {
        let text = fs::read(folder.path().join(name)).expect("a file");
        let text = String::from_utf8_lossy(&text);
        let head = text.split("<AppendedData").next().unwrap_or_default();
        let _ = write!(said, "\n== {name}\n{head}");
    }
    assert_snapshot!(said);
}

/// Runs a wall on 1, 2, 3 and 8 threads; `see` looks at the end of each run.
fn wall_moves_alike(
    wall: Wall3d,
    profile: Profile,
    pressed: PressedFaces,
    steps: u64,
    see: impl Fn(&SpatialSimulation),
) {
    let scenario = Scenario { wall_3d: Some(wall), ..Scenario::default() };
    let deck = scenario.generate_in_space().expect("a wall").deck.to_text();
    let folder = TempDir::new().expect("a temporary folder");
    let deck = write(folder.path(), "wall.y", deck.as_bytes());
    let spatial_contact = SpatialContact { pressed, has_friction: true };
    let run = |threads| {
        let team = Team::new(threads).expect("threads");
        let options = SolverOptions { spatial_contact, team, ..SolverOptions::default() };
        let loaded = load(&deck, None, profile, options).expect("a sound deck");
        let simulation = loaded.simulation.and_then(AnySimulation::into_spatial);
        let mut simulation = simulation.expect("a deck in space");
        assert!(simulation.tetrahedra().count() > 2048);
        (0..steps).for_each(|_| step(&mut simulation));
        see(&simulation);
        bytes(&simulation)
    };
    let alone = run(1);
    for threads in [2, 3, 8] {
        assert!(run(threads) == alone, "{threads} threads give other bits");
    }
}

/// A dry wall in English bond with friction: couples, springs and all.
#[test]
fn a_dry_wall_moves_alike_on_1_2_3_and_8_threads() {
    let wall =
        Wall3d { bricks: 10, courses: 12, settle_s: 0.002, push_s: 0.01, ..Wall3d::default() };
    wall_moves_alike(wall, Profile::default(), PressedFaces::Both, 120, |_| {});
}

/// A mortared wall that cracks, and touches where it has cracked.
#[test]
fn a_wall_that_cracks_moves_alike_on_1_2_3_and_8_threads() {
    let wall = Wall3d {
        bricks: 10,
        courses: 10,
        bond: BrickBond::Running,
        cells: [2, 1, 1],
        bonded: true,
        contact_at_cracks: true,
        push_m_s: [0.0, 30.0, 0.0],
        settle_s: 1e-5,
        push_s: 1e-3,
        ..Wall3d::default()
    };
    wall_moves_alike(wall, Profile::Source, PressedFaces::Contactor, 300, |simulation| {
        assert!(simulation.failures().len() > 20, "{} joints", simulation.failures().len());
        let work = simulation.couple_work().expect("contact");
        assert!(work.evaluated > 1000, "{} contacts", work.evaluated);
    });
}
