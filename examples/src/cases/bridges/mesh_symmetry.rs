//! Symmetric against asymmetric mesh.

use super::{
    family::{asymmetry, asymmetry_of_top, run_one, run_scenario},
    pictures::{self, Shown},
};
use crate::{Bench, Case, CaseError, Finding, Group, Length, Outcome};
use ypsilon_post::field::Field;

/// The case.
pub(super) const CASE: Case = Case {
    name: "mesh-symmetry",
    group: Group::Bridges,
    title: "Symmetric and asymmetric mesh",
    source: "thesis, section 4.2, figure 4.4",
    about: "\
The bridge with D = 0.5 L under 1000 kN in the middle of its top, in quarters every 0.1 s after 0.5 s, on
the mirror-symmetric mesh and on one whose blocks of the right half are divided along their other diagonals. The
symmetric mesh is that of `asymmetric.toml` with `symmetric = true`.",
    evaluate,
};

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut asymmetric = run_one(bench, "asymmetric", "asymmetric mesh")?;
    let mut scenario = bench.scenario("asymmetric.toml")?;
    if let Some(bridge) = &mut scenario.bridge {
        bridge.symmetric = true;
    }
    let mut symmetric = run_scenario(bench, scenario, "symmetric", "symmetric mesh")?;
    let end = symmetric.run.summary.time;
    let frame = symmetric.last()?;
    let stress = asymmetry(&frame).unwrap_or(f64::NAN);
    let tops = [&mut symmetric, &mut asymmetric]
        .map(|run| run.top(Some(run.settled), end).map(|top| asymmetry_of_top(&top)));
    let [on_symmetric, on_asymmetric] = tops;
    let (on_symmetric, on_asymmetric) = (on_symmetric?, on_asymmetric?);
    let findings = vec![
        Finding::range("asymmetry of σyy, symmetric mesh", "of the largest", [0.0, 1e-3], stress),
        Finding::range(
            "asymmetry of the top's displacements, symmetric mesh",
            "of the largest",
            [0.0, 1e-3],
            on_symmetric,
        ),
        Finding::statement(
            "asymmetry of the top's displacements, asymmetric mesh",
            "larger by far",
            &format!("{on_asymmetric:.1e} of the largest"),
            on_asymmetric > 10.0 * on_symmetric,
        ),
    ];
    let mut pictures = Vec::new();
    if bench.length() == Length::Full {
        for (run, file) in [(&mut symmetric, "symmetric.png"), (&mut asymmetric, "asymmetric.png")]
        {
            let frame = run.last()?;
            let shown = Shown::new(Field::VonMises, run.label);
            let caption = format!("Von Mises stress on the {}", run.label);
            pictures.push(pictures::state(bench, &frame, shown, file, &caption)?);
        }
    }
    Ok(Outcome { findings, pictures })
}
