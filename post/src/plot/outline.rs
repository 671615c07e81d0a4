//! Edges of bodies.

use std::collections::BTreeMap;

use crate::results::Frame;

/// Edges that belong to one triangle only: the surface of bodies, open cracks and the borders
/// between materials, as pairs of points.
pub(super) fn outline(
    frame: &Frame,
    classes: &[[usize; 3]],
    points: &[[f64; 2]],
) -> Vec<Vec<[f64; 2]>> {
    let mut edges: BTreeMap<[usize; 2], (u32, [u32; 2])> = BTreeMap::new();
    for (triangle, class) in frame.elements.iter().zip(classes) {
        for k in 0..3 {
            let next = (k + 1) % 3;
            let mut key = [class[k], class[next]];
            key.sort_unstable();
            let edge = edges.entry(key).or_insert((0, [triangle[k], triangle[next]]));
            edge.0 += 1;
        }
    }
    let alone = edges.into_values().filter(|(count, _)| *count == 1);
    alone.map(|(_, [a, b])| Frame::corners([a, b, a], points)[..2].to_vec()).collect()
}
