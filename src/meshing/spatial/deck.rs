//! The deck of a structure in space.

use super::model::SpatialModel;
use crate::meshing::{
    node_sets::NodeSet,
    property_sets::PropertySets,
    scenario::RunTimes,
    write_deck::{self, Times, length},
};
use yformat::{
    deck::{Deck, DeckBuilder},
    dialect::Dialect,
};

/// Types of tetrahedra and of the joints between them.
const TETRAHEDRON: i64 = 21;
const JOINT: i64 = 23;

/// Node sets and the nodes' numbers of them.
pub(super) struct Conditions {
    pub sets: Vec<NodeSet<3>>,
    pub of_node: Vec<usize>,
    pub instants: Vec<f64>,
}

/// Puts everything into a deck of the split dialect.
pub(super) fn deck(
    header: &[String],
    model: &SpatialModel,
    properties: &PropertySets,
    conditions: &Conditions,
    times: Times,
    run: RunTimes,
) -> Deck {
    let mut builder = DeckBuilder::new(Dialect::Split);
    for comment in header {
        builder = builder.comment(comment.clone());
    }
    // outputs are written at the beginning of a step: one more, and the end is among them
    let output = ((times.output_s / times.step_s).round() as i64).max(1);
    builder = builder
        .comment("control")
        .integer("YDC/MCSTEP", times.steps(times.end_s) + 1)
        .integer("YDC/NCSTEP", 0)
        .real("YDC/DCSTEC", times.step_s)
        .real("YDC/DCTIME", 0.0)
        .real("YDC/DCGRAZ", model.gravity_m_s2)
        .integer("YDC/ICOUTF", output)
        .integer("YDC/ICSHTF", output);
    builder = nodes(builder, model, conditions);
    builder = elements(builder, model, properties);
    builder = contact(builder, model, run);
    builder = builder.comment("history 0: kinetic energy").kinetic_energy_history(5e-4);
    builder = write_deck::materials(builder, properties, TETRAHEDRON);
    if let Some(joints) = &model.joints {
        builder = write_deck::joint_sets(builder, [&joints.inside, &joints.mortar], JOINT);
        builder = write_deck::insertion(builder, &model.substances, properties);
        if model.contact_at_cracks {
            builder = builder.integer("YDPM/IAUTBN", 0);
        }
    }
    write_deck::conditions(builder, &conditions.sets, &conditions.instants).run().stop().build()
}

fn nodes(builder: DeckBuilder, model: &SpatialModel, conditions: &Conditions) -> DeckBuilder {
    let places = &model.mesh.nodes;
    let copies = model.mesh.tetrahedra.iter().filter(|t| model.bonded(t.material)).count() * 4;
    let start = |(node, place)| *model.start.get(&node).unwrap_or(place);
    let current = places.iter().enumerate().flat_map(start).collect();
    let velocity = |node| model.velocities.get(&node).copied().unwrap_or_default();
    builder
        .comment("nodes")
        .integer("YDN/MNODIM", 3)
        .integer("YDN/NNODIM", 3)
        .integer("YDN/MNOPO", length(places.len() + copies))
        .integer("YDN/NNOPO", length(places.len()))
        .reals2("YDN/D2NCC", 3, current)
        .reals2("YDN/D2NCI", 3, places.iter().flatten().copied().collect())
        .reals2("YDN/D2NVC", 3, (0..places.len()).flat_map(velocity).collect())
        .integers("YDN/I1NOBF", boundary(model))
        .integers("YDN/I1NOPR", conditions.of_node.iter().map(|&set| length(set)).collect())
}

/// 1 for nodes at the surface of a body; where contact begins at cracks, at that of bodies without
/// joints.
fn boundary(model: &SpatialModel) -> Vec<i64> {
    let mut flags = vec![0; model.mesh.nodes.len()];
    for (face, sides) in model.mesh.faces() {
        let bonded = |&side: &usize| model.bonded(model.mesh.tetrahedra[side].material);
        let touches =
            if sides.iter().any(bonded) { !model.contact_at_cracks } else { sides.len() == 1 };
        if touches {
            face.iter().for_each(|&node| flags[node] = 1);
        }
    }
    flags
}

fn elements(builder: DeckBuilder, model: &SpatialModel, properties: &PropertySets) -> DeckBuilder {
    let tetrahedra = &model.mesh.tetrahedra;
    let bonded = |side: &usize| model.bonded(tetrahedra[*side].material);
    let faces = model.mesh.faces();
    let joints = faces.values().filter(|sides| sides.iter().any(bonded)).count();
    builder
        .comment("tetrahedra")
        .integer("YDE/MELEM", length(tetrahedra.len() + joints))
        .integer("YDE/NELEM", length(tetrahedra.len()))
        .integer("YDE/MELST", 1)
        .integer("YDE/NELST", 1)
        .integer("YDE/MELNO", 6)
        .integer("YDE/NELNO", 4)
        .integers("YDE/I1ELPR", properties.of_triangle.iter().map(|&set| length(set)).collect())
        .integers2("YDE/I2ELTO", 4, tetrahedra.iter().flat_map(|t| t.nodes).map(length).collect())
}

fn contact(builder: DeckBuilder, model: &SpatialModel, run: RunTimes) -> DeckBuilder {
    if run.contact == Some(false) {
        return builder.comment("no contact").integer("YDI/MICOUP", 0);
    }
    let mesh = &model.mesh;
    let heights: f64 = mesh.tetrahedra.iter().map(|t| mesh.height(t)).sum();
    let own = write_deck::round(0.1 * heights / mesh.tetrahedra.len().max(1) as f64);
    builder
        .comment("contact")
        .integer("YDI/MICOUP", length(mesh.tetrahedra.len() * 100 + 100))
        .integer("YDI/NICOUP", 0)
        .integer("YDI/IIECFF", -2)
        .real("YDI/DIEZON", run.contact_buffer_m.unwrap_or(own))
        .real("YDI/DIEDI", 200.0)
}
