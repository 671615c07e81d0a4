//! `.yh` histories of a run (spec `y2d3d.md` G.3, `outputs.md` 2 and 5.7).

use super::{
    FilePosition, OutputError, OutputNames, ResultWriter, decode, encode, table_file::TableFile,
};
use crate::{
    mechanics::Vec2,
    scene::{HistoryLines, Probe, Scene},
    simulation::{Simulation, SpatialSimulation},
};
use std::{
    fs,
    io::{self, Write},
    path::PathBuf,
};
use yformat::{
    dialect::Dialect,
    history::{HistoryWriter, LineStyle},
};

/// What `--formats` calls the files.
const KIND: &str = "yh";
/// Lines are written at steps whose index is a multiple of this: fixed in the
/// original of the split dialect, whatever the output interval.
const LINE_INTERVAL: u64 = 100;
/// Property set over whose nodes the classic dialect sums contact forces: fixed there.
const SUMMED_SET: i32 = 1;

/// Writes one file per history.
pub struct HistoryOutput {
    files: Vec<TableFile>,
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
    pub fn open<const D: usize>(
        names: &OutputNames,
        scene: &Scene<D>,
    ) -> Result<Self, OutputError> {
        let continues = scene.control.first_step > 0;
        let open = |index: usize| -> Result<_, OutputError> {
            let path = names.history(index);
            let mut table = TableFile::create(path.clone())?;
            if continues && path.exists() {
                let earlier = fs::read(&path).map_err(OutputError::io(&path))?;
                table.write(|file| file.write_all(&earlier))?;
            }
            Ok(table)
        };
        let files = (0..scene.probes.len()).map(open).collect::<Result<_, _>>()?;
        Ok(Self { files })
    }

    /// Histories of an earlier run, to be gone on with.
    #[must_use]
    pub fn closed() -> Self {
        Self { files: Vec::new() }
    }

    /// Writes a line of each history for which one `is_due`.
    fn lines(
        &mut self,
        simulation: &Simulation,
        is_due: impl Fn(usize) -> bool,
    ) -> Result<(), OutputError> {
        let probes = &simulation.scene().probes;
        for (index, (probe, table)) in probes.iter().zip(&mut self.files).enumerate() {
            if is_due(index) {
                let value = simulation.probe_values()[index];
                table.write(|file| line(file, simulation, probe, value))?;
            }
        }
        Ok(())
    }
}

fn line(
    file: &mut impl Write,
    simulation: &Simulation,
    probe: &Probe,
    value: f64,
) -> io::Result<()> {
    let (time, value) = (simulation.time() * probe.time_factor, value * probe.value_factor);
    match simulation.scene().conventions.dialect {
        Dialect::Classic => {
            let force = contact_force_on_set(simulation, SUMMED_SET);
            yformat::classic_output::write_history_point(file, time, value, force.into())
        }
        Dialect::YGeo => yformat::ygeo_output::write_history_point(file, time, value),
        Dialect::Split | Dialect::Y3d => {
            HistoryWriter::new(file, LineStyle::Unix).write(time, value)
        }
    }
}

/// Sum of the contact forces on the nodes of a property set, nodes ascending, N.
fn contact_force_on_set(simulation: &Simulation, set: i32) -> Vec2 {
    let nodes = simulation.scene().nodes.set.iter().zip(simulation.contact_forces());
    nodes.filter(|(s, _)| **s == set).fold(Vec2::zeros(), |sum, (_, force)| sum + force)
}

impl ResultWriter for HistoryOutput {
    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let is_due = simulation.scene().conventions.history_lines
            == HistoryLines::EveryHundredSteps
            && simulation.step_index().is_multiple_of(LINE_INTERVAL);
        self.lines(simulation, |_| is_due)
    }

    fn after_motion(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if simulation.scene().conventions.history_lines != HistoryLines::WhenRefreshed {
            return Ok(());
        }
        let now = simulation.time();
        self.lines(simulation, |index| simulation.probe_times()[index] == now)
    }

    fn kind(&self) -> &'static str {
        KIND
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        self.mark_files()
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        simulation: &Simulation,
    ) -> Result<(), OutputError> {
        self.resume_files(mark, names, simulation.scene().probes.len())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        self.finish_files()
    }
}

impl ResultWriter<SpatialSimulation> for HistoryOutput {
    fn after_forces(&mut self, simulation: &SpatialSimulation) -> Result<(), OutputError> {
        if !simulation.step_index().is_multiple_of(LINE_INTERVAL) {
            return Ok(());
        }
        let probes = simulation.scene().probes.iter().zip(simulation.probe_values());
        for ((probe, value), table) in probes.zip(&mut self.files) {
            let (time, value) = (simulation.time() * probe.time_factor, value * probe.value_factor);
            table.write(|file| HistoryWriter::new(file, LineStyle::Unix).write(time, value))?;
        }
        Ok(())
    }

    fn kind(&self) -> &'static str {
        KIND
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        self.mark_files()
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        simulation: &SpatialSimulation,
    ) -> Result<(), OutputError> {
        self.resume_files(mark, names, simulation.scene().probes.len())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        self.finish_files()
    }
}

impl HistoryOutput {
    fn mark_files(&mut self) -> Result<Vec<u8>, OutputError> {
        let positions =
            self.files.iter_mut().map(TableFile::mark).collect::<Result<Vec<_>, _>>()?;
        encode(KIND, &positions)
    }

    fn resume_files(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        probes: usize,
    ) -> Result<(), OutputError> {
        let positions: Vec<FilePosition> = decode(KIND, mark)?;
        if positions.len() != probes {
            return Err(OutputError::Mark { kind: KIND });
        }
        let open = |(index, position)| TableFile::resume(names.history(index), position);
        self.files = positions.into_iter().enumerate().map(open).collect::<Result<_, _>>()?;
        Ok(())
    }

    fn finish_files(self) -> Result<Vec<PathBuf>, OutputError> {
        self.files.into_iter().map(TableFile::finish).collect()
    }
}
