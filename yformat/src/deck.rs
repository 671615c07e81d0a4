//! Decks: reading, changing and writing the input files of the Y family.
//!
//! [`Deck::parse`] reads a deck as the original programs do and keeps every byte, so that writing
//! it gives back the same file. What the deck means while it is executed is the business of
//! [`Database`](crate::database::Database).

mod array;
mod assignment;
mod builder;
mod canonical;
mod comment;
mod edit;
mod entry;
mod include;
mod item;
mod lex;
mod number;
mod parser;
mod reader;
mod scan;
mod spans;
mod stages;
mod substitute;
mod unknown;
pub(crate) mod words;
mod write;

use crate::dialect::Dialect;
use crate::source::SourceMap;

pub use array::{Array, Header};
pub use builder::DeckBuilder;
pub use entry::{Entry, EntryError, EntryPath, Number};
pub use include::{FolderIncludes, IncludeLoader, NoIncludes};
pub use item::{Assignment, Item, ItemKind, TailReason, Value};
pub use reader::{DeckReader, ParseOutcome};
pub use stages::Stage;
pub use substitute::SubstituteError;

/// A deck: its items in the order in which the program meets them, and the files that they come
/// from.
///
/// ```
/// use yformat::deck::Deck;
///
/// let text = "/YD/YDC/MCSTEP 5 /* steps */\n$YDOIT\n";
/// let outcome = Deck::parse("a.y", text);
/// assert_eq!(outcome.deck.items().len(), 4); // the last line end is an item too
/// assert_eq!(outcome.deck.to_text(), text);
/// ```
#[derive(Debug, Clone)]
pub struct Deck {
    sources: SourceMap,
    dialect: Dialect,
    items: Vec<Item>,
}

impl Deck {
    /// Reads a deck that includes no other files; the dialect is detected.
    pub fn parse(name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> ParseOutcome {
        DeckReader::new().parse(name, bytes)
    }

    /// Reads a deck from a file, with the files that it includes; the dialect is detected.
    ///
    /// # Errors
    /// If the file itself cannot be read; trouble with included files is reported in the outcome.
    pub fn read(path: impl AsRef<std::path::Path>) -> std::io::Result<ParseOutcome> {
        DeckReader::new().read(path)
    }

    /// The files that the deck was read from.
    #[must_use]
    pub fn sources(&self) -> &SourceMap {
        &self.sources
    }

    /// The dialect by which it was read.
    #[must_use]
    pub fn dialect(&self) -> Dialect {
        self.dialect
    }

    /// The items in order of execution.
    #[must_use]
    pub fn items(&self) -> &[Item] {
        &self.items
    }

    /// The item with this index.
    #[must_use]
    pub fn item(&self, index: usize) -> Option<&Item> {
        self.items.get(index)
    }

    /// The assignments with their item indices.
    pub fn assignments(&self) -> impl Iterator<Item = (usize, &Assignment)> {
        self.items.iter().enumerate().filter_map(|(index, item)| Some((index, item.assignment()?)))
    }
}
