//! The run table and the run's log `Ytmp` (spec `y2d3d.md` A.1, G.4).

use super::{FilePosition, OutputError};
use std::{
    fs::File,
    io::{self, Seek as _, SeekFrom, Write as _},
    path::{Path, PathBuf},
};
use yformat::{c_format::Exponential, checksum::Checksum, part_file::Mark};

/// Heading of the run table.
pub const TABLE_HEADER: &str = "  Ncycle      Physi. time         Date and Time   Elapsed time";

/// A row of the run table: step, physical time, date, processor seconds.
#[must_use]
pub fn table_row(step: u64, time: f64, date: &str, seconds: f64) -> String {
    let time = Exponential::new(7).width(15).format(time);
    format!("{step:8}  {time}   {date}{seconds:15.3}")
}

/// The run's log: the deck's keywords as they were read, warnings, and the run
/// table. It is written line by line, so that it tells where a run stands.
pub struct RunTable {
    path: PathBuf,
    file: File,
    length: u64,
    checksum: Checksum,
}

impl RunTable {
    /// Starts the log anew.
    ///
    /// # Errors
    /// If the file cannot be created.
    pub fn create(path: &Path) -> Result<Self, OutputError> {
        let file = File::create(path).map_err(OutputError::io(path))?;
        Ok(Self { path: path.to_path_buf(), file, length: 0, checksum: Checksum::new() })
    }

    /// Goes on with the log of an earlier run from `position`; what was written after it is cut
    /// off. Begins a new one if the log is not that of the run any more: all runs in a folder
    /// call theirs alike.
    ///
    /// # Errors
    /// If the file can be neither changed nor created.
    pub fn resume(path: &Path, position: FilePosition) -> Result<Self, OutputError> {
        let mark = Mark::from(position);
        let earlier = std::fs::read(path).unwrap_or_default();
        let kept = usize::try_from(mark.length).ok().and_then(|length| earlier.get(..length));
        let Some(kept) = kept.filter(|kept| Checksum::of(kept) == mark.checksum) else {
            return Self::create(path);
        };
        let resume = || {
            let mut file = File::options().write(true).open(path)?;
            file.set_len(mark.length)?;
            file.seek(SeekFrom::End(0))?;
            io::Result::Ok(file)
        };
        let file = resume().map_err(OutputError::io(path))?;
        let mut checksum = Checksum::new();
        checksum.add(kept);
        Ok(Self { path: path.to_path_buf(), file, length: mark.length, checksum })
    }

    /// How far the log has been written.
    #[must_use]
    pub fn position(&self) -> FilePosition {
        Mark { length: self.length, checksum: self.checksum.value() }.into()
    }

    /// Writes one line.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn line(&mut self, text: &str) -> Result<(), OutputError> {
        let line = format!("{text}\n");
        self.file.write_all(line.as_bytes()).map_err(OutputError::io(&self.path))?;
        self.length += line.len() as u64;
        self.checksum.add(line.as_bytes());
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rows_look_like_the_original_ones() {
        assert_eq!(
            table_row(0, 0.0, "01/01/2000 00:00:00", 0.0),
            "       0    0.0000000e+00   01/01/2000 00:00:00          0.000"
        );
        assert_eq!(TABLE_HEADER.len(), 8 + 17 + 22 + 15);
    }
}
