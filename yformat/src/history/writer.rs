//! Writes history lines.

use std::io::{self, Write};

use crate::c_format::{ExponentDigits, Exponential};

/// How lines end and exponents look.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum LineStyle {
    /// Line feed, exponents of at least two digits.
    #[default]
    Unix,
    /// Carriage return and line feed, exponents of at least three digits.
    Windows,
}

/// Writes the lines of one history, each with the C format `%+17.10e %+17.10e`.
#[derive(Debug)]
pub struct HistoryWriter<W> {
    output: W,
    number: Exponential,
    line_end: &'static str,
}

impl<W: Write> HistoryWriter<W> {
    /// A writer into `output`. Each line becomes one `write_all`.
    pub fn new(output: W, style: LineStyle) -> Self {
        let number = Exponential::new(10).width(17).plus();
        let (digits, line_end) = match style {
            LineStyle::Unix => (ExponentDigits::Two, "\n"),
            LineStyle::Windows => (ExponentDigits::Three, "\r\n"),
        };
        Self { output, number: number.exponent_digits(digits), line_end }
    }

    /// Writes one line.
    pub fn write(&mut self, time: f64, value: f64) -> io::Result<()> {
        let time = self.number.format(time);
        let value = self.number.format(value);
        let line = format!("{time} {value}{}", self.line_end);
        self.output.write_all(line.as_bytes())
    }

    /// Flushes the output.
    pub fn flush(&mut self) -> io::Result<()> {
        self.output.flush()
    }

    /// Gives the output back.
    pub fn into_inner(self) -> W {
        self.output
    }
}
