//! VTU files and their PVD collection for ParaView.
//!
//! Two blocks per output step: the bodies (triangles) and, where there are
//! any, the joints (lines along their middle). Values are those of the step's
//! force evaluation, in double precision.

use super::{
    Background, OutputError, OutputNames, ResultWriter,
    bodies::body_of_elements,
    vtu_series::{self, VtuSeries},
};
use crate::{
    mechanics::{Vec2, softening_triangle, triangle},
    scene::ElementKind,
    simulation::{JointView, Simulation, joint_views},
};
use std::path::PathBuf;
use ypsilon_converters::{
    stress_measures::{SymmetricTensor, plane, principal, tresca, von_mises},
    vtk::{CellType, Cells, DataArray, UnstructuredGrid},
};

/// Writes a VTU file per block and output step, and the PVD after each step.
pub struct VtuOutput(VtuSeries);

impl VtuOutput {
    /// Output named by `names`.
    #[must_use]
    pub fn new(names: &OutputNames, background: &Background) -> Self {
        Self(VtuSeries::new(names, background))
    }
}

impl ResultWriter for VtuOutput {
    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if !simulation.is_output_step() {
            return Ok(());
        }
        self.0.write(simulation.step_index(), simulation.time(), grids(simulation))
    }

    fn kind(&self) -> &'static str {
        vtu_series::KIND
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        self.0.mark()
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        _simulation: &Simulation,
    ) -> Result<(), OutputError> {
        self.0.resume(mark, names)
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        Ok(self.0.finish())
    }
}

fn in_space(v: Vec2) -> [f64; 3] {
    [v.x, v.y, 0.0]
}

/// The blocks of a state whose forces were evaluated, each with what it adds to the names of files.
#[must_use]
pub fn grids(simulation: &Simulation) -> Vec<(&'static str, UnstructuredGrid)> {
    let joints: Vec<JointView> = joint_views(simulation).collect();
    let mut grids = vec![(vtu_series::BODIES, body_grid(simulation))];
    if !joints.is_empty() {
        grids.push((vtu_series::JOINTS, joint_grid(simulation, &joints)));
    }
    grids
}

fn vectors(name: &str, values: impl Iterator<Item = Vec2>) -> DataArray {
    DataArray::vector(name, values.map(in_space).collect())
}

/// Triangles with the nodes as points.
fn body_grid(simulation: &Simulation) -> UnstructuredGrid {
    let scene = simulation.scene();
    let nodes = &scene.nodes;
    let triangles: Vec<usize> = simulation.triangles().collect();
    let mut cells = Cells::with_capacity(CellType::Triangle, triangles.len());
    for &t in &triangles {
        cells.push(CellType::Triangle, &scene.elements.corners::<3>(t).map(|n| n as u32));
    }
    let displacement = nodes.current.iter().zip(&nodes.initial).map(|(x, x0)| x - x0);
    let point_data = vec![
        vectors("displacement", displacement),
        vectors("velocity", nodes.velocity.iter().copied()),
        vectors("force", simulation.forces().iter().copied()),
        DataArray::scalar("mass", simulation.masses().to_vec()),
        DataArray::integer("boundary condition ID", nodes.set.clone()),
        DataArray::integer("boundary flag", nodes.boundary_flag.clone()),
        DataArray::integer("node ID", (0..nodes.len() as i32).collect()),
    ];
    let bodies = body_of_elements(simulation);
    let stress: Vec<SymmetricTensor> = triangles.iter().map(|&t| stress(simulation, t)).collect();
    let scalar = |name: &str, f: fn(&SymmetricTensor) -> f64| {
        DataArray::scalar(name, stress.iter().map(f).collect())
    };
    let integer = |name: &str, f: &dyn Fn(usize) -> i32| {
        DataArray::integer(name, triangles.iter().map(|&t| f(t)).collect())
    };
    let mut cell_data = vec![
        integer("material property ID", &|t| scene.elements.property[t]),
        integer("body ID", &|t| bodies[t]),
        integer("element ID", &|t| t as i32),
        scalar("von Mises stress", von_mises),
        scalar("in-plane von Mises stress", |s| von_mises(&plane(s[0], s[1], 0.0, s[3]))),
        scalar("Tresca stress", tresca),
        scalar("principal stress 1", |s| principal(s)[0]),
        scalar("principal stress 2", |s| principal(s)[1]),
        scalar("principal stress 3", |s| principal(s)[2]),
    ];
    cell_data.insert(3, DataArray::symmetric_tensor("Cauchy stress", stress));
    if let Some(damage) = simulation.triangle_damage() {
        cell_data.push(DataArray::scalar("damage", triangles.iter().map(|&t| damage[t]).collect()));
    }
    UnstructuredGrid {
        points: nodes.current.iter().copied().map(in_space).collect(),
        cells,
        point_data,
        cell_data,
        field_data: run_data(simulation),
    }
}

/// Cauchy stress of a triangle. The laws are ones of plane strain, so that σzz,
/// the volumetric part of the law, is not zero; the original's files leave it out.
fn stress(simulation: &Simulation, element: usize) -> SymmetricTensor {
    let s = &simulation.stresses()[element];
    let scene = simulation.scene();
    let area = |x: &[Vec2]| {
        let [a, b, c] = scene.elements.corners::<3>(element).map(|n| x[n]);
        triangle::double_area(&[a, b, c])
    };
    let ratio = area(&scene.nodes.current) / area(&scene.nodes.initial);
    let zz = scene.material_of(element).map_or(0.0, |m| {
        let volumetric = m.lame_lambda * (ratio - 1.0 / ratio);
        match m.kind {
            ElementKind::ElasticTriangle => 0.5 * volumetric,
            ElementKind::SofteningTriangle if ratio < 1.0 => 0.5 * volumetric,
            ElementKind::SofteningTriangle => {
                let damage = scene.elements.state[m.damage_row as usize][element];
                (1.0 - softening_triangle::loss(damage)) * volumetric
            }
            ElementKind::RigidTriangle
            | ElementKind::Tetrahedron
            | ElementKind::QuadraticTetrahedron
            | ElementKind::Inert(_) => 0.0,
        }
    });
    plane(s[(0, 0)], s[(1, 1)], zz, s[(0, 1)])
}

/// Joints as lines along their middle.
fn joint_grid(simulation: &Simulation, joints: &[JointView]) -> UnstructuredGrid {
    let nodes = &simulation.scene().nodes;
    let mut cells = Cells::with_capacity(CellType::Line, joints.len());
    let mut points = Vec::with_capacity(2 * joints.len());
    let mut displacement = Vec::with_capacity(2 * joints.len());
    for (k, joint) in joints.iter().enumerate() {
        let [a, b, c, d] = joint.nodes;
        for (p, q) in [(a, d), (b, c)] {
            let middle = (nodes.current[p] + nodes.current[q]) / 2.0;
            points.push(in_space(middle));
            displacement.push(middle - (nodes.initial[p] + nodes.initial[q]) / 2.0);
        }
        cells.push(CellType::Line, &[2 * k as u32, 2 * k as u32 + 1]);
    }
    let scalar = |name: &str, f: &dyn Fn(&JointView) -> f64| {
        DataArray::scalar(name, joints.iter().map(f).collect())
    };
    let integer = |name: &str, f: &dyn Fn(&JointView) -> i32| {
        DataArray::integer(name, joints.iter().map(f).collect())
    };
    let cell_data = vec![
        integer("joint state", &|j| j.condition as i32),
        integer("joint set ID", &|j| j.law as i32),
        integer("element ID", &|j| j.element as i32),
        scalar("damage", &|j| j.damage),
        scalar("opening", &|j| j.opening),
        scalar("sliding", &|j| j.sliding),
        scalar("failure mode", &|j| j.failure.map_or(0.0, |f| f.mode)),
        integer("failure time step", &|j| j.failure.map_or(-1, |f| f.step as i32)),
    ];
    UnstructuredGrid {
        points,
        cells,
        point_data: vec![vectors("displacement", displacement.into_iter())],
        cell_data,
        field_data: run_data(simulation),
    }
}

fn run_data(simulation: &Simulation) -> Vec<DataArray> {
    vec![
        DataArray::time(simulation.time()),
        DataArray::integer("step", vec![simulation.step_index() as i32]),
        DataArray::scalar("kinetic energy", vec![simulation.previous_kinetic_energy()]),
    ]
}
