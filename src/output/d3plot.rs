//! d3plot family of a run (spec `y2d3d.md` G.2).

use super::{
    OutputError, OutputNames, ResultWriter,
    elements::{is_joint, material_number, original_material_number, shown_elements},
};
use crate::simulation::Simulation;
use std::path::PathBuf;
use yformat::d3plot::{
    ControlBlock, Counts, FamilyWriter, Geometry, NodeVectors, Shell, StartDate, StateView,
    Stresses, Title, states_per_file,
};

/// Writes the d3plot family, opened at the first state.
pub struct D3plotOutput {
    names: OutputNames,
    start: StartDate,
    legacy: bool,
    family: Option<Family>,
}

struct Family {
    writer: FamilyWriter,
    elements: Vec<usize>,
    /// Nodes announced in the control block; later ones have no place in the family.
    nodes: usize,
    coordinates: Vec<[f64; 2]>,
    velocities: Vec<[f64; 2]>,
    stresses: Vec<[f64; 3]>,
    deletion_table: Vec<f64>,
}

impl D3plotOutput {
    /// Output named by `names`, with the start date in its title. `legacy`
    /// writes the control block exactly as the original did.
    #[must_use]
    pub fn new(names: &OutputNames, start: StartDate, legacy: bool) -> Self {
        Self { names: names.clone(), start, legacy, family: None }
    }

    fn open(&self, simulation: &Simulation) -> Result<Family, OutputError> {
        let scene = simulation.scene();
        let elements = shown_elements(scene);
        let counts = Counts {
            nodes: scene.nodes.len(),
            elements: elements.len(),
            properties: scene.materials.len(),
        };
        let title = Title::new(self.names.base(), self.start);
        let mut control = ControlBlock::two_dimensional(title, counts)?;
        if self.legacy {
            control = control.legacy();
        }
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
        let per_file = states_per_file(scene.nodes.len(), scene.elements.len());
        let writer = FamilyWriter::create(&self.names.d3plot(), control, &geometry, per_file)?;
        Ok(Family {
            writer,
            elements,
            nodes: scene.nodes.len(),
            coordinates: Vec::new(),
            velocities: Vec::new(),
            stresses: Vec::new(),
            deletion_table: Vec::new(),
        })
    }
}

impl Family {
    fn write(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let scene = simulation.scene();
        let fill = |to: &mut Vec<[f64; 2]>, from: &[nalgebra::Vector2<f64>]| {
            to.clear();
            to.extend(from[..self.nodes].iter().map(|v| [v.x, v.y]));
        };
        fill(&mut self.coordinates, &scene.nodes.current);
        fill(&mut self.velocities, &scene.nodes.velocity);
        self.stresses.clear();
        self.deletion_table.clear();
        for &element in &self.elements {
            let stress = simulation.stresses()[element];
            self.stresses.push([stress[(0, 0)], stress[(1, 1)], stress[(0, 1)]]);
            self.deletion_table.push(f64::from(material_number(scene, element)));
        }
        self.writer.write_state(&StateView {
            time: simulation.time(),
            kinetic_energy: simulation.previous_kinetic_energy(),
            coordinates: NodeVectors::Plane(&self.coordinates),
            velocities: NodeVectors::Plane(&self.velocities),
            accelerations: NodeVectors::Zero,
            stresses: Stresses::Plane(&self.stresses),
            deletion_table: &self.deletion_table,
        })?;
        Ok(())
    }
}

impl ResultWriter for D3plotOutput {
    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if !simulation.is_output_step() {
            return Ok(());
        }
        let mut family = match self.family.take() {
            Some(family) => family,
            None => self.open(simulation)?,
        };
        let written = family.write(simulation);
        self.family = Some(family);
        written
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        match self.family {
            Some(family) => Ok(family.writer.finish()?.files),
            None => Ok(Vec::new()),
        }
    }
}
