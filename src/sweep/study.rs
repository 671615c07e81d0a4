//! Studies: what is varied, what is run, what is told.

use super::{
    base::{Base, Setting, Target},
    cell::Cell,
    outputs::Output,
};
use std::{io, path::PathBuf};
use thiserror::Error;
use yformat::{checksum::Checksum, diagnostic::Diagnostic, dialect::Dialect, source::SourceMap};

/// A study that was read and makes sense.
#[derive(Debug)]
pub struct Study {
    /// Its file.
    pub file: PathBuf,
    /// Folder of the cases and the table.
    pub folder: PathBuf,
    /// What it says of itself.
    pub title: Option<String>,
    /// What is varied.
    pub base: Base,
    /// How.
    pub parameters: Vec<Parameter>,
    /// The cases, numbered from 1.
    pub cases: Vec<Case>,
    /// What is told of each case.
    pub outputs: Vec<Output>,
    /// How cases are run.
    pub plan: RunPlan,
}

/// What takes other values from case to case.
#[derive(Debug)]
pub struct Parameter {
    /// Its name, a column of the table.
    pub name: String,
    /// Unit of its values, where it is known.
    pub unit: Option<String>,
    /// What it sets.
    pub targets: Vec<Target>,
    /// Whether its values multiply what the base has.
    pub is_factor: bool,
    /// Whether numbers are rounded to whole ones.
    pub is_rounded: bool,
}

/// One combination of values.
#[derive(Debug, Clone, PartialEq)]
pub struct Case {
    /// From 1.
    pub number: usize,
    /// One value for each parameter.
    pub values: Vec<Cell>,
}

/// How cases are run.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct RunPlan {
    /// Flags of `ypsilon run`.
    pub flags: Vec<String>,
    /// Kinds of result files beside those that outputs need.
    pub formats: Vec<String>,
    /// Threads of a case, if the study says so.
    pub threads: Option<usize>,
    /// Steps between two checkpoints.
    pub checkpoint_every: u64,
    /// Whether result files stay when the outputs are taken.
    pub keeps: bool,
    /// Whether the table is written as Parquet, too.
    pub parquet: bool,
}

/// Why a study cannot be run.
#[derive(Debug, Error)]
pub enum StudyError {
    /// The file cannot be read.
    #[error("cannot read {path}: {source}")]
    Io {
        /// The study.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
    /// Something in it makes no sense.
    #[error("{finding}")]
    Finding {
        /// The study's text, for the place.
        sources: Box<SourceMap>,
        /// What is wrong, where, and how to mend it.
        finding: Box<Diagnostic>,
    },
    /// The base deck has errors.
    #[error("the base deck has errors")]
    Deck {
        /// Sources that the findings point into.
        sources: Box<SourceMap>,
        /// All findings.
        findings: Vec<Diagnostic>,
    },
}

/// Checks flags of `ypsilon run`; a sentence about what is wrong with them.
pub type FlagCheck<'a> = &'a dyn Fn(&[String]) -> Result<Option<Dialect>, String>;

impl Study {
    /// The case with a number.
    #[must_use]
    pub fn case(&self, number: usize) -> Option<&Case> {
        self.cases.get(number.checked_sub(1)?)
    }

    /// The values of a case with their places.
    pub(super) fn settings<'a>(&'a self, case: &'a Case) -> Vec<Setting<'a>> {
        let of_parameter = |(parameter, cell): (&'a Parameter, &'a Cell)| {
            parameter.targets.iter().map(move |target| Setting {
                target,
                cell,
                is_factor: parameter.is_factor,
                is_rounded: parameter.is_rounded,
            })
        };
        self.parameters.iter().zip(&case.values).flat_map(of_parameter).collect()
    }

    /// What tells the inputs of a case from those of others: equal for equal decks and flags.
    ///
    /// # Errors
    /// If a value does not fit its place.
    pub fn print(&self, case: &Case) -> Result<String, String> {
        let mut print = Checksum::new();
        print.add(self.base.describe(&self.settings(case))?.as_bytes());
        for flag in &self.plan.flags {
            print.add(flag.as_bytes());
            print.add(b"\n");
        }
        Ok(format!("{:016x}", print.value()))
    }

    /// The values of a case in words: `young 1e9, friction 0.5`.
    #[must_use]
    pub fn words(&self, case: &Case) -> String {
        let pairs = self.parameters.iter().zip(&case.values);
        pairs.map(|(p, value)| format!("{} {value}", p.name)).collect::<Vec<_>>().join(", ")
    }
}
