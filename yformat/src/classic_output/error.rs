//! What can go wrong with a restart deck.

use std::io;

use crate::diagnostic::Diagnostic;

/// Why a restart deck cannot be read or written.
#[derive(Debug, thiserror::Error)]
pub enum RestartError {
    /// The deck itself is wrong.
    #[error(transparent)]
    Deck(Box<Diagnostic>),
    /// The deck announces more than it gives.
    #[error("{size} is {announced}, but {array} gives {found}: correct one of them")]
    Missing {
        /// Keyword of the number.
        size: &'static str,
        /// Its value.
        announced: i64,
        /// Keyword of the array.
        array: &'static str,
        /// How many the array gives.
        found: usize,
    },
    /// A number is beyond what a deck of the classic dialect can mean.
    #[error("{keyword} is {found}, expected {expected}")]
    OutOfRange {
        /// The keyword.
        keyword: &'static str,
        /// Its value.
        found: i64,
        /// What it may be.
        expected: &'static str,
    },
    /// Arrays that belong together have different lengths; the deck is not written.
    #[error("{array} has {found} entries where {expected} are needed")]
    Length {
        /// Keyword of the array.
        array: &'static str,
        /// Entries needed.
        expected: usize,
        /// Entries there.
        found: usize,
    },
    /// The operating system refused.
    #[error("cannot write the restart deck: {0}")]
    Io(#[from] io::Error),
}
