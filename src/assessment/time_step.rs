//! The time step against the critical one.

use super::{Facts, Places, below, element_of};
use crate::{
    bench::work_precision::recommendations::{TIME_STEP_AT_REST, TIME_STEP_IN_MOTION},
    stability::Limits,
};
use yformat::diagnostic::Diagnostic;

/// Share of the critical step above which strains of a run may use up what is left.
const NEARLY: f64 = 0.9;

pub(super) fn judge(
    facts: &Facts,
    limits: &Limits,
    places: &Places<'_>,
    findings: &mut Vec<Diagnostic>,
) {
    let (dt, critical) = (facts.time_step_s, limits.critical_s);
    let place = places.of(&["YDC/DCSTEC"]);
    let suggestion = below(TIME_STEP_AT_REST * critical);
    let cause = limits.set_by.map_or_else(String::new, |culprit| {
        let at = facts.place_of(element_of(culprit.part)).map_or_else(String::new, |at| {
            let at: Vec<String> = at.iter().map(|x| format!("{x:.4}")).collect();
            format!(" at ({})", at.join(", "))
        });
        format!(", which {}{at} sets", culprit.part)
    });
    // what the limit is without contacts, which open again when they push each other away
    let lasting = limits.joints_s.min(limits.viscosity_s);
    if dt > critical && dt <= NEARLY * lasting {
        findings.push(
            Diagnostic::warning(
                "check::time-step",
                format!("the time step {dt:e} s is longer than what contacts that stay closed bear, {critical:.3e} s{cause}"),
            )
            .at(place)
            .label(format!("{:.2} of the critical step", dt / critical))
            .expected(format!("DCSTEC of {suggestion:e} s or less"))
            .help("such contacts push each other open in a few steps, with energy from nowhere: shorten the step, or lower D1PEPE"),
        );
    } else if dt > critical {
        findings.push(
            Diagnostic::error(
                "check::time-step",
                format!("the time step {dt:e} s is longer than the critical one, {critical:.3e} s{cause}"),
            )
            .at(place)
            .label(format!("{:.2} of the critical step", dt / critical))
            .expected(format!("DCSTEC of {suggestion:e} s or less"))
            .help("the run would diverge: shorten the step, or mend what sets its limit"),
        );
    } else if dt > NEARLY * critical {
        findings.push(
            Diagnostic::warning(
                "check::time-step",
                format!("the time step {dt:e} s is {:.0} % of the critical one, {critical:.3e} s{cause}", 100.0 * dt / critical),
            )
            .at(place)
            .expected(format!("DCSTEC of {suggestion:e} s or less"))
            .help("elements get stiffer as they are compressed, which shortens the limit"),
        );
    }
    if dt <= critical && dt > limits.impact_s {
        findings.push(
            Diagnostic::warning(
                "check::impact-step",
                format!(
                    "bodies that meet face to face are stable up to {:.3e} s only, the time step is {dt:e} s",
                    limits.impact_s
                ),
            )
            .at(place)
            .expected(format!("DCSTEC of {:e} s or less", below(TIME_STEP_AT_REST * limits.impact_s)))
            .help(format!(
                "if bodies collide, {:e} s keeps their energy to 0.1 %",
                below(TIME_STEP_IN_MOTION * limits.impact_s)
            )),
        );
    }
}
