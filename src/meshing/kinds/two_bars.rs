//! Two bars with a gap that a force closes.

use super::bodies;
use crate::meshing::{
    MeshingError,
    mesh::Mesh,
    model::{Drive, Model, Motion, Support},
    properties::{Material, count, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A bar held at its left end and pulled to the right at its other end, and beyond a gap a second
/// bar that is held at its right end. The origin is at the left bar's lower left corner.
///
/// With a second bar of half the length the free end of the first one moves u = g (2 + x)/3,
/// x = F l/(E A g), once the gap is closed (x ≥ 1), and u = g x before.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct TwoBars {
    /// Length of the left bar l \[m\].
    pub length_m: f64,
    /// Length of the right bar \[m\].
    pub right_length_m: f64,
    /// Height of both \[m\].
    pub height_m: f64,
    /// The gap g \[m\].
    pub gap_m: f64,
    /// Force on the free end F \[N\].
    pub force_n: f64,
    /// Time in which the force grows \[s\].
    pub ramp_s: f64,
    /// Whether the right bar does not move at all.
    pub rigid_right: bool,
    /// Cells along the height; cells are about square, two triangles each.
    pub cells: usize,
    /// The bars.
    pub material: Material,
}

impl Default for TwoBars {
    fn default() -> Self {
        TwoBars {
            length_m: 1.0,
            right_length_m: 0.5,
            height_m: 0.1,
            gap_m: 0.01,
            force_n: 20.0,
            ramp_s: 5.0,
            rigid_right: false,
            cells: 1,
            material: Material {
                young_pa: 10e3,
                poisson: 0.0,
                density_kg_m3: 1000.0,
                friction: 0.0,
                penalty_pa: 1e6,
                tangential_penalty_pa: 1e5,
                viscosity_pa_s: Some(2000.0),
                ..Material::default()
            },
        }
    }
}

impl TwoBars {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<Model, MeshingError> {
        for (name, value) in [
            ("two-bars.length_m", self.length_m),
            ("two-bars.right_length_m", self.right_length_m),
            ("two-bars.height_m", self.height_m),
            ("two-bars.gap_m", self.gap_m),
            ("two-bars.ramp_s", self.ramp_s),
        ] {
            positive(name, value)?;
        }
        count("two-bars.cells", self.cells, 1)?;
        self.material.check("two-bars.material")?;
        let cell = self.height_m / self.cells as f64;
        let along = |length: f64| (length / cell).round().max(1.0) as usize;
        let lengths = [along(self.length_m), along(self.right_length_m)];
        lengths.iter().try_for_each(|&n| count("two-bars: cells of a bar", n, 1))?;
        let mut mesh = Mesh::default();
        let (end, height) = (self.length_m, self.height_m);
        let left = mesh.rectangle([[0.0; 2], [end, height]], [lengths[0], self.cells], 0)?;
        let start = end + self.gap_m;
        let stop = start + self.right_length_m;
        let right = mesh.rectangle([[start, 0.0], [stop, height]], [lengths[1], self.cells], 0)?;
        let mut model =
            bodies("two bars with a gap".to_owned(), mesh, vec![("bars", self.material)]);
        let at = |nodes: std::ops::Range<usize>, x: f64, model: &Model| -> Vec<usize> {
            nodes.filter(|&n| model.mesh.nodes[n][0] == x).collect()
        };
        let loaded = at(left.clone(), end, &model);
        let corner = |n: usize| {
            let y = model.mesh.nodes[n][1];
            y == 0.0 || y == height
        };
        // the force is spread evenly over the face: corners have half a cell each
        let history = vec![[0.0, 0.0], [self.ramp_s, 1.0]];
        let pulled = |name: &str, nodes: Vec<usize>, share: f64| Support {
            name: name.to_owned(),
            nodes,
            motion: Motion {
                drives: [Drive::Force(self.force_n * share), Drive::Force(0.0)],
                later: None,
                history: history.clone(),
            },
        };
        let each = 1.0 / self.cells as f64;
        let (corners, between): (Vec<usize>, Vec<usize>) =
            loaded.into_iter().partition(|&n| corner(n));
        let held =
            |name: &str, nodes| Support { name: name.to_owned(), nodes, motion: Motion::CLAMPED };
        let right_held = if self.rigid_right { right.collect() } else { at(right, stop, &model) };
        model.supports = vec![
            held("left end", at(left, 0.0, &model)),
            held("right end", right_held),
            pulled("pulled, corners", corners, each / 2.0),
        ];
        if !between.is_empty() {
            model.supports.push(pulled("pulled", between, each));
        }
        model.gravity_m_s2 = 0.0;
        model.settled_s = 2.0 * self.ramp_s;
        let x = self.force_n * self.length_m / (self.material.young_pa * height * self.gap_m);
        model.notes = vec![format!("F l/(E A g) = {x}")];
        Ok(model)
    }
}
