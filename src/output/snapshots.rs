//! `.ym` snapshots and `contactforce.txt` as the classic dialect writes them
//! (spec `outputs.md` 1, 3.1).

use super::{
    Background, FilePosition, OutputError, OutputNames, ResultWriter, decode, encode, file_names,
    mark::mark_of, present, save,
};
use crate::{
    mechanics::Vec2,
    scene::{ElementKind, JointKind, SnapshotSettings},
    simulation::{EmissionStage, Simulation},
};
use std::{
    io::{self, BufWriter, Write},
    path::PathBuf,
};
use yformat::{
    classic_output::ContactForceSums,
    part_file::PartFile,
    ym::{
        AcousticSource, BoundaryJoint, Digits, FractureJoint, MeanVelocity, Record, Scales,
        SnapshotWriter, Triangle,
    },
};

/// Property set over whose nodes the original sums contact forces: fixed there.
const SUMMED_SET: i32 = 5;
/// More snapshots than any run writes.
const MOST_SNAPSHOTS: u64 = 1 << 60;

/// Writes one `.ym` file per output step and a line of contact forces with each.
pub struct SnapshotOutput {
    names: OutputNames,
    background: Background,
    /// Number of the next snapshot.
    number: u64,
    written: Vec<PathBuf>,
    /// Contact forces; `None` before an earlier run is gone on with.
    forces: Option<BufWriter<PartFile>>,
}

impl SnapshotOutput {
    /// Snapshots from the deck's first number on. A run whose first number is not
    /// 0 goes on with the contact forces that are there, as the original does.
    ///
    /// # Errors
    /// If the file of contact forces cannot be created or read.
    pub fn open(
        names: &OutputNames,
        background: &Background,
        simulation: &Simulation,
    ) -> Result<Self, OutputError> {
        let settings = simulation.scene().snapshots;
        let number = settings.map_or(0, |s| s.first_number);
        let path = names.contact_forces();
        let mut part = PartFile::create(&path).map_err(OutputError::io(&path))?;
        if number > 0 && path.exists() {
            let earlier = std::fs::read(&path).map_err(OutputError::io(&path))?;
            part.write_all(&earlier).map_err(OutputError::io(&path))?;
        }
        let forces = Some(BufWriter::new(part));
        let (names, background) = (names.clone(), background.clone());
        Ok(Self { names, background, number, written: Vec::new(), forces })
    }

    /// Snapshots of an earlier run, to be gone on with.
    #[must_use]
    pub fn closed(names: &OutputNames, background: &Background) -> Self {
        let (names, background) = (names.clone(), background.clone());
        Self { names, background, number: 0, written: Vec::new(), forces: None }
    }
}

impl ResultWriter for SnapshotOutput {
    fn after_motion(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        let Some(settings) = simulation.scene().snapshots else { return Ok(()) };
        if !simulation.is_output_step() {
            return Ok(());
        }
        let path = self.names.snapshot(self.number);
        save(&self.background, &path, |contents| {
            write_snapshot(contents, &settings, simulation).map(drop)
        })?;
        self.written.push(path);
        self.number += 1;
        let Some(forces) = &mut self.forces else { return Ok(()) };
        writeln!(forces, "{}", contact_force_sums(simulation))
            .map_err(OutputError::io(self.names.contact_forces()))
    }

    fn kind(&self) -> &'static str {
        "ym"
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        let kind = self.kind();
        let Some(forces) = &mut self.forces else { return Err(OutputError::Mark { kind }) };
        let position = mark_of(forces).map_err(OutputError::io(self.names.contact_forces()))?;
        encode(kind, &(self.number, file_names(kind, &self.written)?, position))
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        _simulation: &Simulation,
    ) -> Result<(), OutputError> {
        let (number, written, position): (u64, Vec<String>, FilePosition) =
            decode(self.kind(), mark)?;
        if number > MOST_SNAPSHOTS {
            return Err(OutputError::Mark { kind: self.kind() });
        }
        self.number = number;
        self.written = present(names, &written)?;
        let path = names.contact_forces();
        let part = PartFile::resume(&path, &position.into()).map_err(OutputError::changed(path))?;
        self.forces = Some(BufWriter::new(part));
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        let path = self.names.contact_forces();
        let Some(forces) = self.forces else { return Ok(self.written) };
        let part = forces.into_inner().map_err(|e| OutputError::io(&path)(e.into_error()))?;
        let mut written = self.written;
        written.push(part.complete().map_err(OutputError::io(path))?);
        Ok(written)
    }
}

fn contact_force_sums(simulation: &Simulation) -> ContactForceSums {
    let mut sums = ContactForceSums::default();
    for (force, &set) in simulation.contact_forces().iter().zip(&simulation.scene().nodes.set) {
        for k in 0..2 {
            sums.magnitudes[k] += force[k].abs();
            if set == SUMMED_SET {
                sums.of_property_5[k] += force[k];
            }
        }
    }
    sums
}

/// Writes the records of all triangles, joints and acoustic sources, property set
/// by property set; every set of joints writes all joints.
fn write_snapshot<W: Write>(
    output: W,
    settings: &SnapshotSettings,
    simulation: &Simulation,
) -> io::Result<W> {
    let scales = Scales {
        coordinate: settings.coordinate,
        force: settings.force,
        stress: settings.stress,
        velocity: settings.velocity,
        displacement: settings.displacement,
        aperture: settings.aperture,
    };
    let digits = Digits::new(i64::from(settings.digits))
        .ok_or_else(|| io::Error::other("ICOUTP asks for numbers without digits"))?;
    let mut writer = SnapshotWriter::new(output, digits, scales)?;
    let scene = simulation.scene();
    for property in 0..scene.materials.len() {
        let material = &scene.materials[property];
        if !matches!(material.kind, ElementKind::Inert(_)) {
            for element in 0..scene.elements.len() {
                if scene.elements.property[element] == property as i32 {
                    writer.write(&triangle(simulation, element, property))?;
                }
            }
        }
        if scene.cohesive_laws.get(property).is_some_and(|law| law.is_cohesive) {
            for element in 0..scene.elements.len() {
                if let Some(record) = joint(simulation, element) {
                    writer.write(&record)?;
                }
            }
            for element in 0..scene.elements.len() {
                if let Some(record) = source(simulation, element) {
                    writer.write(&record)?;
                }
            }
        }
    }
    Ok(writer.into_inner())
}

fn triangle(simulation: &Simulation, element: usize, property: usize) -> Record {
    let scene = simulation.scene();
    let nodes = scene.elements.corners::<3>(element);
    let elastic = scene.materials[property].kind == ElementKind::ElasticTriangle;
    let stress = simulation.present_stress(element).unwrap_or_default();
    let force = boundary_force(simulation, element);
    Record::Triangle(Triangle {
        corners: nodes.map(|n| scene.nodes.current[n].into()),
        velocity: MeanVelocity::of_corners(nodes.map(|n| scene.nodes.velocity[n].into())),
        stress: [stress[(0, 0)], stress[(1, 1)], stress[(0, 1)]],
        damage: 0.0,
        contact_force: elastic.then_some(force.into()),
    })
}

fn boundary_force(simulation: &Simulation, element: usize) -> Vec2 {
    let forces = &simulation.contact_tally().boundary_force;
    forces.get(element).copied().unwrap_or_default()
}

/// Record of a joint that is an edge of the model or a fracture.
fn joint(simulation: &Simulation, element: usize) -> Option<Record> {
    let elements = &simulation.scene().elements;
    let nodes = || {
        let corners = elements.corners::<4>(element);
        corners.map(|n| simulation.scene().nodes.current[n].into())
    };
    let sides = elements.sides[element].map(|side| usize::try_from(side).ok());
    match elements.joint_kind[element] {
        JointKind::FreeEdge => {
            let force = sides[0].map_or(Vec2::zeros(), |e| boundary_force(simulation, e));
            let contact_force = force.into();
            Some(Record::BoundaryJoint(BoundaryJoint { nodes: nodes(), contact_force }))
        }
        JointKind::PreExisting | JointKind::Broken => {
            let aperture = simulation.classic_joints()?.aperture(element)?;
            let sliding = &simulation.contact_tally().sliding_force;
            let force = |side: Option<usize>| {
                side.and_then(|e| sliding.get(e)).map_or(0.0, |f: &f64| f.abs())
            };
            Some(Record::FractureJoint(FractureJoint {
                nodes: nodes(),
                failure_mode: aperture.failure_mode,
                normal_stress: aperture.normal_stress,
                shear_stress: aperture.shear_stress,
                sliding_force: (force(sides[0]) + force(sides[1])) / 2.0,
                aperture: aperture.current,
                shear_displacement: aperture.slip.abs(),
                dilation: aperture.dilation,
                hydraulic_aperture: aperture.hydraulic,
            }))
        }
        JointKind::Intact | JointKind::NoJoint => None,
    }
}

/// Record of a joint whose breaking was heard.
fn source(simulation: &Simulation, element: usize) -> Option<Record> {
    let emission = simulation.classic_joints()?.emission(element)?;
    if emission.stage != EmissionStage::Broken {
        return None;
    }
    let scene = simulation.scene();
    let [a, b, c, d] = scene.elements.corners::<4>(element).map(|n| scene.nodes.current[n]);
    let position = ((a + b + c + d) / 4.0).into();
    Some(Record::AcousticSource(AcousticSource { position, magnitude: emission.magnitude }))
}
