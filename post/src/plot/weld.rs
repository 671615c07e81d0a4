//! Which corners of triangles belong together.
//!
//! Where joints were inserted every triangle has nodes of its own. Corners belong together if
//! they lay at the same place at the start, are still close, and are of the same material and
//! body.

use std::collections::HashMap;

use crate::results::Frame;

/// How far apart corners may lie at the start, relative to the mean edge.
const SAME_PLACE: f64 = 1e-6;
/// How far apart they may have moved, relative to the mean edge: more is an open crack.
const STILL_CLOSE: f64 = 1e-2;

/// The joint vertex of each corner of each triangle, and how many there are.
pub(super) fn weld(frame: &Frame, initial: &[[f64; 2]]) -> (Vec<[usize; 3]>, usize) {
    let edge = mean_edge(frame, initial);
    let cell = (SAME_PLACE * edge).max(f64::MIN_POSITIVE);
    let mut known: HashMap<(u32, i32, i32), usize> = HashMap::new();
    let mut places: HashMap<[i64; 2], Vec<usize>> = HashMap::new();
    let mut vertices: Vec<(u32, i32, i32)> = Vec::new();
    let at = |points: &[[f64; 2]], node: u32| {
        points.get(node as usize).copied().unwrap_or([f64::NAN; 2])
    };
    let apart = |a: [f64; 2], b: [f64; 2]| (a[0] - b[0]).hypot(a[1] - b[1]);
    let classes = frame
        .elements
        .iter()
        .enumerate()
        .map(|(index, triangle)| {
            let material = frame.property.get(index).copied().unwrap_or(0);
            let body = frame.body.as_ref().and_then(|b| b.get(index)).copied().unwrap_or(0);
            triangle.map(|node| {
                let key = (node, material, body);
                *known.entry(key).or_insert_with(|| {
                    let place = at(initial, node);
                    let [i, j] = place.map(|x| (x / cell).round() as i64);
                    let beside = (-1..=1).flat_map(|di| (-1..=1).map(move |dj| [di, dj]));
                    let near = beside
                        .filter_map(|[di, dj]| {
                            places.get(&[i.saturating_add(di), j.saturating_add(dj)])
                        })
                        .flatten();
                    let same = near.copied().find(|&vertex: &usize| {
                        vertices.get(vertex).is_some_and(|&(other, m, b)| {
                            (m, b) == (material, body)
                                && apart(at(initial, other), place) <= cell
                                && apart(at(&frame.points, other), at(&frame.points, node))
                                    <= STILL_CLOSE * edge
                        })
                    });
                    same.unwrap_or_else(|| {
                        vertices.push(key);
                        places.entry([i, j]).or_default().push(vertices.len() - 1);
                        vertices.len() - 1
                    })
                })
            })
        })
        .collect();
    (classes, vertices.len())
}

fn mean_edge(frame: &Frame, initial: &[[f64; 2]]) -> f64 {
    let mut sum = 0.0;
    for &triangle in &frame.elements {
        let [a, b, c] = Frame::corners(triangle, initial);
        for (p, q) in [(a, b), (b, c), (c, a)] {
            sum += (p[0] - q[0]).hypot(p[1] - q[1]);
        }
    }
    sum / (3 * frame.elements.len()).max(1) as f64
}

/// Values at corners: means over the triangles that meet there, by area.
pub(super) fn averaged(
    frame: &Frame,
    values: &[f64],
    classes: &[[usize; 3]],
    count: usize,
) -> Vec<[f64; 3]> {
    let mut sums = vec![[0.0; 2]; count];
    for ((&triangle, class), &value) in frame.elements.iter().zip(classes).zip(values) {
        let [a, b, c] = Frame::corners(triangle, &frame.points);
        let area = ((b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1])).abs();
        for &vertex in class {
            if let Some(sum) = sums.get_mut(vertex) {
                sum[0] += area * value;
                sum[1] += area;
            }
        }
    }
    let mean = |vertex: usize| sums.get(vertex).map_or(f64::NAN, |[sum, area]| sum / area);
    classes.iter().map(|class| class.map(mean)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Two triangles with nodes of their own along the diagonal of a square.
    fn square(opened: f64, body: Vec<i32>) -> Frame {
        let initial = [[0., 0.], [1., 0.], [1., 1.], [0., 0.], [1., 1.], [0., 1.]];
        let moved = [[0., 0.], [0., 0.], [0., 0.], [0., opened], [0., opened], [0., opened]];
        Frame {
            points: initial.iter().zip(&moved).map(|(x, u)| [x[0] + u[0], x[1] + u[1]]).collect(),
            displacement: Some(moved.to_vec()),
            elements: vec![[0, 1, 2], [3, 4, 5]],
            property: vec![0, 0],
            body: Some(body),
            ..Frame::default()
        }
    }

    #[test]
    fn corners_hold_together_unless_open_or_of_other_bodies() {
        let count = |frame: Frame| weld(&frame, &frame.initial()).1;
        assert_eq!(count(square(1e-4, vec![0, 0])), 4);
        assert_eq!(count(square(0.1, vec![0, 0])), 6);
        assert_eq!(count(square(1e-4, vec![0, 1])), 6);
    }

    #[test]
    fn means_are_by_area() {
        let frame = square(0.0, vec![0, 0]);
        let (classes, count) = weld(&frame, &frame.initial());
        let values = averaged(&frame, &[1.0, 3.0], &classes, count);
        assert_eq!(values, [[2.0, 1.0, 2.0], [2.0, 2.0, 3.0]]);
    }
}
