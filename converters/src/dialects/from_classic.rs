//! Reads the meaning of decks of the classic dialect: one table of properties, told apart by
//! I1PTYP.

use yformat::database::Database;

use super::DialectError;
use super::contact::{PairLaw, PairTable};
use super::loads::table_of_ramp;
use super::model::{ElementSet, JointSet, Model, NodeSet};
use super::read::{
    contact, control, integers, node_set_columns, nodes, reals, set_count, triangles,
};

/// What a property of the common table is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Role {
    Element(usize),
    Node(usize),
    Joint(usize),
    Nothing,
}

/// The properties in order, each with its number among those of its kind.
fn roles(kinds: &[i64]) -> Vec<Role> {
    let (mut elements, mut nodes, mut joints) = (0, 0, 0);
    let next = |count: &mut usize| {
        *count += 1;
        *count - 1
    };
    kinds
        .iter()
        .map(|kind| match kind {
            1 | 2 | 4 => Role::Element(next(&mut elements)),
            -1 => Role::Node(next(&mut nodes)),
            3 => Role::Joint(next(&mut joints)),
            _ => Role::Nothing,
        })
        .collect()
}

pub(super) fn model(database: &Database, lost: &mut Vec<String>) -> Result<Model, DialectError> {
    let count = set_count(database, "YDP/NPROP")?;
    let kinds = integers(database, "YDP/I1PTYP", count, -2);
    let roles = roles(&kinds);
    let role = |property: i64| {
        usize::try_from(property).ok().and_then(|p| roles.get(p)).copied().unwrap_or(Role::Nothing)
    };
    let of_node = |property| match role(property) {
        Role::Node(set) => Some(set),
        _ => None,
    };
    let nodes = nodes(database, of_node, |flag| flag > 0)?;
    let kinds_of_elements = database.integers("YDE/I1ELTY");
    let of_element = |element, property| {
        let is_triangle = kinds_of_elements.is_none_or(|field| field.get1(element) == -1);
        match role(property) {
            Role::Element(set) if is_triangle => Ok(set),
            Role::Element(_) | Role::Joint(_) => Err(DialectError::HasJoints { element, property }),
            _ => Err(DialectError::NoElementSet { element, property }),
        }
    };
    let triangles = triangles(database, nodes.len(), of_element)?;
    let of_kind = |wanted: fn(Role) -> bool| -> Vec<usize> {
        (0..count).filter(|&p| roles.get(p).is_some_and(|&role| wanted(role))).collect()
    };
    let elements = of_kind(|role| matches!(role, Role::Element(_)));
    let joints = of_kind(|role| matches!(role, Role::Joint(_)));
    let node_sets = of_kind(|role| matches!(role, Role::Node(_)));
    let (meshing, joint_of_pair) = meshing(database, &elements, count, role, lost);
    let model = Model {
        control: control(database),
        node_room: database.integer("YDN/MNOPO"),
        element_room: database.integer("YDE/MELEM"),
        state_rows: database.integer("YDE/MELST"),
        nodes,
        triangles,
        contact: contact(database),
        element_sets: element_sets(database, &elements, &kinds),
        pairs: pairs(database, &elements, count)?,
        node_sets: read_node_sets(database, &node_sets, count, lost),
        joint_sets: joint_sets(database, &joints, count),
        meshing,
        joint_of_pair,
    };
    if model.element_sets.iter().any(|set| set.kind == 2) {
        lost.push("contact acts on rigid triangles, too (type 2)".to_owned());
    }
    differences(database, &joints, count, lost);
    Ok(model)
}

fn element_sets(database: &Database, properties: &[usize], kinds: &[i64]) -> Vec<ElementSet> {
    let count = kinds.len();
    let real = |name: &str| reals(database, &format!("YDP/{name}"), count, 0.0);
    let integer = |name: &str| integers(database, &format!("YDP/{name}"), count, 0);
    let (lambda, mu, density) = (real("D1PELA"), real("D1PEMU"), real("D1PERO"));
    let (viscosity, stretch) = (real("D1PEKS"), real("D1PSEM"));
    let (fractures, boundary) = (integer("I1PEFR"), integer("I1PEMB"));
    let rows = integer("I1PSDE");
    let set = |&p: &usize| ElementSet {
        kind: kinds[p],
        lambda: 2.0 * lambda[p],
        mu: mu[p],
        density: density[p],
        viscosity: viscosity[p],
        stretch: stretch[p],
        fractures: fractures[p],
        boundary_mode: boundary[p],
        state_row: rows[p],
    };
    properties.iter().map(set).collect()
}

/// The penalty is the smaller of the two, a tenth of it in sliding; friction is D1PEFR within a
/// set and the smaller D1PBIF between sets.
fn pairs(
    database: &Database,
    properties: &[usize],
    count: usize,
) -> Result<PairTable, DialectError> {
    let of_set = |name: &str| -> Vec<f64> {
        let all = reals(database, &format!("YDP/{name}"), count, 0.0);
        properties.iter().map(|&p| all[p]).collect()
    };
    let (penalty, inside, between) = (of_set("D1PEPC"), of_set("D1PEFR"), of_set("D1PBIF"));
    PairTable::of(properties.len(), |i, j| {
        let normal = penalty[i].min(penalty[j]);
        let friction = if i == j { inside[i] } else { between[i].min(between[j]) };
        PairLaw { friction, normal, tangential: 0.1 * normal }
    })
}

fn read_node_sets(
    database: &Database,
    properties: &[usize],
    count: usize,
    lost: &mut Vec<String>,
) -> Vec<NodeSet> {
    let columns = node_set_columns(database, "YDP", count, 0.0);
    let factor = reals(database, "YDP/D1PNAF", count, 0.0);
    let growth = reals(database, "YDP/D1PNAI", count, 0.0);
    let given = |name: &str| match database.given(name) {
        Some(_) => database.real(name),
        None => 0.0,
    };
    let ramp = table_of_ramp(database.real("YDC/DCTIME"), given("YDC/DCGRST"), given("YDC/DCRMPT"));
    let set = |&p: &usize| NodeSet {
        codes: [0, 1].map(|axis| columns.codes[axis][p]),
        amplitudes: [0, 1].map(|axis| columns.amplitudes[axis][p]),
        edge_loads: [0, 1].map(|axis| factor[p] * columns.edge_loads[axis][p]),
        axes: [0, 1, 2, 3].map(|axis| columns.axes[axis][p]),
        factors: ramp.clone().unwrap_or_default(),
    };
    for (index, &p) in properties.iter().enumerate() {
        if growth[p] != 0.0 && columns.edge_loads.iter().any(|load| load[p] != 0.0) {
            lost.push(format!("pressure and traction of node set {index} do not grow (D1PNAI)"));
        }
    }
    properties.iter().map(set).collect()
}

fn joint_sets(database: &Database, properties: &[usize], count: usize) -> Vec<JointSet> {
    let real = |name: &str| reals(database, &format!("YDP/{name}"), count, 0.0);
    let (tensile, cohesion, friction) = (real("D1PEFT"), real("D1PCOH"), real("D1PICF"));
    let (opening, sliding, penalty) = (real("D1PEGT"), real("D1PEGS"), real("D1PEPE"));
    let set = |&p: &usize| JointSet {
        kind: 3,
        tensile_strength: tensile[p],
        shear_strength: cohesion[p],
        cohesion: cohesion[p],
        friction: friction[p],
        opening_energy: opening[p],
        sliding_energy: sliding[p],
        penalty: penalty[p],
    };
    properties.iter().map(set).collect()
}

/// What the meshing tables of the other dialects say.
type Meshing = (Vec<(i64, Vec<usize>)>, Vec<[i64; 3]>);

/// Each set with a mesh code is meshed by itself, and its joints are those that I1PEJP names.
fn meshing(
    database: &Database,
    elements: &[usize],
    count: usize,
    role: impl Fn(i64) -> Role,
    lost: &mut Vec<String>,
) -> Meshing {
    let codes = integers(database, "YDP/I1PEMN", count, -1);
    let joints = integers(database, "YDP/I1PEJP", count, -1);
    let (mut records, mut rows) = (Vec::new(), Vec::new());
    for (set, &p) in elements.iter().enumerate() {
        if codes[p] <= 0 {
            continue;
        }
        records.push((codes[p], vec![set]));
        match role(joints[p]) {
            Role::Joint(joint) => rows.push([set as i64, set as i64, joint as i64]),
            _ if codes[p].to_string().contains('3') => lost.push(format!(
                "element set {set} is to get joints, but its I1PEJP {} is no joint property: its \
                 triangles are detached",
                joints[p]
            )),
            _ => {}
        }
    }
    (records, rows)
}

/// What the classic joints and contacts do differently.
fn differences(database: &Database, joints: &[usize], count: usize, lost: &mut Vec<String>) {
    if database.integer("YDC/ICFMTY") == 1 {
        lost.push("friction is Coulomb's, not Barton's and Bandis's (ICFMTY)".to_owned());
    }
    if database.integer("YDC/ICSAVF") > 0 {
        lost.push("no restart decks are written (ICSAVF)".to_owned());
    }
    if joints.is_empty() {
        return;
    }
    let of_joints = |name: &str| {
        let values = reals(database, &format!("YDP/{name}"), count, 0.0);
        joints.iter().any(|&p| values.get(p).is_some_and(|&value| value != 0.0))
    };
    lost.push(
        "joints soften by another law: the two modes are combined otherwise, and tension does not \
         lower the shear strength"
            .to_owned(),
    );
    lost.push("triangles beside an intact joint may touch each other, too".to_owned());
    lost.push("apertures and acoustic emissions of joints are not computed".to_owned());
    if of_joints("D1PEPF") {
        lost.push("joints hold no fluid pressure (D1PEPF)".to_owned());
    }
    if of_joints("D1PEFR") {
        lost.push("softened joints keep no residual friction of their own (D1PEFR)".to_owned());
    }
    if joints.len() > 1 {
        lost.push(format!(
            "each joint has the strength of its own set; the original lets all {} joint sets act \
             on all joints",
            joints.len()
        ));
    }
}
