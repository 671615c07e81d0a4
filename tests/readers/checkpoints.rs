//! Checkpoints: the file, and the states in it.

use super::{
    decks::{run_options, step},
    folder,
};
use std::{path::Path, sync::LazyLock};
use yformat::{checksum::Checksum, deck::Deck};
use ypsilon::{
    scene::Profile,
    session::{Checkpoint, Checkpoints, LoadedDeck, Silent, prepare, run_with},
    simulation::{AnySimulation, SimulationState, SolverOptions, SpatialState},
};

/// Steps that a restored state makes.
const STEPS: u64 = 3;

/// Decks whose states are restored: each dialect keeps other things of its own. The first is that
/// of the checkpoint files.
pub const DECKS: [&[u8]; 5] = [
    include_bytes!("../bad_decks/base.y"),
    include_bytes!("../bad_decks/base_classic.y"),
    include_bytes!("../bad_decks/base_ygeo.y"),
    include_bytes!("../bad_decks/base_3d.y"),
    include_bytes!("../data/y3d/12_joint_pair.Y3D"),
];

/// A checkpoint file, and the run that goes on from it. Its checksum and the length that it gives
/// of itself are set right first: what stands behind them is to be read.
pub fn file(bytes: &[u8]) {
    let path = Path::new("deck.checkpoint");
    let _ = Checkpoint::parse(bytes, path);
    let Ok(checkpoint) = Checkpoint::parse(&with_checksum(bytes), path) else { return };
    let folder = folder();
    let options = run_options(folder.path());
    let resume = Checkpoints { resume: Some(checkpoint), ..Checkpoints::default() };
    let _ = run_with(loaded(0), &options, resume, &mut Silent);
}

/// Magic line, format, version of the program; length of the payload; payload; checksum.
fn with_checksum(bytes: &[u8]) -> Vec<u8> {
    let mut bytes = bytes.to_vec();
    let version = bytes.get(23).map_or(0, |&length| usize::from(length));
    let start = 24 + version + 8;
    if let Some(end) = bytes.len().checked_sub(8).filter(|&end| end >= start) {
        let length = (end - start) as u64;
        bytes[start - 8..start].copy_from_slice(&length.to_le_bytes());
        let checksum = Checksum::of(&bytes[..end]);
        bytes[end..].copy_from_slice(&checksum.to_le_bytes());
    }
    bytes
}

/// A state, the number of its deck in the first byte: whether it fits is checked, and if so the
/// simulation goes on with it.
pub fn state(bytes: &[u8]) {
    goes_on(bytes);
}

/// Whether a state could be restored.
pub fn goes_on(bytes: &[u8]) -> bool {
    let Some((&deck, bytes)) = bytes.split_first() else { return false };
    let mut simulation = SIMULATIONS[usize::from(deck) % DECKS.len()].clone();
    let is_restored = match &mut simulation {
        AnySimulation::Plane(simulation) => postcard::from_bytes::<SimulationState>(bytes)
            .is_ok_and(|state| simulation.restore(state).is_ok()),
        AnySimulation::Spatial(simulation) => postcard::from_bytes::<SpatialState>(bytes)
            .is_ok_and(|state| simulation.restore(state).is_ok()),
    };
    if is_restored {
        step(&mut simulation, STEPS);
    }
    is_restored
}

/// States of all decks after no, one and twelve steps.
pub fn states() -> Vec<Vec<u8>> {
    let mut states = Vec::new();
    for (deck, simulation) in SIMULATIONS.iter().enumerate() {
        for steps in [0, 1, 12] {
            let mut simulation = simulation.clone();
            step(&mut simulation, steps);
            let state = match &simulation {
                AnySimulation::Plane(simulation) => postcard::to_stdvec(&simulation.state()),
                AnySimulation::Spatial(simulation) => postcard::to_stdvec(&simulation.state()),
            };
            let mut bytes = vec![deck as u8];
            bytes.extend(state.expect("a state can be written"));
            states.push(bytes);
        }
    }
    states
}

/// The checkpoint that a run of the first deck leaves.
pub fn files() -> Vec<Vec<u8>> {
    let folder = folder();
    let options = run_options(folder.path());
    let checkpoints = Checkpoints { at_end: true, ..Checkpoints::default() };
    run_with(loaded(0), &options, checkpoints, &mut Silent).expect("a run");
    vec![std::fs::read(folder.path().join("deck.checkpoint")).expect("a checkpoint")]
}

/// The simulations of the decks at their start.
static SIMULATIONS: LazyLock<[AnySimulation; DECKS.len()]> = LazyLock::new(|| {
    std::array::from_fn(|deck| loaded(deck).simulation.expect("a deck that runs"))
});

fn loaded(deck: usize) -> LoadedDeck {
    let outcome = Deck::parse("deck.y", DECKS[deck]);
    let path = Path::new("deck.y");
    prepare(outcome, path, Profile::default(), SolverOptions::default()).expect("a sound deck")
}
