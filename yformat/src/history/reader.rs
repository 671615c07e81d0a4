//! Reads history files of every dialect.

use super::number::take;

/// One line of a history.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HistoryPoint {
    /// Time.
    pub time: f64,
    /// The quantity at that time.
    pub value: f64,
}

/// The contents of a history file.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct History {
    /// Times and values in the order of the file. Y appends to old files, so the time of a
    /// second run may begin anew.
    pub points: Vec<HistoryPoint>,
    /// Sums of the contact forces in x and y, one per point, in files of the classic dialect;
    /// empty in others. A run that was killed may have left one less.
    pub contact_forces: Vec<[f64; 2]>,
    /// Whether the last line has no line end, as when the program was killed: its numbers may
    /// be cut short. If they cannot be read as two numbers the line is left out.
    pub unterminated: bool,
}

/// Why a text is not a history.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
pub enum HistoryError {
    /// A line is not two numbers.
    #[error("line {line} is not a time and a value: {text:?}")]
    NotTwoNumbers {
        /// Line number, from 1.
        line: usize,
        /// The line, cut after 60 bytes.
        text: String,
    },
    /// A line of contact forces is missing below a point of a classic history, or follows no
    /// point.
    #[error("line {line}: points and contact forces do not alternate")]
    NotAlternating {
        /// Line number, from 1.
        line: usize,
    },
}

impl History {
    /// Parses the text of a `.yh` file.
    ///
    /// Both line ends, exponents of any length, numbers without a blank between them and the
    /// spellings of `nan` and `inf` by C libraries are accepted; blank lines are skipped.
    pub fn parse(text: &[u8]) -> Result<Self, HistoryError> {
        let mut history =
            Self { unterminated: !text.is_empty() && !text.ends_with(b"\n"), ..Self::default() };
        let mut classic = false;
        let mut lines = text.split(|&b| b == b'\n').enumerate().peekable();
        while let Some((index, line)) = lines.next() {
            if line.trim_ascii().is_empty() {
                continue;
            }
            let number = index + 1;
            let Some([first, second]) = two_numbers(line) else {
                if history.unterminated && lines.peek().is_none() {
                    break;
                }
                return Err(HistoryError::NotTwoNumbers { line: number, text: excerpt(line) });
            };
            if history.points.len() == 1 && history.contact_forces.is_empty() {
                classic = line.starts_with(b" ");
            }
            if classic && history.contact_forces.len() < history.points.len() {
                if !line.starts_with(b" ") {
                    return Err(HistoryError::NotAlternating { line: number });
                }
                history.contact_forces.push([first, second]);
            } else if classic && line.starts_with(b" ") {
                return Err(HistoryError::NotAlternating { line: number });
            } else {
                history.points.push(HistoryPoint { time: first, value: second });
            }
        }
        Ok(history)
    }
}

fn two_numbers(line: &[u8]) -> Option<[f64; 2]> {
    let (first, rest) = take(line)?;
    let (second, rest) = take(rest)?;
    rest.trim_ascii().is_empty().then_some([first, second])
}

fn excerpt(line: &[u8]) -> String {
    String::from_utf8_lossy(line.get(..60).unwrap_or(line)).into_owned()
}
