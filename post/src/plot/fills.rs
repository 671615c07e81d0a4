//! The bodies, filled with colours.

use std::collections::BTreeMap;

use super::axes::Axes;
use super::bands::band;
use super::colouring::{Colouring, SHADES};
use super::colours::Colour;
use super::picture::Shape;
use crate::results::Frame;

/// Triangles of one colour each, one shape for each colour.
pub(super) fn flat(
    frame: &Frame,
    points: &[[f64; 2]],
    values: &[f64],
    axes: &Axes,
    colours: &Colouring,
) -> Vec<Shape> {
    let mut of_colour: BTreeMap<Colour, Vec<Vec<[f64; 2]>>> = BTreeMap::new();
    for (&triangle, &value) in frame.elements.iter().zip(values) {
        let ring = Frame::corners(triangle, points).map(|p| axes.pixel(p)).to_vec();
        let colour = if value.is_finite() {
            colours.colour(colours.middle(colours.shade(value), SHADES))
        } else {
            colours.map.colour(f64::NAN)
        };
        of_colour.entry(colour).or_default().push(ring);
    }
    polygons(of_colour)
}

/// Triangles cut into bands, one shape for each colour.
pub(super) fn banded(
    frame: &Frame,
    points: &[[f64; 2]],
    values: &[[f64; 3]],
    axes: &Axes,
    colours: &Colouring,
) -> Vec<Shape> {
    let mut of_colour: BTreeMap<Colour, Vec<Vec<[f64; 2]>>> = BTreeMap::new();
    let step = (colours.high - colours.low) / colours.bands as f64;
    let of_band = |value: f64| {
        (((value - colours.low) / step).floor().clamp(0.0, (colours.bands - 1) as f64)) as usize
    };
    for (&triangle, &values) in frame.elements.iter().zip(values) {
        let corners = Frame::corners(triangle, points).map(|p| axes.pixel(p));
        if !values.iter().all(|v| v.is_finite()) {
            of_colour.entry(colours.map.colour(f64::NAN)).or_default().push(corners.to_vec());
            continue;
        }
        let [a, b, c] = values;
        let (first, last) = (of_band(a.min(b).min(c)), of_band(a.max(b).max(c)));
        for index in first..=last {
            // the first and the last band take what lies outside of the range
            let edge = |index: usize| colours.low + index as f64 * step;
            let low = if index == 0 { -f64::MAX } else { edge(index) };
            let high = if index + 1 == colours.bands { f64::MAX } else { edge(index + 1) };
            let ring =
                if first == last { corners.to_vec() } else { band(corners, values, low, high) };
            if ring.len() > 2 {
                let colour = colours.colour(colours.middle(index, colours.bands));
                of_colour.entry(colour).or_default().push(ring);
            }
        }
    }
    polygons(of_colour)
}

fn polygons(of_colour: BTreeMap<Colour, Vec<Vec<[f64; 2]>>>) -> Vec<Shape> {
    let shape = |(colour, rings)| Shape::Polygons { rings, colour, seam: 1.4 };
    of_colour.into_iter().map(shape).collect()
}
