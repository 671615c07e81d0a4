//! Tables that grow during a run and that a later run can go on with.

use super::{FilePosition, OutputError, mark::mark_of};
use std::{
    io::{self, BufWriter, Write as _},
    path::PathBuf,
};
use yformat::part_file::PartFile;

/// A table of which lines are written, under its name once it is complete.
pub(super) struct TableFile {
    path: PathBuf,
    file: BufWriter<PartFile>,
}

impl TableFile {
    /// Starts a table.
    pub fn create(path: PathBuf) -> Result<Self, OutputError> {
        let part = PartFile::create(&path).map_err(OutputError::io(&path))?;
        Ok(Self { path, file: BufWriter::new(part) })
    }

    /// Starts a table with its heading.
    pub fn with_heading(path: PathBuf, heading: &str) -> Result<Self, OutputError> {
        let mut table = Self::create(path)?;
        table.line(heading)?;
        Ok(table)
    }

    /// Goes on with a table of an earlier run.
    pub fn resume(path: PathBuf, position: FilePosition) -> Result<Self, OutputError> {
        let part =
            PartFile::resume(&path, &position.into()).map_err(OutputError::changed(&path))?;
        Ok(Self { path, file: BufWriter::new(part) })
    }

    /// Writes one line.
    pub fn line(&mut self, line: &str) -> Result<(), OutputError> {
        self.write(|file| writeln!(file, "{line}"))
    }

    /// Writes whatever `write` does.
    pub fn write(
        &mut self,
        write: impl FnOnce(&mut BufWriter<PartFile>) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        write(&mut self.file).map_err(OutputError::io(&self.path))
    }

    /// How far the table has been written, all of it on the disk.
    pub fn mark(&mut self) -> Result<FilePosition, OutputError> {
        mark_of(&mut self.file).map_err(OutputError::io(&self.path))
    }

    /// Completes the table.
    pub fn finish(self) -> Result<PathBuf, OutputError> {
        let Self { path, file } = self;
        let part = file.into_inner().map_err(|e| OutputError::io(&path)(e.into_error()))?;
        part.complete().map_err(OutputError::io(path))
    }
}
