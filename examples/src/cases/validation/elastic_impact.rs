//! 3.2.2: an impact that keeps its energy.

use super::impact::collide;
use crate::{Bench, Case, CaseError, Finding, Group, Outcome, plotting::chart};

/// The case.
pub const CASE: Case = Case {
    name: "elastic-impact",
    group: Group::Validation,
    title: "Impact of stiff blocks (\"elastic\")",
    source: "thesis, section 3.2.2, tables 3.5 and 3.6",
    about: "\
The soft impact with stiff blocks: ν = 0 and **E = 12.9 GPa** (the thesis prints 12.9 MPa, which
would be softer than before; 50 times 258 MPa is meant. It also swaps the numbers of its tables 3.5
and 3.6 in the text). The contact lasts much longer than a wave takes through a block and back
(1.3 ms), so the blocks move as rigid ones: velocities 0 and 5 m/s for equal masses, −1.667 and
3.333 m/s for a second block of twice the mass. The thesis loses 40 and 60 mJ of 70312 J.",
    evaluate,
};

/// The same with tetrahedra.
pub const SOLID: Case = Case {
    name: "elastic-impact-3d",
    group: Group::Solids,
    title: "Impact of stiff cubes (\"elastic\")",
    source: "thesis, section 3.2.2, tables 3.5 and 3.6",
    about: "\
The soft impact of cubes with ν = 0 and **E = 12.9 GPa** (printed 12.9 MPa; 50 times 258 MPa is meant, and
the numbers of tables 3.5 and 3.6 are swapped in the text). The contact lasts much longer than a wave
takes through a cube and back, so the cubes move as rigid ones: 0 and 5 m/s for equal masses, −1.667 and
3.333 m/s for twice the mass. The thesis loses 40 and 60 mJ of 70312 J.",
    evaluate,
};

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut lines = Vec::new();
    for ratio in [1.0, 2.0] {
        let impact = collide(bench, &scenario, &format!("ratio{ratio}"), ratio)?;
        let of = |what: &str| format!("{what}, m₂ = {ratio} m₁");
        let [before, after] = impact.momenta;
        findings.push(Finding::value(&of("momentum after"), "kg m/s", before, after, 1e-11));
        let expected = [5.0 * (1.0 - ratio) / (1.0 + ratio), 10.0 / (1.0 + ratio)];
        for k in 0..2 {
            let name = of(&format!("velocity of block {}", k + 1));
            let obtained = impact.velocities[k];
            findings.push(Finding::within(&name, "m/s", expected[k], obtained, 0.05));
        }
        let lost = 1.0 - impact.rigid[1] / impact.rigid[0];
        let name = of("part of the kinetic energy that the mean motion loses");
        findings.push(Finding::within(&name, "", 0.0, lost, 1e-3));
        let sum = impact.kinetic + impact.strain;
        let name = of("kinetic and strain energy after");
        findings.push(Finding::value(&name, "J", impact.rigid[0], sum, 1e-4));
        lines.extend(impact.curves);
    }
    let title = "Impact of stiff blocks";
    let picture = chart(title, ["time (s)", "mean velocity (m/s)"], &lines)?;
    let figure = bench.picture(&picture, "velocity.png", "Velocities of the blocks' centres")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
