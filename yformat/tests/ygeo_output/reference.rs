//! The cases with results of the original: a few committed, all where the shared folder is.

use std::fs;
use std::path::{Path, PathBuf};

use yformat::ygeo_output::ResultFile;

/// A folder with a deck of the same name and its results.
pub struct Case {
    pub name: String,
    folder: PathBuf,
}

impl Case {
    /// The deck's path: what the names of results begin with.
    pub fn deck(&self) -> PathBuf {
        self.folder.join(format!("{}.y", self.name))
    }

    pub fn read(&self, file: &str) -> String {
        let path = self.folder.join(file);
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    pub fn result(&self, file: ResultFile, step: u64) -> String {
        let path = file.path(&self.deck(), step);
        fs::read_to_string(&path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
    }

    /// A text file, if the run wrote one.
    pub fn text(&self, path: &Path) -> Option<String> {
        path.exists().then(|| fs::read_to_string(path).unwrap())
    }

    /// The steps with output files.
    pub fn steps(&self) -> Vec<u64> {
        let prefix = format!("{}.y_", self.name);
        let entries = fs::read_dir(&self.folder).unwrap();
        let mut steps: Vec<u64> = entries
            .filter_map(|entry| {
                let name = entry.unwrap().file_name().into_string().unwrap();
                name.strip_prefix(&prefix)?.strip_suffix(".vtp")?.parse().ok()
            })
            .collect();
        steps.sort_unstable();
        assert!(!steps.is_empty(), "{} has results", self.folder.display());
        steps
    }
}

/// All cases; those committed stand in for the shared ones where these are absent.
pub fn cases() -> Vec<Case> {
    let manifest = Path::new(env!("CARGO_MANIFEST_DIR"));
    let shared = manifest.join("../../shared/reference/ygeo");
    let folder = if shared.is_dir() {
        shared
    } else {
        println!("skipped: no {}, only the committed cases", shared.display());
        manifest.join("tests/data/ygeo_output")
    };
    cases_in(&folder)
}

/// The committed cases, which must be what the shared folder has.
pub fn committed() -> Vec<Case> {
    cases_in(&Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/ygeo_output"))
}

fn cases_in(folder: &Path) -> Vec<Case> {
    let mut cases: Vec<Case> = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path())
        .filter(|path| path.is_dir())
        .map(|folder| Case {
            name: folder.file_name().unwrap().to_string_lossy().into_owned(),
            folder,
        })
        .collect();
    cases.sort_by(|a, b| a.name.cmp(&b.name));
    assert!(cases.len() >= 3, "cases in {}", folder.display());
    cases
}
