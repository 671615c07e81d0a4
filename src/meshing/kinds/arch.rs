//! An arch of dry voussoirs.

use super::bodies;
use crate::meshing::{
    MeshingError,
    mesh::Mesh,
    model::{Model, Motion, Support},
    pattern::Point,
    properties::{Material, check_elements, count, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A circular arch of equal dry voussoirs between two held blocks, under its own weight. The
/// origin is the centre of the circle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Arch {
    /// Radius of the centre line \[m\].
    pub radius_m: f64,
    /// Thickness \[m\].
    pub thickness_m: f64,
    /// Angle from springing to springing \[°\]; 180 for a semicircle.
    pub opening_deg: f64,
    /// Number of voussoirs; with an even number there is a joint at the crown.
    pub voussoirs: usize,
    /// Cells along the arch and across its thickness of a voussoir, two triangles each.
    pub cells: [usize; 2],
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// The voussoirs and the held blocks.
    pub stone: Material,
}

impl Default for Arch {
    /// A semicircle that stands.
    fn default() -> Self {
        Arch {
            radius_m: 1.0,
            thickness_m: 0.15,
            opening_deg: 180.0,
            voussoirs: 20,
            cells: [1, 2],
            gravity_m_s2: -9.81,
            stone: Material {
                young_pa: 1e9,
                friction: 1.0,
                penalty_pa: 2e9,
                tangential_penalty_pa: 1e9,
                ..Material::default()
            },
        }
    }
}

impl Arch {
    /// The arch's model. Blocks 0 and 1 are the held ones at the left and the right, voussoirs
    /// follow from left to right.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<Model, MeshingError> {
        positive("arch.radius_m", self.radius_m)?;
        positive("arch.thickness_m", self.thickness_m)?;
        positive("arch: inner radius (m)", self.radius_m - self.thickness_m / 2.0)?;
        positive("arch.opening_deg", self.opening_deg)?;
        positive("arch: 270° less opening_deg", 270.0 - self.opening_deg)?;
        count("arch.voussoirs", self.voussoirs, 2)?;
        self.cells.iter().try_for_each(|&n| count("arch.cells", n, 1))?;
        check_elements(0, &[2, self.voussoirs, self.cells[0], self.cells[1]])?;
        self.stone.check("arch.stone")?;
        let half = self.opening_deg.to_radians() / 2.0;
        let radii = [-1.0, 1.0].map(|s| self.radius_m + s * self.thickness_m / 2.0);
        let mut mesh = Mesh::default();
        // held blocks are twice as thick as the arch, so that no voussoir slips off
        let wide = [-1.0, 1.0].map(|s| self.radius_m + s * self.thickness_m);
        let cells = [1, 2 * self.cells[1]];
        let depth = self.thickness_m;
        let mut held = Vec::new();
        for side in [-1.0, 1.0] {
            // along the tangent at the springing, away from the arch
            let along = if side < 0.0 { [-depth, 0.0] } else { [0.0, depth] };
            let [[x0, y0], [x1, y1]] = [[along[0], wide[0]], [along[1], wide[1]]];
            let nodes = mesh.rectangle([[x0, y0], [x1, y1]], cells, 0)?;
            for node in nodes.clone() {
                let [s, r] = mesh.nodes[node];
                let [sin, cos] = [(side * half).sin(), (side * half).cos()];
                mesh.nodes[node] = [r * sin + s * cos, r * cos - s * sin];
            }
            held.extend(nodes);
        }
        let n = self.voussoirs as f64;
        let mut crown = Vec::new();
        for k in 0..self.voussoirs {
            // twice the number of the joint, from the crown, so that both halves are mirrored
            let [from, to] = [k, k + 1].map(|k| 2.0 * k as f64 - n);
            let nodes = mesh.rectangle([[from, radii[0]], [to, radii[1]]], self.cells, 0)?;
            for node in nodes {
                let [twice, r] = mesh.nodes[node];
                mesh.nodes[node] = polar(r, half * (twice / n));
                let crown_joint = twice == 0.0 || (twice.abs() < 1.0 && self.cells[0] == 1);
                if r == radii[1] && crown_joint {
                    crown.push(node);
                }
            }
        }
        let degrees = self.opening_deg;
        let title = format!("arch of {} dry voussoirs over {degrees}°", self.voussoirs);
        let mut model = bodies(title, mesh, vec![("stone", self.stone)]);
        model.top = crown;
        let name = "held blocks".to_owned();
        model.supports = vec![Support { name, nodes: held, motion: Motion::CLAMPED }];
        model.gravity_m_s2 = self.gravity_m_s2;
        model.settled_s = 10.0 * (self.radius_m / self.gravity_m_s2.abs().max(1e-3)).sqrt();
        let ratio = self.thickness_m / self.radius_m;
        model.notes = vec![format!("thickness by radius {ratio:.4}")];
        Ok(model)
    }
}

/// A point at a radius, at an angle from the vertical.
fn polar(r: f64, angle: f64) -> Point {
    [r * angle.sin(), r * angle.cos()]
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn voussoirs_are_equal_and_mirrored() {
        for voussoirs in [7, 20] {
            let arch = Arch { voussoirs, ..Arch::default() };
            let model = arch.model().expect("a model");
            model.check().expect("a sound mesh");
            assert_eq!(model.mesh.blocks, voussoirs + 2);
            let mut areas = vec![0.0; model.mesh.blocks];
            model.mesh.triangles.iter().for_each(|t| areas[t.block] += model.mesh.area(t));
            // quadrilaterals with straight edges between two radii
            let angle = std::f64::consts::PI / voussoirs as f64;
            let expected = angle.sin() / 2.0 * (1.075f64.powi(2) - 0.925f64.powi(2));
            assert!(areas[2..].iter().all(|a| (a - expected).abs() < 1e-12), "{areas:?}");
            let nodes = &model.mesh.nodes;
            let mirrored = |&[x, y]: &Point| {
                nodes.iter().any(|p| (p[0] + x).abs() < 1e-14 && (p[1] - y).abs() < 1e-14)
            };
            assert!(nodes.iter().all(mirrored));
        }
    }

    #[test]
    fn joints_are_closed() {
        let model = Arch::default().model().expect("a model");
        // every node of a voussoir's joint has a partner in the next one
        let inner = model.supports[0].nodes.len()..model.mesh.nodes.len();
        let alone = inner
            .clone()
            .filter(|&n| {
                let p = model.mesh.nodes[n];
                !inner.clone().any(|m| {
                    m != n && {
                        let q = model.mesh.nodes[m];
                        (p[0] - q[0]).hypot(p[1] - q[1]) < 1e-12
                    }
                })
            })
            .count();
        assert_eq!(alone, 6, "the two springings have three nodes each");
    }

    #[test]
    fn an_arch_thicker_than_its_radius_is_refused() {
        let arch = Arch { thickness_m: 2.0, ..Arch::default() };
        assert!(arch.model().expect_err("a fault").to_string().contains("inner radius"));
    }
}
