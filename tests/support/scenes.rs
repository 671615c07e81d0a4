//! Scenes and the bits of their states.

use std::path::Path;
use yformat::{database::Database, deck::Deck};
use ypsilon::{
    scene::{Profile, Scene, from_deck},
    simulation::Simulation,
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

/// The scene of a case of `tests/data/split2d`.
pub fn reference_scene(case: &str) -> Scene {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/split2d");
    let outcome = Deck::read(root.join(case).join(format!("{case}.y"))).expect("committed deck");
    assert!(!outcome.has_errors());
    scene(&outcome.deck)
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
    let properties = simulation.scene().elements.property.iter().map(|&p| p as u64);
    vectors.flat_map(|v| [v.x.to_bits(), v.y.to_bits()]).chain(properties).collect()
}
