//! What can be wrong with a snapshot.

use std::fmt::Write as _;

/// Why a file is no snapshot, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{file}:{line}: {problem}")]
pub struct YmError {
    /// Name of the file as it was given.
    pub file: String,
    /// Line, from 1.
    pub line: usize,
    /// What is wrong there.
    pub problem: YmProblem,
}

/// What is wrong with a line of a snapshot.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum YmProblem {
    /// The first line is another one.
    #[error("a .ym snapshot begins with the line `CODED`, this file with `{found}`")]
    Heading {
        /// What the first line holds, cut.
        found: String,
    },
    /// The first character gives no number of digits.
    #[error(
        "the line `{found}` begins with no number of digits: 1 to 9 expected (ICOUTP of the deck)"
    )]
    Digits {
        /// The line, cut.
        found: String,
    },
    /// A character is no digit of base 90.
    #[error("column {column}: `{found}` is none of the 90 digits of .ym files")]
    Character {
        /// Column, from 1.
        column: usize,
        /// The character.
        found: String,
    },
    /// The line is longer or shorter than its own count says.
    #[error("the line has {found} characters, {expected} are announced by its first two")]
    Length {
        /// Characters announced.
        expected: usize,
        /// Characters there.
        found: usize,
    },
    /// The record is of no known type.
    #[error(
        "record type {found} is unknown: expected 1 (triangle), 3 (fracture), 5 (boundary) or 6 \
         (acoustic source)"
    )]
    Type {
        /// The type.
        found: u64,
    },
    /// The record has another number of values than its type has.
    #[error("a record of type {type_number} has count {found}, expected {}", either(expected))]
    Count {
        /// The type.
        type_number: u64,
        /// The count of the line.
        found: u8,
        /// Counts that records of the type have.
        expected: Vec<u8>,
    },
}

fn either(counts: &[u8]) -> String {
    let mut text = String::new();
    for (index, count) in counts.iter().enumerate() {
        let separator = if index == 0 { "" } else { " or " };
        let _ = write!(text, "{separator}{count}");
    }
    text
}

/// The beginning of a line for a message.
pub(super) fn excerpt(line: &[u8]) -> String {
    let shown = String::from_utf8_lossy(line.get(..30).unwrap_or(line));
    shown.replace(char::is_control, "\u{FFFD}")
}
