//! d3plot family of a run in three dimensions (spec `y2d3d.md` G.2).
//!
//! As in the original, the "accelerations" of a state are the forces of joints, and its kinetic
//! energy is that of the end of the previous step.

use crate::{
    mechanics::Vec3,
    output::{
        Background, OutputError, OutputNames, ResultWriter,
        d3plot_family::{Family, KIND, OpenFamily, OwnedState},
        elements::{is_joint, material_number, material_of_joint_set, shown_elements},
    },
    scene::JointKind,
    simulation::SpatialSimulation,
};
use std::path::PathBuf;
use yformat::d3plot::{
    ControlBlock, Counts, Geometry, NodeVectors, Solid, StartDate, StateView, Stresses, Title,
};

/// Writes the d3plot family, opened at the first state.
pub struct SpatialD3plotOutput(Family);

/// A state to be written, in the single precision of the files: it may have to wait.
struct State {
    time: f64,
    kinetic_energy: f64,
    coordinates: Vec<[f32; 3]>,
    velocities: Vec<[f32; 3]>,
    joint_forces: Vec<[f32; 3]>,
    stresses: Vec<[f32; 6]>,
    deletion_table: Vec<f32>,
}

impl OwnedState for State {
    fn view(&self) -> StateView<'_> {
        StateView {
            time: self.time,
            kinetic_energy: self.kinetic_energy,
            coordinates: NodeVectors::Spatial(&self.coordinates),
            velocities: NodeVectors::Spatial(&self.velocities),
            accelerations: NodeVectors::Spatial(&self.joint_forces),
            stresses: Stresses::Spatial(&self.stresses),
            deletion_table: &self.deletion_table,
        }
    }
}

impl State {
    fn new(simulation: &SpatialSimulation, shown: &OpenFamily) -> Self {
        let scene = simulation.scene();
        let nodes = |values: &[Vec3]| {
            let single = |v: &Vec3| [v.x as f32, v.y as f32, v.z as f32];
            values[..shown.nodes].iter().map(single).collect()
        };
        let stress = |element: usize| {
            let s = simulation.stress(element);
            [s[(0, 0)], s[(1, 1)], s[(2, 2)], s[(0, 1)], s[(1, 2)], s[(0, 2)]]
                .map(|component| component as f32)
        };
        let material = |element: usize| material_number(scene, element) as f32;
        Self {
            time: simulation.time(),
            kinetic_energy: simulation.previous_kinetic_energy(),
            coordinates: nodes(&scene.nodes.current),
            velocities: nodes(&scene.nodes.velocity),
            joint_forces: nodes(simulation.joint_forces()),
            stresses: shown.elements().map(stress).collect(),
            deletion_table: shown.elements().map(material).collect(),
        }
    }
}

/// Material number of an element for the connectivity, where a joint that has failed already
/// keeps the material of its joint set.
fn original_material(simulation: &SpatialSimulation, element: usize) -> i32 {
    let scene = simulation.scene();
    if scene.elements.joint_kind[element] == JointKind::Broken {
        let failure = simulation.failures().iter().find(|f| f.element == element);
        return material_of_joint_set(scene, failure.map_or(0, |f| f.law as i32));
    }
    material_number(scene, element)
}

impl SpatialD3plotOutput {
    /// Output named by `names`, with the start date in its title. `legacy`
    /// writes the control block exactly as the original did.
    #[must_use]
    pub fn new(
        names: &OutputNames,
        background: &Background,
        start: StartDate,
        legacy: bool,
    ) -> Self {
        Self(Family::new(names, background, start, legacy))
    }

    fn open(&mut self, simulation: &SpatialSimulation) -> Result<(), OutputError> {
        let scene = simulation.scene();
        let elements = shown_elements(scene);
        let counts = Counts {
            nodes: scene.nodes.len(),
            elements: elements.len(),
            properties: scene.materials.len(),
        };
        let title = Title::new(self.0.names.base(), self.0.start);
        let control = ControlBlock::three_dimensional(title, counts)?;
        let solids = elements.iter().map(|&e| {
            let material = original_material(simulation, e);
            let node = |i: usize| scene.elements.nodes[e][i] as u32;
            if is_joint(scene, e) {
                Solid::joint([0, 1, 2, 3, 4, 5].map(node), material)
            } else {
                Solid::tetrahedron([0, 1, 2, 3].map(node), material)
            }
        });
        let geometry = Geometry {
            coordinates: scene.nodes.initial.iter().map(|x| x.map(|c| c as f32).into()).collect(),
            solids: solids.collect(),
            ..Geometry::default()
        };
        self.0.open(control, &geometry, &elements, [scene.nodes.len(), scene.elements.len()])
    }
}

impl ResultWriter<SpatialSimulation> for SpatialD3plotOutput {
    fn after_forces(&mut self, simulation: &SpatialSimulation) -> Result<(), OutputError> {
        if !simulation.is_output_step() {
            return Ok(());
        }
        if !self.0.is_open() {
            self.open(simulation)?;
        }
        self.0.write(|shown| State::new(simulation, shown))
    }

    fn kind(&self) -> &'static str {
        KIND
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        self.0.mark()
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        simulation: &SpatialSimulation,
    ) -> Result<(), OutputError> {
        let scene = simulation.scene();
        self.0.resume(mark, names, [scene.nodes.len(), scene.elements.len()])
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        self.0.finish()
    }
}
