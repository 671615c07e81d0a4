//! What the published source does with faces between tetrahedra that are free or have come apart
//! (spec `y2d3d.md` D.4, D.7, profile S): their nodes become boundary nodes, and contact begins.
//!
//! Two blocks, one on the other, with a weak joint between them, no node flagged. The upper one is
//! lifted until the joint fails and then pressed down again.

mod support;

use std::{collections::BTreeSet, fs, path::Path};
use support::spoilt_deck::{edit, write};
use tempfile::TempDir;
use ypsilon::{
    scene::{Profile, Scene},
    session::load,
    simulation::{SolverOptions, SpatialSimulation, SpatialState},
};

const BLOCKS: &str = "tests/data/split3d/t3d_joint_tension/t3d_joint_tension.y";

/// The upper block is lifted for 4 ms, then lowered as fast.
const TABLE: &str = "/YD/YDPN/MPNFACT 4 /YD/YDPN/NPNFACT 4 /YD/YDPN/D3PNFAC 231 2 3 4
0 1 0.004 1 0.0041 -1 1 -1
0 1 0.004 1 0.0041 -1 1 -1
0 1 0.004 1 0.0041 -1 1 -1
";

fn blocks(marks_free_faces: bool) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let deck = fs::read_to_string(root.join(BLOCKS)).expect("a committed deck");
    let free = if marks_free_faces { "" } else { "/YD/YDPM/IAUTBN 0\n" };
    edit(
        deck,
        &[
            ("1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1", &"0 ".repeat(27)),
            ("/YD/YDPM/MPMROW 3\n", &format!("/YD/YDPM/MPMROW 3\n{free}")),
            ("/YD/YDPN/I1PNFX 3\n", &format!("{TABLE}/YD/YDPN/I1PNFX 3\n")),
        ],
    )
}

fn prepared(marks_free_faces: bool, profile: Profile) -> SpatialSimulation {
    let folder = TempDir::new().expect("a temporary folder");
    let deck = write(folder.path(), "blocks.y", blocks(marks_free_faces).as_bytes());
    let loaded = load(&deck, None, profile, SolverOptions::default()).expect("a sound deck");
    let simulation = loaded.simulation.expect("a deck that runs");
    simulation.into_spatial().expect("a deck in space")
}

fn step_to(simulation: &mut SpatialSimulation, end: u64) {
    while simulation.step_index() < end {
        simulation.evaluate_forces();
        simulation.advance();
    }
}

/// Places, at the start, of the nodes that are flagged.
fn flagged(scene: &Scene<3>) -> BTreeSet<[i64; 3]> {
    let flags = scene.nodes.boundary_flag.iter();
    let flagged = flags.zip(&scene.nodes.initial).filter(|(flag, _)| **flag == 1);
    flagged.map(|(_, place)| [0, 1, 2].map(|k| (2.0 * place[k]).round() as i64)).collect()
}

/// Those of all nodes for which something holds; 2 is the far end of the blocks along each axis.
fn places(holds: impl Fn([i64; 3]) -> bool) -> BTreeSet<[i64; 3]> {
    let all = (0..27).map(|n| [n % 3, n / 3 % 3, n / 9]);
    all.filter(|&place| holds(place)).collect()
}

#[test]
fn free_faces_flag_their_nodes_with_all_their_copies() {
    let mut simulation = prepared(true, Profile::Source);
    step_to(&mut simulation, 1);
    let scene = simulation.scene();
    assert_eq!(flagged(scene), places(|place| place != [1; 3]));
    // at each place all copies or none
    for (flag, place) in scene.nodes.boundary_flag.iter().zip(&scene.nodes.initial) {
        assert_eq!(*flag == 1, place.iter().any(|x| *x != 0.5), "{place}");
    }
    for (marks, profile) in [(false, Profile::Source), (true, Profile::Windows)] {
        let mut simulation = prepared(marks, profile);
        step_to(&mut simulation, 1);
        assert_eq!(flagged(simulation.scene()), BTreeSet::new(), "{profile:?}");
    }
}

#[test]
fn a_joint_that_fails_flags_its_nodes_and_makes_its_sides_a_couple() {
    let mut simulation = prepared(false, Profile::Source);
    step_to(&mut simulation, 2);
    let contacts = |simulation: &SpatialSimulation| simulation.couple_work().expect("contact");
    assert_eq!(contacts(&simulation).most_couples, 0, "nothing is flagged");
    while simulation.failures().is_empty() {
        let next = simulation.step_index() + 1;
        step_to(&mut simulation, next);
    }
    let failed = simulation.failures().len();
    let scene = simulation.scene();
    let corners = simulation.failures().iter().flat_map(|f| scene.elements.corners::<6>(f.element));
    let broken: BTreeSet<_> = corners
        .map(|n| [0, 1, 2].map(|k| (2.0 * scene.nodes.initial[n][k]).round() as i64))
        .collect();
    assert_eq!(flagged(scene), broken);
    assert!(broken.iter().all(|place| place[2] == 1), "the weak plane");
    assert!(contacts(&simulation).most_couples >= failed, "sides of failed joints are couples");
}

/// The blocks stop each other where they were torn apart; in the Windows program nothing does.
#[test]
fn torn_faces_bear_pressure_again() {
    let press = |profile| {
        let mut simulation = prepared(false, profile);
        step_to(&mut simulation, 11_000);
        // over the longest period in which waves go up and down
        let mut on_base = 0.0;
        for end in 11_001..=14_000 {
            step_to(&mut simulation, end);
            let nodes = &simulation.scene().nodes;
            let base = (0..nodes.len()).filter(|&n| nodes.initial[n].z == 0.0);
            let force = |n: usize| simulation.forces()[n].z + simulation.joint_forces()[n].z;
            on_base += base.map(force).sum::<f64>() / 3000.0;
        }
        (simulation.failures().len(), -on_base)
    };
    let (failed, pressed) = press(Profile::Source);
    let (failed_too, unpressed) = press(Profile::Windows);
    assert_eq!((failed, failed_too), (8, 8), "the whole plane");
    // 1 m² of modulus 1 GPa, pressed together by 0.88 mm over 1 m on the average, held at both ends
    assert!((0.8e6..1.0e6).contains(&pressed), "{pressed} N");
    assert!(unpressed.abs() < 0.1 * pressed, "{unpressed} beside {pressed}");
}

/// Flags, couples and families come with the state.
#[test]
fn what_was_torn_apart_is_so_after_a_restart() {
    let mut straight = prepared(false, Profile::Source);
    let mut saved = Vec::new();
    while straight.failures().len() < 8 {
        // kept before the first failure, and before the last one known
        if straight.step_index().is_multiple_of(50) {
            saved.push(postcard::to_stdvec(&straight.state()).expect("a state can be written"));
        }
        let next = straight.step_index() + 1;
        step_to(&mut straight, next);
    }
    let end = straight.step_index() + 200;
    step_to(&mut straight, end);
    for bytes in saved.iter().rev().take(3) {
        let state: SpatialState = postcard::from_bytes(bytes).expect("the state");
        let mut restored = prepared(false, Profile::Source);
        restored.restore(state).expect("a state of this deck");
        step_to(&mut restored, end);
        let bits = |s: &SpatialSimulation| postcard::to_stdvec(&s.state()).expect("a state");
        assert!(bits(&restored) == bits(&straight), "other bits");
    }
}
