//! Weight and load at once.

use super::{
    family::{BridgeRun, coarsen, run_as_it_is},
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
more: no block shares a node with another one, and where triangles share no edge the program inserts no joint. Its
collapse is that of a dry bridge.",
    evaluate,
};

/// When joints are looked at, and when the bridge has to be down \[s\].
const TIMES: [f64; 2] = [0.125, 0.25];

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let full = bench.length() == Length::Full;
    let mut mortared = run(bench, "abrupt")?;
    let frame = mortared.frame_at(TIMES[0])?;
    let mut findings = vec![hinges(&mortared, &frame)];
    let mut figures = Vec::new();
    if full {
        let (text, falls) = fallen(&mut mortared)?;
        let quantity = format!("bridge with mortar at {} s", TIMES[1]);
        findings.push(
            Finding::statement(&quantity, "has collapsed", &text, falls).noted(if falls {
                ""
            } else {
                STANDS
            }),
        );
        figures.extend(shown(bench, &mut mortared, "with mortar", 20.0)?);
    }
    let mut dry = run(bench, "dry")?;
    let (text, falls) = fallen(&mut dry)?;
    let quantity = format!("bridge without mortar at {} s", TIMES[1]);
    findings.push(Finding::statement(&quantity, "has collapsed", &text, falls));
    if full {
        figures.extend(shown(bench, &mut dry, "without mortar", 1.0)?);
    }
    Ok(Outcome { findings, pictures: figures })
}

/// Falling takes its time: in the test suite blocks are larger, but times are the same.
fn run(bench: &Bench, name: &str) -> Result<BridgeRun, CaseError> {
    let mut scenario = bench.scenario(&format!("{name}.toml"))?;
    if bench.length() == Length::Short {
        coarsen(&mut scenario);
        scenario.run.end_s = Some(TIMES[1]);
    }
    run_as_it_is(bench, scenario, name, "D = 0.75 L")
}

/// The hinges of a collapse: joints of the ring at the key and at both flanks.
fn hinges(run: &BridgeRun, frame: &Frame) -> Finding {
    let broken = frame.joints.iter().filter(|j| j.state == JointState::Broken).count();
    let cracks = run.cracks_of_ring(frame);
    let count = |from: f64, to: f64| cracks.iter().filter(|c| (from..to).contains(&c[0])).count();
    let [left, key, right] = [count(-60.0, -20.0), count(-15.0, 15.0), count(20.0, 60.0)];
    Finding::statement(
        &format!("broken joints at {} s, with mortar", TIMES[0]),
        "the ring is open at the key and at both flanks",
        &format!(
            "{broken} broken; of the ring's joints {key} within 15° of the key, {left} at 20° to 60° on its left, \
             {right} on its right"
        ),
        key > 0 && left > 0 && right > 0,
    )
}

/// Where the lowest point of the top is, and whether that is more than any standing bridge shows.
fn fallen(run: &mut BridgeRun) -> Result<(String, bool), CaseError> {
    let top = run.top(None, TIMES[1])?;
    let lowest = top.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min);
    let text = format!("the lowest point of the top is {:.1} mm down", -1e3 * lowest);
    Ok((text, lowest < -0.1))
}

fn shown(
    bench: &Bench,
    run: &mut BridgeRun,
    what: &str,
    deformation: f64,
) -> Result<Vec<Figure>, CaseError> {
    let mut figures = Vec::new();
    for time in TIMES {
        let frame = run.frame_at(time)?;
        let times =
            if deformation > 1.0 { format!(", {deformation:.0} times") } else { String::new() };
        let title = format!("{what}, {time} s, displacements{times}");
        let mut shown = Shown::new(Field::Displacement, title);
        shown.deformation = deformation;
        let file = format!("{}-{:04.0}.png", what.replace(' ', "-"), 1e3 * time);
        let caption = format!("Displacements and broken joints {what} at {time} s");
        figures.push(pictures::state(bench, &frame, shown, &file, &caption)?);
    }
    Ok(figures)
}

/// Why it does not fall.
const STANDS: &str = "\
The hinges of a collapse appear (key, flanks, the ring separates from the spandrels), but spandrels and soil hold the \
flanks, and friction holds the key: here all blocks are bonded and nothing is left out beside the ring. Without mortar \
it falls.";
