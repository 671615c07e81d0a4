use super::Reader;
use crate::scene::{ElasticLaw, ElementKind, JointKind, Material, Scene};
use yformat::diagnostic::Diagnostic;

/// Type codes (spec `y3d.md` 1.8).
const QUADRATIC: i64 = 11;
const LINEAR: i64 = 13;
pub(super) const JOINT: i64 = 15;

/// What VGW makes of D1PEPE before its factor 6 (spec `y3d.md` 3.3), so that a potential of 1
/// presses with 0.06 D1PEPE.
const PENALTY_SHARE: f64 = 0.01;
/// Tangential against normal penalty (spec `y3d.md` 3.4).
const TANGENTIAL_SHARE: f64 = 2.0 / 7.0;

/// All property sets, those of joints as elements without mechanics.
pub(super) fn read(reader: &mut Reader<'_>) -> Vec<Material> {
    let what = "property sets";
    let len = reader.count_of_sets("YDP/NPROP", "YDP/MPROP", what, 1);
    let kinds = reader.required_integers("YDP/I1PTYP", what, len);
    for name in ["YDP/D1PELA", "YDP/D1PEMU", "YDP/D1PERO"] {
        let _ = reader.required_reals(name, what, len);
    }
    for (name, quantity) in [
        ("YDP/D1PELA", "Lamé constant"),
        ("YDP/D1PEMU", "shear modulus"),
        ("YDP/D1PERO", "density"),
        ("YDP/D1PEKS", "viscosity"),
        ("YDP/D1PEPE", "penalty"),
        ("YDP/D1PEFR", "friction coefficient"),
    ] {
        reader.check_at_least(name, len, 0.0, false, quantity);
    }
    let Some(kinds) = kinds else { return Vec::new() };
    let real = |name| reader.reals(name, 0.0);
    let (lambda, mu, rho, eta) =
        (real("YDP/D1PELA"), real("YDP/D1PEMU"), real("YDP/D1PERO"), real("YDP/D1PEKS"));
    let (penalty, friction) = (real("YDP/D1PEPE"), real("YDP/D1PEFR"));
    (0..len)
        .map(|i| Material {
            kind: kind(reader, i, kinds.get1(i)),
            elastic_law: ElasticLaw::NeoHookean,
            lame_lambda: lambda(i),
            shear_modulus: mu(i),
            viscosity: eta(i),
            density: rho(i),
            contact_penalty: penalty(i) * PENALTY_SHARE,
            tangential_penalty: penalty(i) * PENALTY_SHARE * TANGENTIAL_SHARE,
            friction: friction(i),
            interface_friction: 0.0,
            is_excavated: false,
            resets_shape: false,
            softening_stretch: 0.0,
            fractures: false,
            joint_set: -1,
            boundary_marking: 0,
            damage_row: 0,
        })
        .collect()
}

fn kind(reader: &mut Reader<'_>, set: usize, code: i64) -> ElementKind {
    let help = match code {
        LINEAR => return ElementKind::Tetrahedron,
        QUADRATIC => return ElementKind::QuadraticTetrahedron,
        JOINT => return ElementKind::Inert(code),
        10 => {
            "the linear elastic tetrahedron is switched off in all programs: 13 has the same stiffness at small strain"
        }
        14 => {
            "the softening tetrahedron has no mechanics in any program: use joints (15) for fracture"
        }
        21 | 23 => {
            "codes 21 and 23 belong to another branch (and to the split dialect): 4-node tetrahedra are 13 here, joints 15"
        }
        _ => "correct I1PTYP",
    };
    reader.report(
        Diagnostic::error(
            "scene::element-type",
            format!("property set {set} has the element type {code}, which is not simulated"),
        )
        .at(reader.entry("YDP/I1PTYP", set))
        .expected("13 (4-node tetrahedron), 11 (10-node tetrahedron) or 15 (joint)")
        .help(help),
    );
    ElementKind::Inert(code)
}

/// Checks that need to know which materials are used.
pub(super) fn check_use(reader: &mut Reader<'_>, scene: &Scene<3>) {
    let bodies = |set: usize| {
        let elements = &scene.elements;
        (0..elements.len()).any(|e| {
            elements.joint_kind[e] == JointKind::NoJoint && elements.property[e] == set as i32
        })
    };
    for set in (0..scene.materials.len()).filter(|&set| bodies(set)) {
        if scene.materials[set].density == 0.0 {
            reader.report(
                Diagnostic::error(
                    "scene::no-mass",
                    format!("material {set} has no density: its nodes cannot move"),
                )
                .at(reader.entry("YDP/D1PERO", set))
                .expected("a density above 0")
                .help("give it with /YD/YDP/D1PERO"),
            );
        }
    }
    let is_quadratic = !scene.elements.edge_nodes.is_empty();
    let passes = reader.integer("YDC/INITER");
    if passes != 0 {
        let message = format!(
            "INITER is {passes}, but the iteration for the consistent mass is not simulated: masses are lumped"
        );
        let finding = if is_quadratic {
            Diagnostic::error("scene::not-simulated", message)
        } else {
            Diagnostic::warning("scene::no-effect", message)
        };
        let help = if reader.is_given("YDC/INITER") {
            "set /YD/YDC/INITER to 0"
        } else {
            "without INITER it is 2: give /YD/YDC/INITER 0"
        };
        let place = reader.place("YDC/INITER");
        reader.report(finding.at(place).expected("0, lumped masses").help(help));
    }
}
