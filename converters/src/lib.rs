//! Turns results of Y into files that ParaView and spreadsheets open, and writes such files
//! for the solver.
//!
//! * [`vtk`]: unstructured grids (`.vtu`) and time series of them (`.pvd`)
//! * [`d3plot`]: d3plot families to time series
//! * [`history`]: `.yh` histories to CSV
//! * [`ym`]: `.ym` snapshots of the classic dialect to time series
//! * [`restart`]: decks of the classic dialect, restart decks above all, to grids
//! * [`gmsh`]: Gmsh meshes to decks
//! * [`vtk_series`]: Y-Geo's VTK files to time series
//! * [`dialects`]: decks of one dialect to another
//! * [`detect`]: what kind of file something is, by its content
//! * [`stress_measures`]: von Mises, principal and Tresca stresses

pub mod d3plot;
pub mod detect;
pub mod dialects;
mod error;
pub mod gmsh;
pub mod history;
mod replace_file;
pub mod restart;
pub mod stress_measures;
pub mod vtk;
pub mod vtk_series;
pub mod ym;

pub use error::ConvertError;
