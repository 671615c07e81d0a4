//! Writes a snapshot record by record.

use std::io::{self, Write};

use super::{CodedRecord, Digits, HEADING, Record, Scales};

/// Writes the lines of one snapshot, each as one `write_all`: give it a buffered output.
#[derive(Debug)]
pub struct SnapshotWriter<W> {
    output: W,
    digits: Digits,
    scales: Scales,
    line: Vec<u8>,
}

impl<W: Write> SnapshotWriter<W> {
    /// Writes the heading. `digits` is `ICOUTP` of the deck.
    ///
    /// # Errors
    /// If `output` cannot be written to.
    pub fn new(mut output: W, digits: Digits, scales: Scales) -> io::Result<Self> {
        output.write_all(HEADING)?;
        output.write_all(b"\n")?;
        Ok(Self { output, digits, scales, line: Vec::new() })
    }

    /// Writes one line.
    ///
    /// # Errors
    /// If the output cannot be written to.
    pub fn write(&mut self, record: &Record) -> io::Result<()> {
        self.line.clear();
        CodedRecord::encode(record, self.digits, &self.scales).push_line(&mut self.line);
        self.line.push(b'\n');
        self.output.write_all(&self.line)
    }

    /// Gives the output back.
    pub fn into_inner(self) -> W {
        self.output
    }
}
