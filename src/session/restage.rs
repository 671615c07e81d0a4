//! Later `$YDOIT` stages: everything persists, a stage changes what it names
//! (spec `deck.md` 1.5).

use super::{load::anchored, model::Model};
use crate::scene::Profile;
use serde::{Deserialize, Serialize};
use std::collections::BTreeSet;
use yformat::{
    database::Database,
    deck::{Deck, Stage},
    diagnostic::Diagnostic,
};

/// Where a run stood when it entered a later stage.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub(super) struct Entry {
    pub step: u64,
    pub time: f64,
}

impl Entry {
    pub fn of(simulation: &impl Model) -> Self {
        Self { step: simulation.step_index(), time: simulation.time() }
    }
}

/// Applies the items of a later stage to the values; returns findings and the keywords named.
fn apply(
    deck: &Deck,
    stage: &Stage,
    database: &mut Database,
    entry: Entry,
) -> (Vec<Diagnostic>, BTreeSet<String>) {
    // the step counter and the time are the program's own variables
    database.set_integer("YDC/NCSTEP", i64::try_from(entry.step).unwrap_or(i64::MAX));
    database.set_real("YDC/DCTIME", entry.time);
    let mut findings = Vec::new();
    let mut named = BTreeSet::new();
    for item in stage.items.clone() {
        findings.extend(database.apply(deck, item));
        if let Some(assignment) = deck.item(item).and_then(|i| i.assignment()) {
            named.insert(format!("{}/{}", assignment.keyword.database, assignment.keyword.name));
        }
    }
    (findings, named)
}

/// Takes a simulation through a stage that an earlier run has passed, up to its settings; the
/// state comes from a checkpoint.
pub(super) fn replay(
    deck: &Deck,
    stage: &Stage,
    database: &mut Database,
    simulation: &mut impl Model,
    entry: Entry,
    profile: Profile,
) {
    let (_, named) = apply(deck, stage, database, entry);
    simulation.replay(deck, database, &named, profile);
}

/// Applies the items of a later stage to a simulation that has run; returns warnings and notes.
///
/// # Errors
/// With all findings if one of them is an error; the simulation is unchanged then.
pub(super) fn restage(
    deck: &Deck,
    stage: &Stage,
    database: &mut Database,
    simulation: &mut impl Model,
    profile: Profile,
) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    let (mut findings, named) = apply(deck, stage, database, Entry::of(simulation));
    let located = |findings: Vec<Diagnostic>| {
        findings.into_iter().map(|f| f.located(deck.sources())).collect::<Vec<_>>()
    };
    if !findings.iter().any(Diagnostic::is_error) {
        let found = simulation.restage(deck, database, &named, profile);
        findings.extend(found.into_iter().map(|f| anchored(f, deck, stage)));
    }
    if findings.iter().any(Diagnostic::is_error) {
        return Err(located(findings));
    }
    Ok(located(findings))
}
