//! Checks of scenes in three dimensions: types, shapes of tetrahedra, joints between them.

use super::{
    Reader,
    geometry::{Shapes, compare_time_step},
    reader::Offenders,
};
use crate::{
    mechanics::{Vec3, tetrahedron::sixfold_volume, tetrahedron10},
    scene::{Combination, ElementKind, Insertion, ProbeQuantity, Scene},
};
use std::collections::HashMap;
use yformat::{diagnostic::Diagnostic, source::Span};

/// Six times the volume over the cube of the longest edge, below which a tetrahedron is flat.
const FLAT: f64 = 1e-12;
/// Faces of a tetrahedron.
const FACES: [[usize; 3]; 4] = [[1, 2, 3], [0, 2, 3], [0, 1, 3], [0, 1, 2]];

/// What an element type code makes of its elements in 3D.
pub(super) fn kind(reader: &mut Reader<'_>, set: usize, code: i64) -> ElementKind {
    if code == 21 {
        return ElementKind::Tetrahedron;
    }
    let (what, help) = match code {
        1 | 2 | 4 => ("the 2D element type", "triangles need NNODIM 2"),
        11 => (
            "10-node tetrahedra, type",
            "the original has neither stiffness nor mass for them: mesh with 4-node tetrahedra",
        ),
        31 => ("the shell type", "shells are not simulated: leave them out"),
        _ => ("the unknown element type", "4-node tetrahedra have type 21"),
    };
    let fault = format!("property set {set} has {what} {code} in a 3D scene");
    reader.report(
        Diagnostic::error("scene::element-type", fault)
            .at(reader.entry("YDPE/I1PTYP", set))
            .expected("21, the 4-node tetrahedron")
            .help(help),
    );
    ElementKind::Inert(code)
}

/// What a history records in 3D.
pub(super) fn quantity(reader: &mut Reader<'_>, history: usize, code: i64) -> ProbeQuantity {
    match code {
        15 => ProbeQuantity::KineticEnergy,
        18 => ProbeQuantity::ForceX,
        19 => ProbeQuantity::ForceY,
        _ => {
            reader.report(
                Diagnostic::warning(
                    "scene::history-type",
                    format!("history {history} has type {code}, which is never updated in 3D"),
                )
                .at(reader.entry("YDO/I1OHYT", history))
                .expected("15 kinetic energy, 18 force x or 19 force y"),
            );
            ProbeQuantity::NeverUpdated(code)
        }
    }
}

/// Reports a meshing code that asks for more than joints.
pub(super) fn check_digits(reader: &mut Reader<'_>, code: i64, place: Option<Span>) {
    if code.to_string().chars().any(|digit| !matches!(digit, '0' | '3')) {
        reader.report(
            Diagnostic::warning(
                "scene::mesh-code",
                format!("mesh code {code} has digits that do nothing in 3D"),
            )
            .at(place)
            .expected("3 (joints) or 0: tetrahedra are neither refined nor separated"),
        );
    }
}

impl Shapes for Scene<3> {
    fn check_shapes(&self, reader: &mut Reader<'_>) {
        let tetrahedra: Vec<usize> =
            (0..self.elements.len()).filter(|&e| self.material_of(e).is_some()).collect();
        let corners = |e: usize, x: &[Vec3]| self.elements.corners::<4>(e).map(|n| x[n]);
        let nodes = &self.nodes;
        let fine = check_repeated_nodes(reader, self, &tetrahedra)
            && check_volumes(reader, &tetrahedra, "D2NCI", |e| corners(e, &nodes.initial))
            && check_volumes(reader, &tetrahedra, "D2NCC", |e| corners(e, &nodes.current));
        if fine {
            check_time_step(reader, self, &tetrahedra);
            check_joint_rows(reader, self);
        }
    }

    fn check_places(&self, reader: &mut Reader<'_>) {
        if self.insertion.as_ref().is_some_and(Insertion::changes_mesh) {
            return;
        }
        for (history, probe) in self.probes.iter().enumerate() {
            let [x, y] = probe.point;
            let is_force = matches!(probe.quantity, ProbeQuantity::ForceX | ProbeQuantity::ForceY);
            if is_force && !self.nodes.initial.iter().any(|p| (p.x, p.y) == (x, y)) {
                reader.report(
                    Diagnostic::warning(
                        "scene::history-point",
                        format!("history {history} lies at no node: ({x}, {y})"),
                    )
                    .at(reader.entry("YDO/D1OHYX", history))
                    .expected("initial x and y of a node, exactly; z is not looked at")
                    .help("its value stays what D1OHYS gives"),
                );
            }
        }
    }

    fn check_again(&self, _reader: &mut Reader<'_>) {}
}

fn check_repeated_nodes(reader: &mut Reader<'_>, scene: &Scene<3>, bodies: &[usize]) -> bool {
    let repeated = |k: usize| {
        let corners = scene.elements.corners::<4>(bodies[k]);
        (0..4).find(|&i| corners[..i].contains(&corners[i]))
    };
    let Some(found) = Offenders::find(bodies.len(), |k| repeated(k).is_some()) else {
        return true;
    };
    let element = bodies[found.first];
    let corner = repeated(found.first).unwrap_or_default();
    reader.report(
        Diagnostic::error(
            "scene::repeated-node",
            format!("tetrahedron {element} has the same node twice{}", found.more()),
        )
        .at(reader.entry_at("YDE/I2ELTO", [corner, element, 0]))
        .label(format!("node {} again", scene.elements.nodes[element][corner]))
        .expected("four different nodes"),
    );
    false
}

/// Six times the volume over the cube of the longest edge.
fn fullness(corners: &[Vec3; 4]) -> f64 {
    let mut longest: f64 = 0.0;
    for i in 0..4 {
        for j in 0..i {
            longest = longest.max((corners[i] - corners[j]).norm());
        }
    }
    sixfold_volume(corners) / longest.powi(3)
}

fn check_volumes(
    reader: &mut Reader<'_>,
    bodies: &[usize],
    coordinates: &str,
    corners: impl Fn(usize) -> [Vec3; 4],
) -> bool {
    // coordinates that are no numbers have no volume and count as flat
    let is_flat =
        |e: usize| fullness(&corners(e)).partial_cmp(&FLAT) != Some(std::cmp::Ordering::Greater);
    let Some(found) = Offenders::find(bodies.len(), |k| is_flat(bodies[k])) else { return true };
    let element = bodies[found.first];
    let shape = corners(element);
    let volume = sixfold_volume(&shape) / 6.0;
    let (code, what, help) = if fullness(&shape) < -FLAT {
        (
            "scene::inverted-tetrahedron",
            "is inside out",
            if coordinates == "D2NCC" {
                "D2NCC turns it inside out, D2NCI does not: correct D2NCC, or leave it out to begin with D2NCI"
            } else {
                "exchange two of its nodes; the original computes nonsense with it"
            },
        )
    } else {
        (
            "scene::flat-tetrahedron",
            "has no volume",
            "its nodes lie in one plane: correct their coordinates or remove it",
        )
    };
    reader.report(
        Diagnostic::error(code, format!("tetrahedron {element} {what}{}", found.more()))
            .at(reader.entry_at("YDE/I2ELTO", [0, element, 0]))
            .label(format!("volume {volume:.3e} with the coordinates of {coordinates}"))
            .expected("four nodes of which the last three run counter-clockwise seen from outside, so that det[x1-x0, x2-x0, x3-x0] > 0")
            .help(help),
    );
    false
}

fn check_time_step(reader: &mut Reader<'_>, scene: &Scene<3>, bodies: &[usize]) {
    let mut critical: Option<(f64, usize)> = None;
    for &e in bodies {
        let material = &scene.materials[scene.elements.property[e] as usize];
        let share = match material.kind {
            ElementKind::Tetrahedron => 1.0,
            ElementKind::QuadraticTetrahedron => tetrahedron10::STABLE_SHARE,
            _ => continue,
        };
        if material.density <= 0.0 {
            continue;
        }
        let corners = scene.elements.corners::<4>(e).map(|n| scene.nodes.initial[n]);
        let double_area = |face: &[usize; 3]| {
            let [a, b, c] = face.map(|i| corners[i]);
            (b - a).cross(&(c - a)).norm()
        };
        let largest = FACES.iter().map(double_area).fold(0.0, f64::max);
        let height = sixfold_volume(&corners) / largest;
        let stiffness = material.lame_lambda + 2.0 * material.shear_modulus;
        let crossing = share * height / (stiffness / material.density).sqrt();
        if critical.is_none_or(|(least, _)| crossing < least) {
            critical = Some((crossing, e));
        }
    }
    if let Some((critical, element)) = critical {
        let element = format!("tetrahedron {element}");
        compare_time_step(reader, scene.control.time_step, critical, &element);
    }
}

/// Every face that is to get a joint needs a row of I2PMIJ; the original gives such joints
/// undefined properties. A face inside one material needs a row of that material, also where it
/// turns out to be free.
fn check_joint_rows(reader: &mut Reader<'_>, scene: &Scene<3>) {
    let Some(insertion) = &scene.insertion else { return };
    for combination in insertion.combinations.iter().filter(|c| c.inserts_joints()) {
        if let Some([p, q]) = pair_without_row(scene, insertion, combination) {
            let (what, row) = if p == q {
                (format!("inside material {p}"), format!("`{p} {p} <joint set>`"))
            } else {
                (format!("between the materials {p} and {q}"), format!("`{p} {q} <joint set>`"))
            };
            reader.report(
                Diagnostic::error(
                    "scene::joint-table",
                    format!("I2PMIJ has no row for joints {what}"),
                )
                .at(reader.word("YDPM/I2PMIJ").or_else(|| reader.word("YDPM/I2PMSET")))
                .expected(format!("a row {row}"))
                .help("the original gives such joints no defined property; to have none between two materials, list them in different records of I2PMSET"),
            );
            return;
        }
    }
}

/// The first two materials, or one, whose faces meet and that no row of the table joins.
fn pair_without_row(
    scene: &Scene<3>,
    insertion: &Insertion,
    combination: &Combination,
) -> Option<[i32; 2]> {
    let has_row = |p: i32, q: i32| {
        insertion.pairs.iter().any(|pair| pair.materials == [p, q] || pair.materials == [q, p])
    };
    let mut faces: HashMap<[i32; 3], i32> = HashMap::new();
    for e in 0..scene.elements.len() {
        let p = scene.elements.property[e];
        if !usize::try_from(p).is_ok_and(|p| combination.materials.contains(&p)) {
            continue;
        }
        if !has_row(p, p) {
            return Some([p, p]);
        }
        for face in FACES {
            let mut nodes = face.map(|i| scene.elements.nodes[e][i]);
            nodes.sort_unstable();
            if let Some(q) = faces.insert(nodes, p)
                && !has_row(p, q)
            {
                return Some([q, p]);
            }
        }
    }
    None
}
