//! Reactions against displacements.

use crate::error::PostError;
use crate::results::{Results, by_dimension};
use crate::selection::Selection;
use crate::table::Table;

/// Sums of the nodal forces of `supports` and mean displacements of `moved` at all times.
///
/// The reaction is the force of the supports on the body: minus the sum of the nodal forces
/// (internal, joints, contact, edge loads), without weight and load of the supported nodes
/// themselves.
///
/// # Errors
/// If a selection holds no node, the results have no nodal forces, or a file cannot be read.
pub fn force_displacement(
    results: &mut Results,
    supports: &Selection,
    moved: &Selection,
) -> Result<Table, PostError> {
    by_dimension!(results, force_displacement_in(supports, moved))
}

fn force_displacement_in<const D: usize, const C: usize>(
    results: &mut Results,
    supports: &Selection,
    moved: &Selection,
) -> Result<Table, PostError> {
    let first = results.frame_in::<D, C>(0)?;
    let initial = first.initial();
    let mesh = first.mesh(&initial);
    let (supports, moved) = (supports.nodes(&mesh)?, moved.nodes(&mesh)?);
    let axes = &["x", "y", "z"][..D];
    let mut headings = vec!["time (s)".to_owned()];
    headings.extend(axes.iter().map(|axis| format!("mean displacement u{axis} (m)")));
    headings.extend(axes.iter().map(|axis| format!("reaction {axis} (N)")));
    let mut table = Table::new(headings);
    let missing = |array| PostError::MissingArray {
        array,
        wanted: "the table of forces and displacements".to_owned(),
        remedy: "VTU files of Ypsilon have them (run with --formats vtu)",
    };
    for index in 0..results.len() {
        let frame = results.frame_in::<D, C>(index)?;
        let force = frame.force.as_ref().ok_or_else(|| missing("nodal forces"))?;
        let displacement = frame.displacement.as_ref().ok_or_else(|| missing("displacements"))?;
        let mut row = vec![frame.time];
        row.extend(sum(displacement, &moved).map(|u| u / moved.len() as f64));
        row.extend(sum(force, &supports).map(|f| 0.0 - f));
        table.rows.push(row);
    }
    Ok(table)
}

fn sum<const D: usize>(vectors: &[[f64; D]], nodes: &[usize]) -> [f64; D] {
    let chosen = nodes.iter().filter_map(|&n| vectors.get(n));
    chosen.fold([0.0; D], |sum, v| std::array::from_fn(|axis| sum[axis] + v[axis]))
}
