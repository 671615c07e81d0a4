//! What can go wrong with a d3plot family.

use std::io;
use std::path::{Path, PathBuf};

/// Why a family cannot be written.
#[derive(Debug, thiserror::Error)]
pub enum WriteError {
    /// The operating system refused.
    #[error("cannot write {path}: {source}", path = path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The refusal.
        source: io::Error,
    },
    /// An array has another length than the control block says.
    #[error("{array} has {found} entries where the control block announces {expected}")]
    Length {
        /// What the array holds.
        array: &'static str,
        /// Entries announced.
        expected: u64,
        /// Entries given.
        found: u64,
    },
    /// A count does not fit in a 4-byte word.
    #[error("{count} {what} are more than a d3plot file can hold")]
    TooMany {
        /// What is counted.
        what: &'static str,
        /// How many.
        count: u64,
    },
    /// The control block describes a layout this writer does not produce.
    #[error("the control block asks for a layout that is not written here: {0}")]
    Layout(#[from] ReadError),
}

impl WriteError {
    /// Wraps the operating system's refusal with the file that it concerns.
    pub(super) fn io(path: &Path) -> impl FnOnce(io::Error) -> Self + use<> {
        let path = path.to_path_buf();
        move |source| Self::Io { path, source }
    }
}

/// Why a family cannot be read.
#[derive(Debug, thiserror::Error)]
pub enum ReadError {
    /// The operating system refused.
    #[error("cannot read {path}: {source}", path = path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The refusal.
        source: io::Error,
    },
    /// There is no first file.
    #[error("a d3plot family needs at least one file")]
    Empty,
    /// The file ends within the control block or the geometry.
    #[error("the file ends within the {section}: {needed} bytes needed, {available} there")]
    TooShort {
        /// Which section is cut.
        section: &'static str,
        /// Bytes up to the end of the section.
        needed: u64,
        /// Bytes of the file.
        available: u64,
    },
    /// A control word has a value that no d3plot of this kind has.
    #[error("control word {word} ({name}) is {value}: {reason}")]
    Control {
        /// Index of the word.
        word: usize,
        /// Its name.
        name: &'static str,
        /// What it holds.
        value: i32,
        /// Why that is refused.
        reason: &'static str,
    },
    /// There is no such state.
    #[error("state {index} does not exist: the family holds {count}")]
    NoSuchState {
        /// The index asked for.
        index: usize,
        /// How many there are.
        count: usize,
    },
}
