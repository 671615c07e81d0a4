//! The result files of the Y-Geo dialect against those of the original.

mod bad_frames;
mod compare;
mod deck;
mod first_step;
mod reference;
mod round_trip;
mod state;
mod text_files;
mod triangle;
mod vtk_text;
