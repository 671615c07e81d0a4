//! Weight and load at once.

use super::{
    family::{BridgeRun, run_as_it_is},
    pictures::{self, Shown},
};
use crate::{Bench, Case, CaseError, Finding, Group, Length, Outcome, case::Figure};
use ypsilon_post::{
    field::Field,
    results::{Frame, JointState},
};

/// The case.
pub(super) const CASE: Case = Case {
    name: "abrupt-load",
    group: Group::Bridges,
    title: "Weight and 1000 kN at once on D = 0.75 L",
    source: "thesis, section 4.1, figure 4.3",
    about: "\
The bridge with D = 0.75 L of [self-weight](../self-weight/README.md); gravity and 1000 kN in the middle of the top
act from t = 0 on. With the same load in quarters ([point-load](../point-load/README.md)) it stands.

`dry.toml` is the same bridge without mortar: joints between blocks have no strength (1 Pa), so that blocks touch and
rub only. The thesis's mesh of this bridge has 606 triangles and 1219 nodes, four for each of its 303 blocks and a few
more, so that its blocks share no nodes; where triangles share no edge the program inserts no joint.",
    evaluate,
};

/// When joints are looked at \[s\].
const HINGES: f64 = 0.05;

/// When the bridge has to be down \[s\].
const DOWN: f64 = 0.25;

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut scenario = bench.scenario("abrupt.toml")?;
    if bench.length() == Length::Short {
        // the same bridge: smaller ones have other hinges, and falling takes its time
        scenario.run.end_s = Some(HINGES);
    }
    let mut mortared = run_as_it_is(bench, scenario, "abrupt", LABEL)?;
    let frame = mortared.frame_at(HINGES)?;
    let mut findings = vec![hinges(&mortared, &frame)];
    if bench.length() == Length::Short {
        return Ok(Outcome { findings, pictures: Vec::new() });
    }
    let mut dry = run_as_it_is(bench, bench.scenario("dry.toml")?, "dry", LABEL)?;
    let mut figures = Vec::new();
    for (run, what) in [(&mut mortared, "with mortar"), (&mut dry, "without mortar")] {
        let top = run.top(None, DOWN)?;
        let lowest = top.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
        let falls = lowest < -0.1;
        findings.push(
            Finding::statement(
                &format!("bridge {what} at {DOWN} s"),
                "has collapsed",
                &format!("the lowest point of the top is {:.1} mm down", -1e3 * lowest),
                falls,
            )
            .noted(if falls { "" } else { STANDS }),
        );
        figures.push(shown(bench, run, what)?);
    }
    Ok(Outcome { findings, pictures: figures })
}

const LABEL: &str = "D = 0.75 L";

/// The hinges of a collapse: joints of the ring at the key and at both flanks.
fn hinges(run: &BridgeRun, frame: &Frame) -> Finding {
    let broken = frame.joints.iter().filter(|j| j.state == JointState::Broken).count();
    let cracks = run.cracks_of_ring(frame);
    let count = |from: f64, to: f64| cracks.iter().filter(|c| (from..to).contains(&c[0])).count();
    let [left, key, right] = [count(-60.0, -20.0), count(-15.0, 15.0), count(20.0, 60.0)];
    Finding::statement(
        &format!("broken joints at {} s, with mortar", HINGES),
        "the ring is open at the key and at both flanks",
        &format!(
            "{broken} broken; of the ring's joints {key} within 15° of the key, {left} at 20° to 60° on its left, \
             {right} on its right"
        ),
        key > 0 && left > 0 && right > 0,
    )
}

fn shown(bench: &Bench, run: &mut BridgeRun, what: &str) -> Result<Figure, CaseError> {
    let frame = run.frame_at(DOWN)?;
    let title = format!("{what}, {DOWN} s, displacements 20 times");
    let shown = Shown { deformation: 20.0, ..Shown::new(Field::Displacement, title) };
    let file = format!("{}.png", what.replace(' ', "-"));
    let caption = format!("Displacements and broken joints {what} at {DOWN} s");
    pictures::state(bench, &frame, shown, &file, &caption)
}

/// Why it does not fall.
const STANDS: &str = "\
The hinges of a collapse appear (key, flanks; the ring separates from the spandrels), but friction holds the key, \
and spandrels and soil hold the flanks, without mortar as well: here nothing is left out beside the ring, where \
the thesis left blocks out that the ring cuts. How many, and how thick its ring is, it does not tell.";
