//! d3plot family of a run in the plane (spec `y2d3d.md` G.2).

use super::{
    Background, OutputError, OutputNames, ResultWriter,
    d3plot_family::{Family, KIND, OpenFamily, OwnedState},
    elements::{is_joint, material_number, original_material_number, shown_elements},
};
use crate::simulation::Simulation;
use std::path::PathBuf;
use yformat::d3plot::{
    ControlBlock, Counts, Geometry, NodeVectors, Shell, StartDate, StateView, Stresses, Title,
};

/// Writes the d3plot family, opened at the first state.
pub struct D3plotOutput(Family);

/// A state to be written, in the single precision of the files: it may have to wait.
struct State {
    time: f64,
    kinetic_energy: f64,
    coordinates: Vec<[f32; 2]>,
    velocities: Vec<[f32; 2]>,
    stresses: Vec<[f32; 3]>,
    deletion_table: Vec<f32>,
}

impl OwnedState for State {
    fn view(&self) -> StateView<'_> {
        StateView {
            time: self.time,
            kinetic_energy: self.kinetic_energy,
            coordinates: NodeVectors::Plane(&self.coordinates),
            velocities: NodeVectors::Plane(&self.velocities),
            accelerations: NodeVectors::Zero,
            stresses: Stresses::Plane(&self.stresses),
            deletion_table: &self.deletion_table,
        }
    }
}

impl State {
    fn new(simulation: &Simulation, shown: &OpenFamily) -> Self {
        let scene = simulation.scene();
        let nodes = |values: &[nalgebra::Vector2<f64>]| {
            values[..shown.nodes].iter().map(|v| [v.x as f32, v.y as f32]).collect()
        };
        let stress = |element: usize| {
            let stress = simulation.stresses().get(element).copied().unwrap_or_default();
            [stress[(0, 0)], stress[(1, 1)], stress[(0, 1)]].map(|component| component as f32)
        };
        let material = |element: usize| material_number(scene, element) as f32;
        Self {
            time: simulation.time(),
            kinetic_energy: simulation.previous_kinetic_energy(),
            coordinates: nodes(&scene.nodes.current),
            velocities: nodes(&scene.nodes.velocity),
            stresses: shown.elements().map(stress).collect(),
            deletion_table: shown.elements().map(material).collect(),
        }
    }
}

impl D3plotOutput {
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

    fn open(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let scene = simulation.scene();
        let elements = shown_elements(scene);
        let counts = Counts {
            nodes: scene.nodes.len(),
            elements: elements.len(),
            properties: scene.materials.len(),
        };
        let title = Title::new(self.0.names.base(), self.0.start);
        let control = ControlBlock::two_dimensional(title, counts)?;
        let shells = elements.iter().map(|&e| {
            let material = original_material_number(simulation, e);
            let node = |i: usize| scene.elements.nodes[e][i] as u32;
            if is_joint(scene, e) {
                Shell::joint([0, 1, 2, 3].map(node), material)
            } else {
                Shell::triangle([0, 1, 2].map(node), material)
            }
        });
        let geometry = Geometry {
            coordinates: scene
                .nodes
                .initial
                .iter()
                .map(|x| [x.x as f32, x.y as f32, 0.0])
                .collect(),
            shells: shells.collect(),
            ..Geometry::default()
        };
        self.0.open(control, &geometry, &elements, [scene.nodes.len(), scene.elements.len()])
    }
}

impl ResultWriter for D3plotOutput {
    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
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
        simulation: &Simulation,
    ) -> Result<(), OutputError> {
        let scene = simulation.scene();
        self.0.resume(mark, names, [scene.nodes.len(), scene.elements.len()])
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        self.0.finish()
    }
}
