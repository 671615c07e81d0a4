//! What can go wrong between results and pictures.

use std::io;
use std::path::{Path, PathBuf};

use ypsilon_converters::ConvertError;

/// Why results cannot be shown.
#[derive(Debug, thiserror::Error)]
pub enum PostError {
    /// The operating system refused.
    #[error("{path}: {source}", path = path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The refusal.
        source: io::Error,
    },
    /// A result file cannot be read.
    #[error(transparent)]
    Results(#[from] ConvertError),
    /// A d3plot family cannot be read.
    #[error("{path}: {source}", path = path.display())]
    D3plot {
        /// First file of the family.
        path: PathBuf,
        /// What is wrong with it.
        source: yformat::d3plot::ReadError,
    },
    /// The file holds no results that can be shown.
    #[error("{path}: {message}", path = path.display())]
    NoResults {
        /// The file.
        path: PathBuf,
        /// What was found and what is expected.
        message: String,
    },
    /// The results lack an array that the picture or table needs.
    #[error("the results hold no {array}, which {wanted} needs; {remedy}")]
    MissingArray {
        /// What is missing.
        array: &'static str,
        /// What needs it.
        wanted: String,
        /// How to get it.
        remedy: &'static str,
    },
    /// Words of the user that mean nothing.
    #[error("{what} `{found}`: {expected}")]
    Words {
        /// What the words are for.
        what: &'static str,
        /// The words.
        found: String,
        /// What is expected.
        expected: String,
    },
    /// A place, time or selection that the results do not have.
    #[error("{0}")]
    Nothing(String),
}

impl PostError {
    /// Words of the user that mean nothing.
    pub fn words(
        what: &'static str,
        found: impl Into<String>,
        expected: impl Into<String>,
    ) -> Self {
        Self::Words { what, found: found.into(), expected: expected.into() }
    }
}

/// Adds the path to an error of the operating system.
pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> PostError + '_ {
    |source| PostError::Io { path: path.to_path_buf(), source }
}
