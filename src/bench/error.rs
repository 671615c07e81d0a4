use crate::{
    meshing::MeshingError,
    session::{DeckFault, RunError},
};
use std::{io, path::PathBuf};
use thiserror::Error;
use ypsilon_post::PostError;

/// Why a benchmark failed.
#[derive(Debug, Error)]
pub enum BenchError {
    /// A generator failed.
    #[error(transparent)]
    Meshing(#[from] MeshingError),
    /// A deck cannot be run.
    #[error(transparent)]
    Deck(#[from] DeckFault),
    /// A deck holds nothing that runs.
    #[error("{0}: nothing runs in this deck")]
    NothingRuns(PathBuf),
    /// A run failed.
    #[error(transparent)]
    Run(#[from] RunError),
    /// A file or process cannot be used.
    #[error("{path}: {source}")]
    Io {
        /// The file or program.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// The process of a run ended with an error.
    #[error("{scene}: the run failed: {message}")]
    Worker {
        /// The scene or deck.
        scene: String,
        /// What the process said.
        message: String,
    },
    /// There is no such scene.
    #[error("there is no scene `{name}`; there are {}", known.join(", "))]
    NoScene {
        /// What was asked for.
        name: String,
        /// What there is.
        known: Vec<String>,
    },
    /// A document has no place for the tables.
    #[error("{path}: {message}")]
    Markers {
        /// The document.
        path: PathBuf,
        /// What is missing.
        message: String,
    },
    /// A table or picture of work-precision cannot be made.
    #[error(transparent)]
    Post(#[from] PostError),
    /// A problem of work-precision cannot be set up.
    #[error("{problem}: {message}")]
    Problem {
        /// The problem.
        problem: &'static str,
        /// Why.
        message: String,
    },
}

impl BenchError {
    /// An error of a file or program.
    pub(crate) fn io(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |source| Self::Io { path, source }
    }
}
