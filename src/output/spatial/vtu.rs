//! VTU files and their PVD collection in three dimensions: tetrahedra, and joints as wedges.
//! Values are those of the step's force evaluation, in double precision.

use super::body_of_tetrahedra;
use crate::{
    mechanics::Vec3,
    output::{
        Background, OutputError, OutputNames, ResultWriter,
        vtu_series::{self, VtuSeries},
    },
    simulation::{FaceJointView, SpatialSimulation, face_joint_views},
};
use std::path::PathBuf;
use ypsilon_converters::{
    stress_measures::{SymmetricTensor, principal, tresca, von_mises},
    vtk::{CellType, Cells, DataArray, UnstructuredGrid},
};

/// Writes a VTU file per block and output step, and the PVD after each step.
pub struct SpatialVtuOutput(VtuSeries);

impl SpatialVtuOutput {
    /// Output named by `names`.
    #[must_use]
    pub fn new(names: &OutputNames, background: &Background) -> Self {
        Self(VtuSeries::new(names, background))
    }
}

impl ResultWriter<SpatialSimulation> for SpatialVtuOutput {
    fn after_forces(&mut self, simulation: &SpatialSimulation) -> Result<(), OutputError> {
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
        _simulation: &SpatialSimulation,
    ) -> Result<(), OutputError> {
        self.0.resume(mark, names)
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        Ok(self.0.finish())
    }
}

/// The blocks of a state whose forces were evaluated, each with what it adds to the names of files.
#[must_use]
pub fn grids(simulation: &SpatialSimulation) -> Vec<(&'static str, UnstructuredGrid)> {
    let joints: Vec<FaceJointView> = face_joint_views(simulation).collect();
    let mut grids = vec![(vtu_series::BODIES, body_grid(simulation))];
    if !joints.is_empty() {
        grids.push((vtu_series::JOINTS, joint_grid(simulation, &joints)));
    }
    grids
}

fn vectors(name: &str, values: impl Iterator<Item = Vec3>) -> DataArray {
    DataArray::vector(name, values.map(Into::into).collect())
}

/// Tetrahedra with the nodes as points.
fn body_grid(simulation: &SpatialSimulation) -> UnstructuredGrid {
    let scene = simulation.scene();
    let nodes = &scene.nodes;
    let tetrahedra: Vec<usize> = simulation.tetrahedra().collect();
    let mut cells = Cells::with_capacity(CellType::Tetra, tetrahedra.len());
    for &t in &tetrahedra {
        if scene.elements.edge_nodes.get(t).is_some_and(|edges| edges[0] >= 0) {
            cells.push(CellType::QuadraticTetra, &scene.elements.all_nodes(t).map(|n| n as u32));
        } else {
            cells.push(CellType::Tetra, &scene.elements.corners::<4>(t).map(|n| n as u32));
        }
    }
    let displacement = nodes.current.iter().zip(&nodes.initial).map(|(x, x0)| x - x0);
    let force = simulation.forces().iter().zip(simulation.joint_forces()).map(|(f, j)| j + f);
    let point_data = vec![
        vectors("displacement", displacement),
        vectors("velocity", nodes.velocity.iter().copied()),
        vectors("force", force),
        DataArray::scalar("mass", simulation.masses().to_vec()),
        DataArray::integer("boundary condition ID", nodes.set.clone()),
        DataArray::integer("boundary flag", nodes.boundary_flag.clone()),
        DataArray::integer("node ID", (0..nodes.len() as i32).collect()),
    ];
    let bodies = body_of_tetrahedra(simulation);
    let stress: Vec<SymmetricTensor> = tetrahedra.iter().map(|&t| stress(simulation, t)).collect();
    let scalar = |name: &str, f: fn(&SymmetricTensor) -> f64| {
        DataArray::scalar(name, stress.iter().map(f).collect())
    };
    let integer = |name: &str, f: &dyn Fn(usize) -> i32| {
        DataArray::integer(name, tetrahedra.iter().map(|&t| f(t)).collect())
    };
    let mut cell_data = vec![
        integer("material property ID", &|t| scene.elements.property[t]),
        integer("body ID", &|t| bodies[t]),
        integer("element ID", &|t| t as i32),
        scalar("von Mises stress", von_mises),
        scalar("Tresca stress", tresca),
        scalar("principal stress 1", |s| principal(s)[0]),
        scalar("principal stress 2", |s| principal(s)[1]),
        scalar("principal stress 3", |s| principal(s)[2]),
    ];
    cell_data.insert(3, DataArray::symmetric_tensor("Cauchy stress", stress));
    UnstructuredGrid {
        points: nodes.current.iter().map(|&x| x.into()).collect(),
        cells,
        point_data,
        cell_data,
        field_data: run_data(simulation),
    }
}

/// Cauchy stress of a tetrahedron: xx, yy, zz, xy, yz, xz.
fn stress(simulation: &SpatialSimulation, element: usize) -> SymmetricTensor {
    let s = simulation.stress(element);
    [s[(0, 0)], s[(1, 1)], s[(2, 2)], s[(0, 1)], s[(1, 2)], s[(0, 2)]]
}

/// Joints as wedges between their faces, with nodes of their own.
fn joint_grid(simulation: &SpatialSimulation, joints: &[FaceJointView]) -> UnstructuredGrid {
    let nodes = &simulation.scene().nodes;
    let mut cells = Cells::with_capacity(CellType::Wedge, joints.len());
    let mut points = Vec::with_capacity(6 * joints.len());
    let mut displacement = Vec::with_capacity(6 * joints.len());
    for (k, joint) in joints.iter().enumerate() {
        for node in joint.nodes {
            points.push(nodes.current[node].into());
            displacement.push(nodes.current[node] - nodes.initial[node]);
        }
        cells.push(CellType::Wedge, &[0, 1, 2, 3, 4, 5].map(|i| 6 * k as u32 + i));
    }
    let scalar = |name: &str, f: &dyn Fn(&FaceJointView) -> f64| {
        DataArray::scalar(name, joints.iter().map(f).collect())
    };
    let integer = |name: &str, f: &dyn Fn(&FaceJointView) -> i32| {
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

fn run_data(simulation: &SpatialSimulation) -> Vec<DataArray> {
    vec![
        DataArray::time(simulation.time()),
        DataArray::integer("step", vec![simulation.step_index() as i32]),
        DataArray::scalar("kinetic energy", vec![simulation.previous_kinetic_energy()]),
    ]
}
