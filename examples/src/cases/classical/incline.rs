//! A block on an incline.

use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome, measure,
    plotting::{chart, function, marks},
};
use std::ops::ControlFlow;
use ypsilon::meshing::Scenario;

/// The case.
pub const CASE: Case = Case {
    name: "incline",
    group: Group::Classical,
    title: "Block on an incline",
    source: "C. A. Coulomb, Théorie des machines simples (1785); any textbook of mechanics",
    about: "\
A block of 0.5 m lies at rest on a plane that falls by an angle β, µ = 0.5. It stays below
atan µ = 26.57° and slides with a = g (sin β − µ cos β) above. The deck's gravity acts along y
only, so the plane is turned, not gravity. The weight comes at once: the block settles by its
elastic displacement on the tangential penalty, which counts as staying.",
    evaluate,
};

/// Mean acceleration down the plane and displacement at the end.
fn slide(bench: &Bench, scenario: &Scenario, name: &str) -> Result<[f64; 2], CaseError> {
    let block = scenario.block_on_plane.as_ref();
    let block = block.ok_or_else(|| CaseError::missing("there is no [block_on_plane]"))?;
    let held = block.model()?.supports[0].nodes.len();
    let (sin, cos) = block.incline_deg.to_radians().sin_cos();
    let (mut early, mut late) = ([0.0; 2], [0.0; 2]);
    let mut way = 0.0;
    let done = bench.watch(scenario, name, |simulation| {
        let nodes = held..simulation.masses().len();
        let [vx, vy, _] = measure::velocity(simulation, nodes.clone());
        let [ux, uy, _] = measure::displacement(simulation, nodes);
        way = ux * cos - uy * sin;
        late = [simulation.time(), vx * cos - vy * sin];
        if simulation.time() < 0.1 {
            early = late;
        }
        ControlFlow::Continue(())
    })?;
    if done.is_unstable {
        return Err(CaseError::missing(format!("{name} has become unstable")));
    }
    Ok([(late[1] - early[1]) / (late[0] - early[0]), way])
}

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut points = Vec::new();
    let gravity = 9.81;
    let law = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        (gravity * (sin - 0.5 * cos)).max(0.0)
    };
    let angles = vec![10.0, 20.0, 25.0, 26.0, 27.0, 28.0, 30.0, 35.0, 40.0];
    for degrees in bench.pick(angles, vec![20.0, 26.0, 28.0, 35.0]) {
        let block = scenario.block_on_plane.as_mut();
        let block = block.ok_or_else(|| CaseError::missing("there is no [block_on_plane]"))?;
        block.incline_deg = degrees;
        let [acceleration, way] = slide(bench, &scenario, &format!("angle{degrees}"))?;
        let expected = law(degrees);
        if expected == 0.0 {
            let name = format!("displacement after 1 s at {degrees}°");
            findings.push(Finding::within(&name, "m", 0.0, way, 1e-3));
            points.push([degrees, 0.0]);
        } else {
            let name = format!("acceleration at {degrees}°");
            let by = 0.01 * expected + 0.002 * gravity;
            findings.push(Finding::within(&name, "m/s²", expected, acceleration, by));
            points.push([degrees, acceleration]);
        }
    }
    let picture = chart(
        "Block on an incline, µ = 0.5",
        ["angle (°)", "acceleration (m/s²)"],
        &[
            function("g (sin β − µ cos β)", [10.0, 40.0], law),
            marks("Ypsilon", &points, [30.0, 2.6]),
        ],
    )?;
    let figure = bench.picture(&picture, "acceleration.png", "Acceleration against the angle")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
