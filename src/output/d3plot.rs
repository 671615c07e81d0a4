//! d3plot family of a run (spec `y2d3d.md` G.2).

use super::{
    Background, FilePosition, OutputError, OutputNames, ResultWriter,
    background::lock,
    decode,
    elements::{is_joint, material_number, original_material_number, shown_elements},
    encode,
};
use crate::{scene::Scene, simulation::Simulation};
use serde::{Deserialize, Serialize};
use std::{
    io,
    path::PathBuf,
    sync::{Arc, Mutex, PoisonError},
};
use yformat::d3plot::{
    ControlBlock, Counts, FamilyMark, FamilyWriter, Geometry, NodeVectors, Shell, StartDate,
    StateView, Stresses, Title, WriteError, states_per_file,
};

/// What `--formats` calls the files.
const KIND: &str = "d3plot";

/// Writes the d3plot family, opened at the first state.
pub struct D3plotOutput {
    names: OutputNames,
    background: Background,
    start: StartDate,
    legacy: bool,
    family: Option<Family>,
}

struct Family {
    writer: Arc<Mutex<FamilyWriter>>,
    per_file: u64,
    elements: Vec<usize>,
    /// Nodes announced in the control block; later ones have no place in the family.
    nodes: usize,
}

/// A state to be written.
struct State {
    time: f64,
    kinetic_energy: f64,
    coordinates: Vec<[f64; 2]>,
    velocities: Vec<[f64; 2]>,
    stresses: Vec<[f64; 3]>,
    deletion_table: Vec<f64>,
}

impl State {
    fn write(&self, writer: &mut FamilyWriter) -> Result<(), OutputError> {
        writer.write_state(&StateView {
            time: self.time,
            kinetic_energy: self.kinetic_energy,
            coordinates: NodeVectors::Plane(&self.coordinates),
            velocities: NodeVectors::Plane(&self.velocities),
            accelerations: NodeVectors::Zero,
            stresses: Stresses::Plane(&self.stresses),
            deletion_table: &self.deletion_table,
        })?;
        Ok(())
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
        let (names, background) = (names.clone(), background.clone());
        Self { names, background, start, legacy, family: None }
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
        Ok(Family::new(writer, per_file, elements, scene.nodes.len()))
    }
}

/// What a later run needs to go on with a family.
#[derive(Serialize, Deserialize)]
struct OutputMark {
    /// Day, month and year of the title.
    start: (u8, u8, u16),
    family: Option<Continuation>,
}

#[derive(Serialize, Deserialize)]
struct Continuation {
    control: Vec<u8>,
    member: u32,
    states_in_file: u64,
    position: FilePosition,
    per_file: u64,
    elements: Vec<u32>,
    nodes: u32,
}

impl Continuation {
    fn of(family: &mut Family) -> Result<Self, OutputError> {
        let mark = lock(&family.writer).mark()?;
        Ok(Self {
            control: mark.control.to_bytes().to_vec(),
            member: mark.member,
            states_in_file: mark.states_in_file,
            position: mark.file.into(),
            per_file: family.per_file,
            elements: family.elements.iter().map(|&e| e as u32).collect(),
            nodes: family.nodes as u32,
        })
    }

    /// The family, if the mark is one of the scene.
    fn open(&self, names: &OutputNames, scene: &Scene) -> Result<Family, OutputError> {
        let unusable = OutputError::Mark { kind: KIND };
        let Ok(control) = <&[u8; ControlBlock::BYTES]>::try_from(self.control.as_slice()) else {
            return Err(unusable);
        };
        let elements: Vec<usize> = self.elements.iter().map(|&e| e as usize).collect();
        let nodes = self.nodes as usize;
        if elements.iter().any(|&e| e >= scene.elements.len())
            || nodes > scene.nodes.len()
            || self.states_in_file > self.per_file.max(1)
        {
            return Err(unusable);
        }
        let mark = FamilyMark {
            control: ControlBlock::from_bytes(control),
            member: self.member,
            states_in_file: self.states_in_file,
            file: self.position.into(),
        };
        let writer = FamilyWriter::resume(&names.d3plot(), self.per_file, &mark);
        let writer = writer.map_err(|error| match error {
            WriteError::Io { path, source } => OutputError::Changed { path, source },
            other => other.into(),
        })?;
        Ok(Family::new(writer, self.per_file, elements, nodes))
    }
}

impl Family {
    fn new(writer: FamilyWriter, per_file: u64, elements: Vec<usize>, nodes: usize) -> Self {
        Self { writer: Arc::new(Mutex::new(writer)), per_file, elements, nodes }
    }

    fn state(&self, simulation: &Simulation) -> State {
        let scene = simulation.scene();
        let nodes = |values: &[nalgebra::Vector2<f64>]| {
            values[..self.nodes].iter().map(|v| [v.x, v.y]).collect()
        };
        let stress = |&element: &usize| {
            let stress = simulation.stresses()[element];
            [stress[(0, 0)], stress[(1, 1)], stress[(0, 1)]]
        };
        let material = |&element: &usize| f64::from(material_number(scene, element));
        State {
            time: simulation.time(),
            kinetic_energy: simulation.previous_kinetic_energy(),
            coordinates: nodes(&scene.nodes.current),
            velocities: nodes(&scene.nodes.velocity),
            stresses: self.elements.iter().map(stress).collect(),
            deletion_table: self.elements.iter().map(material).collect(),
        }
    }
}

impl ResultWriter for D3plotOutput {
    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if !simulation.is_output_step() {
            return Ok(());
        }
        let family = match self.family.take() {
            Some(family) => family,
            None => self.open(simulation)?,
        };
        let (state, writer) = (family.state(simulation), Arc::clone(&family.writer));
        self.family = Some(family);
        self.background.submit(move || state.write(&mut lock(&writer)))
    }

    fn kind(&self) -> &'static str {
        KIND
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        let StartDate { day, month, year } = self.start;
        let family = self.family.as_mut().map(Continuation::of).transpose()?;
        encode(KIND, &OutputMark { start: (day, month, year), family })
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        simulation: &Simulation,
    ) -> Result<(), OutputError> {
        let mark: OutputMark = decode(KIND, mark)?;
        let (day, month, year) = mark.start;
        if day > 31 || month > 12 || year > 9999 {
            return Err(OutputError::Mark { kind: KIND });
        }
        self.start = StartDate { day, month, year };
        let open = |family: Continuation| family.open(names, simulation.scene());
        self.family = mark.family.map(open).transpose()?;
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        let Some(family) = self.family else { return Ok(Vec::new()) };
        // all states are written, so that nobody else has the writer
        let still_used = || io::Error::other("it is still being written");
        let writer = Arc::into_inner(family.writer).ok_or_else(still_used);
        let writer = writer.map_err(OutputError::io(self.names.d3plot()))?;
        let writer = writer.into_inner().unwrap_or_else(PoisonError::into_inner);
        Ok(writer.finish()?.files)
    }
}
