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
}
