//! Runs in processes of their own.

use super::{BenchError, Measurement, Work};
use std::{
    ffi::OsString,
    io::ErrorKind,
    path::PathBuf,
    process::{Command, Output},
    time::Instant,
};

/// The program that does the work of one run: Ypsilon itself.
#[derive(Debug, Clone)]
pub struct Program {
    /// Its file.
    pub path: PathBuf,
}

/// What counting instructions came to.
#[derive(Debug, Clone, PartialEq)]
pub enum Counted {
    /// Instructions of the whole process.
    Instructions(u64),
    /// They cannot be counted here; why.
    Impossible(String),
}

impl Program {
    /// The program that runs now.
    ///
    /// # Errors
    /// If the system does not say where it is.
    pub fn this() -> Result<Self, BenchError> {
        let path = std::env::current_exe().map_err(BenchError::io("this program"))?;
        Ok(Self { path })
    }

    /// Runs a deck in a process of its own, and gives its measurement and the wall-clock time
    /// from the start of the process to its end, s.
    ///
    /// # Errors
    /// If the process cannot start or the run fails.
    pub fn measure(&self, work: &Work, threads: usize) -> Result<(Measurement, f64), BenchError> {
        let started = Instant::now();
        let output = Command::new(&self.path)
            .args(arguments(work, threads))
            .output()
            .map_err(BenchError::io(&self.path))?;
        let seconds = started.elapsed().as_secs_f64();
        if !output.status.success() {
            return Err(failure(work, &output));
        }
        let measurement = serde_json::from_slice(&output.stdout)
            .map_err(|error| worker(work, error.to_string()))?;
        Ok((measurement, seconds))
    }

    /// Counts the instructions of the same on one thread, with valgrind's cachegrind.
    ///
    /// # Errors
    /// If the run fails. A machine without valgrind is no error.
    pub fn count(&self, work: &Work) -> Result<Counted, BenchError> {
        let log = work.folder.join("valgrind.log");
        let with = |option: &str, path: &std::path::Path| {
            let mut argument = OsString::from(option);
            argument.push(path);
            argument
        };
        let output = Command::new("valgrind")
            .args(["--tool=cachegrind", "--cache-sim=no", "--branch-sim=no"])
            .args(["--cachegrind-out-file=/dev/null"])
            .arg(with("--log-file=", &log))
            .arg(&self.path)
            .args(arguments(work, 1))
            .output();
        let output = match output {
            Ok(output) => output,
            Err(error) if error.kind() == ErrorKind::NotFound => {
                let reason = "valgrind is not installed: instructions are not counted";
                return Ok(Counted::Impossible(reason.to_owned()));
            }
            Err(error) => return Err(BenchError::io("valgrind")(error)),
        };
        let text = std::fs::read_to_string(&log).unwrap_or_default();
        if !output.status.success() {
            // a processor that valgrind does not know, for example
            let reason = text.lines().chain(Some("")).next().unwrap_or_default();
            let status = output.status;
            return Ok(Counted::Impossible(format!("valgrind failed ({status}): {reason}")));
        }
        Ok(instructions(&text).map_or_else(
            || Counted::Impossible("valgrind gave no number of instructions".to_owned()),
            Counted::Instructions,
        ))
    }
}

/// The command line of a run, as `ypsilon bench` understands it.
fn arguments(work: &Work, threads: usize) -> Vec<OsString> {
    let mut arguments: Vec<OsString> = vec!["bench".into(), "--worker".into()];
    arguments.push(work.deck.clone().into());
    arguments.push("--worker-folder".into());
    arguments.push(work.folder.clone().into());
    arguments.push("--threads".into());
    arguments.push(threads.to_string().into());
    if let Some(steps) = work.steps {
        arguments.push("--steps".into());
        arguments.push(steps.to_string().into());
    }
    if work.takes_phases {
        arguments.push("--worker-phases".into());
    }
    arguments
}

/// `==123== I refs: 1,234` in the log of cachegrind.
fn instructions(log: &str) -> Option<u64> {
    let line = log.lines().find(|line| line.contains("I") && line.contains("refs:"))?;
    let digits: String = line.split("refs:").nth(1)?.chars().filter(char::is_ascii_digit).collect();
    digits.parse().ok()
}

fn failure(work: &Work, output: &Output) -> BenchError {
    let said = String::from_utf8_lossy(&output.stderr);
    let said = said.trim().trim_start_matches("error: ").to_owned();
    worker(work, if said.is_empty() { output.status.to_string() } else { said })
}

fn worker(work: &Work, message: String) -> BenchError {
    BenchError::Worker { scene: work.deck.display().to_string(), message }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn instructions_are_found_in_the_log() {
        let log = "==7== Cachegrind, a cache profiler\n==7== \n==7== I   refs:      1,234,567\n";
        assert_eq!(instructions(log), Some(1_234_567));
        assert_eq!(instructions("==7== I refs: 12\n"), Some(12));
        assert_eq!(instructions("==7== no figure\n"), None);
    }
}
