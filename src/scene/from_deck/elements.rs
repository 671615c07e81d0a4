use super::{
    Reader,
    nodes::to_i32,
    reader::{Offenders, numbers_of},
};
use crate::scene::{BROKEN_OFFSET, Elements, JointKind, SPLIT_BROKEN, SPLIT_FREE_EDGE};
use yformat::{database::Field, diagnostic::Diagnostic, dialect::Dialect};

/// Most node numbers that an element of the table can have.
const MOST_NODES: usize = 6;
/// Most rows of the element table that state files show, whatever MELNO declares.
const MOST_ROWS: usize = 32;

pub(super) fn read(
    reader: &mut Reader<'_>,
    nodes: usize,
    materials: usize,
    laws: usize,
) -> Option<Elements> {
    let len = reader.count("YDE/NELEM", "YDE/MELEM", "elements", 1);
    let topology = reader.required_integers("YDE/I2ELTO", "elements", len);
    let property = reader.required_integers("YDE/I1ELPR", "elements", len);
    let (topology, property) = (topology?, property?);
    if len == 0 {
        return None;
    }
    let corner = |e: usize, i: usize| topology.get2(i, e);
    // without materials their count or types are wrong, which has been reported
    if check_topology(reader, topology, len, nodes) && materials > 0 {
        let is_joint = |e| corner(e, 3) >= 0;
        check_properties(reader, len, |e| property.get1(e), is_joint, materials, laws);
    }
    let tag = reader.integers("YDE/I1ELBE", -1);
    let rows = usize::try_from(reader.integer("YDE/MELNO")).unwrap_or(0);
    let state_rows = usize::try_from(reader.integer("YDE/MELST")).unwrap_or(0).min(64);
    let state = reader.real_field("YDE/D2ELST");
    let mut elements = Elements {
        table_rows: rows.min(MOST_ROWS),
        nodes: (0..len)
            .map(|e| {
                std::array::from_fn(|i| {
                    if i < rows.min(MOST_NODES) { to_i32(corner(e, i)) } else { -1 }
                })
            })
            .collect(),
        property: (0..len).map(|e| to_i32(property.get1(e))).collect(),
        contact_tag: (0..len).map(|e| to_i32(tag(e))).collect(),
        state: (0..state_rows)
            .map(|row| (0..len).map(|e| state.map_or(0.0, |s| s.get2(row, e))).collect())
            .collect(),
        joint_kind: vec![JointKind::NoJoint; len],
        fracture: vec![-1; len],
        sides: vec![[-1; 2]; len],
    };
    if reader.database.dialect() != Dialect::Classic {
        name_joints(&mut elements, reader.database.dialect());
    }
    Some(elements)
}

/// Says of each joint of the deck whether it holds: the codes of the property
/// sets tell it.
pub(super) fn name_joints(elements: &mut Elements, dialect: Dialect) {
    for e in 0..elements.len() {
        let [a, b, c, d, ..] = elements.nodes[e];
        let property = &mut elements.property[e];
        elements.joint_kind[e] = match (d >= 0, *property) {
            (false, _) => JointKind::NoJoint,
            (true, _) if (a, b) == (d, c) => JointKind::FreeEdge,
            (true, SPLIT_FREE_EDGE) => JointKind::FreeEdge,
            (true, SPLIT_BROKEN) if dialect == Dialect::Split => JointKind::Broken,
            (true, code) if code < 0 && dialect == Dialect::YGeo => {
                *property = code + BROKEN_OFFSET;
                JointKind::Broken
            }
            (true, _) => JointKind::Intact,
        };
    }
}

fn check_topology(
    reader: &mut Reader<'_>,
    topology: &Field<i64>,
    len: usize,
    nodes: usize,
) -> bool {
    let rows = topology.given_shape().first().copied().unwrap_or(0);
    if rows < 3 {
        reader.report(
            Diagnostic::error(
                "scene::short-array",
                format!("YDE/I2ELTO gives {rows} nodes for each element"),
            )
            .at(reader.length("YDE/I2ELTO", 0))
            .expected("3 nodes for each triangle, after the header `21 3 <number of elements>`"),
        );
        return false;
    }
    for i in 0..3 {
        let wrong = |e: usize| !(0..nodes as i64).contains(&topology.get2(i, e));
        if let Some(found) = Offenders::find(len, wrong) {
            let node = topology.get2(i, found.first);
            reader.report(
                Diagnostic::error(
                    "scene::node-number",
                    format!(
                        "element {} has node {node}, which does not exist{}",
                        found.first,
                        found.more()
                    ),
                )
                .at(reader.entry_at("YDE/I2ELTO", [i, found.first, 0]))
                .label(format!("node {node}"))
                .expected(format!("a node: {}", numbers_of(nodes)))
                .help("nodes are numbered from 0; check whether this deck numbers them from 1"),
            );
            return false;
        }
    }
    let wrong = |e: usize| topology.get2(3, e) >= nodes as i64;
    if let Some(found) = Offenders::find(if rows > 3 { len } else { 0 }, wrong) {
        reader.report(
            Diagnostic::error(
                "scene::node-number",
                format!(
                    "element {} has a fourth node that does not exist{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry_at("YDE/I2ELTO", [3, found.first, 0]))
            .expected(format!("-1 for triangles, {} for joints", numbers_of(nodes)))
            .help("the element table needs only 3 rows: give `21 3 <number of elements>`"),
        );
        return false;
    }
    true
}

/// Reports elements whose property does not exist.
pub(super) fn check_properties(
    reader: &mut Reader<'_>,
    len: usize,
    property: impl Fn(usize) -> i64,
    is_joint: impl Fn(usize) -> bool,
    materials: usize,
    laws: usize,
) {
    let (first_law, end) = (materials as i64, (materials + laws) as i64);
    let numbering = reader.database.dialect();
    let wrong = |e: usize| {
        let p = property(e);
        if is_joint(e) && numbering == Dialect::Classic {
            !(0..first_law).contains(&p)
        } else if is_joint(e) {
            let dead = p == i64::from(SPLIT_BROKEN)
                || p == i64::from(SPLIT_FREE_EDGE)
                || (first_law..end).contains(&(p + i64::from(BROKEN_OFFSET)));
            !dead && !(first_law..end).contains(&p)
        } else {
            !(0..first_law).contains(&p)
        }
    };
    if let Some(found) = Offenders::find(len, wrong) {
        let e = found.first;
        let code = property(e);
        let (kind, expected) = if is_joint(e) && numbering == Dialect::Classic {
            ("joint", format!("a property set: {}", numbers_of(materials)))
        } else if is_joint(e) {
            (
                "joint",
                format!("{first_law} to {} for live joints, -1000 or -1001 for dead ones", end - 1),
            )
        } else {
            let what = if numbering == Dialect::Classic { "a" } else { "an element" };
            ("triangle", format!("{what} property set: {}", numbers_of(materials)))
        };
        reader.report(
            Diagnostic::error(
                "scene::property-number",
                format!("{kind} {e} has property {code}, which does not exist{}", found.more()),
            )
            .at(reader.entry("YDE/I1ELPR", e))
            .label(format!("property {code}"))
            .expected(expected)
            .help("property sets are numbered from 0; correct I1ELPR, or raise NPROP and give the properties of that set"),
        );
    }
}
