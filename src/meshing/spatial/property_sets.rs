//! Property sets of structures in space: materials by colour.

use super::model::SpatialModel;
use crate::meshing::{
    colouring::colour,
    model::Bond,
    property_sets::{PropertySet, PropertySets},
};
use std::collections::BTreeSet;

/// The sets of a model, one for each material and colour that occurs, and the tetrahedra's
/// numbers of them.
pub(super) fn sets(model: &SpatialModel) -> PropertySets {
    let mesh = &model.mesh;
    let colours = colours(model);
    let key = |t: &super::Tetrahedron| {
        let blocks = model.joints.is_some() && model.substances[t.material].bond == Bond::Blocks;
        (t.material, if blocks { colours[t.block] } else { 0 })
    };
    let mut keys: Vec<_> = mesh.tetrahedra.iter().map(key).collect();
    keys.sort_unstable();
    keys.dedup();
    let heights = mean_heights(model);
    let set = |&(substance, colour): &(usize, usize)| {
        let material = model.substances[substance].material;
        let viscosity_pa_s = material.viscosity(heights[substance]);
        PropertySet { substance, colour, small: false, material, viscosity_pa_s }
    };
    let number = |t| keys.binary_search(&key(t)).unwrap_or_default();
    let of_triangle = mesh.tetrahedra.iter().map(number).collect();
    PropertySets { sets: keys.iter().map(set).collect(), of_triangle }
}

/// A colour for each block: blocks that share a face have different ones.
fn colours(model: &SpatialModel) -> Vec<usize> {
    let mut neighbours = vec![BTreeSet::new(); model.mesh.blocks];
    for sides in model.mesh.faces().values() {
        if let [a, b] = sides[..] {
            let [a, b] = [a, b].map(|side| model.mesh.tetrahedra[side].block);
            if a != b {
                neighbours[a].insert(b);
                neighbours[b].insert(a);
            }
        }
    }
    colour(&neighbours)
}

/// Mean of the shortest heights of the tetrahedra of each material \[m\].
fn mean_heights(model: &SpatialModel) -> Vec<f64> {
    let mut sums = vec![(0.0, 0.0); model.substances.len()];
    for tetrahedron in &model.mesh.tetrahedra {
        let (sum, count) = &mut sums[tetrahedron.material];
        *sum += model.mesh.height(tetrahedron);
        *count += 1.0;
    }
    sums.into_iter().map(|(sum, count)| if count > 0.0 { sum / count } else { 1.0 }).collect()
}
