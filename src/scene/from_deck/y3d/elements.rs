use super::{super::nodes::to_i32, Reader, materials::JOINT};
use crate::{
    mechanics::{Vec3, tetrahedron::sixfold_volume, tetrahedron10},
    scene::from_deck::reader::{Offenders, numbers_of},
    scene::{ElementKind, Elements, JointKind, Material, Nodes, Scene},
};
use yformat::diagnostic::Diagnostic;

/// Rows of the element table with a body number behind four or ten nodes.
const ROWS: [i64; 2] = [5, 11];
/// Most rows of the element table that state files show, whatever MELNO declares.
const MOST_ROWS: usize = 32;

/// Elements: tetrahedra with four or ten nodes and their body.
pub(super) fn read(
    reader: &mut Reader<'_>,
    nodes: usize,
    materials: &[Material],
) -> Option<Elements> {
    let len = reader.count("YDE/NELEM", "YDE/MELEM", "elements", 1);
    let topology = reader.required_integers("YDE/I2ELTO", "elements", len)?;
    let property = reader.required_integers("YDE/I1ELPR", "elements", len)?;
    // types that are not simulated have been reported
    if len == 0 || materials.is_empty() || materials.iter().any(is_unknown) {
        return None;
    }
    let rows = topology.given_shape().first().copied().unwrap_or(0);
    if !ROWS.contains(&(rows as i64)) {
        reader.report(
            Diagnostic::error(
                "scene::short-array",
                format!("YDE/I2ELTO gives {rows} numbers for each element"),
            )
            .at(reader.length("YDE/I2ELTO", 0))
            .expected("5 (four nodes and the body number) or 11 (ten nodes and the body number)")
            .help("the header is `21 <numbers of an element> <number of elements>`"),
        );
        return None;
    }
    let kind = |e: usize| usize::try_from(property.get1(e)).ok().and_then(|p| materials.get(p));
    let is_body = |m: &Material| !matches!(m.kind, ElementKind::Inert(_));
    if let Some(found) = Offenders::find(len, |e| !kind(e).is_some_and(is_body)) {
        let e = found.first;
        let set = property.get1(e);
        reader.report(
            Diagnostic::error(
                "scene::property-number",
                format!(
                    "element {e} has property set {set}, which is none of tetrahedra{}",
                    found.more()
                ),
            )
            .at(reader.entry("YDE/I1ELPR", e))
            .expected(format!("a property set of type 11 or 13: {}", numbers_of(materials.len())))
            .help("joints are inserted (I1PEMN 3), not given; property sets are numbered from 0"),
        );
        return None;
    }
    let is_quadratic =
        |e: usize| kind(e).is_some_and(|m| m.kind == ElementKind::QuadraticTetrahedron);
    let needed = |e: usize| if is_quadratic(e) { tetrahedron10::NODES } else { 4 };
    if let Some(found) = Offenders::find(len, |e| needed(e) > rows - 1) {
        reader.report(
            Diagnostic::error(
                "scene::short-array",
                format!("element {} has type 11, but only four nodes{}", found.first, found.more()),
            )
            .at(reader.length("YDE/I2ELTO", 0))
            .expected("11 numbers for each element: ten nodes and the body number"),
        );
        return None;
    }
    let exists = |n: i64| (0..nodes as i64).contains(&n);
    let wrong = |e: usize| (0..needed(e)).find(|&i| !exists(topology.get2(i, e)));
    if let Some(found) = Offenders::find(len, |e| wrong(e).is_some()) {
        let corner = wrong(found.first).unwrap_or(0);
        let node = topology.get2(corner, found.first);
        reader.report(
            Diagnostic::error(
                "scene::node-number",
                format!(
                    "element {} has node {node}, which does not exist{}",
                    found.first,
                    found.more()
                ),
            )
            .at(reader.entry_at("YDE/I2ELTO", [corner, found.first, 0]))
            .label(format!("node {node}"))
            .expected(format!("a node: {}", numbers_of(nodes)))
            .help(
                "nodes are numbered from 0 in .Y3D decks, from 1 in the files of the preprocessor",
            ),
        );
        return None;
    }
    let any_quadratic = (0..len).any(is_quadratic);
    let tag = reader.integers("YDE/I1ELBE", -1);
    let declared = usize::try_from(reader.integer("YDE/MELNO")).unwrap_or(0);
    let number = |e: usize, i: usize| to_i32(topology.get2(i, e));
    Some(Elements {
        table_rows: declared.min(MOST_ROWS),
        nodes: (0..len)
            .map(|e| std::array::from_fn(|i| if i < 4 { number(e, i) } else { -1 }))
            .collect(),
        edge_nodes: if any_quadratic {
            (0..len)
                .map(|e| {
                    std::array::from_fn(|i| if is_quadratic(e) { number(e, 4 + i) } else { -1 })
                })
                .collect()
        } else {
            Vec::new()
        },
        property: (0..len).map(|e| to_i32(property.get1(e))).collect(),
        joint_kind: vec![JointKind::NoJoint; len],
        fracture: vec![-1; len],
        sides: vec![[-1; 2]; len],
        contact_tag: (0..len).map(|e| to_i32(tag(e))).collect(),
        state: Vec::new(),
    })
}

/// Whether a property set has a type that is not simulated.
fn is_unknown(material: &Material) -> bool {
    matches!(material.kind, ElementKind::Inert(code) if code != JOINT)
}

/// Turns tetrahedra that are inside out by an exchange of their nodes 2 and 3 (spec `y3d.md` 1.9).
pub(super) fn turn_inverted(reader: &mut Reader<'_>, elements: &mut Elements, nodes: &Nodes<3>) {
    let volume = |elements: &Elements, e: usize, places: &[Vec3]| {
        sixfold_volume(&elements.corners::<4>(e).map(|n| places[n]))
    };
    let inverted: Vec<usize> =
        (0..elements.len()).filter(|&e| volume(elements, e, &nodes.initial) < 0.0).collect();
    for &e in &inverted {
        elements.nodes[e].swap(2, 3);
        if let Some(edges) = elements.edge_nodes.get_mut(e) {
            // (1,2) with (1,3), (2,0) with (0,3)
            edges.swap(1, 4);
            edges.swap(2, 3);
        }
    }
    if let Some(found) = Offenders::find(inverted.len(), |_| true) {
        let element = inverted[found.first];
        reader.report(
            Diagnostic::warning(
                "scene::inverted-tetrahedron",
                format!(
                    "tetrahedron {element} is inside out: its nodes 2 and 3 are exchanged{}",
                    found.more()
                ),
            )
            .at(reader.entry_at("YDE/I2ELTO", [2, element, 0]))
            .expected("four nodes with det[x1-x0, x2-x0, x3-x0] > 0")
            .help("Solidity exchanges them, too; VGW computes nonsense"),
        );
    }
}

/// Reports ten-node tetrahedra whose edges are curved so much that they have no volume somewhere.
pub(super) fn check_edges(reader: &mut Reader<'_>, scene: &Scene<3>) {
    let elements = &scene.elements;
    let quadratic: Vec<usize> = (0..elements.edge_nodes.len())
        .filter(|&e| elements.edge_nodes[e].iter().all(|&n| n >= 0))
        .collect();
    for (name, places) in [("D2NCI", &scene.nodes.initial), ("D2NCC", &scene.nodes.current)] {
        let least = |e: usize| {
            let nodes = elements.all_nodes(e).map(|n| places[n]);
            tetrahedron10::ReferenceShape::new(&nodes).least_jacobian
        };
        // coordinates that are no numbers have no volume
        let wrong =
            |k: usize| least(quadratic[k]).partial_cmp(&0.0) != Some(std::cmp::Ordering::Greater);
        if let Some(found) = Offenders::find(quadratic.len(), wrong) {
            let element = quadratic[found.first];
            reader.report(
                Diagnostic::error(
                    "scene::inverted-tetrahedron",
                    format!("the ten-node tetrahedron {element} is inside out somewhere{}", found.more()),
                )
                .at(reader.entry_at("YDE/I2ELTO", [4, element, 0]))
                .label(format!("with the coordinates of {name}"))
                .expected("nodes 4 to 9 near the middles of the edges (0,1), (1,2), (2,0), (0,3), (1,3), (2,3)")
                .help("check the order of these nodes; it is that of VTK and GiD"),
            );
            return;
        }
    }
}
