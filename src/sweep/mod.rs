//! Parameter studies: a deck or scenario run with many combinations of values, and one table of
//! what came out.
//!
//! ```text
//! study.toml ── Study ── sampling ──▶ Case ── base ──▶ case-0001/deck.y ── ypsilon run ──▶ results
//!                                                                  outputs ◀──────────────┘
//!                                      results.csv ◀── StudyTable ◀── Record (case.json)
//! ```
//!
//! Everything that is known of a case lies in its own folder, so that any number of processes, on
//! any machines that share the folder, can run cases of one study, and each can be killed at any
//! time. [`Study::run_case`] is all that local sweeps, GNU Parallel and Slurm do.

mod base;
mod cell;
mod child;
mod error;
mod evaluate;
mod export;
mod json_file;
mod manifest;
mod outputs;
mod pool;
mod random;
mod read;
mod record;
mod run_case;
mod sampling;
mod scenario_path;
mod study;
mod study_file;
mod table;
mod values;

pub use base::{Base, Target};
pub use cell::Cell;
pub use error::SweepError;
pub use export::Scheduler;
pub use outputs::{Figure, Output, Source, When};
pub use pool::{Event, jobs_and_threads};
pub use record::{Record, State};
pub use run_case::Runner;
pub use sampling::{MOST_CASES, Sampling};
pub use scenario_path::ScenarioPath;
pub use study::{Case, FlagCheck, Parameter, RunPlan, Study, StudyError};
pub use table::{StudyTable, parquet_is_there};
pub use values::Values;
