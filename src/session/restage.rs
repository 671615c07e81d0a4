//! Later `$YDOIT` stages: everything persists, a stage changes what it names
//! (spec `deck.md` 1.5).

use super::load::anchored;
use crate::{
    scene::{Profile, update_scene},
    simulation::Simulation,
};
use std::collections::BTreeSet;
use yformat::{
    database::Database,
    deck::{Deck, Stage},
    diagnostic::Diagnostic,
};

/// Applies the items of a later stage to a simulation that has run; returns warnings and notes.
///
/// # Errors
/// With all findings if one of them is an error; the simulation is unchanged then.
pub(super) fn restage(
    deck: &Deck,
    stage: &Stage,
    database: &mut Database,
    simulation: &mut Simulation,
    profile: Profile,
) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    // the step counter and the time are the program's own variables
    database.set_integer("YDC/NCSTEP", i64::try_from(simulation.step_index()).unwrap_or(i64::MAX));
    database.set_real("YDC/DCTIME", simulation.time());
    let mut findings = Vec::new();
    let mut named = BTreeSet::new();
    for item in stage.items.clone() {
        findings.extend(database.apply(deck, item));
        if let Some(assignment) = deck.item(item).and_then(|i| i.assignment()) {
            named.insert(format!("{}/{}", assignment.keyword.database, assignment.keyword.name));
        }
    }
    let located = |findings: Vec<Diagnostic>| {
        findings.into_iter().map(|f| f.located(deck.sources())).collect::<Vec<_>>()
    };
    if !findings.iter().any(Diagnostic::is_error) {
        let outcome = update_scene(deck, database, simulation.scene(), &named, profile);
        findings.extend(outcome.findings.into_iter().map(|f| anchored(f, deck, stage)));
        if let Some(scene) = outcome.scene.filter(|_| !findings.iter().any(Diagnostic::is_error)) {
            let travel = named.contains("YDI/DIEDI").then(|| database.real("YDI/DIEDI"));
            simulation.continue_with(scene, travel);
            return Ok(located(findings));
        }
    }
    Err(located(findings))
}
