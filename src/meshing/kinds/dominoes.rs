//! Dominoes that topple one after the other.

use super::bodies;
use crate::meshing::{
    MeshingError,
    mesh::Mesh,
    model::{Model, Motion, Support},
    properties::{Material, check_elements, count, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A row of dominoes on a held floor; the first one is pushed to the right. The origin is the
/// first one's lower right corner.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Dominoes {
    /// Number of dominoes.
    pub number: usize,
    /// Thickness of a domino \[m\].
    pub thickness_m: f64,
    /// Height of a domino \[m\].
    pub height_m: f64,
    /// Gap between neighbours \[m\].
    pub gap_m: f64,
    /// Angular velocity of the first domino at the start, about its lower right corner \[rad/s\].
    pub push_rad_s: f64,
    /// Whether lower right corners are hinged to the floor, so that no domino slips.
    pub hinged: bool,
    /// Cells along thickness and height, two triangles each.
    pub cells: [usize; 2],
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// Dominoes and floor.
    pub material: Material,
}

impl Default for Dominoes {
    /// Dominoes 48 mm high.
    fn default() -> Self {
        Dominoes {
            number: 20,
            thickness_m: 0.0075,
            height_m: 0.048,
            gap_m: 0.016,
            push_rad_s: 3.0,
            hinged: true,
            cells: [1, 6],
            gravity_m_s2: -9.81,
            material: Material {
                young_pa: 1e7,
                density_kg_m3: 1000.0,
                friction: 0.0,
                penalty_pa: 1e7,
                tangential_penalty_pa: 1e6,
                ..Material::default()
            },
        }
    }
}

impl Dominoes {
    /// The model. Block 0 is the floor, dominoes follow from left to right.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<Model, MeshingError> {
        count("dominoes.number", self.number, 1)?;
        positive("dominoes.thickness_m", self.thickness_m)?;
        positive("dominoes.height_m", self.height_m)?;
        positive("dominoes.gap_m", self.gap_m)?;
        positive("dominoes.push_rad_s", self.push_rad_s)?;
        positive("dominoes: height less gap (m)", self.height_m - self.gap_m)?;
        self.cells.iter().try_for_each(|&n| count("dominoes.cells", n, 1))?;
        check_elements(0, &[2, self.number, self.cells[0], self.cells[1]])?;
        self.material.check("dominoes.material")?;
        let pitch = self.thickness_m + self.gap_m;
        let mut mesh = Mesh::default();
        let [left, right] =
            [-2.0 * pitch, (self.number - 1) as f64 * pitch + self.height_m + 2.0 * pitch];
        let cells = ((right - left) / pitch).ceil();
        count("dominoes: cells of the floor", cells as usize, 1)?;
        let floor = mesh.rectangle([[left, -pitch], [right, 0.0]], [cells as usize, 1], 0)?;
        let mut hinges = Vec::new();
        let mut first = 0..0;
        for k in 0..self.number {
            let x = k as f64 * pitch;
            let corners = [[x - self.thickness_m, 0.0], [x, self.height_m]];
            let nodes = mesh.rectangle(corners, self.cells, 0)?;
            hinges.push(nodes.start + self.cells[0]);
            if k == 0 {
                first = nodes;
            }
        }
        let title = format!("{} dominoes", self.number);
        let mut model = bodies(title, mesh, vec![("dominoes", self.material)]);
        let spin = |node: usize| {
            let [x, y] = model.mesh.nodes[node];
            (node, [self.push_rad_s * y, -self.push_rad_s * x])
        };
        model.velocities = first.map(spin).collect();
        let clamped =
            |name: &str, nodes| Support { name: name.to_owned(), nodes, motion: Motion::CLAMPED };
        model.supports = vec![clamped("floor", floor.collect())];
        if self.hinged {
            model.supports.push(clamped("hinges", hinges));
        }
        model.gravity_m_s2 = self.gravity_m_s2;
        let speed = (self.gravity_m_s2.abs() * self.height_m).sqrt();
        model.settled_s = 1.0 / self.push_rad_s + self.number as f64 * pitch / speed;
        Ok(model)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dominoes_stand_apart_on_their_floor() {
        let dominoes = Dominoes::default();
        let model = dominoes.model().expect("a model");
        model.check().expect("a sound mesh");
        assert_eq!(model.mesh.blocks, 21);
        for (k, &hinge) in model.supports[1].nodes.iter().enumerate() {
            let [x, y] = model.mesh.nodes[hinge];
            assert!((x - k as f64 * 0.0235).abs() < 1e-12 && y == 0.0);
        }
        assert_eq!(model.velocities.len(), 14);
        assert_eq!(model.velocities[&model.supports[1].nodes[0]], [0.0; 2]);
    }

    #[test]
    fn dominoes_that_cannot_reach_each_other_are_refused() {
        let dominoes = Dominoes { gap_m: 0.05, ..Dominoes::default() };
        assert!(dominoes.model().expect_err("a fault").to_string().contains("height less gap"));
    }
}
