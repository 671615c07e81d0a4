//! Values at places through time.

use super::locate::{Locator, nearest_corner};
use crate::error::PostError;
use crate::field::Field;
use crate::results::{Frame, Results};
use crate::table::Table;

/// A place of the bodies. It moves with them: what it names is found in the state at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// A node, from 0.
    Node(usize),
    /// A point of the undeformed bodies, m: stresses are those of the triangle that holds it,
    /// nodal values are linear in that triangle.
    Point([f64; 2]),
    /// The node of a triangle nearest to a point of the undeformed bodies, m.
    Nearest([f64; 2]),
}

impl Place {
    fn name(&self) -> String {
        match self {
            Self::Node(node) => format!("node {node}"),
            Self::Point([x, y]) => format!("({x}; {y})"),
            Self::Nearest([x, y]) => format!("the node nearest to ({x}; {y})"),
        }
    }
}

/// A place as triangles and weights: fixed once for all times.
enum Anchor {
    Node(usize, Option<usize>),
    Triangle(usize, [f64; 3]),
}

/// Histories of `fields` at `places`: one column for each pair behind the time.
///
/// # Errors
/// If a place lies in no body, a field is not in the results, or a file cannot be read.
pub fn histories(
    results: &mut Results,
    places: &[Place],
    fields: &[Field],
) -> Result<Table, PostError> {
    let first = results.frame(0)?;
    let anchors: Vec<Anchor> =
        places.iter().map(|place| anchor(&first, place)).collect::<Result<_, _>>()?;
    let mut headings = vec!["time (s)".to_owned()];
    for place in places {
        headings.extend(fields.iter().map(|f| heading(*f, place)));
    }
    let mut table = Table::new(headings);
    for index in 0..results.len() {
        let frame = results.frame(index)?;
        let values: Vec<_> = fields.iter().map(|f| f.values(&frame)).collect::<Result<_, _>>()?;
        let mut row = vec![frame.time];
        for anchor in &anchors {
            for values in &values {
                row.push(value(&frame, anchor, values));
            }
        }
        table.rows.push(row);
    }
    Ok(table)
}

fn heading(field: Field, place: &Place) -> String {
    match field.quantity().unit() {
        "" => format!("{} at {}", field.name(), place.name()),
        unit => format!("{} at {} ({unit})", field.name(), place.name()),
    }
}

fn anchor(frame: &Frame, place: &Place) -> Result<Anchor, PostError> {
    match *place {
        Place::Nearest(point) => match nearest_corner(frame, point) {
            Some(node) => anchor(frame, &Place::Node(node)),
            None => Err(PostError::Nothing("no node has finite coordinates".to_owned())),
        },
        Place::Node(node) if node < frame.points.len() => {
            let mut corners = frame.triangles.iter();
            Ok(Anchor::Node(node, corners.position(|t| t.contains(&(node as u32)))))
        }
        Place::Node(node) => Err(PostError::Nothing(format!(
            "there is no node {node}; nodes run from 0 to {}",
            frame.points.len().saturating_sub(1)
        ))),
        Place::Point(point) => {
            let initial = frame.initial();
            let found = Locator::new(&frame.triangles, &initial).find(point);
            let found = found.ok_or_else(|| {
                let [low, high] = Frame::bounds(&initial).unwrap_or([[f64::NAN; 2]; 2]);
                PostError::Nothing(format!(
                    "no triangle holds the point {} at the start; bodies lie within \
                     x = {} to {}, y = {} to {}",
                    place.name(),
                    low[0],
                    high[0],
                    low[1],
                    high[1]
                ))
            })?;
            Ok(Anchor::Triangle(found.triangle, found.weights))
        }
    }
}

fn value(frame: &Frame, anchor: &Anchor, values: &crate::field::FieldValues) -> f64 {
    use crate::field::FieldValues::{Nodes, Triangles};
    let at = |values: &[f64], index: usize| values.get(index).copied().unwrap_or(f64::NAN);
    match (anchor, values) {
        (Anchor::Node(node, _), Nodes(values)) => at(values, *node),
        (Anchor::Node(_, triangle), Triangles(values)) => {
            triangle.map_or(f64::NAN, |t| at(values, t))
        }
        (Anchor::Triangle(triangle, _), Triangles(values)) => at(values, *triangle),
        (Anchor::Triangle(triangle, weights), Nodes(values)) => {
            let corners = frame.triangles.get(*triangle).copied().unwrap_or([u32::MAX; 3]);
            corners.iter().zip(weights).map(|(&n, w)| w * at(values, n as usize)).sum()
        }
    }
}
