//! Writing: read items give back their bytes, the others their canonical text.

use std::io;

use super::canonical;
use super::item::Item;
use super::lex::is_space;
use super::{Deck, ItemKind, TailReason};
use crate::source::{SourceId, decode};

impl Deck {
    /// The bytes of the deck file. What was read and not changed comes out as it was.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        self.file_to_bytes(SourceId(0))
    }

    /// The deck file as text, bytes that are not UTF-8 read as Latin-1. Write [`Deck::to_bytes`],
    /// not this, to a file.
    #[must_use]
    pub fn to_text(&self) -> String {
        decode(&self.to_bytes()).into_owned()
    }

    /// Writes the deck file.
    ///
    /// # Errors
    /// If `out` cannot be written to.
    pub fn write_to(&self, mut out: impl io::Write) -> io::Result<()> {
        out.write_all(&self.to_bytes())
    }

    /// The bytes of the deck file or of one of the files that it includes.
    #[must_use]
    pub fn file_to_bytes(&self, file: SourceId) -> Vec<u8> {
        let mut out = Vec::new();
        let mut last_is_canonical = false;
        for item in self.items.iter().filter(|item| item.file == file) {
            let source = self.sources.get(file).map_or(&[][..], |source| source.bytes());
            out.extend_from_slice(source.get(item.lead.clone()).unwrap_or_default());
            let text = item.text.clone().and_then(|text| source.get(text));
            let separate = (last_is_canonical || text.is_none()) && item.lead.is_empty();
            if separate
                && !out.last().copied().is_none_or(is_space)
                && !text.is_some_and(begins_with_space)
            {
                out.push(b'\n');
            }
            match text {
                Some(text) => out.extend_from_slice(text),
                None => out.extend_from_slice(canonical::item(&item.kind).as_bytes()),
            }
            last_is_canonical = text.is_none();
        }
        if last_is_canonical && !out.ends_with(b"\n") && !out.is_empty() {
            out.push(b'\n');
        }
        out
    }

    /// The lines that the original writes into `Ytmp` while it reads the deck: every command and
    /// keyword, as spelled. The word that ends the reading with an error is among them, if it
    /// begins as one of these.
    ///
    /// ```
    /// let deck = yformat::deck::Deck::parse("a.y", "/YD/YDC/MCSTEPS 5 /* x */ $YDOIT\n").deck;
    /// assert_eq!(deck.echo_lines(), ["/YD/YDC/MCSTEPS", "$YDOIT"]);
    /// ```
    #[must_use]
    pub fn echo_lines(&self) -> Vec<String> {
        let mut lines = Vec::new();
        let mut open: Vec<SourceId> = Vec::new();
        for (index, item) in self.items.iter().enumerate() {
            while open.last().is_some_and(|file| *file != item.file) {
                open.pop();
                lines.push("* close included-file.".to_owned());
            }
            lines.extend(self.echo_line(index, item));
            if let ItemKind::Include(name) = &item.kind {
                lines.push(format!("* open included-file: {name}"));
                // Files are numbered as they are opened, so the items of this one have a higher
                // number.
                match self.items.get(index + 1).map(Item::file) {
                    Some(next) if next > item.file => open.push(next),
                    _ => lines.push("* close included-file.".to_owned()),
                }
            }
        }
        lines
    }

    /// The word that the original echoes for one item, if it echoes one.
    #[must_use]
    pub fn echo_of(&self, index: usize) -> Option<String> {
        self.echo_line(index, self.item(index)?)
    }

    fn echo_line(&self, index: usize, item: &Item) -> Option<String> {
        let canonical = match &item.kind {
            ItemKind::Tail(TailReason::AfterError) if !self.follows_tail(index) => {
                let word = self.sources.text(self.word_span(index)?);
                return ["/YD/", "$YINCL"]
                    .iter()
                    .any(|known| word.starts_with(known))
                    .then(|| word.into_owned());
            }
            ItemKind::Comment(_) | ItemKind::Tail(_) => return None,
            ItemKind::Assignment(given) => given.keyword.path(),
            ItemKind::Run => "$YDOIT".to_owned(),
            ItemKind::Stop => "$YSTOP".to_owned(),
            ItemKind::Include(_) => "$YINCL".to_owned(),
        };
        Some(self.word_span(index).map_or(canonical, |span| self.sources.text(span).into_owned()))
    }

    /// Whether the item before is a tail too: the rest of a file that includes the one with the
    /// error.
    fn follows_tail(&self, index: usize) -> bool {
        let before = index.checked_sub(1).and_then(|before| self.item(before));
        before.is_some_and(|item| matches!(item.kind, ItemKind::Tail(TailReason::AfterError)))
    }
}

fn begins_with_space(text: &[u8]) -> bool {
    text.first().copied().is_some_and(is_space)
}
