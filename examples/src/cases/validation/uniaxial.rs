//! 3.1.2: confined tension and compression.

use super::homogeneous::{body, deform, run};
use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome,
    plotting::{chart, function, marks},
};

/// The case.
pub const CASE: Case = Case {
    name: "uniaxial",
    group: Group::Validation,
    title: "Confined uniaxial tension and compression",
    source: "thesis, section 3.1.2, Eq. 3.5, in plane form",
    about: "\
The square of the simple shear is driven to F = [[1, 0], [0, 1 + α]] with ν = 0. The thesis says
that E stays 26.6 GPa, but its µ (13 GPa) and the legends of its figures belong to **E = 26 GPa**,
which is taken here. Expected: Tyy = µ ((1 + α)² − 1)/(1 + α): −128.7, −19.5, 0, 10.833 and
19.5 GPa. The thesis's z is our y.",
    evaluate,
};

/// The same with tetrahedra.
pub const SOLID: Case = Case {
    name: "uniaxial-3d",
    group: Group::Solids,
    title: "Confined uniaxial tension and compression of a cube",
    source: "thesis, section 3.1.2, Eq. 3.5",
    about: "\
The cube of the simple shear is driven to F = [[1, 0, 0], [0, 1, 0], [0, 0, 1 + α]] with ν = 0. The
thesis says that E stays 26.6 GPa, but its µ (13 GPa) and the legends of its figures belong to
**E = 26 GPa**, which is taken here. Expected: Tzz (in the rows \"Tyy\": up) =
µ ((1 + α)² − 1)/(1 + α): −128.7, −19.5, 0, 10.833 and 19.5 GPa.",
    evaluate,
};

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let mu = body(&mut scenario)?.material.mu();
    let law = |a: f64| mu * ((1.0 + a).powi(2) - 1.0) / (1.0 + a);
    let mut findings = Vec::new();
    let mut points = Vec::new();
    let (mut worst, mut others) = (0.0_f64, 0.0_f64);
    for (alpha, printed) in
        [(-0.9, -128.7e9), (-0.5, -19.5e9), (0.0, 0.0), (0.5, 10.833e9), (1.0, 19.5e9)]
    {
        deform(&mut scenario, [[1.0, 0.0], [0.0, 1.0 + alpha]])?;
        let state = run(bench, &scenario, &format!("uniaxial{alpha}"))?;
        let [xx, yy, xy] = state.stress;
        points.push([alpha, yy]);
        worst = worst.max(state.scatter);
        others = others.max(xx.abs()).max(xy.abs()).max(state.across);
        let name = format!("Tyy at α = {alpha}");
        findings.push(if alpha == 0.0 {
            Finding::within(&name, "Pa", 0.0, yy, 1e-6 * mu)
        } else {
            // the thesis prints up to five digits
            debug_assert!((law(alpha) / printed - 1.0).abs() < 1e-4);
            Finding::value(&name, "Pa", law(alpha), yy, 1e-6)
        });
    }
    findings.push(Finding::within("largest of all other stresses", "Pa", 0.0, others, 1e-6 * mu));
    let name = "largest difference between elements";
    findings.push(Finding::within(name, "Pa", 0.0, worst, 1e-6 * mu));
    let picture = chart(
        "Confined tension and compression",
        ["stretch α", "stress Tyy (Pa)"],
        &[function("analytic", [-0.9, 1.0], law), marks("Ypsilon", &points, [1.9, 15.0 * mu])],
    )?;
    let figure = bench.picture(&picture, "stress.png", "Stress against the stretch")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
