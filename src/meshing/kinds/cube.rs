//! A cube, in plane form a square.

use super::bodies;
use crate::meshing::{
    MeshingError,
    mesh::{Mesh, Triangle},
    model::{Drive, Model, Motion, Support},
    pattern::Point,
    properties::{Material, count, not_negative, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// A square that is deformed in a known way, pressed, or left to its weight. The origin is in the
/// middle of its lower face.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Cube {
    /// Edge \[m\].
    pub edge_m: f64,
    /// Cells along an edge, two triangles each; 0 for four triangles around a node in the middle.
    pub cells: usize,
    /// Deformation gradient, row by row, about the origin: where the square is at the start, or
    /// where its faces are driven to if they are held.
    pub gradient: [[f64; 2]; 2],
    /// What is held: `free`, `base` (lower face clamped), `confined` (lower face and sides on
    /// rollers), `faces` (all faces driven to what the gradient says).
    pub held: Held,
    /// Pressure on the upper face, as forces on its undeformed length \[Pa\].
    pub pressure_pa: f64,
    /// Time in which faces are driven and the pressure grows \[s\].
    pub ramp_s: f64,
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// What it is made of.
    pub material: Material,
}

/// What is held of a cube.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Held {
    /// Nothing: it starts as the gradient says.
    Free,
    /// The lower face is clamped; it starts as the gradient says.
    Base,
    /// The lower face and the sides are on rollers; it starts as the gradient says.
    Confined,
    /// All faces: they are driven from the undeformed square to what the gradient says.
    Faces,
}

impl Default for Cube {
    /// The cube of the thesis's first validations.
    fn default() -> Self {
        Cube {
            edge_m: 1.0,
            cells: 0,
            gradient: [[1.0, 0.0], [0.0, 1.0]],
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

impl Cube {
    /// The model.
    ///
    /// # Errors
    /// If a parameter has no sense.
    pub fn model(&self) -> Result<Model, MeshingError> {
        positive("cube.edge_m", self.edge_m)?;
        count("cube.cells", self.cells.max(1), 1)?;
        positive("cube.ramp_s", self.ramp_s)?;
        not_negative("cube.pressure_pa", self.pressure_pa.abs())?;
        self.material.check("cube.material")?;
        let [[a, b], [c, d]] = self.gradient;
        positive("cube: determinant of the gradient", a * d - b * c)?;
        let mesh = self.mesh()?;
        let mut model = bodies("cube".to_owned(), mesh, vec![("cube", self.material)]);
        if self.held == Held::Faces {
            self.drive(&mut model);
        } else {
            self.start(&mut model);
            self.hold(&mut model);
        }
        let (half, edge) = (self.edge_m / 2.0, self.edge_m);
        if self.pressure_pa == 0.0 && matches!(self.held, Held::Free | Held::Base) {
            model.top = model.nodes_where(|[_, y]| y == edge);
            model.top.sort_by(|&a, &b| model.mesh.nodes[a][0].total_cmp(&model.mesh.nodes[b][0]));
        }
        debug_assert!(model.mesh.nodes.iter().all(|p| p[0].abs() <= half));
        model.gravity_m_s2 = self.gravity_m_s2;
        model.settled_s = 2.0 * self.ramp_s;
        Ok(model)
    }

    fn mesh(&self) -> Result<Mesh, MeshingError> {
        let (half, edge) = (self.edge_m / 2.0, self.edge_m);
        let mut mesh = Mesh::default();
        if self.cells > 0 {
            mesh.rectangle([[-half, 0.0], [half, edge]], [self.cells; 2], 0)?;
            return Ok(mesh);
        }
        mesh.nodes = vec![[-half, 0.0], [half, 0.0], [half, edge], [-half, edge], [0.0, half]];
        mesh.triangles = (0..4)
            .map(|k| Triangle { nodes: [k, (k + 1) % 4, 4], block: 0, material: 0 })
            .collect();
        mesh.blocks = 1;
        Ok(mesh)
    }

    /// Where the gradient puts a point.
    fn image(&self, [x, y]: Point) -> Point {
        self.gradient.map(|row| row[0] * x + row[1] * y)
    }

    fn is_on_faces(&self, [x, y]: Point) -> bool {
        x.abs() == self.edge_m / 2.0 || y == 0.0 || y == self.edge_m
    }

    /// Drives all faces: the velocity grows and shrinks linearly, so that steps that fit into half
    /// the ramp add up to the way without error.
    fn drive(&self, model: &mut Model) {
        let history = vec![[0.0, 0.0], [self.ramp_s / 2.0, 1.0], [self.ramp_s, 0.0]];
        for (node, &place) in model.mesh.nodes.iter().enumerate() {
            if !self.is_on_faces(place) {
                continue;
            }
            let image = self.image(place);
            let speed = [0, 1].map(|k| 2.0 * (image[k] - place[k]) / self.ramp_s);
            let motion = if speed == [0.0; 2] {
                Motion::CLAMPED
            } else {
                let drives = speed.map(Drive::Velocity);
                Motion { drives, later: None, history: history.clone() }
            };
            model.supports.push(Support { name: "face".to_owned(), nodes: vec![node], motion });
        }
    }

    fn start(&self, model: &mut Model) {
        if self.gradient == [[1.0, 0.0], [0.0, 1.0]] {
            return;
        }
        let places = model.mesh.nodes.iter().enumerate();
        model.start = places.map(|(node, &place)| (node, self.image(place))).collect();
    }

    /// Supports and pressure.
    fn hold(&self, model: &mut Model) {
        let (half, edge) = (self.edge_m / 2.0, self.edge_m);
        let each = self.pressure_pa * edge / self.cells.max(1) as f64;
        let history = vec![[0.0, 0.0], [self.ramp_s, 1.0]];
        for (node, &[x, y]) in model.mesh.nodes.iter().enumerate() {
            let (low, high, side) = (y == 0.0, y == edge, x.abs() == half);
            let (name, mut drives) = match self.held {
                Held::Base if low => ("base", [Drive::Velocity(0.0); 2]),
                Held::Confined if low && side => ("corner", [Drive::Velocity(0.0); 2]),
                Held::Confined if low => ("base", [Drive::Force(0.0), Drive::Velocity(0.0)]),
                Held::Confined if side => ("side", [Drive::Velocity(0.0), Drive::Force(0.0)]),
                _ if high && each != 0.0 => ("top", [Drive::Force(0.0); 2]),
                _ => continue,
            };
            if high && each != 0.0 {
                drives[1] = Drive::Force(-each * if side { 0.5 } else { 1.0 });
            }
            let moved = drives.iter().any(|d| matches!(d, Drive::Force(f) if *f != 0.0));
            let history = if moved { history.clone() } else { Vec::new() };
            let motion = Motion { drives, later: None, history };
            model.supports.push(Support { name: name.to_owned(), nodes: vec![node], motion });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_square_is_covered_and_symmetric() {
        for cells in [0, 1, 4] {
            let model = Cube { cells, ..Cube::default() }.model().expect("a model");
            model.check().expect("a sound mesh");
            assert!((model.mesh.total_area() - 1.0).abs() < 1e-14);
            let nodes = &model.mesh.nodes;
            assert!(nodes.iter().all(|&[x, y]| nodes.contains(&[-x, y])));
        }
    }

    #[test]
    fn driven_faces_arrive_where_the_gradient_says() {
        let gradient = [[1.0, 0.5], [0.0, 0.5]];
        let cube = Cube { gradient, held: Held::Faces, ..Cube::default() };
        let model = cube.model().expect("a model");
        assert_eq!(model.supports.len(), 4);
        for support in &model.supports {
            let [x, y] = model.mesh.nodes[support.nodes[0]];
            let way = support.motion.drives.map(|drive| match drive {
                Drive::Velocity(v) => v * cube.ramp_s / 2.0,
                Drive::Force(_) => f64::NAN,
            });
            assert!((way[0] - 0.5 * y).abs() < 1e-15 && (way[1] + 0.5 * y).abs() < 1e-15);
            assert_eq!(support.motion == Motion::CLAMPED, y == 0.0, "{x} {y}");
        }
    }

    #[test]
    fn a_pressure_adds_up() {
        let cube = Cube { cells: 3, held: Held::Confined, pressure_pa: 12.0, ..Cube::default() };
        let model = cube.model().expect("a model");
        let force: f64 = model
            .supports
            .iter()
            .map(|s| match s.motion.drives[1] {
                Drive::Force(f) => f,
                Drive::Velocity(_) => 0.0,
            })
            .sum();
        assert!((force + 12.0).abs() < 1e-14);
    }

    #[test]
    fn a_square_turned_inside_out_is_refused() {
        let cube = Cube { gradient: [[-1.0, 0.0], [0.0, 1.0]], ..Cube::default() };
        assert!(cube.model().expect_err("a fault").to_string().contains("determinant"));
    }
}
