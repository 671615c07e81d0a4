//! A support that settles.

use super::{
    family::{BridgeRun, middles, run_shown},
    pictures::{self, Shown},
};
use crate::{Bench, Case, CaseError, Finding, Group, Length, Outcome};
use ypsilon::meshing::Load;
use ypsilon_post::{
    field::Field,
    plot::Range,
    results::{Frame, JointState},
};

/// The case.
pub(super) const CASE: Case = Case {
    name: "settlement",
    group: Group::Bridges,
    title: "Bridges whose left support settles by 0.6 m",
    source: "thesis, section 4.4, figures 4.14 to 4.16",
    about: "\
The bridges of [self-weight](../self-weight/README.md); the ground under the left half of the masonry moves down
with 0.2 m/s from 1.5 s to 4.5 s. The soil beside it stays.",
    evaluate,
};

fn evaluate(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut runs = run_shown(bench)?;
    let mut findings = Vec::new();
    let mut pictures = Vec::new();
    let full = bench.length() == Length::Full;
    for run in &mut runs {
        let [from, end] = course(run)?;
        let half_way = f64::midpoint(from, end);
        let label = run.label;
        let way = settled(&run.last()?);
        findings.push(Finding::within(&format!("settlement, {label}"), "m", 0.6, way, 1e-6));
        let frame = run.frame_at(half_way)?;
        let broken = frame.joints.iter().filter(|j| j.state == JointState::Broken).count();
        findings.push(Finding::statement(
            &format!("joints at 0.3 m, {label}"),
            "open",
            &format!("{broken} broken"),
            broken > 0,
        ));
        let cracks = run.cracks_of_ring(&frame);
        let widest = |right: bool| {
            let side = cracks.iter().filter(|c| (c[0] > 0.0) == right);
            side.max_by(|a, b| a[1].total_cmp(&b[1])).copied()
        };
        let (left, right) = (widest(false), widest(true));
        let text = |crack: Option<[f64; 2]>| match crack {
            Some([angle, opening]) => format!("{:.0}° ({:.1} mm)", angle.abs(), 1e3 * opening),
            None => "none".to_owned(),
        };
        let text = format!("left {}, right {}", text(left), text(right));
        if run.label.contains("0.5") && full {
            let near = |crack: Option<[f64; 2]>, angle: f64| {
                crack.is_some_and(|c| (c[0].abs() - angle).abs() <= 20.0)
            };
            findings.push(
                Finding::statement(
                    &format!("widest cracks of the ring at 0.3 m, {label}"),
                    "40° left and 30° right of the key, within a voussoir or two (20°)",
                    &text,
                    near(left, 40.0) && near(right, 30.0),
                )
                .noted(
                    "Voussoirs are 6.7° long here; which of neighbouring joints opens depends on the joints of \
                     the courses above, of which the thesis shows a picture only.",
                ),
            );
        } else {
            findings.push(Finding::statement(
                &format!("widest cracks of the ring at 0.3 m, {label}"),
                "two, on both sides of the key",
                &text,
                left.is_some() && right.is_some(),
            ));
        }
        if !full {
            continue;
        }
        // the blocks on the ground hang on the soil beside them, which stays
        let [everywhere, above] = [0.0, 1.0];
        let mut peaks: [f64; 2] = [0.0; 2];
        for index in 0..run.results.len() {
            let frame = run.results.frame(index)?;
            for (peak, height) in peaks.iter_mut().zip([everywhere, above]) {
                *peak = peak.max(largest_stress(run, &frame, height)?);
            }
        }
        let last = run.last()?;
        let rest = largest_stress(run, &last, above)?;
        findings.push(Finding::statement(
            &format!(
                "stresses of the masonry above the footing when the cracks are through, {label}"
            ),
            "fall",
            &format!(
                "von Mises {:.2} MPa at most, {:.2} MPa at the end",
                peaks[1] / 1e6,
                rest / 1e6
            ),
            rest < peaks[1],
        ));
        if label.contains("0.25") {
            findings.push(
                Finding::range(
                    "largest von Mises stress of the masonry, D = 0.25 L",
                    "MPa",
                    [20.5 / 2.0, 20.5 * 2.0],
                    peaks[0] / 1e6,
                )
                .noted(
                    "A factor of two: it is the stress of single triangles, here at the outer corner of the footing, \
                     which pulls down the soil that is bonded to it. The soil itself, whose base stays, is strained by \
                     a third.",
                ),
            );
        }
        for (time, way) in [(half_way, "0.3"), (end, "0.6")] {
            let frame = run.frame_at(time)?;
            let mut shown = Shown::new(Field::VonMises, format!("{label}, settlement of {way} m"));
            shown.range = Range::Robust(1.0);
            let file = format!("{}-{}.png", pictures::slug(label), way.replace('.', ""));
            let caption = format!("Von Mises stress and broken joints, {label}, {way} m");
            pictures.push(pictures::state(bench, &frame, shown, &file, &caption)?);
        }
    }
    Ok(Outcome { findings, pictures })
}

/// When the support begins and ends to settle \[s\].
fn course(run: &BridgeRun) -> Result<[f64; 2], CaseError> {
    let times = |load: &Load| match *load {
        Load::Settlement { from_s, to_s, .. } => Some([from_s, to_s]),
        _ => None,
    };
    let found = run.scenario.loads.iter().find_map(times);
    found.ok_or_else(|| CaseError::missing(format!("{} has no settlement", run.label)))
}

/// Largest von Mises stress of masonry that lay higher than `above` at the start \[Pa\].
fn largest_stress(run: &BridgeRun, frame: &Frame, above: f64) -> Result<f64, CaseError> {
    let values = Field::VonMises.values(frame)?.of_elements(frame);
    let masonry = values
        .iter()
        .zip(middles(frame))
        .filter(|(_, middle)| middle[0].abs() < run.half_length() && middle[1] > above);
    Ok(masonry.map(|(&stress, _)| stress).fold(0.0, f64::max))
}

/// How far the left support went down \[m\].
fn settled(frame: &Frame) -> f64 {
    let initial = frame.initial();
    let base = (0..initial.len())
        .filter(|&n| initial[n][1] == 0.0 && (-8.3..-1.0).contains(&initial[n][0]));
    base.map(|n| initial[n][1] - frame.points[n][1]).fold(0.0, f64::max)
}
