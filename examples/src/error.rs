use std::path::PathBuf;

/// Why a case cannot be evaluated.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CaseError {
    /// The scenario makes no deck.
    #[error(transparent)]
    Meshing(#[from] ypsilon::meshing::MeshingError),
    /// The scenario's deck cannot be written, or its monitors make no sense.
    #[error(transparent)]
    Scenario(#[from] ypsilon::session::ScenarioError),
    /// The deck has errors.
    #[error("{deck}: {message}")]
    Deck {
        /// The deck.
        deck: PathBuf,
        /// What is wrong with it.
        message: String,
    },
    /// The run failed.
    #[error(transparent)]
    Run(#[from] Box<ypsilon::session::RunError>),
    /// Results or pictures cannot be read or made.
    #[error(transparent)]
    Post(#[from] ypsilon_post::PostError),
    /// A file cannot be read or written.
    #[error("{path}: {source}", path = path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// Why.
        source: std::io::Error,
    },
    /// Results of earlier runs cannot be read.
    #[error("{path}: {source}", path = path.display())]
    Json {
        /// The file.
        path: PathBuf,
        /// Why.
        source: serde_json::Error,
    },
    /// What the evaluation looks for is not in the results.
    #[error("{0}")]
    Missing(String),
}

impl CaseError {
    /// Adds the path to an error of the operating system.
    pub(crate) fn at(path: &std::path::Path) -> impl Fn(std::io::Error) -> Self + '_ {
        |source| Self::Io { path: path.to_path_buf(), source }
    }

    /// What the evaluation looks for is not in the results.
    #[must_use]
    pub fn missing(what: impl Into<String>) -> Self {
        Self::Missing(what.into())
    }
}
