//! 3.1.4: contact of a bar with a rigid wall.

use super::two_bars::{displacement, set, with_overlap};
use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome,
    plotting::{chart, function, line, marks},
};

/// The case.
pub const CASE: Case = Case {
    name: "one-bar",
    group: Group::Validation,
    title: "Contact of a bar with a rigid wall",
    source: "thesis, section 3.1.4, figure 3.12",
    about: "\
The left bar of the two bars against a held one. Once the gap is closed the bar's end cannot move:
u/g → 1 as the penalty grows. What the overlap makes of it follows from the contact force
6 p (δ − 2 δ²) H (see the two bars).",
    evaluate,
};

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut study = Vec::new();
    let law = |penalty: f64| with_overlap(penalty, 0.0);
    for penalty in bench.pick(vec![1e2, 1e3, 1e4, 1e5, 1e6], vec![1e6]) {
        set(&mut scenario, 2.0, penalty)?;
        let u = displacement(bench, &scenario, &format!("p{penalty}"))?;
        let name = format!("u/g at x = 2, penalty {penalty:e} Pa");
        findings.push(Finding::value(&name, "", law(penalty), u, 0.01));
        if penalty == 1e6 {
            findings.push(Finding::value("u/g of a rigid contact", "", 1.0, u, 1e-3));
        }
        study.push([penalty.log10(), u]);
    }
    let picture = chart(
        "One bar against a rigid wall at x = 2",
        ["log10 of the penalty in Pa", "u/g"],
        &[
            function("with overlap", [2.0, 6.0], |p| law(10f64.powf(p))),
            line("without overlap: 1", vec![[2.0, 1.0], [6.0, 1.0]]),
            marks("Ypsilon", &study, [4.0, 0.6]),
        ],
    )?;
    let figure = bench.picture(&picture, "penalty.png", "Displacement against the penalty")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
