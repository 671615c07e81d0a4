//! The file formats of Munjiza's Y program and its descendants, without any physics.
//!
//! - [`deck`]: input decks, read without loss and written back; [`keywords`] are their tables,
//!   [`database`] the values that they leave in the program, [`diagnostic`] what is wrong with them.
//! - [`d3plot`]: binary result families for LS-PrePost.
//! - [`history`]: `.yh` histories.
//! - [`ygeo_output`]: the VTK XML and text files of the Y-Geo dialect.
//! - [`ym`]: `.ym` snapshots of the classic dialect, [`classic_output`]: its other files.

pub mod c_format;
pub mod checksum;
pub mod classic_output;
pub mod d3plot;
pub mod database;
pub mod deck;
pub mod diagnostic;
pub mod dialect;
pub mod history;
pub mod keywords;
pub mod part_file;
pub mod source;
pub mod ygeo_output;
pub mod ym;
