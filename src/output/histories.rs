//! `.yh` histories of a run (spec `y2d3d.md` G.3).

use super::{OutputError, OutputNames, ResultWriter};
use crate::simulation::Simulation;
use std::{
    fs,
    io::{BufWriter, Write},
    path::PathBuf,
};
use yformat::{
    history::{HistoryWriter, LineStyle},
    part_file::PartFile,
};

/// Lines are written at steps whose index is a multiple of this: fixed in the
/// original, whatever the output interval.
const LINE_INTERVAL: u64 = 100;

/// Writes one file per history.
pub struct HistoryOutput {
    files: Vec<HistoryWriter<BufWriter<PartFile>>>,
}

impl HistoryOutput {
    /// Opens the files of a simulation's probes.
    ///
    /// A run that continues an earlier one (first step above 0) goes on with
    /// the histories that are there, as the original does; a run from step 0
    /// begins them anew.
    ///
    /// # Errors
    /// If a file cannot be created or an earlier one cannot be read.
    pub fn open(names: &OutputNames, simulation: &Simulation) -> Result<Self, OutputError> {
        let continues = simulation.scene().control.first_step > 0;
        let open = |index: usize| -> Result<_, OutputError> {
            let path = names.history(index);
            let mut part = PartFile::create(&path).map_err(OutputError::io(&path))?;
            if continues && path.exists() {
                let earlier = fs::read(&path).map_err(OutputError::io(&path))?;
                part.write_all(&earlier).map_err(OutputError::io(&path))?;
            }
            Ok(HistoryWriter::new(BufWriter::new(part), LineStyle::Unix))
        };
        let files = (0..simulation.scene().probes.len()).map(open).collect::<Result<_, _>>()?;
        Ok(Self { files })
    }
}

impl ResultWriter for HistoryOutput {
    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if !simulation.step_index().is_multiple_of(LINE_INTERVAL) {
            return Ok(());
        }
        let probes = &simulation.scene().probes;
        for ((file, probe), &value) in
            self.files.iter_mut().zip(probes).zip(simulation.probe_values())
        {
            let time = simulation.time() * probe.time_factor;
            file.write(time, value * probe.value_factor)
                .map_err(OutputError::io("a history file"))?;
        }
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        let complete = |file: HistoryWriter<BufWriter<PartFile>>| {
            let part = file
                .into_inner()
                .into_inner()
                .map_err(|e| OutputError::io("a history file")(e.into_error()))?;
            let path = part.path().to_path_buf();
            part.complete().map_err(OutputError::io(path))
        };
        self.files.into_iter().map(complete).collect()
    }
}
