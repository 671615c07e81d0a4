//! Smallest and largest values with place and time.

use crate::error::PostError;
use crate::field::{Field, FieldValues};
use crate::results::{Frame, Results};
use crate::table::Table;

/// Smallest and largest value of a field at each time with its place (the node, or the centre of
/// the triangle, where it is then), m.
///
/// # Errors
/// If the field is not in the results or a file cannot be read.
pub fn extremes(results: &mut Results, fields: &[Field]) -> Result<Table, PostError> {
    let mut headings = vec!["time (s)".to_owned()];
    for field in fields {
        let (name, unit) = (field.name(), field.quantity().unit());
        let unit = if unit.is_empty() { String::new() } else { format!(" ({unit})") };
        for kind in ["min", "max"] {
            headings.push(format!("{kind} {name}{unit}"));
            headings.push(format!("x of {kind} {name} (m)"));
            headings.push(format!("y of {kind} {name} (m)"));
        }
    }
    let mut table = Table::new(headings);
    for index in 0..results.len() {
        let frame = results.frame(index)?;
        let mut row = vec![frame.time];
        for field in fields {
            let values = field.values(&frame)?;
            for sign in [1.0, -1.0] {
                let all = values.all().iter().enumerate().filter(|(_, v)| v.is_finite());
                let extreme = all.min_by(|(_, a), (_, b)| (sign * **a).total_cmp(&(sign * **b)));
                let (value, place) = match extreme {
                    Some((index, &value)) => (value, place(&frame, &values, index)),
                    None => (f64::NAN, [f64::NAN; 2]),
                };
                row.extend([value, place[0], place[1]]);
            }
        }
        table.rows.push(row);
    }
    Ok(table)
}

fn place(frame: &Frame, values: &FieldValues, index: usize) -> [f64; 2] {
    match values {
        FieldValues::Nodes(_) => frame.points.get(index).copied().unwrap_or([f64::NAN; 2]),
        FieldValues::Triangles(_) => {
            let triangle = frame.triangles.get(index).copied().unwrap_or([u32::MAX; 3]);
            let [a, b, c] = Frame::corners(triangle, &frame.points);
            [0, 1].map(|axis| (a[axis] + b[axis] + c[axis]) / 3.0)
        }
    }
}
