//! Shapes: clockwise and flat triangles, nodes used twice, and whether the
//! time step can be stable.

use super::{Reader, classic_use, probes, reader::Offenders};
use crate::{
    mechanics::{Vec2, triangle::double_area},
    scene::{ElementKind, Scene},
};
use yformat::{diagnostic::Diagnostic, dialect::Dialect};

/// Twice the area over the squared longest edge, below which a triangle is flat.
const FLAT: f64 = 1e-12;

/// Checks that depend on what the bodies of a scene are made of.
pub(super) trait Shapes {
    /// Of the shapes of its elements.
    fn check_shapes(&self, reader: &mut Reader<'_>);
    /// Of what lies where in a new scene.
    fn check_places(&self, reader: &mut Reader<'_>);
    /// What else is to be checked in later stages.
    fn check_again(&self, reader: &mut Reader<'_>);
}

impl Shapes for Scene {
    fn check_shapes(&self, reader: &mut Reader<'_>) {
        check(reader, self);
    }

    fn check_places(&self, reader: &mut Reader<'_>) {
        probes::check_use(reader, self);
        if reader.is_classic() {
            classic_use::check(reader, self);
        }
    }

    fn check_again(&self, reader: &mut Reader<'_>) {
        if reader.is_classic() {
            classic_use::check_again(reader, self);
        }
    }
}

fn check(reader: &mut Reader<'_>, scene: &Scene) {
    let triangles: Vec<usize> =
        (0..scene.elements.len()).filter(|&e| scene.material_of(e).is_some()).collect();
    let corners = |e: usize, x: &[Vec2]| scene.elements.corners::<3>(e).map(|n| x[n]);
    if reader.database.dialect() != Dialect::Split {
        warn_of_clockwise(reader, scene, &triangles);
    }
    let fine = check_repeated_nodes(reader, scene, &triangles)
        && check_areas(reader, &triangles, "D2NCI", |e| corners(e, &scene.nodes.initial))
        && check_areas(reader, &triangles, "D2NCC", |e| corners(e, &scene.nodes.current));
    if fine {
        check_time_step(reader, scene, &triangles);
    }
}

fn check_repeated_nodes(reader: &mut Reader<'_>, scene: &Scene, triangles: &[usize]) -> bool {
    let repeated = |k: usize| {
        let [a, b, c] = scene.elements.corners::<3>(triangles[k]);
        a == b || b == c || c == a
    };
    let Some(found) = Offenders::find(triangles.len(), repeated) else { return true };
    let element = triangles[found.first];
    let [a, b, c] = scene.elements.corners::<3>(element);
    let second = if a == b { 1 } else { 2 };
    reader.report(
        Diagnostic::error(
            "scene::repeated-node",
            format!("triangle {element} has the same node twice{}", found.more()),
        )
        .at(reader.entry_at("YDE/I2ELTO", [second, element, 0]))
        .label(format!("node {} again", if second == 1 { b } else { c }))
        .expected("three different nodes"),
    );
    false
}

fn check_areas(
    reader: &mut Reader<'_>,
    triangles: &[usize],
    coordinates: &str,
    corners: impl Fn(usize) -> [Vec2; 3],
) -> bool {
    let flatness = |e: usize| {
        let [a, b, c] = corners(e);
        let longest =
            (b - a).norm_squared().max((c - b).norm_squared()).max((a - c).norm_squared());
        double_area(&[a, b, c]) / longest
    };
    // the split dialect alone refuses triangles that run clockwise; coordinates
    // that are no numbers have no flatness and count as flat
    let refuses = reader.database.dialect() == Dialect::Split;
    let size = |flatness: f64| if refuses { flatness } else { flatness.abs() };
    let is_flat =
        |e: usize| size(flatness(e)).partial_cmp(&FLAT) != Some(std::cmp::Ordering::Greater);
    let Some(found) = Offenders::find(triangles.len(), |k| is_flat(triangles[k])) else {
        return true;
    };
    let element = triangles[found.first];
    let area = 0.5 * double_area(&corners(element));
    let (code, what, help) = if flatness(element) < -FLAT {
        (
            "scene::clockwise-triangle",
            "runs clockwise",
            if coordinates == "D2NCC" {
                "D2NCC turns it over, D2NCI does not: correct D2NCC, or leave it out to begin with D2NCI"
            } else {
                "exchange two of its nodes; the original computes nonsense with it"
            },
        )
    } else {
        (
            "scene::flat-triangle",
            "has no area",
            "its nodes lie on one line: correct their coordinates or remove it",
        )
    };
    reader.report(
        Diagnostic::error(code, format!("triangle {element} {what}{}", found.more()))
            .at(reader.entry_at("YDE/I2ELTO", [0, element, 0]))
            .label(format!("area {area:.3e} with the coordinates of {coordinates}"))
            .expected("three nodes counter-clockwise")
            .help(help),
    );
    false
}

/// Clockwise triangles run in the classic dialect and Y-Geo, as in their programs.
fn warn_of_clockwise(reader: &mut Reader<'_>, scene: &Scene, triangles: &[usize]) {
    let nodes = &scene.nodes;
    let is_clockwise = |k: usize| {
        let corners = scene.elements.corners::<3>(triangles[k]);
        [&nodes.initial, &nodes.current]
            .into_iter()
            .any(|x| double_area(&corners.map(|n| x[n])) < 0.0)
    };
    let Some(found) = Offenders::find(triangles.len(), is_clockwise) else { return };
    let element = triangles[found.first];
    reader.report(
        Diagnostic::warning(
            "scene::clockwise-triangle",
            format!("triangle {element} runs clockwise{}", found.more()),
        )
        .at(reader.entry_at("YDE/I2ELTO", [0, element, 0]))
        .expected("three nodes counter-clockwise")
        .help("as in the original such triangles have negative mass, and nodes with negative mass never move: exchange two nodes of each"),
    );
}

fn check_time_step(reader: &mut Reader<'_>, scene: &Scene, triangles: &[usize]) {
    let mut critical: Option<(f64, usize)> = None;
    for &e in triangles {
        let material = &scene.materials[scene.elements.property[e] as usize];
        if material.kind != ElementKind::ElasticTriangle || material.density <= 0.0 {
            continue;
        }
        let [a, b, c] = scene.elements.corners::<3>(e).map(|n| scene.nodes.initial[n]);
        let longest = (b - a).norm().max((c - b).norm()).max((a - c).norm());
        let height = double_area(&[a, b, c]).abs() / longest;
        let stiffness = material.lame_lambda + 2.0 * material.shear_modulus;
        let crossing = height / (stiffness / material.density).sqrt();
        if critical.is_none_or(|(least, _)| crossing < least) {
            critical = Some((crossing, e));
        }
    }
    if let Some((critical, element)) = critical {
        compare_time_step(
            reader,
            scene.control.time_step,
            critical,
            &format!("triangle {element}"),
        );
    }
}

/// Warns of a time step beyond the smallest time that an elastic wave takes across an element:
/// its smallest height over the speed of compression waves. Explicit integration needs a
/// time step below about this; it grows without bound beyond.
pub(super) fn compare_time_step(reader: &mut Reader<'_>, dt: f64, critical: f64, element: &str) {
    if dt > critical {
        reader.report(
            Diagnostic::warning(
                "scene::unstable-time-step",
                format!("the time step {dt:e} s is longer than an elastic wave takes across {element}, {critical:.3e} s"),
            )
            .at(reader.place("YDC/DCSTEC"))
            .expected(format!("a time step below {critical:.2e} s"))
            .help("explicit integration is unstable beyond: shorten the step, or coarsen the smallest elements"),
        );
    }
}
