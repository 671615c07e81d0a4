use super::Reader;
use crate::scene::{Elements, FacePressure, from_deck::reader::Offenders};
use std::collections::HashMap;
use yformat::diagnostic::Diagnostic;

/// Faces of a tetrahedron, seen from outside counter-clockwise (spec `y3d.md` 1.9).
const FACES: [[u8; 3]; 4] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]];

/// Pressures on faces (spec `y3d.md` 1.7): of a surface triangle its nodes count, not their order.
pub(super) fn read(reader: &mut Reader<'_>, elements: &Elements) -> Vec<FacePressure> {
    let len = usize::try_from(reader.integer("YDX/NELEM")).unwrap_or(0);
    let pressure = reader.reals("YDX/D1NAP", 0.0);
    let pressed: Vec<usize> = (0..len.min(1 << 24)).filter(|&t| pressure(t) != 0.0).collect();
    if pressed.is_empty() {
        return Vec::new();
    }
    let Some(topology) = reader.required_integers("YDX/I2ELTO", "surface triangles", len) else {
        return Vec::new();
    };
    if !elements.edge_nodes.is_empty() {
        reader.report(
            Diagnostic::error(
                "scene::not-simulated",
                "pressures on the faces of ten-node tetrahedra are not simulated",
            )
            .at(reader.entry("YDX/D1NAP", pressed[0]))
            .expected("pressures of 0, or 4-node tetrahedra (type 13)")
            .help("give the load as nodal forces (D1BNFX, D1BNFY, D1BNFZ)"),
        );
        return Vec::new();
    }
    let mut owners: HashMap<[i64; 3], Option<(usize, [u8; 3])>> = HashMap::new();
    for e in 0..elements.len() {
        for face in FACES {
            let mut nodes = face.map(|i| i64::from(elements.nodes[e][usize::from(i)]));
            nodes.sort_unstable();
            // a face between two tetrahedra is none of the surface
            owners.entry(nodes).and_modify(|owner| *owner = None).or_insert(Some((e, face)));
        }
    }
    let owner = |t: usize| {
        let mut nodes: [i64; 3] = std::array::from_fn(|i| topology.get2(i, t));
        nodes.sort_unstable();
        owners.get(&nodes).copied().flatten()
    };
    if let Some(found) = Offenders::find(pressed.len(), |k| owner(pressed[k]).is_none()) {
        let triangle = pressed[found.first];
        reader.report(
            Diagnostic::error(
                "scene::surface-triangle",
                format!("surface triangle {triangle} carries a pressure, but is no face of the surface{}", found.more()),
            )
            .at(reader.entry_at("YDX/I2ELTO", [0, triangle, 0]))
            .expected("the three nodes of a face of one tetrahedron"),
        );
    }
    pressed
        .into_iter()
        .filter_map(|t| {
            let (element, corners) = owner(t)?;
            Some(FacePressure { element, corners, pressure: pressure(t) })
        })
        .collect()
}
