//! Descriptions of meshes, and words of the command line.

use yformat::deck::Deck;
use ypsilon::{meshing::Scenario, output::Monitor, session::monitors};
use ypsilon_converters::gmsh::{parse_msh, skeleton};
use ypsilon_post::{field::Field, results::FrameChoice, selection::Selection};

/// A Gmsh mesh, down to the deck that is made of it.
pub fn gmsh(bytes: &[u8]) {
    if let Ok(mesh) = parse_msh(bytes)
        && let Ok(skeleton) = skeleton(&mesh, "wall.msh")
    {
        let outcome = Deck::parse("wall.y", skeleton.deck.to_text());
        assert!(!outcome.has_errors(), "{:?}", outcome.error());
    }
}

/// A scenario, down to its deck.
pub fn scenario(bytes: &[u8]) {
    let Ok(text) = std::str::from_utf8(bytes) else { return };
    let Ok(scenario) = Scenario::parse(text) else { return };
    let _ = monitors(&scenario, "scenario.toml".as_ref());
    if is_large(text) {
        return;
    }
    if let Ok(generated) = scenario.generate_any() {
        let outcome = Deck::parse("wall.y", generated.deck().to_text());
        assert!(!outcome.has_errors(), "{:?}", outcome.error());
    }
}

/// Whether a scenario names a number of cells, blocks or courses with which a mesh takes long. Beyond
/// all bounds it has to be refused at once.
fn is_large(text: &str) -> bool {
    let words = text.split(|c: char| !(c.is_ascii_alphanumeric() || ".+-_".contains(c)));
    words.filter_map(|word| word.parse::<u64>().ok()).any(|n| (9..100_000).contains(&n))
}

/// Selections, fields, times and monitors.
pub fn words(bytes: &[u8]) {
    let Ok(words) = std::str::from_utf8(bytes) else { return };
    let _ = words.parse::<Selection>();
    let _ = words.parse::<Field>();
    let _ = words.parse::<FrameChoice>();
    let _ = words.parse::<Monitor>();
}
