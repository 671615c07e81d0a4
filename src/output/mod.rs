//! What a run writes, and when.
//!
//! Each kind of file has a writer of its own behind [`ResultWriter`]. Every
//! result file is written under a temporary name and takes its final one when
//! it is complete; the run's log `Ytmp` is written as the run goes.

mod bodies;
mod d3plot;
mod elements;
mod error;
mod histories;
mod monitors;
mod names;
mod restart_deck;
mod run_table;
mod snapshots;
mod state_file;
mod vtu;

pub use bodies::body_of_elements;
pub use d3plot::D3plotOutput;
pub use error::OutputError;
pub use histories::HistoryOutput;
pub use monitors::{Monitor, MonitorOutput, MonitorPlan, MonitorQuantity};
pub use names::OutputNames;
pub use restart_deck::RestartDeckOutput;
pub use run_table::{RunTable, TABLE_HEADER, table_row};
pub use snapshots::SnapshotOutput;
pub use state_file::{StateFileOutput, write_state};
pub use vtu::VtuOutput;

use crate::simulation::Simulation;
use std::path::PathBuf;
use yformat::{database::Database, deck::Deck};

/// A kind of result file.
pub trait ResultWriter {
    /// Looks at the values of a stage of the deck before its first step.
    ///
    /// # Errors
    /// If they cannot be written out.
    fn begin_stage(&mut self, _deck: &Deck, _values: &Database) -> Result<(), OutputError> {
        Ok(())
    }

    /// Looks at the state after the forces of a step were evaluated and before
    /// the nodes move, and writes what is due at this step.
    ///
    /// # Errors
    /// If a file cannot be written.
    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError>;

    /// Looks at the state after the nodes have moved, while step and time are still
    /// those of the forces.
    ///
    /// # Errors
    /// If a file cannot be written.
    fn after_motion(&mut self, _simulation: &Simulation) -> Result<(), OutputError> {
        Ok(())
    }

    /// Looks at the state after a completed step.
    ///
    /// # Errors
    /// If a file cannot be written.
    fn after_step(&mut self, _simulation: &Simulation) -> Result<(), OutputError> {
        Ok(())
    }

    /// Completes all files and names them.
    ///
    /// # Errors
    /// If a file cannot be completed.
    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError>;
}
