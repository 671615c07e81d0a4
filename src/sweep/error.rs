use super::study::StudyError;
use std::{
    io,
    path::{Path, PathBuf},
};
use thiserror::Error;

/// Why a sweep ends before its cases do.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum SweepError {
    /// The study cannot be run.
    #[error(transparent)]
    Study(#[from] StudyError),
    /// A file cannot be written or read, or the program not started.
    #[error("{path}: {source}", path = path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The folder holds cases of another study, or of this one before it was changed.
    #[error("{0}")]
    Changed(String),
    /// The folder of a case holds something else.
    #[error(
        "{folder} is there already and was not made by a sweep: it stays as it is; take another \
         folder with --out",
        folder = .0.display()
    )]
    Foreign(PathBuf),
    /// There is no case with this number.
    #[error("there is no case {asked}: cases are numbered from 1 to {last}")]
    NoCase {
        /// What was asked for.
        asked: usize,
        /// The last one.
        last: usize,
    },
    /// What the program cannot do as it was built.
    #[error("{0}")]
    Unsupported(&'static str),
}

/// Adds the path to an error of the operating system.
pub(super) fn at(path: &Path) -> impl Fn(io::Error) -> SweepError + '_ {
    |source| SweepError::Io { path: path.to_path_buf(), source }
}
