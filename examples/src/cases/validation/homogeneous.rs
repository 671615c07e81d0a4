//! What the cases of a square or cube in a homogeneous state share.

use crate::{Bench, CaseError};
use std::ops::ControlFlow;
use ypsilon::{
    meshing::{Material, Scenario},
    scene::SpatialContact,
};

/// The state of a square or cube at the end of a run.
pub(super) struct State {
    /// Mean Cauchy stresses along, up, and of the shear between both \[Pa\].
    pub stress: [f64; 3],
    /// Largest mean of the other stresses of a cube; 0 for squares \[Pa\].
    pub across: f64,
    /// Largest difference of an element's stress from the mean \[Pa\].
    pub scatter: f64,
    /// Largest nodal force \[N\].
    pub force: f64,
    /// Mean height of the upper face above where it was \[m\].
    pub rise: f64,
}

/// What cases change of a square or cube.
pub(super) struct Body<'a> {
    /// What it is made of.
    pub material: &'a mut Material,
    /// Pressure on its upper face \[Pa\].
    pub pressure_pa: &'a mut f64,
    /// Time in which the pressure grows \[s\].
    pub ramp_s: &'a mut f64,
    /// Its height \[m\].
    pub height_m: f64,
}

/// The square or cube of a scenario.
pub(super) fn body(scenario: &mut Scenario) -> Result<Body<'_>, CaseError> {
    if let Some(cube) = &mut scenario.cube_3d {
        return Ok(Body {
            material: &mut cube.material,
            pressure_pa: &mut cube.pressure_pa,
            ramp_s: &mut cube.ramp_s,
            height_m: cube.size_m[2],
        });
    }
    let missing = || CaseError::missing("the scenario has no [cube] and no [cube_3d]");
    let cube = scenario.cube.as_mut().ok_or_else(missing)?;
    Ok(Body {
        material: &mut cube.material,
        pressure_pa: &mut cube.pressure_pa,
        ramp_s: &mut cube.ramp_s,
        height_m: cube.edge_m,
    })
}

/// Gives the square or cube a deformation gradient along and up.
pub(super) fn deform(
    scenario: &mut Scenario,
    [[a, b], [c, d]]: [[f64; 2]; 2],
) -> Result<(), CaseError> {
    if let Some(cube) = &mut scenario.cube_3d {
        cube.gradient = [[a, 0.0, b], [0.0, 1.0, 0.0], [c, 0.0, d]];
        return Ok(());
    }
    let missing = || CaseError::missing("the scenario has no [cube] and no [cube_3d]");
    scenario.cube.as_mut().ok_or_else(missing)?.gradient = [[a, b], [c, d]];
    Ok(())
}

/// Runs a scenario to its end.
pub(super) fn run(bench: &Bench, scenario: &Scenario, name: &str) -> Result<State, CaseError> {
    let law = SpatialContact::default();
    let done = bench.watch_any(scenario, name, law, |_| ControlFlow::Continue(()))?;
    let simulation = &done.simulation;
    if done.is_unstable {
        return Err(CaseError::missing(format!("{name} has become unstable")));
    }
    let up = simulation.up();
    let stresses: Vec<_> = simulation.bodies().iter().map(|&e| simulation.stress(e)).collect();
    let count = stresses.len() as f64;
    let mean = |i: usize, j: usize| stresses.iter().map(|s| s[i][j]).sum::<f64>() / count;
    let mut across = 0.0_f64;
    let mut scatter = 0.0_f64;
    for i in 0..=up {
        for j in 0..=up {
            let mean = mean(i, j);
            if up == 2 && (i == 1 || j == 1) {
                across = across.max(mean.abs());
            }
            let off = stresses.iter().map(|s| (s[i][j] - mean).abs()).fold(0.0, f64::max);
            scatter = scatter.max(off);
        }
    }
    let nodes = 0..simulation.masses().len();
    let size = |f: [f64; 3]| f.iter().map(|x| x * x).sum::<f64>().sqrt();
    let force = nodes.clone().map(|n| size(simulation.force(n))).fold(0.0, f64::max);
    let top = nodes.clone().map(|n| simulation.initial(n)[up]).fold(0.0, f64::max);
    let rises: Vec<f64> = nodes
        .filter(|&n| simulation.initial(n)[up] == top)
        .map(|n| simulation.current(n)[up] - top)
        .collect();
    let rise = rises.iter().sum::<f64>() / rises.len() as f64;
    Ok(State { stress: [mean(0, 0), mean(up, up), mean(0, up)], across, scatter, force, rise })
}
