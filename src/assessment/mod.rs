//! What a run of a deck will come to, found before it starts: whether its time step is stable, and
//! whether its settings go together.

mod contact;
mod facts;
mod joints;
mod loads;
mod places;
mod resources;
mod time_step;
mod viscosity;

pub use facts::{Facts, SetFacts};
pub use resources::Resources;

use crate::{
    session::LoadedDeck,
    simulation::AnySimulation,
    stability::{Limits, Part, Share},
};
use places::Places;
use serde::Serialize;
use yformat::diagnostic::Diagnostic;

/// What is expected of a run.
#[derive(Debug, Clone, Serialize)]
pub struct Assessment {
    /// Time step of the deck, s.
    pub time_step_s: f64,
    /// Critical time step of the scene as it stands, s; none if nothing limits it.
    pub critical_step_s: Option<f64>,
    /// Critical step by step of the deck: above 1 the run is stable.
    pub safety_factor: Option<f64>,
    /// Critical step if free edges or faces are pressed by their like, s.
    pub critical_step_in_impact_s: Option<f64>,
    /// Critical steps of the elasticity of elements alone, with joints, with closed contacts, and
    /// of viscosity alone, s.
    pub of_elements_s: Option<f64>,
    /// See above.
    pub with_joints_s: Option<f64>,
    /// See above.
    pub with_contacts_s: Option<f64>,
    /// See above.
    pub of_viscosity_s: Option<f64>,
    /// What sets the critical step, in words.
    pub set_by: Option<String>,
    /// Where that is, m.
    pub place_m: Option<Vec<f64>>,
    /// Property sets.
    pub sets: Vec<SetFacts>,
    /// Memory, files and time of the run.
    pub resources: Resources,
    /// What is to be changed.
    #[serde(skip)]
    pub findings: Vec<Diagnostic>,
}

/// Assesses the first stage of a deck; none if nothing runs.
#[must_use]
pub fn assess(loaded: &LoadedDeck) -> Option<Assessment> {
    let simulation = loaded.simulation.as_ref()?;
    let limits = Limits::of_simulation(simulation);
    let facts = match simulation {
        AnySimulation::Plane(s) => Facts::of_plane(s.scene()),
        AnySimulation::Spatial(s) => Facts::of_space(s.scene()),
    };
    let places = Places { deck: &loaded.deck, database: &loaded.database };
    let mut findings = Vec::new();
    time_step::judge(&facts, &limits, &places, &mut findings);
    viscosity::judge(&facts, &limits, &places, &mut findings);
    contact::judge(&facts, &places, &mut findings);
    joints::judge(&facts, &places, &mut findings);
    loads::judge(&facts, &places, &mut findings);
    let sources = loaded.deck.sources();
    let findings = findings.into_iter().map(|finding| finding.located(sources)).collect();
    let finite = |value: f64| value.is_finite().then_some(value);
    let culprit = limits.set_by.map(|culprit| culprit.part);
    Some(Assessment {
        time_step_s: facts.time_step_s,
        critical_step_s: finite(limits.critical_s),
        safety_factor: finite(limits.critical_s / facts.time_step_s),
        critical_step_in_impact_s: finite(limits.impact_s),
        of_elements_s: finite(limits.elements_s),
        with_joints_s: finite(limits.joints_s),
        with_contacts_s: finite(limits.contact_s),
        of_viscosity_s: finite(limits.viscosity_s),
        set_by: limits.set_by.map(|c| format!("{} ({:.0} % of it)", c.part, 100.0 * c.share)),
        place_m: culprit.and_then(|share| facts.place_of(element_of(share))),
        resources: Resources::of(simulation, &facts),
        sets: facts.sets,
        findings,
    })
}

fn element_of(share: Share) -> usize {
    let (Share::Stiffness(part) | Share::Viscosity(part)) = share;
    match part {
        Part::Element(e) | Part::Joint(e) | Part::Impact(e) => e,
        Part::Contact([a, _]) => a,
    }
}

/// A number rounded down to two digits, for settings to write into a deck.
fn below(value: f64) -> f64 {
    rounded(value, f64::floor)
}

/// A number rounded up to two digits.
fn above(value: f64) -> f64 {
    rounded(value, f64::ceil)
}

fn rounded(value: f64, round: fn(f64) -> f64) -> f64 {
    if !(value > 0.0 && value.is_finite()) {
        return value;
    }
    let decade = value.log10().floor() as i32 - 1;
    // a hair of slack, so that 0.75 stays 0.75
    let slack = if round(0.5) > 0.0 { -1e-9 } else { 1e-9 };
    let digits = round(value / 10f64.powi(decade) * (1.0 + slack));
    // through text: 5e-6, not 4.999999999999999e-6
    format!("{digits}e{decade}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::{above, below};

    #[test]
    fn settings_are_rounded_to_two_digits_on_the_safe_side() {
        assert_eq!(below(0.75), 0.75);
        assert_eq!(below(1.2678e-6), 1.2e-6);
        assert_eq!(above(1.2101e9), 1.3e9);
        assert_eq!(above(20.0), 20.0);
    }
}
