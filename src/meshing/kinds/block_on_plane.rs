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

/// A square block on a held plane, with a velocity to the right. It stops after v²/(2 µ g) on a
/// level plane. The origin is under the block's left corner.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct BlockOnPlane {
    /// Edge of the block \[m\].
    pub edge_m: f64,
    /// Cells along an edge of the block, two triangles each.
    pub cells: usize,
    /// Velocity of the block at the start \[m/s\].
    pub velocity_m_s: f64,
    /// Angle at which the plane falls to the right \[°\].
    pub incline_deg: f64,
    /// How far the block may slide \[m\]; as far as it should if it is not given and it stops.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub way_m: Option<f64>,
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
            incline_deg: 0.0,
            way_m: None,
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
        let (sin, cos) = self.incline_deg.to_radians().sin_cos();
        positive("block-on-plane: cosine of incline_deg", cos)?;
        // a negative one speeds the block up
        let braking = self.gravity_m_s2.abs() * (self.material.friction * cos - sin);
        let (stop, duration) = self.way(braking)?;
        let [left, right] = [-self.edge_m, stop + 2.0 * self.edge_m];
        let cells = ((right - left) / self.edge_m).ceil();
        count("block-on-plane: cells of the plane", cells as usize, 1)?;
        let mut mesh = Mesh::default();
        let plane = [[left, -self.edge_m / 2.0], [right, 0.0]];
        let held = mesh.rectangle(plane, [cells as usize, 1], 0)?;
        let block = mesh.rectangle([[0.0; 2], [self.edge_m; 2]], [self.cells, self.cells], 0)?;
        for [x, y] in &mut mesh.nodes {
            [*x, *y] = [*x * cos + *y * sin, *y * cos - *x * sin];
        }
        let mut model = bodies("block on a plane".to_owned(), mesh, vec![("block", self.material)]);
        let (name, nodes) = ("plane".to_owned(), held.collect());
        model.supports = vec![Support { name, nodes, motion: Motion::CLAMPED }];
        model.velocities =
            block.map(|node| (node, [self.velocity_m_s * cos, -self.velocity_m_s * sin])).collect();
        model.gravity_m_s2 = self.gravity_m_s2;
        model.settled_s = 1.2 * duration + 0.05;
        let verb = if braking > 0.0 { "stop after" } else { "have slid" };
        model.notes = vec![format!("the block should {verb} {stop} m, at {duration} s")];
        Ok(model)
    }

    /// How far the block slides, and how long that takes.
    fn way(&self, braking: f64) -> Result<(f64, f64), MeshingError> {
        let v = self.velocity_m_s;
        if braking > 0.0 {
            let stop = v * v / (2.0 * braking);
            return Ok((self.way_m.map_or(stop, |way| way.min(stop)), v / braking));
        }
        let Some(way) = self.way_m else {
            let expected = "needed, because the block does not stop";
            return Err(MeshingError::parameter("block-on-plane.way_m", "none", expected));
        };
        positive("block-on-plane.way_m", way)?;
        // 0.8 of it, so that the block stays on the plane: v t + a t²/2
        let a = positive("block-on-plane: acceleration (m/s²)", -braking).map(|()| -braking)?;
        Ok((way, ((v * v + 1.6 * a * way).sqrt() - v) / a))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_block_lies_on_its_plane() {
        for (incline_deg, way_m) in [(0.0, None), (20.0, None), (40.0, Some(2.0))] {
            let block = BlockOnPlane { incline_deg, way_m, ..BlockOnPlane::default() };
            let model = block.model().expect("a model");
            model.check().expect("a sound mesh");
            let (sin, cos) = incline_deg.to_radians().sin_cos();
            let first = model.supports[0].nodes.len();
            for (node, v) in &model.velocities {
                let [x, y] = model.mesh.nodes[*node];
                assert!(*node >= first && x * sin + y * cos > -1e-12);
                assert!((v[0] * sin + v[1] * cos).abs() < 1e-12);
            }
        }
    }

    #[test]
    fn a_block_that_does_not_stop_needs_a_way() {
        let block = BlockOnPlane { incline_deg: 40.0, ..BlockOnPlane::default() };
        assert!(block.model().expect_err("a fault").to_string().contains("way_m"));
    }
}
