//! Fragments of decks to start from the present state again: coordinates and
//! velocities of the deck's own nodes (spec `outputs.md` 5.7).

use super::{
    super::{Background, OutputError, OutputNames, file_names, present},
    save,
};
use crate::{mechanics::Vec2, simulation::Simulation};
use serde::{Deserialize, Serialize};
use std::path::{Path, PathBuf};
use yformat::{
    database::Database,
    deck::Deck,
    ygeo_output::{RestartFragment, TextFile},
};

/// Writes fragments every so many steps and at the last one.
pub(super) struct RestartFragments {
    prefix: PathBuf,
    background: Background,
    /// Steps from one to the next; 0 for none.
    interval: u64,
    /// Triangles of the deck by their nodes.
    topology: Vec<[usize; 3]>,
    nodes: usize,
    written: Vec<PathBuf>,
}

/// What a later run needs to go on with the fragments.
#[derive(Serialize, Deserialize)]
pub(super) struct RestartMark {
    topology: Vec<[usize; 3]>,
    nodes: usize,
    written: Vec<String>,
}

impl RestartFragments {
    pub fn new(prefix: &Path, background: &Background) -> Self {
        let (topology, written) = (Vec::new(), Vec::new());
        let (prefix, background) = (prefix.to_path_buf(), background.clone());
        Self { prefix, background, interval: 0, topology, nodes: 0, written }
    }

    pub fn begin_stage(&mut self, _deck: &Deck, values: &Database) {
        let count = |name| usize::try_from(values.integer(name)).unwrap_or(0);
        self.interval = count("YDC/ICRESF") as u64;
        if !self.topology.is_empty() {
            return;
        }
        self.nodes = count("YDN/NNOPO");
        let Some(field) = values.integers("YDE/I2ELTO") else { return };
        let node = |e: usize, i: usize| usize::try_from(field.get2(i, e)).unwrap_or(usize::MAX);
        self.topology = (0..count("YDE/NELEM")).map(|e| [0, 1, 2].map(|i| node(e, i))).collect();
    }

    pub fn write(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let (step, end) = (simulation.step_index(), simulation.scene().control.end_step);
        if self.interval == 0 || !(step.is_multiple_of(self.interval) || step + 1 == end) {
            return Ok(());
        }
        let represented = self.represent(simulation);
        let of = |values: &[Vec2]| -> Vec<[f64; 2]> {
            represented.iter().map(|&n| values[n].into()).collect()
        };
        let nodes = &simulation.scene().nodes;
        let (coordinates, velocities) = (of(&nodes.current), of(&nodes.velocity));
        let fragment = RestartFragment {
            step,
            time: simulation.time(),
            coordinates: &coordinates,
            velocities: &velocities,
        };
        let path = TextFile::Restart(self.written.len() as u64).path(&self.prefix);
        save(&self.background, &path, |file| fragment.write(file))?;
        self.written.push(path);
        Ok(())
    }

    /// For each node of the deck the node that the last triangle with it has now.
    fn represent(&self, simulation: &Simulation) -> Vec<usize> {
        let mut represented: Vec<usize> = (0..self.nodes).collect();
        let elements = &simulation.scene().elements;
        for (e, own) in self.topology.iter().enumerate() {
            for (node, now) in own.iter().zip(elements.corners::<3>(e)) {
                if let Some(slot) = represented.get_mut(*node) {
                    *slot = now;
                }
            }
        }
        represented
    }

    pub fn mark(&self, kind: &'static str) -> Result<RestartMark, OutputError> {
        Ok(RestartMark {
            topology: self.topology.clone(),
            nodes: self.nodes,
            written: file_names(kind, &self.written)?,
        })
    }

    pub fn resume(
        &mut self,
        kind: &'static str,
        mark: RestartMark,
        names: &OutputNames,
        simulation: &Simulation,
    ) -> Result<(), OutputError> {
        let scene = simulation.scene();
        if mark.topology.len() > scene.elements.len() || mark.nodes > scene.nodes.len() {
            return Err(OutputError::Mark { kind });
        }
        (self.topology, self.nodes) = (mark.topology, mark.nodes);
        self.written = present(names, &mark.written)?;
        Ok(())
    }

    pub fn finish(self) -> Vec<PathBuf> {
        self.written
    }
}
