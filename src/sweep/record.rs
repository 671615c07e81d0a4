//! What is known of a case: `case.json` in its folder.

use super::{error::SweepError, json_file::write_json};
use serde::{Deserialize, Serialize};
use std::path::Path;

/// Name of the file.
const NAME: &str = "case.json";

/// How far a case is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum State {
    /// Its input files are written.
    Ready,
    /// It was started; if nobody runs it, it was killed.
    Running,
    /// It was interrupted, and goes on or begins anew the next time.
    Interrupted,
    /// It is over, well or not.
    Ended,
}

/// What is known of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Record {
    /// Its number, from 1.
    pub case: usize,
    /// Version of Ypsilon.
    pub version: String,
    /// Its values in words.
    pub values: String,
    /// What tells its inputs from others.
    pub inputs: String,
    /// How far it is.
    pub state: State,
    /// Exit code of its run, as `ypsilon run` has them, 128 and the signal for a run that was
    /// killed; 1 also for a run without the outputs that are asked for.
    pub status: i32,
    /// Why it failed.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub message: String,
    /// What tells the outputs that were asked for from others.
    #[serde(default)]
    pub asked: String,
    /// Their numbers. They are words, because readers of JSON round.
    #[serde(default)]
    pub outputs: Vec<String>,
}

impl Record {
    /// The record in a folder; none if there is none that can be read.
    #[must_use]
    pub fn read(folder: &Path) -> Option<Self> {
        serde_json::from_slice(&std::fs::read(folder.join(NAME)).ok()?).ok()
    }

    pub(super) fn write(&self, folder: &Path) -> Result<(), SweepError> {
        write_json(&folder.join(NAME), self)
    }

    /// Whether it ended well.
    #[must_use]
    pub fn is_done(&self) -> bool {
        self.state == State::Ended && self.status == 0
    }

    /// Whether it failed.
    #[must_use]
    pub fn has_failed(&self) -> bool {
        self.state == State::Ended && self.status != 0
    }

    /// Whether it failed for a reason outside of it, such as a full disk or a signal: it would not
    /// fail again for its values.
    #[must_use]
    pub fn is_to_blame_on_the_machine(&self) -> bool {
        self.has_failed() && (self.status == 3 || self.status >= 128)
    }
}
