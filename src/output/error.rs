use std::{io, path::PathBuf};
use thiserror::Error;

/// A result file could not be written.
#[derive(Debug, Error)]
pub enum OutputError {
    /// The operating system refused.
    #[error("cannot write {path}: {source}")]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A kind of files that no later run can go on with.
    #[error(
        "{kind} files cannot be gone on with by a later run: leave them out of --formats, \
         or run without --checkpoint, --checkpoint-every and --resume"
    )]
    NotResumable {
        /// The kind.
        kind: &'static str,
    },
    /// A checkpoint does not tell how far files were written.
    #[error("the checkpoint does not tell how to go on with the {kind} files")]
    Mark {
        /// The kind.
        kind: &'static str,
    },
    /// A file that an earlier run has written is not there any more.
    #[error("{path} is missing, which the run wrote before its checkpoint; put it back to go on")]
    Missing {
        /// The file.
        path: PathBuf,
    },
    /// A file that an earlier run has written is another one now.
    #[error(
        "cannot go on with {path}: {source}. Give the folder of the earlier results with --out, \
         and the files as they were left"
    )]
    Changed {
        /// The file.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// A d3plot file could not be written.
    #[error(transparent)]
    D3plot(#[from] yformat::d3plot::WriteError),
    /// A monitor watches nothing.
    #[error("monitor {name}: {source}")]
    Monitor {
        /// Its name.
        name: String,
        /// Why.
        source: ypsilon_post::PostError,
    },
    /// Monitors are asked for in three dimensions.
    #[error(
        "monitor {name}: the scene is three-dimensional, and monitors watch 2D scenes only; \
         run it without --monitor and take the values from the VTU files"
    )]
    MonitorInSpace {
        /// Its name.
        name: String,
    },
    /// A VTK file could not be written.
    #[error(transparent)]
    Vtk(#[from] ypsilon_converters::ConvertError),
}

impl OutputError {
    /// Wraps an I/O error with the file that it concerns.
    pub fn io(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |source| Self::Io { path, source }
    }

    /// Wraps the reason why a file of an earlier run cannot be gone on with.
    pub fn changed(path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> Self {
        let path = path.into();
        move |source| Self::Changed { path, source }
    }
}
