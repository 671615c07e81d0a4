//! The long form of a diagnostic, drawn by `codespan-reporting`.

use std::ops::Range;

use codespan_reporting::diagnostic::{Diagnostic as Report, Label, Severity as Level};
use codespan_reporting::files::{Error, Files};
use codespan_reporting::term;

use super::{Diagnostic, Severity};
use crate::source::{SourceMap, Span, decode};

/// Bytes shown on either side of the offending words: restart decks have lines of megabytes.
const CONTEXT: usize = 160;

pub(super) fn render(diagnostic: &Diagnostic, sources: &SourceMap) -> String {
    let level = match diagnostic.severity {
        Severity::Note => Level::Note,
        Severity::Warning => Level::Warning,
        Severity::Error => Level::Error,
    };
    let excerpt = diagnostic.span.map(|span| Excerpt::around(span, sources)).unwrap_or_default();
    let mut report =
        Report::new(level).with_code(diagnostic.code).with_message(&diagnostic.message);
    if diagnostic.span.is_some() {
        let label = Label::primary((), excerpt.underlined.clone());
        report = report
            .with_label(label.with_message(diagnostic.notes.label.as_deref().unwrap_or_default()));
    }
    let expected = diagnostic.notes.expected.iter().map(|text| format!("expected: {text}"));
    let help = diagnostic.notes.help.iter().map(|text| format!("help: {text}"));
    report = report.with_notes(expected.chain(help).collect());
    let mut out = String::new();
    match term::emit_to_string(&mut out, &term::Config::default(), &excerpt, &report) {
        Ok(()) => out,
        Err(_) => diagnostic.clone().located(sources).to_string(),
    }
}

/// The one line that is shown, with its true line and column numbers.
#[derive(Debug, Default)]
struct Excerpt {
    name: String,
    text: String,
    line: usize,
    /// Column number of the first character of `text`.
    first_column: usize,
    underlined: Range<usize>,
}

impl Excerpt {
    fn around(span: Span, sources: &SourceMap) -> Self {
        let bytes = sources.get(span.source).map_or(&[][..], |source| source.bytes());
        let start = span.start.min(bytes.len());
        let line_start = bytes[..start].iter().rposition(|&b| b == b'\n').map_or(0, |at| at + 1);
        let line_end =
            bytes[start..].iter().position(|&b| b == b'\n').map_or(bytes.len(), |at| start + at);
        // A carriage return would move the terminal's cursor; it is white space in decks anyway.
        let line_end =
            if line_end > start && bytes[line_end - 1] == b'\r' { line_end - 1 } else { line_end };
        let from = cut(bytes, start.saturating_sub(CONTEXT).max(line_start), line_start);
        let end = span.end.clamp(start, line_end).min(start + CONTEXT);
        let to = (end + CONTEXT).min(line_end);
        let before = printable(&bytes[from..start]);
        let marked = printable(&bytes[start..end]);
        let after = printable(&bytes[end..to]);
        let location = sources.location(span);
        Excerpt {
            name: location.file,
            line: location.line,
            first_column: location.column - before.chars().count(),
            underlined: before.len()..before.len() + marked.len(),
            text: before + &marked + &after,
        }
    }
}

/// Moves a cut to the left until it does not split a UTF-8 character.
fn cut(bytes: &[u8], mut at: usize, lowest: usize) -> usize {
    while at > lowest && at < bytes.len() && bytes[at] & 0xC0 == 0x80 {
        at -= 1;
    }
    at
}

/// Control characters become a replacement sign, one character each, so that columns stay true.
fn printable(bytes: &[u8]) -> String {
    let keep = |c: char| if c.is_control() && c != '\t' { char::REPLACEMENT_CHARACTER } else { c };
    decode(bytes).chars().map(keep).collect()
}

impl<'a> Files<'a> for Excerpt {
    type FileId = ();
    type Name = &'a str;
    type Source = &'a str;

    fn name(&'a self, (): ()) -> Result<&'a str, Error> {
        Ok(&self.name)
    }

    fn source(&'a self, (): ()) -> Result<&'a str, Error> {
        Ok(&self.text)
    }

    fn line_index(&'a self, (): (), _byte_index: usize) -> Result<usize, Error> {
        Ok(0)
    }

    fn line_number(&'a self, (): (), _line_index: usize) -> Result<usize, Error> {
        Ok(self.line)
    }

    fn column_number(
        &'a self,
        (): (),
        _line_index: usize,
        byte_index: usize,
    ) -> Result<usize, Error> {
        let before = self.text.get(..byte_index).unwrap_or(&self.text);
        Ok(self.first_column + before.chars().count())
    }

    fn line_range(&'a self, (): (), line_index: usize) -> Result<Range<usize>, Error> {
        match line_index {
            0 => Ok(0..self.text.len()),
            _ => Err(Error::LineTooLarge { given: line_index, max: 0 }),
        }
    }
}
