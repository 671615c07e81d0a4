//! 3.1.4: contact between two bars.

use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome, measure,
    plotting::{chart, function, line, marks},
};
use std::ops::ControlFlow;
use ypsilon::{meshing::Scenario, scene::SpatialContact};

/// The case.
pub const CASE: Case = Case {
    name: "two-bars",
    group: Group::Validation,
    title: "Contact of two bars",
    source: "thesis, section 3.1.4, Eq. 3.7 (Lagrange multipliers)",
    about: "\
A bar of length l = 1 m and height h = 0.1 m with E A = 1000 N is pulled towards a second one
beyond a gap g = 0.01 m. With x = F l/(E A g) its end moves u/g = x until the gap is closed
(x = 1) and u/g = (2 + x)/3 from then on. That formula needs a second bar that is twice as stiff;
here it has half the length (the thesis's figure is not in its text). In general
u/g = (x + r)/(1 + r) with r = k l/(E A) and 1/k = 1/k_right + 1/k_contact.

The penalty study has an answer as well. The potential of a triangle is three times its smallest
area coordinate. Along an edge that has entered a right-angled triangle of height and base H by
δ = d/H its integral is 3 (δ − 2 δ²) H, and both edges are integrated: the contact force is
6 p (δ − 2 δ²) H, of stiffness 6 p for small overlaps. Strains reach 1.3 %, where the law is softer
than Hooke's by about half of that.",
    evaluate,
};

/// Displacement of the pulled end by the gap, in equilibrium.
pub(super) fn displacement(
    bench: &Bench,
    scenario: &Scenario,
    name: &str,
) -> Result<f64, CaseError> {
    let [length, gap] = match (&scenario.two_bars, &scenario.two_bars_3d) {
        (Some(bars), _) => [bars.length_m, bars.gap_m],
        (_, Some(bars)) => [bars.length_m, bars.gap_m],
        _ => return Err(CaseError::missing("the scenario has no bars")),
    };
    let law = SpatialContact::default();
    let done = bench.watch_any(scenario, name, law, |_| ControlFlow::Continue(()))?;
    if done.is_unstable {
        return Err(CaseError::missing(format!("{name} has become unstable")));
    }
    let simulation = &*done.simulation;
    let end: Vec<usize> =
        (0..simulation.masses().len()).filter(|&n| simulation.initial(n)[0] == length).collect();
    Ok(measure::displacement(simulation, end)[0] / gap)
}

/// Changes a scenario: x = F l/(E A g) and the penalty.
pub(super) fn set(scenario: &mut Scenario, x: f64, penalty: f64) -> Result<(), CaseError> {
    if let Some(bars) = &mut scenario.two_bars_3d {
        let area = bars.height_m * bars.height_m;
        bars.force_n = x * bars.material.young_pa * area / bars.length_m * bars.gap_m;
        bars.material.penalty_pa = penalty;
        bars.material.tangential_penalty_pa = 0.1 * penalty;
        return Ok(());
    }
    let bars = scenario.two_bars.as_mut();
    let bars = bars.ok_or_else(|| CaseError::missing("the scenario has no [two_bars]"))?;
    let stiffness = bars.material.young_pa * bars.height_m / bars.length_m;
    bars.force_n = x * stiffness * bars.gap_m;
    bars.material.penalty_pa = penalty;
    bars.material.tangential_penalty_pa = 0.1 * penalty;
    Ok(())
}

/// Displacement of the pulled end by the gap at x = 2 by Hooke's law, if the overlap of both bars
/// counts. `right` is the compliance of the second bar by that of the first one.
pub(super) fn with_overlap(penalty: f64, right: f64) -> f64 {
    let height = 0.1;
    let contact = |d: f64| {
        let part = d / height;
        6.0 * penalty * (part - 2.0 * part * part) * height
    };
    equilibrium(contact, right)
}

/// The same for a contact force that follows from the overlap.
fn equilibrium(contact: impl Fn(f64) -> f64, right: f64) -> f64 {
    let (height, gap, stiffness) = (0.1, 0.01, 1000.0);
    // the overlap for which both bars are in equilibrium
    let excess = |d: f64| {
        let force = contact(d);
        (2.0 * gap - force / stiffness) - right * force / stiffness - gap - d
    };
    let (mut low, mut high) = (0.0, 0.25 * height);
    for _ in 0..60 {
        let middle = f64::midpoint(low, high);
        *(if excess(middle) > 0.0 { &mut low } else { &mut high }) = middle;
    }
    (2.0 * gap - contact(low) / stiffness) / gap
}

/// The same with tetrahedra.
pub const SOLID: Case = Case {
    name: "two-bars-3d",
    group: Group::Solids,
    title: "Contact of two bars of tetrahedra",
    source: "thesis, section 3.1.4, Eq. 3.7 (Lagrange multipliers)",
    about: "\
The two bars of the plane with a square section of 0.1 m, cells of six tetrahedra, E A = 1000 N:
u/g = x until the gap is closed (x = F l/(E A g) = 1, here F = 10 N), (2 + x)/3 from then on for a second
bar that is twice as stiff, and 1 for a rigid one. In general u/g = (x + r)/(1 + r) with
r = k l/(E A) and 1/k = 1/k_right + 1/k_contact.

The potential of a tetrahedron is 4 times its smallest volume coordinate, and the faces of one bar are
pressed: at an overlap d that is small beside the height H of the tetrahedra, the force is
24 p A d/H. Strains reach 1.3 %, where the law is softer than Hooke's by about half of that.",
    evaluate: evaluate_solid,
};

fn evaluate_solid(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut points = Vec::new();
    for x in bench.pick(vec![0.5, 1.0, 1.25, 1.5, 1.75, 2.0], vec![0.5, 2.0]) {
        set(&mut scenario, x, 1e6)?;
        let u = displacement(bench, &scenario, &format!("x{x}"))?;
        let expected = if x > 1.0 { (2.0 + x) / 3.0 } else { x };
        findings.push(Finding::value(&format!("u/g at x = {x}"), "", expected, u, 0.01));
        points.push([x, u]);
    }
    let (area, height) = (0.01, 0.1);
    for penalty in bench.pick(vec![3e3, 1e4, 1e5], vec![1e4]) {
        set(&mut scenario, 2.0, penalty)?;
        let u = displacement(bench, &scenario, &format!("p{penalty}"))?;
        let expected = equilibrium(|d| 24.0 * penalty * area * d / height, 0.5);
        let name = format!("u/g at x = 2, penalty {penalty:e} Pa");
        findings.push(Finding::value(&name, "", expected, u, 0.01));
    }
    if let Some(bars) = &mut scenario.two_bars_3d {
        bars.rigid_right = true;
    }
    for penalty in bench.pick(vec![1e4, 1e5, 1e6], vec![1e6]) {
        set(&mut scenario, 2.0, penalty)?;
        let u = displacement(bench, &scenario, &format!("rigid{penalty}"))?;
        let expected = equilibrium(|d| 24.0 * penalty * area * d / height, 0.0);
        let name = format!("u/g at x = 2, rigid bar, penalty {penalty:e} Pa");
        findings.push(Finding::value(&name, "", expected, u, 0.01));
        if penalty == 1e6 {
            findings.push(Finding::value("u/g of a rigid contact", "", 1.0, u, 1e-3));
        }
    }
    let picture = chart(
        "Two bars of tetrahedra with a gap, penalty 1 MPa",
        ["F l/(E A g)", "u/g"],
        &[
            function("u/g = x, then (2 + x)/3", [0.0, 2.0], |x| x.min((2.0 + x) / 3.0)),
            marks("Ypsilon", &points, [2.0, 1.4]),
        ],
    )?;
    let figure = bench.picture(&picture, "displacement.png", "Displacement against force")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut points = Vec::new();
    for x in bench.pick(vec![0.5, 1.0, 1.25, 1.5, 1.75, 2.0], vec![0.5, 2.0]) {
        set(&mut scenario, x, 1e6)?;
        let u = displacement(bench, &scenario, &format!("x{x}"))?;
        let expected = if x > 1.0 { (2.0 + x) / 3.0 } else { x };
        findings.push(Finding::value(&format!("u/g at x = {x}"), "", expected, u, 0.01));
        points.push([x, u]);
    }
    let mut study = Vec::new();
    for penalty in bench.pick(vec![1e2, 1e3, 1e4, 1e5, 1e6], vec![1e3]) {
        set(&mut scenario, 2.0, penalty)?;
        let u = displacement(bench, &scenario, &format!("p{penalty}"))?;
        let expected = with_overlap(penalty, 0.5);
        let name = format!("u/g at x = 2, penalty {penalty:e} Pa");
        findings.push(Finding::value(&name, "", expected, u, 0.01));
        study.push([penalty.log10(), u]);
    }
    let picture = chart(
        "Two bars with a gap, penalty 1 MPa",
        ["F l/(E A g)", "u/g"],
        &[
            function("u/g = x, then (2 + x)/3", [0.0, 2.0], |x| x.min((2.0 + x) / 3.0)),
            marks("Ypsilon", &points, [2.0, 1.4]),
        ],
    )?;
    let first = bench.picture(&picture, "displacement.png", "Displacement against force")?;
    let picture = chart(
        "Convergence with the penalty at x = 2",
        ["log10 of the penalty in Pa", "u/g"],
        &[
            function("with overlap", [2.0, 6.0], |p| with_overlap(10f64.powf(p), 0.5)),
            line("without overlap: 4/3", vec![[2.0, 4.0 / 3.0], [6.0, 4.0 / 3.0]]),
            marks("Ypsilon", &study, [4.0, 0.3]),
        ],
    )?;
    let second = bench.picture(&picture, "penalty.png", "Displacement against the penalty")?;
    Ok(Outcome { findings, pictures: vec![first, second] })
}
