use super::{Reader, classic, nodes::to_i32, reader::numbers_of, solids, ygeo};
use crate::scene::{ElasticLaw, ElementKind, Material, Scene};
use yformat::{diagnostic::Diagnostic, dialect::Dialect};

/// Types of elastic triangles in the classic dialect.
const ELASTIC: [i64; 1] = [1];
/// Types of triangles in the classic dialect.
const TRIANGLES: [i64; 2] = [1, 2];

pub(super) fn read(reader: &mut Reader<'_>, dimension: usize) -> Vec<Material> {
    let what = if reader.is_classic() { "property sets" } else { "element property sets" };
    let len = reader.count_of_sets("YDPE/NPROP", "YDPE/MPROP", what, 1);
    let kinds = reader.required_integers("YDPE/I1PTYP", what, len);
    for (name, sets) in
        [("YDPE/D1PELA", &ELASTIC[..]), ("YDPE/D1PEMU", &ELASTIC), ("YDPE/D1PERO", &TRIANGLES)]
    {
        let needed = if reader.is_classic() { classic::sets_up_to(reader, sets) } else { len };
        let _ = reader.required_reals(name, what, needed);
    }
    for (name, quantity) in [
        ("YDPE/D1PELA", "Lamé constant"),
        ("YDPE/D1PEMU", "shear modulus"),
        ("YDPE/D1PERO", "density"),
        ("YDPE/D1PEKS", "viscosity"),
        ("YDPE/D1PEPE", "contact penalty"),
        ("YDPE/D1PEPT", "tangential contact penalty"),
        ("YDPE/D1PEFR", "friction coefficient"),
        ("YDPE/D1PBIF", "friction coefficient between sets"),
    ] {
        reader.check_at_least(name, len, 0.0, false, quantity);
    }
    let Some(kinds) = kinds else { return Vec::new() };
    let real = |name| reader.reals(name, 0.0);
    let (lambda, mu, rho, eta) =
        (real("YDPE/D1PELA"), real("YDPE/D1PEMU"), real("YDPE/D1PERO"), real("YDPE/D1PEKS"));
    let (penalty, tangential, friction, stretch) =
        (real("YDPE/D1PEPE"), real("YDPE/D1PEPT"), real("YDPE/D1PEFR"), real("YDPE/D1PSEM"));
    let fractures = reader.integers("YDPE/I1PEFR", -1);
    let joint_set = reader.integers("YDPE/I1PEJP", -1);
    let marking = reader.integers("YDPE/I1PEMB", 0);
    let interface = real("YDPE/D1PBIF");
    let support = reader.integers("YDPE/I1PSUP", -1);
    let excavated = reader.integers("YDPE/I1PEXC", -1);
    let damage_row = reader.integers("YDPE/I1PSDE", 0);
    (0..len)
        .map(|i| Material {
            kind: if dimension == 3 {
                solids::kind(reader, i, kinds.get1(i))
            } else {
                kind(reader, i, kinds.get1(i))
            },
            elastic_law: elastic_law(reader, i, kinds.get1(i)),
            lame_lambda: lambda(i),
            shear_modulus: mu(i),
            viscosity: eta(i),
            density: rho(i),
            contact_penalty: penalty(i),
            tangential_penalty: tangential(i),
            friction: friction(i),
            interface_friction: interface(i),
            is_excavated: excavated(i) == 1,
            resets_shape: support(i) == 1,
            softening_stretch: stretch(i),
            fractures: fractures(i) > 0,
            joint_set: to_i32(joint_set(i)),
            boundary_marking: to_i32(marking(i)),
            damage_row: to_i32(damage_row(i)),
        })
        .collect()
}

/// Other dialects have one law only.
fn elastic_law(reader: &mut Reader<'_>, set: usize, code: i64) -> ElasticLaw {
    match reader.database.dialect() {
        Dialect::YGeo => ygeo::elastic_law(reader, set, code),
        _ => ElasticLaw::NeoHookean,
    }
}

fn kind(reader: &mut Reader<'_>, set: usize, code: i64) -> ElementKind {
    let is_linear = |code| reader.database.dialect() == Dialect::YGeo && (5..=6).contains(&code);
    if reader.is_classic() {
        return classic::kind(reader, set, code);
    }
    match code {
        1 => ElementKind::ElasticTriangle,
        _ if is_linear(code) => ElementKind::ElasticTriangle,
        2 => ElementKind::RigidTriangle,
        4 => ElementKind::SofteningTriangle,
        11 | 21 | 31 => {
            reader.report(
                Diagnostic::error(
                    "scene::element-type",
                    format!("property set {set} has the 3D element type {code} in a 2D scene"),
                )
                .at(reader.entry("YDPE/I1PTYP", set))
                .expected("1 (elastic), 2 (rigid) or 4 (softening triangle)"),
            );
            ElementKind::Inert(code)
        }
        _ => {
            reader.report(
                Diagnostic::warning(
                    "scene::element-type",
                    format!("property set {set} has type {code}: its elements have neither stiffness nor mass"),
                )
                .at(reader.entry("YDPE/I1PTYP", set))
                .expected("1 (elastic), 2 (rigid) or 4 (softening triangle)")
                .help("nodes of such elements never move; give another type if they should"),
            );
            ElementKind::Inert(code)
        }
    }
}

/// Checks that need to know which materials are used.
pub(super) fn check_use<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    let reads_stretch = |m: &Material| {
        matches!(m.kind, ElementKind::ElasticTriangle | ElementKind::SofteningTriangle)
    };
    let original_reads_it = reader.database.dialect() == Dialect::Split;
    if original_reads_it
        && !reader.is_given("YDPE/D1PSEM")
        && scene.materials.iter().any(reads_stretch)
    {
        reader.report(
            Diagnostic::note(
                "scene::original-needs",
                "the original cannot run a deck without D1PSEM, though elastic triangles do not use it",
            )
            .at(reader.word("YDPE/NPROP"))
            .help("add /YD/YDPE/D1PSEM with a 0 for each property set to run the deck with the original, too"),
        );
    }
    for (set, material) in scene.materials.iter().enumerate() {
        let used = scene.elements.property.contains(&(set as i32));
        if !used || matches!(material.kind, ElementKind::Inert(_)) {
            continue;
        }
        if material.density == 0.0 {
            reader.report(
                Diagnostic::error(
                    "scene::no-mass",
                    format!("material {set} has no density: its nodes cannot move"),
                )
                .at(reader.entry("YDPE/D1PERO", set))
                .expected("a density above 0")
                .help(format!("give it with /YD/{}", reader.called("YDPE/D1PERO"))),
            );
        }
        if material.kind == ElementKind::SofteningTriangle {
            check_softening(reader, scene, set);
            if material.fractures && scene.conventions.dialect == Dialect::YGeo {
                reader.report(
                    Diagnostic::error(
                        "scene::not-simulated",
                        format!("softening material {set} is to fracture, which Y-Geo does with strengths that it never sets"),
                    )
                    .at(reader.entry("YDPE/I1PEFR", set))
                    .expected("0: no fracture")
                    .help("use joints for fracture"),
                );
            }
        }
    }
}

fn check_softening<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>, set: usize) {
    let material = &scene.materials[set];
    if material.softening_stretch <= 0.0 {
        reader.report(
            Diagnostic::error(
                "scene::softening",
                format!(
                    "softening material {set} has the tensile stretch {}",
                    material.softening_stretch
                ),
            )
            .at(reader.entry("YDPE/D1PSEM", set).or_else(|| reader.entry("YDPE/I1PTYP", set)))
            .expected("a stretch above 0 in /YD/YDPE/D1PSEM")
            .help("it is the stretch beyond 1 at which the triangle is damaged completely"),
        );
    }
    let row = usize::try_from(material.damage_row).ok().filter(|&r| r < scene.elements.state.len());
    if row.is_none() {
        reader.report(
            Diagnostic::error(
                "scene::softening",
                format!(
                    "softening material {set} keeps its damage in row {} of D2ELST, which does not exist",
                    material.damage_row
                ),
            )
            .at(reader.entry("YDPE/I1PSDE", set).or_else(|| reader.place("YDE/MELST")))
            .expected(format!("a row of D2ELST: {}", numbers_of(scene.elements.state.len())))
            .help("raise /YD/YDE/MELST or correct /YD/YDPE/I1PSDE"),
        );
    }
}
