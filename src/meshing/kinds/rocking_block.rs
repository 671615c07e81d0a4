//! A block that rocks on a plane.

use super::bodies;
use crate::meshing::{
    MeshingError,
    mesh::Mesh,
    model::{Model, Motion, Support},
    properties::{Material, count, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A slender block that is tilted about its lower left corner and let go on a held plane. The
/// origin is that corner.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct RockingBlock {
    /// Width \[m\].
    pub width_m: f64,
    /// Height \[m\].
    pub height_m: f64,
    /// Tilt at the start by the angle at which it would fall over.
    pub tilt: f64,
    /// Cells along width and height, two triangles each.
    pub cells: [usize; 2],
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// Block and plane.
    pub material: Material,
}

impl Default for RockingBlock {
    fn default() -> Self {
        RockingBlock {
            width_m: 0.2,
            height_m: 1.0,
            tilt: 0.5,
            cells: [2, 5],
            gravity_m_s2: -9.81,
            material: Material {
                young_pa: 10e9,
                density_kg_m3: 2500.0,
                friction: 1.0,
                penalty_pa: 10e9,
                tangential_penalty_pa: 1e9,
                ..Material::default()
            },
        }
    }
}

impl RockingBlock {
    /// Half the diagonal \[m\].
    #[must_use]
    pub fn radius_m(&self) -> f64 {
        self.width_m.hypot(self.height_m) / 2.0
    }

    /// The tilt at which the block would fall over.
    #[must_use]
    pub fn slenderness(&self) -> f64 {
        (self.width_m / self.height_m).atan()
    }

    /// Housner's frequency p = √(3 g / 4 R) \[1/s\].
    #[must_use]
    pub fn frequency_1_s(&self) -> f64 {
        (0.75 * self.gravity_m_s2.abs() / self.radius_m()).sqrt()
    }

    /// The model. Block 0 is the plane.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<Model, MeshingError> {
        positive("rocking-block.width_m", self.width_m)?;
        positive("rocking-block.height_m", self.height_m)?;
        positive("rocking-block.tilt", self.tilt)?;
        positive("rocking-block: 1 less tilt", 1.0 - self.tilt)?;
        positive("rocking-block: gravity (m/s²)", self.gravity_m_s2.abs())?;
        self.cells.iter().try_for_each(|&n| count("rocking-block.cells", n, 1))?;
        self.material.check("rocking-block.material")?;
        let (w, h) = (self.width_m, self.height_m);
        let mut mesh = Mesh::default();
        let cells = [6 * self.cells[0], self.cells[0]];
        let plane = mesh.rectangle([[-1.5 * w, -w / 2.0], [1.5 * w + w, 0.0]], cells, 0)?;
        let block = mesh.rectangle([[0.0; 2], [w, h]], self.cells, 0)?;
        let (sin, cos) = (self.tilt * self.slenderness()).sin_cos();
        for node in block {
            let [x, y] = mesh.nodes[node];
            mesh.nodes[node] = [x * cos - y * sin, x * sin + y * cos];
        }
        let mut model = bodies("rocking block".to_owned(), mesh, vec![("block", self.material)]);
        let (name, nodes) = ("plane".to_owned(), plane.collect());
        model.supports = vec![Support { name, nodes, motion: Motion::CLAMPED }];
        model.gravity_m_s2 = self.gravity_m_s2;
        let quarter = (1.0 / (1.0 - self.tilt)).acosh() / self.frequency_1_s();
        model.settled_s = 5.0 * quarter;
        model.notes = vec![format!("a quarter of Housner's period is {quarter:.4} s")];
        Ok(model)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_block_is_tilted_about_its_corner() {
        let block = RockingBlock::default();
        let model = block.model().expect("a model");
        model.check().expect("a sound mesh");
        assert!((model.mesh.total_area() - (0.2 + 0.8 * 0.1)).abs() < 1e-12);
        let first = model.supports[0].nodes.len();
        assert_eq!(model.mesh.nodes[first], [0.0; 2]);
        let [x, y] = model.mesh.nodes[first + 2];
        assert!((y.atan2(x) - 0.5 * 0.2f64.atan()).abs() < 1e-14);
        assert!(model.mesh.nodes[first..].iter().all(|p| p[1] >= 0.0));
    }

    #[test]
    fn a_block_that_falls_over_is_refused() {
        assert!(RockingBlock { tilt: 1.0, ..RockingBlock::default() }.model().is_err());
    }
}
