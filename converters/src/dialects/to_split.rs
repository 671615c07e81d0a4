//! Writes decks of the split and Y-Geo dialects.

use yformat::dialect::Dialect;

use super::DialectError;
use super::contact::misfit_line;
use super::model::{JointSet, Model, NodeSet};
use super::write::{Writer, common};

pub(super) fn write(
    model: &Model,
    writer: &mut Writer,
    lost: &mut Vec<String>,
) -> Result<(), DialectError> {
    let is_ygeo = writer.dialect() == Dialect::YGeo;
    common(model, writer);
    let sets = model.nodes.iter().map(|node| node.set.map_or(-1, |set| set as i64)).collect();
    writer.integers("YDN/I1NOPR", sets);
    if is_ygeo {
        writer.integers("YDN/I1NOWE", vec![-1; model.nodes.len()]);
        if model.control.first_step != 0 {
            lost.push("Y-Geo of Toronto must start at step 0 (NCSTEP)".to_owned());
        }
    }
    element_sets(model, writer, lost);
    node_sets(&model.node_sets, writer, lost);
    joint_sets(&model.joint_sets, writer, lost);
    meshing(model, writer);
    Ok(())
}

fn element_sets(model: &Model, writer: &mut Writer, lost: &mut Vec<String>) {
    let is_ygeo = writer.dialect() == Dialect::YGeo;
    let sets = &model.element_sets;
    let real = |value: fn(&super::model::ElementSet) -> f64| sets.iter().map(value).collect();
    let integer = |value: fn(&super::model::ElementSet) -> i64| sets.iter().map(value).collect();
    writer.count("YDPE/MPROP", sets.len());
    writer.count("YDPE/NPROP", sets.len());
    let factor = if is_ygeo { 0.5 } else { 1.0 };
    writer.reals("YDPE/D1PELA", sets.iter().map(|set| factor * set.lambda).collect());
    writer.reals("YDPE/D1PEMU", real(|set| set.mu));
    writer.reals("YDPE/D1PERO", real(|set| set.density));
    writer.reals("YDPE/D1PEKS", real(|set| set.viscosity));
    writer.reals("YDPE/D1PSEM", real(|set| set.stretch));
    writer.integers("YDPE/I1PEFR", integer(|set| set.fractures));
    writer.integers("YDPE/I1PEMB", integer(|set| set.boundary_mode));
    writer.integers("YDPE/I1PSDE", integer(|set| set.state_row.max(0)));
    writer.integers("YDPE/I1PTYP", integer(|set| set.kind));
    softening(model, lost);
    if is_ygeo {
        ygeo_elements(model, writer);
    } else {
        split_contact(model, writer, lost);
    }
}

/// Notes on sets of type 4, whose laws differ between all dialects.
pub(super) fn softening(model: &Model, lost: &mut Vec<String>) {
    for (index, _) in model.element_sets.iter().enumerate().filter(|(_, set)| set.kind == 4) {
        lost.push(format!(
            "element set {index} softens (type 4) by another law, beginning without damage"
        ));
    }
}

/// One value per set, the pair has the smaller one.
fn split_contact(model: &Model, writer: &mut Writer, lost: &mut Vec<String>) {
    let pairs = &model.pairs;
    let count = model.element_sets.len();
    let normal = pairs.per_set(count, |law| law.normal, false);
    let tangential = pairs.per_set(count, |law| law.tangential, false);
    let friction = pairs.per_set(count, |law| law.friction, false);
    lost.extend(misfit_line(
        "normal contact penalty",
        "its own but the smaller one of the two",
        &pairs.misfits(&normal, |law| law.normal),
    ));
    lost.extend(misfit_line(
        "tangential contact penalty",
        "its own but the smaller one of the two",
        &pairs.misfits(&tangential, |law| law.tangential),
    ));
    lost.extend(misfit_line(
        "friction",
        "its own but the smaller one of the two",
        &pairs.misfits(&friction, |law| law.friction),
    ));
    writer.reals("YDPE/D1PEPE", normal);
    writer.reals("YDPE/D1PEPT", tangential);
    writer.reals("YDPE/D1PEFR", friction);
}

/// The contact table, and what Y-Geo cannot run without.
fn ygeo_elements(model: &Model, writer: &mut Writer) {
    let count = model.element_sets.len();
    let zeros = || vec![0.0; count];
    for name in ["D1PEEM", "D1PENU", "D1PEEX", "D1PEEY", "D1PEMX", "D1PEMY", "D1PEG"] {
        writer.reals(&format!("YDPE/{name}"), zeros());
    }
    for name in ["I1USAN", "I1PEXC", "I1PSUP"] {
        writer.integers(&format!("YDPE/{name}"), vec![0; count]);
    }
    let records =
        model.pairs.laws.iter().flat_map(|(&(i, j), law)| {
            [i as f64, j as f64, law.friction, law.normal, law.tangential]
        });
    let records: Vec<f64> = records.collect();
    writer.count("YDPE/MPEROW", records.len() / 5);
    writer.reals2("YDPE/D2PEINT", 5, records);
}

fn node_sets(sets: &[NodeSet], writer: &mut Writer, lost: &mut Vec<String>) {
    let column = |value: &dyn Fn(&NodeSet) -> f64| sets.iter().map(value).collect::<Vec<f64>>();
    writer.count("YDPN/MPNSET", sets.len());
    writer.count("YDPN/NPNSET", sets.len());
    for (axis, name) in ["I1PNFX", "I1PNFY"].into_iter().enumerate() {
        // Code 4 freezes nodes everywhere but in Y-Geo, where it absorbs waves.
        let is_ygeo = writer.dialect() == Dialect::YGeo;
        let code = |code: i64| if is_ygeo && code == 4 { 0 } else { code };
        let codes = sets.iter().map(|set| code(set.codes[axis])).collect();
        writer.integers(&format!("YDPN/{name}"), codes);
    }
    for (axis, name) in ["D1PNAX", "D1PNAY"].into_iter().enumerate() {
        writer.reals(&format!("YDPN/{name}"), column(&|set| set.amplitudes[axis]));
    }
    for (axis, name) in ["D1PNAP", "D1PNAT"].into_iter().enumerate() {
        writer.reals(&format!("YDPN/{name}"), column(&|set| set.edge_loads[axis]));
    }
    for (axis, name) in ["D1PNXX", "D1PNXY", "D1PNYX", "D1PNYY"].into_iter().enumerate() {
        writer.reals(&format!("YDPN/{name}"), column(&|set| set.axes[axis]));
    }
    let points = sets.iter().map(|set| set.factors.len()).min().unwrap_or(0);
    if points > 0 {
        let begins = sets.first().and_then(|set| set.factors.first()).map(|&(time, _)| time);
        if writer.dialect() == Dialect::YGeo && begins == Some(-1.0) {
            lost.push("load tables that begin at the time -1 are ignored (D3PNFAC)".to_owned());
        }
        writer.count("YDPN/MPNFACT", points);
        writer.count("YDPN/NPNFACT", points);
        let table = sets.iter().flat_map(|set| {
            let of_set = set.factors.iter().take(points);
            of_set.flat_map(|&(time, factor)| [time, factor])
        });
        writer.reals3("YDPN/D3PNFAC", [2, sets.len(), points], table.collect());
    }
}

fn joint_sets(sets: &[JointSet], writer: &mut Writer, lost: &mut Vec<String>) {
    let is_ygeo = writer.dialect() == Dialect::YGeo;
    // Y-Geo cannot run without joint sets: it gets one that nothing uses.
    let unused = [JointSet { kind: 3, ..JointSet::default() }];
    let sets = match sets {
        [] if is_ygeo => &unused[..],
        [] => return,
        sets => sets,
    };
    writer.count("YDPJ/MPJSET", sets.len());
    writer.count("YDPJ/NPJSET", sets.len());
    let mut real = |name: &str, value: fn(&JointSet) -> f64| {
        writer.reals(&format!("YDPJ/{name}"), sets.iter().map(value).collect());
    };
    real("D1PJFT", |set| set.tensile_strength);
    real("D1PJFS", |set| set.shear_strength);
    real("D1PJCO", |set| set.cohesion);
    real("D1PJFR", |set| set.friction);
    real("D1PJGF", |set| set.opening_energy);
    real("D1PJPE", |set| set.penalty);
    if is_ygeo {
        real("D1PJGS", |set| set.sliding_energy);
        real("D1USAF", |_| -1.0);
        for name in ["D1PJAL", "D1PJCR", "D1PJFD", "D1PJTR", "D1PJGR", "D1PJSR"] {
            real(name, |_| 0.0);
        }
    }
    writer.integers("YDPJ/I1PSDE", vec![0; sets.len()]);
    writer.integers("YDPJ/I1PTYP", sets.iter().map(|set| set.kind).collect());
    if is_ygeo {
        writer.integer("YDPJ/IUSEHY", 0);
        return;
    }
    let differ = |set: &&JointSet| set.opening_energy != set.sliding_energy;
    for (index, _) in sets.iter().enumerate().filter(|(_, set)| differ(set)) {
        lost.push(format!(
            "joint set {index} has the fracture energy of opening in sliding, too (D1PJGF)"
        ));
    }
}

fn meshing(model: &Model, writer: &mut Writer) {
    let columns = 2 + model.meshing.iter().map(|(_, sets)| sets.len()).max().unwrap_or(0);
    let records = model.meshing.iter().flat_map(|(code, sets)| {
        let members = sets.iter().map(|&set| set as i64);
        let padded = members.chain(std::iter::repeat(-1)).take(columns - 2);
        [sets.len() as i64, *code].into_iter().chain(padded).collect::<Vec<i64>>()
    });
    let records: Vec<i64> = records.collect();
    writer.count("YDPM/MPMCOM", model.meshing.len());
    if model.meshing.is_empty() {
        return;
    }
    writer.count("YDPM/MPMCOL", columns);
    writer.integers2("YDPM/I2PMSET", columns, records);
    writer.count("YDPM/MPMROW", model.joint_of_pair.len());
    writer.integers2("YDPM/I2PMIJ", 3, model.joint_of_pair.iter().flatten().copied().collect());
}
