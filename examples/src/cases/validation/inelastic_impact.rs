//! 3.2.2: an impact that makes the blocks swing.

use super::impact::collide;
use crate::{Bench, Case, CaseError, Finding, Group, Outcome, plotting::chart};

/// The case.
pub const CASE: Case = Case {
    name: "inelastic-impact",
    group: Group::Validation,
    title: "Impact of soft blocks (\"inelastic\")",
    source: "thesis, section 3.2.2, tables 3.3 and 3.4",
    about: "\
A block of 5625 kg hits a second one of the same mass, then of twice the mass, at 5 m/s.
E = 258 MPa, ν = 0.17, no viscosity, no friction, no gravity, Δt = 0.5 µs (the thesis's \"four
orders larger than recommended\" must read smaller). The two blocks are squares of 1.5 m with
2500 kg/m³ in free flight, which a platform without friction does not change.

Nothing dissipates: kinetic energy that is missing after the impact is in the vibration of the
blocks, because the contact (half a period of 9 ms) lasts as long as a wave takes through the block
and back (9 ms). The thesis's mesh, shape and effective contact stiffness are unknown, so that its
velocities can only be met in kind: 1.741 and 3.259 m/s (restitution 0.30), 0.748 and 2.126 m/s
(0.28). The penalty here, 60 MPa, gives the ratio of both times that its p_n has in three
dimensions. Other meshes (1 to 6 cells along an edge) and penalties (30 MPa to 1 GPa) give 0.84 to
0.94 for equal and 0.67 to 0.87 for double mass; with the viscosities that were tried (0.3 to 5 MPa s)
it is 0.60 at the least. The thesis's 0.30 must have lost energy in another way. Momentum and the sum of all energies must be kept.",
    evaluate,
};

/// The same with tetrahedra.
pub const SOLID: Case = Case {
    name: "inelastic-impact-3d",
    group: Group::Solids,
    title: "Impact of soft cubes (\"inelastic\")",
    source: "thesis, section 3.2.2, tables 3.3 and 3.4",
    about: "\
A cube of 5625 kg hits a second one of the same mass, then of twice the mass, at 5 m/s: cubes of 1.5 m
of twelve tetrahedra in free flight, E = 258 MPa, ν = 0.17, no viscosity, no friction, no gravity,
Δt = 0.5 µs. The thesis's p_n = 1 GPa counts as 60 MPa in its program; the law here has a factor 6,
so the penalty is 10 MPa.

Nothing dissipates but the one-sided law of contact, whose forces have no potential where bodies deform:
kinetic energy that is missing is in the vibration of the cubes. The thesis's mesh and shape are unknown,
so that its velocities can only be met in kind: 1.741 and 3.259 m/s, 0.748 and 2.126 m/s.",
    evaluate,
};

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let scenario = bench.scenario("scenario.toml")?;
    let mut findings = Vec::new();
    let mut lines = Vec::new();
    for (ratio, printed, energy) in [(1.0, [1.741, 3.259], 38395.0), (2.0, [0.748, 2.126], 26997.0)]
    {
        let impact = collide(bench, &scenario, &format!("ratio{ratio}"), ratio)?;
        let [before, after] = impact.momenta;
        let of = |what: &str| format!("{what}, m₂ = {ratio} m₁");
        findings.push(Finding::value(&of("momentum before"), "kg m/s", 28125.0, before, 1e-12));
        findings.push(Finding::value(&of("momentum after"), "kg m/s", before, after, 1e-11));
        let sum = impact.kinetic + impact.strain;
        let name = of("kinetic and strain energy after");
        findings.push(Finding::value(&name, "J", impact.rigid[0], sum, 2e-3).noted(
            "contact forces come from a potential on elements that keep their shape; where they \
             deform (here by some percent) its energy changes a little without a force",
        ));
        let [v1, v2] = impact.velocities;
        let restitution = (v2 - v1) / 5.0;
        let note = "the thesis's mesh, shape and contact stiffness are not known";
        let name = of("restitution");
        let [w1, w2]: [f64; 2] = printed;
        findings.push(Finding::range(&name, "", [0.0, 0.95], restitution).noted(
            "an impact that leaves vibration behind has a restitution well below 1; the thesis's \
             is 0.30 for equal masses and 0.28 for double mass",
        ));
        findings.push(Finding::told(&name, "", (w2 - w1) / 5.0, restitution, note));
        findings.push(Finding::told(&of("velocity of block 1"), "m/s", w1, v1, note));
        findings.push(Finding::told(&of("velocity of block 2"), "m/s", w2, v2, note));
        let name = of("kinetic energy of the blocks' mean motion after");
        findings.push(Finding::told(&name, "J", energy, impact.rigid[1], note));
        lines.extend(impact.curves);
    }
    let title = "Impact of soft blocks";
    let picture = chart(title, ["time (s)", "mean velocity (m/s)"], &lines)?;
    let figure = bench.picture(&picture, "velocity.png", "Velocities of the blocks' centres")?;
    Ok(Outcome { findings, pictures: vec![figure] })
}
