//! A block that slides on a plane.

use super::{add_body, check_cells};
use crate::meshing::{
    MeshingError,
    model::Motion,
    properties::{Material, positive},
    spatial::{mesh::SpatialMesh, model::SpatialModel},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A cube on a held level plane, with a velocity along. With friction (`--contact-friction`) it
/// stops after v²/(2 µ g). The origin is under the middle of the cube's rear face; z points up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct BlockOnPlane3d {
    /// Edge of the cube \[m\].
    pub edge_m: f64,
    /// Cells of the cube along, across and up, six tetrahedra each; `[0, 0, 0]` for twelve
    /// tetrahedra around a centre.
    pub cells: [usize; 3],
    /// Velocity of the cube at the start \[m/s\].
    pub velocity_m_s: f64,
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// Cube and plane.
    pub material: Material,
}

impl Default for BlockOnPlane3d {
    fn default() -> Self {
        BlockOnPlane3d {
            edge_m: 0.5,
            cells: [1; 3],
            velocity_m_s: 1.0,
            gravity_m_s2: -10.0,
            material: Material {
                young_pa: 300e6,
                poisson: 0.2,
                density_kg_m3: 25000.0,
                friction: 0.5,
                penalty_pa: 3e7,
                tangential_penalty_pa: 3e7,
                ..Material::default()
            },
        }
    }
}

impl BlockOnPlane3d {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<SpatialModel, MeshingError> {
        let edge = self.edge_m;
        positive("block-on-plane-3d.edge_m", edge)?;
        check_cells("block-on-plane-3d.cells", self.cells)?;
        positive("block-on-plane-3d.velocity_m_s", self.velocity_m_s)?;
        self.material.check("block-on-plane-3d.material")?;
        let braking = self.gravity_m_s2.abs() * self.material.friction;
        positive("block-on-plane-3d: friction times gravity", braking)?;
        let v = self.velocity_m_s;
        let (way, duration) = (v * v / (2.0 * braking), v / braking);
        let (left, right) = (-edge, way + 2.0 * edge);
        let cells = ((right - left) / edge).ceil().max(1.0) as usize;
        let mut mesh = SpatialMesh::default();
        let plane = [[left, -edge, -edge], [right, edge, 0.0]];
        let held = mesh.add_box(plane, [cells, 2, 1], 0)?;
        let block = [[0.0, -edge / 2.0, 0.0], [edge, edge / 2.0, edge]];
        let moving = add_body(&mut mesh, block, self.cells, 0)?;
        let volume = (right - left) * 2.0 * edge * edge + edge.powi(3);
        let materials = vec![("block", self.material)];
        let mut model = SpatialModel::of_bodies("block on a plane", mesh, volume, materials);
        model.hold("plane", held.collect(), Motion::CLAMPED);
        model.velocities = moving.map(|node| (node, [v, 0.0, 0.0])).collect();
        model.gravity_m_s2 = self.gravity_m_s2;
        model.settled_s = 1.2 * duration + 0.05;
        model.notes = vec![format!("the block should stop after {way} m, at {duration} s")];
        Ok(model)
    }
}
