use super::{
    Profile, Reader, classic,
    reader::{Offenders, numbers_of},
    ygeo,
};
use crate::scene::{CohesiveLaw, CohesiveModel, FailedJoints, JointPoints, RockJoint, Scene};
use yformat::{diagnostic::Diagnostic, dialect::Dialect};

/// What cohesive laws are called in findings.
const WHAT: &str = "joint property sets";

/// Arrays that the cohesive law of the classic dialect reads.
const CLASSIC_ARRAYS: [&str; 7] = [
    "YDPJ/D1PJFT",
    "YDPJ/D1PJGF",
    "YDPJ/D1PJGS",
    "YDPJ/D1PJPE",
    "YDPJ/D1PJCO",
    "YDPJ/D1PJFR",
    "YDPE/D1PEFR",
];

pub(super) fn read(reader: &mut Reader<'_>, dimension: usize) -> Vec<CohesiveLaw> {
    let len = reader.count_of_sets("YDPJ/NPJSET", "YDPJ/MPJSET", WHAT, 0);
    let real = |name| reader.reals(name, 0.0);
    let (ft, fs, gf) = (real("YDPJ/D1PJFT"), real("YDPJ/D1PJFS"), real("YDPJ/D1PJGF"));
    let one_energy = reader.database.dialect() == Dialect::Split;
    let gs = real(if one_energy { "YDPJ/D1PJGF" } else { "YDPJ/D1PJGS" });
    let layering = ygeo::layering(reader);
    let is_classic = reader.is_classic();
    let residual = real("YDPE/D1PEFR");
    let (co, fr, pe) = (real("YDPJ/D1PJCO"), real("YDPJ/D1PJFR"), real("YDPJ/D1PJPE"));
    let kind = reader.integers("YDPJ/I1PTYP", -1);
    (0..len)
        .map(|i| CohesiveLaw {
            is_cohesive: kind(i) == joint_type(dimension),
            tensile_strength: ft(i),
            shear_strength: fs(i),
            fracture_energy: gf(i),
            shear_fracture_energy: gs(i),
            // joints between tetrahedra have neither cohesion nor friction
            cohesion: if dimension == 3 { 0.0 } else { co(i) },
            friction: fr(i),
            residual_friction: if is_classic { residual(i) } else { 0.0 },
            penalty: pe(i),
            peak_strength: ft(i),
            rock: if is_classic { classic::rock_joint(reader, i) } else { RockJoint::default() },
            layering: layering(i),
        })
        .collect()
}

/// Type code of joints that carry forces.
fn joint_type(dimension: usize) -> i64 {
    if dimension == 3 { 23 } else { 3 }
}

/// Integration of joints between tetrahedra: the Windows program always takes three points.
pub(super) fn points(reader: &Reader<'_>, profile: Profile) -> JointPoints {
    match (profile, reader.integer("YDPJ/NINTPT")) {
        (Profile::Windows, _) | (Profile::Source, 3) => JointPoints::Three,
        (Profile::Source, _) => JointPoints::Seven,
    }
}

/// What becomes of joints that fail: in the plane it is the same in both programs.
pub(super) fn failed(dimension: usize, profile: Profile) -> FailedJoints {
    match (dimension, profile) {
        (3, Profile::Source) => FailedJoints::Opened,
        _ => FailedJoints::Left,
    }
}

/// Joint sets that elements of the deck have or that joint insertion can give.
fn used_sets<const D: usize>(scene: &Scene<D>) -> Vec<usize> {
    let first = scene.materials.len() as i32;
    let of_elements = scene.elements.property.iter().map(|&p| p - first);
    let inserting = scene.insertion.iter().filter(|i| i.inserts_joints());
    let of_pairs = inserting.flat_map(|i| &i.pairs).map(|pair| pair.joint_set);
    let mut used: Vec<usize> =
        of_elements.chain(of_pairs).filter_map(|set| usize::try_from(set).ok()).collect();
    // in the classic dialect every joint set acts on every joint
    if scene.conventions.cohesive == CohesiveModel::Classic && !used.is_empty() {
        used.extend(
            (0..scene.cohesive_laws.len()).filter(|&set| scene.cohesive_laws[set].is_cohesive),
        );
    }
    used.sort_unstable();
    used.dedup();
    used
}

/// Checks of the joint sets that are used.
pub(super) fn check_use<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    if let Some(insertion) = scene.insertion.as_ref().filter(|i| i.inserts_joints())
        && let Some(row) = insertion.pairs.iter().position(|pair| pair.joint_set < 0)
    {
        let set = insertion.pairs[row].joint_set;
        reader.report(
            Diagnostic::error("scene::joint-set", format!("there is no joint set {set}"))
                .at(reader.entry_at("YDPM/I2PMIJ", [2, row, 0]))
                .expected(format!("a joint set: {}", numbers_of(scene.cohesive_laws.len())))
                .help("to have no joints between two materials, leave their row out"),
        );
        return;
    }
    let sets = used_sets(scene);
    if let Some(&set) = sets.iter().find(|&&s| s >= scene.cohesive_laws.len()) {
        let pairs = scene.insertion.iter().flat_map(|i| &i.pairs);
        let row = pairs.map(|pair| pair.joint_set).position(|s| s == set as i32);
        let count = scene.cohesive_laws.len();
        reader.report(
            Diagnostic::error(
                "scene::joint-set",
                format!("joint set {set} does not exist"),
            )
            .at(row.and_then(|row| reader.entry_at("YDPM/I2PMIJ", [2, row, 0])))
            .label(format!("joint set {set}"))
            .expected(if count == 0 {
                "joint property sets (/YD/YDPJ/NPJSET and their arrays)".to_owned()
            } else {
                format!("a joint set: {}", numbers_of(count))
            })
            .help("correct the row of I2PMIJ, or raise NPJSET and give the properties of that set"),
        );
        return;
    }
    if sets.is_empty() || !check_given(reader, scene) {
        return;
    }
    for &set in &sets {
        if scene.cohesive_laws[set].is_cohesive {
            check_law(reader, set, &scene.cohesive_laws[set]);
        } else {
            report_type(reader, set, scene);
        }
    }
    let end = sets.last().map_or(0, |last| last + 1);
    for name in ["YDPJ/D1PJGF", "YDPJ/D1PJGS"] {
        reader.check_at_least(name, end, 0.0, false, "fracture energy");
    }
}

/// Whether the deck gives all arrays that the cohesive law reads.
fn check_given<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) -> bool {
    let laws = &scene.cohesive_laws;
    if reader.is_classic() {
        let needed = classic::sets_up_to(reader, &[classic::JOINT_TYPE]);
        return CLASSIC_ARRAYS
            .iter()
            .all(|name| needed == 0 || reader.required_reals(name, WHAT, needed).is_some());
    }
    let mut given = reader.required_integers("YDPJ/I1PTYP", WHAT, laws.len()).is_some();
    let mut arrays = vec!["YDPJ/D1PJFT", "YDPJ/D1PJGF", "YDPJ/D1PJPE"];
    if laws.iter().any(|law| law.cohesion <= 0.0) {
        arrays.push("YDPJ/D1PJFS");
    }
    for name in arrays.into_iter().filter(|_| laws.iter().any(|law| law.is_cohesive)) {
        given &= reader.required_reals(name, WHAT, laws.len()).is_some();
    }
    given
}

fn report_type<const D: usize>(reader: &mut Reader<'_>, set: usize, scene: &Scene<D>) {
    let kind = joint_type(D);
    let acts = reader.is_classic() && scene.cohesive_laws.iter().any(|law| law.is_cohesive);
    let (message, help) = if acts {
        (
            format!("joints have property set {set}, which has not type 3"),
            Some(
                "in this dialect all sets of type 3 act on every joint: of its own set a joint takes only D1PCOH at the start",
            ),
        )
    } else {
        (format!("joint set {set} has not type {kind}: its joints carry nothing"), None)
    };
    let called = reader.called("YDPJ/I1PTYP");
    let expected = format!("{kind}, the type of {D}D joints, in /YD/{called}");
    let finding = Diagnostic::warning("scene::joint-type", message)
        .at(reader.entry("YDPJ/I1PTYP", set).or_else(|| reader.word("YDPJ/NPJSET")))
        .expected(expected);
    reader.report(match help {
        Some(help) => finding.help(help),
        None => finding,
    });
}

fn check_law(reader: &mut Reader<'_>, set: usize, law: &CohesiveLaw) {
    for (name, quantity, value) in [
        ("YDPJ/D1PJFT", "tensile strength", law.tensile_strength),
        ("YDPJ/D1PJPE", "joint penalty", law.penalty),
    ] {
        if value <= 0.0 {
            report_value(reader, set, name, quantity, value);
        }
    }
    if law.initial_shear_strength() <= 0.0 {
        report_value(reader, set, "YDPJ/D1PJFS", "shear strength", law.initial_shear_strength());
    }
}

fn report_value(reader: &mut Reader<'_>, set: usize, name: &str, quantity: &str, value: f64) {
    let place = reader.entry(name, set).or_else(|| reader.word("YDPJ/NPJSET"));
    let called = reader.called(name);
    reader.report(
        Diagnostic::error(
            "scene::value-range",
            format!("{called}: the {quantity} of joint set {set} is {value}"),
        )
        .at(place)
        .expected(format!("a {quantity} above 0: the cohesive law divides by it"))
        .help(format!("give it with /YD/{called}")),
    );
}

/// Reports joint table rows whose materials do not exist.
pub(super) fn check_pairs(reader: &mut Reader<'_>, pairs: &[[i64; 2]], materials: usize) {
    let wrong = |row: usize| pairs[row].iter().any(|m| !(0..materials as i64).contains(m));
    if let Some(found) = Offenders::find(pairs.len(), wrong) {
        reader.report(
            Diagnostic::warning(
                "scene::joint-pair",
                format!(
                    "row {} of I2PMIJ names materials {} and {}, of which there are only {materials}{}",
                    found.first,
                    pairs[found.first][0],
                    pairs[found.first][1],
                    found.more()
                ),
            )
            .at(reader.entry_at("YDPM/I2PMIJ", [0, found.first, 0]))
            .help("such a row never applies"),
        );
    }
}
