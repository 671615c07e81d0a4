//! What a case is.

use crate::{Bench, CaseError, Finding};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// Cases that belong together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Group {
    /// Chapter 3 of the thesis but for its wall.
    Validation,
    /// The wall of TU Eindhoven.
    MasonryWall,
    /// Chapter 4 of the thesis.
    Bridges,
    /// Chapter 3 of the thesis as printed, in space, and masonry of tetrahedra.
    Solids,
    /// Cases with published answers beyond the thesis.
    Classical,
}

impl Group {
    /// All of them, in the order of the report.
    pub const ALL: [Self; 5] =
        [Self::Validation, Self::Solids, Self::MasonryWall, Self::Bridges, Self::Classical];

    /// Its folder under `examples/`.
    #[must_use]
    pub fn folder(self) -> &'static str {
        match self {
            Self::Validation => "validation",
            Self::Solids => "solids",
            Self::MasonryWall => "masonry-wall",
            Self::Bridges => "bridges",
            Self::Classical => "classical",
        }
    }

    /// Its heading in the report.
    #[must_use]
    pub fn title(self) -> &'static str {
        match self {
            Self::Validation => "Validations (chapter 3 of the thesis)",
            Self::Solids => "In space: validations (chapter 3 of the thesis) and masonry",
            Self::MasonryWall => "Masonry shear wall (section 3.3 of the thesis)",
            Self::Bridges => "Masonry bridges (chapter 4 of the thesis)",
            Self::Classical => "Classical benchmarks",
        }
    }
}

/// A case with known answers.
#[derive(Debug, Clone, Copy)]
pub struct Case {
    /// Its name and the name of its folder.
    pub name: &'static str,
    /// Where it belongs.
    pub group: Group,
    /// One line that says what it is.
    pub title: &'static str,
    /// Where data and answers are published.
    pub source: &'static str,
    /// Data, theory and what to know about the answer, as Markdown.
    pub about: &'static str,
    /// Runs it and says what came out.
    pub evaluate: fn(&Bench) -> Result<Outcome, CaseError>,
}

impl Case {
    /// Its folder.
    #[must_use]
    pub fn folder(&self) -> PathBuf {
        examples().join(self.group.folder()).join(self.name)
    }
}

/// The folder of all examples.
#[must_use]
pub fn examples() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// What came out of a case.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Outcome {
    /// Expected and obtained quantities.
    pub findings: Vec<Finding>,
    /// Pictures in the case's folder.
    pub pictures: Vec<Figure>,
}

/// A picture of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Figure {
    /// Its file in the case's folder.
    pub file: String,
    /// What it shows.
    pub caption: String,
}
