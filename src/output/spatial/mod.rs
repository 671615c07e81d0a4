//! Result files of simulations in three dimensions.

mod bodies;
mod d3plot;
mod vtu;

pub use bodies::body_of_tetrahedra;
pub use d3plot::SpatialD3plotOutput;
pub use vtu::{SpatialVtuOutput, grids as spatial_grids};
