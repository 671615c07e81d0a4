//! The upper edge of the bodies.

use super::only_in_the_plane;
use crate::error::PostError;
use crate::results::{Frame, FrameChoice, Results, bounds};
use crate::selection::Selection;
use crate::table::Table;

/// Nodes of the upper edge at chosen times, from left to right: where they were at the start and
/// what they have moved.
///
/// Without a `selection` the upper edge are the ends of all edges of triangles above which, at
/// the start, there is no other triangle; with one, the nodes of the selection.
///
/// # Errors
/// If the bodies are in space, the selection holds no node, there are no displacements, or a file cannot be read.
pub fn top_line(
    results: &mut Results,
    selection: Option<&Selection>,
    times: &[FrameChoice],
) -> Result<Table, PostError> {
    let instead = "`line` from X,Y,Z to X,Y,Z, or `history` at nodes";
    only_in_the_plane(results, "the top line", instead)?;
    let first = results.frame(0)?;
    let initial = first.initial();
    let mut nodes = match selection {
        Some(selection) => selection.nodes(&first.mesh(&initial))?,
        None => upper_nodes(&first, &initial),
    };
    let x = |n: &usize| initial.get(*n).map_or([f64::NAN; 2], |p| *p);
    nodes.sort_by(|a, b| x(a)[0].total_cmp(&x(b)[0]).then(x(a)[1].total_cmp(&x(b)[1])));
    let headings = ["time (s)", "node", "x0 (m)", "y0 (m)", "ux (m)", "uy (m)", "x (m)", "y (m)"];
    let mut table = Table::new(headings);
    for &time in times {
        let frame = results.frame(results.index_of(time)?)?;
        let moved = frame.displacement.as_ref().ok_or(PostError::MissingArray {
            array: "displacements",
            wanted: "the top line".to_owned(),
            remedy: "VTU files and d3plot families of Ypsilon have them",
        })?;
        for &node in &nodes {
            let at = |v: &[[f64; 2]]| v.get(node).copied().unwrap_or([f64::NAN; 2]);
            let (x0, u, x) = (at(&initial), at(moved), at(&frame.points));
            table.rows.push(vec![frame.time, node as f64, x0[0], x0[1], u[0], u[1], x[0], x[1]]);
        }
    }
    Ok(table)
}

/// Ends of the edges that see the sky: straight above their middle there is no triangle.
fn upper_nodes(frame: &Frame, initial: &[[f64; 2]]) -> Vec<usize> {
    let mut chosen = vec![false; initial.len()];
    // triangles ordered by their left ends, so that few have to be looked at for an edge
    let spans: Vec<[f64; 3]> = frame
        .elements
        .iter()
        .map(|&t| {
            let [low, high] = bounds(&Frame::corners(t, initial)).unwrap_or_default();
            [low[0], high[0], high[1]]
        })
        .collect();
    let mut order: Vec<usize> = (0..spans.len()).collect();
    order.sort_by(|&a, &b| spans[a][0].total_cmp(&spans[b][0]));
    let widest = spans.iter().map(|s| s[1] - s[0]).fold(0.0, f64::max);
    for triangle in &frame.elements {
        for edge in 0..3 {
            let (a, b) = (triangle[edge], triangle[(edge + 1) % 3]);
            let corners = Frame::corners([a, b, a], initial);
            let middle = [0, 1].map(|k| 0.5 * (corners[0][k] + corners[1][k]));
            // counter-clockwise triangles: edges that run left have their outside above
            if corners[1][0] >= corners[0][0] {
                continue;
            }
            let size = (corners[1][0] - corners[0][0]).hypot(corners[1][1] - corners[0][1]);
            let from = order.partition_point(|&t| spans[t][0] < middle[0] - widest);
            let covered = order[from..]
                .iter()
                .take_while(|&&t| spans[t][0] <= middle[0])
                .filter(|&&t| spans[t][1] >= middle[0] && spans[t][2] > middle[1])
                .any(|&t| {
                    let other = Frame::corners(frame.elements[t], initial);
                    height_above(other, middle[0]).is_some_and(|y| y > middle[1] + 1e-6 * size)
                });
            if !covered {
                for node in [a, b] {
                    if let Some(slot) = chosen.get_mut(node as usize) {
                        *slot = true;
                    }
                }
            }
        }
    }
    (0..chosen.len()).filter(|&n| chosen[n]).collect()
}

/// Largest height of a triangle at `x`.
fn height_above(corners: [[f64; 2]; 3], x: f64) -> Option<f64> {
    let mut highest = None::<f64>;
    for edge in 0..3 {
        let (a, b) = (corners[edge], corners[(edge + 1) % 3]);
        let (low, high) = if a[0] <= b[0] { (a, b) } else { (b, a) };
        if low[0] <= x && x <= high[0] && low[0] < high[0] {
            let y = low[1] + (high[1] - low[1]) * (x - low[0]) / (high[0] - low[0]);
            highest = Some(highest.map_or(y, |h| h.max(y)));
        }
    }
    highest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_upper_edge_of_a_square_and_a_lintel() {
        let points = vec![
            [0.0, 0.0],
            [1.0, 0.0],
            [1.0, 1.0],
            [0.0, 1.0],
            // a small triangle under the square
            [0.2, -0.5],
            [0.8, -0.5],
            [0.5, -0.2],
        ];
        let triangles = vec![[0, 1, 2], [0, 2, 3], [4, 5, 6]];
        let frame = Frame { points: points.clone(), elements: triangles, ..Frame::default() };
        assert_eq!(upper_nodes(&frame, &points), [2, 3]);
    }
}
