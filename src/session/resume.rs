//! From a checkpoint to a run that goes on.

use super::{
    checkpoint::{Checkpoint, CheckpointError, DeckPrint, Position},
    load::LoadedDeck,
    model::{Model, Writers},
    restage::replay,
    run::{RunError, RunOptions},
};
use crate::output::{Background, OutputNames};
use yformat::database::Database;

/// More steps, and more triangles times steps, than any run does.
const MOST_COUNTED: u64 = 1 << 60;

/// Takes a deck that has just been loaded to where the run of the checkpoint stood. Gives that
/// place, and the writers with their files open there.
///
/// # Errors
/// If the checkpoint is not one of this deck or result files are not as they were left.
pub(super) fn resume<M: Model>(
    checkpoint: &Checkpoint,
    loaded: &mut LoadedDeck,
    simulation: &mut M,
    options: &RunOptions,
    names: &OutputNames,
    background: &Background,
) -> Result<(Position, Writers<M>), RunError> {
    let other_deck = || CheckpointError::OtherDeck { deck: options.deck.clone() };
    let mut position = checkpoint.position.clone();
    let LoadedDeck { deck, database, stages, .. } = loaded;
    let entered = position.ends.len();
    if DeckPrint::of(deck) != checkpoint.deck
        || !(1..=stages.len()).contains(&entered)
        || position.entries.len() + 1 != entered
        || position.steps.max(position.triangle_steps) > MOST_COUNTED
    {
        return Err(other_deck().into());
    }
    check_end(&position, 0, database)?;
    for (index, entry) in (1..entered).zip(&position.entries) {
        replay(deck, &stages[index], database, simulation, *entry, options.profile);
        check_end(&position, index, database)?;
    }
    simulation.load(checkpoint.state.clone()).map_err(CheckpointError::from)?;
    let (step, end) = (simulation.step_index(), simulation.control().end_step);
    if end < step {
        return Err(CheckpointError::Passed { step, end }.into());
    }
    if let Some(last) = position.ends.last_mut() {
        *last = database.integer("YDC/MCSTEP");
    }
    let mut writers = simulation.writers(options, names, background, true)?;
    let kinds: Vec<&str> = checkpoint.marks.iter().map(|(kind, _)| kind.as_str()).collect();
    if !writers.iter().map(|writer| writer.kind()).eq(kinds.iter().copied()) {
        let was = kinds.join(", ");
        return Err(CheckpointError::OtherFormats { was }.into());
    }
    for (writer, (_, mark)) in writers.iter_mut().zip(&checkpoint.marks) {
        writer.resume(mark, names, simulation)?;
    }
    Ok((position, writers))
}

/// A stage that is over must have ended where the deck says; the last may be made longer.
fn check_end(
    position: &Position,
    index: usize,
    database: &Database,
) -> Result<(), CheckpointError> {
    let now = database.integer("YDC/MCSTEP");
    match position.ends.get(index) {
        Some(&was) if index + 1 < position.ends.len() && was != now => {
            Err(CheckpointError::EarlierStage { stage: index + 1, was, now })
        }
        _ => Ok(()),
    }
}
