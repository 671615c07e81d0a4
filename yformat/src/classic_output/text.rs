//! The number formats of the original, and how its decks spell lists and matrices.

use std::io::{self, Write};

use crate::c_format::Exponential;

/// `%+10.3e`: log files.
pub(super) const E10: Exponential = Exponential::new(3).width(10).plus();
/// `%+18.11e`: parameters.
pub(super) const E18: Exponential = Exponential::new(11).width(18).plus();
/// `%+28.20e`: states, exact.
pub(super) const E28: Exponential = Exponential::new(20).width(28).plus();

/// A value with the format that it is printed in.
pub(super) trait Format<T> {
    /// Prints the value.
    fn put(&self, out: &mut dyn Write, value: T) -> io::Result<()>;
}

impl Format<f64> for Exponential {
    fn put(&self, out: &mut dyn Write, value: f64) -> io::Result<()> {
        write!(out, "{}", self.format(value))
    }
}

/// `%wd`.
#[derive(Debug, Clone, Copy)]
pub(super) struct Width(pub(super) usize);

impl Format<i64> for Width {
    fn put(&self, out: &mut dyn Write, value: i64) -> io::Result<()> {
        write!(out, "{value:width$}", width = self.0)
    }
}

/// Writes the items of a deck as the original does.
pub(super) struct DeckText<W> {
    pub(super) out: W,
}

impl<W: Write> DeckText<W> {
    /// The heading of a section.
    pub(super) fn section(&mut self, comment: &str) -> io::Result<()> {
        writeln!(self.out, "     /*   {comment}*/")
    }

    /// One value.
    pub(super) fn scalar<T>(
        &mut self,
        keyword: &str,
        format: impl Format<T>,
        value: T,
    ) -> io::Result<()> {
        write!(self.out, "/YD/{keyword} ")?;
        format.put(&mut self.out, value)?;
        writeln!(self.out)
    }

    /// The first line of a list.
    pub(super) fn count(&mut self, keyword: &str, count: usize) -> io::Result<()> {
        writeln!(self.out, "/YD/{keyword} {count:5}")
    }

    /// The line of values of a list.
    pub(super) fn values<T>(
        &mut self,
        format: impl Format<T>,
        values: impl IntoIterator<Item = T>,
    ) -> io::Result<()> {
        for value in values {
            format.put(&mut self.out, value)?;
            self.out.write_all(b" ")?;
        }
        writeln!(self.out)
    }

    /// A list with its number of values.
    pub(super) fn list<T>(
        &mut self,
        keyword: &str,
        format: impl Format<T>,
        values: impl ExactSizeIterator<Item = T>,
    ) -> io::Result<()> {
        self.count(keyword, values.len())?;
        self.values(format, values)
    }

    /// The first line of a matrix.
    pub(super) fn matrix_header(&mut self, keyword: &str, n1: usize, n2: usize) -> io::Result<()> {
        writeln!(self.out, "/YD/{keyword} {:5} {n1:5} {n2:5}", 21)
    }

    /// A matrix, one row a line, and the empty line behind it.
    pub(super) fn matrix<'a, T: Copy + 'a>(
        &mut self,
        keyword: &str,
        format: impl Format<T> + Copy,
        columns: usize,
        rows: impl Iterator<Item = &'a [T]>,
        count: usize,
    ) -> io::Result<()> {
        self.matrix_header(keyword, columns, count)?;
        for row in rows {
            self.values(format, row.iter().copied())?;
        }
        writeln!(self.out)
    }
}
