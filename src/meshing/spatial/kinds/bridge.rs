//! Arch bridges across their whole depth.

use crate::meshing::{
    MeshingError,
    colouring::colours,
    kinds::Bridge,
    model::{Drive, Motion},
    properties::{count, positive},
    spatial::{mesh::SpatialMesh, model::SpatialModel},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;

/// An arch bridge drawn out across its depth. Each block of its section is a row of bricks, two
/// layers deep; those of every other colour are shifted by one layer, so that bricks overlap
/// across the depth as well.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Bridge3d {
    /// Depth of the bridge \[m\].
    pub depth_m: f64,
    /// Layers across the depth, three tetrahedra for each triangle of the section; even.
    pub layers: usize,
    /// The section.
    pub section: Bridge,
}

impl Default for Bridge3d {
    fn default() -> Self {
        Bridge3d { depth_m: 2.0, layers: 2, section: Bridge::default() }
    }
}

impl Bridge3d {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<SpatialModel, MeshingError> {
        positive("bridge-3d.depth_m", self.depth_m)?;
        count("bridge-3d.layers", self.layers, 2)?;
        if self.layers % 2 == 1 {
            let expected = "an even number is needed: bricks are two layers deep";
            return Err(MeshingError::parameter("bridge-3d.layers", self.layers, expected));
        }
        let section = self.section.model()?;
        section.check()?;
        let colours = colours(&section.mesh);
        let rows = self.layers / 2 + 1;
        let block = |triangle: &crate::meshing::Triangle, layer: usize| {
            triangle.block * rows + (layer + colours[triangle.block] % 2) / 2
        };
        let mut mesh = SpatialMesh::drawn_out(&section.mesh, self.depth_m, self.layers, block)?;
        number_blocks(&mut mesh);
        let nodes = section.mesh.nodes.len();
        let mut model = SpatialModel {
            contact_at_cracks: false,
            title: format!("{}, {} m deep", section.title, self.depth_m),
            volume: section.area * self.depth_m,
            bodies: section.bodies,
            mesh,
            substances: section.substances,
            joints: section.joints,
            supports: Vec::new(),
            velocities: BTreeMap::new(),
            start: BTreeMap::new(),
            settled_s: section.settled_s,
            gravity_m_s2: section.gravity_m_s2,
            notes: section.notes,
        };
        for support in section.supports {
            let own = (0..=self.layers)
                .flat_map(|layer| support.nodes.iter().map(move |node| layer * nodes + node));
            let [along, up] = support.motion.drives;
            let held = matches!(along, Drive::Velocity(_)) && matches!(up, Drive::Velocity(_));
            let across = if held { Drive::Velocity(0.0) } else { Drive::Force(0.0) };
            let drives = [along, across, up];
            let motion = Motion { drives, later: None, history: support.motion.history };
            model.hold(&support.name, own.collect(), motion);
        }
        Ok(model)
    }
}

/// Numbers the blocks that there are without gaps.
fn number_blocks(mesh: &mut SpatialMesh) {
    let mut numbers = BTreeMap::new();
    for tetrahedron in &mut mesh.tetrahedra {
        let next = numbers.len();
        tetrahedron.block = *numbers.entry(tetrahedron.block).or_insert(next);
    }
    mesh.blocks = numbers.len();
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    /// Blocks that meet in the section lie behind each other with shifted ends.
    #[test]
    fn bricks_are_staggered_across_the_depth() {
        let bridge = Bridge3d { layers: 4, ..Bridge3d::default() };
        let model = bridge.model().expect("a model");
        model.check().expect("a sound mesh");
        let step = bridge.depth_m / bridge.layers as f64;
        let mut ends: BTreeSet<(i64, usize)> = BTreeSet::new();
        for t in &model.mesh.tetrahedra {
            let y = model.mesh.corners(t).map(|p| p[1]).into_iter().fold(f64::INFINITY, f64::min);
            ends.insert(((y / step).round() as i64, t.block));
        }
        let firsts: BTreeSet<i64> = model
            .mesh
            .tetrahedra
            .iter()
            .map(|t| t.block)
            .collect::<BTreeSet<_>>()
            .iter()
            .filter_map(|&block| ends.iter().find(|(_, b)| *b == block).map(|(y, _)| *y))
            .collect();
        assert_eq!(firsts, (0..bridge.layers as i64).collect(), "rows begin in every layer");
    }
}
