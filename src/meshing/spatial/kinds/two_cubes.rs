//! Two cubes that collide.

use super::{add_body, check_cells};
use crate::meshing::{
    MeshingError,
    properties::{Material, positive},
    spatial::{mesh::SpatialMesh, model::SpatialModel},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Two cubes in line, the left one with a velocity to the right, without gravity. The origin is in
/// the middle of the gap, in the middle below.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct TwoCubes3d {
    /// Edge of a cube \[m\].
    pub edge_m: f64,
    /// Gap between them \[m\].
    pub gap_m: f64,
    /// Cells along, across and up, six tetrahedra each; `[0, 0, 0]` for twelve tetrahedra around
    /// a centre.
    pub cells: [usize; 3],
    /// Velocity of the left cube at the start \[m/s\].
    pub velocity_m_s: f64,
    /// Mass of the right cube by that of the left one.
    pub mass_ratio: f64,
    /// How far the right cube is shifted across and up \[m\].
    pub shift_m: [f64; 2],
    /// Whether the right cube comes first in the deck, so that the faces of the left one are
    /// pressed by one-sided contact.
    pub right_first: bool,
    /// The cubes; the density is that of the left one.
    pub material: Material,
}

impl Default for TwoCubes3d {
    fn default() -> Self {
        TwoCubes3d {
            edge_m: 1.5,
            gap_m: 0.01,
            cells: [0; 3],
            velocity_m_s: 5.0,
            mass_ratio: 1.0,
            shift_m: [0.0; 2],
            right_first: false,
            material: Material {
                young_pa: 258e6,
                poisson: 0.17,
                density_kg_m3: 5625.0 / 3.375,
                friction: 0.0,
                penalty_pa: 1e9,
                tangential_penalty_pa: 1e8,
                viscosity_pa_s: Some(0.0),
                ..Material::default()
            },
        }
    }
}

impl TwoCubes3d {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<SpatialModel, MeshingError> {
        let edge = self.edge_m;
        positive("two-cubes-3d.edge_m", edge)?;
        positive("two-cubes-3d.gap_m", self.gap_m)?;
        positive("two-cubes-3d.velocity_m_s", self.velocity_m_s)?;
        positive("two-cubes-3d.mass_ratio", self.mass_ratio)?;
        check_cells("two-cubes-3d.cells", self.cells)?;
        self.material.check("two-cubes-3d.material")?;
        let density_kg_m3 = self.material.density_kg_m3 * self.mass_ratio;
        let right = Material { density_kg_m3, ..self.material };
        let (near, far) = (self.gap_m / 2.0, self.gap_m / 2.0 + edge);
        let [dy, dz] = self.shift_m;
        let half = edge / 2.0;
        let left_ends = [[-far, -half, 0.0], [-near, half, edge]];
        let right_ends = [[near, dy - half, dz], [far, dy + half, dz + edge]];
        let mut mesh = SpatialMesh::default();
        let moving = if self.right_first {
            add_body(&mut mesh, right_ends, self.cells, 1)?;
            add_body(&mut mesh, left_ends, self.cells, 0)?
        } else {
            let moving = add_body(&mut mesh, left_ends, self.cells, 0)?;
            add_body(&mut mesh, right_ends, self.cells, 1)?;
            moving
        };
        let materials = vec![("left cube", self.material), ("right cube", right)];
        let volume = 2.0 * edge.powi(3);
        let mut model = SpatialModel::of_bodies("two cubes in line", mesh, volume, materials);
        model.velocities = moving.map(|node| (node, [self.velocity_m_s, 0.0, 0.0])).collect();
        model.gravity_m_s2 = 0.0;
        let speed = (self.material.young_pa / self.material.density_kg_m3).sqrt();
        model.settled_s = self.gap_m / self.velocity_m_s + 20.0 * edge / speed;
        let mass = self.material.density_kg_m3 * edge.powi(3);
        model.notes = vec![format!(
            "masses {mass} kg and {} kg, momentum {} kg m/s",
            mass * self.mass_ratio,
            mass * self.velocity_m_s
        )];
        Ok(model)
    }
}
