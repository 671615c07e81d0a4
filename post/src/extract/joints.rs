//! Joints through time.

use crate::error::PostError;
use crate::results::{JointState, Results, by_dimension};
use crate::table::Table;

/// How many joints are intact, softening and broken at all times; of the broken ones how many
/// failed in tension, in shear, in both, and of how many it is not known; and the length of the
/// broken ones, m, in space their area, m².
///
/// # Errors
/// If no time has joints, or a file cannot be read.
pub fn joint_counts(results: &mut Results) -> Result<Table, PostError> {
    by_dimension!(results, joint_counts_in())
}

fn joint_counts_in<const D: usize, const C: usize>(
    results: &mut Results,
) -> Result<Table, PostError> {
    let mut table = Table::new([
        "time (s)",
        "intact",
        "softening",
        "broken",
        "broken in tension",
        "broken in shear",
        "broken in both",
        "broken of unknown mode",
        if D > 2 { "broken area (m²)" } else { "broken length (m)" },
    ]);
    let mut any = false;
    for index in 0..results.len() {
        let frame = results.frame_in::<D, C>(index)?;
        any |= !frame.joints.is_empty();
        let mut row = vec![0.0; table.headings.len()];
        row[0] = frame.time;
        for joint in &frame.joints {
            row[1 + joint.state as usize] += 1.0;
            if joint.state == JointState::Broken {
                let mode = match joint.mode {
                    Some(1.0) => 4,
                    Some(2.0) => 5,
                    Some(_) => 6,
                    None => 7,
                };
                row[mode] += 1.0;
                row[8] += joint.extent();
            }
        }
        table.rows.push(row);
    }
    if any {
        Ok(table)
    } else {
        Err(PostError::Nothing("the results have no joints at any time".to_owned()))
    }
}
