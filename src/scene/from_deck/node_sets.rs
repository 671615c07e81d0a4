use super::{
    Profile, Reader, classic, load_history,
    reader::{Offenders, numbers_of},
};
use crate::{
    TOLERANCE,
    scene::{Condition, NodeSet, Scene},
};
use nalgebra::{SMatrix, SVector};
use yformat::{diagnostic::Diagnostic, dialect::Dialect};

pub(super) fn read<const D: usize>(reader: &mut Reader<'_>, profile: Profile) -> Vec<NodeSet<D>> {
    let len = reader.count_of_sets("YDPN/NPNSET", "YDPN/MPNSET", "node sets", 0);
    check_given(reader, len);
    let codes: [_; D] = std::array::from_fn(|k| reader.integers(CODES[k], -1));
    // the other programs have no default
    let unloaded = if reader.database.dialect() == Dialect::Split { 1.0 } else { 0.0 };
    let amplitudes: [_; D] = std::array::from_fn(|k| reader.reals(AMPLITUDES[k], unloaded));
    let (pressure, traction) = (reader.reals("YDPN/D1PNAP", 0.0), reader.reals("YDPN/D1PNAT", 0.0));
    let axis_components: [[_; D]; D] = std::array::from_fn(|a| {
        std::array::from_fn(|k| reader.reals(AXES[a][k], if a == k { 1.0 } else { 0.0 }))
    });
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
            let axes = std::array::from_fn(|a| SVector::from_fn(|k, _| axis_components[a][k](set)));
            // in 3D, nodes without code are free: forces act, but no load
            let is_free = |k: usize| D == 3 && !(1..=3).contains(&codes[k](set));
            NodeSet {
                conditions: std::array::from_fn(|k| {
                    if is_free(k) { Condition::Force } else { condition(codes[k](set), absorbs) }
                }),
                amplitudes: std::array::from_fn(
                    |k| {
                        if is_free(k) { 0.0 } else { amplitudes[k](set) }
                    },
                ),
                acceleration: [0.0; D],
                pressure: pressure(set),
                traction: traction(set),
                edge_factor: if is_classic { factor(set) } else { 1.0 },
                edge_factor_step: if is_classic { factor_step(set) } else { 0.0 },
                axes: if moves(set) {
                    check_axes(reader, set, axes, profile)
                } else {
                    SMatrix::identity()
                },
                moves: moves(set),
            }
        })
        .collect::<Vec<_>>();
    if D == 3 {
        check_use_of_axes(reader, &sets);
        check_edge_loads(reader, &sets);
    } else {
        check_codes(reader, &sets);
    }
    check_amplitudes(reader, &sets);
    if is_classic {
        check_edge_factors(reader, &sets);
    } else {
        note_edge_factors(reader, D, sets.len());
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
fn check_edge_factors<const D: usize>(reader: &mut Reader<'_>, sets: &[NodeSet<D>]) {
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

fn note_edge_factors(reader: &mut Reader<'_>, dimension: usize, sets: usize) {
    let factor = reader.reals("YDPN/D1PNAF", 1.0);
    if let Some(found) = Offenders::find(sets, |set| factor(set) != 1.0) {
        reader.report(
            Diagnostic::note(
                "scene::no-effect",
                if dimension == 2 {
                    "D1PNAF has no effect in 2D: the load-time table replaces it"
                } else {
                    "D1PNAF has no effect in 3D"
                },
            )
            .at(reader.entry("YDPN/D1PNAF", found.first)),
        );
    }
}

/// Codes, amplitudes and components of the local axes, by direction.
const CODES: [&str; 3] = ["YDPN/I1PNFX", "YDPN/I1PNFY", "YDPN/I1PNFZ"];
const AMPLITUDES: [&str; 3] = ["YDPN/D1PNAX", "YDPN/D1PNAY", "YDPN/D1PNAZ"];
const AXES: [[&str; 3]; 3] = [
    ["YDPN/D1PNXX", "YDPN/D1PNXY", "YDPN/D1PNXZ"],
    ["YDPN/D1PNYX", "YDPN/D1PNYY", "YDPN/D1PNYZ"],
    ["YDPN/D1PNZX", "YDPN/D1PNZY", "YDPN/D1PNZZ"],
];

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

fn check_axes<const D: usize>(
    reader: &mut Reader<'_>,
    set: usize,
    mut axes: [SVector<f64, D>; D],
    profile: Profile,
) -> SMatrix<f64, D, D> {
    let place = |reader: &Reader<'_>| {
        (0..D).find_map(|k| reader.entry(AXES[k][k], set)).or_else(|| reader.word("YDPN/NPNSET"))
    };
    if spanned(&axes).abs() < TOLERANCE {
        let label: Vec<String> = axes
            .iter()
            .zip(["x", "y", "z"])
            .map(|(axis, name)| format!("{name} {}", words(axis)))
            .collect();
        let (space, wanted, all) = if D == 2 {
            (
                "the plane",
                "two",
                "give the x axis with D1PNXX and D1PNXY, the y axis with D1PNYX and D1PNYY; without them they are those of the scene",
            )
        } else {
            (
                "space",
                "three",
                "give the x axis with D1PNXX, D1PNXY and D1PNXZ, the y axis with D1PNYX, ..., the z axis with D1PNZX, ...; without them they are those of the scene",
            )
        };
        reader.report(
            Diagnostic::error(
                "scene::axes",
                format!("the local axes of node set {set} do not span {space}"),
            )
            .at(place(reader))
            .label(label.join(", "))
            .expected(format!("{wanted} perpendicular unit vectors"))
            .help(all),
        );
        return SMatrix::identity();
    }
    let is_unit = |a: &SVector<f64, D>| (a.norm() - 1.0).abs() <= 1e-6;
    let is_square = |a: usize, b: usize| axes[a].dot(&axes[b]).abs() <= 1e-6;
    let skew = !axes.iter().all(is_unit) || !(0..D).all(|a| (0..a).all(|b| is_square(a, b)));
    let is_split = reader.database.dialect() == Dialect::Split;
    if is_split && profile == Profile::Source {
        axes = axes.map(|a| {
            let norm = a.norm();
            a.map(|component| component / norm)
        });
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
    SMatrix::from_columns(&axes)
}

/// `(1, 0)`.
fn words<const D: usize>(axis: &SVector<f64, D>) -> String {
    let components: Vec<String> = axis.iter().map(f64::to_string).collect();
    format!("({})", components.join(", "))
}

/// Area or volume that the axes span.
fn spanned<const D: usize>(axes: &[SVector<f64, D>; D]) -> f64 {
    let a = |i: usize, k: usize| axes[i][k];
    if D == 2 {
        return a(0, 0) * a(1, 1) - a(0, 1) * a(1, 0);
    }
    (0..3).fold(0.0, |sum, i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        sum + a(0, i) * (a(1, j) * a(2, k) - a(1, k) * a(2, j))
    })
}

/// Pressure and traction act on edges of triangles.
fn check_edge_loads<const D: usize>(reader: &mut Reader<'_>, sets: &[NodeSet<D>]) {
    let lost = |set: usize| sets[set].pressure != 0.0 || sets[set].traction != 0.0;
    if let Some(found) = Offenders::find(sets.len(), lost) {
        let (load, name) = if sets[found.first].pressure == 0.0 {
            ("traction", "YDPN/D1PNAT")
        } else {
            ("pressure", "YDPN/D1PNAP")
        };
        reader.report(
            Diagnostic::warning(
                "scene::no-effect",
                format!(
                    "the {load} of node set {} has no effect in 3D{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry(name, found.first))
            .expected("0: as in the original, tetrahedra have no loads on their faces")
            .help("give the load as nodal forces (code 1 with D1PNAX, D1PNAY, D1PNAZ)"),
        );
    }
}

/// In 3D the original looks at local axes only where there is a load-time table.
fn check_use_of_axes<const D: usize>(reader: &mut Reader<'_>, sets: &[NodeSet<D>]) {
    if reader.is_given("YDPN/D3PNFAC") {
        return;
    }
    let turned = |set: usize| sets[set].axes != SMatrix::<f64, D, D>::identity();
    if let Some(found) = Offenders::find(sets.len(), turned) {
        let place = AXES.iter().flatten().find_map(|name| reader.entry(name, found.first));
        reader.report(
            Diagnostic::warning(
                "scene::axes",
                format!(
                    "the local axes of node set {} have no effect: there is no load-time table{}",
                    found.first,
                    found.more()
                ),
            )
            .at(place)
            .expected("a load-time table (NPNFACT, D3PNFAC) with factors 1, to make them act")
            .help("in 3D the original takes the global axes where D3PNFAC is not given"),
        );
    }
}

fn check_codes<const D: usize>(reader: &mut Reader<'_>, sets: &[NodeSet<D>]) {
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

fn check_amplitudes<const D: usize>(reader: &mut Reader<'_>, sets: &[NodeSet<D>]) {
    for (k, name) in AMPLITUDES.into_iter().take(D).enumerate() {
        let loaded = sets
            .iter()
            .any(|s| s.moves && s.conditions[k] != Condition::Frozen && s.amplitudes[k] != 0.0);
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

/// Checks that need the whole scene.
pub(super) fn check_use<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    check_sets_of_nodes(reader, scene);
    load_history::check_use(reader, scene);
}

fn check_sets_of_nodes<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
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
