//! Energies through time.

use crate::error::PostError;
use crate::results::{Results, by_dimension};
use crate::table::Table;

/// Kinetic energy at all times.
///
/// # Errors
/// If the results neither tell it nor hold masses and velocities.
pub fn energy(results: &mut Results) -> Result<Table, PostError> {
    by_dimension!(results, energy_in())
}

fn energy_in<const D: usize, const C: usize>(results: &mut Results) -> Result<Table, PostError> {
    let mut table = Table::new(["time (s)", "kinetic energy (J)"]);
    for index in 0..results.len() {
        let frame = results.frame_in::<D, C>(index)?;
        let energy = frame.energy().ok_or(PostError::MissingArray {
            array: "kinetic energy",
            wanted: "the table of energies".to_owned(),
            remedy: "VTU files and d3plot families of Ypsilon have it",
        })?;
        table.rows.push(vec![frame.time, energy]);
    }
    Ok(table)
}
