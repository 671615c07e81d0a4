//! Fragments of a deck with the state of the nodes, to be pasted into a deck that goes on.

use std::io::{self, Write};

/// The contents of `PREFIXres<k>`: coordinates and velocities of the nodes of the deck, six
/// decimals only (outputs.md, 5.7).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RestartFragment<'a> {
    /// The step.
    pub step: u64,
    /// Its time.
    pub time: f64,
    /// Coordinates of the deck's nodes. After joints were put in, Y-Geo gives for each the
    /// detached node of the last triangle that uses it.
    pub coordinates: &'a [[f64; 2]],
    /// Velocities of the same nodes.
    pub velocities: &'a [[f64; 2]],
}

impl RestartFragment<'_> {
    /// Writes the fragment. The count of each table is the length of its slice.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        out.write_all(b"/* Current restart data stored for \n")?;
        writeln!(out, "Time Step: {} @ Time: {:.6} */ \n", self.step, self.time)?;
        table(out, "D2NCC", self.coordinates)?;
        out.write_all(b"\n")?;
        table(out, "D2NVC", self.velocities)
    }
}

fn table(out: &mut impl Write, keyword: &str, rows: &[[f64; 2]]) -> io::Result<()> {
    writeln!(out, "/YD/YDN/{keyword} 21 2 {} ", rows.len())?;
    for [x, y] in rows {
        writeln!(out, "{x:.6} \t {y:.6} ")?;
    }
    Ok(())
}
