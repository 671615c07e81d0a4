use super::{Profile, Reader, classic, joints, nodes::to_i32, reader::numbers_of, solids};
use crate::scene::{Combination, Insertion, Interfaces, JointPair, Material, Scene};
use yformat::{database::Field, diagnostic::Diagnostic, source::Span};

pub(super) fn read(
    reader: &mut Reader<'_>,
    dimension: usize,
    materials: &[Material],
    profile: Profile,
) -> Option<Insertion> {
    // without materials their count or types are wrong, which has been reported
    if materials.is_empty() {
        return None;
    }
    if reader.is_classic() {
        return classic::insertion(reader, materials);
    }
    let table = reader.integer_field("YDPM/I2PMSET").filter(|f| f.item().is_some())?;
    let columns = usize::try_from(reader.integer("YDPM/MPMCOL")).unwrap_or(0);
    let records = table.given_shape().get(1).copied().unwrap_or(0);
    let combinations: Vec<Combination> = (0..records)
        .filter_map(|record| {
            combination(reader, dimension, table, record, columns, materials.len())
        })
        .collect();
    let rows = reader.integer_field("YDPM/I2PMIJ").filter(|f| f.item().is_some());
    let count = rows.map_or(0, |f| f.given_shape().get(1).copied().unwrap_or(0));
    let row = |i: usize, r: usize| rows.map_or(-1, |f| f.get2(i, r));
    let names: Vec<[i64; 2]> = (0..count).map(|r| [row(0, r), row(1, r)]).collect();
    joints::check_pairs(reader, &names, materials.len());
    // materials that do not exist have been reported and never apply
    let material = |m: i64| to_i32(m.clamp(-1, MOST_MATERIAL));
    let pairs = (0..count).map(|r| JointPair {
        materials: [material(row(0, r)), material(row(1, r))],
        joint_set: to_i32(row(2, r)),
    });
    let capacity = |name| usize::try_from(reader.integer(name)).unwrap_or(0);
    let insertion = Insertion {
        combinations,
        pairs: pairs.collect(),
        interfaces: Interfaces::Free,
        flags_free_faces: dimension == 3
            && profile == Profile::Source
            && reader.integer("YDPM/IAUTBN") != 0,
        node_capacity: capacity("YDN/MNOPO"),
        element_capacity: capacity("YDE/MELEM"),
    };
    check(reader, dimension, &insertion);
    Some(insertion)
}

fn combination(
    reader: &mut Reader<'_>,
    dimension: usize,
    table: &Field<i64>,
    record: usize,
    columns: usize,
    materials: usize,
) -> Option<Combination> {
    let (count, code) = (table.get2(0, record), table.get2(1, record));
    let room = columns.saturating_sub(2) as i64;
    if !(1..=room).contains(&count) {
        reader.report(
            Diagnostic::error(
                "scene::mesh-record",
                format!("record {record} of I2PMSET lists {count} materials in {columns} columns"),
            )
            .at(reader.entry_at("YDPM/I2PMSET", [0, record, 0]))
            .expected(format!(
                "a number of materials from 1 to {room}, then the code, then the materials"
            ))
            .help("raise /YD/YDPM/MPMCOL to 2 + the number of materials, or correct the record"),
        );
        return None;
    }
    let listed: Vec<i64> = (0..count as usize).map(|k| table.get2(2 + k, record)).collect();
    if let Some(k) = listed.iter().position(|m| !(0..materials as i64).contains(m)) {
        reader.report(
            Diagnostic::error(
                "scene::property-number",
                format!(
                    "record {record} of I2PMSET lists material {}, which does not exist",
                    listed[k]
                ),
            )
            .at(reader.entry_at("YDPM/I2PMSET", [2 + k, record, 0]))
            .expected(format!("an element property set: {}", numbers_of(materials)))
            .help("a record is `<number of materials> <code> <material> <material> ...`"),
        );
        return None;
    }
    let place = reader.entry_at("YDPM/I2PMSET", [1, record, 0]);
    if dimension == 3 {
        solids::check_digits(reader, code, place);
    } else {
        check_digits(reader, code, place);
    }
    Some(Combination { code, materials: listed.into_iter().map(|m| m as usize).collect() })
}

/// Material number beyond all that exist, small enough to count on from.
const MOST_MATERIAL: i64 = 1 << 30;

/// Largest number of triangles that refinement may come to: node numbers have 32 bits.
const MOST_TRIANGLES: u64 = i32::MAX as u64 / 3;

/// Checks that need the whole scene.
pub(super) fn check_use<const D: usize>(reader: &mut Reader<'_>, scene: &Scene<D>) {
    let Some(insertion) = &scene.insertion else { return };
    for (record, combination) in insertion.combinations.iter().enumerate().filter(|_| D == 2) {
        let triangles = combination.refined(scene.elements.len() as u64);
        if triangles > MOST_TRIANGLES {
            reader.report(
                Diagnostic::error(
                    "scene::mesh-code",
                    format!("mesh code {} makes {triangles} triangles", combination.code),
                )
                .at(code_place(reader, record, combination))
                .expected(format!("at most {MOST_TRIANGLES} triangles"))
                .help("each digit 1 makes 4 triangles of one, each digit 2 makes 6: use fewer"),
            );
            return;
        }
    }
    if insertion.changes_mesh() && scene.elements.state.is_empty() && !reader.is_classic() {
        reader.report(
            Diagnostic::note(
                "scene::original-needs",
                "the original cannot mesh without element states (MELST)",
            )
            .at(reader.word("YDPM/I2PMSET"))
            .help("add /YD/YDE/MELST 1 behind MELEM to run the deck with the original, too"),
        );
    }
}

/// Where a meshing code stands: in its record, or at its material in the classic dialect.
fn code_place(reader: &Reader<'_>, record: usize, combination: &Combination) -> Option<Span> {
    if reader.is_classic() {
        return reader.entry("YDP/I1PEMN", *combination.materials.first()?);
    }
    reader.entry_at("YDPM/I2PMSET", [1, record, 0])
}

/// Reports a meshing code with digits beyond those that mesh.
pub(super) fn check_digits(reader: &mut Reader<'_>, code: i64, place: Option<Span>) {
    if code.to_string().chars().any(|digit| !('0'..='4').contains(&digit)) {
        reader.report(
            Diagnostic::warning(
                "scene::mesh-code",
                format!("mesh code {code} has digits that do nothing"),
            )
            .at(place)
            .expected(
                "digits 1 (into 4), 2 (into 6), 3 (joints), 4 (separate), done from the right",
            ),
        );
    }
}

fn check(reader: &mut Reader<'_>, dimension: usize, insertion: &Insertion) {
    let Some(record) = insertion.combinations.iter().position(Combination::inserts_joints) else {
        return;
    };
    let place = reader.entry_at("YDPM/I2PMSET", [1, record, 0]);
    if insertion.pairs.is_empty() {
        reader.report(
            Diagnostic::error(
                "scene::joint-table",
                "joints are to be inserted, but no joint set is named for them",
            )
            .at(place)
            .expected(
                "a table of joint sets: MPMROW and I2PMIJ with rows `materialA materialB jointset`",
            ),
        );
        return;
    }
    if dimension == 3 {
        // missing rows are looked for face by face
        return;
    }
    let joined = |m: usize| insertion.pairs.iter().any(|p| p.materials == [m as i32; 2]);
    let inserting = insertion.combinations.iter().filter(|c| c.inserts_joints());
    if let Some(material) = inserting.flat_map(|c| &c.materials).copied().find(|&m| !joined(m)) {
        reader.report(
            Diagnostic::warning(
                "scene::joint-table",
                format!("I2PMIJ has no row for joints inside material {material}"),
            )
            .at(reader.word("YDPM/I2PMIJ"))
            .expected(format!("a row `{material} {material} <joint set>`"))
            .help("as in the original such a joint takes the set of the joint made before it, or none"),
        );
    }
}
