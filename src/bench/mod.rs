//! Benchmarks: how fast scenes run, and what accuracy costs.
//!
//! - [`run_suite`] runs [scenes](SCENES) and decks, each run in a process of its own
//!   ([`work`] is what that process does), and gives a [`Report`]: triangle-steps per second,
//!   time of each phase, memory, speed-up, growth, instructions;
//! - [`markdown`] turns a report into tables and puts them into a document;
//! - [`work_precision`] compares solutions with exact answers over time step, penalty, contact
//!   buffer, mesh and viscosity.

mod child;
mod error;
mod machine;
pub mod markdown;
mod report;
mod scenes;
mod statistics;
mod suite;
pub mod work_precision;
mod worker;

pub use child::{Counted, Program};
pub use error::BenchError;
pub use machine::Machine;
pub use report::{Growth, Report, Run, SceneReport};
pub use scenes::{SCENES, Scene, found_decks};
pub use statistics::{Spread, growth_exponent, median};
pub use suite::{Plan, Subject, run_suite};
pub use worker::{Measurement, Work, work};
