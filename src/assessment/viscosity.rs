//! D1PEKS against critical damping and against what the smallest element bears.

use super::{Facts, Places, below};
use crate::stability::{Limits, Share};
use yformat::diagnostic::Diagnostic;

pub(super) fn judge(
    facts: &Facts,
    limits: &Limits,
    places: &Places<'_>,
    findings: &mut Vec<Diagnostic>,
) {
    let is_unstable = facts.time_step_s > limits.critical_s;
    let by_viscosity = matches!(limits.set_by.map(|c| c.part), Some(Share::Viscosity(_)));
    for set in &facts.sets {
        let viscosity = set.viscosity_pa_s;
        if viscosity <= 0.0 {
            continue;
        }
        let place = places.of_set("D1PEKS", set.set);
        let (element, height) = (set.smallest_element, set.smallest_height_m);
        if is_unstable && by_viscosity && viscosity > set.safe_viscosity_pa_s {
            let safe = below(0.9 * set.safe_viscosity_pa_s);
            let finding = Diagnostic::error(
                "check::viscosity",
                format!("D1PEKS {viscosity:e} Pa s of property set {} is too much for its smallest elements", set.set),
            )
            .at(place)
            .label(format!("element {element} is {height:.3e} m high"));
            findings.push(match safe > 0.0 {
                true => finding
                    .expected(format!("D1PEKS of {safe:e} Pa s or less at this time step"))
                    .help("give small elements a property set with less viscosity of its own, or shorten DCSTEC: viscous forces are those of the velocity before the step"),
                false => finding
                    .expected("a shorter DCSTEC first: without any viscosity this set may not be stable either")
                    .help("see check::time-step"),
            });
        } else if viscosity > 1.5 * set.critical_viscosity_pa_s {
            findings.push(
                Diagnostic::note(
                    "check::overdamped",
                    format!(
                        "D1PEKS {viscosity:e} Pa s of property set {} is {:.1} times critical damping of its smallest element",
                        set.set,
                        viscosity / set.critical_viscosity_pa_s
                    ),
                )
                .at(place)
                .expected(format!(
                    "2 h √(E ρ) = {:e} Pa s for the {height:.3e} m of element {element}",
                    below(set.critical_viscosity_pa_s)
                ))
                .help("more slows the way to rest and shortens the stable step"),
            );
        }
    }
    let undamped = facts.sets.iter().all(|set| set.viscosity_pa_s <= 0.0);
    if let (true, Some(set)) = (undamped && facts.has_gravity, facts.sets.first()) {
        findings.push(
            Diagnostic::note("check::undamped", "no property set has viscosity: vibrations under gravity never end")
                .at(places.of_set("D1PEKS", set.set))
                .expected(format!(
                    "for bodies that come to rest D1PEKS of {:e} Pa s, critical damping of an element of {:.3e} m",
                    below(set.critical_viscosity_pa_s),
                    set.smallest_height_m
                )),
        );
    }
}
