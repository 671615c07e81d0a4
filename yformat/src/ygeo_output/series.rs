//! Text files with a line per time: histories, totals of the fractures, hydrofracture.

use std::io::{self, Write};

use crate::c_format::Exponential;

/// `%+10.3e`, in which all Y dialects print most numbers.
pub(super) const E10: Exponential = Exponential::new(3).width(10).plus();

/// Writes a line of `PREFIXh<k>`: time and quantity, each already in the units of the history
/// (times D1OHYC and D1OHYF; outputs.md, 5.7). [`crate::history::History`] reads the file.
pub fn write_history_point(out: &mut impl Write, time: f64, value: f64) -> io::Result<()> {
    writeln!(out, "{}\t{}", E10.format(time), E10.format(value))
}

/// A line of `PREFIXhFRAC`: the fractures at an output step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FractureTotals {
    /// The output step.
    pub step: u64,
    /// Sum of the areas of the gaps ([`super::JointGap::area`]).
    pub open_area: f64,
    /// Sum of the present lengths of edge 0-1 of the broken joints.
    pub length: f64,
}

impl FractureTotals {
    /// Writes the line.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        // Y-Geo's sums begin with a positive zero; in Rust the sum of nothing is a negative one.
        let (area, length) = (self.open_area + 0.0, self.length + 0.0);
        writeln!(out, "{}\t{area:.9}\t{length:.9}", self.step)
    }
}

/// A line of `PREFIXhHF`: the fluid that drives the fractures, each step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HydrofracturePoint {
    /// Time at the start of the step.
    pub time: f64,
    /// Pressure of the fluid.
    pub pressure: f64,
    /// Mass of the fluid.
    pub mass: f64,
    /// Volume that it fills.
    pub volume: f64,
}

impl HydrofracturePoint {
    /// Writes the line.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let [time, pressure, mass] =
            [self.time, self.pressure, self.mass].map(|value| E10.format(value));
        writeln!(out, "{time}\t{pressure}\t{mass}\t{:.6}", self.volume)
    }
}
