//! 3.2.1: a block that slides and stops.

use crate::{
    Bench, Case, CaseError, Finding, Group, Length, Outcome, measure,
    plotting::{chart, function, marks},
};
use std::ops::ControlFlow;
use ypsilon::{
    meshing::{Scenario, TimeStepBounds},
    scene::{PressedFaces, SpatialContact},
};

/// The case.
pub const CASE: Case = Case {
    name: "sliding-block",
    group: Group::Validation,
    title: "Block that slides with friction",
    source: "thesis, section 3.2.1, figure 3.14, Eq. 3.8",
    about: "\
A block of l = 0.5 m (E = 300 MPa, ρ = 25000 kg/m³) slides on a held plane with µ = 0.5,
g = 10 m/s². It stops after d = v²/(2 µ g), at t = v/(µ g). The thesis prints neither ν nor the
penalty; ν = 0.2 and 30 MPa are taken, and no viscosity. The block swings on its contact, so that
the force between them varies around its weight; friction follows it, and the sum is right.

The thesis gives the limit l √(ρ/E) = 4.56 ms for the time step. That is the time of a wave along
an edge; the true limit is that of the stiffest mode of mesh and contact, 2/ω, which the generator
computes. Both are compared with the shortest step for which the motion diverges.",
    evaluate,
};

/// The same with tetrahedra.
pub const SOLID: Case = Case {
    name: "sliding-block-3d",
    group: Group::Solids,
    title: "Cube that slides with friction",
    source: "thesis, section 3.2.1, figure 3.14, Eq. 3.8",
    about: "\
A cube of l = 0.5 m (E = 300 MPa, ρ = 25000 kg/m³), six tetrahedra, slides on a held plane of cells of its
size with µ = 0.5, g = 10 m/s², with `--contact-friction`. It stops after d = v²/(2 µ g), at t = v/(µ g).
The thesis prints neither ν nor the penalties; ν = 0.2, 30 MPa, and 300 MPa along the surface are taken:
sliding from one tetrahedron to the next begins anew, over a distance of µ f/(p_t √A), which is to be short.",
    evaluate: evaluate_solid,
};

/// Friction, and the faces of one body pressed.
const LAW: SpatialContact = SpatialContact { pressed: PressedFaces::Contactor, has_friction: true };

fn evaluate_solid(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut points = Vec::new();
    let mut set = |velocity: f64, step: f64| -> Result<Scenario, CaseError> {
        let block = scenario.block_on_plane_3d.as_mut();
        let block = block.ok_or_else(|| CaseError::missing("there is no [block_on_plane_3d]"))?;
        block.velocity_m_s = velocity;
        scenario.run.step_s = Some(step);
        Ok(scenario.clone())
    };
    for velocity in bench.pick(vec![1.0, 2.0, 3.0, 4.0, 5.0], vec![1.0, 3.0]) {
        let (found, _) = slide(bench, &set(velocity, 1e-4)?, &format!("v{velocity}"), LAW)?;
        let [way, time] = found.unwrap_or([f64::NAN; 2]);
        let name = format!("stop distance at v = {velocity} m/s");
        findings.push(Finding::value(&name, "m", velocity.powi(2) / 10.0, way, 0.01));
        let name = format!("stop time at v = {velocity} m/s");
        findings.push(Finding::within(&name, "s", velocity / 5.0, time, 1e-2));
        points.push([velocity, way]);
    }
    if bench.length() == Length::Full {
        let both = SpatialContact { pressed: PressedFaces::Both, ..LAW };
        let (found, _) = slide(bench, &set(3.0, 1e-4)?, "both", both)?;
        let name = "motion at v = 3 m/s with `--contact two-sided`";
        let text = if found.is_some() { "stops" } else { "diverges" };
        findings.push(Finding::statement(name, "stops", text, found.is_some()));
        let way = found.map_or(f64::NAN, |[way, _]| way);
        let name = "stop distance at v = 3 m/s with `--contact two-sided`";
        findings.push(Finding::value(name, "m", 0.9, way, 0.01));
    }
    let frictionless = SpatialContact { has_friction: false, ..LAW };
    let (found, _) = slide(bench, &set(1.0, 1e-4)?, "smooth", frictionless)?;
    let way = found.map_or(f64::NAN, |[way, _]| way);
    let name = "way at v = 1 m/s in 0.29 s without `--contact-friction`";
    findings.push(Finding::value(name, "m", 0.29, way, 2e-3));
    for step in bench.pick(vec![1e-5, 5e-5, 2e-4, 4e-4], vec![2e-4]) {
        let (found, _) = slide(bench, &set(3.0, step)?, &format!("dt{step}"), LAW)?;
        let way = found.map_or(f64::NAN, |[way, _]| way);
        let name = format!("stop distance at v = 3 m/s, Δt = {step:e} s");
        findings.push(Finding::value(&name, "m", 0.9, way, 0.01));
    }
    let picture = chart(
        "Stop distance of a cube of tetrahedra, µ = 0.5, g = 10 m/s²",
        ["velocity (m/s)", "distance (m)"],
        &[
            function("v²/(2 µ g)", [0.0, 5.0], |v| v * v / 10.0),
            marks("Ypsilon", &points, [5.0, 2.5]),
        ],
    )?;
    let figure = bench.picture(&picture, "distance.png", "Stop distance against velocity")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}

/// How far and how long the block slides; none if the motion diverges.
fn slide(
    bench: &Bench,
    scenario: &Scenario,
    name: &str,
    law: SpatialContact,
) -> Result<(Option<[f64; 2]>, TimeStepBounds), CaseError> {
    let mut farthest = [0.0_f64, 0.0];
    let mut block: Vec<usize> = Vec::new();
    let mut first_energy = 0.0;
    let mut diverged = false;
    let mut stopped = false;
    let done = bench.watch_any(scenario, name, law, |simulation| {
        if block.is_empty() {
            let nodes = 0..simulation.masses().len();
            block = nodes.filter(|&n| simulation.velocity(n)[0] > 0.0).collect();
            first_energy = measure::kinetic_energy(simulation);
        }
        let way = measure::displacement(simulation, block.iter().copied())[0];
        farthest[0] = way.max(farthest[0]);
        let speed = measure::velocity(simulation, block.iter().copied())[0];
        if speed > 0.0 && !stopped {
            farthest[1] = simulation.time();
        }
        stopped |= speed <= 0.0;
        diverged |= measure::kinetic_energy(simulation) > 3.0 * first_energy;
        if diverged { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    })?;
    let sound = !diverged && !done.is_unstable;
    Ok((sound.then_some(farthest), done.bounds))
}

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut points = Vec::new();
    let mut set = |velocity: f64, step: f64| -> Result<Scenario, CaseError> {
        let block = scenario.block_on_plane.as_mut();
        let block = block.ok_or_else(|| CaseError::missing("there is no [block_on_plane]"))?;
        block.velocity_m_s = velocity;
        scenario.run.step_s = Some(step);
        Ok(scenario.clone())
    };
    for velocity in bench.pick(vec![1.0, 2.0, 3.0, 4.0, 5.0], vec![1.0, 3.0]) {
        let (found, _) = slide(bench, &set(velocity, 1e-4)?, &format!("v{velocity}"), LAW)?;
        let [way, time] = found.unwrap_or([f64::NAN; 2]);
        let name = format!("stop distance at v = {velocity} m/s");
        findings.push(Finding::value(&name, "m", velocity.powi(2) / 10.0, way, 0.01));
        let name = format!("stop time at v = {velocity} m/s");
        // the block swings on its contact with a period of 37 ms, and its friction with it
        findings.push(Finding::within(&name, "s", velocity / 5.0, time, 5e-3));
        points.push([velocity, way]);
    }
    for step in bench.pick(vec![1e-5, 1e-4, 5e-4, 1e-3, 2e-3], vec![5e-4]) {
        let (found, _) = slide(bench, &set(3.0, step)?, &format!("dt{step}"), LAW)?;
        let way = found.map_or(f64::NAN, |[way, _]| way);
        let name = format!("stop distance at v = 3 m/s, Δt = {step:e} s");
        findings.push(Finding::value(&name, "m", 0.9, way, 0.01));
    }
    let (mut stable, mut diverging) = (1e-3, 2e-2);
    let mut bounds = None;
    for round in 0..bench.pick(9, 5) {
        let step = f64::midpoint(stable, diverging);
        let (found, own) = slide(bench, &set(3.0, step)?, &format!("limit{round}"), LAW)?;
        bounds = Some(own);
        *(if found.is_some() { &mut stable } else { &mut diverging }) = step;
    }
    let limit = f64::midpoint(stable, diverging);
    let own = bounds.map_or(f64::NAN, |b| b.together_s);
    findings.push(
        Finding::range("the motion diverges above Δt", "s", [own, 2.0 * own], limit).noted(
            "the range starts at the generator's bound 2/ω of the assembled mesh with all \
             contacts closed; contacts of this block are closed on one face only",
        ),
    );
    let thesis = 0.5 * (25000.0_f64 / 300e6).sqrt();
    findings.push(
        Finding::told("limit of Δt by Eq. 3.8", "s", thesis, limit, "a rule of thumb")
            .noted("the thesis's Eq. 3.8 is a rule of thumb that knows neither mesh nor contact"),
    );
    let picture = chart(
        "Stop distance of a block, µ = 0.5, g = 10 m/s²",
        ["velocity (m/s)", "distance (m)"],
        &[
            function("v²/(2 µ g)", [0.0, 5.0], |v| v * v / 10.0),
            marks("Ypsilon", &points, [5.0, 2.5]),
        ],
    )?;
    let figure = bench.picture(&picture, "distance.png", "Stop distance against velocity")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
