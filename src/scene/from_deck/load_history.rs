//! The load-time table of the node sets.

use super::Reader;
use crate::scene::{Condition, LoadHistory, NodeSet, Scene};
use yformat::diagnostic::Diagnostic;

/// The load-time table of the node sets, if there is one.
pub(super) fn read(reader: &mut Reader<'_>, sets: usize) -> Option<LoadHistory> {
    let points = reader.count("YDPN/NPNFACT", "YDPN/MPNFACT", "load-time points", 0);
    let table = reader.real_field("YDPN/D3PNFAC").filter(|f| f.item().is_some())?;
    let given = table.given_shape();
    let (given_sets, given_points) =
        (given.get(1).copied().unwrap_or(0), given.get(2).copied().unwrap_or(0));
    for (index, given, needed, what) in
        [(1, given_sets, sets, "node sets (NPNSET)"), (2, given_points, points, "points (NPNFACT)")]
    {
        if given < needed {
            reader.report(
                Diagnostic::error(
                    "scene::short-array",
                    format!("the load-time table is given for {given} of {needed} {what}"),
                )
                .at(reader.length("YDPN/D3PNFAC", index))
                .expected(format!(
                    "the header `231 2 {sets} {points}`, then the pairs `time factor` of one set after the other"
                )),
            );
            return None;
        }
    }
    let at = |set: usize, p: usize| (table.get3(0, set, p), table.get3(1, set, p));
    let history = LoadHistory {
        points: (0..sets).map(|set| (0..points).map(|p| at(set, p)).collect()).collect(),
    };
    if history.is_active() {
        check_times(reader, &history);
    }
    Some(history)
}

fn check_times(reader: &mut Reader<'_>, history: &LoadHistory) {
    for (set, points) in history.points.iter().enumerate() {
        let Some(k) = points.windows(2).position(|pair| pair[0].0 >= pair[1].0) else { continue };
        reader.report(
            Diagnostic::error(
                "scene::load-time-order",
                format!(
                    "the load-time table of node set {set} goes from time {} to {}",
                    points[k].0,
                    points[k + 1].0
                ),
            )
            .at(reader.entry_at("YDPN/D3PNFAC", [0, set, k + 1]))
            .expected("times that increase from point to point")
            .help("the table lists pairs `time factor`, one set after the other: put them in order of time, no time twice"),
        );
        return;
    }
}

/// Whether the table covers the run.
pub(super) fn check_use<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    if D == 3 {
        check_presence(reader, scene);
        return;
    }
    let Some(history) = scene.load_history.as_ref().filter(|h| h.is_active()) else { return };
    let control = &scene.control;
    let steps = control.end_step.saturating_sub(control.first_step);
    let last = control.start_time + control.time_step * steps.saturating_sub(1) as f64;
    let loaded = |set: &NodeSet<D>| {
        let along = |k: usize| set.conditions[k] != Condition::Frozen && set.amplitudes[k] != 0.0;
        (0..D).any(along) || set.pressure != 0.0 || set.traction != 0.0
    };
    for (set, points) in
        history.points.iter().enumerate().filter(|(set, _)| loaded(&scene.node_sets[*set]))
    {
        let (Some(first), Some(end)) = (points.first(), points.last()) else { continue };
        // accumulated time may miss the last entry by rounding
        let slack = 0.5 * control.time_step;
        if first.0 > control.start_time + slack || end.0 < last - slack {
            reader.report(
                Diagnostic::warning(
                    "scene::load-time-coverage",
                    format!(
                        "the load-time table of node set {set} covers {} to {} s, the run {} to {last} s",
                        first.0, end.0, control.start_time
                    ),
                )
                .at(reader.entry_at("YDPN/D3PNFAC", [0, set, 0]))
                .expected("a table that covers the run")
                .help("outside the table the factor is 1, not the last value: add a point at the end of the run"),
            );
            return;
        }
    }
}

/// In 3D the original stops when the time leaves the table of a set.
fn check_presence<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    let Some(history) = &scene.load_history else { return };
    for (set, points) in history.points.iter().enumerate() {
        let [first, .., end] = points[..] else { continue };
        let Some(missed) = first_time_outside(scene, first.0, end.0) else { continue };
        reader.report(
            Diagnostic::error(
                "scene::load-time-coverage",
                format!(
                    "the load-time table of node set {set} covers {} to {} s; the run reaches {missed} s",
                    first.0, end.0
                ),
            )
            .at(reader.entry_at("YDPN/D3PNFAC", [0, set, 0]))
            .expected("a table that begins with the run and ends after the last step, with two points or more, or a single point")
            .help("in 3D the original stops at a time outside the table, and at its last time: add a point behind the end of the run"),
        );
        return;
    }
}

/// Most steps whose times are added up one by one.
const MOST_STEPS: u64 = 100_000_000;

/// The first time of a step that is not in `[first, end)`.
fn first_time_outside<const D: usize>(scene: &Scene<D>, first: f64, end: f64) -> Option<f64> {
    let control = &scene.control;
    let start = control.start_time;
    let steps = control.end_step.saturating_sub(control.first_step);
    if steps == 0 {
        return None;
    }
    if start < first || start >= end {
        return Some(start);
    }
    // as the steps add it up, unless that takes too long: rounding decides about the last only
    let mut time = start;
    if steps > MOST_STEPS {
        time += control.time_step * (steps - 1) as f64;
    } else {
        for _ in 1..steps {
            time += control.time_step;
        }
    }
    (time >= end).then_some(time)
}
