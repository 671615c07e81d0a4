//! A cube or box.

use super::{add_body, areas, check_cells, check_size};
use crate::meshing::{
    MeshingError,
    kinds::Held,
    model::{Drive, Motion},
    properties::{Material, not_negative, positive},
    spatial::{
        mesh::{Place, SpatialMesh},
        model::SpatialModel,
    },
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A box that is deformed in a known way, pressed, or left to its weight. The origin is in the
/// middle of its lower face; z points up.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Cube3d {
    /// Lengths along, across and up \[m\].
    pub size_m: [f64; 3],
    /// Cells along, across and up, six tetrahedra each; `[0, 0, 0]` for twelve tetrahedra: eight
    /// corners and a centre.
    pub cells: [usize; 3],
    /// Deformation gradient, row by row, about the origin: where the box is at the start, or
    /// where its faces are driven to if they are held.
    pub gradient: [[f64; 3]; 3],
    /// What is held: `free`, `base` (lower face clamped), `confined` (lower face and sides on
    /// rollers), `faces` (all faces driven to what the gradient says).
    pub held: Held,
    /// Pressure on the upper face, as forces on its undeformed area \[Pa\].
    pub pressure_pa: f64,
    /// Time in which faces are driven and the pressure grows \[s\].
    pub ramp_s: f64,
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// What it is made of.
    pub material: Material,
}

const IDENTITY: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

impl Default for Cube3d {
    /// The cube of the thesis's first validations.
    fn default() -> Self {
        Cube3d {
            size_m: [1.0; 3],
            cells: [0; 3],
            gradient: IDENTITY,
            held: Held::Free,
            pressure_pa: 0.0,
            ramp_s: 0.01,
            gravity_m_s2: 0.0,
            material: Material {
                young_pa: 26e9,
                poisson: 0.0,
                density_kg_m3: 1000.0,
                penalty_pa: 26e9,
                tangential_penalty_pa: 2.6e9,
                ..Material::default()
            },
        }
    }
}

impl Cube3d {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<SpatialModel, MeshingError> {
        check_size("cube-3d.size_m", self.size_m)?;
        check_cells("cube-3d.cells", self.cells)?;
        positive("cube-3d.ramp_s", self.ramp_s)?;
        not_negative("cube-3d.pressure_pa", self.pressure_pa.abs())?;
        self.material.check("cube-3d.material")?;
        let [a, b, c] = self.gradient;
        let determinant =
            crate::meshing::spatial::mesh::dot(crate::meshing::spatial::mesh::cross(a, b), c);
        positive("cube-3d: determinant of the gradient", determinant)?;
        let [x, y, z] = self.size_m;
        let mut mesh = SpatialMesh::default();
        let ends = [[-x / 2.0, -y / 2.0, 0.0], [x / 2.0, y / 2.0, z]];
        add_body(&mut mesh, ends, self.cells, 0)?;
        let materials = vec![("box", self.material)];
        let mut model = SpatialModel::of_bodies("box", mesh, x * y * z, materials);
        if self.held == Held::Faces {
            self.drive(&mut model);
        } else {
            self.start(&mut model);
            self.hold(&mut model);
        }
        model.gravity_m_s2 = self.gravity_m_s2;
        model.settled_s = 2.0 * self.ramp_s;
        Ok(model)
    }

    /// Where the gradient puts a point.
    fn image(&self, p: Place) -> Place {
        self.gradient.map(|row| row[0] * p[0] + row[1] * p[1] + row[2] * p[2])
    }

    /// Whether a point is on a side along or across.
    fn sides(&self, [x, y, _]: Place) -> [bool; 2] {
        [x.abs() == self.size_m[0] / 2.0, y.abs() == self.size_m[1] / 2.0]
    }

    /// Drives all faces: the velocity grows and shrinks linearly, so that steps that fit into half
    /// the ramp add up to the way without error.
    fn drive(&self, model: &mut SpatialModel) {
        let history = vec![[0.0, 0.0], [self.ramp_s / 2.0, 1.0], [self.ramp_s, 0.0]];
        for node in 0..model.mesh.nodes.len() {
            let place = model.mesh.nodes[node];
            let ends = place[2] == 0.0 || place[2] == self.size_m[2];
            if !ends && self.sides(place) == [false; 2] {
                continue;
            }
            let image = self.image(place);
            let speed = [0, 1, 2].map(|k| 2.0 * (image[k] - place[k]) / self.ramp_s);
            let motion = if speed == [0.0; 3] {
                Motion::CLAMPED
            } else {
                let drives = speed.map(Drive::Velocity);
                Motion { drives, later: None, history: history.clone() }
            };
            model.hold("face", vec![node], motion);
        }
    }

    fn start(&self, model: &mut SpatialModel) {
        if self.gradient != IDENTITY {
            let places = model.mesh.nodes.iter().enumerate();
            model.start = places.map(|(node, &place)| (node, self.image(place))).collect();
        }
    }

    /// Supports and pressure.
    fn hold(&self, model: &mut SpatialModel) {
        let top = self.size_m[2];
        let shares = areas(&model.mesh, |place| place[2] == top);
        let history = vec![[0.0, 0.0], [self.ramp_s, 1.0]];
        for node in 0..model.mesh.nodes.len() {
            let place = model.mesh.nodes[node];
            let (low, sides) = (place[2] == 0.0, self.sides(place));
            let mut drives = [Drive::Force(0.0); 3];
            match self.held {
                Held::Base if low => drives = [Drive::Velocity(0.0); 3],
                Held::Confined => {
                    for (k, held) in [sides[0], sides[1], low].into_iter().enumerate() {
                        if held {
                            drives[k] = Drive::Velocity(0.0);
                        }
                    }
                }
                _ => {}
            }
            let force = self.pressure_pa * shares.get(&node).copied().unwrap_or(0.0);
            let history = if force == 0.0 { Vec::new() } else { history.clone() };
            if force != 0.0 {
                drives[2] = Drive::Force(-force);
            }
            let motion = Motion { drives, later: None, history };
            if motion != Motion::FREE {
                let name = if force == 0.0 { "held" } else { "top" };
                model.hold(name, vec![node], motion);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn nodes_on_the_diagonal_of_a_pressed_face_bear_a_third_the_others_a_sixth() {
        let cube = Cube3d { held: Held::Confined, pressure_pa: 12.0, ..Cube3d::default() };
        let model = cube.model().expect("a model");
        model.check().expect("a sound mesh");
        assert_eq!(model.mesh.tetrahedra.len(), 12);
        let mut forces: Vec<f64> = model
            .supports
            .iter()
            .filter_map(|s| match s.motion.drives[2] {
                Drive::Force(f) if f != 0.0 => Some(f),
                _ => None,
            })
            .collect();
        forces.sort_by(f64::total_cmp);
        let expected = [-4.0, -4.0, -2.0, -2.0];
        assert!(forces.iter().zip(expected).all(|(f, e)| (f - e).abs() < 1e-14), "{forces:?}");
    }

    #[test]
    fn a_box_turned_inside_out_is_refused() {
        let gradient = [[-1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let cube = Cube3d { gradient, ..Cube3d::default() };
        assert!(cube.model().expect_err("a fault").to_string().contains("determinant"));
    }
}
