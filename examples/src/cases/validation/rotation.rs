//! 3.1.3: rotation of a rigid body.

use super::homogeneous::{body, deform, run};
use crate::{
    Bench, Case, CaseError, Finding, Group, Outcome,
    plotting::{chart, line},
};

/// The case.
pub const CASE: Case = Case {
    name: "rotation",
    group: Group::Validation,
    title: "Rotation of a rigid body",
    source: "thesis, section 3.1.3, Eq. 3.6, in plane form",
    about: "\
A square of 1 m (E = 26 GPa, ν = 0.4) starts turned by 0° to 90° in steps of 22.5° with nothing
held. The thesis expects T = 0: a rotation deforms nothing. Stresses and nodal forces must be
rounding, and the square must stay where it is for a thousand steps.",
    evaluate,
};

/// The same with tetrahedra.
pub const SOLID: Case = Case {
    name: "rotation-3d",
    group: Group::Solids,
    title: "Rotation of a rigid cube",
    source: "thesis, section 3.1.3, Eq. 3.6",
    about: "\
A cube of 1 m of twelve tetrahedra, eight corners and a centre (E = 26 GPa, ν = 0.4), starts turned
about y by 0° to 90° in steps of 22.5° with nothing held. The thesis expects T = 0: stresses and nodal
forces must be rounding for a thousand steps.",
    evaluate,
};

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("scenario.toml")?;
    let young = body(&mut scenario)?.material.young_pa;
    let mut findings = Vec::new();
    let mut points = Vec::new();
    for step in 0..=4 {
        let degrees = 22.5 * f64::from(step);
        let (sin, cos) = degrees.to_radians().sin_cos();
        deform(&mut scenario, [[cos, -sin], [sin, cos]])?;
        let state = run(bench, &scenario, &format!("rotation{step}"))?;
        let largest = state.stress.iter().fold(state.across, |m, s| m.max(s.abs()));
        let stress = largest + state.scatter;
        points.push([degrees, stress / young]);
        let name = format!("largest stress by E at {degrees}°");
        findings.push(Finding::within(&name, "", 0.0, stress / young, 1e-14));
        let name = format!("largest nodal force by E times 1 m² at {degrees}°");
        findings.push(Finding::within(&name, "", 0.0, state.force / young, 1e-14));
    }
    let title = "Largest stress of a turned body";
    let picture = chart(title, ["angle (°)", "stress by E"], &[line("Ypsilon", points)])?;
    let figure = bench.picture(&picture, "stress.png", "Largest stress by E, which is rounding")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
