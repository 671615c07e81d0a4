//! Loads that start at once.

use super::{Facts, Places, above, facts::Sudden};
use yformat::diagnostic::Diagnostic;

/// Passages of a wave through the scene in which a load should rise.
const PASSAGES: f64 = 20.0;

pub(super) fn judge(facts: &Facts, places: &Places<'_>, findings: &mut Vec<Diagnostic>) {
    let slowest = facts
        .sets
        .iter()
        .map(|set| (set.young_pa / set.density_kg_m3).sqrt())
        .filter(|speed| *speed > 0.0)
        .fold(f64::INFINITY, f64::min);
    if !slowest.is_finite() {
        return;
    }
    let rise = above(PASSAGES * facts.extent_m[0] / slowest);
    for (set, sudden) in &facts.sudden {
        let (what, keyword) = match sudden {
            Sudden::Force => ("forces act".to_owned(), ["D1PNAX", "D1PNAY"]),
            Sudden::Pressure => ("pressure acts".to_owned(), ["D1PNAP", "D1PNAT"]),
            Sudden::Velocity(jump) => {
                (format!("nodes are moved with {jump:.3e} m/s"), ["D1PNAX", "D1PNAY"])
            }
        };
        let names = keyword.map(|k| [format!("YDPN/{k}"), format!("YDP/{k}")]);
        let names: Vec<&str> = names.iter().flatten().map(String::as_str).collect();
        findings.push(
            Diagnostic::note(
                "check::sudden-load",
                format!("{what} on node set {set} in full from the first step: stresses overshoot by up to a factor 2"),
            )
            .at(places.number(&names, *set))
            .expected(format!("a table D3PNFAC that rises from 0 within {rise:e} s, {PASSAGES} passages of a wave, unless a blow is meant")),
        );
    }
    if facts.has_gravity {
        findings.push(
            Diagnostic::note(
                "check::sudden-gravity",
                "gravity acts in full from the first step: bodies at rest begin to swing",
            )
            .at(places.of(&["YDC/DCGRAY", "YDC/DCGRAZ"]))
            .expected(format!(
                "`ypsilon run --settle`, or {rise:e} s of settling before other loads rise"
            )),
        );
    }
}
