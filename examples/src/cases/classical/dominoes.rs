//! The speed of toppling dominoes.

use super::domino_theory::Row;
use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome,
    plotting::{chart, function, marks},
};
use std::ops::ControlFlow;
use ypsilon::meshing::{Scenario, kinds::Dominoes};

/// The case.
pub const CASE: Case = Case {
    name: "dominoes",
    group: Group::Classical,
    title: "Speed of toppling dominoes",
    source: "J. M. J. van Leeuwen, Am. J. Phys. 78 (2010) 721-727 (arXiv:physics/0401018), without \
             friction; D. E. Shaw, Am. J. Phys. 46 (1978) 640-642",
    about: "\
A row of dominoes 48 mm high and 7.5 mm thick, hinged at their lower front edges, without friction
between them. A domino that is hit leans on the next one and turns with it, all of them as one
mechanism of the angle of the foremost; hits are plastic. That gives an asymptotic speed
(`domino_theory.rs`), a multiple of √(g h) that depends on gap and thickness only.

Contact here is elastic: a domino is thrown off by a hit and is caught up again, so a plastic hit is
the limit of many of them. Soft, viscous dominoes come close to it.",
    evaluate,
};

/// When each domino has turned by half a degree \[s\].
fn arrivals(
    bench: &Bench,
    scenario: &Scenario,
    row: &Dominoes,
    name: &str,
) -> Result<Vec<f64>, CaseError> {
    let hinges = row.model()?.supports[1].nodes.clone();
    let height = row.cells[1] * (row.cells[0] + 1);
    let mut times: Vec<f64> = Vec::new();
    let mut before = 0.0;
    let done = bench.watch(scenario, name, |simulation| {
        let nodes = &simulation.scene().nodes.current;
        let Some(&hinge) = hinges.get(times.len()) else { return ControlFlow::Break(()) };
        let d = nodes[hinge + height] - nodes[hinge];
        let angle = d[0].atan2(d[1]).to_degrees();
        let step = simulation.scene().control.time_step;
        if angle > 0.5 {
            times.push(simulation.time() - step * (angle - 0.5) / (angle - before).max(1e-12));
            before = 0.0;
        } else {
            before = angle;
        }
        ControlFlow::Continue(())
    })?;
    if done.is_unstable {
        return Err(CaseError::missing(format!("{name} has become unstable")));
    }
    Ok(times)
}

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut points = Vec::new();
    let own = scenario.dominoes.clone();
    let own = own.ok_or_else(|| CaseError::missing("the scenario has no [dominoes]"))?;
    let theory = |part: f64| Row {
        thickness: own.thickness_m,
        height: own.height_m,
        gap: part * own.height_m,
        gravity: own.gravity_m_s2.abs(),
    };
    let unit = (own.gravity_m_s2.abs() * own.height_m).sqrt();
    for part in bench.pick(vec![0.2, 0.333, 0.5, 0.65], vec![0.333]) {
        let row = scenario.dominoes.as_mut();
        let row = row.ok_or_else(|| CaseError::missing("the scenario has no [dominoes]"))?;
        row.gap_m = part * own.height_m;
        let row = row.clone();
        let times = arrivals(bench, &scenario, &row, &format!("gap{part}"))?;
        let pitch = row.gap_m + row.thickness_m;
        // without the start, and the last ones, which have nothing to lean on
        let (first, last) = (times.len() / 2, times.len().saturating_sub(2));
        let speed = match (times.get(first), times.get(last)) {
            (Some(a), Some(b)) if last > first => (last - first) as f64 * pitch / (b - a),
            _ => f64::NAN,
        };
        let name = format!("speed at a gap of {part} h");
        findings.push(Finding::value(&name, "m/s", theory(part).speed(), speed, 0.1));
        points.push([part, speed / unit]);
    }
    let picture = chart(
        "Speed of toppling dominoes, thickness 0.156 h",
        ["gap by height", "speed by √(g h)"],
        &[
            function("van Leeuwen, without friction", [0.1, 0.8], |p| theory(p).speed() / unit),
            marks("Ypsilon", &points, [0.7, 1.5]),
        ],
    )?;
    let figure = bench.picture(&picture, "speed.png", "Speed against the gap")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
