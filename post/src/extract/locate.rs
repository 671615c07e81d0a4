//! Which triangle holds a point.

use std::collections::HashMap;

use crate::results::Frame;

/// How far outside of a triangle a point may lie and still belong to it, relative to its size.
const TOLERANCE: f64 = 1e-9;

/// Finds triangles by place.
#[derive(Debug)]
pub struct Locator<'a> {
    triangles: &'a [[u32; 3]],
    points: &'a [[f64; 2]],
    cell: f64,
    origin: [f64; 2],
    cells: HashMap<[i64; 2], Vec<usize>>,
    /// Triangles that reach over too many cells to be listed in each.
    large: Vec<usize>,
}

/// Cells that a triangle may reach over before it counts as large.
const LARGE: i64 = 256;

/// A triangle and the weights of its corners at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Location {
    /// The triangle.
    pub triangle: usize,
    /// Area coordinates.
    pub weights: [f64; 3],
}

impl<'a> Locator<'a> {
    /// A search structure over triangles whose corners lie at `points`.
    #[must_use]
    pub fn new(triangles: &'a [[u32; 3]], points: &'a [[f64; 2]]) -> Self {
        let bounds = Frame::bounds(points).unwrap_or([[0.0; 2]; 2]);
        let (width, height) = (bounds[1][0] - bounds[0][0], bounds[1][1] - bounds[0][1]);
        let per_axis = (triangles.len() as f64).sqrt().clamp(1.0, 1000.0);
        let cell = (width.max(height) / per_axis).max(f64::MIN_POSITIVE);
        let (cells, large) = (HashMap::new(), Vec::new());
        let mut locator = Self { triangles, points, cell, origin: bounds[0], cells, large };
        for (index, &triangle) in triangles.iter().enumerate() {
            let corners = Frame::corners(triangle, points);
            let Ok([low, high]) = Frame::bounds(&corners) else { continue };
            let (low, high) = (locator.cell_of(low), locator.cell_of(high));
            if (high[0] - low[0] + 1).saturating_mul(high[1] - low[1] + 1) > LARGE {
                locator.large.push(index);
                continue;
            }
            for i in low[0]..=high[0] {
                for j in low[1]..=high[1] {
                    locator.cells.entry([i, j]).or_default().push(index);
                }
            }
        }
        locator
    }

    /// The triangle with the lowest number that holds `point`.
    #[must_use]
    pub fn find(&self, point: [f64; 2]) -> Option<Location> {
        let near = self.cells.get(&self.cell_of(point)).into_iter().flatten();
        let holds = |&triangle: &usize| {
            let corners = Frame::corners(*self.triangles.get(triangle)?, self.points);
            let weights = weights(corners, point)?;
            weights.iter().all(|&w| w >= -TOLERANCE).then_some(Location { triangle, weights })
        };
        near.chain(&self.large).filter_map(holds).min_by_key(|found| found.triangle)
    }

    fn cell_of(&self, point: [f64; 2]) -> [i64; 2] {
        [0, 1].map(|axis| ((point[axis] - self.origin[axis]) / self.cell).floor() as i64)
    }
}

/// The corner of a triangle that was nearest to a point at the start, the lowest number among
/// equals. Nodes without a triangle, which joint insertion leaves behind, do not count.
#[must_use]
pub fn nearest_corner(frame: &Frame, point: [f64; 2]) -> Option<usize> {
    let initial = frame.initial();
    let mut corners: Vec<usize> = frame.triangles.iter().flatten().map(|&n| n as usize).collect();
    corners.sort_unstable();
    corners.dedup();
    let distance = |&n: &usize| initial.get(n).map(|x| (x[0] - point[0]).hypot(x[1] - point[1]));
    let found = corners.into_iter().filter_map(|n| Some((distance(&n)?, n)));
    found.filter(|(d, _)| d.is_finite()).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, n)| n)
}

/// Area coordinates of a point; `None` for triangles without area.
fn weights([a, b, c]: [[f64; 2]; 3], p: [f64; 2]) -> Option<[f64; 3]> {
    let area = |a: [f64; 2], b: [f64; 2], c: [f64; 2]| {
        (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])
    };
    let whole = area(a, b, c);
    let weights = [area(p, b, c) / whole, area(a, p, c) / whole, area(a, b, p) / whole];
    weights.iter().all(|w| w.is_finite()).then_some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_corner_belongs_to_a_triangle() {
        let points = vec![[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let frame = Frame { points, triangles: vec![[1, 2, 3]], ..Frame::default() };
        assert_eq!(nearest_corner(&frame, [0.1, 0.1]), Some(1));
        assert_eq!(nearest_corner(&frame, [5.0, 0.1]), Some(2));
        assert_eq!(nearest_corner(&frame, [f64::NAN, 0.1]), None);
    }

    #[test]
    fn points_are_found_in_their_triangles() {
        let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]];
        let triangles = [[0, 1, 2], [0, 2, 3]];
        let locator = Locator::new(&triangles, &points);
        let found = locator.find([1.5, 0.25]).expect("a triangle");
        assert_eq!((found.triangle, found.weights), (0, [0.25, 0.5, 0.25]));
        assert_eq!(locator.find([0.1, 0.9]).map(|l| l.triangle), Some(1));
        assert_eq!(locator.find([2.0, 1.0]).map(|l| l.triangle), Some(0));
        assert_eq!(locator.find([2.1, 0.5]), None);
        assert_eq!(locator.find([f64::NAN, 0.5]), None);
    }
}
