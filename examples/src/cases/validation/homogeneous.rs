//! What the cases of a square in a homogeneous state share.

use crate::{Bench, CaseError};
use std::ops::ControlFlow;
use ypsilon::meshing::{Scenario, kinds::Cube};

/// The state of a square at the end of a run.
pub(super) struct State {
    /// Mean Cauchy stresses xx, yy, xy \[Pa\].
    pub stress: [f64; 3],
    /// Largest difference of a triangle's stress from the mean \[Pa\].
    pub scatter: f64,
    /// Largest nodal force \[N\].
    pub force: f64,
    /// Mean height of the upper face above where it was \[m\].
    pub rise: f64,
}

/// The square of a scenario.
pub(super) fn cube(scenario: &mut Scenario) -> Result<&mut Cube, CaseError> {
    scenario.cube.as_mut().ok_or_else(|| CaseError::missing("the scenario has no [cube]"))
}

/// Runs a scenario to its end.
pub(super) fn run(bench: &Bench, scenario: &Scenario, name: &str) -> Result<State, CaseError> {
    let done = bench.watch(scenario, name, |_| ControlFlow::Continue(()))?;
    let simulation = &done.simulation;
    if done.is_unstable {
        return Err(CaseError::missing(format!("{name} has become unstable")));
    }
    let stresses: Vec<[f64; 3]> = simulation
        .triangles()
        .map(|e| &simulation.stresses()[e])
        .map(|t| [t[(0, 0)], t[(1, 1)], t[(0, 1)]])
        .collect();
    let count = stresses.len() as f64;
    let stress = [0, 1, 2].map(|k| stresses.iter().map(|s| s[k]).sum::<f64>() / count);
    let off = |s: &[f64; 3]| (0..3).map(|k| (s[k] - stress[k]).abs()).fold(0.0, f64::max);
    let scatter = stresses.iter().map(off).fold(0.0, f64::max);
    let force = simulation.forces().iter().map(|f| f.norm()).fold(0.0, f64::max);
    let nodes = &simulation.scene().nodes;
    let edge = nodes.initial.iter().map(|p| p[1]).fold(0.0, f64::max);
    let top: Vec<f64> = nodes
        .initial
        .iter()
        .zip(&nodes.current)
        .filter(|(x, _)| x[1] == edge)
        .map(|(x, y)| y[1] - x[1])
        .collect();
    let rise = top.iter().sum::<f64>() / top.len() as f64;
    Ok(State { stress, scatter, force, rise })
}
