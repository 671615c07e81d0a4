//! Which element holds a point.

use std::collections::HashMap;

use crate::results::Frame;
use crate::vectors::{bounds, content, length, minus};

/// How far outside of an element a point may lie and still belong to it, relative to its size.
const TOLERANCE: f64 = 1e-9;

/// Finds triangles (`D` = 2, `C` = 3) or tetrahedra (3, 4) by place. Edges are straight between
/// the corners, whether nodes lie on them or not.
#[derive(Debug)]
pub struct Locator<'a, const D: usize, const C: usize> {
    elements: &'a [[u32; C]],
    points: &'a [[f64; D]],
    cell: f64,
    origin: [f64; D],
    cells: HashMap<[i64; D], Vec<usize>>,
    /// Elements that reach over too many cells to be listed in each.
    large: Vec<usize>,
}

/// Cells that an element may reach over before it counts as large.
const LARGE: i64 = 256;

/// An element and the weights of its corners at a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Location<const C: usize> {
    /// The triangle or tetrahedron.
    pub element: usize,
    /// Area or volume coordinates.
    pub weights: [f64; C],
}

impl<'a, const D: usize, const C: usize> Locator<'a, D, C> {
    /// A search structure over elements whose corners lie at `points`.
    #[must_use]
    pub fn new(elements: &'a [[u32; C]], points: &'a [[f64; D]]) -> Self {
        let bounds_of_all = bounds(points).unwrap_or([[0.0; D]; 2]);
        let widest = minus(bounds_of_all[1], bounds_of_all[0]).into_iter().fold(0.0, f64::max);
        let count = elements.len() as f64;
        let per_axis = if D == 2 { count.sqrt() } else { count.cbrt() }.clamp(1.0, 1000.0);
        let cell = (widest / per_axis).max(f64::MIN_POSITIVE);
        let (cells, large) = (HashMap::new(), Vec::new());
        let origin = bounds_of_all[0];
        let mut locator = Self { elements, points, cell, origin, cells, large };
        for (index, &element) in elements.iter().enumerate() {
            let Ok([low, high]) = bounds(&Frame::corners(element, points)) else { continue };
            // as far as a point may lie outside
            let widest = minus(high, low).into_iter().fold(0.0, f64::max);
            let reach = C as f64 * TOLERANCE * widest;
            let (low, high) = (low.map(|x| x - reach), high.map(|x| x + reach));
            let (low, high) = (locator.cell_of(low), locator.cell_of(high));
            let counts: [i64; D] =
                std::array::from_fn(|axis| high[axis].saturating_sub(low[axis]).saturating_add(1));
            let reached = counts.into_iter().fold(1, i64::saturating_mul);
            if reached > LARGE {
                locator.large.push(index);
                continue;
            }
            for mut number in 0..reached {
                let key = std::array::from_fn(|axis| {
                    let step = number % counts[axis];
                    number /= counts[axis];
                    low[axis] + step
                });
                locator.cells.entry(key).or_default().push(index);
            }
        }
        locator
    }

    /// The element with the lowest number that holds `point`.
    #[must_use]
    pub fn find(&self, point: [f64; D]) -> Option<Location<C>> {
        let near = self.cells.get(&self.cell_of(point)).into_iter().flatten();
        let holds = |&element: &usize| {
            let corners = Frame::corners(*self.elements.get(element)?, self.points);
            let weights = weights(corners, point)?;
            weights.iter().all(|&w| w >= -TOLERANCE).then_some(Location { element, weights })
        };
        near.chain(&self.large).filter_map(holds).min_by_key(|found| found.element)
    }

    fn cell_of(&self, point: [f64; D]) -> [i64; D] {
        minus(point, self.origin).map(|way| (way / self.cell).floor() as i64)
    }
}

/// The node of an element that was nearest to a point at the start, the lowest number among
/// equals. Nodes without an element, which joint insertion leaves behind, do not count.
#[must_use]
pub fn nearest_node<const D: usize, const C: usize>(
    frame: &Frame<D, C>,
    point: [f64; D],
) -> Option<usize> {
    let initial = frame.initial();
    let used = frame.mesh(&initial).used();
    let nodes = initial.iter().zip(used).enumerate().filter(|(_, (_, used))| *used);
    let found = nodes.map(|(node, (&place, _))| (length(minus(place, point)), node));
    found.filter(|(d, _)| d.is_finite()).min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, n)| n)
}

/// Area or volume coordinates of a point; `None` for elements without area or volume.
fn weights<const D: usize, const C: usize>(
    corners: [[f64; D]; C],
    p: [f64; D],
) -> Option<[f64; C]> {
    let whole = content(&corners);
    let weights = std::array::from_fn(|corner| {
        let mut part = corners;
        part[corner] = p;
        content(&part) / whole
    });
    weights.iter().all(|w: &f64| w.is_finite()).then_some(weights)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_nearest_node_belongs_to_a_triangle() {
        let points = vec![[0.0, 0.0], [0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let frame = Frame { points, elements: vec![[1, 2, 3]], ..Frame::default() };
        assert_eq!(nearest_node(&frame, [0.1, 0.1]), Some(1));
        assert_eq!(nearest_node(&frame, [5.0, 0.1]), Some(2));
        assert_eq!(nearest_node(&frame, [f64::NAN, 0.1]), None);
    }

    #[test]
    fn points_are_found_in_their_triangles() {
        let points = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [0.0, 1.0]];
        let triangles = [[0, 1, 2], [0, 2, 3]];
        let locator = Locator::new(&triangles, &points);
        let found = locator.find([1.5, 0.25]).expect("a triangle");
        assert_eq!((found.element, found.weights), (0, [0.25, 0.5, 0.25]));
        assert_eq!(locator.find([0.1, 0.9]).map(|l| l.element), Some(1));
        assert_eq!(locator.find([2.0, 1.0]).map(|l| l.element), Some(0));
        assert_eq!(locator.find([2.1, 0.5]), None);
        assert_eq!(locator.find([f64::NAN, 0.5]), None);
    }

    #[test]
    fn points_on_the_outline_are_found_in_spite_of_rounding() {
        // two squares; the right side of the first lies a rounding short of 1, where the cells of
        // the search meet
        let end = 1.0 - f64::EPSILON / 2.0;
        let square = |left: f64, right: f64| [[left, 0.0], [right, 0.0], [right, 1.0], [left, 1.0]];
        let points = [square(0.0, end), square(1.5, 2.0)].concat();
        let triangles = [[0, 1, 2], [0, 2, 3], [4, 5, 6], [4, 6, 7]];
        let locator = Locator::new(&triangles, &points);
        assert_eq!(locator.find([1.0, 0.5]).map(|l| l.element), Some(0));
        assert_eq!(locator.find([1.0 + 1e-6, 0.5]), None);
    }

    #[test]
    fn points_are_found_in_their_tetrahedra() {
        // a long prism of three tetrahedra beside a small one far away
        let points = [
            [0.0, 0.0, 0.0],
            [1.0, 0.0, 0.0],
            [0.0, 1.0, 0.0],
            [0.0, 0.0, 8.0],
            [1.0, 0.0, 8.0],
            [0.0, 1.0, 8.0],
            [5.0, 5.0, 5.0],
            [5.5, 5.0, 5.0],
            [5.0, 5.5, 5.0],
            [5.0, 5.0, 5.5],
        ];
        let tetrahedra = [[0, 1, 2, 5], [0, 1, 5, 4], [0, 4, 5, 3], [6, 7, 8, 9]];
        let locator = Locator::new(&tetrahedra, &points);
        let found = locator.find([0.25, 0.25, 1.0]).expect("a tetrahedron");
        assert_eq!((found.element, found.weights), (0, [0.5, 0.25, 0.125, 0.125]));
        // where the weights say
        for point in [[0.2, 0.1, 7.5], [0.1, 0.7, 4.0], [5.1, 5.2, 5.1]] {
            let found = locator.find(point).expect("a tetrahedron");
            let corners = Frame::corners(tetrahedra[found.element], &points);
            for axis in 0..3 {
                let at = corners.iter().zip(found.weights).map(|(c, w)| c[axis] * w);
                assert!((at.sum::<f64>() - point[axis]).abs() < 1e-14, "{point:?}");
            }
        }
        assert_eq!(locator.find([5.1, 5.2, 5.1]).map(|l| l.element), Some(3));
        assert_eq!(locator.find([0.6, 0.6, 4.0]), None);
        assert_eq!(locator.find([5.3, 5.3, 5.3]), None);
    }
}
