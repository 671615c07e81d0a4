//! A block that slides on a plane.

use super::bodies;
use crate::meshing::{
    MeshingError,
    mesh::Mesh,
    model::{Model, Motion, Support},
    properties::{Material, count, not_negative, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A square block on a held plane, with a velocity to the right. It stops after v²/(2 µ g). The
/// origin is under the block's left corner.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct BlockOnPlane {
    /// Edge of the block \[m\].
    pub edge_m: f64,
    /// Cells along an edge of the block, two triangles each.
    pub cells: usize,
    /// Velocity of the block at the start \[m/s\].
    pub velocity_m_s: f64,
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// Block and plane.
    pub material: Material,
}

impl Default for BlockOnPlane {
    fn default() -> Self {
        BlockOnPlane {
            edge_m: 0.5,
            cells: 1,
            velocity_m_s: 1.0,
            gravity_m_s2: -10.0,
            material: Material {
                young_pa: 300e6,
                poisson: 0.2,
                density_kg_m3: 25000.0,
                friction: 0.5,
                penalty_pa: 3e9,
                tangential_penalty_pa: 3e8,
                ..Material::default()
            },
        }
    }
}

impl BlockOnPlane {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<Model, MeshingError> {
        positive("block-on-plane.edge_m", self.edge_m)?;
        count("block-on-plane.cells", self.cells, 1)?;
        not_negative("block-on-plane.velocity_m_s", self.velocity_m_s)?;
        self.material.check("block-on-plane.material")?;
        let braking = self.material.friction * self.gravity_m_s2.abs();
        positive("block-on-plane: friction times gravity", braking)?;
        let (stop, duration) =
            (self.velocity_m_s.powi(2) / (2.0 * braking), self.velocity_m_s / braking);
        let [left, right] = [-self.edge_m, stop + 2.0 * self.edge_m];
        let cells = ((right - left) / self.edge_m).ceil();
        count("block-on-plane: cells of the plane", cells as usize, 1)?;
        let mut mesh = Mesh::default();
        let plane = [[left, -self.edge_m / 2.0], [right, 0.0]];
        let held = mesh.rectangle(plane, [cells as usize, 1], 0);
        let block = mesh.rectangle([[0.0; 2], [self.edge_m; 2]], [self.cells, self.cells], 0);
        let mut model = bodies("block on a plane".to_owned(), mesh, vec![("block", self.material)]);
        let (name, nodes) = ("plane".to_owned(), held.collect());
        model.supports = vec![Support { name, nodes, motion: Motion::CLAMPED }];
        model.velocities = block.map(|node| (node, [self.velocity_m_s, 0.0])).collect();
        model.gravity_m_s2 = self.gravity_m_s2;
        model.settled_s = 1.2 * duration + 0.05;
        model.notes = vec![format!("the block should stop after {stop} m, at {duration} s")];
        Ok(model)
    }
}
