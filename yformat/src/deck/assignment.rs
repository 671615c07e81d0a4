//! A keyword and what follows it.

use super::array::{Array, Header};
use super::item::{Assignment, Value};
use super::lex::{is_space, next_word};
use super::number::Number;
use super::scan::{Cursor, Found};
use crate::diagnostic::Diagnostic;
use crate::dialect::Dialect;
use crate::keywords::{self, Adjustment, Keyword, NumberKind};
use crate::source::{SourceId, Span};

/// Announced values that are believed whatever the size of the file is.
const ALWAYS_BELIEVED: u64 = 1000;

/// An assignment as read.
pub(super) struct Read {
    pub assignment: Assignment,
    /// First byte behind it.
    pub end: usize,
    pub warnings: Vec<Diagnostic>,
    /// Values are missing. Whether that is worth a warning of its own depends on what follows.
    pub short: Option<Diagnostic>,
}

/// Reads the value of `word`, which begins with `/YD/`.
pub(super) fn read(
    dialect: Dialect,
    source: SourceId,
    bytes: &[u8],
    word: Span,
) -> Result<Read, Diagnostic> {
    let text = bytes.get(word.range()).unwrap_or_default();
    let keyword = match keywords::match_word(dialect, text) {
        Some((_, Some(keyword))) => keyword,
        Some((table, None)) => return Err(super::unknown::keyword(dialect, table, text, word)),
        None => return Err(super::unknown::database(dialect, text, word)),
    };
    let (warnings, undefined) = (Vec::new(), None);
    let mut cursor = Cursor { bytes, source, at: word.end, keyword, dialect, warnings, undefined };
    cursor.warnings.extend(trailing_characters(dialect, keyword, text, word));
    let (value, short) = match (keyword.rank(), keyword.number) {
        (0, NumberKind::Integer) => scalar::<i64>(&mut cursor, word, Value::Integer)?,
        (0, NumberKind::Real) => scalar::<f64>(&mut cursor, word, Value::Real)?,
        (_, NumberKind::Integer) => array::<i64>(&mut cursor, word, Value::Integers)?,
        (_, NumberKind::Real) => array::<f64>(&mut cursor, word, Value::Reals)?,
    };
    refuse_negative(&cursor, &value)?;
    note_undefined(&mut cursor);
    let (end, warnings) = (cursor.at, cursor.warnings);
    Ok(Read { assignment: Assignment { keyword, value }, end, warnings, short })
}

fn scalar<T: Number>(
    cursor: &mut Cursor<'_>,
    word: Span,
    wrap: fn(Option<T>) -> Value,
) -> Result<(Value, Option<Diagnostic>), Diagnostic> {
    match cursor.number()? {
        Found::Value(value) => return Ok((wrap(Some(value)), None)),
        // what was swallowed is the reason why the value is missing
        Found::Swallowed => return Ok((wrap(None), cursor.warnings.pop())),
        Found::Nothing => {}
    }
    let name = cursor.keyword.path();
    let short = Diagnostic::warning(
        "deck::missing-value",
        format!("no value follows {name}, it keeps its old value"),
    )
    .at(word)
    .label("no number follows")
    .help("write the value, or leave the keyword out");
    Ok((wrap(None), Some(short)))
}

fn array<T: Number>(
    cursor: &mut Cursor<'_>,
    word: Span,
    wrap: fn(Array<T>) -> Value,
) -> Result<(Value, Option<Diagnostic>), Diagnostic> {
    let header = cursor.header()?;
    check_header(cursor, &header, word);
    let expected = header.expected();
    let header_end = cursor.at;
    let array = cursor.array::<T>(header)?;
    let given = array.numbers().len();
    if given == 0 && expected > 0 {
        return Err(no_values(cursor, expected));
    }
    refuse_endless(cursor, expected, header_end)?;
    if cursor.keyword.scratch_follows {
        skip_scratch_array(cursor)?;
    }
    if cursor.dialect == Dialect::Classic && cursor.keyword.name == "D1NMCT" && expected == 0 {
        skip_restart_masses(cursor);
    }
    let name = cursor.keyword.path();
    let short = (expected > given as u64).then(|| {
        let message = format!(
            "{name} announces {expected} values and gives {given}: the last one is repeated"
        );
        let missing = expected - given as u64;
        let plural = if missing == 1 { "value is" } else { "values are" };
        Diagnostic::warning("deck::missing-values", message)
            .at(word)
            .label(format!("{missing} {plural} missing"))
            .help("write all values, or correct the count")
    });
    Ok((wrap(array), short))
}

/// Missing values are taken to repeat the last one, but not more of them than the file has bytes:
/// whoever asks for the array would run out of memory.
fn refuse_endless(cursor: &Cursor<'_>, expected: u64, header_end: usize) -> Result<(), Diagnostic> {
    let bytes = cursor.bytes.len() as u64;
    if expected <= bytes.max(ALWAYS_BELIEVED) {
        return Ok(());
    }
    let name = cursor.keyword.path();
    let before = cursor.bytes.get(..header_end).unwrap_or_default();
    let start = before.iter().rposition(|&b| is_space(b)).map_or(0, |at| at + 1);
    Err(Diagnostic::error(
        "deck::endless-array",
        format!("{name} announces {expected} values, more than the whole file has characters"),
    )
    .at(cursor.span(start..header_end))
    .label("the last count before the values")
    .help("correct the count"))
}

fn check_header(cursor: &mut Cursor<'_>, header: &Header, word: Span) {
    let name = cursor.keyword.path();
    let counts = &header.counts()[..header.rank()];
    if counts.iter().any(|&count| count < 0) {
        let warning = Diagnostic::warning(
            "deck::negative-count",
            format!("{name} has a negative length: nothing is read"),
        );
        cursor.warnings.push(warning.at(word).label("a length after this is negative"));
    }
    let order = header.order();
    let reads_nothing = header.loops().is_none() && counts.iter().all(|&count| count > 0);
    if reads_nothing && !cursor.keyword.short_header {
        let message =
            format!("{name} has order code {order}, which names no loops: nothing is read");
        let expected = "123, 132, 213, 231, 312 or 321";
        cursor
            .warnings
            .push(Diagnostic::warning("deck::order-code", message).at(word).expected(expected));
    }
    if header.rank() == 2 && order != 12 && order != 21 && header.expected() > 0 {
        let message = format!("{name} has order code {order}, which is read as 21");
        cursor
            .warnings
            .push(Diagnostic::warning("deck::order-code", message).at(word).expected("21 or 12"));
    }
}

/// The first value of an array cannot be read: the original fills the array with whatever its stack
/// holds.
fn no_values(cursor: &Cursor<'_>, expected: u64) -> Diagnostic {
    let name = cursor.keyword.path();
    let next = cursor.next_word_span();
    let text = cursor.bytes.get(next.range()).unwrap_or_default();
    if next.start == cursor.at && !text.is_empty() {
        return super::unknown::glued(&name, true, cursor.bytes, next);
    }
    let values = if expected == 1 { "1 value".to_owned() } else { format!("{expected} values") };
    let (code, message, label) = match text {
        [] => (
            "deck::no-values",
            format!("{name} announces {values} and gives none"),
            "the file ends here",
        ),
        [b'/', b'*', ..] => (
            "deck::comment-inside-values",
            format!("a comment stands between {name} and its values"),
            "comments are read between values and the next keyword only",
        ),
        _ => {
            ("deck::no-values", format!("{name} announces {values} and gives none"), "not a number")
        }
    };
    let error = Diagnostic::error(code, message).at(next).label(label);
    match code {
        "deck::no-values" => error.expected(values),
        _ => error.help("move the comment before the keyword or behind its last value"),
    }
}

/// Y-Geo reads a second array of the same form, if a number follows, and uses it as scratch space.
fn skip_scratch_array(cursor: &mut Cursor<'_>) -> Result<(), Diagnostic> {
    let before = cursor.at;
    if matches!(cursor.number::<i64>()?, Found::Value(_)) {
        cursor.at = before;
        let header = cursor.header()?;
        cursor.array::<i64>(header)?;
    } else {
        cursor.at = before;
    }
    Ok(())
}

/// Joint states of a restart deck may hold values that the program never defined.
fn note_undefined(cursor: &mut Cursor<'_>) {
    let Some((first, count)) = cursor.undefined else {
        return;
    };
    let plural = if count == 1 { "value is" } else { "values are" };
    let message = format!("{count} {plural} not finite in {}", cursor.keyword.path());
    cursor.warnings.push(
        Diagnostic::note("deck::undefined-state", message).at(first).label("the first of them"),
    );
}

/// The classic program writes its restart decks with the count 0 before all the masses, and then
/// cannot read them. Masses are computed anew, so they may be dropped.
fn skip_restart_masses(cursor: &mut Cursor<'_>) {
    let (mut dropped, mut first) = (0usize, None);
    while let Some(word) = next_word(cursor.bytes, cursor.at) {
        if matches!(cursor.bytes.get(word.range.start), None | Some(b'/' | b'$')) {
            break;
        }
        first.get_or_insert(word.range.clone());
        dropped += 1;
        cursor.at = word.range.end;
    }
    if let Some(range) = first {
        let message =
            format!("D1NMCT announces no values and is followed by {dropped}: they are dropped");
        let warning = Diagnostic::warning("deck::restart-masses", message).at(cursor.span(range));
        cursor.warnings.push(
            warning
                .label("the first of them")
                .help("the program that wrote this restart deck stops here; masses are computed anew, so nothing is lost"),
        );
    }
}

/// Characters behind the compared part of a keyword are ignored, which hides glued counts and
/// misspelt names.
fn trailing_characters(
    dialect: Dialect,
    keyword: &'static Keyword,
    text: &[u8],
    word: Span,
) -> Option<Diagnostic> {
    let path = keyword.path();
    if text.len() <= path.len() && path.as_bytes().starts_with(text) {
        return None;
    }
    let compared = "/YD//".len() + keyword.database.len() + keyword.match_length;
    let trailing = String::from_utf8_lossy(text.get(compared..).unwrap_or_default()).into_owned();
    let span = Span { start: (word.start + compared).min(word.end), ..word };
    let warning =
        Diagnostic::warning("deck::trailing-characters", format!("this word is taken for {path}"));
    let help = if keyword.rank() > 0 && trailing.bytes().all(|b| b.is_ascii_digit()) {
        format!("if {trailing} is the number of values, put a blank before it: it is not read")
    } else if let [other, ..] = keywords::dialects_knowing(text)[..]
        && other != dialect.name()
    {
        format!("the {other} dialect has a keyword of this name, the {dialect} dialect has not")
    } else {
        format!("write {path}")
    };
    Some(warning.at(span).label("ignored").help(help))
}

fn refuse_negative(cursor: &Cursor<'_>, value: &Value) -> Result<(), Diagnostic> {
    let negative = matches!(value, Value::Real(Some(real)) if *real < 0.0);
    if cursor.keyword.adjustment != Adjustment::RejectNegative || !negative {
        return Ok(());
    }
    let before = cursor.bytes.get(..cursor.at).unwrap_or_default();
    let start = before.iter().rposition(|&b| is_space(b)).map_or(0, |at| at + 1);
    let message = format!("{} must not be negative", cursor.keyword.path());
    Err(Diagnostic::error("deck::negative-parameter", message)
        .at(cursor.span(start..cursor.at))
        .expected("a positive number"))
}
