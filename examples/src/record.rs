//! What a case found when it last ran, as its folder keeps it.

use crate::{Case, CaseError, Outcome};
use serde::{Deserialize, Serialize};
use std::path::Path;
use yformat::part_file::PartFile;

/// The file in the folder of a case.
pub const FILE: &str = "results.json";

/// What a case found when it last ran.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Version of Ypsilon.
    pub version: String,
    /// What came out.
    pub outcome: Outcome,
    /// Wall-clock seconds of all its runs, made one after the other.
    pub seconds: f64,
    /// Triangles times steps of all its runs.
    pub triangle_steps: u64,
}

impl Record {
    /// What the folder of a case keeps; none if it has not run.
    ///
    /// # Errors
    /// If the file cannot be read or is none of ours.
    pub fn read(case: &Case) -> Result<Option<Self>, CaseError> {
        let path = case.folder().join(FILE);
        let text = match std::fs::read_to_string(&path) {
            Ok(text) => text,
            Err(e) if e.kind() == std::io::ErrorKind::NotFound => return Ok(None),
            Err(source) => return Err(CaseError::Io { path, source }),
        };
        serde_json::from_str(&text).map(Some).map_err(|source| CaseError::Json { path, source })
    }

    /// Keeps it.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn write(&self, case: &Case) -> Result<(), CaseError> {
        let path = case.folder().join(FILE);
        let mut text = serde_json::to_string_pretty(self)
            .map_err(|source| CaseError::Json { path: path.clone(), source })?;
        text.push('\n');
        write(&path, &text)
    }
}

/// Writes a text file that takes its name when it is complete.
pub(crate) fn write(path: &Path, text: &str) -> Result<(), CaseError> {
    use std::io::Write;
    let attempt = || {
        let mut file = PartFile::create(path)?;
        file.write_all(text.as_bytes())?;
        file.complete()
    };
    attempt().map(drop).map_err(CaseError::at(path))
}
