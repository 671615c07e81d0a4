//! Contact penalty and buffer.

use super::{Facts, Places, SetFacts, above, below};
use crate::bench::work_precision::recommendations::{BUFFER, PENALTY};
use yformat::{diagnostic::Diagnostic, source::Span};

/// Penalty by Young's modulus below which bodies overlap too much, and above which nothing is
/// gained any more.
const PENALTY_RANGE: [f64; 2] = [2.0, 200.0];
/// Contact pressure by Young's modulus that rounding may make.
const COARSE: f64 = 1e-8;
/// Buffer by the smallest height above which couples are too many.
const WIDE_BUFFER: f64 = 1.0;
/// Steps that the buffer should last at the highest speed.
const FEW_STEPS: f64 = 5.0;

pub(super) fn judge(facts: &Facts, places: &Places<'_>, findings: &mut Vec<Diagnostic>) {
    if facts.contact.is_none() {
        return;
    }
    if !facts.has_pair_table() {
        penalties(facts, places, findings);
    }
    buffer(facts, places, findings);
}

fn penalties(facts: &Facts, places: &Places<'_>, findings: &mut Vec<Diagnostic>) {
    // sets of the same stone have the same to be said
    let mut alike: Vec<(f64, Vec<&SetFacts>)> = Vec::new();
    for set in facts.sets.iter().filter(|set| set.young_pa > 0.0 && set.penalty_pa > 0.0) {
        let ratio = set.penalty_pa / set.young_pa;
        match alike.iter_mut().find(|(other, _)| (ratio / other - 1.0).abs() < 1e-3) {
            Some((_, sets)) => sets.push(set),
            None => alike.push((ratio, vec![set])),
        }
    }
    for (ratio, sets) in alike {
        let place = match places.of_set("D1PEPE", sets[0].set) {
            Some(place) => Some(place),
            None => places.of_set("D1PEPC", sets[0].set),
        };
        penalty(ratio, &sets, place, findings);
        precision(ratio, &sets, facts, place, findings);
    }
}

fn penalty(ratio: f64, sets: &[&SetFacts], place: Option<Span>, findings: &mut Vec<Diagnostic>) {
    let [least, most] = PENALTY_RANGE;
    if (least..=most).contains(&ratio) {
        return;
    }
    let numbers: Vec<String> = sets.iter().map(|set| set.set.to_string()).collect();
    let (plural, numbers) = (if sets.len() == 1 { "" } else { "s" }, numbers.join(", "));
    let consequence = match ratio < least {
        true => format!(
            "{ratio:.2} times Young's modulus: each contact is as soft as a layer of {:.2} heights of its triangles",
            1.0 / (6.0 * ratio)
        ),
        false => format!("{ratio:.0} times Young's modulus: steps get shorter, results no better"),
    };
    let message = format!("the contact penalty of property set{plural} {numbers} is {consequence}");
    let wanted = above(PENALTY * sets[0].young_pa);
    findings.push(
        Diagnostic::warning("check::penalty", message)
            .at(place)
            .expected(format!("{wanted:e} Pa, {PENALTY} times Young's modulus")),
    );
}

/// Coordinates are rounded: what pressure does the smallest overlap make?
fn precision(
    ratio: f64,
    sets: &[&SetFacts],
    facts: &Facts,
    place: Option<Span>,
    findings: &mut Vec<Diagnostic>,
) {
    let height = sets.iter().map(|set| set.smallest_height_m).fold(f64::INFINITY, f64::min);
    let largest = facts.extent_m[1];
    let rounding = f64::EPSILON * largest * 6.0 * ratio / height;
    if rounding > COARSE {
        findings.push(
            Diagnostic::warning(
                "check::precision",
                format!("rounding of coordinates up to {largest:.3e} m makes contact pressures of {rounding:.1e} of Young's modulus"),
            )
            .at(place)
            .expected("coordinates that begin near 0, or a smaller penalty")
            .help("move the origin into the scene"),
        );
    }
}

fn buffer(facts: &Facts, places: &Places<'_>, findings: &mut Vec<Diagnostic>) {
    let Some(contact) = &facts.contact else { return };
    let (buffer, height) = (contact.buffer, facts.smallest_height());
    if !height.is_finite() {
        return;
    }
    let place = places.of(&["YDI/DIEZON"]);
    let step = facts.speed_m_s * facts.time_step_s;
    let wanted = below((BUFFER * height).max(20.0 * step));
    let expected = format!("DIEZON of about {wanted:e} m");
    if buffer <= step && step > 0.0 {
        findings.push(
            Diagnostic::error(
                "check::buffer",
                format!("nodes move {step:.3e} m in one step, more than DIEZON {buffer:e} m: contacts are missed"),
            )
            .at(place)
            .expected(expected),
        );
    } else if buffer < FEW_STEPS * step {
        findings.push(
            Diagnostic::warning(
                "check::buffer",
                format!("nodes at {:.3e} m/s cross DIEZON {buffer:e} m in {:.1} steps: contact is looked for all the time", facts.speed_m_s, buffer / step),
            )
            .at(place)
            .expected(expected),
        );
    } else if buffer > WIDE_BUFFER * height {
        findings.push(
            Diagnostic::note(
                "check::buffer",
                format!("DIEZON {buffer:e} m is {:.1} heights of the smallest element: many couples that never touch", buffer / height),
            )
            .at(place)
            .expected(expected),
        );
    }
}
