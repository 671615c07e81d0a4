//! Result files as Y-Geo writes them: families of VTK files at output steps and
//! text files of events (spec `outputs.md` 5).

mod events;
mod frames;
mod restart;

use super::{
    Background, OutputError, OutputNames, ResultWriter, decode, encode, file_names, present, save,
};
use crate::{mechanics::Vec2, simulation::Simulation};
use events::{EventFiles, EventMark};
use restart::{RestartFragments, RestartMark};
use std::path::PathBuf;
use yformat::{database::Database, deck::Deck, ygeo_output::ResultFile};

/// Writes all files of Y-Geo but the histories.
pub struct YGeoOutput {
    prefix: PathBuf,
    background: Background,
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
        Self::of(nodes, simulation.scene().nodes.current.clone())
    }

    fn of(nodes: Vec<usize>, reference: Vec<Vec2>) -> Self {
        let mut place = vec![usize::MAX; reference.len()];
        for (index, &node) in nodes.iter().enumerate() {
            place[node] = index;
        }
        Self { nodes, place, reference }
    }
}

/// Nodes shown and their reference, events, restarts, names of the files written.
type VtpMark = (Option<(Vec<usize>, Vec<Vec2>)>, EventMark, RestartMark, Vec<String>);

impl YGeoOutput {
    /// Files of a run, in the folder of its results.
    #[must_use]
    pub fn new(names: &OutputNames, background: &Background) -> Self {
        let prefix = names.prefix();
        Self {
            events: EventFiles::new(&prefix),
            restarts: RestartFragments::new(&prefix, background),
            prefix,
            background: background.clone(),
            setup: None,
            written: Vec::new(),
        }
    }

    fn write_frames(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let Some(setup) = &self.setup else { return Ok(()) };
        for kind in ResultFile::ALL {
            let path = kind.path(&self.prefix, simulation.step_index());
            save(&self.background, &path, |file| frames::write(file, kind, simulation, setup))?;
            self.written.push(path);
        }
        self.events.write_totals(simulation)
    }
}

impl ResultWriter for YGeoOutput {
    fn begin_stage(&mut self, deck: &Deck, values: &Database) -> Result<(), OutputError> {
        self.restarts.begin_stage(deck, values);
        Ok(())
    }

    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        match &mut self.setup {
            None => self.setup = Some(Setup::new(simulation)),
            // a later stage may mesh
            Some(setup) if setup.place.len() != simulation.masses().len() => {
                let mut anew = Setup::new(simulation);
                let known = setup.reference.len().min(anew.reference.len());
                anew.reference[..known].copy_from_slice(&setup.reference[..known]);
                *setup = anew;
            }
            Some(_) => {}
        }
        Ok(())
    }

    fn after_motion(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if simulation.is_output_step() {
            self.write_frames(simulation)?;
        }
        self.events.write_events(simulation)?;
        self.restarts.write(simulation)
    }

    fn kind(&self) -> &'static str {
        "vtp"
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        let kind = self.kind();
        let setup = self.setup.as_ref().map(|s| (s.nodes.clone(), s.reference.clone()));
        let (events, restarts) = (self.events.mark()?, self.restarts.mark(kind)?);
        encode(kind, &(setup, events, restarts, file_names(kind, &self.written)?))
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        simulation: &Simulation,
    ) -> Result<(), OutputError> {
        let kind = self.kind();
        let (setup, events, restarts, written) = decode::<VtpMark>(kind, mark)?;
        let nodes = simulation.scene().nodes.len();
        if let Some((shown, reference)) = &setup
            && (reference.len() != nodes || shown.iter().any(|&n| n >= reference.len()))
        {
            return Err(OutputError::Mark { kind });
        }
        self.setup = setup.map(|(shown, reference)| Setup::of(shown, reference));
        self.events.resume(events)?;
        self.restarts.resume(kind, restarts, names, simulation)?;
        self.written = present(names, &written)?;
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        let mut written = self.written;
        written.extend(self.events.finish()?);
        written.extend(self.restarts.finish());
        Ok(written)
    }
}
