//! 3.2.3: damping by viscosity.

use super::homogeneous::body;
use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome, measure,
    plotting::{chart, line},
};
use std::{f64::consts::PI, ops::ControlFlow};
use ypsilon::{meshing::Scenario, scene::SpatialContact};

/// The case.
pub const CASE: Case = Case {
    name: "damping",
    group: Group::Validation,
    title: "Damping of a soft cube under its weight",
    source: "thesis, section 3.2.3, table 3.7",
    about: "\
A soft cube of 1 m (E = 26 kPa, ν = 0.2, ρ = 1000 kg/m³, elements of 0.1 to 0.2 m) on a held base
is left to its own weight. The viscosity D1PEKS η damps its swing. A bar's mode of angular frequency
ω has ξ = η ω/(2 E). The kinetic energy swings at twice the mode: its maxima are π/ω_d apart, and
decay as exp(−2 ξ ω t). The thesis prints twice the mode as w_n (18.68 to 19.00 rad/s) and
ξ = 0.1, 0.2, 0.4 for η = 500, 1020, 2040 Pa s; the cube is critically damped at about 5000 to
5100 Pa s. Here mode and ξ are measured from the maxima of the kinetic energy of a square in plane
strain.",
    evaluate,
};

/// The same with tetrahedra.
pub const SOLID: Case = Case {
    name: "damping-3d",
    group: Group::Solids,
    title: "Damping of a soft cube of tetrahedra under its weight",
    source: "thesis, section 3.2.3, table 3.7",
    about: "\
A soft cube of 1 m (E = 26 kPa, ν = 0.2, ρ = 1000 kg/m³, cells of 0.2 m of six tetrahedra) on a held
base is left to its own weight. A mode of angular frequency ω has ξ = η ω/(2 E) as a bar has; the
kinetic energy swings at twice the mode: its maxima are π/ω_d apart, and decay as exp(−2 ξ ω t). The
first axial mode of small strain is 8.07 rad/s; the strain under gravity (19 to 38 %) stiffens the cube to
about 9 rad/s. The thesis prints twice the mode as w_n (18.68 to 19.00 rad/s) and ξ = 0.1, 0.2, 0.4 for
η = 500, 1020, 2040 Pa s; critical at about 5000 to 5100 Pa s.",
    evaluate,
};

/// A swing of the cube.
struct Swing {
    /// Kinetic energy through time.
    energy: Vec<[f64; 2]>,
    /// Mean displacement through time.
    sag: Vec<[f64; 2]>,
}

impl Swing {
    /// Maxima of the kinetic energy, as long as they stand out.
    fn maxima(&self) -> Vec<[f64; 2]> {
        let largest = self.energy.iter().map(|e| e[1]).fold(0.0, f64::max);
        let mut found = Vec::new();
        for w in self.energy.windows(3) {
            let [[_, a], [t, b], [_, c]] = [w[0], w[1], w[2]];
            // other modes hide those that are smaller
            if b >= a && b > c && b > 1e-4 * largest {
                // the top of the parabola through three points
                let shift = 0.5 * (a - c) / (a - 2.0 * b + c);
                let step = w[1][0] - w[0][0];
                found.push([t + shift * step, b - 0.25 * (a - c) * shift]);
            }
        }
        found
    }

    /// Damped angular frequency of the mode and its decay rate, from a fit to the maxima.
    fn mode(&self) -> Option<[f64; 2]> {
        let maxima = self.maxima();
        // the first swing is the largest, and not of small strain
        let used: Vec<[f64; 2]> = maxima.iter().skip(1).take(6).copied().collect();
        let (first, last) = (used.first()?, used.last()?);
        let count = used.len() as f64 - 1.0;
        if count < 1.0 {
            return None;
        }
        let frequency = PI * count / (last[0] - first[0]);
        let decay = -(last[1] / first[1]).ln() / (last[0] - first[0]) / 2.0;
        Some([frequency, decay])
    }

    /// By how much the sag goes beyond where it ends.
    fn overshoot(&self) -> f64 {
        let end = self.sag.last().map_or(f64::NAN, |p| p[1]);
        let lowest = self.sag.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
        lowest / end - 1.0
    }
}

fn swing(bench: &Bench, scenario: &mut Scenario, viscosity: f64) -> Result<Swing, CaseError> {
    body(scenario)?.material.viscosity_pa_s = Some(viscosity);
    let (mut energy, mut sag) = (Vec::new(), Vec::new());
    let law = SpatialContact::default();
    let done = bench.watch_any(scenario, &format!("eta{viscosity}"), law, |simulation| {
        if simulation.step_index().is_multiple_of(10) {
            let nodes = simulation.masses().len();
            energy.push([simulation.time(), measure::kinetic_energy(simulation)]);
            let sunk = measure::displacement(simulation, 0..nodes)[simulation.up()];
            sag.push([simulation.time(), sunk]);
        }
        ControlFlow::Continue(())
    })?;
    if done.is_unstable {
        return Err(CaseError::missing(format!("η = {viscosity} has become unstable")));
    }
    Ok(Swing { energy, sag })
}

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let young = body(&mut scenario)?.material.young_pa;
    let mut findings = Vec::new();
    let mut lines = Vec::new();
    let mut slopes = Vec::new();
    for (viscosity, ratio, printed) in
        [(500.0, 0.1, 18.68), (1020.0, 0.2, 18.83), (2040.0, 0.4, 19.0)]
    {
        let swing = swing(bench, &mut scenario, viscosity)?;
        let Some([damped, decay]) = swing.mode() else {
            return Err(CaseError::missing(format!("η = {viscosity} does not swing")));
        };
        let mode = damped.hypot(decay);
        let xi = decay / mode;
        slopes.push(viscosity / xi);
        let of = |what: &str| format!("{what}, η = {viscosity} Pa s");
        let bar = viscosity * mode / (2.0 * young);
        findings.push(Finding::value(&of("ξ against η ω/(2 E)"), "", bar, xi, 0.15));
        findings.push(Finding::value(&of("ξ against table 3.7"), "", ratio, xi, 0.15));
        let name = of("w_n of table 3.7, twice the mode");
        findings.push(Finding::value(&name, "rad/s", printed, 2.0 * mode, 0.1));
        let name = format!("η = {viscosity} Pa s");
        let shown = swing.energy.iter().filter(|p| p[0] <= 1.5).step_by(5).copied().collect();
        lines.push(line(&name, shown));
    }
    let critical = slopes.iter().sum::<f64>() / slopes.len() as f64;
    findings.push(Finding::value("critical η, from η/ξ", "Pa s", 5050.0, critical, 0.15));
    let beyond = swing(bench, &mut scenario, 1.1 * critical)?;
    let over = beyond.overshoot();
    findings.push(Finding::within("overshoot at 1.1 times the critical η", "", 0.0, over, 2e-3));
    let below = swing(bench, &mut scenario, 0.5 * critical)?.overshoot();
    findings.push(Finding::range("overshoot at half the critical η", "", [0.02, 1.0], below));
    let shown = beyond.energy.iter().filter(|p| p[0] <= 1.5).step_by(5).copied().collect();
    lines.push(line(&format!("η = {:.0} Pa s", 1.1 * critical), shown));
    let title = "Kinetic energy of a cube under its weight";
    let picture = chart(title, ["time (s)", "kinetic energy (J)"], &lines)?;
    let figure = bench.picture(&picture, "energy.png", "Kinetic energy through time")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
