//! Cases with known answers: each is a folder under `examples/` with scenario files, a README and
//! pictures, and a function here that runs it and says what came out.
//!
//! * [`case`]: what a case is, and the groups
//! * [`bench`](mod@bench): where and how long a case runs, with helpers to run scenarios
//! * [`finding`]: an expected and an obtained quantity, and whether they agree
//! * [`report`]: READMEs and `examples/REPORT.md`
//! * [`cases`]: the cases, one file each
//!
//! `cargo run --release -p ypsilon-examples -- report` runs them all.

pub mod bench;
pub mod case;
pub mod cases;
mod error;
pub mod finding;
pub mod measure;
pub mod plotting;
pub mod record;
pub mod report;

pub use bench::{Bench, InSpace, Length, Run, Watched, WatchedInSpace};
pub use case::{Case, Group, Outcome};
pub use error::CaseError;
pub use finding::{Expected, Finding, Obtained, Tolerance};
