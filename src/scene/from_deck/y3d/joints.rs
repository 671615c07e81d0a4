use super::{Reader, materials::JOINT};
use crate::scene::{
    CohesiveLaw, Combination, ElementKind, Elements, Insertion, Interfaces, JointPair, Material,
    RockJoint, Scene, from_deck::nodes::to_i32,
};
use yformat::diagnostic::Diagnostic;

/// Mesh code that inserts joints.
const INSERT: i64 = 3;

/// A cohesive law for each property set (spec `y3d.md` 4.3); those of type 15 act.
pub(super) fn read(reader: &mut Reader<'_>) -> Vec<CohesiveLaw> {
    let len = usize::try_from(reader.integer("YDP/NPROP")).unwrap_or(0);
    let kind = reader.integers("YDP/I1PTYP", -1);
    let real = |name| reader.reals(name, 0.0);
    let (strength, penalty) = (real("YDP/D1PEFT"), real("YDP/D1PEPE"));
    let (cohesion, friction) = (real("YDP/D1PCOH"), real("YDP/D1PICF"));
    // old decks have one energy for both modes
    let of_mode = |name| if reader.is_given(name) { real(name) } else { real("YDP/D1PEGF") };
    let (opening, sliding) = (of_mode("YDP/D1PEGFN"), of_mode("YDP/D1PEGFS"));
    (0..len.min(1_000_000))
        .map(|i| CohesiveLaw {
            is_cohesive: kind(i) == JOINT,
            tensile_strength: strength(i),
            shear_strength: cohesion(i),
            fracture_energy: opening(i),
            shear_fracture_energy: sliding(i),
            cohesion: cohesion(i),
            friction: friction(i),
            residual_friction: 0.0,
            penalty: penalty(i),
            peak_strength: strength(i),
            rock: RockJoint::default(),
            layering: None,
        })
        .collect()
}

/// Joints between all elements of property sets with the mesh code 3; two sets are joined by the
/// higher of the two sets that they name (spec `y3d.md` 4.1).
pub(super) fn insertion(
    reader: &mut Reader<'_>,
    materials: &[Material],
    elements: &Elements,
) -> Option<Insertion> {
    let code = reader.integers("YDP/I1PEMN", 0);
    let named = reader.integers("YDP/I1PEJP", 0);
    let used: Vec<usize> =
        (0..materials.len()).filter(|&m| elements.property.contains(&(m as i32))).collect();
    if let Some(&set) = used.iter().find(|&&set| !matches!(code(set), 0 | INSERT)) {
        reader.report(
            Diagnostic::error(
                "scene::mesh-code",
                format!("mesh code {} of property set {set} is not simulated", code(set)),
            )
            .at(reader.entry("YDP/I1PEMN", set))
            .expected("0 or 3 (joints)"),
        );
        return None;
    }
    let joined: Vec<usize> = used.into_iter().filter(|&set| code(set) == INSERT).collect();
    if joined.is_empty() {
        return None;
    }
    let is_linear = |set: &&usize| materials[**set].kind != ElementKind::Tetrahedron;
    if let Some(&set) = joined.iter().find(is_linear) {
        reader.report(
            Diagnostic::error(
                "scene::not-simulated",
                format!("property set {set} asks for joints between ten-node tetrahedra"),
            )
            .at(reader.entry("YDP/I1PEMN", set))
            .expected("0, or 4-node tetrahedra (type 13): joints are for these only"),
        );
        return None;
    }
    let mut pairs = Vec::new();
    for (i, &p) in joined.iter().enumerate() {
        for &q in &joined[..=i] {
            let joint_set = to_i32(named(p).max(named(q)));
            pairs.push(JointPair { materials: [q as i32, p as i32], joint_set });
        }
    }
    let capacity = |name| usize::try_from(reader.integer(name)).unwrap_or(0);
    Some(Insertion {
        combinations: vec![Combination { code: INSERT, materials: joined }],
        pairs,
        interfaces: Interfaces::Free,
        flags_free_faces: false,
        node_capacity: capacity("YDN/MNOPO"),
        element_capacity: capacity("YDE/MELEM"),
    })
}

/// Checks of the joint sets that insertion uses.
pub(super) fn check_use(reader: &mut Reader<'_>, scene: &Scene<3>) {
    let Some(insertion) = &scene.insertion else { return };
    let mut sets: Vec<i32> = insertion.pairs.iter().map(|pair| pair.joint_set).collect();
    sets.sort_unstable();
    sets.dedup();
    for set in sets {
        let law = usize::try_from(set).ok().and_then(|set| scene.cohesive_laws.get(set));
        let Some(law) = law.filter(|law| law.is_cohesive) else {
            let named = reader.integers("YDP/I1PEJP", 0);
            let by = (0..scene.materials.len()).find(|&m| named(m) == i64::from(set));
            reader.report(
                Diagnostic::error(
                    "scene::joint-set",
                    format!("joints are to have property set {set}, which is none of joints"),
                )
                .at(by.and_then(|m| reader.entry("YDP/I1PEJP", m)))
                .expected("a property set of type 15"),
            );
            return;
        };
        let index = set as usize;
        for (name, quantity, value) in [
            ("YDP/D1PEFT", "tensile strength", law.tensile_strength),
            ("YDP/D1PEPE", "penalty", law.penalty),
            ("YDP/D1PCOH", "cohesion", law.cohesion),
        ] {
            if value <= 0.0 {
                reader.report(
                    Diagnostic::error(
                        "scene::value-range",
                        format!("{name}: the {quantity} of joint set {set} is {value}"),
                    )
                    .at(reader.entry(name, index).or_else(|| reader.word("YDP/NPROP")))
                    .expected(format!("a {quantity} above 0: the cohesive law divides by it")),
                );
            }
        }
    }
}
