//! Full-precision state files in the text form of the reference states: for
//! debugging and for comparison with other programs.

use super::{Background, OutputError, OutputNames, ResultWriter, save};
use crate::simulation::Simulation;
use std::{
    collections::BTreeSet,
    io::{self, Write},
    path::PathBuf,
};

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
        let done = simulation.step_index();
        if self.steps.contains(&done) {
            let path = self.names.state(done);
            save(&self.background, &path, |contents| write_state(contents, simulation))?;
            self.written.push(path);
        }
        Ok(())
    }

    fn kind(&self) -> &'static str {
        "state"
    }

    fn series(&mut self) -> Option<&mut Vec<PathBuf>> {
        Some(&mut self.written)
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        Ok(self.written)
    }
}

/// Writes the state after the last completed step: per node coordinates,
/// velocity, force of the last evaluation, mass, boundary flag and node set;
/// per element its property code and nodes. Numbers read back to the same bits.
///
/// # Errors
/// If `output` refuses.
pub fn write_state(mut output: impl Write, simulation: &Simulation) -> io::Result<()> {
    let scene = simulation.scene();
    let (nodes, elements) = (&scene.nodes, &scene.elements);
    writeln!(
        output,
        "# steps_done {} time {:e} nnopo {} nelem {}",
        simulation.step_index(),
        simulation.time(),
        nodes.len(),
        elements.len()
    )?;
    writeln!(output, "# node: id x y vx vy fx fy mass boundary_flag property")?;
    for n in 0..nodes.len() {
        let (x, v, f) = (nodes.current[n], nodes.velocity[n], simulation.forces()[n]);
        writeln!(
            output,
            "{n} {:e} {:e} {:e} {:e} {:e} {:e} {:e} {} {}",
            x.x,
            x.y,
            v.x,
            v.y,
            f.x,
            f.y,
            simulation.masses()[n],
            nodes.boundary_flag[n],
            nodes.set[n]
        )?;
    }
    writeln!(output, "# element: id property nodes...")?;
    for e in 0..elements.len() {
        let code = scene.conventions.property_code(
            elements.property[e],
            elements.joint_kind[e],
            scene.materials.len(),
        );
        write!(output, "{e} {code}")?;
        for row in 0..elements.table_rows {
            write!(output, " {}", elements.nodes[e].get(row).copied().unwrap_or(-1))?;
        }
        writeln!(output)?;
    }
    Ok(())
}
