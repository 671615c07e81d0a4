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
    dimension: usize,
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
    if check_topology(reader, dimension, topology, len, nodes) && materials > 0 {
        // joints have more nodes than bodies
        let is_joint = |e| corner(e, dimension + 1) >= 0;
        check_properties(reader, dimension, len, |e| property.get1(e), is_joint, materials, laws);
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
        edge_nodes: Vec::new(),
        joint_kind: vec![JointKind::NoJoint; len],
        fracture: vec![-1; len],
        sides: vec![[-1; 2]; len],
    };
    if reader.database.dialect() != Dialect::Classic {
        name_joints(&mut elements, reader.database.dialect(), dimension);
    }
    Some(elements)
}

/// Says of each joint of the deck whether it holds: the codes of the property
/// sets tell it.
pub(super) fn name_joints(elements: &mut Elements, dialect: Dialect, dimension: usize) {
    for e in 0..elements.len() {
        let nodes = elements.nodes[e];
        let [a, b, c, d, ..] = nodes;
        let is_closed = if dimension == 3 { nodes[..3] == nodes[3..] } else { (a, b) == (d, c) };
        let property = &mut elements.property[e];
        elements.joint_kind[e] = match (nodes[dimension + 1] >= 0, *property) {
            (false, _) => JointKind::NoJoint,
            (true, _) if is_closed => JointKind::FreeEdge,
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

/// What the elements that are no joints are.
fn body_name(dimension: usize, plural: bool) -> &'static str {
    match (dimension, plural) {
        (3, false) => "tetrahedron",
        (3, true) => "tetrahedra",
        (_, false) => "triangle",
        (_, true) => "triangles",
    }
}

fn check_topology(
    reader: &mut Reader<'_>,
    dimension: usize,
    topology: &Field<i64>,
    len: usize,
    nodes: usize,
) -> bool {
    let rows = topology.given_shape().first().copied().unwrap_or(0);
    let corners = dimension + 1;
    let bodies = body_name(dimension, true);
    if rows < corners {
        reader.report(
            Diagnostic::error(
                "scene::short-array",
                format!("YDE/I2ELTO gives {rows} nodes for each element"),
            )
            .at(reader.length("YDE/I2ELTO", 0))
            .expected(format!(
                "{corners} nodes for each {}, after the header `21 {corners} <number of elements>`",
                body_name(dimension, false)
            )),
        );
        return false;
    }
    for i in 0..corners {
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
    // joints give all their nodes, bodies no more than their corners
    let most = if dimension == 3 { 6 } else { 4 };
    let given = |e: usize| (corners..most).filter(|&i| topology.get2(i, e) >= 0).count();
    let wrong = |e: usize| {
        let beyond = |i| topology.get2(i, e) >= nodes as i64;
        (corners..most).any(beyond) || !(given(e) == 0 || given(e) == most - corners)
    };
    if let Some(found) = Offenders::find(if rows > corners { len } else { 0 }, wrong) {
        let fault = if dimension == 2 {
            format!("element {} has a fourth node that does not exist{}", found.first, found.more())
        } else {
            format!(
                "element {} is neither tetrahedron nor joint: its fifth and sixth node do not exist or are not both given{}",
                found.first,
                found.more()
            )
        };
        reader.report(
            Diagnostic::error("scene::node-number", fault)
            .at(reader.entry_at("YDE/I2ELTO", [corners, found.first, 0]))
            .expected(format!("-1 for {bodies}, {} for joints", numbers_of(nodes)))
            .help(format!(
                "the element table needs only {corners} rows: give `21 {corners} <number of elements>`"
            )),
        );
        return false;
    }
    true
}

/// Reports elements whose property does not exist.
pub(super) fn check_properties(
    reader: &mut Reader<'_>,
    dimension: usize,
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
            (body_name(dimension, false), format!("{what} property set: {}", numbers_of(materials)))
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
