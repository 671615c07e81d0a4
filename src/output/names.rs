use std::path::{Path, PathBuf};

/// Names of the files that a run writes (spec `y2d3d.md` G.1).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct OutputNames {
    folder: PathBuf,
    deck: String,
    base: String,
}

impl OutputNames {
    /// Names for results of `deck` in `folder`.
    ///
    /// Results are named after the deck's file name: histories after the whole
    /// name, everything else after the name up to its last dot. As in the
    /// original a name without a dot loses its last character, so that no
    /// result takes the place of the deck.
    #[must_use]
    pub fn new(deck: &Path, folder: &Path) -> Self {
        let deck = deck.file_name().unwrap_or_default().to_string_lossy().into_owned();
        // decks named on the command line of the original carry backslashes
        let deck = deck.rsplit('\\').next().unwrap_or_default().to_owned();
        let base = match deck.rfind('.') {
            Some(dot) => deck[..dot].to_owned(),
            None => deck.chars().take(deck.chars().count().saturating_sub(1)).collect(),
        };
        let base = if base.is_empty() { "ypsilon".to_owned() } else { base };
        Self { folder: folder.to_path_buf(), deck, base }
    }

    /// Name up to the last dot.
    #[must_use]
    pub fn base(&self) -> &str {
        &self.base
    }

    /// Folder of the results.
    #[must_use]
    pub fn folder(&self) -> &Path {
        &self.folder
    }

    /// First file of the d3plot family.
    #[must_use]
    pub fn d3plot(&self) -> PathBuf {
        self.folder.join(&self.base)
    }

    /// File of history `index`.
    #[must_use]
    pub fn history(&self, index: usize) -> PathBuf {
        self.folder.join(format!("{}h{index}", self.deck))
    }

    /// What the files of Y-Geo begin with: the whole name of the deck.
    #[must_use]
    pub fn prefix(&self) -> PathBuf {
        self.folder.join(&self.deck)
    }

    /// Snapshot of the classic dialect.
    #[must_use]
    pub fn snapshot(&self, number: u64) -> PathBuf {
        self.folder.join(format!("{}{number}.ym", self.stem()))
    }

    /// Restart deck of the classic dialect, written after the snapshot with this number.
    #[must_use]
    pub fn restart(&self, snapshot: u64) -> PathBuf {
        self.folder.join(format!("{}{snapshot}_restart.y", self.stem()))
    }

    /// Mesh that the classic dialect writes beside a restart deck.
    #[must_use]
    pub fn mesh(&self) -> PathBuf {
        self.folder.join(format!("{}.msh", self.stem()))
    }

    /// Contact forces of the classic dialect.
    #[must_use]
    pub fn contact_forces(&self) -> PathBuf {
        self.folder.join("contactforce.txt")
    }

    /// Name up to the first dot, after which the classic dialect calls its files.
    fn stem(&self) -> &str {
        match self.deck.split('.').next() {
            Some(stem) if !stem.is_empty() => stem,
            _ => "ypsilon",
        }
    }

    /// Table of the monitors.
    #[must_use]
    pub fn monitors(&self) -> PathBuf {
        self.folder.join(format!("{}.monitors.csv", self.base))
    }

    /// Table of energies.
    #[must_use]
    pub fn energy(&self) -> PathBuf {
        self.folder.join(format!("{}.energy.csv", self.base))
    }

    /// The run's log.
    #[must_use]
    pub fn log(&self) -> PathBuf {
        self.folder.join("Ytmp")
    }

    /// VTU file of a step; `part` is empty for the bodies.
    #[must_use]
    pub fn vtu(&self, part: &str, step: u64) -> PathBuf {
        self.folder.join(format!("{}{part}_{step:07}.vtu", self.base))
    }

    /// Collection of all VTU files.
    #[must_use]
    pub fn pvd(&self) -> PathBuf {
        self.folder.join(format!("{}.pvd", self.base))
    }

    /// Full-precision state after `steps` completed steps.
    #[must_use]
    pub fn state(&self, steps: u64) -> PathBuf {
        self.folder.join(format!("{}.state_{steps}.txt", self.base))
    }

    /// Full-precision state just before a run became unstable.
    #[must_use]
    pub fn unstable_state(&self) -> PathBuf {
        self.folder.join(format!("{}.unstable.state.txt", self.base))
    }

    /// VTU file of the state just before a run became unstable; `part` is empty for the bodies.
    #[must_use]
    pub fn unstable_vtu(&self, part: &str) -> PathBuf {
        self.folder.join(format!("{}{part}.unstable.vtu", self.base))
    }

    /// Checkpoint just before a run became unstable.
    #[must_use]
    pub fn unstable_checkpoint(&self) -> PathBuf {
        self.folder.join(format!("{}.unstable.checkpoint", self.base))
    }

    /// Checkpoint that a later run can go on from.
    #[must_use]
    pub fn checkpoint(&self) -> PathBuf {
        self.folder.join(format!("{}.checkpoint", self.base))
    }

    /// Machine-readable summary of the run.
    #[must_use]
    pub fn summary(&self) -> PathBuf {
        self.folder.join(format!("{}.run.json", self.base))
    }
}

#[cfg(test)]
mod tests {
    use super::OutputNames;
    use std::path::Path;

    #[test]
    fn names_follow_the_original_rules() {
        let names = |deck: &str| OutputNames::new(Path::new(deck), Path::new("out"));
        assert_eq!(names("a/wall.2.y").base(), "wall.2");
        assert_eq!(names("actual").base(), "actua");
        assert_eq!(names("decks\\arch.y").base(), "arch");
        assert_eq!(names(".y").base(), "ypsilon");
        assert_eq!(names("arch.y").history(3), Path::new("out/arch.yh3"));
    }
}
