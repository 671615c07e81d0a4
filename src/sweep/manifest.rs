//! `manifest.json`: what the cases of a folder are, so that a changed study is noticed.

use super::{
    error::{SweepError, at},
    json_file::write_json,
    run_case::folder_name,
    study::Study,
};
use serde::{Deserialize, Serialize};
use std::{fs, path::PathBuf};

/// The cases of a folder.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
struct Manifest {
    version: String,
    study: String,
    cases: Vec<Entry>,
}

/// A case: its values in words, and what tells its inputs from others.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
struct Entry {
    values: String,
    inputs: String,
}

/// Most changes that a message tells one by one.
const MOST_TOLD: usize = 3;

impl Study {
    /// Compares the study with what its folder was made for, and writes that down.
    ///
    /// # Errors
    /// If cases have changed since, unless they are to be `updated`; if the file cannot be written.
    pub fn settle_folder(&self, updated: bool) -> Result<(), SweepError> {
        let now = self.manifest();
        let before = self.manifest_there();
        if let Some(before) = before.as_ref().filter(|_| !updated)
            && let Some(words) = self.difference(before, &now)
        {
            return Err(SweepError::Changed(words));
        }
        if before.as_ref() == Some(&now) {
            return Ok(());
        }
        fs::create_dir_all(&self.folder).map_err(at(&self.folder))?;
        let path = self.manifest_path();
        write_json(&path, &now)
    }

    /// Cases that the folder holds beyond those of the study, by the names of their folders.
    #[must_use]
    pub fn left_over(&self) -> Vec<String> {
        let after = (self.cases.len() + 1..).map(folder_name);
        after.take_while(|name| self.folder.join(name).join("case.json").exists()).collect()
    }

    /// Says how the study differs from what its folder was made for; nothing if it does not.
    ///
    /// # Errors
    /// If cases have changed.
    pub fn compare_with_folder(&self) -> Result<(), SweepError> {
        let difference =
            self.manifest_there().and_then(|there| self.difference(&there, &self.manifest()));
        difference.map_or(Ok(()), |words| Err(SweepError::Changed(words)))
    }

    fn manifest_path(&self) -> PathBuf {
        self.folder.join("manifest.json")
    }

    fn manifest_there(&self) -> Option<Manifest> {
        serde_json::from_slice(&fs::read(self.manifest_path()).ok()?).ok()
    }

    fn manifest(&self) -> Manifest {
        let entry = |case| Entry {
            values: self.words(case),
            inputs: self.print(case).unwrap_or_else(|words| words),
        };
        Manifest {
            version: env!("CARGO_PKG_VERSION").to_owned(),
            study: self.file.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            cases: self.cases.iter().map(entry).collect(),
        }
    }

    fn difference(&self, before: &Manifest, now: &Manifest) -> Option<String> {
        let both = before.cases.iter().zip(&now.cases).enumerate();
        let changed: Vec<(usize, &Entry, &Entry)> = both
            .filter(|(_, (a, b))| a.inputs != b.inputs)
            .map(|(index, (a, b))| (index + 1, a, b))
            .collect();
        let (was, is) = (before.cases.len(), now.cases.len());
        // cases that are added or taken away leave the others what they were
        if changed.is_empty() {
            return None;
        }
        let told = changed.iter().take(MOST_TOLD).map(|(number, a, b)| {
            if a.values == b.values {
                format!("  case {number} ({}): the base, its targets or [run] flags", a.values)
            } else {
                format!("  case {number}: was {}; is {}", a.values, b.values)
            }
        });
        let mut lines: Vec<String> = told.collect();
        if changed.len() > MOST_TOLD {
            lines.push(format!("  and {} more", changed.len() - MOST_TOLD));
        }
        let counts =
            if was == is { String::new() } else { format!(" ({was} cases then, {is} now)") };
        Some(format!(
            "{study} has changed since {folder} was made{counts}. Other inputs have\n{lines}\n\
             run these cases anew with --update (others are kept), or take another folder with --out",
            study = self.file.display(),
            folder = self.folder.display(),
            lines = lines.join("\n")
        ))
    }
}
