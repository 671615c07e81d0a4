//! What is worth telling about a series, though it can be converted.

use std::fmt;
use std::path::PathBuf;

/// Something that the user of the results should know.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum YmNotice {
    /// There is no deck beside the snapshots.
    NoDeck {
        /// The deck that was looked for.
        expected: PathBuf,
    },
    /// Two decks could have written the snapshots.
    TwoSeries {
        /// The one that was taken.
        taken: PathBuf,
        /// The other one.
        other: PathBuf,
    },
    /// The deck has an error; what stands before it counts.
    DeckError {
        /// The first error.
        message: String,
    },
    /// A scale without which values mean nothing is not in the deck.
    NoScale {
        /// Keyword.
        keyword: &'static str,
        /// What is taken instead, with its unit.
        taken: String,
    },
    /// A scale by which nothing can be coded.
    UselessScale {
        /// Keyword.
        keyword: &'static str,
        /// Its value.
        value: String,
    },
    /// The deck does not say how often snapshots are written.
    NoTimes,
    /// The last line of a snapshot is cut and left out.
    Truncated {
        /// The snapshot.
        path: PathBuf,
        /// The line, from 1.
        line: usize,
    },
}

impl fmt::Display for YmNotice {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoDeck { expected } => write!(
                f,
                "no deck {} is beside the snapshots: all values are relative to the deck's output \
                 scales, and times are snapshot numbers; name the deck with --deck",
                expected.display()
            ),
            Self::TwoSeries { taken, other } => write!(
                f,
                "the snapshots may belong to {} or {}; the first is taken, name the right one with \
                 --deck",
                taken.display(),
                other.display()
            ),
            Self::DeckError { message } => {
                write!(f, "only what stands before an error of the deck is taken: {message}")
            }
            Self::NoScale { keyword, taken } => write!(
                f,
                "the deck gives no {keyword}, with which the original computes anything: {taken} \
                 is taken"
            ),
            Self::UselessScale { keyword, value } => write!(
                f,
                "{keyword} is {value}: what is scaled by it was not coded and cannot be shown"
            ),
            Self::NoTimes => {
                write!(f, "the deck gives no positive ICOUTF: snapshot numbers are shown for times")
            }
            Self::Truncated { path, line } => write!(
                f,
                "{}:{line}: the last line is cut and left out: the program was stopped while it \
                 wrote",
                path.display()
            ),
        }
    }
}
