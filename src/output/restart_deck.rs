//! Restart decks and meshes as the classic dialect writes them (spec `outputs.md`
//! 3.4).
//!
//! The number of masses is written, which the original leaves 0, so that both
//! the original and Ypsilon read the deck.

use super::{
    Background, OutputError, OutputNames, ResultWriter, decode, encode, file_names, present, save,
};
use crate::{
    mechanics::{Vec2, aperture::Aperture},
    scene::JointKind,
    simulation::Simulation,
};
use std::{io, path::PathBuf};
use yformat::{
    classic_output::{JointState, MassCount, RestartDeck, RestartError, Table},
    database::Database,
    deck::Deck,
};

/// Writes a restart deck and a mesh at the deck's intervals and after the last step.
pub struct RestartDeckOutput {
    names: OutputNames,
    background: Background,
    /// The deck's values, which the state is put into.
    template: RestartDeck,
    /// Output steps so far.
    snapshots: u64,
    written: Vec<PathBuf>,
}

impl RestartDeckOutput {
    /// Restart decks of a run.
    #[must_use]
    pub fn new(names: &OutputNames, background: &Background) -> Self {
        let (template, written) = (RestartDeck::default(), Vec::new());
        let (names, background) = (names.clone(), background.clone());
        Self { names, background, template, snapshots: 0, written }
    }

    fn write(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let first = simulation.scene().snapshots.map_or(0, |s| s.first_number);
        let next = first + self.snapshots;
        let deck = fill_in(&self.template, simulation, next);
        let path = self.names.restart(next.saturating_sub(1));
        let background = &self.background;
        save(background, &path, |file| deck.write_to(file, MassCount::Correct).map_err(to_io))?;
        let mesh = self.names.mesh();
        save(background, &mesh, |file| deck.mesh().write_to(file))?;
        for path in [path, mesh] {
            if !self.written.contains(&path) {
                self.written.push(path);
            }
        }
        Ok(())
    }
}

fn to_io(error: RestartError) -> io::Error {
    match error {
        RestartError::Io(error) => error,
        other => io::Error::other(other),
    }
}

impl ResultWriter for RestartDeckOutput {
    fn begin_stage(&mut self, deck: &Deck, values: &Database) -> Result<(), OutputError> {
        let template = RestartDeck::from_values(deck, values).map_err(to_io);
        self.template = template.map_err(OutputError::io("the restart deck"))?;
        Ok(())
    }

    fn after_motion(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        self.snapshots += u64::from(simulation.is_output_step());
        Ok(())
    }

    fn after_step(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let interval = simulation.scene().snapshots.map_or(0, |s| s.restart_interval);
        let done = simulation.step_index();
        let is_last = done == simulation.scene().control.end_step;
        if interval > 0 && done > 1 && (done.is_multiple_of(interval) || is_last) {
            self.write(simulation)?;
        }
        Ok(())
    }

    fn kind(&self) -> &'static str {
        "restart"
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        encode(self.kind(), &(self.snapshots, file_names(self.kind(), &self.written)?))
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        _simulation: &Simulation,
    ) -> Result<(), OutputError> {
        let (snapshots, written) = decode::<(u32, Vec<String>)>(self.kind(), mark)?;
        self.snapshots = snapshots.into();
        self.written = present(names, &written)?;
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        Ok(self.written)
    }
}

/// The deck from which the run goes on after the step just completed.
fn fill_in(template: &RestartDeck, simulation: &Simulation, next_snapshot: u64) -> RestartDeck {
    let mut deck = template.clone();
    let scene = simulation.scene();
    deck.control.next_step = simulation.step_index() as i64;
    deck.control.time = simulation.time();
    deck.control.next_snapshot = next_snapshot as i64;
    fill_in_elements(&mut deck, simulation);
    let nodes = &mut deck.nodes;
    let vectors = |values: &[Vec2]| values.iter().map(|&v| v.into()).collect::<Vec<[f64; 2]>>();
    nodes.coordinates = vectors(&scene.nodes.current);
    nodes.initial_coordinates = vectors(&scene.nodes.initial);
    nodes.velocities = vectors(&scene.nodes.velocity);
    nodes.forces = vectors(simulation.forces());
    nodes.masses = simulation.masses().to_vec();
    nodes.boundary_flags = scene.nodes.boundary_flag.iter().map(|&f| i64::from(f)).collect();
    nodes.properties = scene.nodes.set.iter().map(|&s| i64::from(s)).collect();
    for (set, factor) in deck.properties.iter_mut().zip(simulation.edge_factors()) {
        set.load_factor = *factor;
        // meshing codes are used up
        set.mesh_code = set.mesh_code.min(0);
    }
    for (history, (value, time)) in deck
        .histories
        .iter_mut()
        .zip(simulation.probe_values().iter().zip(simulation.probe_times()))
    {
        (history.value, history.time) = (*value, *time);
    }
    deck
}

fn fill_in_elements(deck: &mut RestartDeck, simulation: &Simulation) {
    let Some(joints) = simulation.classic_joints() else { return };
    let scene = simulation.scene();
    let elements = &scene.elements;
    let columns = deck.elements.nodes.columns();
    let edges = usize::try_from(deck.elements.nodes_per_element).unwrap_or(3);
    let (mut nodes, mut strengths, mut around) = (Vec::new(), Vec::new(), Vec::new());
    deck.elements.kinds.clear();
    deck.elements.properties.clear();
    deck.joints.clear();
    for e in 0..elements.len() {
        let kind = elements.joint_kind[e];
        deck.elements.kinds.push(kind as i64);
        let code =
            scene.conventions.property_code(elements.property[e], kind, scene.materials.len());
        deck.elements.properties.push(i64::from(code));
        let of = |row: usize| elements.nodes[e].get(row).copied().unwrap_or(-1);
        nodes.extend((0..columns).map(|row| i64::from(of(row))));
        strengths.extend((0..columns).map(|point| joints.stored_strength(e, point)));
        let linked = match kind {
            JointKind::NoJoint => joints.joints_around(e).to_vec(),
            _ => elements.sides[e].to_vec(),
        };
        let linked = linked.into_iter().map(i64::from).chain(std::iter::repeat(-1));
        around.extend(linked.take(edges));
        if kind != JointKind::NoJoint {
            let aperture = joints.aperture(e).copied().unwrap_or_default();
            deck.joints.push(joint_state(e, &aperture));
        }
    }
    deck.elements.nodes = Table::new(columns, nodes);
    deck.elements.shear_strengths = Table::new(columns, strengths);
    deck.elements.joints = Table::new(edges, around);
}

fn joint_state(element: usize, a: &Aperture) -> JointState {
    JointState {
        element: element as i64,
        initial_normal_stiffness: a.initial_stiffness,
        normal_stiffness: a.normal_stiffness,
        shear_stiffness: a.shear_stiffness,
        normal_stress: a.normal_stress,
        shear_stress: a.shear_stress,
        initial_aperture: a.initial,
        aperture: a.current,
        hydraulic_aperture: a.hydraulic,
        residual_aperture: a.residual,
        shear_displacement: a.slip,
        dilation: a.dilation,
        peak_shear_displacement: a.peak_slip,
        fracture_length: a.length,
        roughness: a.roughness,
        wall_strength: a.wall_strength,
        asperity_angle: a.asperity_angle,
        failure_mode: a.failure_mode,
        fluid_pressure: a.fluid_pressure,
        fluid_entry_time: a.entry_time,
    }
}
