//! The canonical text of items that were not read, or were changed.

use std::fmt::Write;

use super::array::{Array, Header};
use super::item::{Assignment, ItemKind, Value};

/// The text of an item, without line end.
pub(super) fn item(kind: &ItemKind) -> String {
    match kind {
        ItemKind::Comment(text) => comment(text),
        ItemKind::Assignment(given) => assignment(given),
        ItemKind::Run => "$YDOIT".to_owned(),
        ItemKind::Stop => "$YSTOP".to_owned(),
        ItemKind::Include(name) => format!("$YINCL {name}"),
        ItemKind::Tail(_) => String::new(),
    }
}

/// A comment as the original can read it: delimiters as words, none inside, at most 99 words of at
/// most 299 bytes each. Longer texts become several comments.
fn comment(text: &str) -> String {
    let words: Vec<String> = text
        .split(|c: char| c.is_ascii_whitespace() || c == '\x0b')
        .filter(|word| !matches!(*word, "" | "/*"))
        .flat_map(readable_words)
        .collect();
    if words.is_empty() {
        return "/* */".to_owned();
    }
    let pieces: Vec<String> =
        words.chunks(99).map(|piece| format!("/* {} */", piece.join(" "))).collect();
    pieces.join("\n")
}

/// Cuts a word that is too long for the original's buffer, and takes off what would close the
/// comment.
fn readable_words(word: &str) -> Vec<String> {
    let characters: Vec<char> = word.chars().collect();
    let pieces = characters.chunks(70).map(|piece| piece.iter().collect::<String>());
    let open = pieces.map(|piece| piece.trim_start_matches("*/").to_owned());
    open.filter(|piece| !piece.is_empty()).collect()
}

fn assignment(given: &Assignment) -> String {
    let mut out = given.keyword.path();
    match &given.value {
        Value::Integer(value) => push_all(&mut out, value.iter().copied(), integer),
        Value::Real(value) => push_all(&mut out, value.iter().copied(), real),
        Value::Integers(array) => push_array(&mut out, array, integer),
        Value::Reals(array) => push_array(&mut out, array, real),
    }
    out
}

fn push_all<T>(out: &mut String, values: impl Iterator<Item = T>, number: fn(&mut String, T)) {
    for value in values {
        out.push(' ');
        number(out, value);
    }
}

fn push_array<T: Copy>(out: &mut String, array: &Array<T>, number: fn(&mut String, T)) {
    let header = array.header();
    let counts = &header.counts()[..header.rank()];
    if header.rank() > 1 {
        push_all(out, std::iter::once(header.order()), integer);
    }
    push_all(out, counts.iter().copied(), integer);
    for line in array.numbers().chunks(line_length(header)) {
        out.push('\n');
        for (position, &value) in line.iter().enumerate() {
            if position > 0 {
                out.push(' ');
            }
            number(out, value);
        }
    }
}

/// Numbers per line: one record, as far as it is not too long to look at.
fn line_length(header: &Header) -> usize {
    let innermost = header.loops().map_or(1, |loops| header.counts()[loops[2]]);
    match header.rank() {
        1 => 10,
        _ => usize::try_from(innermost).unwrap_or(1).clamp(1, 20),
    }
}

fn integer(out: &mut String, value: i64) {
    let _ = write!(out, "{value}");
}

/// The shortest text that reads back to the same bits; Rust's `{:?}` gives it, with an exponent
/// where that is shorter.
fn real(out: &mut String, value: f64) {
    let _ = write!(out, "{value:?}");
}
