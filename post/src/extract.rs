//! Tables from results, of triangles in the plane and tetrahedra in space.
//!
//! The code is generic over the dimension `D` and the corners of an element `C`; which they are
//! is asked of the results once for each table.

mod energies;
mod extremes;
mod force_displacement;
mod histories;
mod joints;
mod lines;
mod locate;
mod top_line;

use crate::error::PostError;
use crate::results::Results;

pub use energies::energy;
pub use extremes::extremes;
pub use force_displacement::force_displacement;
pub use histories::{Place, histories, on_bodies};
pub use joints::joint_counts;
pub use lines::{Path, along};
pub use locate::{Location, Locator, nearest_node};
pub use top_line::top_line;

/// Refuses results in space for a table of the plane.
fn only_in_the_plane(results: &mut Results, table: &str, instead: &str) -> Result<(), PostError> {
    if results.dimension()? == 2 {
        return Ok(());
    }
    Err(PostError::Nothing(format!(
        "{table} is one of bodies in the plane, and {path} holds bodies in space; use {instead}",
        path = results.path().display()
    )))
}
