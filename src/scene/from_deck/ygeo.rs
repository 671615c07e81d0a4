//! What only Y-Geo decks have.

use super::{
    Reader,
    reader::{Offenders, numbers_of},
};
use crate::scene::{
    ElasticLaw, Fracture, FractureNetwork, FractureTreatment, InSituStress, Isotropy, Layering,
    PairProperties, PairRow, PairRule, SeismicMethod, TransverseIsotropy,
};
use yformat::diagnostic::Diagnostic;

/// Columns of the contact table.
const PAIR_COLUMNS: usize = 5;

/// The elastic law of a property set of type `code`.
pub(super) fn elastic_law(reader: &mut Reader<'_>, set: usize, code: i64) -> ElasticLaw {
    if !reader.knows("YDPE/I1USAN") {
        return ElasticLaw::NeoHookean;
    }
    let real = |name| reader.reals(name, 0.0)(set);
    match reader.integers("YDPE/I1USAN", -1)(set) {
        kind @ (1 | 2) => {
            let young = [real("YDPE/D1PEEX"), real("YDPE/D1PEEY")];
            let poisson = [real("YDPE/D1PEMX"), real("YDPE/D1PEMY")];
            let shear = real("YDPE/D1PEG");
            let law = TransverseIsotropy { young, poisson, shear };
            check_transverse(reader, set, &law);
            ElasticLaw::Transverse(if kind == 2 { condensed(&law) } else { law })
        }
        _ => {
            let law = Isotropy { young: real("YDPE/D1PEEM"), poisson: real("YDPE/D1PENU") };
            match code {
                5 => ElasticLaw::PlaneStress(checked(reader, set, law)),
                6 => ElasticLaw::PlaneStrain(checked(reader, set, law)),
                _ => ElasticLaw::NeoHookean,
            }
        }
    }
}

/// The constants of the second formula for transverse isotropy (spec
/// `mechanics.md` 2.2, I1USAN 2).
fn condensed(law: &TransverseIsotropy) -> TransverseIsotropy {
    let [x, y] = law.poisson;
    TransverseIsotropy {
        young: [law.young[0] / (1.0 - x * y), law.young[1] / (1.0 - y * x)],
        poisson: [(x + x * y) / (1.0 - x * y), (y + x * y) / (1.0 - x * y)],
        shear: law.shear,
    }
}

fn check_transverse(reader: &mut Reader<'_>, set: usize, law: &TransverseIsotropy) {
    let product = law.poisson[0] * law.poisson[1];
    let stiff = law.young.iter().all(|&e| e > 0.0) && law.shear > 0.0;
    if !stiff || product >= 1.0 {
        reader.report(
            Diagnostic::error(
                "scene::value-range",
                format!(
                    "the transversely isotropic constants of property set {set} make no stiffness"
                ),
            )
            .at(reader.entry("YDPE/I1USAN", set))
            .expected("D1PEEX, D1PEEY and D1PEG above 0, D1PEMX times D1PEMY below 1")
            .help("set I1USAN to 0 for an isotropic material"),
        );
    }
}

fn checked(reader: &mut Reader<'_>, set: usize, law: Isotropy) -> Isotropy {
    if law.young <= 0.0 || law.poisson <= -1.0 || law.poisson >= 0.5 {
        reader.report(
            Diagnostic::error(
                "scene::value-range",
                format!(
                    "Young's modulus {} and Poisson's ratio {} of property set {set} make no stiffness",
                    law.young, law.poisson
                ),
            )
            .at(reader.entry("YDPE/D1PEEM", set).or_else(|| reader.entry("YDPE/I1PTYP", set)))
            .expected("D1PEEM above 0 and D1PENU between -1 and 0.5 for types 5 and 6"),
        );
    }
    law
}

/// The contact table.
pub(super) fn pair_table(reader: &mut Reader<'_>) -> PairRule {
    let rows = usize::try_from(reader.integer("YDPE/MPEROW")).unwrap_or(0);
    let table = reader.real_field("YDPE/D2PEINT").filter(|f| f.item().is_some());
    let given = table.map_or([0, 0], |f| {
        let shape = f.given_shape();
        [shape.first().copied().unwrap_or(0), shape.get(1).copied().unwrap_or(0)]
    });
    let Some(table) = table.filter(|_| given[0] >= PAIR_COLUMNS && given[1] >= rows && rows > 0)
    else {
        reader.report(
            Diagnostic::error("scene::pair-table", "the contact table D2PEINT is not complete")
                .at(reader.word("YDPE/D2PEINT").or_else(|| reader.word("YDPE/MPEROW")))
                .expected(format!(
                    "/YD/YDPE/MPEROW and /YD/YDPE/D2PEINT 21 5 {} with rows `set set friction penalty tangential-penalty`",
                    rows.max(1)
                ))
                .help("Y-Geo takes penalties and friction of contact from this table alone"),
        );
        return PairRule::Table(Vec::new());
    };
    let rows: Vec<PairRow> = (0..rows)
        .map(|row| PairRow {
            materials: [table.get2(0, row) as i64, table.get2(1, row) as i64],
            properties: PairProperties {
                friction: table.get2(2, row),
                penalty: table.get2(3, row),
                tangential_penalty: table.get2(4, row),
            },
        })
        .collect();
    check_pairs(reader, &rows);
    PairRule::Table(rows)
}

fn check_pairs(reader: &mut Reader<'_>, rows: &[PairRow]) {
    let sets = reader.integer("YDPE/NPROP");
    let wrong = |r: usize| {
        let [a, b] = rows[r].materials;
        a > b || a < 0 || b >= sets
    };
    if let Some(found) = Offenders::find(rows.len(), wrong) {
        let [a, b] = rows[found.first].materials;
        reader.report(
            Diagnostic::warning(
                "scene::pair-table",
                format!(
                    "row {} of D2PEINT names property sets {a} and {b}: it never applies{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry_at("YDPE/D2PEINT", [0, found.first, 0]))
            .expected("two property sets that exist, the lower number first"),
        );
    }
    let all_apply = Offenders::find(rows.len(), wrong).is_none();
    let unsound = |r: usize| {
        let p = rows[r].properties;
        p.friction > 0.0 && p.tangential_penalty <= 0.0 || p.penalty < 0.0
    };
    if let Some(found) = Offenders::find(rows.len(), unsound) {
        reader.report(
            Diagnostic::error(
                "scene::tangential-penalty",
                format!(
                    "row {} of D2PEINT has friction without tangential penalty, or a negative penalty{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry_at("YDPE/D2PEINT", [2, found.first, 0]))
            .expected("penalties of 0 or more, and a tangential penalty above 0 where there is friction"),
        );
    }
    let pairs = |a: i64, b: i64| rows.iter().any(|r| r.materials == [a, b]);
    let missing = (0..sets.min(1000))
        .flat_map(|a| (a..sets.min(1000)).map(move |b| (a, b)))
        .find(|&(a, b)| !pairs(a, b));
    if let Some((a, b)) = missing.filter(|_| all_apply) {
        reader.report(
            Diagnostic::warning(
                "scene::pair-table",
                format!("D2PEINT has no row for property sets {a} and {b}"),
            )
            .at(reader.word("YDPE/D2PEINT"))
            .expected(format!("a row `{a} {b} friction penalty tangential-penalty`"))
            .help("as in the original the pair takes what the pair before it has, at first friction 0 and penalties 2e6 and 1e6"),
        );
    }
}

/// Stress in situ, if it is used.
pub(super) fn in_situ(reader: &Reader<'_>) -> Option<InSituStress> {
    let real = |name| reader.real(name);
    (reader.integer("YDIS/IUSEIS") == 1).then(|| InSituStress {
        at_surface: ["YDIS/DCSTXX", "YDIS/DCSTXY", "YDIS/DCSTYY"].map(real),
        gradient: ["YDIS/DCSYXX", "YDIS/DCSYXY", "YDIS/DCSYYY"].map(real),
        surface: real("YDIS/DCSRFY"),
    })
}

/// How released energy is measured.
pub(super) fn seismic(reader: &Reader<'_>) -> SeismicMethod {
    match reader.integer("YDSM/IUSESM") {
        1 => SeismicMethod::Window(reader.real("YDSM/DCTWLE")),
        2 => SeismicMethod::AtFailure,
        _ => SeismicMethod::SinceYield,
    }
}

/// Strengths of layered materials, one for each joint set that has them.
pub(super) fn layering(reader: &Reader<'_>) -> impl Fn(usize) -> Option<Layering> + use<> {
    let real = |name| reader.reals(name, 0.0);
    let exponent = reader.reals("YDPJ/D1USAF", -1.0);
    let (angle, tensile) = (real("YDPJ/D1PJAL"), real("YDPJ/D1PJTR"));
    let (opening, sliding) = (real("YDPJ/D1PJGR"), real("YDPJ/D1PJSR"));
    let (cohesion, friction) = (real("YDPJ/D1PJCR"), real("YDPJ/D1PJFD"));
    let values: Vec<Option<Layering>> =
        (0..usize::try_from(reader.integer("YDPJ/NPJSET")).unwrap_or(0).min(1_000_000))
            .map(|i| {
                (exponent(i) > 0.0).then(|| Layering {
                    angle: angle(i),
                    exponent: exponent(i),
                    tensile_strength: tensile(i),
                    fracture_energy: opening(i),
                    shear_fracture_energy: sliding(i),
                    cohesion: cohesion(i),
                    friction: friction(i),
                })
            })
            .collect();
    move |i| values.get(i).copied().flatten()
}

/// The fracture network, if it is used.
pub(super) fn fracture_network(reader: &mut Reader<'_>, nodes: usize) -> Option<FractureNetwork> {
    let common = match reader.integer("YDFN/IUSEFN") {
        0 => return None,
        1 => Some(FractureTreatment::Broken),
        2 => Some(FractureTreatment::Cohesive),
        3 => None,
        other => {
            reader.report(
                Diagnostic::error(
                    "scene::fracture-network",
                    format!("IUSEFN is {other}, which is no kind of fracture network"),
                )
                .at(reader.place("YDFN/IUSEFN"))
                .expected("0 (none), 1 (broken), 2 (cohesive) or 3 (each fracture its own)"),
            );
            return None;
        }
    };
    let field = reader.integer_field("YDFN/I2DFNN").filter(|f| f.item().is_some());
    let Some(field) = field else {
        reader.report(
            Diagnostic::error("scene::fracture-network", "the fractures have no nodes")
                .at(reader.place("YDFN/IUSEFN"))
                .expected("/YD/YDFN/I2DFNN with the node numbers of each fracture, -1 to fill up"),
        );
        return None;
    };
    let shape = field.given_shape();
    let (rows, count) = (shape.first().copied().unwrap_or(0), shape.get(1).copied().unwrap_or(0));
    let real = |name, absent| reader.reals(name, absent);
    let (friction, penalty, tangential) =
        (real("YDFN/D1DFFR", -1.0), real("YDFN/D1DFPE", 0.0), real("YDFN/D1DFPT", 0.0));
    let kind = reader.integers("YDFN/I1DFFT", -1);
    let fractures: Vec<Fracture> = (0..count)
        .map(|f| Fracture {
            nodes: (0..rows).filter_map(|r| usize::try_from(field.get2(r, f)).ok()).collect(),
            contact: PairProperties {
                friction: friction(f),
                penalty: penalty(f),
                tangential_penalty: tangential(f),
            },
            treatment: match kind(f) {
                1 => FractureTreatment::Broken,
                2 => FractureTreatment::Cohesive,
                _ => FractureTreatment::Ordinary,
            },
        })
        .collect();
    let wrong = |f: usize| fractures[f].nodes.iter().any(|&n| n >= nodes);
    if let Some(found) = Offenders::find(count, wrong) {
        reader.report(
            Diagnostic::error(
                "scene::fracture-network",
                format!(
                    "fracture {} passes a node that does not exist{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry_at("YDFN/I2DFNN", [0, found.first, 0]))
            .expected(format!("nodes: {}", numbers_of(nodes))),
        );
        return None;
    }
    let network = FractureNetwork {
        common,
        fractures,
        tensile_strength: reader.real("YDFN/DDFNFT"),
        cohesion: reader.real("YDFN/DDFNCO"),
        fracture_energy: reader.real("YDFN/DDFNGF"),
        shear_fracture_energy: reader.real("YDFN/DDFNGS"),
    };
    let cohesive = (0..count).any(|f| network.treatment(f) == FractureTreatment::Cohesive);
    if cohesive && network.tensile_strength <= 0.0 {
        reader.report(
            Diagnostic::error(
                "scene::value-range",
                "cohesive fractures have no tensile strength (DDFNFT)",
            )
            .at(reader.place("YDFN/DDFNFT").or_else(|| reader.place("YDFN/IUSEFN")))
            .expected("a tensile strength above 0: the cohesive law divides by it"),
        );
    }
    Some(network)
}
