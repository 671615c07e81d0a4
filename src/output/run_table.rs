//! The run table and the run's log `Ytmp` (spec `y2d3d.md` A.1, G.4).

use super::OutputError;
use std::{
    fs::File,
    io::Write,
    path::{Path, PathBuf},
};
use yformat::c_format::Exponential;

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
}

impl RunTable {
    /// Starts the log anew.
    ///
    /// # Errors
    /// If the file cannot be created.
    pub fn create(path: &Path) -> Result<Self, OutputError> {
        let file = File::create(path).map_err(OutputError::io(path))?;
        Ok(Self { path: path.to_path_buf(), file })
    }

    /// Writes one line.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn line(&mut self, text: &str) -> Result<(), OutputError> {
        writeln!(self.file, "{text}").map_err(OutputError::io(&self.path))
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
