//! What a run writes, and when.
//!
//! Each kind of file has a writer of its own behind [`ResultWriter`]. Every
//! result file is written under a temporary name and takes its final one when
//! it is complete; the run's log `Ytmp` is written as the run goes.

mod background;
mod bodies;
mod d3plot;
mod d3plot_family;
mod elements;
mod energy;
mod error;
mod histories;
mod mark;
mod monitors;
mod names;
mod restart_deck;
mod run_table;
mod snapshots;
mod spatial;
mod state_file;
mod table_file;
mod vtu;
mod vtu_series;
mod ygeo;

pub use background::Background;
pub use bodies::body_of_elements;
pub use d3plot::D3plotOutput;
pub use energy::{Audit, EnergyOutput, EnergySummary};
pub use error::OutputError;
pub use histories::HistoryOutput;
pub use mark::{FilePosition, decode, encode, file_names, present};
pub use monitors::{Monitor, MonitorOutput, MonitorPlan, MonitorQuantity};
pub use names::OutputNames;
pub use restart_deck::RestartDeckOutput;
pub use run_table::{RunTable, TABLE_HEADER, table_row};
pub use snapshots::SnapshotOutput;
pub use spatial::{SpatialD3plotOutput, SpatialVtuOutput, body_of_tetrahedra, spatial_grids};
pub use state_file::{StateFileOutput, write_spatial_state, write_state};
pub use vtu::{VtuOutput, grids};
pub use ygeo::YGeoOutput;

use crate::simulation::Simulation;
use std::{
    io::{self, Write as _},
    path::{Path, PathBuf},
};
use yformat::{database::Database, deck::Deck, part_file::PartFile};

/// A kind of result file of a simulation `S`.
pub trait ResultWriter<S = Simulation> {
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
    fn after_forces(&mut self, _simulation: &S) -> Result<(), OutputError> {
        Ok(())
    }

    /// Looks at the state after the nodes have moved, while step and time are still
    /// those of the forces.
    ///
    /// # Errors
    /// If a file cannot be written.
    fn after_motion(&mut self, _simulation: &S) -> Result<(), OutputError> {
        Ok(())
    }

    /// Looks at the state after a completed step.
    ///
    /// # Errors
    /// If a file cannot be written.
    fn after_step(&mut self, _simulation: &S) -> Result<(), OutputError> {
        Ok(())
    }

    /// What the files are, as `--formats` calls them.
    fn kind(&self) -> &'static str {
        std::any::type_name::<Self>()
    }

    /// How the run kept its energy, if this writer watches that.
    fn energy(&self) -> Option<EnergySummary> {
        None
    }

    /// Complete files of a series of one file per state. A writer that needs nothing but their
    /// list to go on with the series gives it here and is done with checkpoints.
    fn series(&mut self) -> Option<&mut Vec<PathBuf>> {
        None
    }

    /// What a later run needs to go on with the files from here; what has been written so far
    /// is on the disk afterwards. Nothing is left to be written in the background.
    ///
    /// # Errors
    /// If the files cannot be gone on with, or the system cannot put them on the disk.
    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        let kind = self.kind();
        match self.series() {
            Some(files) => encode(kind, &file_names(kind, files)?),
            None => Err(OutputError::NotResumable { kind }),
        }
    }

    /// Goes on with the files of an earlier run, which [`Self::mark`] told about at the present
    /// state of the simulation.
    ///
    /// # Errors
    /// If the files are not as they were left.
    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        _simulation: &S,
    ) -> Result<(), OutputError> {
        let kind = self.kind();
        let files = self.series().ok_or(OutputError::NotResumable { kind })?;
        *files = present(names, &decode::<Vec<String>>(kind, mark)?)?;
        Ok(())
    }

    /// Completes all files and names them. What was handed over to be written in the background
    /// has been written.
    ///
    /// # Errors
    /// If a file cannot be completed.
    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError>;
}

/// Writes a file that appears when it is complete: its contents are made now, and go to the disk
/// while the run goes on.
fn save(
    background: &Background,
    path: &Path,
    write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>,
) -> Result<(), OutputError> {
    let mut contents = Vec::new();
    write(&mut contents).map_err(OutputError::io(path))?;
    let path = path.to_path_buf();
    background.submit(move || {
        let write = || {
            let mut file = PartFile::create(&path)?;
            file.write_all(&contents)?;
            file.complete()
        };
        write().map(drop).map_err(OutputError::io(&path))
    })
}
