//! VTU files of a run and their PVD collection.

use super::{Background, OutputError, OutputNames, background::lock, decode, encode, present};
use serde::{Deserialize, Serialize};
use std::{
    path::PathBuf,
    sync::{Arc, Mutex},
};
use ypsilon_converters::vtk::{PvdSeries, UnstructuredGrid, write_vtu};

/// What `--formats` calls the files.
pub(super) const KIND: &str = "vtu";
/// What names of files of bodies have behind that of the deck.
pub(super) const BODIES: &str = "";
/// What those of joints have.
pub(super) const JOINTS: &str = "_joints";

/// A file of the series: its time, its part of the picture with number and name, its name.
#[derive(Clone, Serialize, Deserialize)]
struct Entry(f64, u32, String, String);

/// A file to be written.
struct Frame {
    path: PathBuf,
    entry: Entry,
    grid: UnstructuredGrid,
}

impl Entry {
    fn add_to(&self, series: &mut PvdSeries) {
        let Self(time, number, label, file) = self;
        series.push(*time, *number, label, file);
    }
}

/// Two blocks per output step, bodies and joints, and the PVD after each step.
pub(super) struct VtuSeries {
    names: OutputNames,
    background: Background,
    /// The files that are complete.
    series: Arc<Mutex<PvdSeries>>,
    /// What the series holds.
    entries: Vec<Entry>,
    files: Vec<PathBuf>,
}

impl VtuSeries {
    /// Files named by `names`.
    pub fn new(names: &OutputNames, background: &Background) -> Self {
        Self {
            names: names.clone(),
            background: background.clone(),
            series: Arc::default(),
            entries: Vec::new(),
            files: Vec::new(),
        }
    }

    /// What is to be written of a block.
    fn frame(
        &mut self,
        (part, number, label): (&str, u32, &str),
        (step, time): (u64, f64),
        grid: UnstructuredGrid,
    ) -> Frame {
        let path = self.names.vtu(part, step);
        let file = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let entry = Entry(time, number, label.to_owned(), file);
        self.entries.push(entry.clone());
        self.files.push(path.clone());
        Frame { path, entry, grid }
    }

    /// Writes the blocks of a step.
    pub fn write(
        &mut self,
        step: u64,
        time: f64,
        grids: Vec<(&str, UnstructuredGrid)>,
    ) -> Result<(), OutputError> {
        let block = |part| if part == JOINTS { (part, 1, "joints") } else { (part, 0, "bodies") };
        let frames: Vec<Frame> = grids
            .into_iter()
            .map(|(part, grid)| self.frame(block(part), (step, time), grid))
            .collect();
        let (series, pvd) = (Arc::clone(&self.series), self.names.pvd());
        self.background.submit(move || {
            let mut series = lock(&series);
            for Frame { path, entry, grid } in frames {
                write_vtu(&path, &grid)?;
                entry.add_to(&mut series);
            }
            Ok(series.write(&pvd)?)
        })
    }

    /// What a later run needs to go on with the series.
    pub fn mark(&self) -> Result<Vec<u8>, OutputError> {
        encode(KIND, &self.entries)
    }

    /// Goes on with the series of an earlier run.
    pub fn resume(&mut self, mark: &[u8], names: &OutputNames) -> Result<(), OutputError> {
        let mut series = lock(&self.series);
        for entry in decode::<Vec<Entry>>(KIND, mark)? {
            let mut path = present(names, std::slice::from_ref(&entry.3))?;
            self.files.append(&mut path);
            entry.add_to(&mut series);
            self.entries.push(entry);
        }
        if !self.entries.is_empty() {
            // the earlier run may have gone further
            series.write(&names.pvd())?;
        }
        Ok(())
    }

    /// All files.
    pub fn finish(self) -> Vec<PathBuf> {
        let mut files = self.files;
        if !files.is_empty() {
            files.push(self.names.pvd());
        }
        files
    }
}
