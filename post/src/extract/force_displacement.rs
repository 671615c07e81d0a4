//! Reactions against displacements.

use crate::error::PostError;
use crate::results::{Frame, Results};
use crate::selection::{Mesh, Selection};
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
    let first = results.frame(0)?;
    let supports = nodes(&first, supports)?;
    let moved = nodes(&first, moved)?;
    let mut table = Table::new([
        "time (s)",
        "mean displacement ux (m)",
        "mean displacement uy (m)",
        "reaction x (N)",
        "reaction y (N)",
    ]);
    let missing = |array| PostError::MissingArray {
        array,
        wanted: "the table of forces and displacements".to_owned(),
        remedy: "VTU files of Ypsilon have them (run with --formats vtu)",
    };
    for index in 0..results.len() {
        let frame = results.frame(index)?;
        let force = frame.force.as_ref().ok_or_else(|| missing("nodal forces"))?;
        let displacement = frame.displacement.as_ref().ok_or_else(|| missing("displacements"))?;
        let reaction = sum(force, &supports).map(|f| 0.0 - f);
        let moved = sum(displacement, &moved).map(|u| u / moved.len() as f64);
        table.rows.push(vec![frame.time, moved[0], moved[1], reaction[0], reaction[1]]);
    }
    Ok(table)
}

/// The nodes of a selection in a frame.
fn nodes(frame: &Frame, selection: &Selection) -> Result<Vec<usize>, PostError> {
    selection.nodes(&Mesh {
        initial: &frame.initial(),
        node_set: frame.node_set.as_deref(),
        triangles: &frame.triangles,
        property: &frame.property,
        body: frame.body.as_deref(),
    })
}

fn sum(vectors: &[[f64; 2]], nodes: &[usize]) -> [f64; 2] {
    let chosen = nodes.iter().filter_map(|&n| vectors.get(n));
    chosen.fold([0.0; 2], |sum, v| [sum[0] + v[0], sum[1] + v[1]])
}
