use super::{
    Profile, Reader, classic,
    reader::{Offenders, numbers_of},
};
use crate::{
    TOLERANCE,
    scene::{Condition, LoadHistory, NodeSet, Scene},
};
use nalgebra::{Matrix2, Vector2};
use yformat::{diagnostic::Diagnostic, dialect::Dialect};

pub(super) fn read(reader: &mut Reader<'_>, profile: Profile) -> Vec<NodeSet<2>> {
    let len = reader.count_of_sets("YDPN/NPNSET", "YDPN/MPNSET", "node sets", 0);
    check_given(reader, len);
    let codes = [reader.integers("YDPN/I1PNFX", -1), reader.integers("YDPN/I1PNFY", -1)];
    // the other programs have no default
    let unloaded = if reader.database.dialect() == Dialect::Split { 1.0 } else { 0.0 };
    let amplitudes = [reader.reals("YDPN/D1PNAX", unloaded), reader.reals("YDPN/D1PNAY", unloaded)];
    let (pressure, traction) = (reader.reals("YDPN/D1PNAP", 0.0), reader.reals("YDPN/D1PNAT", 0.0));
    let x_axis = [reader.reals("YDPN/D1PNXX", 1.0), reader.reals("YDPN/D1PNXY", 0.0)];
    let y_axis = [reader.reals("YDPN/D1PNYX", 0.0), reader.reals("YDPN/D1PNYY", 1.0)];
    let absorbs = absorbs(reader);
    let is_classic = reader.is_classic();
    let kind = reader.integers("YDPE/I1PTYP", 0);
    let moves = |set: usize| !is_classic || kind(set) == NODE_SET;
    let (factor, factor_step) = (
        reader.reals("YDPN/D1PNAF", if is_classic { 0.0 } else { 1.0 }),
        reader.reals("YDPN/D1PNAI", 0.0),
    );
    let sets = (0..len)
        .map(|set| {
            let axes = [
                Vector2::new(x_axis[0](set), x_axis[1](set)),
                Vector2::new(y_axis[0](set), y_axis[1](set)),
            ];
            NodeSet {
                conditions: [condition(codes[0](set), absorbs), condition(codes[1](set), absorbs)],
                amplitudes: [amplitudes[0](set), amplitudes[1](set)],
                pressure: pressure(set),
                traction: traction(set),
                edge_factor: if is_classic { factor(set) } else { 1.0 },
                edge_factor_step: if is_classic { factor_step(set) } else { 0.0 },
                axes: if moves(set) {
                    check_axes(reader, set, axes, profile)
                } else {
                    Matrix2::identity()
                },
                moves: moves(set),
            }
        })
        .collect::<Vec<_>>();
    check_codes(reader, &sets);
    check_amplitudes(reader, &sets);
    if is_classic {
        check_edge_factors(reader, &sets);
    } else {
        note_edge_factors(reader, sets.len());
    }
    sets
}

/// The classic dialect has no values for arrays that are not given.
fn check_given(reader: &mut Reader<'_>, len: usize) {
    let needed = classic::sets_up_to(reader, &[NODE_SET]).min(len);
    if !reader.is_classic() || needed == 0 {
        return;
    }
    for name in ["YDPN/I1PNFX", "YDPN/I1PNFY"] {
        let _ = reader.required_integers(name, "property sets of nodes", needed);
    }
    for name in ["YDPN/D1PNAX", "YDPN/D1PNAY"] {
        let _ = reader.required_reals(name, "property sets of nodes", needed);
    }
}

/// Pressure and traction are multiplied by a factor that is 0 where the deck gives none.
fn check_edge_factors(reader: &mut Reader<'_>, sets: &[NodeSet<2>]) {
    let lost = |set: usize| {
        let set = &sets[set];
        (set.pressure != 0.0 || set.traction != 0.0)
            && set.edge_factor == 0.0
            && set.edge_factor_step == 0.0
    };
    if let Some(found) = Offenders::find(sets.len(), lost) {
        let (load, name) = if sets[found.first].pressure == 0.0 {
            ("traction", "YDPN/D1PNAT")
        } else {
            ("pressure", "YDPN/D1PNAP")
        };
        let factor = reader.called("YDPN/D1PNAF");
        reader.report(
            Diagnostic::warning(
                "scene::edge-factor",
                format!(
                    "the {load} of property set {} does nothing: its factor D1PNAF is 0{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader
                .entry("YDPN/D1PNAF", found.first)
                .or_else(|| reader.entry(name, found.first)))
            .expected(format!("1 in /YD/{factor}, or a growth per step in D1PNAI"))
            .help(if reader.is_given("YDPN/D1PNAF") {
                "pressure and traction are multiplied by D1PNAF"
            } else {
                "pressure and traction are multiplied by D1PNAF, without which the original cannot run"
            }),
        );
    }
}

fn note_edge_factors(reader: &mut Reader<'_>, sets: usize) {
    let factor = reader.reals("YDPN/D1PNAF", 1.0);
    if let Some(found) = Offenders::find(sets, |set| factor(set) != 1.0) {
        reader.report(
            Diagnostic::note(
                "scene::no-effect",
                "D1PNAF has no effect in 2D: the load-time table replaces it",
            )
            .at(reader.entry("YDPN/D1PNAF", found.first)),
        );
    }
}

/// Type of the property sets of nodes in the classic dialect's common table.
const NODE_SET: i64 = -1;

/// Whether code 4 makes nodes absorbing.
fn absorbs(reader: &Reader<'_>) -> bool {
    reader.database.dialect() == Dialect::YGeo
}

fn condition(code: i64, absorbs: bool) -> Condition {
    match code {
        1 => Condition::Force,
        2 => Condition::Acceleration,
        3 => Condition::Velocity,
        4 if absorbs => Condition::Absorbing,
        _ => Condition::Frozen,
    }
}

fn check_axes(
    reader: &mut Reader<'_>,
    set: usize,
    mut axes: [Vector2<f64>; 2],
    profile: Profile,
) -> Matrix2<f64> {
    let place = |reader: &Reader<'_>| {
        reader.entry("YDPN/D1PNXX", set).or_else(|| reader.entry("YDPN/D1PNYY", set))
    };
    let cross = axes[0].x * axes[1].y - axes[0].y * axes[1].x;
    if cross.abs() < TOLERANCE {
        reader.report(
            Diagnostic::error(
                "scene::axes",
                format!("the local axes of node set {set} do not span the plane"),
            )
            .at(place(reader))
            .label(format!("x ({}, {}), y ({}, {})", axes[0].x, axes[0].y, axes[1].x, axes[1].y))
            .expected("two perpendicular unit vectors")
            .help("give the x axis with D1PNXX and D1PNXY, the y axis with D1PNYX and D1PNYY; without them they are those of the scene"),
        );
        return Matrix2::identity();
    }
    let skew =
        axes.iter().any(|a| (a.norm() - 1.0).abs() > 1e-6) || axes[0].dot(&axes[1]).abs() > 1e-6;
    let is_split = reader.database.dialect() == Dialect::Split;
    if is_split && profile == Profile::Source {
        axes = axes.map(|a| Vector2::new(a.x / a.norm(), a.y / a.norm()));
    } else if skew {
        reader.report(
            Diagnostic::warning(
                "scene::axes",
                format!("the local axes of node set {set} are not perpendicular unit vectors"),
            )
            .at(place(reader))
            .help(if is_split {
                "as in the Windows program they are taken as they are and scale the motion; `--profile source` normalises them"
            } else {
                "as in the original they are taken as they are and scale the motion"
            }),
        );
    }
    Matrix2::from_columns(&axes)
}

fn check_codes(reader: &mut Reader<'_>, sets: &[NodeSet<2>]) {
    let len = sets.len();
    for (name, axis) in [("YDPN/I1PNFX", "x"), ("YDPN/I1PNFY", "y")] {
        // in the classic dialect that is an error
        if len > 0 && !reader.is_given(name) && !reader.is_classic() {
            reader.report(
                Diagnostic::warning(
                    "scene::frozen-nodes",
                    format!("{name} is not given: all nodes are frozen along {axis}"),
                )
                .at(reader.word("YDPN/NPNSET"))
                .expected("1 (force), 2 (acceleration) or 3 (velocity) for each node set")
                .help("in 2D a set without code keeps its velocity whatever the forces"),
            );
        }
        let code = reader.integers(name, -1);
        let last = if absorbs(reader) { 4 } else { 3 };
        if let Some(found) = Offenders::find(len, |set| sets[set].moves && code(set) > last) {
            let value = code(found.first);
            let meaning = if value == 4 { " (absorbing boundary in Y-Geo)" } else { "" };
            reader.report(
                Diagnostic::warning(
                    "scene::frozen-nodes",
                    format!(
                        "code {value}{meaning} of node set {} freezes its nodes along {axis}{}",
                        found.first,
                        found.more()
                    ),
                )
                .at(reader.entry(name, found.first))
                .expected("1 (force), 2 (acceleration), 3 (velocity) or 0 (frozen)"),
            );
        }
    }
}

fn check_amplitudes(reader: &mut Reader<'_>, sets: &[NodeSet<2>]) {
    for (k, name) in ["YDPN/D1PNAX", "YDPN/D1PNAY"].into_iter().enumerate() {
        let loaded = sets.iter().any(|s| s.moves && s.conditions[k] != Condition::Frozen);
        let default_is_one = reader.database.dialect() == Dialect::Split;
        if loaded && default_is_one && !reader.is_given(name) {
            reader.report(
                Diagnostic::warning(
                    "scene::default-amplitude",
                    format!("{name} is not given: every amplitude is 1"),
                )
                .at(reader.word("YDPN/NPNSET"))
                .help(format!("add /YD/{name} with a 0 for each node set without load")),
            );
        }
    }
}

/// The load-time table of the node sets, if there is one.
pub(super) fn read_load_history(reader: &mut Reader<'_>, sets: usize) -> Option<LoadHistory> {
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

/// Checks that need the whole scene.
pub(super) fn check_use(reader: &mut Reader<'_>, scene: &Scene) {
    check_sets_of_nodes(reader, scene);
    check_coverage(reader, scene);
}

fn check_sets_of_nodes(reader: &mut Reader<'_>, scene: &Scene) {
    let sets = scene.node_sets.len() as i32;
    let set_of = &scene.nodes.set;
    if let Some(found) = Offenders::find(set_of.len(), |n| !(0..sets).contains(&set_of[n])) {
        reader.report(
            Diagnostic::warning(
                "scene::node-set",
                format!(
                    "node {} belongs to set {}, which does not exist: it never moves{}",
                    found.first,
                    set_of[found.first],
                    found.more()
                ),
            )
            .at(reader.entry("YDN/I1NOPR", found.first))
            .expected(if reader.is_classic() {
                "a property set of type -1 (nodes)".to_owned()
            } else if sets == 0 {
                "node sets: /YD/YDPN/MPNSET, NPNSET and their arrays".to_owned()
            } else {
                format!("a node set: {}", numbers_of(scene.node_sets.len()))
            })
            .help(if reader.is_classic() {
                "property sets are numbered from 0; correct I1NOPR, or raise NPROP"
            } else {
                "node sets are numbered from 0; correct I1NOPR, or raise NPNSET"
            }),
        );
    }
}

fn check_coverage(reader: &mut Reader<'_>, scene: &Scene) {
    let Some(history) = scene.load_history.as_ref().filter(|h| h.is_active()) else { return };
    let control = &scene.control;
    let steps = control.end_step.saturating_sub(control.first_step);
    let last = control.start_time + control.time_step * steps.saturating_sub(1) as f64;
    let loaded = |set: &NodeSet<2>| {
        let [x, y] =
            [0, 1].map(|k| set.conditions[k] != Condition::Frozen && set.amplitudes[k] != 0.0);
        x || y || set.pressure != 0.0 || set.traction != 0.0
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
