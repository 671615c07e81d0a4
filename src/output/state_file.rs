//! Full-precision state files in the text form of the reference states: for
//! debugging and for comparison with other programs.

use super::{Background, OutputError, OutputNames, ResultWriter, save};
use crate::{
    scene::Scene,
    simulation::{Simulation, SpatialSimulation},
};
use nalgebra::SVector;
use std::{
    collections::BTreeSet,
    io::{self, Write},
    path::PathBuf,
};

/// What a run calls the files.
const KIND: &str = "state";

/// Writes the state after chosen numbers of completed steps.
pub struct StateFileOutput {
    names: OutputNames,
    background: Background,
    steps: BTreeSet<u64>,
    written: Vec<PathBuf>,
}

impl StateFileOutput {
    /// States after each of `steps` completed steps.
    #[must_use]
    pub fn new(
        names: &OutputNames,
        background: &Background,
        steps: impl IntoIterator<Item = u64>,
    ) -> Self {
        Self {
            names: names.clone(),
            background: background.clone(),
            steps: steps.into_iter().collect(),
            written: Vec::new(),
        }
    }
}

impl ResultWriter for StateFileOutput {
    fn after_step(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        self.write_if_due(simulation.step_index(), |file| write_state(file, simulation))
    }

    fn kind(&self) -> &'static str {
        KIND
    }

    fn series(&mut self) -> Option<&mut Vec<PathBuf>> {
        Some(&mut self.written)
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        Ok(self.written)
    }
}

impl ResultWriter<SpatialSimulation> for StateFileOutput {
    fn after_step(&mut self, simulation: &SpatialSimulation) -> Result<(), OutputError> {
        self.write_if_due(simulation.step_index(), |file| write_spatial_state(file, simulation))
    }

    fn kind(&self) -> &'static str {
        KIND
    }

    fn series(&mut self) -> Option<&mut Vec<PathBuf>> {
        Some(&mut self.written)
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        Ok(self.written)
    }
}

impl StateFileOutput {
    fn write_if_due(
        &mut self,
        done: u64,
        write: impl FnOnce(&mut Vec<u8>) -> io::Result<()>,
    ) -> Result<(), OutputError> {
        if self.steps.contains(&done) {
            let path = self.names.state(done);
            save(&self.background, &path, write)?;
            self.written.push(path);
        }
        Ok(())
    }
}

/// Writes the state after the last completed step: per node coordinates,
/// velocity, force of the last evaluation, mass, boundary flag and node set;
/// per element its property code and nodes. Numbers read back to the same bits.
///
/// # Errors
/// If `output` refuses.
pub fn write_state(output: impl Write, simulation: &Simulation) -> io::Result<()> {
    let progress = (simulation.step_index(), simulation.time());
    write_scene(output, simulation.scene(), progress, simulation.forces(), simulation.masses())
}

/// The same in three dimensions. Forces are those of tetrahedra and contact; those of joints are
/// added when nodes move, as in the original.
///
/// # Errors
/// If `output` refuses.
pub fn write_spatial_state(output: impl Write, simulation: &SpatialSimulation) -> io::Result<()> {
    let progress = (simulation.step_index(), simulation.time());
    write_scene(output, simulation.scene(), progress, simulation.forces(), simulation.masses())
}

fn write_scene<const D: usize>(
    mut output: impl Write,
    scene: &Scene<D>,
    (step, time): (u64, f64),
    forces: &[SVector<f64, D>],
    masses: &[f64],
) -> io::Result<()> {
    let (nodes, elements) = (&scene.nodes, &scene.elements);
    writeln!(
        output,
        "# steps_done {step} time {time:e} nnopo {} nelem {}",
        nodes.len(),
        elements.len()
    )?;
    let columns = if D == 2 { "x y vx vy fx fy" } else { "x y z vx vy vz fx fy fz" };
    writeln!(output, "# node: id {columns} mass boundary_flag property")?;
    for n in 0..nodes.len() {
        write!(output, "{n}")?;
        for vector in [&nodes.current[n], &nodes.velocity[n], &forces[n]] {
            for component in vector {
                write!(output, " {component:e}")?;
            }
        }
        writeln!(output, " {:e} {} {}", masses[n], nodes.boundary_flag[n], nodes.set[n])?;
    }
    writeln!(output, "# element: id property nodes...")?;
    for e in 0..elements.len() {
        let code = scene.property_code(e);
        write!(output, "{e} {code}")?;
        for row in 0..elements.table_rows {
            write!(output, " {}", elements.node_number(e, row))?;
        }
        writeln!(output)?;
    }
    Ok(())
}
