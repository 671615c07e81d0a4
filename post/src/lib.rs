//! Post-processing: tables and pictures from results of Ypsilon. Tables are made of bodies in the
//! plane and in space by the same code, generic over the dimension.
//!
//! * [`results`]: one model of VTU series and d3plot families
//! * [`field`]: what can be shown: stresses, displacements, velocities, forces
//! * [`selection`]: nodes by set, box, line, material, body or number
//! * [`extract`]: histories, lines, arcs, force against displacement, extremes as tables
//! * [`table`]: columns with names and units, as CSV
//! * [`plot`]: contour pictures and curves as PNG and SVG
//!
//! Pictures need nothing of the machine: the font is built in, and the same input gives the same
//! bytes everywhere.

mod error;
pub mod extract;
pub mod field;
#[cfg(feature = "parquet")]
pub mod parquet;
pub mod plot;
mod point;
pub mod results;
pub mod selection;
pub mod table;
mod vectors;

pub use error::PostError;
pub use point::Point;
