//! Text files of joints that yield and break, and of their totals.

use super::{
    super::{FilePosition, OutputError, mark::mark_of},
    frames::{corners, yield_mode},
};
use crate::{scene::JointKind, simulation::Simulation};
use serde::{Deserialize, Serialize};
use std::{
    io::{self, BufWriter},
    path::{Path, PathBuf},
};
use yformat::{
    part_file::PartFile,
    ygeo_output::{BreakageRecord, FractureTotals, JointGap, TextFile, YieldRecord},
};

/// A text file that is made when its first line comes.
struct Lines {
    path: PathBuf,
    file: Option<BufWriter<PartFile>>,
}

impl Lines {
    fn new(path: PathBuf) -> Self {
        Self { path, file: None }
    }

    fn write(
        &mut self,
        write: impl FnOnce(&mut BufWriter<PartFile>) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        let open = || -> io::Result<_> { Ok(BufWriter::new(PartFile::create(&self.path)?)) };
        let lines = match self.file.take() {
            Some(file) => Ok(file),
            None => open(),
        };
        let done = lines.and_then(|mut file| {
            write(&mut file)?;
            self.file = Some(file);
            Ok(())
        });
        done.map_err(OutputError::io(&self.path))
    }

    fn mark(&mut self) -> Result<Option<FilePosition>, OutputError> {
        let position = self.file.as_mut().map(mark_of).transpose();
        position.map_err(OutputError::io(&self.path))
    }

    fn resume(&mut self, position: Option<FilePosition>) -> Result<(), OutputError> {
        let open = |position: FilePosition| PartFile::resume(&self.path, &position.into());
        let part = position.map(open).transpose().map_err(OutputError::changed(&self.path))?;
        self.file = part.map(BufWriter::new);
        Ok(())
    }

    fn finish(self) -> Result<Option<PathBuf>, OutputError> {
        let Some(file) = self.file else { return Ok(None) };
        let part = file.into_inner().map_err(|e| OutputError::io(&self.path)(e.into_error()))?;
        part.complete().map(Some).map_err(OutputError::io(self.path))
    }
}

/// The text files of events.
pub(super) struct EventFiles {
    breakage: Lines,
    yielding: Lines,
    totals: Lines,
    /// Failures written so far.
    failures: usize,
}

/// What a later run needs to go on with the files.
#[derive(Serialize, Deserialize)]
pub(super) struct EventMark {
    positions: [Option<FilePosition>; 3],
    failures: u64,
}

impl EventFiles {
    pub fn mark(&mut self) -> Result<EventMark, OutputError> {
        let positions = [self.breakage.mark()?, self.yielding.mark()?, self.totals.mark()?];
        Ok(EventMark { positions, failures: self.failures as u64 })
    }

    pub fn resume(&mut self, mark: EventMark) -> Result<(), OutputError> {
        let [breakage, yielding, totals] = mark.positions;
        self.breakage.resume(breakage)?;
        self.yielding.resume(yielding)?;
        self.totals.resume(totals)?;
        self.failures = usize::try_from(mark.failures).unwrap_or(usize::MAX);
        Ok(())
    }

    pub fn new(prefix: &Path) -> Self {
        let lines = |file: TextFile| Lines::new(file.path(prefix));
        Self {
            breakage: lines(TextFile::Breakage),
            yielding: lines(TextFile::Yielding),
            totals: lines(TextFile::FractureTotals),
            failures: 0,
        }
    }

    /// Joints that broke or began to yield in this step, the latest first.
    pub fn write_events(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let all = simulation.failures();
        for failure in all[self.failures.min(all.len())..].iter().rev() {
            let element = failure.element;
            let [a, b, ..] = corners(simulation, element);
            let record = simulation.joint_record(element).copied().unwrap_or_default();
            let fracture = simulation.scene().elements.fracture[element];
            let line = BreakageRecord {
                element,
                failure_mode: failure.mode,
                time: failure.time,
                centroid: failure.place.into(),
                edge: [a, b],
                fracture_energy: record.fracture_energy,
                length: failure.length,
                kinetic_energy_change: record.release.largest,
                peak_time: record.release.time,
                fracture_network: simulation
                    .scene()
                    .fracture_network
                    .as_ref()
                    .map(|_| i64::from(fracture >= 0)),
            };
            self.breakage.write(|file| line.write(file))?;
        }
        self.failures = all.len();
        for &element in simulation.yielded_now().iter().rev() {
            let Some(record) = simulation.joint_record(element) else { continue };
            let Some(mode) = yield_mode(record.yielding.mode) else { continue };
            let [a, b, ..] = corners(simulation, element);
            let line = YieldRecord {
                element,
                mode,
                time: record.yielding.time,
                centroid: record.yielding.place,
                edge: [a, b],
            };
            self.yielding.write(|file| line.write(file))?;
        }
        Ok(())
    }

    /// Open area and length of all broken joints.
    pub fn write_totals(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let elements = &simulation.scene().elements;
        let (mut open_area, mut length) = (0.0, 0.0);
        for e in (0..elements.len()).filter(|&e| elements.joint_kind[e] == JointKind::Broken) {
            let corners = corners(simulation, e);
            open_area += f64::from(JointGap::between(corners).area);
            let [a, b] = [corners[0], corners[1]].map(|p| p.map(|x| x as f32));
            let (dx, dy) = (a[0] - b[0], a[1] - b[1]);
            length += f64::from((dx * dx + dy * dy).sqrt());
        }
        let totals = FractureTotals { step: simulation.step_index(), open_area, length };
        self.totals.write(|file| totals.write(file))
    }

    pub fn finish(self) -> Result<Vec<PathBuf>, OutputError> {
        let files = [self.breakage, self.yielding, self.totals].map(Lines::finish);
        let mut written = Vec::new();
        for file in files {
            written.extend(file?);
        }
        Ok(written)
    }
}
