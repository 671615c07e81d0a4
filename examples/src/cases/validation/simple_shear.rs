//! 3.1.1: simple shear.

use super::homogeneous::{body, deform, run};
use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome,
    plotting::{chart, function, marks},
};

/// The case.
pub const CASE: Case = Case {
    name: "simple-shear",
    group: Group::Validation,
    title: "Simple shear",
    source: "thesis, section 3.1.1, Eq. 3.4, in plane form",
    about: "\
A square of 1 m, four triangles around a node in its middle, has its faces driven to the simple
shear F = [[1, γ], [0, 1]] with the base held; the node in the middle is free and finds its place.
E = 26.6 GPa, ν = 0.4 (µ = 9.5 GPa), ρ = 1000 kg/m³. The Cauchy stress of the law is
T = µ (B − I)/J + λ (J − 1/J)/2 I, so with J = 1 Txx = µ γ², Txy = µ γ, Tyy = 0. The thesis's z is
our y.",
    evaluate,
};

/// The same with tetrahedra.
pub const SOLID: Case = Case {
    name: "simple-shear-3d",
    group: Group::Solids,
    title: "Simple shear of a cube",
    source: "thesis, section 3.1.1, Eq. 3.4",
    about: "\
A cube of 1 m of twelve tetrahedra, eight corners and a centre, has its faces driven to the simple
shear F = [[1, 0, γ], [0, 1, 0], [0, 0, 1]] with the base held; the node in the middle is free and
finds its place. E = 26.6 GPa, ν = 0.4 (µ = 9.5 GPa, λ = 38 GPa), ρ = 1000 kg/m³. Expected:
Txx = µ γ², Txz = µ γ (in the rows \"Txy\": along and up), all others 0, the same in all twelve.",
    evaluate,
};

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mu = body(&mut scenario)?.material.mu();
    let mut findings = Vec::new();
    let (mut normal, mut shear) = (Vec::new(), Vec::new());
    let (mut worst, mut across) = (0.0_f64, 0.0_f64);
    for gamma in [-1.0, -0.5, 0.0, 0.5, 1.0] {
        deform(&mut scenario, [[1.0, gamma], [0.0, 1.0]])?;
        let state = run(bench, &scenario, &format!("shear{gamma}"))?;
        let [xx, yy, xy] = state.stress;
        normal.push([gamma, xx]);
        shear.push([gamma, xy]);
        worst = worst.max(state.scatter);
        across = across.max(yy.abs()).max(state.across);
        let names = [format!("Txx at γ = {gamma}"), format!("Txy at γ = {gamma}")];
        for (name, expected, obtained) in
            [(&names[0], mu * gamma * gamma, xx), (&names[1], mu * gamma, xy)]
        {
            findings.push(if expected == 0.0 {
                Finding::within(name, "Pa", 0.0, obtained, 1e-6 * mu)
            } else {
                Finding::value(name, "Pa", expected, obtained, 1e-6)
            });
        }
    }
    findings.push(Finding::within("largest of all other stresses", "Pa", 0.0, across, 1e-6 * mu));
    let name = "largest difference between elements";
    findings.push(Finding::within(name, "Pa", 0.0, worst, 1e-6 * mu));
    let picture = chart(
        "Simple shear",
        ["shear γ", "stress (Pa)"],
        &[
            function("Txx = µ γ²", [-1.0, 1.0], |g| mu * g * g),
            function("Txy = µ γ", [-1.0, 1.0], |g| mu * g),
            marks("Ypsilon Txx", &normal, [2.0, 2.0 * mu]),
            marks("Ypsilon Txy", &shear, [2.0, 2.0 * mu]),
        ],
    )?;
    let figure = bench.picture(&picture, "stress.png", "Stresses against the shear")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
