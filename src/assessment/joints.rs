//! Strengths of joints against their penalties and the size of elements.

use super::{Facts, Places, above, below};
use yformat::diagnostic::Diagnostic;

/// Share of its stiffness that a body loses to intact joints which is worth a word.
const SOFTENING: f64 = 0.05;
/// Opening at the strength, by the length of the joint, that is too much.
const WIDE: f64 = 1e-2;

pub(super) fn judge(facts: &Facts, places: &Places<'_>, findings: &mut Vec<Diagnostic>) {
    let young = facts.sets.iter().map(|set| set.young_pa).fold(0.0, f64::max);
    for (number, law, longest) in &facts.joints {
        let of = |keyword: &str| {
            let names = [format!("YDPJ/{keyword}"), format!("YDP/{keyword}")];
            places.number(&names.each_ref().map(String::as_str), *number)
        };
        if law.penalty <= 0.0 || law.tensile_strength <= 0.0 || young <= 0.0 {
            continue;
        }
        // an element and a joint in line: 1/E and 1/p
        let softer = young / (young + law.penalty);
        if softer > SOFTENING {
            findings.push(
                Diagnostic::warning(
                    "check::joint-softening",
                    format!("intact joints of set {number} make bodies {:.0} % softer: their penalty is {:.2} times Young's modulus", 100.0 * softer, law.penalty / young),
                )
                .at(of("D1PJPE"))
                .expected(format!("D1PJPE of {:e} Pa or more, 20 times Young's modulus, for 5 %", above(20.0 * young)))
                .help("the step gets shorter with the root of the penalty"),
            );
        }
        let opening = 2.0 * law.tensile_strength / law.penalty;
        if opening > WIDE {
            findings.push(
                Diagnostic::warning(
                    "check::joint-opening",
                    format!("joints of set {number} open by {:.1} % of their length before they reach their strength", 100.0 * opening),
                )
                .at(of("D1PJPE"))
                .expected(format!("D1PJPE of {:e} Pa or more", above(2.0 * law.tensile_strength / WIDE))),
            );
        }
        // softening ends at 3 G/f, but not before twice the opening at the strength
        let most = 3.0 * law.fracture_energy * law.penalty / (4.0 * law.tensile_strength.powi(2));
        if law.fracture_energy > 0.0 && *longest > most {
            findings.push(
                Diagnostic::warning(
                    "check::fracture-energy",
                    format!("joints of set {number} up to {longest:.3e} m long take more energy to break than their fracture energy says"),
                )
                .at(of("D1PJGF"))
                .expected(format!("joints of {:.2e} m or less, or D1PJPE of {:e} Pa or more", most, above(law.penalty * longest / most)))
                .help("softening ends at 3 G/f or at twice the opening at the strength, 4 h f/p, whichever is more"),
            );
        }
        let zone = young * law.fracture_energy / law.tensile_strength.powi(2);
        if law.fracture_energy > 0.0 && *longest > zone {
            findings.push(
                Diagnostic::note(
                    "check::fracture-zone",
                    format!("the fracture zone of set {number} is {zone:.2e} m long, shorter than its joints: results depend on the mesh"),
                )
                .at(of("D1PJGF"))
                .expected(format!("elements of {:.2e} m or less", below(zone / 3.0))),
            );
        }
    }
}
