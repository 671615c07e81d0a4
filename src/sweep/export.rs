//! Job lists of a study for other machines: GNU Parallel and Slurm.

use super::{
    error::{SweepError, at},
    study::Study,
};
use std::{
    ffi::OsString,
    fs,
    io::Write,
    path::{Component, Path, PathBuf},
};
use yformat::part_file::PartFile;

/// Whom jobs are written for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Scheduler {
    /// GNU Parallel: `jobs.txt` and `parallel.sh`.
    Parallel,
    /// Slurm: `slurm.sh`, an array of jobs.
    Slurm,
}

/// Most jobs of an array: Slurm's own limit, unless its administrator says otherwise, is 1001.
const MOST_ARRAY_JOBS: usize = 1000;

impl Study {
    /// Writes the files of all cases and a job list into the folder of the study; gives what was
    /// written of the latter.
    ///
    /// # Errors
    /// If a file cannot be written, or the folder holds other cases.
    pub fn export(&self, scheduler: Scheduler, updated: bool) -> Result<Vec<PathBuf>, SweepError> {
        self.settle_folder(updated)?;
        for case in &self.cases {
            self.prepare(case, updated)?;
        }
        let study = quoted(&self.study_from_folder()?);
        match scheduler {
            Scheduler::Parallel => {
                let line = |case: &super::Case| {
                    format!("ypsilon sweep run-case {study} {} --out .\n", case.number)
                };
                let lines: String = self.cases.iter().map(line).collect();
                Ok(vec![
                    self.put("parallel.sh", &parallel(&study), true)?,
                    self.put("jobs.txt", &lines, false)?,
                ])
            }
            Scheduler::Slurm => Ok(vec![self.put("slurm.sh", &self.slurm(&study), true)?]),
        }
    }

    /// The study as a path from its folder, so that both can be moved together.
    fn study_from_folder(&self) -> Result<PathBuf, SweepError> {
        let whole = |path: &Path| path.canonicalize().map_err(at(path));
        Ok(relative(&whole(&self.folder)?, &whole(&self.file)?))
    }

    fn put(&self, name: &str, text: &str, is_program: bool) -> Result<PathBuf, SweepError> {
        let path = self.folder.join(name);
        let write = || {
            let mut file = PartFile::create(&path)?;
            file.write_all(text.as_bytes())?;
            let path = file.complete()?;
            #[cfg(unix)]
            if is_program {
                use std::os::unix::fs::PermissionsExt;
                let mut permissions = fs::metadata(&path)?.permissions();
                permissions.set_mode(permissions.mode() | 0o111);
                fs::set_permissions(&path, permissions)?;
            }
            Ok(path)
        };
        write().map_err(at(&path))
    }

    fn slurm(&self, study: &str) -> String {
        let cases = self.cases.len();
        let each = cases.div_ceil(MOST_ARRAY_JOBS).max(1);
        let jobs = cases.div_ceil(each);
        let threads = self.plan.threads.unwrap_or(1);
        let stem = self.file.file_stem().unwrap_or_default().to_string_lossy();
        let name: String =
            stem.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' }).collect();
        format!(
            r#"#!/usr/bin/env bash
# {cases} cases of {study} as an array of {jobs} jobs. Add what your cluster asks for
# (--partition, --account, --time, --mem), then, in this folder:
#   sbatch slurm.sh
#   ypsilon sweep collect {study} --out .
# A job that is out of time is interrupted a minute before and goes on when it is submitted again.
#SBATCH --job-name={name}
#SBATCH --array=1-{jobs}
#SBATCH --ntasks=1
#SBATCH --cpus-per-task={threads}
#SBATCH --output=slurm-%A_%a.log
#SBATCH --signal=B:INT@60
set -euo pipefail
cd "${{SLURM_SUBMIT_DIR:-.}}"
first=$(( (SLURM_ARRAY_TASK_ID - 1) * {each} + 1 ))
last=$(( first + {each} - 1 ))
if [ "$last" -gt {cases} ]; then last={cases}; fi
exec ypsilon sweep run-case {study} "$first-$last" --out . --threads "${{SLURM_CPUS_PER_TASK:-1}}"
"#
        )
    }
}

fn parallel(study: &str) -> String {
    format!(
        r#"#!/usr/bin/env bash
# Runs the cases of {study} with GNU Parallel, then makes the table. Options of parallel
# may follow: ./parallel.sh --jobs 8
set -euo pipefail
cd "$(dirname "${{BASH_SOURCE[0]}}")"
# cases that fail are told by the table
parallel --joblog jobs.log "$@" < jobs.txt || true
ypsilon sweep collect {study} --out .
"#
    )
}

/// The way from one folder to a file, both without links and dots.
fn relative(from: &Path, to: &Path) -> PathBuf {
    let (from, to): (Vec<Component<'_>>, Vec<Component<'_>>) =
        (from.components().collect(), to.components().collect());
    let common = from.iter().zip(&to).take_while(|(a, b)| a == b).count();
    let up = from.iter().skip(common).map(|_| OsString::from(".."));
    let down = to.iter().skip(common).map(|c| c.as_os_str().to_owned());
    up.chain(down).collect()
}

/// A path as a word of a shell.
fn quoted(path: &Path) -> String {
    let text = path.to_string_lossy();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-+,:@".contains(c);
    if !text.is_empty() && text.chars().all(is_plain) {
        return text.into_owned();
    }
    format!("'{}'", text.replace('\'', r"'\''"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ways_lead_from_folder_to_file() {
        let way = |from: &str, to: &str| relative(Path::new(from), Path::new(to));
        assert_eq!(way("/a/b/study", "/a/b/study.toml"), Path::new("../study.toml"));
        assert_eq!(way("/a/b", "/a/b/study.toml"), Path::new("study.toml"));
        assert_eq!(way("/x/y", "/a/study.toml"), Path::new("../../a/study.toml"));
    }

    #[test]
    fn words_of_shells_are_quoted() {
        assert_eq!(quoted(Path::new("../study.toml")), "../study.toml");
        assert_eq!(quoted(Path::new("my study's.toml")), r"'my study'\''s.toml'");
    }
}
