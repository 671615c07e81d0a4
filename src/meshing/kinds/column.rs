//! Blocks on top of each other.

use super::bodies;
use crate::meshing::{
    MeshingError,
    mesh::Mesh,
    model::{Model, Motion, Support},
    properties::{Material, check_elements, count, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Blocks on top of each other, without mortar. The lowest one is held. The origin is in the
/// middle of its lower face.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Column {
    /// Number of blocks, the held one included.
    pub blocks: usize,
    /// Width of a block \[m\].
    pub width_m: f64,
    /// Height of a block \[m\].
    pub height_m: f64,
    /// Cells along width and height of a block, two triangles each.
    pub cells: [usize; 2],
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// The blocks.
    pub stone: Material,
}

impl Default for Column {
    /// Five blocks of the bridges' stone.
    fn default() -> Self {
        Column {
            blocks: 5,
            width_m: 0.5,
            height_m: 0.25,
            cells: [2, 1],
            gravity_m_s2: -9.81,
            stone: Material { friction: 0.6, ..Material::default() },
        }
    }
}

impl Column {
    /// The column's model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<Model, MeshingError> {
        count("column.blocks", self.blocks, 1)?;
        positive("column.width_m", self.width_m)?;
        positive("column.height_m", self.height_m)?;
        self.cells.iter().try_for_each(|&n| count("column.cells", n, 1))?;
        check_elements(0, &[2, self.blocks, self.cells[0], self.cells[1]])?;
        self.stone.check("column.stone")?;
        let mut mesh = Mesh::default();
        let half = self.width_m / 2.0;
        let mut last = 0..0;
        let mut held = Vec::new();
        for k in 0..self.blocks {
            let [y0, y1] = [k, k + 1].map(|k| k as f64 * self.height_m);
            last = mesh.rectangle([[-half, y0], [half, y1]], self.cells, 0)?;
            if k == 0 {
                held = last.clone().collect();
            }
        }
        let title = format!("column of {} blocks", self.blocks);
        let mut model = bodies(title, mesh, vec![("stone", self.stone)]);
        let roof = self.blocks as f64 * self.height_m;
        model.top = last.filter(|&n| model.mesh.nodes[n][1] == roof).collect();
        let name = "base".to_owned();
        model.supports = vec![Support { name, nodes: held, motion: Motion::CLAMPED }];
        model.top.retain(|_| self.blocks > 1);
        model.gravity_m_s2 = self.gravity_m_s2;
        Ok(model)
    }
}
