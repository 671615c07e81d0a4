//! The table of a study: one row for each case that is over.

use super::{
    cell::Cell,
    error::{SweepError, at},
    outputs::heading,
    record::{Record, State},
    study::Study,
};
use std::{
    io::Write,
    path::{Path, PathBuf},
};
use yformat::part_file::PartFile;
use ypsilon_post::table::quoted;

/// Headings and rows: number of the case, its values, status, outputs.
#[derive(Debug, Clone, PartialEq)]
pub struct StudyTable {
    /// Names of the columns, units in brackets behind them.
    pub headings: Vec<String>,
    /// One row for each case that is over.
    pub rows: Vec<Vec<Cell>>,
}

impl StudyTable {
    /// The table of the cases that have ended, in their order. Outputs of those that failed are NaN.
    #[must_use]
    pub fn of(study: &Study, records: &[Option<Record>]) -> Self {
        let mut headings = vec!["case".to_owned()];
        let named = |p: &super::Parameter| heading(&p.name, p.unit.as_deref().unwrap_or_default());
        headings.extend(study.parameters.iter().map(named));
        headings.push("status".to_owned());
        headings.extend(study.outputs.iter().map(super::Output::heading));
        let mut rows = Vec::new();
        for (case, record) in study.cases.iter().zip(records) {
            let Some(record) = record.as_ref().filter(|r| r.state == State::Ended) else {
                continue;
            };
            let mut row = vec![Cell::Whole(case.number as i64)];
            row.extend(case.values.iter().cloned());
            row.push(Cell::Whole(record.status.into()));
            for index in 0..study.outputs.len() {
                let word = record.outputs.get(index).filter(|_| record.status == 0);
                let value = word.and_then(|word| word.parse().ok());
                row.push(Cell::Number(value.unwrap_or(f64::NAN)));
            }
            rows.push(row);
        }
        Self { headings, rows }
    }

    /// The table as CSV: commas, decimal points, `nan` where there is no number.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let line = |cells: Vec<String>| {
            let cells: Vec<String> = cells.iter().map(|cell| quoted(cell)).collect();
            cells.join(",") + "\n"
        };
        let mut text = line(self.headings.clone());
        for row in &self.rows {
            text.push_str(&line(row.iter().map(Cell::to_string).collect()));
        }
        text
    }

    /// Writes `results.csv`, and `results.parquet` if it is asked for, into a folder.
    ///
    /// # Errors
    /// If a file cannot be written.
    pub fn write(&self, folder: &Path, parquet: bool) -> Result<Vec<PathBuf>, SweepError> {
        let path = folder.join("results.csv");
        let write = || {
            let mut file = PartFile::create(&path)?;
            file.write_all(self.to_csv().as_bytes())?;
            file.complete()
        };
        let mut written = vec![write().map_err(at(&path))?];
        if parquet {
            written.push(self.write_parquet(&folder.join("results.parquet"))?);
        }
        Ok(written)
    }

    #[cfg(not(feature = "parquet"))]
    fn write_parquet(&self, _path: &Path) -> Result<PathBuf, SweepError> {
        Err(SweepError::Unsupported(NO_PARQUET))
    }

    #[cfg(feature = "parquet")]
    fn write_parquet(&self, path: &Path) -> Result<PathBuf, SweepError> {
        use ypsilon_post::parquet::{Column, write};
        let column = |index: usize| {
            let cells = || self.rows.iter().filter_map(move |row| row.get(index));
            if index == 0 || cells().all(|cell| matches!(cell, Cell::Whole(_))) {
                let whole = |cell: &Cell| if let Cell::Whole(whole) = cell { *whole } else { 0 };
                Column::Integers(cells().map(whole).collect())
            } else if cells().any(|cell| matches!(cell, Cell::Word(_))) {
                Column::Words(cells().map(Cell::to_string).collect())
            } else {
                Column::Numbers(cells().map(|cell| cell.value().unwrap_or(f64::NAN)).collect())
            }
        };
        let columns: Vec<(String, Column)> =
            self.headings.iter().cloned().enumerate().map(|(i, h)| (h, column(i))).collect();
        write(path, &columns).map_err(at(path))?;
        Ok(path.to_path_buf())
    }
}

/// What is said where Parquet was left out.
#[cfg(not(feature = "parquet"))]
const NO_PARQUET: &str = "this program was built without Parquet: build it with `cargo build \
                          --release --features parquet`, or read results.csv, which has the same";

/// Whether tables can be written as Parquet.
///
/// # Errors
/// A sentence, if the program was built without it.
pub fn parquet_is_there() -> Result<(), SweepError> {
    #[cfg(feature = "parquet")]
    return Ok(());
    #[cfg(not(feature = "parquet"))]
    Err(SweepError::Unsupported(NO_PARQUET))
}
