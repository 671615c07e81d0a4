//! Smallest and largest values with place and time.

use crate::error::PostError;
use crate::field::{Field, FieldValues};
use crate::results::{Frame, Results, by_dimension};
use crate::table::Table;

/// Smallest and largest value of a field at each time with its place (the node, or the centre of
/// the element, where it is then), m.
///
/// # Errors
/// If the field is not in the results or a file cannot be read.
pub fn extremes(results: &mut Results, fields: &[Field]) -> Result<Table, PostError> {
    by_dimension!(results, extremes_in(fields))
}

fn extremes_in<const D: usize, const C: usize>(
    results: &mut Results,
    fields: &[Field],
) -> Result<Table, PostError> {
    let mut headings = vec!["time (s)".to_owned()];
    for field in fields {
        let (name, unit) = (field.name(), field.quantity().unit());
        let unit = if unit.is_empty() { String::new() } else { format!(" ({unit})") };
        for kind in ["min", "max"] {
            headings.push(format!("{kind} {name}{unit}"));
            let axes = ["x", "y", "z"].iter().take(D);
            headings.extend(axes.map(|axis| format!("{axis} of {kind} {name} (m)")));
        }
    }
    let mut table = Table::new(headings);
    for index in 0..results.len() {
        let frame = results.frame_in::<D, C>(index)?;
        let mut row = vec![frame.time];
        for field in fields {
            let values = field.values(&frame)?;
            for sign in [1.0, -1.0] {
                let all = values.all().iter().enumerate().filter(|(_, v)| v.is_finite());
                let extreme = all.min_by(|(_, a), (_, b)| (sign * **a).total_cmp(&(sign * **b)));
                let (value, place) = match extreme {
                    Some((index, &value)) => (value, place(&frame, &values, index)),
                    None => (f64::NAN, [f64::NAN; D]),
                };
                row.push(value);
                row.extend(place);
            }
        }
        table.rows.push(row);
    }
    Ok(table)
}

fn place<const D: usize, const C: usize>(
    frame: &Frame<D, C>,
    values: &FieldValues,
    index: usize,
) -> [f64; D] {
    match values {
        FieldValues::Nodes(_) => frame.points.get(index).copied().unwrap_or([f64::NAN; D]),
        FieldValues::Elements(_) => {
            let element = frame.elements.get(index).copied().unwrap_or([u32::MAX; C]);
            let corners = Frame::corners(element, &frame.points);
            std::array::from_fn(|axis| {
                corners.iter().map(|corner| corner[axis]).sum::<f64>() / C as f64
            })
        }
    }
}
