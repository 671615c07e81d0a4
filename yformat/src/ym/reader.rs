//! Reads and rewrites whole snapshots.

use std::io;
use std::path::Path;

use super::digits::value_of;
use super::error::excerpt;
use super::{CodedRecord, Digits, HEADING, RecordKind, YmError, YmProblem};

/// How lines end.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LineEnd {
    /// `\n`.
    #[default]
    LineFeed,
    /// `\r\n`, as Windows builds write.
    CarriageReturnLineFeed,
}

impl LineEnd {
    fn bytes(self) -> &'static [u8] {
        match self {
            Self::LineFeed => b"\n",
            Self::CarriageReturnLineFeed => b"\r\n",
        }
    }
}

/// A whole snapshot.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Snapshot {
    /// Its lines in order, the heading left out.
    pub records: Vec<CodedRecord>,
    /// How the heading ends, and so all lines.
    pub line_end: LineEnd,
    /// The number of a last line that is left out because it is cut short, as when the program was
    /// killed while it wrote.
    pub truncated: Option<usize>,
}

impl Snapshot {
    /// Reads a file.
    ///
    /// # Errors
    /// If the file cannot be read; if it is no snapshot, an error of the kind `InvalidData` that
    /// holds a [`YmError`].
    pub fn read(path: &Path) -> io::Result<Self> {
        let bytes = std::fs::read(path)?;
        Self::parse(path.display().to_string(), &bytes)
            .map_err(|error| io::Error::new(io::ErrorKind::InvalidData, error))
    }

    /// Reads a snapshot from memory. `name` appears in messages. Both line ends are accepted, blank
    /// lines are skipped.
    ///
    /// # Errors
    /// At the first line that is none of a snapshot, but for a last one that has no line end and is
    /// too short: see [`Snapshot::truncated`].
    pub fn parse(name: impl Into<String>, bytes: &[u8]) -> Result<Self, YmError> {
        let error = |line, problem| YmError { file: name.into(), line, problem };
        let unterminated = !bytes.ends_with(b"\n");
        let mut lines = bytes.split(|&b| b == b'\n').enumerate().peekable();
        let first = lines.next().map_or(&[][..], |(_, line)| line);
        let line_end = match first.strip_suffix(b"\r") {
            Some(_) => LineEnd::CarriageReturnLineFeed,
            None => LineEnd::LineFeed,
        };
        if without_return(first) != HEADING {
            return Err(error(1, YmProblem::Heading { found: excerpt(without_return(first)) }));
        }
        let mut snapshot = Self { records: Vec::new(), line_end, truncated: None };
        while let Some((index, line)) = lines.next() {
            let line = without_return(line);
            if line.is_empty() {
                continue;
            }
            match record(line) {
                Ok(record) => snapshot.records.push(record),
                Err(YmProblem::Length { expected, found })
                    if unterminated && found < expected && lines.peek().is_none() =>
                {
                    snapshot.truncated = Some(index + 1);
                }
                Err(problem) => return Err(error(index + 1, problem)),
            }
        }
        Ok(snapshot)
    }

    /// The text. What was read without blank or cut lines comes out as it was.
    #[must_use]
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut text = HEADING.to_vec();
        text.extend_from_slice(self.line_end.bytes());
        for record in &self.records {
            record.push_line(&mut text);
            text.extend_from_slice(self.line_end.bytes());
        }
        text
    }
}

fn without_return(line: &[u8]) -> &[u8] {
    line.strip_suffix(b"\r").unwrap_or(line)
}

/// Reads one line.
fn record(line: &[u8]) -> Result<CodedRecord, YmProblem> {
    let no_digits = || YmProblem::Digits { found: excerpt(line) };
    let (&first, rest) = line.split_first().ok_or_else(no_digits)?;
    let digits =
        value_of(first).and_then(|digits| Digits::new(i64::from(digits))).ok_or_else(no_digits)?;
    let Some((&second, body)) = rest.split_first() else {
        return Err(YmProblem::Length { expected: 2, found: 1 });
    };
    let count = value_of(second).ok_or_else(|| character(line, 1))?;
    let expected = 2 + usize::from(count).saturating_sub(2) * digits.get();
    if let Some(bad) = line.iter().position(|&b| value_of(b).is_none()) {
        return Err(character(line, bad));
    }
    if line.len() != expected {
        return Err(YmProblem::Length { expected, found: line.len() });
    }
    let mut numbers =
        body.chunks_exact(digits.get()).map(|number| Digits::take(number).unwrap_or_default());
    let type_number = numbers.next().unwrap_or_default();
    match RecordKind::of(type_number, count) {
        Some(kind) => Ok(CodedRecord::new(kind, digits, numbers)),
        None => Err(match RecordKind::counts(type_number) {
            known if known.is_empty() => YmProblem::Type { found: type_number },
            expected => YmProblem::Count { type_number, found: count, expected },
        }),
    }
}

/// The problem with the byte at this position.
fn character(line: &[u8], position: usize) -> YmProblem {
    let byte = line.get(position..=position).unwrap_or_default();
    YmProblem::Character { column: position + 1, found: byte.escape_ascii().to_string() }
}
