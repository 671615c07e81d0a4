//! Result files as Y-Geo writes them: families of VTK files at output steps and
//! text files of events (spec `outputs.md` 5).

mod events;
mod frames;
mod restart;

use super::{OutputError, OutputNames, ResultWriter};
use crate::{mechanics::Vec2, simulation::Simulation};
use events::EventFiles;
use restart::RestartFragments;
use std::{
    io::{self, BufWriter, Write},
    path::{Path, PathBuf},
};
use yformat::{database::Database, deck::Deck, part_file::PartFile, ygeo_output::ResultFile};

/// Writes all files of Y-Geo but the histories.
pub struct YGeoOutput {
    prefix: PathBuf,
    setup: Option<Setup>,
    events: EventFiles,
    restarts: RestartFragments,
    written: Vec<PathBuf>,
}

/// What is found out at the first output and kept.
struct Setup {
    /// Nodes that are shown: those with mass.
    nodes: Vec<usize>,
    /// Place of each node among them.
    place: Vec<usize>,
    /// Coordinates from which displacements count.
    reference: Vec<Vec2>,
}

impl Setup {
    fn new(simulation: &Simulation) -> Self {
        let masses = simulation.masses();
        let nodes: Vec<usize> = (0..masses.len()).filter(|&n| masses[n] > 0.0).collect();
        let mut place = vec![usize::MAX; masses.len()];
        for (index, &node) in nodes.iter().enumerate() {
            place[node] = index;
        }
        Self { nodes, place, reference: simulation.scene().nodes.current.clone() }
    }
}

impl YGeoOutput {
    /// Files of a run, in the folder of its results.
    #[must_use]
    pub fn new(names: &OutputNames) -> Self {
        let prefix = names.prefix();
        Self {
            events: EventFiles::new(&prefix),
            restarts: RestartFragments::new(&prefix),
            prefix,
            setup: None,
            written: Vec::new(),
        }
    }

    fn write_frames(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let Some(setup) = &self.setup else { return Ok(()) };
        for kind in ResultFile::ALL {
            let path = kind.path(&self.prefix, simulation.step_index());
            save(&path, |file| frames::write(file, kind, simulation, setup))?;
            self.written.push(path);
        }
        self.events.write_totals(simulation)
    }
}

/// Writes a file that appears when it is complete.
fn save(
    path: &Path,
    write: impl FnOnce(&mut BufWriter<PartFile>) -> io::Result<()>,
) -> Result<(), OutputError> {
    let save = || {
        let mut file = BufWriter::new(PartFile::create(path)?);
        write(&mut file)?;
        file.flush()?;
        file.into_inner().map_err(io::IntoInnerError::into_error)?.complete()
    };
    save().map(drop).map_err(OutputError::io(path))
}

impl ResultWriter for YGeoOutput {
    fn begin_stage(&mut self, deck: &Deck, values: &Database) -> Result<(), OutputError> {
        self.restarts.begin_stage(deck, values);
        Ok(())
    }

    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        self.setup.get_or_insert_with(|| Setup::new(simulation));
        Ok(())
    }

    fn after_motion(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if simulation.is_output_step() {
            self.write_frames(simulation)?;
        }
        self.events.write_events(simulation)?;
        self.restarts.write(simulation)
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        let mut written = self.written;
        written.extend(self.events.finish()?);
        written.extend(self.restarts.finish());
        Ok(written)
    }
}
