//! `.yh` histories to CSV.

use std::collections::BTreeMap;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use yformat::history::History;

use crate::error::{ConvertError, at};
use crate::replace_file::replace_file;

/// What a conversion wrote.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct HistoryReport {
    /// Rows below the heading.
    pub rows: usize,
    /// Histories whose last line has no line end and may be cut short.
    pub unterminated: Vec<PathBuf>,
}

/// One history and the heading of its column.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Heading.
    pub heading: String,
    /// Its points.
    pub history: History,
}

/// Converts histories to one CSV table: the time, then one column per history, headed by its
/// file name.
pub fn histories_to_csv(inputs: &[&Path], output: &Path) -> Result<HistoryReport, ConvertError> {
    let mut columns = Vec::with_capacity(inputs.len());
    let mut unterminated = Vec::new();
    for &input in inputs {
        let text = std::fs::read(input).map_err(at(input))?;
        let history = History::parse(&text)
            .map_err(|source| ConvertError::History { path: input.to_path_buf(), source })?;
        if history.unterminated {
            unterminated.push(input.to_path_buf());
        }
        let name = input.file_name().unwrap_or(input.as_os_str());
        columns.push(Column { heading: name.to_string_lossy().into_owned(), history });
    }
    let mut rows = 0;
    replace_file(output, |file| {
        rows = write_csv(file, &columns)?;
        Ok(())
    })
    .map_err(at(output))?;
    Ok(HistoryReport { rows, unterminated })
}

/// Writes the table and tells how many rows it has.
///
/// Histories of the same times share rows in the order of the file. Otherwise there is one row
/// per time, ascending; a cell is empty where a history has no such time, and the last of
/// several values of the same time counts. Numbers are as short as exactness allows.
pub fn write_csv(mut output: impl Write, columns: &[Column]) -> io::Result<usize> {
    write!(output, "time")?;
    for column in columns {
        write!(output, ",{}", quoted(&column.heading))?;
    }
    if let [only] = columns
        && !only.history.contact_forces.is_empty()
    {
        return classic(output, &only.history);
    }
    writeln!(output)?;
    if same_times(columns) {
        let rows = columns.first().map_or(0, |c| c.history.points.len());
        for row in 0..rows {
            let mut points = columns.iter().filter_map(|c| c.history.points.get(row));
            if let Some(first) = points.next() {
                write!(output, "{:?},{:?}", first.time, first.value)?;
            }
            for point in points {
                write!(output, ",{:?}", point.value)?;
            }
            writeln!(output)?;
        }
        return Ok(rows);
    }
    let mut rows: BTreeMap<SortedTime, Vec<Option<f64>>> = BTreeMap::new();
    for (index, column) in columns.iter().enumerate() {
        for point in &column.history.points {
            let row =
                rows.entry(SortedTime(point.time)).or_insert_with(|| vec![None; columns.len()]);
            if let Some(cell) = row.get_mut(index) {
                *cell = Some(point.value);
            }
        }
    }
    for (SortedTime(time), row) in &rows {
        write!(output, "{time:?}")?;
        for cell in row {
            match cell {
                Some(value) => write!(output, ",{value:?}")?,
                None => write!(output, ",")?,
            }
        }
        writeln!(output)?;
    }
    Ok(rows.len())
}

/// The rest of the table of one history with contact forces.
fn classic(mut output: impl Write, history: &History) -> io::Result<usize> {
    writeln!(output, ",contact force x,contact force y")?;
    for (index, point) in history.points.iter().enumerate() {
        write!(output, "{:?},{:?}", point.time, point.value)?;
        match history.contact_forces.get(index) {
            Some([x, y]) => writeln!(output, ",{x:?},{y:?}")?,
            None => writeln!(output, ",,")?,
        }
    }
    Ok(history.points.len())
}

fn same_times(columns: &[Column]) -> bool {
    let bits = |column: &Column| -> Vec<u64> {
        let points = column.history.points.iter();
        points.map(|p| p.time.to_bits()).collect()
    };
    let Some((first, others)) = columns.split_first() else {
        return true;
    };
    let times = bits(first);
    others.iter().all(|other| bits(other) == times)
}

/// A heading, in quotes where CSV needs them.
fn quoted(heading: &str) -> String {
    if heading.contains([',', '"', '\n', '\r']) {
        format!("\"{}\"", heading.replace('"', "\"\""))
    } else {
        heading.to_owned()
    }
}

/// A time with a total order, so that also `nan` has its place.
#[derive(Debug, Clone, Copy)]
struct SortedTime(f64);

impl Ord for SortedTime {
    fn cmp(&self, other: &Self) -> std::cmp::Ordering {
        self.0.total_cmp(&other.0)
    }
}

impl PartialOrd for SortedTime {
    fn partial_cmp(&self, other: &Self) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl PartialEq for SortedTime {
    fn eq(&self, other: &Self) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for SortedTime {}
