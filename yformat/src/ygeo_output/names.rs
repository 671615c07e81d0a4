//! The names of the result files: the deck's full name with something behind it.

use std::path::{Path, PathBuf};

/// One of the seven files of an output step.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ResultFile {
    /// Triangles with velocities, forces, stresses and strains.
    Elements,
    /// Broken joints.
    BrokenJoints,
    /// Yielded joints.
    YieldedJoints,
    /// Rebars.
    Rebars,
    /// Joints of rebars.
    OneDimensionalJoints,
    /// Acoustic events.
    AcousticEvents,
    /// Principal directions of the stress.
    PrincipalDirections,
}

impl ResultFile {
    /// All of them.
    pub const ALL: [Self; 7] = [
        Self::Elements,
        Self::BrokenJoints,
        Self::YieldedJoints,
        Self::Rebars,
        Self::OneDimensionalJoints,
        Self::AcousticEvents,
        Self::PrincipalDirections,
    ];

    /// The file of `step` of the run with `deck`: `wall.y_broken_joints_200.vtp`, beside the
    /// deck.
    #[must_use]
    pub fn path(self, deck: &Path, step: u64) -> PathBuf {
        let (middle, extension) = match self {
            Self::Elements => ("", "vtp"),
            Self::BrokenJoints => ("broken_joints_", "vtp"),
            Self::YieldedJoints => ("yielded_joints_", "vtp"),
            Self::Rebars => ("rebars_", "vtp"),
            Self::OneDimensionalJoints => ("1D_joints_", "vtp"),
            Self::AcousticEvents => ("acoustic_", "vtu"),
            Self::PrincipalDirections => ("principal_direction_", "vtu"),
        };
        behind(deck, &format!("_{middle}{step}.{extension}"))
    }
}

/// One of the text files. All but [`TextFile::Restart`] grow by appending.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum TextFile {
    /// History number so and so, from 0.
    History(usize),
    /// Joints as they broke.
    Breakage,
    /// Joints as they yielded ("softened").
    Yielding,
    /// Totals of broken joints.
    FractureTotals,
    /// Hydrofracture.
    Hydrofracture,
    /// Restart fragment number so and so.
    Restart(u64),
}

impl TextFile {
    /// The file of the run with `deck`: `wall.yhBRK`, beside the deck.
    #[must_use]
    pub fn path(self, deck: &Path) -> PathBuf {
        match self {
            Self::History(number) => behind(deck, &format!("h{number}")),
            Self::Breakage => behind(deck, "hBRK"),
            Self::Yielding => behind(deck, "hSFT"),
            Self::FractureTotals => behind(deck, "hFRAC"),
            Self::Hydrofracture => behind(deck, "hHF"),
            Self::Restart(number) => behind(deck, &format!("res{number}")),
        }
    }
}

fn behind(deck: &Path, tail: &str) -> PathBuf {
    let mut name = deck.as_os_str().to_os_string();
    name.push(tail);
    PathBuf::from(name)
}
