//! Reading values of a deck, and what the dialects have in common.

use yformat::database::{Database, Field};

use super::DialectError;
use super::model::{Contact, Control, Node, Triangle};

/// Most sets of one kind.
const MOST_SETS: i64 = 1_000_000;

/// Entries 0 to `count` of an array of reals; `absent` where the deck does not have it.
pub(super) fn reals(database: &Database, name: &str, count: usize, absent: f64) -> Vec<f64> {
    match database.reals(name) {
        Some(field) => (0..count).map(|index| field.get1(index)).collect(),
        None => vec![absent; count],
    }
}

/// Entries 0 to `count` of an array of integers; `absent` where the deck does not have it.
pub(super) fn integers(database: &Database, name: &str, count: usize, absent: i64) -> Vec<i64> {
    match database.integers(name) {
        Some(field) => (0..count).map(|index| field.get1(index)).collect(),
        None => vec![absent; count],
    }
}

/// How many entries of an array of rank 1 stand in the deck. Its count may say more.
pub(super) fn entries<T: Copy>(field: &Field<T>) -> usize {
    (0..).take_while(|&index| field.ordinal([index, 0, 0]).is_some()).count()
}

/// How many records of an array of rank 2 stand in the deck, at least in part.
pub(super) fn records<T: Copy>(field: &Field<T>) -> usize {
    (0..).take_while(|&index| field.ordinal([0, index, 0]).is_some()).count()
}

/// A number of sets.
pub(super) fn set_count(database: &Database, count: &'static str) -> Result<usize, DialectError> {
    let found = database.integer(count);
    match usize::try_from(found) {
        Ok(sets) if found <= MOST_SETS => Ok(sets),
        Ok(_) => {
            Err(DialectError::Count { count, found, array: "the deck", given: MOST_SETS as usize })
        }
        Err(_) => Ok(0),
    }
}

/// A count that an array of rank 2 must have the records for.
fn record_count<T: Copy>(
    database: &Database,
    count: &'static str,
    array: &'static str,
    field: Option<&Field<T>>,
) -> Result<usize, DialectError> {
    let found = database.integer(count);
    let given = field.map_or(0, records);
    match usize::try_from(found) {
        Ok(value) if value <= given => Ok(value),
        _ => Err(DialectError::Count { count, found, array, given }),
    }
}

/// Values that the YDC databases of all dialects share.
pub(super) fn control(database: &Database) -> Control {
    let scale = |name: &str| database.given(name).map(|_| database.real(name));
    Control {
        last_step: database.integer("YDC/MCSTEP"),
        first_step: database.integer("YDC/NCSTEP"),
        gravity: database.real("YDC/DCGRAY"),
        time_step: database.real("YDC/DCSTEC"),
        start: database.real("YDC/DCTIME"),
        output_interval: database.integer("YDC/ICOUTF").max(1),
        output_number: database.integer("YDC/ICOUTI"),
        output_digits: database.integer("YDC/ICOUTP"),
        scales: ["YDC/DCSIZC", "YDC/DCSIZF", "YDC/DCSIZS", "YDC/DCSIZV"].map(scale),
    }
}

/// Values that the YDI databases of all dialects share.
pub(super) fn contact(database: &Database) -> Contact {
    Contact {
        couples: database.integer("YDI/MICOUP"),
        travelled: database.real("YDI/DIEDI"),
        buffer: database.real("YDI/DIEZON"),
    }
}

/// The nodes; `set` finds the node set of what I1NOPR says, `flagged` tells what I1NOBF means.
pub(super) fn nodes(
    database: &Database,
    set: impl Fn(i64) -> Option<usize>,
    flagged: impl Fn(i64) -> bool,
) -> Result<Vec<Node>, DialectError> {
    let dimensions = database.integer("YDN/NNODIM");
    if dimensions != 2 {
        return Err(DialectError::Dimensions(dimensions));
    }
    let initial = database.reals("YDN/D2NCI");
    let count = record_count(database, "YDN/NNOPO", "YDN/D2NCI", initial)?;
    let current = database.reals("YDN/D2NCC").or(initial);
    let velocity = database.reals("YDN/D2NVC");
    let flags = integers(database, "YDN/I1NOBF", count, 0);
    let sets = integers(database, "YDN/I1NOPR", count, -1);
    let pair = |field: Option<&Field<f64>>, index: usize| {
        field.map_or([0.0; 2], |field| [field.get2(0, index), field.get2(1, index)])
    };
    let node = |(index, (flag, of)): (usize, (i64, i64))| Node {
        initial: pair(initial, index),
        current: pair(current, index),
        velocity: pair(velocity, index),
        flagged: flagged(flag),
        set: set(of),
    };
    Ok(flags.into_iter().zip(sets).enumerate().map(node).collect())
}

/// The triangles; `set` finds the element set of what I1ELPR says.
pub(super) fn triangles(
    database: &Database,
    nodes: usize,
    set: impl Fn(usize, i64) -> Result<usize, DialectError>,
) -> Result<Vec<Triangle>, DialectError> {
    let corners = database.integers("YDE/I2ELTO");
    let count = record_count(database, "YDE/NELEM", "YDE/I2ELTO", corners)?;
    let sets = integers(database, "YDE/I1ELPR", count, -1);
    let mut triangles = Vec::new();
    for (element, of) in sets.into_iter().enumerate() {
        let set = set(element, of)?;
        let corner = |row: usize| corners.map_or(-1, |field| field.get2(row, element));
        let triangle = Triangle { nodes: [corner(0), corner(1), corner(2)], set };
        let wrong = |&&node: &&i64| usize::try_from(node).map_or(true, |node| node >= nodes);
        if let Some(&node) = triangle.nodes.iter().find(wrong) {
            let last = i64::try_from(nodes).unwrap_or(i64::MAX) - 1;
            return Err(DialectError::NoSuchNode { element, node, last });
        }
        triangles.push(triangle);
    }
    Ok(triangles)
}

/// Node positions and local axes of a set database; `absent` amplitudes where not given.
pub(super) struct NodeSetColumns {
    /// Codes in the local directions.
    pub(super) codes: [Vec<i64>; 2],
    /// Amplitudes in the local directions.
    pub(super) amplitudes: [Vec<f64>; 2],
    /// Pressure and traction.
    pub(super) edge_loads: [Vec<f64>; 2],
    /// Local axes.
    pub(super) axes: [Vec<f64>; 4],
}

/// The columns of the node sets in the database `YDP` or `YDPN`.
pub(super) fn node_set_columns(
    database: &Database,
    of: &str,
    count: usize,
    absent_amplitude: f64,
) -> NodeSetColumns {
    let real = |name: &str, absent| reals(database, &format!("{of}/{name}"), count, absent);
    let integer = |name: &str| integers(database, &format!("{of}/{name}"), count, -1);
    NodeSetColumns {
        codes: [integer("I1PNFX"), integer("I1PNFY")],
        amplitudes: [real("D1PNAX", absent_amplitude), real("D1PNAY", absent_amplitude)],
        edge_loads: [real("D1PNAP", 0.0), real("D1PNAT", 0.0)],
        axes: [real("D1PNXX", 1.0), real("D1PNXY", 0.0), real("D1PNYX", 0.0), real("D1PNYY", 1.0)],
    }
}
