//! Two bars with a gap that a force closes.

use super::{areas, check_size};
use crate::meshing::{
    MeshingError,
    model::{Drive, Motion},
    properties::{Material, count, positive},
    spatial::{mesh::SpatialMesh, model::SpatialModel},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A bar of square section held at its left end and pulled to the right at its other end, and
/// beyond a gap a second bar that is held at its right end. The origin is at the left bar's
/// lower left corner in front.
///
/// With a second bar of half the length the free end of the first one moves u = g (2 + x)/3,
/// x = F l/(E A g), once the gap is closed (x ≥ 1), and u = g x before.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct TwoBars3d {
    /// Length of the left bar l \[m\].
    pub length_m: f64,
    /// Length of the right bar \[m\].
    pub right_length_m: f64,
    /// Height and depth of both \[m\].
    pub height_m: f64,
    /// The gap g \[m\].
    pub gap_m: f64,
    /// Force on the free end F \[N\].
    pub force_n: f64,
    /// Time in which the force grows \[s\].
    pub ramp_s: f64,
    /// Whether the right bar does not move at all.
    pub rigid_right: bool,
    /// Cells along the height; cells are about cubes, six tetrahedra each.
    pub cells: usize,
    /// The bars.
    pub material: Material,
}

impl Default for TwoBars3d {
    fn default() -> Self {
        TwoBars3d {
            length_m: 1.0,
            right_length_m: 0.5,
            height_m: 0.1,
            gap_m: 0.01,
            force_n: 20.0,
            ramp_s: 3.0,
            rigid_right: false,
            cells: 1,
            material: Material {
                young_pa: 100e3,
                poisson: 0.0,
                density_kg_m3: 1000.0,
                friction: 0.0,
                penalty_pa: 1e6,
                tangential_penalty_pa: 1e5,
                viscosity_pa_s: Some(20000.0),
                ..Material::default()
            },
        }
    }
}

impl TwoBars3d {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<SpatialModel, MeshingError> {
        let (length, height) = (self.length_m, self.height_m);
        check_size("two-bars-3d: lengths and height", [length, self.right_length_m, height])?;
        positive("two-bars-3d.gap_m", self.gap_m)?;
        positive("two-bars-3d.ramp_s", self.ramp_s)?;
        count("two-bars-3d.cells", self.cells, 1)?;
        self.material.check("two-bars-3d.material")?;
        let cell = height / self.cells as f64;
        let along = |length: f64| (length / cell).round().max(1.0) as usize;
        let mut mesh = SpatialMesh::default();
        let cells = |n: usize| [n, self.cells, self.cells];
        let left = mesh.add_box([[0.0; 3], [length, height, height]], cells(along(length)), 0)?;
        let start = length + self.gap_m;
        let stop = start + self.right_length_m;
        let ends = [[start, 0.0, 0.0], [stop, height, height]];
        let right = mesh.add_box(ends, cells(along(self.right_length_m)), 0)?;
        let volume = (length + self.right_length_m) * height * height;
        let materials = vec![("bars", self.material)];
        let mut model = SpatialModel::of_bodies("two bars with a gap", mesh, volume, materials);
        let left_end = model.nodes_where(|[x, ..]| x == 0.0);
        let right_end = model.nodes_where(|[x, ..]| x == stop);
        debug_assert!(left_end.iter().all(|node| left.contains(node)));
        model.hold("left end", left_end, Motion::CLAMPED);
        let held = if self.rigid_right { right.collect() } else { right_end };
        model.hold("right end", held, Motion::CLAMPED);
        let history = vec![[0.0, 0.0], [self.ramp_s, 1.0]];
        let pressure = self.force_n / (height * height);
        for (node, area) in areas(&model.mesh, |[x, ..]| x == length) {
            let free = Drive::Force(0.0);
            let drives = [Drive::Force(pressure * area), free, free];
            let motion = Motion { drives, later: None, history: history.clone() };
            model.hold("pulled", vec![node], motion);
        }
        model.gravity_m_s2 = 0.0;
        model.settled_s = 2.0 * self.ramp_s;
        let stiffness = self.material.young_pa * height * height / length;
        model.notes = vec![format!("F l/(E A g) = {}", self.force_n / (stiffness * self.gap_m))];
        Ok(model)
    }
}
