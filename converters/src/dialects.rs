//! Decks of one dialect to another (spec `deck.md` 3 and 8.2, `mechanics.md` 2.2, 4, 11).
//!
//! The deck is executed up to its first `$YDOIT`, what it then means is a model
//! with the same meaning in all dialects, and the model is written in the other dialect. What the
//! other dialect cannot say is listed, never dropped in silence.
//!
//! The elastic law of the split dialect has (λ/2)(V/V₀ − V₀/V), that of the others
//! λ(V/V₀ − V₀/V): `D1PELA` of the split dialect is twice that of the others, at any strain.

mod contact;
mod from_classic;
mod from_split;
mod loads;
mod model;
mod read;
mod to_classic;
mod to_split;
mod write;

use std::io::Write;
use std::path::Path;

use yformat::database::Database;
use yformat::deck::{Deck, DeckReader, ItemKind, Value};
use yformat::diagnostic::Diagnostic;
use yformat::dialect::Dialect;
use yformat::keywords;

use crate::error::{ConvertError, at, no_deck_there};
use crate::replace_file::replace_file;

/// Why a deck cannot be converted.
#[derive(Debug, thiserror::Error)]
pub enum DialectError {
    /// The deck has errors.
    #[error("the deck has errors; `ypsilon check` shows all of them. The first one: {}", .0.message)]
    Deck(Box<Diagnostic>),
    /// The deck is of the dialect asked for.
    #[error("this is a deck of the {0} dialect already")]
    Same(Dialect),
    /// A dialect that decks are not converted from or to.
    #[error("decks of the {0} dialect are not converted; expected split, classic or y-geo")]
    Unsupported(Dialect),
    /// The deck runs nothing.
    #[error("the deck has no $YDOIT: there is nothing to convert")]
    NothingRuns,
    /// A count is larger than what the deck gives.
    #[error("{count} is {found}, but {array} gives {given}; mend the count or give the rest")]
    Count {
        /// Keyword of the count.
        count: &'static str,
        /// Its value.
        found: i64,
        /// Keyword of the array that it counts.
        array: &'static str,
        /// How many entries the array has.
        given: usize,
    },
    /// The deck is three-dimensional.
    #[error("the deck has {0} dimensions; decks of 2 are converted")]
    Dimensions(i64),
    /// The deck has joints already: it continues a run.
    #[error(
        "element {element} is a joint already (property {property}): convert the deck that the \
         run was started with"
    )]
    HasJoints {
        /// Element index.
        element: usize,
        /// Its property.
        property: i64,
    },
    /// An element whose property is none of a triangle.
    #[error("element {element} has property {property}, which is no set of triangles")]
    NoElementSet {
        /// Element index.
        element: usize,
        /// Its property.
        property: i64,
    },
    /// An element names a node that does not exist.
    #[error("element {element} names node {node}; nodes run from 0 to {last}")]
    NoSuchNode {
        /// Element index.
        element: usize,
        /// The node.
        node: i64,
        /// The last node.
        last: i64,
    },
    /// More sets than a table of pairs can hold.
    #[error("{0} element sets need too large a table of pairs; at most 2000 are converted")]
    TooManySets(usize),
    /// A value that cannot be written.
    #[error("the values for {0} are not finite")]
    NotFinite(String),
}

/// A converted deck.
#[derive(Debug, Clone)]
pub struct ConvertedDeck {
    /// The deck.
    pub deck: Deck,
    /// What it does not say as the other one did, one sentence each.
    pub lost: Vec<String>,
}

/// Converts a deck to another dialect.
///
/// ```no_run
/// use yformat::{deck::Deck, dialect::Dialect};
/// use ypsilon_converters::dialects::convert_deck;
///
/// let deck = Deck::read("wall.y")?.deck;
/// let converted = convert_deck(&deck, Dialect::Split)?;
/// for line in &converted.lost {
///     eprintln!("{line}");
/// }
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
///
/// # Errors
/// If the deck has errors, is of that dialect, is three-dimensional or continues a run with joints.
pub fn convert_deck(deck: &Deck, to: Dialect) -> Result<ConvertedDeck, DialectError> {
    let from = deck.dialect();
    if from == to {
        return Err(DialectError::Same(to));
    }
    for dialect in [from, to] {
        if dialect == Dialect::Y3d {
            return Err(DialectError::Unsupported(dialect));
        }
    }
    let stages: Vec<_> = deck.stages().into_iter().filter(|stage| stage.runs).collect();
    let (first, later) = stages.split_first().ok_or(DialectError::NothingRuns)?;
    let mut database = Database::new(from);
    for item in first.items.clone() {
        let mut findings = database.apply(deck, item).into_iter();
        if let Some(error) = findings.find(Diagnostic::is_error) {
            return Err(DialectError::Deck(Box::new(error)));
        }
    }
    let mut lost = Vec::new();
    let model = match from {
        Dialect::Classic => from_classic::model(&database, &mut lost)?,
        _ => from_split::model(&database, &mut lost)?,
    };
    let mut writer = write::Writer::new(to);
    match to {
        Dialect::Classic => to_classic::write(&model, &mut writer, &mut lost),
        _ => to_split::write(&model, &mut writer, &mut lost)?,
    }
    histories(&database, &mut writer, &mut lost);
    let mut writer = writer.run();
    for stage in later {
        for item in stage.items.clone() {
            later_item(deck, item, to, &mut writer, &mut lost);
        }
        writer = writer.run();
    }
    let deck = writer.finish(&header(deck, from, &lost))?;
    Ok(ConvertedDeck { deck, lost })
}

/// Converts the deck in `input` to the file `output` and gives what got lost.
///
/// # Errors
/// If the deck cannot be read or converted, or the new one exists or cannot be written.
pub fn deck_to_dialect(
    input: &Path,
    output: &Path,
    to: Dialect,
) -> Result<Vec<String>, ConvertError> {
    let refused = |source| ConvertError::Dialect { path: input.to_path_buf(), source };
    let outcome = DeckReader::new().read(input).map_err(at(input))?;
    if let Some(error) = outcome.diagnostics.into_iter().find(Diagnostic::is_error) {
        return Err(refused(DialectError::Deck(Box::new(error))));
    }
    let ConvertedDeck { deck, lost } = convert_deck(&outcome.deck, to).map_err(refused)?;
    no_deck_there(output)?;
    replace_file(output, |file| file.write_all(deck.to_text().as_bytes())).map_err(at(output))?;
    Ok(lost)
}

/// The comments of the new deck: those that head the old one, then what was done.
fn header(deck: &Deck, from: Dialect, lost: &[String]) -> Vec<String> {
    let mut comments = Vec::new();
    for item in deck.items() {
        match item.kind() {
            ItemKind::Comment(text) => {
                let inside = text.trim_start_matches("/*").trim_end_matches("*/");
                comments.push(inside.trim().to_owned());
            }
            _ => break,
        }
    }
    comments.push(format!("Converted by ypsilon from the {from} dialect."));
    comments.extend(lost.iter().map(|line| format!("Not as before: {line}")));
    comments
}

/// The history database is the same in all dialects, but not all types are computed by all.
fn histories(database: &Database, writer: &mut write::Writer, lost: &mut Vec<String>) {
    let count = usize::try_from(database.integer("YDO/MOHYS")).unwrap_or(0);
    if count == 0 {
        return;
    }
    writer.integer("YDO/MOHYS", database.integer("YDO/MOHYS"));
    writer.integer("YDO/NOHYS", database.integer("YDO/NOHYS"));
    writer.real("YDO/DOHYP", database.real("YDO/DOHYP"));
    for name in ["D1OHYC", "D1OHYF", "D1OHYS", "D1OHYT", "D1OHYX", "D1OHYY"] {
        let name = format!("YDO/{name}");
        if let Some(field) = database.reals(&name) {
            writer.reals(&name, (0..read::entries(field)).map(|index| field.get1(index)).collect());
        }
    }
    if let Some(field) = database.integers("YDO/I1OHYT") {
        let types: Vec<i64> = (0..read::entries(field)).map(|index| field.get1(index)).collect();
        let known: &[i64] = match writer.dialect() {
            Dialect::Classic => &[15],
            Dialect::YGeo => &[1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 18, 19, 21],
            _ => &[1, 2, 3, 4, 5, 6, 7, 8, 9, 15, 18, 19],
        };
        for (index, kind) in types.iter().enumerate().filter(|(_, kind)| !known.contains(kind)) {
            lost.push(format!(
                "history {index} is of type {kind}, which the {} dialect does not compute",
                writer.dialect()
            ));
        }
        writer.integers("YDO/I1OHYT", types);
    }
}

/// An item of a later stage: control values are carried over, everything else is listed.
fn later_item(
    deck: &Deck,
    item: usize,
    to: Dialect,
    writer: &mut write::Writer,
    lost: &mut Vec<String>,
) {
    let Some(given) = deck.item(item).and_then(|item| item.assignment()) else { return };
    let name = format!("{}/{}", given.keyword.database, given.keyword.name);
    let known = given.keyword.database == "YDC" && keywords::find(to, &name).is_some();
    match &given.value {
        Value::Integer(Some(value)) if known => writer.integer(&name, *value),
        Value::Real(Some(value)) if known => writer.real(&name, *value),
        _ => lost.push(format!("{} of a later stage is left out", given.keyword.path())),
    }
}
