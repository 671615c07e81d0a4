//! Text files with a line per joint that broke or yielded.

use std::io::{self, Write};

use super::joints::YieldMode;
use super::series::E10;

/// A line of `PREFIXhBRK`: a joint that broke in the step.
///
/// Y-Geo writes the joints of one step latest first, that is in descending order of the
/// evaluation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BreakageRecord {
    /// Number of the joint's element, from 0.
    pub element: usize,
    /// As in [`super::BrokenJoint::failure_mode`].
    pub failure_mode: f64,
    /// Time of the step.
    pub time: f64,
    /// Mean of the four corners.
    pub centroid: [f64; 2],
    /// Coordinates of corners 0 and 1 after the step.
    pub edge: [[f64; 2]; 2],
    /// Work of the joint, negative where it took up energy.
    pub fracture_energy: f64,
    /// Length by which the work is divided: that of edge 0-1 when the joint broke.
    pub length: f64,
    /// Change of the kinetic energy around the joint.
    pub kinetic_energy_change: f64,
    /// Time when that change was largest.
    pub peak_time: f64,
    /// Flag of the discrete fracture network where the deck uses one (IUSEFN above 0).
    pub fracture_network: Option<i64>,
}

impl BreakageRecord {
    /// Writes the line.
    ///
    /// The last column, Y-Geo's "window start", is an integer that C prints as a real number:
    /// what comes out is the real number printed before it, the time of the peak, in all
    /// reference files. It is printed so here.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        let [[x0, y0], [x1, y1]] = self.edge;
        let reals = [
            self.failure_mode,
            self.time,
            self.centroid[0],
            self.centroid[1],
            x0,
            y0,
            x1,
            y1,
            self.fracture_energy,
            -self.fracture_energy / self.length,
            self.kinetic_energy_change,
            self.peak_time,
        ];
        write!(out, "{:5}\t", self.element)?;
        for real in reals {
            write!(out, "{}\t", E10.format(real))?;
        }
        if let Some(flag) = self.fracture_network {
            write!(out, "{flag:5}")?;
        }
        writeln!(out, "\t{}", E10.format(self.peak_time))
    }
}

/// A line of `PREFIXhSFT`: a joint that yielded in the step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct YieldRecord {
    /// Number of the joint's element, from 0.
    pub element: usize,
    /// How it yielded.
    pub mode: YieldMode,
    /// Time of the step.
    pub time: f64,
    /// Mean of the four corners.
    pub centroid: [f64; 2],
    /// Coordinates of corners 0 and 1 after the step.
    pub edge: [[f64; 2]; 2],
}

impl YieldRecord {
    /// Writes the line.
    pub fn write(&self, out: &mut impl Write) -> io::Result<()> {
        write!(out, "{:5}\t{}", self.element, self.mode.code())?;
        let [[x0, y0], [x1, y1]] = self.edge;
        for real in [self.time, self.centroid[0], self.centroid[1], x0, y0, x1, y1] {
            write!(out, "\t{}", E10.format(real))?;
        }
        out.write_all(b"\n")
    }
}
