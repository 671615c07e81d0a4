//! What the names of the files say.

use std::path::Path;

/// The kinds of files that Y-Geo writes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum SeriesKind {
    /// Triangles with velocities, forces, stresses and strains: `wall.y_300.vtp`.
    Triangles,
    /// Broken and boundary joints.
    BrokenJoints,
    /// Joints that soften.
    YieldedJoints,
    /// Reinforcement bars.
    Rebars,
    /// Bars across joints.
    BarJoints,
    /// Acoustic events: points only.
    Acoustic,
    /// Principal stress directions at the centres of the triangles: points only.
    PrincipalDirections,
}

/// Kinds with the middle of their names, in the order of their parts.
const KINDS: [(SeriesKind, &str); 7] = [
    (SeriesKind::Triangles, ""),
    (SeriesKind::BrokenJoints, "_broken_joints"),
    (SeriesKind::YieldedJoints, "_yielded_joints"),
    (SeriesKind::Rebars, "_rebars"),
    (SeriesKind::BarJoints, "_1D_joints"),
    (SeriesKind::Acoustic, "_acoustic"),
    (SeriesKind::PrincipalDirections, "_principal_direction"),
];

impl SeriesKind {
    /// Number of its part in a collection.
    #[must_use]
    pub fn part(self) -> u32 {
        self as u32
    }

    /// Name of its part in a collection.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::Triangles => "elements",
            Self::BrokenJoints => "broken joints",
            Self::YieldedJoints => "yielded joints",
            Self::Rebars => "rebars",
            Self::BarJoints => "1D joints",
            Self::Acoustic => "acoustic events",
            Self::PrincipalDirections => "principal directions",
        }
    }
}

/// A file name taken apart.
///
/// ```
/// use ypsilon_converters::vtk_series::{SeriesKind, SeriesName};
///
/// let name = SeriesName::of("results/wall.y_broken_joints_300.vtp".as_ref()).unwrap();
/// assert_eq!((name.family.as_str(), name.step), ("wall.y", 300));
/// assert_eq!(name.kind, SeriesKind::BrokenJoints);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct SeriesName {
    /// What the names of all files of the run begin with.
    pub family: String,
    /// Kind of the file.
    pub kind: SeriesKind,
    /// Step number.
    pub step: u64,
}

impl SeriesName {
    /// Takes the name of a file apart; `None` if it has no step number or another extension than
    /// `.vtp` and `.vtu`.
    #[must_use]
    pub fn of(path: &Path) -> Option<Self> {
        let name = path.file_name()?.to_str()?;
        let stem = name.strip_suffix(".vtp").or_else(|| name.strip_suffix(".vtu"))?;
        let (rest, step) = stem.rsplit_once('_')?;
        let digits = step.bytes().all(|byte| byte.is_ascii_digit());
        let step = if digits { step.parse().ok()? } else { return None };
        let special = KINDS
            .iter()
            .skip(1)
            .find_map(|&(kind, middle)| rest.strip_suffix(middle).map(|family| (family, kind)));
        let (family, kind) = special.unwrap_or((rest, SeriesKind::Triangles));
        (!family.is_empty()).then(|| Self { family: family.to_owned(), kind, step })
    }
}
