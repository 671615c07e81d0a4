//! The pieces of a deck.

use std::ops::Range;

use super::array::Array;
use crate::keywords::Keyword;
use crate::source::{SourceId, Span};

/// What follows a keyword.
///
/// ```
/// use yformat::deck::{Deck, Value};
///
/// let deck = Deck::parse("a.y", "/YD/YDC/MCSTEP 5\n").deck;
/// assert_eq!(deck.items()[0].assignment().unwrap().value, Value::Integer(Some(5)));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// An integer; `None` if no number follows the keyword, which leaves the old value.
    Integer(Option<i64>),
    /// A real; `None` if no number follows the keyword, which leaves the old value.
    Real(Option<f64>),
    /// An array of integers.
    Integers(Array<i64>),
    /// An array of reals.
    Reals(Array<f64>),
}

/// A keyword and its value.
///
/// ```
/// let deck = yformat::deck::Deck::parse("a.y", "/YD/YDC/MCSTEP 5\n").deck;
/// let (index, assignment) = deck.assignments().next().unwrap();
/// assert_eq!((index, assignment.keyword.name), (0, "MCSTEP"));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Assignment {
    /// The keyword that the word is taken for.
    pub keyword: &'static Keyword,
    /// Its value.
    pub value: Value,
}

/// Why bytes at the end of a file are not read.
///
/// ```
/// use yformat::deck::{Deck, ItemKind, TailReason};
///
/// let deck = Deck::parse("a.y", "$YSTOP notes of the author").deck;
/// assert_eq!(deck.items()[1].kind(), &ItemKind::Tail(TailReason::AfterStop));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TailReason {
    /// Nothing but white space is left.
    WhiteSpace,
    /// The last word has no white space behind it, so the original throws it away.
    DroppedWord,
    /// They follow `$YSTOP`.
    AfterStop,
    /// They begin with something that ends the reading.
    AfterError,
}

/// What an item is.
///
/// ```
/// use yformat::deck::{Deck, ItemKind};
///
/// let deck = Deck::parse("a.y", "/* a */ $YDOIT\n").deck;
/// assert_eq!(deck.items()[0].kind(), &ItemKind::Comment("/* a */".to_owned()));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub enum ItemKind {
    /// A comment with its delimiters.
    Comment(String),
    /// A keyword and its value.
    Assignment(Assignment),
    /// `$YDOIT`: run the steps.
    Run,
    /// `$YSTOP`: stop reading.
    Stop,
    /// `$YINCL`: go on in another file. Its items follow this one.
    Include(String),
    /// The rest of a file, which is not read.
    Tail(TailReason),
}

/// One piece of a deck. Read items remember their bytes, new and changed ones are written in
/// canonical form.
///
/// ```
/// use yformat::deck::{Deck, ItemKind};
///
/// let deck = Deck::parse("a.y", "  $YDOIT\n").deck;
/// assert_eq!(deck.items()[0].kind(), &ItemKind::Run);
/// assert_eq!(deck.items()[0].span().unwrap().range(), 2..8);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    pub(super) kind: ItemKind,
    pub(super) file: SourceId,
    /// White space before the item; stays when the item is changed.
    pub(super) lead: Range<usize>,
    /// The item's own bytes, unless it is new or changed.
    pub(super) text: Option<Range<usize>>,
}

impl Item {
    pub(super) fn new(kind: ItemKind) -> Self {
        Item { kind, file: SourceId(0), lead: 0..0, text: None }
    }

    /// What it is.
    #[must_use]
    pub fn kind(&self) -> &ItemKind {
        &self.kind
    }

    /// The keyword and value, if it is an assignment.
    #[must_use]
    pub fn assignment(&self) -> Option<&Assignment> {
        match &self.kind {
            ItemKind::Assignment(assignment) => Some(assignment),
            _ => None,
        }
    }

    /// The file that it belongs to.
    #[must_use]
    pub fn file(&self) -> SourceId {
        self.file
    }

    /// Its bytes without the white space before it; `None` if it is new or changed.
    #[must_use]
    pub fn span(&self) -> Option<Span> {
        self.text.clone().map(|range| Span::new(self.file, range))
    }
}
