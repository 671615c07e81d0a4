//! Loads that change fast: half a sine wave, and a convoy.

use super::{
    family::{BridgeRun, run_shown},
    pictures::{self, Shown},
};
use crate::{Bench, Case, CaseError, Finding, Group, Length, Outcome};
use ypsilon::meshing::Load;
use ypsilon_post::field::Field;

/// Half a sine wave of the distributed load.
pub(super) const SINE: Case = Case {
    name: "sine-load",
    group: Group::Bridges,
    title: "Bridges under half a sine wave of load",
    source: "thesis, section 4.5.1, figures 4.17 and 4.18",
    about: "\
The bridges of [self-weight](../self-weight/README.md) with 110 kN/m over the whole top times a half sine from
1.5 s to 3.5 s. Displacements are those since 1.5 s.",
    evaluate: evaluate_sine,
};

/// Four axles at 100 km/h.
pub(super) const CONVOY: Case = Case {
    name: "convoy",
    group: Group::Bridges,
    title: "Bridges under a convoy at 100 km/h",
    source: "thesis, section 4.5.2, figures 4.19 and 4.20",
    about: "\
The bridges of [self-weight](../self-weight/README.md) with four axles of 250 kN, 1.6 m apart, that stand at the
left end of the top, come in quarters every 0.5 s from 1.5 s on, and drive to the right end at 27.8 m/s from 3.5 s on;
forces at the nodes are given every 0.01 s, linear in between, and amount to 1000 kN at every instant. Displacements
are those since 1.5 s.",
    evaluate: evaluate_convoy,
};

/// The lowest point of the top at each time \[m\], since loads began.
fn deflections(run: &mut BridgeRun) -> Result<Vec<[f64; 2]>, CaseError> {
    let (settled, times) = (run.settled, run.results.times().to_vec());
    let later = times.into_iter().filter(|&time| time >= settled - 1e-9);
    later
        .map(|time| {
            let top = run.top(Some(settled), time)?;
            Ok([time, -top.iter().map(|p| p[1]).fold(f64::INFINITY, f64::min)])
        })
        .collect()
}

/// Largest compression of each state \[Pa\].
fn compressions(run: &mut BridgeRun) -> Result<Vec<[f64; 2]>, CaseError> {
    (0..run.results.len())
        .map(|index| {
            let frame = run.results.frame(index)?;
            Ok([frame.time, run.compression(&frame).0])
        })
        .collect()
}

fn largest(curve: &[[f64; 2]]) -> [f64; 2] {
    curve.iter().copied().max_by(|a, b| a[1].total_cmp(&b[1])).unwrap_or([f64::NAN; 2])
}

fn at(curve: &[[f64; 2]], time: f64) -> f64 {
    let near = curve.iter().min_by(|a, b| (a[0] - time).abs().total_cmp(&(b[0] - time).abs()));
    near.map_or(f64::NAN, |p| p[1])
}

const STIFFER: &str = "\
All joints are bonded and no gaps are left here; the thesis's blocks, with gaps where cut ones were left out, \
are softer.";

/// Beginning and end of the wave \[s\].
fn wave(run: &BridgeRun) -> Result<[f64; 2], CaseError> {
    let times = |load: &Load| match *load {
        Load::HalfSine { from_s, to_s, .. } => Some([from_s, to_s]),
        _ => None,
    };
    let found = run.scenario.loads.iter().find_map(times);
    found.ok_or_else(|| CaseError::missing(format!("{} has no half sine", run.label)))
}

fn evaluate_sine(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut runs = run_shown(bench)?;
    let (mut findings, mut figures) = (Vec::new(), Vec::new());
    let full = bench.length() == Length::Full;
    let (mut paths, mut peaks, mut slopes) = (Vec::new(), Vec::new(), Vec::new());
    for run in &mut runs {
        let label = run.label;
        let [from, to] = wave(run)?;
        let at_part = |part: f64| from + part * (to - from);
        let deflection = deflections(run)?;
        let [when, most] = largest(&deflection);
        findings.push(Finding::within(
            &format!("when the deflection is largest, {label}"),
            "s",
            at_part(0.5),
            when,
            0.075 * (to - from),
        ));
        if full {
            let (up, down) = (at(&deflection, at_part(0.25)), at(&deflection, at_part(0.75)));
            findings.push(Finding::statement(
                &format!("deflection at 0.7 of the load, {label}"),
                "unloading above loading, or equal",
                &format!("{:.3} mm loading, {:.3} mm unloading", 1e3 * up, 1e3 * down),
                down >= 0.999 * up,
            ));
        }
        let compression = compressions(run)?;
        let before = at(&compression, run.settled);
        let after = at(&compression, run.run.summary.time);
        findings.push(
            Finding::value(
                &format!("largest compression after unloading, {label}"),
                "MPa",
                before / 1e6,
                after / 1e6,
                if full { 0.02 } else { 0.2 },
            )
            .noted("Expected is the value before the load: no residual stresses."),
        );
        if label.contains("0.25") {
            let reason = "the thesis's value is read from a colour bar";
            let name = "largest deflection since the load began, D = 0.25 L";
            findings.push(Finding::told(name, "mm", 2.70, 1e3 * most, reason).noted(STIFFER));
        }
        let peak = at(&compression, at_part(0.5));
        peaks.push(peak);
        slopes.push(peak - before);
        let path = compression
            .iter()
            .filter(|p| p[0] >= from && p[0] <= to)
            .map(|p| [((p[0] - from) / (to - from) * std::f64::consts::PI).sin(), -p[1]])
            .collect();
        paths.push((label.to_owned(), path));
    }
    if full {
        let megapascals = |values: &[f64]| {
            let all: Vec<String> = values.iter().map(|v| format!("{:.2}", v / 1e6)).collect();
            all.join(", ")
        };
        findings.push(Finding::statement(
            "largest compression σyy under the full load, and its growth",
            "largest for D = 0.75 L, both of them",
            &format!("{} MPa, growth {} MPa", megapascals(&peaks), megapascals(&slopes)),
            peaks[2] > peaks[0].max(peaks[1]) && slopes[2] > slopes[0].max(slopes[1]),
        ));
        let labels = ["load q/q0", "lowest σyy (Pa)"];
        let caption = "Lowest σyy by load, loading and unloading (figure 4.18)";
        figures.push(pictures::lines(bench, paths, labels, "stress-load.png", caption)?);
        let [from, to] = wave(&runs[0])?;
        let time = f64::midpoint(from, to);
        let frame = runs[0].frame_at(time)?;
        let shown = Shown::new(
            Field::DisplacementY,
            format!("{}, largest load ({time:.1} s)", runs[0].label),
        );
        let caption = format!("Vertical displacement at {time:.1} s, self weight included");
        figures.push(pictures::state(bench, &frame, shown, "uy.png", &caption)?);
    }
    Ok(Outcome { findings, pictures: figures })
}

/// A convoy's drive.
struct Drive {
    /// When it starts \[s\].
    start: f64,
    /// When the middle of the axles is over the key \[s\].
    over_key: f64,
    /// Half of the distance between its outer axles \[m\].
    half_length: f64,
}

impl Drive {
    fn of(run: &BridgeRun) -> Result<Self, CaseError> {
        let described = |load: &Load| match *load {
            Load::Convoy { axles, spacing_m, speed_m_s, .. } => {
                Some((axles.saturating_sub(1) as f64 * spacing_m / 2.0, speed_m_s))
            }
            _ => None,
        };
        let Some((half_length, speed)) = run.scenario.loads.iter().find_map(described) else {
            return Err(CaseError::missing(format!("{} has no convoy", run.label)));
        };
        let staging = run.scenario.staging;
        let start = staging.complete_s() + staging.interval_s - staging.ramp_s;
        let over_key = start + (run.half_length() - half_length) / speed;
        Ok(Drive { start, over_key, half_length })
    }
}

fn evaluate_convoy(bench: &Bench) -> Result<Outcome, CaseError> {
    let mut runs = run_shown(bench)?;
    let (mut findings, mut figures) = (Vec::new(), Vec::new());
    let full = bench.length() == Length::Full;
    let mut curves = Vec::new();
    for run in &mut runs {
        let label = run.label;
        let drive = Drive::of(run)?;
        let complete = run.scenario.staging.complete_s();
        let sums = &run.run.generated.node_sets.sums;
        let driving = sums.iter().filter(|sum| sum.time_s >= complete);
        let worst = driving.map(|sum| (sum.applied_n - 1e6).abs()).fold(0.0, f64::max);
        findings.push(Finding::within(
            &format!("sum of the forces less 1000 kN, {label}"),
            "N",
            0.0,
            worst,
            1e-3,
        ));
        let top = run.top(Some(run.settled), drive.over_key)?;
        let lowest = top.iter().min_by(|a, b| a[1].total_cmp(&b[1])).map_or(f64::NAN, |p| p[0]);
        findings.push(Finding::within(
            &format!("lowest place of the top while the axles are over the key, {label}"),
            "m",
            0.0,
            lowest,
            drive.half_length + 0.6,
        ));
        let deflection = deflections(run)?;
        curves.push((label.to_owned(), deflection.iter().map(|p| [p[0], -p[1]]).collect()));
        if !label.contains("0.5") {
            continue;
        }
        let [when, most] = largest(&deflection);
        findings.push(
            Finding::within(
                &format!("when the deflection is largest, {label}"),
                "s",
                drive.over_key,
                when,
                0.1,
            )
            .noted(
                "Expected is the instant when the middle of the axles is over the key. Here the top sinks most where \
                 the axles wait before they drive, at the left end: the masonry below is compressed by 0.30 mm there, \
                 and the arch, which is stiffer than the thesis's, sinks by 0.20 mm when they pass.",
            ),
        );
        let reason = "the thesis's value is read from a colour bar";
        let name = format!("largest deflection since the loads began, {label}");
        findings.push(Finding::told(&name, "mm", 12.0, 1e3 * most, reason).noted(STIFFER));
        let compression = compressions(run)?;
        findings.push(
            Finding::range(
                &format!("largest compression σyy, {label}"),
                "MPa",
                [4.0 / 2.0, 4.0 * 2.0],
                largest(&compression)[1] / 1e6,
            )
            .noted(
                "A factor of two for the size of the triangles under the axles. The thesis's 4.0 MPa is the end of \
                 its colours; here 1000 kN spread from 5 m at the top to the footings, in masonry that is bonded \
                 everywhere and does not bend.",
            ),
        );
        let frame = run.frame_at(when)?;
        let shown = Shown::new(Field::StressYy, format!("{label}, {when:.2} s"));
        let caption = "σyy when the deflection is largest";
        figures.push(pictures::state(bench, &frame, shown, "syy.png", caption)?);
        let feet = footings(run, drive.start)?;
        findings.push(
            Finding::statement(
                &format!("footing with the larger reaction during the drive, {label}"),
                "right",
                &format!(
                    "left {:.0} kN more than before, right {:.0} kN",
                    feet[0] / 1e3,
                    feet[1] / 1e3
                ),
                feet[1] > feet[0],
            )
            .noted(
                "The axles wait over the left footing and leave over the right one; of a bridge that stays elastic \
                 both carry the same at most. The thesis's right footing is worse by what the drive damaged.",
            ),
        );
    }
    if full {
        let labels = ["time (s)", "lowest displacement of the top (m)"];
        let caption = "Deflection under the axles: stages to 3.5 s, then the drive";
        figures.push(pictures::lines(bench, curves, labels, "deflection.png", caption)?);
    }
    Ok(Outcome { findings, pictures: figures })
}

/// Largest additional vertical reaction of left and right footing from a time on \[N\].
fn footings(run: &BridgeRun, from: f64) -> Result<[f64; 2], CaseError> {
    let table = run.run.monitors()?;
    let time = table.find("time")?;
    let mut largest = [0.0_f64; 2];
    for (k, name) in ["left footing reaction-y", "right footing reaction-y"].iter().enumerate() {
        let column = table.find(name)?;
        let before = table
            .rows
            .iter()
            .take_while(|row| row[time] < run.settled)
            .last()
            .map_or(f64::NAN, |row| row[column]);
        for row in table.rows.iter().filter(|row| row[time] >= from) {
            largest[k] = largest[k].max(row[column] - before);
        }
    }
    Ok(largest)
}
