//! What the two laws of contact of tetrahedra keep of a collision.

use crate::{
    Bench, Case, CaseError, Finding, Group, Length, Outcome, measure,
    plotting::{chart, line},
};
use std::ops::ControlFlow;
use ypsilon::{
    meshing::Scenario,
    scene::{PressedFaces, SpatialContact},
};

/// The case.
pub const CASE: Case = Case {
    name: "contact-laws-3d",
    group: Group::Solids,
    title: "A collision with one-sided and with two-sided contact",
    source: "mechanics: momentum, angular momentum and energy are kept",
    about: "\
Two soft cubes of 1 m of twelve tetrahedra (E = 258 MPa, ν = 0.17) collide at 5 m/s, the second one 0.31 m
beside and 0.17 m above the line, so that they turn. No friction, no viscosity, no gravity. Both laws run with
either cube first in the deck.

The original's law (`--contact one-sided`) presses the faces of the element with the higher number only and
shares the force among the nodes of the target by projections: energy is not quite kept, and the numbering
decides. `--contact two-sided` is the gradient of a potential: energy is kept but for the time step, whatever
the numbering. What is left goes down with the step: kinetic energy is that of velocities half a step away
from the places that strain and contact energy are those of.",
    evaluate,
};

/// What is left after a collision, by what there was before.
struct Balance {
    momentum: f64,
    /// Largest change of the angular momentum by the largest component before.
    angular_momentum: f64,
    energy: f64,
    /// Velocity of the left cube \[m/s\].
    velocity: [f64; 3],
    curve: Vec<[f64; 2]>,
}

fn collide(
    bench: &Bench,
    scenario: &Scenario,
    name: &str,
    law: SpatialContact,
) -> Result<Balance, CaseError> {
    let mut first: Option<[[f64; 3]; 2]> = None;
    let mut energy_before = f64::NAN;
    let mut curve = Vec::new();
    let done = bench.watch_in_space(scenario, name, law, |simulation| {
        if simulation.step_index().is_multiple_of(100) {
            let nodes = 0..simulation.masses().len();
            let energy = measure::kinetic_energy(simulation) + measure::strain_energy(simulation);
            if first.is_none() {
                energy_before = energy;
                first = Some([
                    measure::momentum(simulation, nodes.clone()),
                    measure::angular_momentum(simulation, nodes),
                ]);
            }
            curve.push([simulation.time(), energy / energy_before]);
        }
        ControlFlow::Continue(())
    })?;
    let (Some([momentum, angular]), false) = (first, done.is_unstable) else {
        return Err(CaseError::missing(format!("{name} has become unstable")));
    };
    let simulation = &done.simulation;
    let nodes = 0..simulation.masses().len();
    let size = |v: [f64; 3]| v.iter().map(|x| x.abs()).fold(0.0, f64::max);
    let change = |a: [f64; 3], b: [f64; 3]| size([0, 1, 2].map(|k| a[k] - b[k])) / size(a);
    let places = &simulation.scene().nodes.initial;
    let left: Vec<usize> = nodes.clone().filter(|&n| places[n][0] < 0.0).collect();
    let energy = measure::kinetic_energy(simulation) + measure::strain_energy(simulation);
    Ok(Balance {
        momentum: change(momentum, measure::momentum(simulation, nodes.clone())),
        angular_momentum: change(angular, measure::angular_momentum(simulation, nodes)),
        energy: energy / energy_before,
        velocity: measure::velocity(simulation, left),
        curve,
    })
}

/// That energy is kept, which full runs judge.
fn energy_kept(bench: &Bench, name: &str, energy: f64) -> Finding {
    match bench.length() {
        Length::Full => Finding::value(name, "", 1.0, energy, 1e-3),
        Length::Short => Finding::told(name, "", 1.0, energy, "judged in full runs"),
    }
}

/// What the time step costs of the energy under the two-sided law, each step half of the one before.
fn refine(bench: &Bench, scenario: &Scenario) -> Result<Vec<Finding>, CaseError> {
    let law = SpatialContact { pressed: PressedFaces::Both, has_friction: false };
    let mut findings = Vec::new();
    let mut errors = Vec::new();
    for step in bench.pick(vec![8e-6, 4e-6, 2e-6, 1e-6], vec![8e-6]) {
        let mut scenario = scenario.clone();
        scenario.run.step_s = Some(step);
        let balance = collide(bench, &scenario, &format!("dt{step:e}"), law)?;
        let name = format!("energy gained or lost, two-sided, Δt = {step:e} s");
        let error = (balance.energy - 1.0).abs();
        findings.push(Finding::told(&name, "", 0.0, error, "the time step's"));
        errors.push(error);
    }
    if bench.length() == Length::Full {
        let name = "energy gained or lost, two-sided, as the time step is halved";
        let falls = errors.windows(2).all(|pair| pair[1] < 0.75 * pair[0]);
        let text = if falls { "less each time" } else { "not less each time" };
        findings.push(Finding::statement(name, "less each time", text, falls));
    }
    Ok(findings)
}

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut lines = Vec::new();
    let laws = [("one-sided", PressedFaces::Contactor), ("two-sided", PressedFaces::Both)];
    for (name, pressed) in laws {
        let law = SpatialContact { pressed, has_friction: false };
        let mut velocities = Vec::new();
        for right_first in [false, true] {
            let mut scenario = scenario.clone();
            if let Some(cubes) = &mut scenario.two_cubes_3d {
                cubes.right_first = right_first;
            }
            let order = if right_first { "right cube first" } else { "left cube first" };
            let of = |what: &str| format!("{what}, {name}, {order}");
            let run = format!("{name}-{}", usize::from(right_first));
            let balance = collide(bench, &scenario, &run, law)?;
            let quantity = of("change of momentum, relative");
            findings.push(Finding::within(&quantity, "", 0.0, balance.momentum, 1e-11));
            let (angular, energy) =
                (of("change of angular momentum, relative"), of("energy after by energy before"));
            if pressed == PressedFaces::Both {
                let change = balance.angular_momentum;
                findings.push(Finding::within(&angular, "", 0.0, change, 1e-10));
                findings.push(energy_kept(bench, &energy, balance.energy));
            } else {
                let why = "the original's law does not keep it";
                let change = balance.angular_momentum;
                findings.push(Finding::told(&angular, "", 0.0, change, why));
                findings.push(Finding::told(&energy, "", 1.0, balance.energy, why));
            }
            velocities.push(balance.velocity);
            lines.push(line(&format!("{name}, {order}"), balance.curve));
        }
        let difference = (0..3).map(|k| velocities[0][k] - velocities[1][k]);
        let difference = difference.map(f64::abs).fold(0.0, f64::max);
        let quantity = format!("what the order in the deck changes of the velocity after, {name}");
        findings.push(if pressed == PressedFaces::Both && bench.length() == Length::Full {
            Finding::within(&quantity, "m/s", 0.0, difference, 1e-6)
        } else {
            Finding::told(&quantity, "m/s", 0.0, difference, "the numbering decides")
        });
    }
    findings.extend(refine(bench, &scenario)?);
    let title = "Energy of two cubes that collide";
    let axes = ["time (s)", "kinetic and strain energy by that before"];
    let picture = chart(title, axes, &lines)?;
    let caption = "Energy through time; during the contact a part is in the contact itself";
    let figure = bench.picture(&picture, "energy.png", caption)?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
