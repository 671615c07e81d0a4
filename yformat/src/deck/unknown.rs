//! Explains words that the top level does not know: mostly numbers where no number is read.

use super::item::{Assignment, Value};
use super::lex::is_space;
use super::number::{Number, Scan};
use crate::diagnostic::Diagnostic;
use crate::dialect::Dialect;
use crate::keywords::{self, NumberKind, Table};
use crate::source::Span;

/// What was read before an unknown word.
pub(super) struct Before<'a> {
    /// The last assignment, if it is the last item but for comments.
    pub assignment: Option<&'a Assignment>,
    /// First byte behind that assignment, if it is in the same file.
    pub end: Option<usize>,
    /// The first comment behind it.
    pub comment: Option<Span>,
    /// Whether some of its values are missing.
    pub short: bool,
}

/// Explains a word that is neither keyword, command nor comment.
pub(super) fn word(dialect: Dialect, bytes: &[u8], word: Span, before: &Before<'_>) -> Diagnostic {
    let text = bytes.get(word.range()).unwrap_or_default();
    if word.start == 0 && text.starts_with(b"\xEF\xBB\xBF") {
        return Diagnostic::error(
            "deck::byte-order-mark",
            "the file begins with a byte order mark",
        )
        .at(Span { end: 3, ..word })
        .help("save it as UTF-8 without byte order mark, or as ASCII");
    }
    if word.start == 0 && (text.starts_with(b"\xFF\xFE") || text.starts_with(b"\xFE\xFF")) {
        return Diagnostic::error("deck::byte-order-mark", "the file is encoded as UTF-16")
            .at(Span { end: 2, ..word })
            .expected("one byte for each character")
            .help("save it as ASCII, or as UTF-8 without byte order mark");
    }
    if let Some(assignment) = before.assignment {
        if before.end == Some(word.start) && word.start > 0 {
            let wants_integer =
                assignment.keyword.number == NumberKind::Integer || ends_in_header(assignment);
            return glued(&assignment.keyword.path(), wants_integer, bytes, word);
        }
        if let (Some(comment), true) = (before.comment, before.short) {
            let message =
                format!("a comment stands among the values of {}", assignment.keyword.path());
            return Diagnostic::error("deck::comment-inside-values", message)
                .at(comment)
                .label("comments are read between values and the next keyword only")
                .help("move the comment before the keyword or behind its last value");
        }
        if before.short {
            return match assignment.value {
                Value::Integer(None) | Value::Real(None) if is_number(text) => {
                    parted_sign(assignment, text, word)
                }
                _ => not_a_number(assignment, text, word),
            };
        }
        if is_number(text) {
            return surplus(assignment, bytes, word);
        }
    }
    plain(dialect, text, word)
}

/// `2e4` for an integer, `1.0D3`, `1,5`: the beginning was read as a number, the rest is left.
pub(super) fn glued(path: &str, wants_integer: bool, bytes: &[u8], rest: Span) -> Diagnostic {
    let start = bytes[..rest.start].iter().rposition(|&b| is_space(b)).map_or(0, |at| at + 1);
    let whole = String::from_utf8_lossy(&bytes[start..rest.end]).into_owned();
    let read = String::from_utf8_lossy(&bytes[start..rest.start]).into_owned();
    let what = if wants_integer { "an integer" } else { "a real" };
    let error = Diagnostic::error(
        "deck::glued-text",
        format!("`{whole}` is not {what}: only `{read}` is read for {path}"),
    )
    .at(Span { start, ..rest })
    .label(format!("`{}` is left over", whole.get(read.len()..).unwrap_or_default()))
    .expected(what);
    match mended(&whole, wants_integer) {
        Some(mended) => error.help(format!("write {mended}")),
        None if wants_integer => error.help("write digits only, without point and exponent"),
        None => error,
    }
}

/// Whether the number before the rest is a count, not a value: counts are always integers.
fn ends_in_header(assignment: &Assignment) -> bool {
    matches!(&assignment.value, Value::Reals(array) if array.numbers().is_empty())
}

fn mended(whole: &str, wants_integer: bool) -> Option<String> {
    let text = whole.replace(['d', 'D'], "e").replace(',', ".");
    let value: f64 = text.parse().ok().filter(|value: &f64| value.is_finite())?;
    if !wants_integer {
        return Some(text);
    }
    (value.fract() == 0.0 && value.abs() < 1e15).then(|| format!("{value:.0}"))
}

fn is_number(text: &[u8]) -> bool {
    matches!(f64::scan(text, 0).scan, Scan::Value(_))
}

/// `- 5`: the scanner takes the sign and fails.
fn parted_sign(assignment: &Assignment, text: &[u8], word: Span) -> Diagnostic {
    let path = assignment.keyword.path();
    let shown = String::from_utf8_lossy(text);
    Diagnostic::error("deck::lone-sign", format!("the sign before `{shown}` stands apart from it"))
        .at(word)
        .label(format!("not read for {path}"))
        .help("write the number without blank after its sign")
}

fn not_a_number(assignment: &Assignment, text: &[u8], word: Span) -> Diagnostic {
    let path = assignment.keyword.path();
    let shown = String::from_utf8_lossy(text).into_owned();
    let (given, announced) = match &assignment.value {
        Value::Integers(array) => (array.numbers().len(), array.header().expected()),
        Value::Reals(array) => (array.numbers().len(), array.header().expected()),
        Value::Integer(_) | Value::Real(_) => (0, 1),
    };
    let message = format!("`{shown}` is no value for {path}");
    let kind = match assignment.keyword.number {
        NumberKind::Integer => "an integer",
        NumberKind::Real => "a number",
    };
    let expected = format!("{kind}: value {} of {announced}", given + 1);
    Diagnostic::error("deck::not-a-number", message)
        .at(word)
        .label(format!("not {kind}"))
        .expected(expected)
}

/// More numbers than a keyword takes.
fn surplus(assignment: &Assignment, bytes: &[u8], word: Span) -> Diagnostic {
    let path = assignment.keyword.path();
    let mut more = 0usize;
    let mut at = word.start;
    loop {
        let scanned = f64::scan(bytes, at);
        match scanned.scan {
            Scan::Value(_) => more += 1,
            _ => break,
        }
        at = scanned.end;
    }
    let header = match &assignment.value {
        Value::Integers(array) => Some(*array.header()),
        Value::Reals(array) => Some(*array.header()),
        Value::Integer(_) | Value::Real(_) => None,
    };
    let Some(header) = header else {
        let error = Diagnostic::error(
            "deck::surplus-values",
            format!("{path} takes one value, more numbers follow"),
        );
        return error.at(word).label("one too many").expected("a keyword").help("take it out");
    };
    let taken = header.expected();
    let found = taken.saturating_add(more as u64);
    Diagnostic::error(
        "deck::surplus-values",
        format!("{path} announces {taken} values, {found} follow"),
    )
    .at(word)
    .label("the first one too many")
    .expected(format!("{taken} values, then a keyword"))
    .help(match header.rank() {
        1 => format!("write the count {found}, or take {more} values out"),
        _ => format!("correct the lengths in the header of {path}, or take {more} values out"),
    })
}

fn plain(dialect: Dialect, text: &[u8], word: Span) -> Diagnostic {
    let shown = crate::source::decode(text).into_owned();
    let expected = "a keyword (`/YD/...`), a comment (`/* ... */`), `$YDOIT` or `$YSTOP`";
    if shown.contains(char::is_control) {
        return Diagnostic::error("deck::not-text", "these bytes are no text")
            .at(word)
            .expected(expected)
            .help("is this the right file?");
    }
    let error = Diagnostic::error("deck::unknown-word", format!("unknown name `{shown}`"))
        .at(word)
        .expected(expected);
    if text.starts_with(b"*/") {
        return error
            .label("closes no comment")
            .help("take it out: comments end at the first word that begins with `*/`");
    }
    if text.starts_with(b"$YINCL") {
        return error.help("only the split dialect can include files");
    }
    let command =
        ["$YDOIT", "$YSTOP"].into_iter().find(|command| shown.to_uppercase().starts_with(command));
    match command.map(str::to_owned).or_else(|| keywords::similar(dialect, &shown)) {
        Some(meant) => error.help(format!("did you mean {meant}?")),
        None => error.help("take it out, or make it a comment: `/* words */`"),
    }
}

/// Explains a keyword that its database does not have.
pub(super) fn keyword(dialect: Dialect, table: &Table, text: &[u8], word: Span) -> Diagnostic {
    let shown = String::from_utf8_lossy(text).into_owned();
    let message =
        format!("database {} of the {dialect} dialect has no keyword `{shown}`", table.database);
    let error =
        Diagnostic::error("deck::unknown-keyword", message).at(word).label("unknown keyword");
    suggested(error, dialect, &shown, text)
}

/// Explains a database that the dialect does not have.
pub(super) fn database(dialect: Dialect, text: &[u8], word: Span) -> Diagnostic {
    let shown = String::from_utf8_lossy(text).into_owned();
    let names: Vec<_> = keywords::tables(dialect).iter().map(|table| table.database).collect();
    let error = Diagnostic::error(
        "deck::unknown-database",
        format!("the {dialect} dialect has no database for `{shown}`"),
    );
    let error =
        error.at(word).label("unknown database").expected(format!("one of {}", names.join(", ")));
    suggested(error, dialect, &shown, text)
}

fn suggested(error: Diagnostic, dialect: Dialect, shown: &str, text: &[u8]) -> Diagnostic {
    let others = keywords::dialects_knowing(text);
    if !others.is_empty() {
        let plural = if others.len() == 1 { "dialect" } else { "dialects" };
        return error.help(format!(
            "it belongs to the {} {plural}; this deck is read as {dialect}",
            others.join(" and ")
        ));
    }
    match keywords::similar(dialect, shown) {
        Some(meant) => error.help(format!("did you mean {meant}?")),
        None => error,
    }
}
