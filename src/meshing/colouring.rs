//! Colours for blocks such that neighbours differ, and for triangles by size.

use super::mesh::Mesh;
use std::collections::{BTreeMap, BTreeSet};

/// A colour for each block: blocks of one material that share an edge have different ones.
///
/// The block with the most differently coloured neighbours comes next and takes the first colour
/// that is free (Brélaz). Masonry needs three or four.
pub(super) fn colours(mesh: &Mesh) -> Vec<usize> {
    colour(&neighbours(mesh))
}

/// A colour for each of some things such that neighbours have different ones.
pub(super) fn colour(neighbours: &[BTreeSet<usize>]) -> Vec<usize> {
    let count = neighbours.len();
    let mut colours: Vec<Option<usize>> = vec![None; count];
    let mut forbidden: Vec<BTreeSet<usize>> = vec![BTreeSet::new(); count];
    let mut open: BTreeSet<usize> = (0..count).collect();
    while let Some(&block) = open
        .iter()
        .max_by_key(|&&b| (forbidden[b].len(), neighbours[b].len(), std::cmp::Reverse(b)))
    {
        open.remove(&block);
        let free = (0..).find(|c| !forbidden[block].contains(c)).unwrap_or_default();
        colours[block] = Some(free);
        for &other in &neighbours[block] {
            forbidden[other].insert(free);
        }
    }
    colours.into_iter().map(Option::unwrap_or_default).collect()
}

/// Blocks of the same material that share an edge with each block.
fn neighbours(mesh: &Mesh) -> Vec<BTreeSet<usize>> {
    let mut at: BTreeMap<[usize; 2], usize> = BTreeMap::new();
    let mut neighbours = vec![BTreeSet::new(); mesh.blocks];
    for (index, triangle) in mesh.triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (triangle.nodes[k], triangle.nodes[(k + 1) % 3]);
            if let Some(other) = at.insert([a.min(b), a.max(b)], index) {
                let other = &mesh.triangles[other];
                if other.block != triangle.block && other.material == triangle.material {
                    neighbours[triangle.block].insert(other.block);
                    neighbours[other.block].insert(triangle.block);
                }
            }
        }
    }
    neighbours
}

/// Triangles whose shortest height is below this part of the mean of their material belong to the
/// small ones.
pub(super) const SMALL: f64 = 0.7;

/// Mean of the shortest heights of the triangles of each material \[m\].
pub(super) fn mean_heights(mesh: &Mesh, materials: usize) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0); materials];
    for triangle in &mesh.triangles {
        let (sum, count) = &mut sums[triangle.material];
        *sum += mesh.height(triangle);
        *count += 1.0;
    }
    sums.into_iter().map(|(sum, count)| if count > 0.0 { sum / count } else { 1.0 }).collect()
}
