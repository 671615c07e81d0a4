//! Reads the meaning of decks of the split and Y-Geo dialects.

use yformat::database::Database;
use yformat::dialect::Dialect;

use super::DialectError;
use super::contact::{PairLaw, PairTable};
use super::model::{ElementSet, JointSet, Model, NodeSet};
use super::read::{
    contact, control, entries, integers, node_set_columns, nodes, reals, records, set_count,
    triangles,
};

pub(super) fn model(database: &Database, lost: &mut Vec<String>) -> Result<Model, DialectError> {
    let is_ygeo = database.dialect() == Dialect::YGeo;
    let sets = set_count(database, "YDPE/NPROP")?;
    let node_sets = set_count(database, "YDPN/NPNSET")?;
    let joint_sets = set_count(database, "YDPJ/NPJSET")?;
    // The split dialect looks for a flag of exactly 1 and, with IWFAST 0, for none.
    let all_touch = !is_ygeo && database.integer("YDC/IWFAST") == 0;
    let flagged = |flag: i64| all_touch || if is_ygeo { flag > 0 } else { flag == 1 };
    let of_node = |set: i64| usize::try_from(set).ok().filter(|&set| set < node_sets);
    let nodes = nodes(database, of_node, flagged)?;
    let of_element = |element, property: i64| match usize::try_from(property) {
        Ok(set) if set < sets => Ok(set),
        _ if property == -1 => Err(DialectError::NoElementSet { element, property }),
        _ => Err(DialectError::HasJoints { element, property }),
    };
    let model = Model {
        control: control(database),
        node_room: database.integer("YDN/MNOPO"),
        element_room: database.integer("YDE/MELEM"),
        state_rows: database.integer("YDE/MELST"),
        triangles: triangles(database, nodes.len(), of_element)?,
        nodes,
        contact: contact(database),
        element_sets: element_sets(database, sets, is_ygeo, lost),
        pairs: if is_ygeo { ygeo_pairs(database, sets)? } else { split_pairs(database, sets)? },
        node_sets: read_node_sets(database, node_sets, is_ygeo, lost),
        joint_sets: read_joint_sets(database, joint_sets, is_ygeo, lost),
        meshing: meshing(database, sets),
        joint_of_pair: joint_rows(database),
    };
    modules(database, is_ygeo, lost);
    Ok(model)
}

fn element_sets(
    database: &Database,
    count: usize,
    is_ygeo: bool,
    lost: &mut Vec<String>,
) -> Vec<ElementSet> {
    let real = |name: &str| reals(database, name, count, 0.0);
    let integer = |name: &str| integers(database, name, count, 0);
    let kinds = integer("YDPE/I1PTYP");
    let (lambda, mu) = (real("YDPE/D1PELA"), real("YDPE/D1PEMU"));
    let (density, viscosity) = (real("YDPE/D1PERO"), real("YDPE/D1PEKS"));
    let (stretch, fractures) = (real("YDPE/D1PSEM"), integer("YDPE/I1PEFR"));
    let (boundary, rows) = (integer("YDPE/I1PEMB"), integer("YDPE/I1PSDE"));
    let factor = if is_ygeo { 2.0 } else { 1.0 };
    let mut sets: Vec<ElementSet> = (0..count)
        .map(|i| ElementSet {
            kind: kinds[i],
            lambda: factor * lambda[i],
            mu: mu[i],
            density: density[i],
            viscosity: viscosity[i],
            stretch: stretch[i],
            fractures: fractures[i],
            boundary_mode: boundary[i],
            state_row: rows[i],
        })
        .collect();
    if is_ygeo {
        let (young, poisson) = (real("YDPE/D1PEEM"), real("YDPE/D1PENU"));
        let anisotropy = integer("YDPE/I1USAN");
        let (excavated, support) = (integer("YDPE/I1PEXC"), integer("YDPE/I1PSUP"));
        for (i, set) in sets.iter_mut().enumerate() {
            if matches!(set.kind, 5 | 6) {
                (set.lambda, set.mu) = lame(set.kind, young[i], poisson[i]);
                set.kind = 1;
                lost.push(format!(
                    "element set {i} of plane stress or strain (type 5 or 6) becomes type 1 with \
                     the Lamé constants of its E and ν: the same at small strains only"
                ));
            }
            if matches!(anisotropy[i], 1 | 2) {
                lost.push(format!("element set {i} is not anisotropic any more (I1USAN)"));
            }
            if excavated[i] == 1 {
                lost.push(format!("element set {i} is not excavated (I1PEXC)"));
            }
            if support[i] == 1 {
                lost.push(format!("element set {i} is no support installed later (I1PSUP)"));
            }
        }
    }
    sets
}

/// Lamé constants of Young's modulus and Poisson's ratio in plane stress (5) and strain (6).
fn lame(kind: i64, young: f64, poisson: f64) -> (f64, f64) {
    let lambda = match kind {
        5 => young * poisson / (1.0 - poisson * poisson),
        _ => young * poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)),
    };
    (lambda, young / (2.0 * (1.0 + poisson)))
}

/// Penalties and friction of a pair are the smaller of the two sets'.
fn split_pairs(database: &Database, sets: usize) -> Result<PairTable, DialectError> {
    let real = |name: &str| reals(database, name, sets, 0.0);
    let (normal, tangential) = (real("YDPE/D1PEPE"), real("YDPE/D1PEPT"));
    let friction = real("YDPE/D1PEFR");
    PairTable::of(sets, |i, j| PairLaw {
        friction: friction[i].min(friction[j]),
        normal: normal[i].min(normal[j]),
        tangential: tangential[i].min(tangential[j]),
    })
}

/// Records `i j μ p_n p_t` with i ≤ j: the last one that matches counts; where none does, the
/// values of the pair before are kept, beginning with friction 0 and penalties 2e6 and 1e6.
fn ygeo_pairs(database: &Database, sets: usize) -> Result<PairTable, DialectError> {
    let mut table = PairTable::of(sets, |_, _| PairLaw::default())?;
    let mut given = std::collections::BTreeMap::new();
    if let Some(field) = database.reals("YDPE/D2PEINT") {
        for record in 0..records(field) {
            let [i, j, friction, normal, tangential] =
                [0, 1, 2, 3, 4].map(|c| field.get2(c, record));
            given.insert((i as i64, j as i64), PairLaw { friction, normal, tangential });
        }
    }
    let mut law = PairLaw { friction: 0.0, normal: 2e6, tangential: 1e6 };
    for (&(i, j), slot) in &mut table.laws {
        law = given.get(&(i as i64, j as i64)).copied().unwrap_or(law);
        *slot = law;
    }
    Ok(table)
}

fn read_node_sets(
    database: &Database,
    count: usize,
    is_ygeo: bool,
    lost: &mut Vec<String>,
) -> Vec<NodeSet> {
    let columns = node_set_columns(database, "YDPN", count, if is_ygeo { 0.0 } else { 1.0 });
    let mut sets: Vec<NodeSet> = (0..count)
        .map(|i| NodeSet {
            codes: [0, 1].map(|axis| columns.codes[axis][i]),
            amplitudes: [0, 1].map(|axis| columns.amplitudes[axis][i]),
            edge_loads: [0, 1].map(|axis| columns.edge_loads[axis][i]),
            axes: [0, 1, 2, 3].map(|axis| columns.axes[axis][i]),
            factors: Vec::new(),
        })
        .collect();
    let points = usize::try_from(database.integer("YDPN/NPNFACT")).unwrap_or(0);
    // Y-Geo ignores a table whose first time is its fill value.
    let table = database.reals("YDPN/D3PNFAC");
    let table = table.filter(|table| !(is_ygeo && table.get3(0, 0, 0) == -1.0));
    if let Some(table) = table {
        for (index, set) in sets.iter_mut().enumerate() {
            let point = |i| (table.get3(0, index, i), table.get3(1, index, i));
            let stands = |&i: &usize| table.ordinal([1, index, i]).is_some();
            set.factors = (0..points).take_while(stands).map(point).collect();
        }
    }
    if is_ygeo {
        for (index, set) in sets.iter_mut().enumerate() {
            if set.codes.contains(&4) {
                lost.push(format!(
                    "node set {index} does not absorb waves any more (code 4): it is free (code 1)"
                ));
                set.codes = set.codes.map(|code| if code == 4 { 1 } else { code });
            }
        }
    }
    sets
}

fn read_joint_sets(
    database: &Database,
    count: usize,
    is_ygeo: bool,
    lost: &mut Vec<String>,
) -> Vec<JointSet> {
    let real = |name: &str| reals(database, &format!("YDPJ/{name}"), count, 0.0);
    let kinds = integers(database, "YDPJ/I1PTYP", count, 3);
    let (tensile, shear) = (real("D1PJFT"), real("D1PJFS"));
    let (cohesion, friction) = (real("D1PJCO"), real("D1PJFR"));
    let (opening, penalty) = (real("D1PJGF"), real("D1PJPE"));
    let sliding = if is_ygeo { real("D1PJGS") } else { opening.clone() };
    if is_ygeo {
        let anisotropy = reals(database, "YDPJ/D1USAF", count, -1.0);
        for (index, _) in anisotropy.iter().enumerate().filter(|(_, exponent)| **exponent > 0.0) {
            lost.push(format!("the strength of joint set {index} is isotropic (D1USAF)"));
        }
        if database.integer("YDPJ/IUSEHY") != 0 {
            lost.push("joints unload along their loading curve (IUSEHY)".to_owned());
        }
    }
    (0..count)
        .map(|i| JointSet {
            kind: kinds[i],
            tensile_strength: tensile[i],
            shear_strength: shear[i],
            cohesion: cohesion[i],
            friction: friction[i],
            opening_energy: opening[i],
            sliding_energy: sliding[i],
            penalty: penalty[i],
        })
        .collect()
}

/// Records `count code set ...` with a code that does something.
fn meshing(database: &Database, sets: usize) -> Vec<(i64, Vec<usize>)> {
    let Some(field) = database.integers("YDPM/I2PMSET") else { return Vec::new() };
    let count = usize::try_from(database.integer("YDPM/MPMCOM")).unwrap_or(0);
    let record = |index| {
        let members = usize::try_from(field.get2(0, index)).unwrap_or(0);
        let members = (0..members)
            .take_while(|i| field.ordinal([2 + i, index, 0]).is_some())
            .filter_map(|i| usize::try_from(field.get2(2 + i, index)).ok())
            .filter(|&set| set < sets);
        (field.get2(1, index), members.collect())
    };
    (0..count.min(records(field))).map(record).collect()
}

fn joint_rows(database: &Database) -> Vec<[i64; 3]> {
    let Some(field) = database.integers("YDPM/I2PMIJ") else { return Vec::new() };
    let rows = usize::try_from(database.integer("YDPM/MPMROW")).unwrap_or(0);
    (0..rows.min(records(field)))
        .map(|row| [0, 1, 2].map(|column| field.get2(column, row)))
        .collect()
}

/// Modules that have no counterpart.
fn modules(database: &Database, is_ygeo: bool, lost: &mut Vec<String>) {
    let off = |lost: &mut Vec<String>, name: &str, what: &str| {
        if database.integer(name) > 0 {
            lost.push(format!("{what} are left out ({name})"));
        }
    };
    off(lost, "YDB/NBORH", "boreholes");
    off(lost, "YDS/NSOUR", "pressure sources");
    if database.reals("YDI/D2SLDIS").is_some_and(|field| records(field) > 0) {
        lost.push("sliding of an earlier run is forgotten (D2SLDIS)".to_owned());
    }
    if is_ygeo {
        off(lost, "YDFN/IUSEFN", "fractures of the fracture network");
        off(lost, "YDIS/IUSEIS", "in-situ stresses");
        off(lost, "YDHF/IUSEHF", "fluids in fractures");
        off(lost, "YDSB/NSBAR", "reinforcement bars");
        off(lost, "YDC/ICRESF", "restart fragments");
        if database.integer("YDC/ICOUTRF") > 0
            && database.integer("YDC/ICOUTRF") != database.integer("YDC/ICOUTF")
        {
            lost.push(
                "the output interval does not change with broken joints (ICOUTRF)".to_owned(),
            );
        }
    } else if database.integer("YDC/IWFAST") > 0
        && let Some(tags) = database.integers("YDE/I1ELBE")
        && (0..entries(tags)).any(|index| tags.get1(index) > 0)
    {
        lost.push("contact tags are left out: flags of nodes decide (I1ELBE)".to_owned());
    }
}
