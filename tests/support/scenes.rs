//! Scenes and the bits of their states.

use std::path::Path;
use yformat::{database::Database, deck::Deck};
use ypsilon::{
    scene::{Profile, Scene, from_deck},
    simulation::{Simulation, SolverOptions},
    team::Team,
};

/// The scene that the first stage of a deck describes.
pub fn scene(deck: &Deck) -> Scene {
    let mut database = Database::new(deck.dialect());
    for item in deck.stages()[0].items.clone() {
        let findings = database.apply(deck, item);
        assert!(findings.iter().all(|f| !f.is_error()), "{findings:?}");
    }
    let outcome = from_deck(deck, &database, "test", Profile::default());
    outcome.scene.unwrap_or_else(|| panic!("{:?}", outcome.findings))
}

/// The scene of a case of `tests/data`: one of the split dialect, or `classic/` and
/// its name, or `ygeo/` and its name.
pub fn reference_scene(case: &str) -> Scene {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data");
    let (dialect, name) = case.split_once('/').unwrap_or(("split2d", case));
    let deck = root.join(dialect).join(name).join(format!("{name}.y"));
    let outcome = Deck::read(deck).expect("committed deck");
    assert!(!outcome.has_errors());
    scene(&outcome.deck)
}

/// The scene at its start, to be moved by so many threads.
pub fn on_threads(scene: &Scene, threads: usize) -> Simulation {
    let team = Team::new(threads).expect("threads");
    Simulation::with_options(scene.clone(), SolverOptions { team, ..SolverOptions::default() })
}

/// Runs one step.
pub fn step(simulation: &mut Simulation) {
    simulation.evaluate_forces();
    simulation.advance();
}

/// Bits of everything that a step changes.
pub fn bits(simulation: &Simulation) -> Vec<u64> {
    let nodes = &simulation.scene().nodes;
    let vectors =
        [&nodes.current, &nodes.velocity].into_iter().flatten().chain(simulation.forces());
    let elements = &simulation.scene().elements;
    let joints = elements.property.iter().zip(&elements.joint_kind);
    let joints = joints.flat_map(|(&property, &kind)| [property as u64, kind as u64]);
    let sliding = simulation.couples().into_iter().flat_map(|(pair, sliding)| {
        // a sliding that is zero has no sign
        pair.map(u64::from).into_iter().chain(sliding.map(|s| (s + 0.0).to_bits()))
    });
    let vectors = vectors.flat_map(|v| [v.x.to_bits(), v.y.to_bits()]);
    vectors.chain(joints).chain(sliding).collect()
}
