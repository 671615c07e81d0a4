//! The seven files of an output step.

use super::Setup;
use crate::{
    mechanics::Vec2,
    scene::{ElementKind, JointKind},
    simulation::{JointFailure, Simulation, YieldMode},
};
use nalgebra::Matrix2;
use std::{
    collections::HashMap,
    io::{self, Write},
};
use yformat::ygeo_output::{
    self, AcousticEvent, BrokenJoint, ElementFrame, ElementFrameError, ElementState, ResultFile,
    YieldedJoint,
};

/// Modes below this are no failure.
const LEAST_MODE: f64 = 0.1;

pub(super) fn write(
    mut out: &mut impl Write,
    kind: ResultFile,
    simulation: &Simulation,
    setup: &Setup,
) -> io::Result<()> {
    match kind {
        ResultFile::Elements => with_elements(simulation, setup, |frame| frame.write(&mut out)),
        ResultFile::PrincipalDirections => {
            with_elements(simulation, setup, |frame| frame.write_principal_directions(&mut out))
        }
        ResultFile::BrokenJoints => {
            ygeo_output::write_broken_joints(&mut out, &broken_joints(simulation))
        }
        ResultFile::YieldedJoints => {
            ygeo_output::write_yielded_joints(&mut out, &yielded_joints(simulation))
        }
        ResultFile::AcousticEvents => {
            ygeo_output::write_acoustic_events(&mut out, &acoustic_events(simulation))
        }
        ResultFile::Rebars => ygeo_output::write_rebars(&mut out, &[]),
        ResultFile::OneDimensionalJoints => {
            ygeo_output::write_one_dimensional_joints(&mut out, &[])
        }
    }
}

fn with_elements(
    simulation: &Simulation,
    setup: &Setup,
    write: impl FnOnce(&ElementFrame<'_>) -> Result<(), ElementFrameError>,
) -> io::Result<()> {
    let scene = simulation.scene();
    let shown = |values: &[Vec2]| -> Vec<[f64; 2]> {
        setup.nodes.iter().map(|&n| values[n].into()).collect()
    };
    let coordinates = shown(&scene.nodes.current);
    let reference_coordinates = shown(&setup.reference);
    let velocities = shown(&scene.nodes.velocity);
    let forces = shown(simulation.forces());
    let mut elements = Vec::new();
    for material in 0..scene.materials.len() {
        if scene.materials[material].kind != ElementKind::ElasticTriangle {
            continue;
        }
        for element in 0..scene.elements.len() {
            if scene.elements.property[element] == material as i32 {
                elements.push(state(simulation, setup, element));
            }
        }
    }
    let frame = ElementFrame {
        coordinates: &coordinates,
        reference_coordinates: &reference_coordinates,
        velocities: &velocities,
        forces: &forces,
        fluid_pressures: &[],
        elements: &elements,
    };
    write(&frame).map_err(|error| match error {
        ElementFrameError::Io(error) => error,
        other => io::Error::other(other),
    })
}

fn state(simulation: &Simulation, setup: &Setup, element: usize) -> ElementState {
    let rows = |m: Matrix2<f64>| [[m[(0, 0)], m[(0, 1)]], [m[(1, 0)], m[(1, 1)]]];
    let (stress, strain) = simulation.present_state(element).unwrap_or_default();
    ElementState {
        corners: simulation.scene().elements.corners::<3>(element).map(|n| setup.place[n]),
        stress: rows(stress),
        strain: rows(strain),
        property: simulation.scene().elements.property[element],
    }
}

/// Joints in the order of their property sets.
fn joints_by_set(simulation: &Simulation) -> impl Iterator<Item = usize> + '_ {
    let scene = simulation.scene();
    let first = scene.materials.len();
    (0..scene.cohesive_laws.len()).flat_map(move |set| {
        let code = (first + set) as i32;
        (0..scene.elements.len()).filter(move |&e| {
            scene.elements.property[e] == code && scene.elements.joint_kind[e] != JointKind::NoJoint
        })
    })
}

pub(super) fn corners(simulation: &Simulation, joint: usize) -> [[f64; 2]; 4] {
    let scene = simulation.scene();
    scene.elements.corners::<4>(joint).map(|n| scene.nodes.current[n].into())
}

fn failures(simulation: &Simulation) -> HashMap<usize, &JointFailure> {
    simulation.failures().iter().map(|failure| (failure.element, failure)).collect()
}

fn broken_joints(simulation: &Simulation) -> Vec<BrokenJoint> {
    let failures = failures(simulation);
    let scene = simulation.scene();
    let excavated = |side: i32| {
        let triangle = usize::try_from(side).ok();
        triangle.and_then(|e| scene.material_of(e)).is_some_and(|m| m.is_excavated)
    };
    joints_by_set(simulation)
        .filter(|&e| {
            matches!(scene.elements.joint_kind[e], JointKind::Broken | JointKind::FreeEdge)
        })
        .map(|e| BrokenJoint {
            corners: corners(simulation, e),
            failure_mode: failures.get(&e).map_or(0.0, |failure| failure.mode),
            neighbour_excavated: scene.elements.sides[e].into_iter().any(excavated),
        })
        .collect()
}

/// How Y-Geo's files call the way in which a joint yields.
pub(super) fn yield_mode(mode: YieldMode) -> Option<ygeo_output::YieldMode> {
    ygeo_output::YieldMode::from_flag(mode as i64)
}

fn yielded_joints(simulation: &Simulation) -> Vec<YieldedJoint> {
    let failures = failures(simulation);
    joints_by_set(simulation)
        .filter(|&e| simulation.scene().elements.joint_kind[e] == JointKind::Intact)
        .filter(|e| failures.get(e).is_none_or(|failure| failure.mode < LEAST_MODE))
        .filter_map(|e| {
            let mode = yield_mode(simulation.joint_record(e)?.yielding.mode)?;
            Some(YieldedJoint { corners: corners(simulation, e), mode })
        })
        .collect()
}

fn acoustic_events(simulation: &Simulation) -> Vec<AcousticEvent> {
    let failures = failures(simulation);
    let heard = joints_by_set(simulation).filter_map(|e| {
        let (failure, record) = (failures.get(&e)?, simulation.joint_record(e)?);
        (failure.mode > 0.0 && record.release.largest > 0.0).then(|| AcousticEvent {
            position: failure.place.into(),
            energy: record.release.largest,
            fracture_energy: record.fracture_energy,
            failure_mode: failure.mode,
        })
    });
    heard.collect()
}
