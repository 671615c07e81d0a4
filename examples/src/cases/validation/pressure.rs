//! 3.1.2, table 3.1: "locking" of a pressed, confined square.

use super::homogeneous::{body, run};
use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome,
    plotting::{chart, line, marks},
};
use ypsilon::meshing::Scenario;

/// The case.
pub const CASE: Case = Case {
    name: "pressure",
    group: Group::Validation,
    title: "Confined square under pressure, ν up to 0.49999 (\"locking\")",
    source: "thesis, section 3.1.2, table 3.1, in plane form",
    about: "\
A square of 1 m with its base and its sides on rollers is pressed by the stress that belongs to
α = −0.01, for ν from 0 to 0.49999, E = 26 GPa. Slips of the thesis: the text says 10 %, the table
is for 1 %; the stresses headed MPa are GPa.

Table 3.1 finds errors of α up to 1 % and calls them locking. There is none: the state is
homogeneous, which any mesh represents. Its stresses were taken from the law with λ ln J / J
(column *law 1*), while the program's law has (λ/2)(J − 1/J). Both are computed here:
- the stress of the program's own law gives α = −0.01 for every ν;
- the stress of law 1 gives the thesis's α (−0.01, −0.010011, −0.010025, −0.010043, −0.010067,
  −0.010082, −0.010096, −0.0101, −0.0101).",
    evaluate,
};

/// The same with tetrahedra.
pub const SOLID: Case = Case {
    name: "pressure-3d",
    group: Group::Solids,
    title: "Confined cube under pressure, ν up to 0.49999 (\"locking\")",
    source: "thesis, section 3.1.2, table 3.1",
    about: "\
The cube of twelve tetrahedra with its base and its sides on rollers is pressed by the stress that
belongs to α = −0.01, for all nine ν of table 3.1, E = 26 GPa. Of the force on the face, nodes on its
diagonal bear a third each, the others a sixth. As in the plane there is no locking: the state is
homogeneous, and the column of the thesis is that of two laws ([pressure](../../validation/pressure)).
- The stress of the program's own law gives α = −0.01 for every ν;
- the stress of λ ln J / J gives the thesis's α.",
    evaluate,
};

/// ν with the α and the stress that table 3.1 prints (GPa, not MPa).
const TABLE: [(f64, f64, f64); 9] = [
    (0.0, -0.01, -0.2613),
    (0.1, -0.010011, -0.2676),
    (0.2, -0.010025, -0.2911),
    (0.3, -0.010043, -0.3533),
    (0.4, -0.010067, -0.5637),
    (0.45, -0.010082, -0.9994),
    (0.49, -0.010096, -4.515),
    (0.4999, -0.0101, -440.0),
    (0.49999, -0.0101, -4399.0),
];
/// What the square should shrink by.
const ALPHA: f64 = -0.01;

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let (mut own, mut printed, mut mixed) = (Vec::new(), Vec::new(), Vec::new());
    for (row, (poisson, alpha, stress)) in TABLE.into_iter().enumerate() {
        let part = pressed(&mut scenario, poisson)?;
        let material = *body(&mut scenario)?.material;
        let j: f64 = 1.0 + ALPHA;
        let shear = material.mu() * (j * j - 1.0) / j;
        let ours = shear + material.lambda() * (j - 1.0 / j) / 2.0;
        let theirs = shear + material.lambda() * j.ln() / j;
        *body(&mut scenario)?.pressure_pa = -ours;
        let rise = run(bench, &scenario, &format!("own{row}"))?.rise;
        let name = format!("α under the law's own stress, ν = {poisson}");
        findings.push(Finding::value(&name, "", ALPHA, rise, 1e-6));
        own.push([part, 100.0 * (rise / ALPHA - 1.0)]);
        *body(&mut scenario)?.pressure_pa = -theirs;
        let rise = run(bench, &scenario, &format!("mixed{row}"))?.rise;
        let name = format!("stress of law 1, ν = {poisson}");
        // four digits are printed; the last three rows have fewer
        findings.push(Finding::value(&name, "Pa", 1e9 * stress, theirs, 1.5e-3));
        let name = format!("α under the stress of law 1, ν = {poisson}");
        findings.push(Finding::value(&name, "", alpha, rise, 1e-4));
        mixed.push([part, 100.0 * (rise / ALPHA - 1.0)]);
        printed.push([part, 100.0 * (alpha / ALPHA - 1.0)]);
    }
    let picture = chart(
        "Error of α: two laws, not locking",
        ["λ/(λ + µ) = 2ν", "error (%)"],
        &[
            line("stress of the law itself", own),
            line("stress of law 1", mixed),
            marks("thesis", &printed, [1.0, 1.1]),
        ],
    )?;
    let figure = bench.picture(&picture, "error.png", "Error of α against Poisson's ratio")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}

/// Sets Poisson's ratio, and with it times and a viscosity that stop the square. Returns 2 ν.
fn pressed(scenario: &mut Scenario, poisson: f64) -> Result<f64, CaseError> {
    let body = body(scenario)?;
    body.material.poisson = poisson;
    let modulus = body.material.lambda() + 2.0 * body.material.mu();
    let speed = (modulus / body.material.density_kg_m3).sqrt();
    let crossing = body.height_m / speed;
    body.material.viscosity_pa_s = Some(modulus * crossing);
    *body.ramp_s = 10.0 * crossing;
    scenario.run.end_s = Some(60.0 * crossing);
    Ok(2.0 * poisson)
}
