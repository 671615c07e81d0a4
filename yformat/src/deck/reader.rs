//! How a deck is read: by which dialect, with which files.

use std::io;
use std::path::Path;

use super::include::{FolderIncludes, IncludeLoader, NoIncludes};
use super::parser::Parser;
use super::{Deck, Item, ItemKind, TailReason};
use crate::diagnostic::Diagnostic;
use crate::dialect::{Dialect, detect};

/// A deck and what there is to say about it.
///
/// ```
/// let outcome = yformat::deck::Deck::parse("a.y", "/YD/YDC/MCSTEP 2e4\n");
/// assert_eq!(outcome.error().unwrap().notes.help.as_deref(), Some("write 20000"));
/// ```
#[derive(Debug, Clone)]
pub struct ParseOutcome {
    /// The deck as far as it could be read.
    pub deck: Deck,
    /// Findings in the order of reading; at most one error, the one that ended the reading.
    pub diagnostics: Vec<Diagnostic>,
}

impl ParseOutcome {
    /// The error that ended the reading, if one did.
    #[must_use]
    pub fn error(&self) -> Option<&Diagnostic> {
        self.diagnostics.iter().find(|diagnostic| diagnostic.is_error())
    }

    /// Whether an error ended the reading.
    #[must_use]
    pub fn has_errors(&self) -> bool {
        self.error().is_some()
    }
}

/// Reads decks.
///
/// ```
/// use yformat::deck::DeckReader;
/// use yformat::dialect::Dialect;
///
/// let mut reader = DeckReader::new().dialect(Dialect::Split).includes(|name: &str| {
///     assert_eq!(name, "steps.y");
///     Ok(b"/YD/YDC/MCSTEP 3".to_vec())
/// });
/// let outcome = reader.parse("a.y", "$YINCL steps.y\n$YDOIT\n");
/// assert!(!outcome.has_errors());
/// assert_eq!(outcome.deck.assignments().count(), 1);
/// ```
#[derive(Default)]
pub struct DeckReader<'a> {
    dialect: Option<Dialect>,
    includes: Option<Box<dyn IncludeLoader + 'a>>,
}

impl<'a> DeckReader<'a> {
    /// A reader that detects the dialect and has no files to include.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Forces a dialect; `None` detects it.
    #[must_use]
    pub fn dialect(mut self, dialect: impl Into<Option<Dialect>>) -> Self {
        self.dialect = dialect.into();
        self
    }

    /// Says where included files come from; a closure from name to bytes will do.
    #[must_use]
    pub fn includes(mut self, includes: impl IncludeLoader + 'a) -> Self {
        self.includes = Some(Box::new(includes));
        self
    }

    /// Reads a deck from memory. `name` appears in messages.
    pub fn parse(&mut self, name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> ParseOutcome {
        match &mut self.includes {
            Some(includes) => parse(name.into(), bytes.into(), self.dialect, includes.as_mut()),
            None => parse(name.into(), bytes.into(), self.dialect, &mut NoIncludes),
        }
    }

    /// Reads a deck from a file. Unless told otherwise, included files are looked for as the
    /// original does, and beside the deck.
    ///
    /// # Errors
    /// If the file cannot be read.
    pub fn read(&mut self, path: impl AsRef<Path>) -> io::Result<ParseOutcome> {
        let path = path.as_ref();
        let (name, bytes) = (path.display().to_string(), std::fs::read(path)?);
        Ok(match &mut self.includes {
            Some(includes) => parse(name, bytes, self.dialect, includes.as_mut()),
            None => parse(name, bytes, self.dialect, &mut FolderIncludes::beside(path)),
        })
    }
}

impl std::fmt::Debug for DeckReader<'_> {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("DeckReader").field("dialect", &self.dialect).finish_non_exhaustive()
    }
}

fn parse(
    name: String,
    bytes: Vec<u8>,
    forced: Option<Dialect>,
    includes: &mut dyn IncludeLoader,
) -> ParseOutcome {
    let detection = detect(&name, &bytes);
    let dialect = forced.unwrap_or(detection.dialect);
    let (deck, mut diagnostics) = Parser::new(dialect, name, bytes).run(includes);
    let has_error = diagnostics.iter().any(Diagnostic::is_error);
    if forced.is_none() && !detection.certain && deck.assignments().next().is_some() {
        let message =
            format!("nothing in this deck tells its dialect, it is read as a {dialect} deck");
        diagnostics.insert(0, Diagnostic::note("deck::undecided-dialect", message));
    }
    let is_blank = |item: &Item| item.kind() == &ItemKind::Tail(TailReason::WhiteSpace);
    if deck.items().iter().all(is_blank) {
        diagnostics.push(
            Diagnostic::error("deck::empty", "the file is empty")
                .at(deck.sources().start())
                .expected("a deck: keywords, values and `$YDOIT`"),
        );
    } else if !has_error && !deck.items().iter().any(|item| item.kind() == &ItemKind::Run) {
        diagnostics.push(
            Diagnostic::warning("deck::no-run", "the deck never asks to run: no `$YDOIT` is read")
                .help("write `$YDOIT` after the data and end its line"),
        );
    }
    let sources = deck.sources();
    let diagnostics =
        diagnostics.into_iter().map(|diagnostic| diagnostic.located(sources)).collect();
    ParseOutcome { deck, diagnostics }
}
