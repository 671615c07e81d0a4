//! The top level: word after word, until the deck ends or something ends the reading.

use std::sync::Arc;

use super::include::IncludeLoader;
use super::item::{Item, ItemKind, TailReason};
use super::lex::{LONGEST_WORD, Word, WordKind, classify, next_word};
use super::unknown::{self, Before};
use super::{Deck, assignment, comment};
use crate::diagnostic::Diagnostic;
use crate::dialect::Dialect;
use crate::source::{SourceId, SourceMap, Span};

/// Files that may be open at once: the deck and nine included ones.
const DEEPEST: usize = 10;
/// Files that a deck may include altogether. Nine levels of files that include each other often
/// would never end.
const MOST_INCLUDES: usize = 10_000;
/// Warnings kept; a deck with more of them is wrong throughout.
const MOST_WARNINGS: usize = 100;

/// A file being read.
struct Frame {
    source: SourceId,
    bytes: Arc<Vec<u8>>,
    at: usize,
}

/// Reads a deck and the files that it includes.
pub(super) struct Parser {
    dialect: Dialect,
    sources: SourceMap,
    items: Vec<Item>,
    diagnostics: Vec<Diagnostic>,
    frames: Vec<Frame>,
    /// The warning about missing values of the last assignment, withheld until it is clear what
    /// follows.
    short: Option<Diagnostic>,
    includes: usize,
}

/// What to do after a word.
enum Next {
    GoOn,
    Stop,
}

impl Parser {
    pub(super) fn new(dialect: Dialect, name: String, bytes: Vec<u8>) -> Self {
        let mut sources = SourceMap::new();
        let source = sources.add(name, bytes);
        let frames = vec![Frame { source, bytes: sources.share(source), at: 0 }];
        Parser {
            dialect,
            sources,
            items: Vec::new(),
            diagnostics: Vec::new(),
            frames,
            short: None,
            includes: 0,
        }
    }

    pub(super) fn run(mut self, loader: &mut dyn IncludeLoader) -> (Deck, Vec<Diagnostic>) {
        while let Some(frame) = self.frames.last() {
            let (source, bytes, at) = (frame.source, Arc::clone(&frame.bytes), frame.at);
            let word = match next_word(&bytes, at) {
                Some(word) if word.terminated => word,
                last => {
                    self.flush_short();
                    self.end_file(source, &bytes, last);
                    continue;
                }
            };
            match self.step(source, &bytes, word, loader) {
                Ok(Next::GoOn) => {}
                Ok(Next::Stop) => self.leave_all(TailReason::AfterStop),
                Err(error) => {
                    self.diagnostics.push(error);
                    self.leave_all(TailReason::AfterError);
                }
            }
        }
        let deck = Deck { sources: self.sources, dialect: self.dialect, items: self.items };
        (deck, self.diagnostics)
    }

    fn step(
        &mut self,
        source: SourceId,
        bytes: &[u8],
        word: Word,
        loader: &mut dyn IncludeLoader,
    ) -> Result<Next, Diagnostic> {
        let span = Span::new(source, word.range);
        let text = &bytes[span.range()];
        if text.len() > LONGEST_WORD {
            self.flush_short();
            return Err(comment::too_long_word(span));
        }
        let kind = classify(text, self.dialect.has_include());
        if !matches!(kind, WordKind::Comment | WordKind::Unknown) {
            self.flush_short();
        }
        match kind {
            WordKind::Stop => {
                self.push(ItemKind::Stop, span, span.end);
                return Ok(Next::Stop);
            }
            WordKind::Run => self.push(ItemKind::Run, span, span.end),
            WordKind::Include => self.include(bytes, span, loader)?,
            WordKind::Comment => {
                let mut warnings = Vec::new();
                let end = comment::read(source, bytes, span, &mut warnings)?;
                self.warn(warnings);
                let text = crate::source::decode(&bytes[span.start..end]).into_owned();
                self.push(ItemKind::Comment(text), span, end);
            }
            WordKind::Data => {
                let read = assignment::read(self.dialect, source, bytes, span)?;
                self.warn(read.warnings);
                self.short = read.short;
                self.push(ItemKind::Assignment(read.assignment), span, read.end);
            }
            WordKind::Unknown => {
                return Err(unknown::word(self.dialect, bytes, span, &self.before(source)));
            }
        }
        Ok(Next::GoOn)
    }

    fn include(
        &mut self,
        bytes: &[u8],
        word: Span,
        loader: &mut dyn IncludeLoader,
    ) -> Result<(), Diagnostic> {
        let failed = |code, message: &str, span, help: &str| {
            Err(Diagnostic::error(code, message).at(span).help(help))
        };
        let Some(name) = next_word(bytes, word.end).filter(|name| name.terminated) else {
            return failed(
                "deck::include-without-name",
                "no file name with white space behind it follows",
                word,
                "write the name of a file, without blanks, and end the line",
            );
        };
        let span = Span::new(word.source, name.range);
        if span.range().len() > LONGEST_WORD {
            return Err(comment::too_long_word(span));
        }
        if self.frames.len() >= DEEPEST {
            return failed(
                "deck::include-too-deep",
                "too many files include each other: nine levels are allowed",
                span,
                "does a file include itself, directly or through another one?",
            );
        }
        self.includes += 1;
        if self.includes > MOST_INCLUDES {
            return failed(
                "deck::too-many-includes",
                "the deck includes more than 10000 files",
                span,
                "put the data into fewer files",
            );
        }
        let file = self.sources.text(span).into_owned();
        let included = loader.load(&file).map_err(|reason| {
            let reason = match reason.kind() {
                std::io::ErrorKind::NotFound => "there is no such file".to_owned(),
                _ => reason.to_string(),
            };
            Diagnostic::error(
                "deck::include-missing",
                format!("`{file}` cannot be included: {reason}"),
            )
            .at(span)
            .help("files are looked for in the working directory, then beside the deck")
        })?;
        self.push(ItemKind::Include(file.clone()), word, span.end);
        let source = self.sources.add(file, included);
        self.frames.push(Frame { source, bytes: self.sources.share(source), at: 0 });
        Ok(())
    }

    /// What was read before an unknown word.
    fn before(&self, source: SourceId) -> Before<'_> {
        let is_comment = |item: &&Item| matches!(item.kind(), ItemKind::Comment(_));
        let comments = self.items.iter().rev().take_while(is_comment).count();
        let (items, comments) = self.items.split_at(self.items.len() - comments);
        let last = items.last();
        let end = last
            .filter(|item| item.file == source)
            .and_then(|item| item.text.as_ref())
            .map(|text| text.end);
        Before {
            assignment: last.and_then(Item::assignment),
            end,
            comment: comments.first().and_then(Item::span),
            short: self.short.is_some(),
        }
    }

    fn push(&mut self, kind: ItemKind, word: Span, end: usize) {
        if let Some(frame) = self.frames.last_mut() {
            let lead = frame.at..word.start;
            frame.at = end;
            self.items.push(Item { kind, file: word.source, lead, text: Some(word.start..end) });
        }
    }

    /// The file ends: nothing is left, or a word without white space behind it, which is thrown
    /// away.
    fn end_file(&mut self, source: SourceId, bytes: &[u8], last: Option<Word>) {
        let reason = match last {
            Some(word) => {
                let text = &bytes[word.range.clone()];
                let harmless = text.starts_with(b"$YSTOP") || text == b"\x1a";
                if !harmless {
                    let message =
                        "the last word of the file has no line end behind it and is not read";
                    let warning = Diagnostic::warning("deck::dropped-word", message)
                        .at(Span::new(source, word.range));
                    self.warn(vec![warning.label("thrown away").help("end the line")]);
                }
                TailReason::DroppedWord
            }
            None => TailReason::WhiteSpace,
        };
        self.leave(reason);
    }

    /// Leaves the innermost file; what is left of it becomes a tail.
    fn leave(&mut self, reason: TailReason) {
        if let Some(frame) = self.frames.pop()
            && frame.at < frame.bytes.len()
        {
            let (lead, text) = (frame.at..frame.at, Some(frame.at..frame.bytes.len()));
            self.items.push(Item { kind: ItemKind::Tail(reason), file: frame.source, lead, text });
        }
    }

    fn leave_all(&mut self, reason: TailReason) {
        while !self.frames.is_empty() {
            self.leave(reason);
        }
    }

    fn flush_short(&mut self) {
        let short = self.short.take();
        self.warn(short.into_iter().collect());
    }

    fn warn(&mut self, warnings: Vec<Diagnostic>) {
        let room = MOST_WARNINGS.saturating_sub(self.diagnostics.len());
        self.diagnostics.extend(warnings.into_iter().take(room));
    }
}
