//! Tables: columns of numbers with names and units.

use std::io::{BufWriter, Write};
use std::path::Path;

use yformat::history::History;
use yformat::part_file::PartFile;

use crate::error::{PostError, at};

/// A table whose columns are called like `time (s)`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Table {
    /// Names of the columns, units in brackets behind them.
    pub headings: Vec<String>,
    /// Rows, each with one number per column; NaN where there is none.
    pub rows: Vec<Vec<f64>>,
}

impl Table {
    /// An empty table.
    #[must_use]
    pub fn new(headings: impl IntoIterator<Item = impl Into<String>>) -> Self {
        Self { headings: headings.into_iter().map(Into::into).collect(), rows: Vec::new() }
    }

    /// The numbers of a column.
    #[must_use]
    pub fn column(&self, index: usize) -> Vec<f64> {
        self.rows.iter().map(|row| row.get(index).copied().unwrap_or(f64::NAN)).collect()
    }

    /// The column with a name, unit and capitals left out, or with a number from 1.
    ///
    /// # Errors
    /// If there is none.
    pub fn find(&self, name: &str) -> Result<usize, PostError> {
        let plain = |heading: &str| {
            heading.split(" (").next().unwrap_or(heading).trim().to_ascii_lowercase()
        };
        let by_name = self.headings.iter().position(|heading| {
            heading == name || plain(heading) == name.trim().to_ascii_lowercase()
        });
        let by_number = || {
            let number = name.trim().parse::<usize>().ok()?.checked_sub(1)?;
            (number < self.headings.len()).then_some(number)
        };
        by_name.or_else(by_number).ok_or_else(|| {
            let columns = self.headings.iter().enumerate();
            let columns: Vec<String> = columns.map(|(i, h)| format!("{} {h}", i + 1)).collect();
            PostError::words("the column", name, format!("there are {}", columns.join(", ")))
        })
    }

    /// The table as CSV: one heading line, commas, decimal points; numbers as short as they can
    /// be read back exactly, `nan` where there is none.
    #[must_use]
    pub fn to_csv(&self) -> String {
        let headings = self.headings.iter().map(|heading| quoted(heading));
        let mut text = headings.collect::<Vec<_>>().join(",");
        text.push('\n');
        for row in &self.rows {
            text.push_str(&row.iter().map(|&v| number(v)).collect::<Vec<_>>().join(","));
            text.push('\n');
        }
        text
    }

    /// Writes the table as CSV; the file takes its name when it is complete.
    ///
    /// # Errors
    /// If it cannot be written.
    pub fn write(&self, path: &Path) -> Result<(), PostError> {
        let write = || {
            let mut file = BufWriter::new(PartFile::create(path)?);
            file.write_all(self.to_csv().as_bytes())?;
            file.into_inner().map_err(std::io::IntoInnerError::into_error)?.complete()
        };
        write().map(drop).map_err(at(path))
    }

    /// Reads a CSV file with one heading line, or a `.yh` history.
    ///
    /// # Errors
    /// If the file is neither.
    pub fn read(path: &Path) -> Result<Self, PostError> {
        let text = std::fs::read(path).map_err(at(path))?;
        if let Ok(history) = History::parse(&text)
            && !history.points.is_empty()
        {
            let rows = history.points.iter().map(|p| vec![p.time, p.value]).collect();
            return Ok(Self { headings: vec!["time (s)".into(), "value".into()], rows });
        }
        let text = String::from_utf8_lossy(&text);
        Self::parse(&text)
            .map_err(|message| PostError::NoResults { path: path.to_path_buf(), message })
    }

    /// Reads CSV with one heading line. Lines that begin with `#` are left out.
    ///
    /// # Errors
    /// A message that names the line.
    pub fn parse(text: &str) -> Result<Self, String> {
        let mut lines = text
            .lines()
            .enumerate()
            .filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
        let (index, first) = lines.next().ok_or("the file is empty; expected a table")?;
        let cells_of = |index: usize, line: &str| {
            split(line).ok_or_else(|| format!("line {} ends within quotes", index + 1))
        };
        let mut table = Self::new(cells_of(index, first)?);
        if table.headings.iter().all(|heading| heading.trim().parse::<f64>().is_ok()) {
            return Err("line 1 holds numbers; expected the names of the columns".to_owned());
        }
        for (index, line) in lines {
            let cells = cells_of(index, line)?;
            if cells.len() != table.headings.len() {
                return Err(format!(
                    "line {} has {} cells; expected {}",
                    index + 1,
                    cells.len(),
                    table.headings.len()
                ));
            }
            let row = cells.iter().map(|cell| match cell.trim() {
                "" => Ok(f64::NAN),
                cell => cell.parse().map_err(|_| {
                    let short: String = cell.chars().take(40).collect();
                    format!("line {} holds `{short}`; expected a number", index + 1)
                }),
            });
            table.rows.push(row.collect::<Result<_, _>>()?);
        }
        Ok(table)
    }
}

/// A cell of CSV: in quotes where it has commas, quotes or line ends, and where a reader would take it
/// for none: an empty line is none of the table, and `#` begins a comment.
#[must_use]
pub fn quoted(cell: &str) -> String {
    if cell.contains([',', '"', '\n', '\r']) || cell.is_empty() || cell.starts_with('#') {
        format!("\"{}\"", cell.replace('"', "\"\""))
    } else {
        cell.to_owned()
    }
}

/// Shortest decimal number that reads back the same.
#[must_use]
pub fn number(value: f64) -> String {
    match value {
        0.0 => "0".to_owned(),
        v if v.is_nan() => "nan".to_owned(),
        v if (1e-4..1e7).contains(&v.abs()) => format!("{v}"),
        v => format!("{v:e}"),
    }
}

/// Cells of a line, quotes taken off; none if the line ends within quotes.
fn split(line: &str) -> Option<Vec<String>> {
    let (mut cells, mut cell, mut quoted) = (Vec::new(), String::new(), false);
    let mut letters = line.chars().peekable();
    while let Some(letter) = letters.next() {
        match letter {
            '"' if quoted && letters.peek() == Some(&'"') => {
                cell.push('"');
                letters.next();
            }
            '"' => quoted = !quoted,
            ',' if !quoted => cells.push(std::mem::take(&mut cell).trim().to_owned()),
            letter => cell.push(letter),
        }
    }
    cells.push(cell.trim().to_owned());
    (!quoted).then_some(cells)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_written_is_read_back() {
        let mut table = Table::new(["time (s)", "ux, \"left\" (m)"]);
        table.rows.push(vec![0.1, -1.25e-9]);
        table.rows.push(vec![1.0 / 3.0, 0.0]);
        assert_eq!(
            table.to_csv(),
            "time (s),\"ux, \"\"left\"\" (m)\"\n0.1,-1.25e-9\n0.3333333333333333,0\n"
        );
        assert_eq!(Table::parse(&table.to_csv()), Ok(table));
        for odd in ["", "# force", "\"", ",", "a \"b\""] {
            let mut table = Table::new([odd]);
            table.rows.push(vec![1.5]);
            assert_eq!(Table::parse(&table.to_csv()), Ok(table), "{odd}");
        }
    }

    #[test]
    fn columns_are_found_by_name_and_number() {
        let table = Table::new(["time (s)", "Force (N)"]);
        assert_eq!(table.find("force").ok(), Some(1));
        assert_eq!(table.find("1").ok(), Some(0));
        let fault = table.find("3").expect_err("a fault").to_string();
        assert!(fault.contains("1 time (s), 2 Force (N)"), "{fault}");
    }

    #[test]
    fn bad_tables_are_refused_with_the_line() {
        assert_eq!(Table::parse("a,b\n1\n"), Err("line 2 has 1 cells; expected 2".into()));
        assert_eq!(Table::parse("a\nx\n"), Err("line 2 holds `x`; expected a number".into()));
        assert_eq!(Table::parse("a\n\"1\n"), Err("line 2 ends within quotes".into()));
        assert!(Table::parse("1,2\n").is_err());
        assert!(Table::parse("").is_err());
    }
}
