//! Two blocks that collide.

use super::bodies;
use crate::meshing::{
    MeshingError,
    mesh::Mesh,
    model::Model,
    properties::{Material, count, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Two square blocks in line, the left one with a velocity to the right, without gravity. The
/// origin is in the middle of the gap, at the height of the lower faces.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct TwoBlocks {
    /// Edge of a block \[m\].
    pub edge_m: f64,
    /// Gap between them \[m\].
    pub gap_m: f64,
    /// Cells along an edge, two triangles each.
    pub cells: usize,
    /// Velocity of the left block at the start \[m/s\].
    pub velocity_m_s: f64,
    /// Mass of the right block by that of the left one.
    pub mass_ratio: f64,
    /// The blocks; the density is that of the left one.
    pub material: Material,
}

impl Default for TwoBlocks {
    fn default() -> Self {
        TwoBlocks {
            edge_m: 1.5,
            gap_m: 0.01,
            cells: 1,
            velocity_m_s: 5.0,
            mass_ratio: 1.0,
            material: Material {
                young_pa: 258e6,
                poisson: 0.17,
                density_kg_m3: 2500.0,
                friction: 0.0,
                penalty_pa: 1e9,
                tangential_penalty_pa: 1e8,
                viscosity_pa_s: Some(0.0),
                ..Material::default()
            },
        }
    }
}

impl TwoBlocks {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<Model, MeshingError> {
        positive("two-blocks.edge_m", self.edge_m)?;
        positive("two-blocks.gap_m", self.gap_m)?;
        positive("two-blocks.velocity_m_s", self.velocity_m_s)?;
        positive("two-blocks.mass_ratio", self.mass_ratio)?;
        count("two-blocks.cells", self.cells, 1)?;
        self.material.check("two-blocks.material")?;
        let right = Material {
            density_kg_m3: self.material.density_kg_m3 * self.mass_ratio,
            ..self.material
        };
        let (near, far) = (self.gap_m / 2.0, self.gap_m / 2.0 + self.edge_m);
        let cells = [self.cells, self.cells];
        let mut mesh = Mesh::default();
        let moving = mesh.rectangle([[-far, 0.0], [-near, self.edge_m]], cells, 0)?;
        mesh.rectangle([[near, 0.0], [far, self.edge_m]], cells, 1)?;
        let materials = vec![("left block", self.material), ("right block", right)];
        let mut model = bodies("two blocks in line".to_owned(), mesh, materials);
        model.velocities = moving.map(|node| (node, [self.velocity_m_s, 0.0])).collect();
        model.gravity_m_s2 = 0.0;
        let speed = (self.material.young_pa / self.material.density_kg_m3).sqrt();
        model.settled_s = self.gap_m / self.velocity_m_s + 20.0 * self.edge_m / speed;
        let mass = self.material.density_kg_m3 * self.edge_m * self.edge_m;
        model.notes = vec![format!(
            "masses {mass} kg and {} kg, momentum {} kg m/s",
            mass * self.mass_ratio,
            mass * self.velocity_m_s
        )];
        Ok(model)
    }
}
