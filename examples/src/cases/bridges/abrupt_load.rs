//! Weight and load at once.

use super::{
    family::run_one,
    pictures::{self, Shown},
};
use crate::{Bench, Case, CaseError, Finding, Group, Length, Outcome};
use ypsilon_post::{field::Field, results::JointState};

/// The case.
pub(super) const CASE: Case = Case {
    name: "abrupt-load",
    group: Group::Bridges,
    title: "Weight and 1000 kN at once on D = 0.75 L",
    source: "thesis, section 4.1, figure 4.3",
    about: "\
The bridge with D = 0.75 L of [self-weight](../self-weight/README.md); gravity and 1000 kN in the middle of the top
act from t = 0 on. With the same load in quarters ([point-load](../point-load/README.md)) it stands.",
    evaluate,
};

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut run = run_one(bench, "abrupt", "D = 0.75 L")?;
    let end = run.run.summary.time;
    let frame = run.frame_at(end / 2.0)?;
    let broken = frame.joints.iter().filter(|j| j.state == JointState::Broken).count();
    let cracks = run.cracks_of_ring(&frame);
    let at_key = cracks.iter().filter(|c| c[0].abs() < 15.0).count();
    let flanks = cracks.iter().filter(|c| (20.0..60.0).contains(&c[0].abs())).count();
    let mut findings = vec![Finding::statement(
        "joints after half the time",
        "open at the key and at both flanks",
        &format!(
            "{broken} broken; of the ring's joints {at_key} within 15° of the key, {flanks} at 20° to 60°"
        ),
        at_key > 0 && flanks > 1,
    )];
    let mut pictures = Vec::new();
    if bench.length() == Length::Full {
        let top = run.top(None, end)?;
        let lowest = top.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
        let falls = lowest < -0.1;
        findings.push(
            Finding::statement(
                "bridge after 0.25 s",
                "has collapsed",
                &format!(
                    "the lowest point of the top is {:.1} mm down at {end:.2} s",
                    -1e3 * lowest
                ),
                falls,
            )
            .noted(if falls { "" } else { STANDS }),
        );
        for (time, name) in [(0.125, "0125"), (0.25, "0250")] {
            let frame = run.frame_at(time)?;
            let mut shown =
                Shown::new(Field::Displacement, format!("{time} s, displacements 20 times"));
            shown.deformation = 20.0;
            let caption = format!("Displacements and broken joints at {time} s");
            pictures.push(pictures::state(
                bench,
                &frame,
                shown,
                &format!("abrupt-{name}.png"),
                &caption,
            )?);
        }
    }
    Ok(Outcome { findings, pictures })
}

/// Why it does not fall.
const STANDS: &str = "\
The hinges of a collapse appear (key, flanks, springings; the ring separates from the spandrels), but the spandrels \
and the soil hold the flanks: in this mesh nothing is left out beside the ring. The thesis left blocks out where \
the ring cuts the courses, and had no ties between most blocks (two nodes per triangle).";
