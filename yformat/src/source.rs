//! Source files and places in them.
//!
//! Everything the parser produces points back into a [`SourceMap`] through [`Span`]s, so that a
//! later check (the scene builder's, say) can still underline the number that it dislikes.

use std::borrow::Cow;
use std::fmt;
use std::ops::Range;
use std::sync::Arc;

/// Number of a source file inside its [`SourceMap`].
///
/// ```
/// let mut sources = yformat::source::SourceMap::new();
/// assert_eq!(sources.add("a.y", "$YSTOP\n").index(), 0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SourceId(pub(crate) usize);

impl SourceId {
    /// Position of the file in its map: 0 is the deck itself, the others are included files in
    /// order of opening.
    #[must_use]
    pub fn index(self) -> usize {
        self.0
    }
}

/// A range of bytes of one source file.
///
/// ```
/// use yformat::source::SourceMap;
///
/// let mut sources = SourceMap::new();
/// let deck = sources.add("wall.y", b"/YD/YDC/MCSTEP 5\n".to_vec());
/// let span = sources.span(deck, 15..16);
/// assert_eq!(sources.text(span), "5");
/// assert_eq!(sources.location(span).to_string(), "wall.y:1:16");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Span {
    /// The file.
    pub source: SourceId,
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl Span {
    pub(crate) fn new(source: SourceId, range: Range<usize>) -> Self {
        Span { source, start: range.start, end: range.end }
    }

    /// The byte range without the file.
    #[must_use]
    pub fn range(self) -> Range<usize> {
        self.start..self.end
    }

    /// Whether the span covers no byte.
    #[must_use]
    pub fn is_empty(self) -> bool {
        self.start >= self.end
    }
}

/// A place as people name it: file, line and column, both counted from 1.
///
/// ```
/// let mut sources = yformat::source::SourceMap::new();
/// let deck = sources.add("a.y", "one\ntwo\n");
/// let location = sources.location(sources.span(deck, 5..6));
/// assert_eq!((location.line, location.column), (2, 2));
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Location {
    /// Name of the file as it was given.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// Column in characters (bytes, if the line is not UTF-8), from 1.
    pub column: usize,
}

impl fmt::Display for Location {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}:{}:{}", self.file, self.line, self.column)
    }
}

/// One file: its name and its bytes, exactly as read.
///
/// ```
/// let mut sources = yformat::source::SourceMap::new();
/// sources.add("a.y", "$YSTOP\n");
/// assert_eq!(sources.iter().next().unwrap().bytes(), b"$YSTOP\n");
/// ```
#[derive(Debug, Clone)]
pub struct Source {
    name: String,
    bytes: Arc<Vec<u8>>,
}

impl Source {
    /// Name of the file as it was given.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// The bytes as read.
    #[must_use]
    pub fn bytes(&self) -> &[u8] {
        &self.bytes
    }
}

/// The deck file and the files that it includes.
///
/// ```
/// let mut sources = yformat::source::SourceMap::new();
/// let id = sources.add("a.y", b"$YSTOP\n".to_vec());
/// assert_eq!(sources.get(id).map(|s| s.name()), Some("a.y"));
/// ```
#[derive(Debug, Clone, Default)]
pub struct SourceMap {
    files: Vec<Source>,
}

impl SourceMap {
    /// A map without files.
    #[must_use]
    pub fn new() -> Self {
        Self::default()
    }

    /// Adds a file and returns its number.
    pub fn add(&mut self, name: impl Into<String>, bytes: impl Into<Vec<u8>>) -> SourceId {
        self.files.push(Source { name: name.into(), bytes: Arc::new(bytes.into()) });
        SourceId(self.files.len() - 1)
    }

    /// The file with this number, if this map has it.
    #[must_use]
    pub fn get(&self, id: SourceId) -> Option<&Source> {
        self.files.get(id.0)
    }

    /// All files in order of opening.
    pub fn iter(&self) -> impl Iterator<Item = &Source> {
        self.files.iter()
    }

    /// A span of this file, cut to the bytes that it has.
    #[must_use]
    pub fn span(&self, id: SourceId, range: Range<usize>) -> Span {
        let length = self.bytes_of(id).len();
        let start = range.start.min(length);
        Span::new(id, start..range.end.clamp(start, length))
    }

    /// The bytes under a span; empty if the span is not of this map.
    #[must_use]
    pub fn bytes(&self, span: Span) -> &[u8] {
        self.bytes_of(span.source).get(span.range()).unwrap_or_default()
    }

    /// The text under a span, bytes that are not UTF-8 read as Latin-1.
    #[must_use]
    pub fn text(&self, span: Span) -> Cow<'_, str> {
        decode(self.bytes(span))
    }

    /// Where a span begins. Costs one pass over the file up to that place, so ask for it only when
    /// reporting.
    #[must_use]
    pub fn location(&self, span: Span) -> Location {
        let bytes = self.bytes_of(span.source);
        let before = &bytes[..span.start.min(bytes.len())];
        let line_start = before.iter().rposition(|&b| b == b'\n').map_or(0, |at| at + 1);
        Location {
            file: self.get(span.source).map_or_else(String::new, |source| source.name.clone()),
            line: before.iter().filter(|&&b| b == b'\n').count() + 1,
            column: decode(&before[line_start..]).chars().count() + 1,
        }
    }

    /// The empty place at the beginning of the first file.
    pub(crate) fn start(&self) -> Span {
        Span::new(SourceId(0), 0..0)
    }

    pub(crate) fn share(&self, id: SourceId) -> Arc<Vec<u8>> {
        self.files.get(id.0).map(|source| Arc::clone(&source.bytes)).unwrap_or_default()
    }

    fn bytes_of(&self, id: SourceId) -> &[u8] {
        self.get(id).map_or(&[], Source::bytes)
    }
}

/// Reads bytes as UTF-8, or as Latin-1 where they are not: old decks carry comments in the code
/// page of their author.
pub(crate) fn decode(bytes: &[u8]) -> Cow<'_, str> {
    match std::str::from_utf8(bytes) {
        Ok(text) => Cow::Borrowed(text),
        Err(_) => Cow::Owned(bytes.iter().map(|&b| char::from(b)).collect()),
    }
}
