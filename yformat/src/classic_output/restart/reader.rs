//! From a deck to the model.

use super::rows::Column;
use super::{Contact, Control, Elements, Nodes, RestartDeck};
use crate::classic_output::{RestartError, Table};
use crate::database::Database;
use crate::deck::{Deck, DeckReader, ItemKind};
use crate::diagnostic::Diagnostic;
use crate::dialect::Dialect;
use crate::ym::Scales;

/// The only array of reals that says how many there are of something.
const COORDINATES: &str = "YDN/D2NCC";
/// More nodes per element than any element has.
const MOST_NODES: i64 = 16;

impl RestartDeck {
    /// Reads the text of a restart deck, or of any deck of the classic dialect. `name` appears in
    /// messages. Warnings and notes are returned beside the deck, the one about the number of masses
    /// among them.
    ///
    /// # Errors
    /// See [`RestartDeck::from_deck`]; also what is wrong with the text.
    pub fn parse(
        name: impl Into<String>,
        text: impl Into<Vec<u8>>,
    ) -> Result<(Self, Vec<Diagnostic>), RestartError> {
        let outcome = DeckReader::new().dialect(Dialect::Classic).parse(name, text);
        if let Some(error) = outcome.diagnostics.iter().find(|found| found.is_error()) {
            return Err(RestartError::Deck(Box::new(error.clone())));
        }
        Ok((Self::from_deck(&outcome.deck)?, outcome.diagnostics))
    }

    /// The values that the first stage of a deck of the classic dialect leaves in the program. What
    /// the deck does not give has the program's value: -1 or 0 in most lists.
    ///
    /// # Errors
    /// If the deck is of another dialect, if its values do not fit its sizes, or if it has fewer
    /// elements, joints, nodes, property sets or histories than it announces.
    pub fn from_deck(deck: &Deck) -> Result<Self, RestartError> {
        if deck.dialect() != Dialect::Classic {
            let message =
                format!("a classic restart deck is expected, this is a {} deck", deck.dialect());
            let error = Diagnostic::error("deck::unknown-dialect", message);
            return Err(RestartError::Deck(Box::new(error)));
        }
        let mut values = Database::new(Dialect::Classic);
        for (index, item) in deck.items().iter().enumerate() {
            if item.kind() == &ItemKind::Run {
                break;
            }
            let found = values.apply(deck, index);
            if let Some(error) = found.into_iter().find(Diagnostic::is_error) {
                return Err(RestartError::Deck(Box::new(error)));
            }
        }
        Self::from_values(deck, &values)
    }

    /// The values that a stage of a deck leaves in the program.
    ///
    /// # Errors
    /// As [`RestartDeck::from_deck`].
    pub fn from_values(deck: &Deck, values: &Database) -> Result<Self, RestartError> {
        let joints = announced(values, "YDJ/NJOINT", "YDJ/I1JTID", 0)?;
        let property_sets = announced(values, "YDP/NPROP", "YDP/I1PTYP", 0)?;
        let histories = announced(values, "YDO/NOHYS", "YDO/I1OHYT", 0)?;
        Ok(Self {
            control: control(values),
            elements: elements(values)?,
            joints: rows(values, joints, super::JointState::REALS, super::JointState::INTEGERS),
            contact: Contact {
                couple_capacity: values.integer("YDI/MICOUP"),
                buffer: values.real("YDI/DIEZON"),
            },
            nodes: nodes(deck, values)?,
            property_capacity: values.integer("YDP/MPROP"),
            properties: rows(
                values,
                property_sets,
                super::PropertySet::REALS,
                super::PropertySet::INTEGERS,
            ),
            history_capacity: values.integer("YDO/MOHYS"),
            history_threshold: values.real("YDO/DOHYP"),
            histories: rows(
                values,
                histories,
                super::HistoryState::REALS,
                super::HistoryState::INTEGERS,
            ),
        })
    }
}

fn control(values: &Database) -> Control {
    Control {
        end_step: values.integer("YDC/MCSTEP"),
        next_step: values.integer("YDC/NCSTEP"),
        gravity: values.real("YDC/DCGRAY"),
        scales: Scales::from_database(values).unwrap_or_default(),
        time_step: values.real("YDC/DCSTEC"),
        time: values.real("YDC/DCTIME"),
        settling_time: values.real("YDC/DCGRST"),
        ramp_time: values.real("YDC/DCRMPT"),
        output_interval: values.integer("YDC/ICOUTF"),
        next_snapshot: values.integer("YDC/ICOUTI"),
        restart_interval: values.integer("YDC/ICSAVF"),
        digits: values.integer("YDC/ICOUTP"),
        friction_law: values.integer("YDC/ICFMTY"),
        aperture_law: values.integer("YDC/ICIATY"),
    }
}

fn elements(values: &Database) -> Result<Elements, RestartError> {
    let count = announced(values, "YDE/NELEM", "YDE/I2ELTO", 1)?;
    let columns = node_count(values, "YDE/MELNO")?;
    let nodes_per_element = values.integer("YDE/NELNO");
    let edges = node_count(values, "YDE/NELNO")?;
    let kinds = integers(values, "YDE/I1ELTY", count, -1);
    let table = |name, columns: usize| {
        let field = values.integers(name);
        let entry = |index: usize| field.map_or(-1, |f| f.get2(index % columns, index / columns));
        Table::new(columns, (0..count * columns).map(entry).collect())
    };
    let strengths = values.reals("YDE/D2ELFS");
    let strength =
        |index: usize| strengths.map_or(0.0, |f| f.get2(index % columns, index / columns));
    Ok(Elements {
        capacity: values.integer("YDE/MELEM"),
        state_rows: values.integer("YDE/MELST"),
        states: values.integer("YDE/NELST"),
        nodes_per_element,
        kinds,
        properties: integers(values, "YDE/I1ELPR", count, -1),
        nodes: table("YDE/I2ELTO", columns),
        shear_strengths: Table::new(columns, (0..count * columns).map(strength).collect()),
        joints: table("YDE/I2ELJP", edges),
    })
}

fn nodes(deck: &Deck, values: &Database) -> Result<Nodes, RestartError> {
    let count = announced(values, "YDN/NNOPO", COORDINATES, 1)?;
    let vectors = |name| -> Vec<[f64; 2]> {
        let field = values.reals(name);
        let entry = |node: usize, axis: usize| field.map_or(0.0, |f| f.get2(axis, node));
        (0..count).map(|node| [entry(node, 0), entry(node, 1)]).collect()
    };
    Ok(Nodes {
        dimension_capacity: values.integer("YDN/MNODIM"),
        capacity: values.integer("YDN/MNOPO"),
        coordinates: vectors(COORDINATES),
        initial_coordinates: vectors("YDN/D2NCI"),
        forces: vectors("YDN/D2NFC"),
        masses: masses(deck, values, count),
        velocities: vectors("YDN/D2NVC"),
        boundary_flags: integers(values, "YDN/I1NOBF", count, 1),
        properties: integers(values, "YDN/I1NOPR", count, -1),
    })
}

/// The masses, also those that follow the count 0.
fn masses(deck: &Deck, values: &Database, count: usize) -> Vec<f64> {
    let given = values.reals("YDN/D1NMCT");
    let announced = given.is_some_and(|field| field.given_shape().iter().any(|&n| n > 0));
    if announced || given.is_none() {
        return (0..count).map(|node| given.map_or(0.0, |field| field.get1(node))).collect();
    }
    let item = values.given("YDN/D1NMCT").and_then(|index| deck.item(index));
    let text = item.and_then(|item| item.span()).map(|span| deck.sources().text(span));
    // the keyword and the count come first
    let words = text.as_deref().unwrap_or_default().split_whitespace().skip(2);
    let mut masses: Vec<f64> = words.map_while(|word| word.parse().ok()).take(count).collect();
    masses.resize(count, 0.0);
    masses
}

/// How many there are by the size keyword, if the array gives as many along `axis`.
fn announced(
    values: &Database,
    size: &'static str,
    array: &'static str,
    axis: usize,
) -> Result<usize, RestartError> {
    let announced = values.integer(size);
    let shape = match array {
        COORDINATES => values.reals(array).map(|field| field.given_shape()),
        _ => values.integers(array).map(|field| field.given_shape()),
    };
    let found = shape.and_then(|shape| shape.get(axis).copied()).unwrap_or(0);
    match usize::try_from(announced.max(0)) {
        Ok(count) if count <= found => Ok(count),
        _ => Err(RestartError::Missing { size, announced, array, found }),
    }
}

fn node_count(values: &Database, keyword: &'static str) -> Result<usize, RestartError> {
    let found = values.integer(keyword);
    match usize::try_from(found) {
        Ok(count) if found <= MOST_NODES => Ok(count),
        _ => Err(RestartError::OutOfRange { keyword, found, expected: "0 to 16 nodes" }),
    }
}

fn integers(values: &Database, name: &str, count: usize, absent: i64) -> Vec<i64> {
    let field = values.integers(name);
    (0..count).map(|index| field.map_or(absent, |field| field.get1(index))).collect()
}

/// Rows from one list per column.
fn rows<R: Default>(
    values: &Database,
    count: usize,
    reals: &[Column<R, f64>],
    integers: &[Column<R, i64>],
) -> Vec<R> {
    let mut rows: Vec<R> = std::iter::repeat_with(R::default).take(count).collect();
    for column in reals {
        if let Some(field) = values.reals(column.keyword) {
            rows.iter_mut().enumerate().for_each(|(k, row)| (column.set)(row, field.get1(k)));
        }
    }
    for column in integers {
        let field = values.integers(column.keyword);
        let value = |k| field.map_or(-1, |field| field.get1(k));
        rows.iter_mut().enumerate().for_each(|(k, row)| (column.set)(row, value(k)));
    }
    rows
}
