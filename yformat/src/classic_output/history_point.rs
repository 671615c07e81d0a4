//! Lines of `.yh` histories.

use std::io::{self, Write};

use super::text::E10;

/// Writes the pair of lines of a point of `DECKh<k>`: time and quantity, each already in the units of
/// the history (times D1OHYC and D1OHYF), then the sums of the nodal contact forces over the nodes of
/// property set 1 (outputs.md 2). [`crate::history::History`] reads the file.
pub fn write_history_point(
    out: &mut impl Write,
    time: f64,
    value: f64,
    contact_force: [f64; 2],
) -> io::Result<()> {
    let [x, y] = contact_force;
    writeln!(out, "{} {}", E10.format(time), E10.format(value))?;
    writeln!(out, " {} {}", E10.format(x), E10.format(y))
}
