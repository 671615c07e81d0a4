//! What the impacts share.

use crate::{Bench, CaseError, measure, plotting::line};
use std::ops::ControlFlow;
use ypsilon::{meshing::Scenario, scene::SpatialContact};
use ypsilon_post::plot::Curve;

/// What an impact does.
pub(super) struct Impact {
    /// Velocities after it \[m/s\].
    pub velocities: [f64; 2],
    /// Momentum before and after it \[kg m/s\].
    pub momenta: [f64; 2],
    /// Kinetic energy of the blocks' mean motions before and after it \[J\].
    pub rigid: [f64; 2],
    /// All kinetic energy after it \[J\].
    pub kinetic: f64,
    /// Strain energy after it \[J\].
    pub strain: f64,
    /// Velocities through time.
    pub curves: [Curve; 2],
}

/// Runs an impact. Velocities after it are means over the last tenth of the run.
pub(super) fn collide(
    bench: &Bench,
    scenario: &Scenario,
    name: &str,
    ratio: f64,
) -> Result<Impact, CaseError> {
    let mut scenario = scenario.clone();
    match (&mut scenario.two_blocks, &mut scenario.two_cubes_3d) {
        (Some(blocks), _) => blocks.mass_ratio = ratio,
        (_, Some(cubes)) => cubes.mass_ratio = ratio,
        _ => return Err(CaseError::missing("the scenario has no blocks")),
    }
    let mut curves = [1, 2].map(|k| line(&format!("block {k}, m₂/m₁ = {ratio}"), Vec::new()));
    let mut momenta = [f64::NAN; 2];
    let mut rigid = [f64::NAN; 2];
    let mut last = [f64::NAN; 2];
    let law = SpatialContact::default();
    let done = bench.watch_any(&scenario, name, law, |simulation| {
        let nodes = simulation.masses().len();
        let halves = [0..nodes / 2, nodes / 2..nodes];
        if !simulation.step_index().is_multiple_of(200)
            && simulation.step_index() < simulation.end_step()
        {
            return ControlFlow::Continue(());
        }
        last = halves.clone().map(|half| measure::velocity(simulation, half)[0]);
        for (curve, v) in curves.iter_mut().zip(last) {
            curve.points.push([simulation.time(), v]);
        }
        momenta[1] = measure::momentum(simulation, 0..nodes)[0];
        let masses = halves.map(|half| measure::mass(simulation, half));
        rigid[1] = (0..2).map(|k| 0.5 * masses[k] * last[k] * last[k]).sum();
        if simulation.step_index() == 0 {
            (momenta[0], rigid[0]) = (momenta[1], rigid[1]);
        }
        ControlFlow::Continue(())
    })?;
    if done.is_unstable {
        return Err(CaseError::missing(format!("{name} has become unstable")));
    }
    let (kinetic, strain) =
        (measure::kinetic_energy(&*done.simulation), measure::strain_energy(&*done.simulation));
    Ok(Impact { velocities: last, momenta, rigid, kinetic, strain, curves })
}
