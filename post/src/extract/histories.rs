//! Values at places through time.

use super::locate::{Location, Locator, nearest_node};
use crate::Point;
use crate::error::PostError;
use crate::field::{Field, FieldValues};
use crate::results::{Frame, Results, bounds, by_dimension, element_name};
use crate::table::Table;

/// A place of the bodies. It moves with them: what it names is found in the state at the start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Place {
    /// A node, from 0.
    Node(usize),
    /// A point of the undeformed bodies, m: stresses are those of the element that holds it,
    /// nodal values follow the shape functions of that element.
    Point(Point),
    /// The node of an element nearest to a point of the undeformed bodies, m.
    Nearest(Point),
}

impl Place {
    fn name(&self) -> String {
        let at = |point: &Point| {
            let numbers: Vec<String> = point.coordinates().iter().map(f64::to_string).collect();
            numbers.join("; ")
        };
        match self {
            Self::Node(node) => format!("node {node}"),
            Self::Point(point) => format!("({})", at(point)),
            Self::Nearest(point) => format!("the node nearest to ({})", at(point)),
        }
    }
}

/// A place as nodes and elements: fixed once for all times.
enum Anchor<const C: usize> {
    Node(usize, Option<usize>),
    Within(Location<C>),
}

/// Histories of `fields` at `places`: one column for each pair behind the time.
///
/// # Errors
/// If a place lies in no body or has other dimensions than the bodies, a field is not in the
/// results, or a file cannot be read.
pub fn histories(
    results: &mut Results,
    places: &[Place],
    fields: &[Field],
) -> Result<Table, PostError> {
    by_dimension!(results, histories_in(places, fields))
}

fn histories_in<const D: usize, const C: usize>(
    results: &mut Results,
    places: &[Place],
    fields: &[Field],
) -> Result<Table, PostError> {
    let first = results.frame_in::<D, C>(0)?;
    let anchors: Vec<Anchor<C>> =
        places.iter().map(|place| anchor(&first, place)).collect::<Result<_, _>>()?;
    let mut headings = vec!["time (s)".to_owned()];
    for place in places {
        headings.extend(fields.iter().map(|f| heading(*f, place)));
    }
    let mut table = Table::new(headings);
    for index in 0..results.len() {
        let frame = results.frame_in::<D, C>(index)?;
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

/// The places, with nodes of no element replaced by the node of one nearest to them at the start:
/// joints take the corners of elements away from the deck's nodes.
///
/// # Errors
/// If a file cannot be read.
pub fn on_bodies(results: &mut Results, places: &[Place]) -> Result<Vec<Place>, PostError> {
    by_dimension!(results, on_bodies_in(places))
}

fn on_bodies_in<const D: usize, const C: usize>(
    results: &mut Results,
    places: &[Place],
) -> Result<Vec<Place>, PostError> {
    let first = results.frame_in::<D, C>(0)?;
    let initial = first.initial();
    let used = first.mesh(&initial).used();
    let moved = |place: &Place| match *place {
        Place::Node(node) if used.get(node) == Some(&false) => {
            let nearest = initial.get(node).and_then(|&x| nearest_node(&first, x));
            nearest.map_or(Place::Node(node), Place::Node)
        }
        other => other,
    };
    Ok(places.iter().map(moved).collect())
}

fn heading(field: Field, place: &Place) -> String {
    match field.quantity().unit() {
        "" => format!("{} at {}", field.name(), place.name()),
        unit => format!("{} at {} ({unit})", field.name(), place.name()),
    }
}

fn anchor<const D: usize, const C: usize>(
    frame: &Frame<D, C>,
    place: &Place,
) -> Result<Anchor<C>, PostError> {
    match *place {
        Place::Nearest(point) => match nearest_node(frame, point.within()?) {
            Some(node) => anchor(frame, &Place::Node(node)),
            None => Err(PostError::Nothing("no node has finite coordinates".to_owned())),
        },
        Place::Node(node) if node < frame.points.len() => {
            let mesh = frame.mesh(&frame.points);
            let mut elements = 0..frame.elements.len();
            Ok(Anchor::Node(node, elements.find(|&e| mesh.nodes_of(e).any(|n| n == node))))
        }
        Place::Node(node) => Err(PostError::Nothing(format!(
            "there is no node {node}; nodes run from 0 to {}",
            frame.points.len().saturating_sub(1)
        ))),
        Place::Point(point) => {
            let initial = frame.initial();
            let found = Locator::new(&frame.elements, &initial).find(point.within()?);
            found.map(Anchor::Within).ok_or_else(|| {
                let [low, high] = bounds(&initial).unwrap_or([[f64::NAN; D]; 2]);
                let ranges = ["x", "y", "z"].iter().zip(low.iter().zip(&high));
                let ranges: Vec<String> =
                    ranges.map(|(axis, (low, high))| format!("{axis} = {low} to {high}")).collect();
                PostError::Nothing(format!(
                    "no {} holds the point {} at the start; bodies lie within {}",
                    element_name(D),
                    place.name(),
                    ranges.join(", ")
                ))
            })
        }
    }
}

fn value<const D: usize, const C: usize>(
    frame: &Frame<D, C>,
    anchor: &Anchor<C>,
    values: &FieldValues,
) -> f64 {
    let at = |values: &[f64], index: usize| values.get(index).copied().unwrap_or(f64::NAN);
    match (anchor, values) {
        (Anchor::Node(node, _), FieldValues::Nodes(values)) => at(values, *node),
        (Anchor::Node(_, element), FieldValues::Elements(values)) => {
            element.map_or(f64::NAN, |element| at(values, element))
        }
        (Anchor::Within(Location { element, weights }), values) => {
            values.within(frame, *element, *weights)
        }
    }
}
