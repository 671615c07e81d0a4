//! The three bridges, and what is measured on them.

use crate::{Bench, CaseError, Length, Run};
use ypsilon::{
    meshing::{Load, Scenario, kinds::Bridge},
    session::Format,
};
use ypsilon_post::{
    Point,
    extract::{Path, along, top_line},
    field::Field,
    results::{Frame, FrameChoice, JointState, Results},
    selection::Selection,
};

/// File names of the three scenarios of a case and the ratio of arch diameter to length.
pub(super) const ALL: [(&str, &str); 3] =
    [("quarter", "D = 0.25 L"), ("half", "D = 0.5 L"), ("three-quarters", "D = 0.75 L")];

/// How much of the time the test suite has: some periods of the bridges before loads begin.
const SHORT: f64 = 0.075;

/// When the structure has settled and the loads begin \[s\].
pub(super) const SETTLED: f64 = 1.5;

/// A bridge after its run.
pub(super) struct BridgeRun {
    pub label: &'static str,
    pub scenario: Scenario,
    pub bridge: Bridge,
    pub run: Run,
    pub results: Results,
    /// When loads begin \[s\].
    pub settled: f64,
}

/// Runs the three bridges of a case; in the test suite the one with the fewest triangles.
pub(super) fn run_shown(bench: &Bench) -> Result<Vec<BridgeRun>, CaseError> {
    let shown = bench.pick(&ALL[..], &ALL[2..]);
    shown.iter().map(|&(name, label)| run_one(bench, name, label)).collect()
}

/// Runs the three bridges of a case.
pub(super) fn run_all(bench: &Bench) -> Result<Vec<BridgeRun>, CaseError> {
    ALL.iter().map(|&(name, label)| run_one(bench, name, label)).collect()
}

/// Runs one scenario of a case's folder.
pub(super) fn run_one(
    bench: &Bench,
    name: &str,
    label: &'static str,
) -> Result<BridgeRun, CaseError> {
    run_scenario(bench, bench.scenario(&format!("{name}.toml"))?, name, label)
}

/// Runs a scenario of a bridge; in the test suite one of large blocks that goes fast.
pub(super) fn run_scenario(
    bench: &Bench,
    mut scenario: Scenario,
    name: &str,
    label: &'static str,
) -> Result<BridgeRun, CaseError> {
    if bench.length() == Length::Short {
        coarsen(&mut scenario);
        hasten(&mut scenario);
    }
    run_as_it_is(bench, scenario, name, label)
}

/// Runs a scenario of a bridge as it is.
pub(super) fn run_as_it_is(
    bench: &Bench,
    scenario: Scenario,
    name: &str,
    label: &'static str,
) -> Result<BridgeRun, CaseError> {
    let none = || CaseError::missing(format!("{name} describes no bridge"));
    let bridge = scenario.bridge.clone().ok_or_else(none)?;
    let run = bench.run(&scenario, name, &[Format::Vtu, Format::Yh])?;
    let results = run.results()?;
    let settled = scenario.staging.start_s;
    Ok(BridgeRun { label, scenario, bridge, run, results, settled })
}

/// Makes the blocks large, and the time step as long as they allow.
fn coarsen(scenario: &mut Scenario) {
    if let Some(bridge) = &mut scenario.bridge {
        bridge.courses = 8;
        bridge.block_length_m = 16.6 / 14.0;
        bridge.ring_thickness_m = 0.65;
        if bridge.arch_diameter_m > 12.0 {
            // a course above the ring
            bridge.arch_diameter_m = 11.6;
        }
    }
    scenario.run.step_s = None;
    scenario.run.monitor_interval = Some(50);
}

/// Lets loads come in halves instead of quarters, and makes everything thirteen times as fast.
fn hasten(scenario: &mut Scenario) {
    let staging = &mut scenario.staging;
    if staging.part < 0.5 {
        let end = scenario.run.end_s.get_or_insert(4.0);
        if scenario.loads.iter().any(is_staged) {
            // two stages less, one of them to come to rest
            *end -= staging.interval_s;
        }
        staging.part = 0.5;
    }
    let run = &mut scenario.run;
    for time in [&mut run.end_s, &mut run.output_s].into_iter().flatten() {
        *time *= SHORT;
    }
    scenario.staging.start_s *= SHORT;
    scenario.staging.interval_s *= SHORT;
    scenario.staging.ramp_s *= SHORT;
    for load in &mut scenario.loads {
        match load {
            Load::HalfSine { from_s, to_s, .. } => {
                *from_s *= SHORT;
                *to_s *= SHORT;
            }
            Load::Settlement { from_s, to_s, velocity_m_s, .. } => {
                *from_s *= SHORT;
                *to_s *= SHORT;
                *velocity_m_s /= SHORT;
            }
            Load::Convoy { speed_m_s, interval_s, .. } => {
                *speed_m_s /= SHORT;
                *interval_s *= SHORT;
            }
            Load::Point { .. } | Load::Distributed { .. } | Load::Train { .. } => {}
        }
    }
}

/// Whether a load comes in stages.
fn is_staged(load: &Load) -> bool {
    match load {
        Load::Point { .. }
        | Load::Distributed { .. }
        | Load::Train { .. }
        | Load::Convoy { .. } => true,
        Load::HalfSine { .. } | Load::Settlement { .. } => false,
    }
}

impl BridgeRun {
    /// Half of the masonry's length \[m\].
    pub fn half_length(&self) -> f64 {
        self.bridge.span_m / 2.0
    }

    /// Height of the arch's centre \[m\].
    pub fn centre(&self) -> f64 {
        self.bridge.centre_height_m.unwrap_or(0.3 * self.radius())
    }

    /// Inner radius of the arch \[m\].
    pub fn radius(&self) -> f64 {
        self.bridge.arch_diameter_m / 2.0
    }

    /// The state nearest to a time.
    pub fn frame_at(&mut self, time: f64) -> Result<Frame, CaseError> {
        let index = self.results.index_of(FrameChoice::Time(time))?;
        Ok(self.results.frame(index)?)
    }

    /// The last state.
    pub fn last(&mut self) -> Result<Frame, CaseError> {
        let index = self.results.index_of(FrameChoice::Last)?;
        Ok(self.results.frame(index)?)
    }

    /// Largest compression σyy in the masonry, as a positive number \[Pa\], and where the
    /// triangle lay at the start \[m\].
    pub fn compression(&self, frame: &Frame) -> (f64, [f64; 2]) {
        let stress = frame.stress.as_deref().unwrap_or_default();
        let middles = middles(frame);
        let masonry =
            stress.iter().zip(&middles).filter(|(_, at)| at[0].abs() < self.half_length());
        masonry
            .map(|(&[_, yy, ..], &at)| (-yy, at))
            .max_by(|a, b| a.0.total_cmp(&b.0))
            .unwrap_or((f64::NAN, [f64::NAN; 2]))
    }

    /// Mean vertical reaction of both halves of the ground between two times \[N\].
    pub fn ground(&self, from: f64, to: f64) -> Result<f64, CaseError> {
        let table = self.run.monitors()?;
        let time = table.find("time")?;
        let feet =
            [table.find("left footing reaction-y")?, table.find("right footing reaction-y")?];
        let within = table.rows.iter().filter(|row| (from..=to).contains(&row[time]));
        let (sum, n) = within.fold((0.0, 0.0), |(sum, n), row| {
            (sum + feet.iter().map(|&foot| row[foot]).sum::<f64>(), n + 1.0)
        });
        Ok(sum / n)
    }

    /// Vertical displacements of the top, left to right: abscissas \[m\] and what the nodes there
    /// have moved from one time to another on average \[m\].
    pub fn top(&mut self, from: Option<f64>, to: f64) -> Result<Vec<[f64; 2]>, CaseError> {
        let (half, height) = (self.half_length(), self.bridge.height_m);
        let selection = Selection::Line([[-half, height], [half, height]].map(Point::Plane));
        let mut times = vec![FrameChoice::Time(to)];
        times.extend(from.map(FrameChoice::Time));
        let table = top_line(&mut self.results, Some(&selection), &times)?;
        let count = table.rows.len() / times.len();
        let mut line: Vec<([f64; 2], f64)> = Vec::new();
        for k in 0..count {
            let row = &table.rows[k];
            let before = if from.is_some() { table.rows[k + count][5] } else { 0.0 };
            let (x, uy) = (row[2], row[5] - before);
            match line.last_mut() {
                Some((point, n)) if (point[0] - x).abs() < 1e-9 => {
                    point[1] += uy;
                    *n += 1.0;
                }
                _ => line.push(([x, uy], 1.0)),
            }
        }
        Ok(line.into_iter().map(|([x, sum], n)| [x, sum / n]).collect())
    }

    /// A field along the middle of the ring from the left springing over the key to the right one
    /// at some time: angle from the key \[degrees\], positive to the right, and value.
    pub fn along_ring(&mut self, field: Field, time: f64) -> Result<Vec<[f64; 2]>, CaseError> {
        let radius = self.radius() + self.bridge.ring_thickness_m / 2.0;
        let path = Path::Arc { centre: [0.0, self.centre()], radius, angles: [179.5, 0.5] };
        let table = along(&mut self.results, &path, 180, &[field], &[FrameChoice::Time(time)])?;
        let value = table.find(field.name())?;
        let angle = table.find("angle")?;
        Ok(table.rows.iter().map(|row| [90.0 - row[angle], row[value]]).collect())
    }

    /// Broken joints of a state on the ring: angle from the key \[degrees\], positive to the right,
    /// and opening \[m\].
    pub fn cracks_of_ring(&self, frame: &Frame) -> Vec<[f64; 2]> {
        let inner = self.radius() - 0.05;
        let outer = self.radius() + self.bridge.ring_thickness_m - 0.02;
        let broken = frame.joints.iter().filter(|joint| joint.state == JointState::Broken);
        broken
            .filter_map(|joint| {
                let ends =
                    [0, 1].map(|k| [0, 1].map(|i| joint.ends[k][i] - joint.displacement[k][i]));
                let at = [0, 1].map(|i| f64::midpoint(ends[0][i], ends[1][i]));
                let from_centre = [at[0], at[1] - self.centre()];
                let radius = from_centre[0].hypot(from_centre[1]);
                // across the ring, not along its back
                let along = [ends[1][0] - ends[0][0], ends[1][1] - ends[0][1]];
                let length = along[0].hypot(along[1]);
                let radial =
                    (along[0] * from_centre[0] + along[1] * from_centre[1]) / (length * radius);
                let angle = from_centre[0].atan2(from_centre[1]).to_degrees();
                let within = (inner..outer).contains(&radius) && radial.abs() > 0.7;
                (within && at[1] > self.centre()).then_some([angle, joint.opening.unwrap_or(0.0)])
            })
            .collect()
    }
}

/// Middles of the triangles at the start \[m\].
pub(super) fn middles(frame: &Frame) -> Vec<[f64; 2]> {
    let initial = frame.initial();
    frame
        .elements
        .iter()
        .map(|&t| {
            let c = Frame::corners(t, &initial);
            [0, 1].map(|i| (c[0][i] + c[1][i] + c[2][i]) / 3.0)
        })
        .collect()
}

/// The largest difference of σyy between triangles that mirror each other, relative to the largest
/// stress; none if a triangle has no mirror image.
pub(super) fn asymmetry(frame: &Frame) -> Option<f64> {
    use std::collections::BTreeMap;
    let stress = frame.stress.as_deref()?;
    let key = |[x, y]: [f64; 2]| [x, y].map(|v| (v * 1e7).round() as i64);
    let middles = middles(frame);
    let at: BTreeMap<[i64; 2], f64> =
        middles.iter().zip(stress).map(|(&m, s)| (key(m), s[1])).collect();
    let largest = stress.iter().map(|s| s[1].abs()).fold(0.0, f64::max);
    let mut worst: f64 = 0.0;
    for (&[x, y], s) in middles.iter().zip(stress) {
        // rounding to a grid: the mirror image may lie in the next cell
        let [i, j] = key([-x, y]);
        let near = (-1..=1).flat_map(|di| (-1..=1).map(move |dj| [i + di, j + dj]));
        let image = near.into_iter().find_map(|cell| at.get(&cell))?;
        worst = worst.max((s[1] - image).abs());
    }
    Some(worst / largest)
}

/// The largest difference of displacements between places of the top that mirror each other,
/// relative to the largest displacement.
pub(super) fn asymmetry_of_top(top: &[[f64; 2]]) -> f64 {
    let largest = top.iter().map(|p| p[1].abs()).fold(0.0, f64::max);
    let n = top.len();
    (0..n).map(|k| (top[k][1] - top[n - 1 - k][1]).abs()).fold(0.0, f64::max) / largest
}
