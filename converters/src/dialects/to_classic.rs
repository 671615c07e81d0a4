//! Writes decks of the classic dialect: element, joint and node sets become one table, in this
//! order.

use super::contact::misfit_line;
use super::loads::ramp_of_tables;
use super::model::{JointSet, Model};
use super::to_split::softening;
use super::write::{Writer, common};

/// Output scale of apertures, m, which the original has no default for.
const APERTURE_SCALE: f64 = 1e-7;

pub(super) fn write(model: &Model, writer: &mut Writer, lost: &mut Vec<String>) {
    let joints = used_joint_sets(model, lost);
    let (elements, nodes) = (model.element_sets.len(), model.node_sets.len());
    let first_node_set = elements + joints.len();
    common(model, writer);
    writer.real("YDC/DCSIZD", 1.0);
    writer.real("YDC/DCSIZA", APERTURE_SCALE);
    let ramp = ramp_of_tables(model.control.start, &model.node_sets);
    if ramp.is_err() {
        lost.push(
            "loads do not follow their tables, which are no common ramp (D3PNFAC)".to_owned(),
        );
    }
    let (settling, rise) = ramp.ok().flatten().unwrap_or((0.0, 0.0));
    writer.real("YDC/DCGRST", settling);
    writer.real("YDC/DCRMPT", rise);
    writer.integers("YDE/I1ELTY", vec![-1; model.triangles.len()]);
    writer.integers2("YDE/I2ELJP", 3, Vec::new());
    let property = |set: Option<usize>| set.map_or(-1, |set| (first_node_set + set) as i64);
    writer.integers("YDN/I1NOPR", model.nodes.iter().map(|node| property(node.set)).collect());
    let count = first_node_set + nodes;
    writer.count("YDP/MPROP", count);
    writer.count("YDP/NPROP", count);
    let mut table = Table { writer, elements, joints: &joints, nodes };
    element_columns(model, &mut table, lost);
    joint_columns(&mut table);
    node_columns(model, &mut table);
    meshing(model, &mut table, lost);
    differences(model, &joints, lost);
}

/// The common table, column by column.
struct Table<'a> {
    writer: &'a mut Writer,
    elements: usize,
    joints: &'a [(usize, JointSet)],
    nodes: usize,
}

impl Table<'_> {
    fn reals(&mut self, name: &str, of: [Vec<f64>; 3]) {
        let counts = [self.elements, self.joints.len(), self.nodes];
        let column = of.into_iter().zip(counts).flat_map(|(values, count)| match values.len() {
            0 => vec![0.0; count],
            _ => values,
        });
        self.writer.reals(&format!("YDP/{name}"), column.collect());
    }

    fn integers(&mut self, name: &str, of: [Vec<i64>; 3]) {
        let counts = [self.elements, self.joints.len(), self.nodes];
        let column = of.into_iter().zip(counts).flat_map(|(values, count)| match values.len() {
            0 => vec![0; count],
            _ => values,
        });
        self.writer.integers(&format!("YDP/{name}"), column.collect());
    }
}

fn element_columns(model: &Model, table: &mut Table<'_>, lost: &mut Vec<String>) {
    let sets = &model.element_sets;
    let pairs = &model.pairs;
    let real = |value: fn(&super::model::ElementSet) -> f64| sets.iter().map(value).collect();
    let integer = |value: fn(&super::model::ElementSet) -> i64| sets.iter().map(value).collect();
    let none = Vec::new;
    table.reals("D1PELA", [real(|set| 0.5 * set.lambda), none(), none()]);
    table.reals("D1PEMU", [real(|set| set.mu), none(), none()]);
    table.reals("D1PERO", [real(|set| set.density), none(), none()]);
    table.reals("D1PEKS", [real(|set| set.viscosity), none(), none()]);
    table.reals("D1PSEM", [real(|set| set.stretch), none(), none()]);
    table.integers("I1PEFR", [integer(|set| set.fractures), Vec::new(), Vec::new()]);
    table.integers("I1PEMB", [integer(|set| set.boundary_mode), Vec::new(), Vec::new()]);
    table.integers("I1PSDE", [integer(|set| set.state_row.max(0)), Vec::new(), Vec::new()]);
    softening(model, lost);
    let penalty = pairs.per_set(sets.len(), |law| law.normal, false);
    let inside = pairs.per_set(sets.len(), |law| law.friction, false);
    let between = pairs.per_set(sets.len(), |law| law.friction, true);
    let smaller = "its own but the smaller one of the two";
    lost.extend(misfit_line(
        "normal contact penalty",
        smaller,
        &pairs.misfits(&penalty, |law| law.normal),
    ));
    lost.extend(misfit_line("friction", smaller, &pairs.misfits(&between, |law| law.friction)));
    let tenth = |law: &super::contact::PairLaw| {
        (law.tangential - 0.1 * law.normal).abs() <= 1e-12 * law.normal.abs()
    };
    let others: Vec<(usize, usize)> =
        pairs.laws.iter().filter(|(_, law)| !tenth(law)).map(|(&pair, _)| pair).collect();
    lost.extend(misfit_line(
        "tangential contact penalty",
        "its own but a tenth of the normal one",
        &others,
    ));
    table.reals("D1PEPC", [penalty, none(), none()]);
    table.reals("D1PEFR", [inside, none(), none()]);
    table.reals("D1PBIF", [between, none(), none()]);
}

fn joint_columns(table: &mut Table<'_>) {
    let real =
        |value: fn(&JointSet) -> f64| table.joints.iter().map(|(_, set)| value(set)).collect();
    let cohesion = |set: &JointSet| match set.cohesion > 0.0 {
        true => set.cohesion,
        false => set.shear_strength,
    };
    let friction = |set: &JointSet| if set.cohesion > 0.0 { set.friction } else { 0.0 };
    let columns: [(&str, Vec<f64>); 6] = [
        ("D1PEFT", real(|set| set.tensile_strength)),
        ("D1PCOH", real(cohesion)),
        ("D1PICF", real(friction)),
        ("D1PEGT", real(|set| set.opening_energy)),
        ("D1PEGS", real(|set| set.sliding_energy)),
        ("D1PEPE", real(|set| set.penalty)),
    ];
    // The original starts every joint with the cohesion of the triangles' property.
    let first = columns[1].1.first().copied().unwrap_or(0.0);
    for (name, values) in columns {
        let elements = if name == "D1PCOH" { vec![first; table.elements] } else { Vec::new() };
        table.reals(name, [elements, values, Vec::new()]);
    }
    for name in ["D1PEPF", "D1PJRC", "D1PJCS", "D1PJSL"] {
        table.reals(name, [Vec::new(), Vec::new(), Vec::new()]);
    }
}

fn node_columns(model: &Model, table: &mut Table<'_>) {
    let sets = &model.node_sets;
    let columns: [(&str, Vec<f64>); 8] = [
        ("D1PNAX", sets.iter().map(|set| set.amplitudes[0]).collect()),
        ("D1PNAY", sets.iter().map(|set| set.amplitudes[1]).collect()),
        ("D1PNAP", sets.iter().map(|set| set.edge_loads[0]).collect()),
        ("D1PNAT", sets.iter().map(|set| set.edge_loads[1]).collect()),
        ("D1PNAF", vec![1.0; sets.len()]),
        ("D1PNAI", Vec::new()),
        ("D1PNXY", sets.iter().map(|set| set.axes[1]).collect()),
        ("D1PNYX", sets.iter().map(|set| set.axes[2]).collect()),
    ];
    for (name, values) in columns {
        table.reals(name, [Vec::new(), Vec::new(), values]);
    }
    for (name, axis) in [("D1PNXX", 0), ("D1PNYY", 3)] {
        let ones = [vec![1.0; table.elements], vec![1.0; table.joints.len()]];
        let [elements, joints] = ones;
        let values = sets.iter().map(|set| set.axes[axis]).collect();
        table.reals(name, [elements, joints, values]);
    }
    for (axis, name) in ["I1PNFX", "I1PNFY"].into_iter().enumerate() {
        let codes = sets.iter().map(|set| set.codes[axis]).collect();
        table.integers(name, [Vec::new(), Vec::new(), codes]);
    }
    let kinds = model.element_sets.iter().map(|set| set.kind).collect();
    let nodes = vec![-1; table.nodes];
    table.integers("I1PTYP", [kinds, vec![3; table.joints.len()], nodes]);
}

/// Whether a mesh code inserts joints.
fn inserts_joints(code: i64) -> bool {
    code > 0 && code.to_string().contains('3')
}

/// The joint sets that element sets with joints use; the first of them is the only one, as the
/// classic dialect lets all act on all joints.
fn used_joint_sets(model: &Model, lost: &mut Vec<String>) -> Vec<(usize, JointSet)> {
    let mut used: Vec<usize> = Vec::new();
    for (_, sets) in model.meshing.iter().filter(|(code, _)| inserts_joints(*code)) {
        for &set in sets {
            let set = set as i64;
            let mut rows = model.joint_of_pair.iter().filter(|row| row[0] == set && row[1] == set);
            used.extend(rows.next_back().and_then(|row| usize::try_from(row[2]).ok()));
        }
    }
    used.sort_unstable();
    used.dedup();
    if let [first, others @ ..] = &used[..]
        && !others.is_empty()
    {
        lost.push(format!(
            "all joints are of joint set {first}: the classic dialect lets every joint set act on \
             every joint"
        ));
    }
    let first = used.first().and_then(|&set| Some((set, *model.joint_sets.get(set)?)));
    first.into_iter().collect()
}

fn meshing(model: &Model, table: &mut Table<'_>, lost: &mut Vec<String>) {
    let mut codes = vec![0; table.elements];
    let order: Vec<usize> = model
        .meshing
        .iter()
        .filter(|(code, _)| *code > 0)
        .flat_map(|(_, sets)| sets)
        .copied()
        .collect();
    if model.meshing.iter().any(|(code, sets)| *code > 0 && sets.len() > 1) || !order.is_sorted() {
        lost.push("nodes and elements that meshing makes have other numbers (I2PMSET)".to_owned());
    }
    if order.len() > order.iter().collect::<std::collections::BTreeSet<_>>().len() {
        lost.push("element sets are meshed by their last record only (I2PMSET)".to_owned());
    }
    for (code, sets) in &model.meshing {
        if inserts_joints(*code) && sets.len() > 1 {
            lost.push(format!(
                "element sets {sets:?} get no joints between each other, only inside (I2PMSET)"
            ));
        }
        for &set in sets {
            if let Some(slot) = codes.get_mut(set) {
                *slot = *code;
            }
        }
    }
    let joint = table.elements as i64;
    let joints = codes.iter().map(|&code| if inserts_joints(code) { joint } else { 0 }).collect();
    table.integers("I1PEMN", [codes, Vec::new(), Vec::new()]);
    table.integers("I1PEJP", [joints, Vec::new(), Vec::new()]);
}

fn differences(model: &Model, joints: &[(usize, JointSet)], lost: &mut Vec<String>) {
    if let Some((_, set)) = joints.first() {
        lost.push(
            "joints soften by another law: the two modes are combined otherwise, and tension \
             lowers the shear strength"
                .to_owned(),
        );
        lost.push("triangles beside an intact joint do not touch each other".to_owned());
        if set.kind != 3 {
            lost.push(format!("joints of type {} become joints of type 3", set.kind));
        }
    }
    if model.element_sets.iter().any(|set| set.kind == 2) {
        lost.push("contact does not act on rigid triangles (type 2)".to_owned());
    }
}
