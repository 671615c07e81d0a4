//! The deck of a model.

use super::{
    model::{Bond, Drive, Model, Substance},
    node_sets::{NodeSet, NodeSets},
    properties::Joint,
    property_sets::PropertySets,
    scenario::RunTimes,
};
use std::collections::{BTreeMap, BTreeSet};
use yformat::{
    deck::{Deck, DeckBuilder},
    dialect::Dialect,
};

/// Times of a run.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Times {
    /// Time step \[s\].
    pub step_s: f64,
    /// End \[s\].
    pub end_s: f64,
    /// Between outputs \[s\].
    pub output_s: f64,
}

impl Times {
    /// Number of steps up to a time.
    pub fn steps(&self, time_s: f64) -> i64 {
        (time_s / self.step_s).ceil().clamp(1.0, 2e9) as i64
    }
}

/// Puts everything into a deck of the split dialect.
pub(super) fn deck(
    header: &[String],
    model: &Model,
    properties: &PropertySets,
    node_sets: &NodeSets,
    times: Times,
    run: RunTimes,
) -> Deck {
    let mut builder = DeckBuilder::new(Dialect::Split);
    for comment in header {
        builder = builder.comment(comment.clone());
    }
    builder = control(builder, model, times);
    builder = nodes(builder, model, node_sets);
    builder = elements(builder, model, properties);
    builder = contact(builder, model, run);
    builder = builder.comment("history 0: kinetic energy").kinetic_energy_history(5e-4);
    builder = materials(builder, properties, 1);
    if let Some(joints) = &model.joints {
        builder = joint_sets(builder, [&joints.inside, &joints.mortar], 3);
        builder = insertion(builder, &model.substances, properties);
    }
    builder = conditions(builder, &node_sets.sets, &node_sets.instants);
    if model.second_stage_s.is_some() {
        builder = builder
            .run()
            .comment("second stage")
            .integer("YDC/MCSTEP", times.steps(times.end_s) + 1);
        builder = drives(builder, &node_sets.sets, true);
    }
    builder.run().stop().build()
}

fn control(builder: DeckBuilder, model: &Model, times: Times) -> DeckBuilder {
    let first_end = model.second_stage_s.unwrap_or(times.end_s);
    // outputs are written at the beginning of a step: one more, and the end is among them
    let steps = times.steps(first_end) + i64::from(model.second_stage_s.is_none());
    let output = ((times.output_s / times.step_s).round() as i64).max(1);
    builder
        .comment("control")
        .integer("YDC/MCSTEP", steps)
        .integer("YDC/NCSTEP", 0)
        .real("YDC/DCSTEC", times.step_s)
        .real("YDC/DCTIME", 0.0)
        .real("YDC/DCGRAY", model.gravity_m_s2)
        .integer("YDC/ICOUTF", output)
        .integer("YDC/ICSHTF", output)
}

fn nodes(builder: DeckBuilder, model: &Model, node_sets: &NodeSets) -> DeckBuilder {
    let count = model.mesh.nodes.len();
    let copies = model.mesh.triangles.iter().filter(|t| model.bonded(t.material)).count() * 3;
    let places: Vec<f64> = model.mesh.nodes.iter().flatten().copied().collect();
    let start = |(node, place): (usize, &[f64; 2])| *model.start.get(&node).unwrap_or(place);
    let current = model.mesh.nodes.iter().enumerate().flat_map(start).collect();
    let velocities = (0..count)
        .flat_map(|node| model.velocities.get(&node).copied().unwrap_or_default())
        .collect();
    builder
        .comment("nodes")
        .integer("YDN/MNODIM", 2)
        .integer("YDN/NNODIM", 2)
        .integer("YDN/MNOPO", length(count + copies))
        .integer("YDN/NNOPO", length(count))
        .reals2("YDN/D2NCC", 2, current)
        .reals2("YDN/D2NCI", 2, places)
        .reals2("YDN/D2NVC", 2, velocities)
        .integers("YDN/I1NOBF", boundary(model))
        .integers("YDN/I1NOPR", node_sets.of_node.iter().map(|&set| length(set)).collect())
}

/// 1 for nodes at the surface of a body.
fn boundary(model: &Model) -> Vec<i64> {
    let mut edges: BTreeMap<[usize; 2], [usize; 2]> = BTreeMap::new();
    for triangle in &model.mesh.triangles {
        for k in 0..3 {
            let (a, b) = (triangle.nodes[k], triangle.nodes[(k + 1) % 3]);
            let bonded = usize::from(model.bonded(triangle.material));
            edges.entry([a.min(b), a.max(b)]).or_default()[bonded] += 1;
        }
    }
    let mut flags = vec![0; model.mesh.nodes.len()];
    for (edge, [continuous, bonded]) in edges {
        if continuous == 1 || bonded > 0 {
            edge.iter().for_each(|&node| flags[node] = 1);
        }
    }
    flags
}

fn elements(builder: DeckBuilder, model: &Model, properties: &PropertySets) -> DeckBuilder {
    let triangles = &model.mesh.triangles;
    let topology = triangles.iter().flat_map(|t| t.nodes).map(length).collect();
    let sets = properties.of_triangle.iter().map(|&set| length(set)).collect();
    builder
        .comment("triangles")
        .integer("YDE/MELEM", length(triangles.len() + joints(model)))
        .integer("YDE/NELEM", length(triangles.len()))
        .integer("YDE/MELST", 1)
        .integer("YDE/NELST", 1)
        .integer("YDE/MELNO", 4)
        .integer("YDE/NELNO", 3)
        .integers("YDE/I1ELPR", sets)
        .integers2("YDE/I2ELTO", 3, topology)
}

/// Number of joint elements that insertion makes: one for each edge of bonded triangles, those at
/// the surface included.
pub(super) fn joints(model: &Model) -> usize {
    let bonded = model.mesh.triangles.iter().filter(|t| model.bonded(t.material));
    let edges: BTreeSet<[usize; 2]> = bonded
        .flat_map(|t| {
            (0..3).map(|k| {
                let (a, b) = (t.nodes[k], t.nodes[(k + 1) % 3]);
                [a.min(b), a.max(b)]
            })
        })
        .collect();
    edges.len()
}

fn contact(builder: DeckBuilder, model: &Model, run: RunTimes) -> DeckBuilder {
    if run.contact == Some(false) {
        return builder.comment("no contact").integer("YDI/MICOUP", 0);
    }
    let mesh = &model.mesh;
    let heights: f64 = mesh.triangles.iter().map(|t| mesh.height(t)).sum();
    let own = round(0.1 * heights / mesh.triangles.len().max(1) as f64);
    let buffer = run.contact_buffer_m.unwrap_or(own);
    builder
        .comment("contact")
        .integer("YDI/MICOUP", length(mesh.triangles.len() * 40 + 100))
        .integer("YDI/NICOUP", 0)
        .integer("YDI/IIECFF", -2)
        .integer("YDI/MISTATE", 6)
        .real("YDI/DIEZON", buffer)
        .real("YDI/DIEDI", 200.0)
}

/// Two significant digits.
pub(super) fn round(value: f64) -> f64 {
    format!("{value:.1e}").parse().unwrap_or(value)
}

/// Property sets; `kind` is the type of their elements.
pub(super) fn materials(builder: DeckBuilder, properties: &PropertySets, kind: i64) -> DeckBuilder {
    let sets = &properties.sets;
    let n = sets.len();
    let each = |value: fn(&super::property_sets::PropertySet) -> f64| {
        sets.iter().map(value).collect::<Vec<f64>>()
    };
    builder
        .comment("property sets")
        .integer("YDPE/MPROP", length(n))
        .integer("YDPE/NPROP", length(n))
        .reals("YDPE/D1PEKS", each(|set| set.viscosity_pa_s))
        .reals("YDPE/D1PELA", each(|set| set.material.lambda()))
        .reals("YDPE/D1PEMU", each(|set| set.material.mu()))
        .reals("YDPE/D1PERO", each(|set| set.material.density_kg_m3))
        .reals("YDPE/D1PEPE", each(|set| set.material.penalty_pa))
        .reals("YDPE/D1PEPT", each(|set| set.material.tangential_penalty_pa))
        .reals("YDPE/D1PEFR", each(|set| set.material.friction))
        .reals("YDPE/D1PSEM", vec![0.0; n])
        .integers("YDPE/I1PEMB", vec![1; n])
        .integers("YDPE/I1PSDE", vec![0; n])
        .integers("YDPE/I1PTYP", vec![kind; n])
}

/// Joint sets; `kind` is the type of their elements.
pub(super) fn joint_sets(builder: DeckBuilder, joints: [&Joint; 2], kind: i64) -> DeckBuilder {
    let each = |value: fn(&Joint) -> f64| joints.iter().map(|joint| value(joint)).collect();
    builder
        .comment("joint sets: 0 inside blocks, 1 mortar")
        .integer("YDPJ/MPJSET", 2)
        .integer("YDPJ/NPJSET", 2)
        .reals("YDPJ/D1PJFS", each(|joint| joint.cohesion_pa))
        .reals("YDPJ/D1PJFT", each(|joint| joint.tensile_pa))
        .reals("YDPJ/D1PJCO", each(|joint| joint.cohesion_pa))
        .reals("YDPJ/D1PJFR", each(|joint| joint.friction))
        .reals("YDPJ/D1PJPE", each(|joint| joint.penalty_pa))
        .reals("YDPJ/D1PJGF", each(|joint| joint.fracture_energy_n_m))
        .integers("YDPJ/I1PSDE", vec![0; 2])
        .integers("YDPJ/I1PTYP", vec![kind; 2])
}

/// One record for all bonded property sets, and a row for every pair of them.
pub(super) fn insertion(
    builder: DeckBuilder,
    substances: &[Substance],
    properties: &PropertySets,
) -> DeckBuilder {
    let bonded: Vec<usize> = (0..properties.sets.len())
        .filter(|&set| substances[properties.sets[set].substance].bond != Bond::Continuous)
        .collect();
    let mut record = vec![length(bonded.len()), 3];
    record.extend(bonded.iter().map(|&set| length(set)));
    let mut rows = Vec::new();
    for (k, &p) in bonded.iter().enumerate() {
        for &q in &bonded[k..] {
            if let Some(joint) = properties.joint_of(substances, p, q) {
                rows.extend([length(p), length(q), length(joint)]);
            }
        }
    }
    builder
        .comment("joints between all elements of the property sets of this record")
        .integer("YDPM/MPMCOM", 1)
        .integer("YDPM/MPMCOL", length(record.len()))
        .integers2("YDPM/I2PMSET", record.len(), record)
        .integer("YDPM/MPMROW", length(rows.len() / 3))
        .integers2("YDPM/I2PMIJ", 3, rows)
}

/// Node sets with their load-time tables.
pub(super) fn conditions<const D: usize>(
    builder: DeckBuilder,
    sets: &[NodeSet<D>],
    instants: &[f64],
) -> DeckBuilder {
    let n = sets.len();
    let mut builder = builder
        .comment("node sets")
        .integer("YDPN/MPNSET", length(n))
        .integer("YDPN/NPNSET", length(n));
    if !instants.is_empty() {
        let tables = sets.iter().flat_map(|set| {
            let history = &set.motion.history;
            instants.iter().flat_map(|&t| [t, super::loads::value(history, t)])
        });
        builder = builder
            .integer("YDPN/MPNFACT", length(instants.len()))
            .integer("YDPN/NPNFACT", length(instants.len()))
            .reals3("YDPN/D3PNFAC", [2, n, instants.len()], tables.collect());
    }
    drives(builder, sets, false)
}

fn drives<const D: usize>(
    mut builder: DeckBuilder,
    sets: &[NodeSet<D>],
    second: bool,
) -> DeckBuilder {
    let axis = |k: usize| {
        sets.iter().map(move |set| match (second, set.motion.later) {
            (true, Some(later)) => later[k],
            _ => set.motion.drives[k],
        })
    };
    let code = |drive| match drive {
        Drive::Force(_) => 1,
        Drive::Velocity(_) => 3,
    };
    let amplitude = |drive| match drive {
        Drive::Force(amount) | Drive::Velocity(amount) => amount,
    };
    for (k, name) in ["YDPN/I1PNFX", "YDPN/I1PNFY", "YDPN/I1PNFZ"].into_iter().take(D).enumerate() {
        builder = builder.integers(name, axis(k).map(code).collect());
    }
    for (k, name) in ["YDPN/D1PNAX", "YDPN/D1PNAY", "YDPN/D1PNAZ"].into_iter().take(D).enumerate() {
        builder = builder.reals(name, axis(k).map(amplitude).collect());
    }
    builder
}

pub(super) fn length(n: usize) -> i64 {
    i64::try_from(n).unwrap_or(i64::MAX)
}
