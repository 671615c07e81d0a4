//! The period of a rocking block.

use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome,
    plotting::{chart, function, line, marks},
};
use std::ops::ControlFlow;
use ypsilon::meshing::{Scenario, kinds::RockingBlock};

/// The case.
pub const CASE: Case = Case {
    name: "rocking-block",
    group: Group::Classical,
    title: "Rocking block",
    source: "G. W. Housner, Bull. Seismol. Soc. Am. 53 (1963) 403-417",
    about: "\
A block 1 m high and 0.2 m wide (α = atan(1/5) = 11.3°, R = 0.51 m half its diagonal) is let go at
rest, tilted by θ₀. Housner's period for slender blocks is T = 4/p acosh(1/(1 − θ₀/α)) with
p = √(3 g/(4 R)). A quarter of it passes until the block stands upright for the first time; without
the assumption of small angles that is ∫ dθ/θ̇ with θ̇² = 2 p² (cos(α − θ) − cos(α − θ₀)), where
p² = m g R/I is taken with the moment of inertia I about the corner of the mesh's nodal masses:
masses at nodes lie farther out than those of the continuum (4/3 m R²).

For an ideal inelastic impact on the other corner Housner gives the ratio of the kinetic energies
after and before it, r = (1 − 3/2 sin² α)², in general (1 − m R²/I (1 − cos 2α))². Contact here is
elastic, of a potential, with nothing that dissipates in it; only vibration and the viscosity of the
block take energy. The part of the energy of rocking that is kept follows from the largest tilt to
the other side. It is nearly Housner's.",
    evaluate,
};

/// What a block does.
struct Rocking {
    /// Tilt by α through time.
    tilt: Vec<[f64; 2]>,
    /// When it stands upright first \[s\].
    upright: f64,
    /// Largest tilt to the other side, by α.
    other: f64,
    /// Moment of inertia of the nodal masses about the corner, by m R².
    inertia: f64,
}

fn rock(
    bench: &Bench,
    scenario: &Scenario,
    block: &RockingBlock,
    name: &str,
) -> Result<Rocking, CaseError> {
    let first = block.model()?.supports[0].nodes.len();
    let corners = [first, first + block.cells[0]];
    let mut tilt: Vec<[f64; 2]> = Vec::new();
    let done = bench.watch(scenario, name, |simulation| {
        if simulation.step_index().is_multiple_of(20) {
            let nodes = &simulation.scene().nodes.current;
            let d = nodes[corners[1]] - nodes[corners[0]];
            tilt.push([simulation.time(), d[1].atan2(d[0]) / block.slenderness()]);
        }
        ControlFlow::Continue(())
    })?;
    if done.is_unstable {
        return Err(CaseError::missing(format!("{name} has become unstable")));
    }
    let crossing = tilt.windows(2).find(|w| w[0][1] > 0.0 && w[1][1] <= 0.0);
    let upright = crossing
        .map_or(f64::NAN, |w| w[0][0] + (w[1][0] - w[0][0]) * w[0][1] / (w[0][1] - w[1][1]));
    let other = -tilt.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    let masses = &done.simulation.masses()[first..];
    let places = &done.simulation.scene().nodes.initial[first..];
    let sum: f64 = masses.iter().zip(places).map(|(m, x)| m * x.norm_squared()).sum();
    let inertia = sum / masses.iter().sum::<f64>() / block.radius_m().powi(2);
    Ok(Rocking { tilt, upright, other, inertia })
}

/// Time from rest at a tilt to upright, for any slenderness \[s\].
fn quarter(block: &RockingBlock, inertia: f64) -> f64 {
    let alpha = block.slenderness();
    let p = (block.gravity_m_s2.abs() / block.radius_m() / inertia).sqrt();
    let start = block.tilt * alpha;
    // θ = θ₀ − s² takes the root's pole away
    let n = 20000;
    let end = start.sqrt();
    let step = end / f64::from(n);
    let value = |k: i32| {
        let s = (f64::from(k) + 0.5) * step;
        let theta = start - s * s;
        let speed = p * (2.0 * ((alpha - theta).cos() - (alpha - start).cos())).abs().sqrt();
        2.0 * s / speed
    };
    (0..n).map(value).sum::<f64>() * step
}

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut lines = Vec::new();
    let mut points = Vec::new();
    for tilt in bench.pick(vec![0.2, 0.35, 0.5, 0.65, 0.8, 0.9], vec![0.5]) {
        let block = scenario.rocking_block.as_mut();
        let block = block.ok_or_else(|| CaseError::missing("there is no [rocking_block]"))?;
        block.tilt = tilt;
        let block = block.clone();
        let frequency = block.frequency_1_s();
        let rocking = rock(bench, &scenario, &block, &format!("tilt{tilt}"))?;
        let housner = (1.0 / (1.0 - tilt)).acosh() / frequency;
        let of = |what: &str| format!("{what}, θ₀ = {tilt} α");
        let time = rocking.upright;
        findings.push(Finding::value(&of("time until upright, T/4"), "s", housner, time, 0.03));
        let name = of("time until upright, large angles, nodal masses");
        findings.push(Finding::value(&name, "s", quarter(&block, rocking.inertia), time, 0.01));
        let alpha = block.slenderness();
        let energy = |tilt: f64| (alpha - tilt * alpha).cos() - alpha.cos();
        let kept = energy(rocking.other) / energy(tilt);
        let sin2 = 2.0 * alpha.sin().powi(2);
        let ideal = |inertia: f64| (1.0 - sin2 / inertia).powi(2);
        let name = of("energy kept in the impact, Housner's r");
        findings.push(Finding::value(&name, "", ideal(4.0 / 3.0), kept, 0.02));
        let name = of("energy kept in the impact, nodal masses");
        findings.push(Finding::value(&name, "", ideal(rocking.inertia), kept, 0.02));
        points.push([tilt, time * frequency]);
        if [0.2, 0.5, 0.8].contains(&tilt) {
            let shown = rocking.tilt.iter().step_by(5).copied().collect();
            lines.push(line(&format!("θ₀ = {tilt} α"), shown));
        }
    }
    let picture = chart("Tilt of a rocking block", ["time (s)", "tilt by α"], &lines)?;
    let first = bench.picture(&picture, "tilt.png", "Tilt through time")?;
    let picture = chart(
        "Time until upright",
        ["first tilt by α", "time by 1/p"],
        &[
            function("Housner: acosh(1/(1 − θ₀/α))", [0.05, 0.95], |t| {
                (1.0 / (1.0 - t)).acosh()
            }),
            marks("Ypsilon", &points, [0.9, 3.3]),
        ],
    )?;
    let second = bench.picture(&picture, "period.png", "A quarter of the period")?;
    Ok(Outcome { findings, pictures: vec![first, second] })
}
