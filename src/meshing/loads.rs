//! Loads in words, and what they amount to at the nodes of the top over time.
//!
//! Loads are forces on one metre of depth. They come in stages after the structure has settled;
//! see [`Staging`].

use super::{
    MeshingError,
    model::{History, Model},
    properties::{count, not_negative, positive},
};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// When and how fast loads come.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Staging {
    /// When the first part comes \[s\].
    pub start_s: f64,
    /// Time between parts \[s\].
    pub interval_s: f64,
    /// Size of a part: 0.25 makes four of them.
    pub part: f64,
    /// How long each part takes to come \[s\].
    pub ramp_s: f64,
}

impl Default for Staging {
    /// A quarter every half second from 1.5 s, each within 10 ms.
    fn default() -> Self {
        Staging { start_s: 1.5, interval_s: 0.5, part: 0.25, ramp_s: 0.01 }
    }
}

impl Staging {
    /// Everything at once at the very beginning.
    #[must_use]
    pub fn abrupt() -> Self {
        Staging { start_s: 0.0, interval_s: 0.5, part: 1.0, ramp_s: 0.0 }
    }

    /// The factor over time.
    #[must_use]
    pub fn history(&self) -> History {
        let parts = (1.0 / self.part).ceil().clamp(1.0, 1000.0) as usize;
        let mut history = Vec::new();
        for k in 0..parts {
            let start = self.start_s + k as f64 * self.interval_s;
            let before = (k as f64 * self.part).min(1.0);
            let after = if k + 1 == parts { 1.0 } else { (k + 1) as f64 * self.part };
            if start + self.ramp_s > 0.0 {
                history.push([start, before]);
            }
            if self.ramp_s > 0.0 || start <= 0.0 {
                history.push([start + self.ramp_s, after]);
            }
        }
        history
    }

    /// When everything is there \[s\].
    #[must_use]
    pub fn complete_s(&self) -> f64 {
        self.history().last().map_or(0.0, |point| point[0])
    }

    pub(super) fn check(&self) -> Result<(), MeshingError> {
        not_negative("staging.start_s", self.start_s)?;
        positive("staging.interval_s", self.interval_s)?;
        not_negative("staging.ramp_s", self.ramp_s)?;
        if !(0.001..=1.0).contains(&self.part) {
            let expected = "a part of the load, from 0.001 to 1";
            return Err(MeshingError::parameter("staging.part", self.part, expected));
        }
        if self.ramp_s >= self.interval_s {
            let expected = "a ramp ends before the next part comes (interval_s)";
            return Err(MeshingError::parameter("staging.ramp_s", self.ramp_s, expected));
        }
        if self.ramp_s == 0.0 && self.start_s > 0.0 {
            let expected = "a load that does not come at the very beginning needs a ramp";
            return Err(MeshingError::parameter("staging.ramp_s", self.ramp_s, expected));
        }
        Ok(())
    }
}

/// A load.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(tag = "type", rename_all = "kebab-case", deny_unknown_fields)]
pub enum Load {
    /// A force downward at a place of the top: on the node there, or shared by the two beside it.
    Point {
        /// How much \[N\].
        force_n: f64,
        /// Abscissa \[m\]; the middle if it is not given.
        #[serde(default)]
        x_m: f64,
    },
    /// A load downward over a part of the top; over all of it without `from_m` and `to_m`.
    Distributed {
        /// How much \[N/m\].
        load_n_per_m: f64,
        /// Left end \[m\].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        from_m: Option<f64>,
        /// Right end \[m\].
        #[serde(default, skip_serializing_if = "Option::is_none")]
        to_m: Option<f64>,
    },
    /// Axles over the middle, and distributed parts on both sides of them.
    Train {
        /// Number of axles.
        #[serde(default = "train::axles")]
        axles: usize,
        /// Force of an axle \[N\].
        #[serde(default = "train::axle_n")]
        axle_n: f64,
        /// Between axles \[m\].
        #[serde(default = "train::spacing_m")]
        spacing_m: f64,
        /// From the outer axles to the distributed parts \[m\].
        #[serde(default = "train::gap_m")]
        gap_m: f64,
        /// The distributed parts \[N/m\].
        #[serde(default = "train::load_n_per_m")]
        load_n_per_m: f64,
        /// Length of each distributed part \[m\].
        #[serde(default = "train::length_m")]
        length_m: f64,
    },
    /// A load over all of the top that grows and shrinks as half a sine wave.
    HalfSine {
        /// The largest load \[N/m\].
        load_n_per_m: f64,
        /// Beginning \[s\].
        #[serde(default = "sine::from_s")]
        from_s: f64,
        /// End \[s\].
        #[serde(default = "sine::to_s")]
        to_s: f64,
    },
    /// Axles that come in stages at the left end of the top, and then drive to its right end.
    Convoy {
        /// Number of axles.
        #[serde(default = "train::axles")]
        axles: usize,
        /// Force of an axle \[N\].
        #[serde(default = "train::axle_n")]
        axle_n: f64,
        /// Between axles \[m\].
        #[serde(default = "train::spacing_m")]
        spacing_m: f64,
        /// Speed \[m/s\].
        #[serde(default = "convoy::speed_m_s")]
        speed_m_s: f64,
        /// How often the forces at the nodes are given \[s\].
        #[serde(default = "convoy::interval_s")]
        interval_s: f64,
    },
    /// A support that moves downward.
    Settlement {
        /// Which one.
        #[serde(default)]
        side: Side,
        /// How fast \[m/s\].
        #[serde(default = "settlement::velocity_m_s")]
        velocity_m_s: f64,
        /// Beginning \[s\].
        #[serde(default = "sine::from_s")]
        from_s: f64,
        /// End \[s\].
        #[serde(default = "settlement::to_s")]
        to_s: f64,
    },
}

impl Load {
    /// When the structure has settled under the load: an interval of the staging after its last
    /// change \[s\].
    #[must_use]
    pub fn end_s(&self, model: &Model, staging: &Staging) -> f64 {
        let staged = staging.complete_s() + staging.interval_s - staging.ramp_s;
        match *self {
            Load::Point { .. } | Load::Distributed { .. } | Load::Train { .. } => staged,
            Load::HalfSine { to_s, .. } | Load::Settlement { to_s, .. } => {
                to_s + staging.interval_s
            }
            Load::Convoy { axles, spacing_m, speed_m_s, .. } => {
                let x = |node: Option<&usize>| node.map_or(0.0, |&n| model.mesh.nodes[n][0]);
                let top = x(model.top.last()) - x(model.top.first());
                staged + (top - axles.saturating_sub(1) as f64 * spacing_m) / speed_m_s
            }
        }
    }
}

/// The left or the right support.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Side {
    /// The left one.
    #[default]
    Left,
    /// The right one.
    Right,
}

mod train {
    pub(super) fn axles() -> usize {
        4
    }
    pub(super) fn axle_n() -> f64 {
        250e3
    }
    pub(super) fn spacing_m() -> f64 {
        1.6
    }
    pub(super) fn gap_m() -> f64 {
        0.8
    }
    pub(super) fn load_n_per_m() -> f64 {
        80e3
    }
    pub(super) fn length_m() -> f64 {
        5.1
    }
}

mod sine {
    pub(super) fn from_s() -> f64 {
        1.5
    }
    pub(super) fn to_s() -> f64 {
        3.5
    }
    /// Straight pieces that stand for half a wave.
    pub(super) const PIECES: usize = 100;
}

mod convoy {
    pub(super) fn speed_m_s() -> f64 {
        100.0 / 3.6
    }
    pub(super) fn interval_s() -> f64 {
        0.01
    }
}

mod settlement {
    pub(super) fn velocity_m_s() -> f64 {
        0.2
    }
    pub(super) fn to_s() -> f64 {
        4.5
    }
}

/// Forces downward at the nodes of the top at one instant \[N\], by their number from the left.
pub(super) type Forces = Vec<f64>;

/// A load as forces at the nodes of the top: linear in time between the given instants, constant
/// outside.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct TopLoad {
    /// Instants \[s\] with forces.
    pub course: Vec<(f64, Forces)>,
    /// The whole force \[N\] at the same instants, from the description alone.
    pub total: Vec<f64>,
}

/// Nodes of the top, from left to right.
pub(super) struct Top<'a> {
    /// Their abscissas \[m\].
    pub x: &'a [f64],
}

impl Top<'_> {
    fn ends(&self) -> Option<(f64, f64)> {
        Some((*self.x.first()?, *self.x.last()?))
    }

    /// Shares a force between the nodes left and right of its place, by the lever.
    fn point(&self, forces: &mut Forces, x: f64, force: f64) {
        let right = self.x.partition_point(|&node| node < x - 1e-9);
        let Some(&beyond) = self.x.get(right) else {
            if let Some(last) = forces.last_mut() {
                *last += force;
            }
            return;
        };
        if right == 0 || (beyond - x).abs() <= 1e-9 {
            forces[right] += force;
            return;
        }
        let before = self.x[right - 1];
        let share = (x - before) / (beyond - before);
        forces[right - 1] += force * (1.0 - share);
        forces[right] += force * share;
    }

    /// Shares a distributed load: each piece between nodes goes to its ends by the lever.
    fn distributed(&self, forces: &mut Forces, from: f64, to: f64, load: f64) {
        for k in 1..self.x.len() {
            let (a, b) = (self.x[k - 1], self.x[k]);
            let (start, end) = (a.max(from), b.min(to));
            if end > start {
                let share = (f64::midpoint(start, end) - a) / (b - a);
                forces[k - 1] += load * (end - start) * (1.0 - share);
                forces[k] += load * (end - start) * share;
            }
        }
    }

    fn none(&self) -> Forces {
        vec![0.0; self.x.len()]
    }
}

/// What loads need to know of the structure: its top and when loads come.
pub(super) fn top_load(
    load: &Load,
    top: &Top<'_>,
    staging: &Staging,
) -> Result<Option<TopLoad>, MeshingError> {
    let Some((left, right)) = top.ends() else {
        let expected = "this kind of mesh has no top to be loaded";
        return match load {
            Load::Settlement { .. } => Ok(None),
            _ => Err(MeshingError::parameter("loads", "given", expected)),
        };
    };
    let on_top = |name: &str, x: f64| {
        if x >= left - 1e-6 && x <= right + 1e-6 {
            return Ok(());
        }
        let expected = format!("the top lies from {left} to {right}");
        Err(MeshingError::parameter(name, x, &expected))
    };
    let mut forces = top.none();
    let total = match *load {
        Load::Settlement { .. } => return Ok(None),
        Load::Point { force_n, x_m } => {
            on_top("loads.x_m", x_m)?;
            top.point(&mut forces, x_m, force_n);
            force_n
        }
        Load::Distributed { load_n_per_m, from_m, to_m } => {
            let (from, to) = (from_m.unwrap_or(left), to_m.unwrap_or(right));
            on_top("loads.from_m", from)?;
            on_top("loads.to_m", to)?;
            positive("loads.to_m - loads.from_m", to - from)?;
            top.distributed(&mut forces, from, to, load_n_per_m);
            load_n_per_m * (to - from)
        }
        Load::Train { axles, axle_n, spacing_m, gap_m, load_n_per_m, length_m } => {
            count("loads.axles", axles, 1)?;
            not_negative("loads.gap_m", gap_m)?;
            not_negative("loads.length_m", length_m)?;
            let middle = f64::midpoint(left, right);
            let half = (axles - 1) as f64 * spacing_m / 2.0;
            let outer = half + gap_m + length_m;
            on_top("half the train", middle + outer)?;
            for k in 0..axles {
                top.point(&mut forces, middle - half + k as f64 * spacing_m, axle_n);
            }
            let near = half + gap_m;
            top.distributed(&mut forces, middle - outer, middle - near, load_n_per_m);
            top.distributed(&mut forces, middle + near, middle + outer, load_n_per_m);
            axles as f64 * axle_n + 2.0 * load_n_per_m * length_m
        }
        Load::HalfSine { load_n_per_m, from_s, to_s } => {
            positive("loads.to_s - loads.from_s", to_s - from_s)?;
            not_negative("loads.from_s", from_s)?;
            top.distributed(&mut forces, left, right, load_n_per_m);
            let history = (0..=sine::PIECES).map(|k| {
                let part = k as f64 / sine::PIECES as f64;
                let end = k == 0 || k == sine::PIECES;
                let wave = if end { 0.0 } else { (part * std::f64::consts::PI).sin() };
                [from_s + part * (to_s - from_s), wave]
            });
            return Ok(Some(scaled(&history.collect(), &forces, load_n_per_m * (right - left))));
        }
        Load::Convoy { axles, axle_n, spacing_m, speed_m_s, interval_s } => {
            count("loads.axles", axles, 1)?;
            positive("loads.speed_m_s", speed_m_s)?;
            positive("loads.interval_s", interval_s)?;
            let length = (axles - 1) as f64 * spacing_m;
            on_top("the convoy's head", left + length)?;
            let way = right - left - length;
            return Ok(Some(convoy_course(top, staging, way, interval_s, speed_m_s, |first| {
                (0..axles).map(|k| (left + first + k as f64 * spacing_m, axle_n)).collect()
            })));
        }
    };
    Ok(Some(scaled(&staging.history(), &forces, total)))
}

/// Forces that keep their proportions.
fn scaled(history: &History, forces: &Forces, total: f64) -> TopLoad {
    let course =
        history.iter().map(|&[t, f]| (t, forces.iter().map(|force| force * f).collect())).collect();
    TopLoad { course, total: history.iter().map(|[_, f]| f * total).collect() }
}

/// Axles that come in stages and then move.
fn convoy_course(
    top: &Top<'_>,
    staging: &Staging,
    way: f64,
    interval_s: f64,
    speed: f64,
    axles: impl Fn(f64) -> Vec<Axle>,
) -> TopLoad {
    let at = |first: f64| {
        let mut forces = top.none();
        axles(first).into_iter().for_each(|(x, force)| top.point(&mut forces, x, force));
        forces
    };
    let total: f64 = axles(0.0).iter().map(|(_, force)| force).sum();
    let mut load = scaled(&staging.history(), &at(0.0), total);
    // the last part settles before the convoy starts
    let start = staging.complete_s() + staging.interval_s - staging.ramp_s;
    let steps = (way / speed / interval_s).ceil().clamp(1.0, MOST_INSTANTS) as usize;
    for k in 0..=steps {
        let time = (k as f64 * interval_s).min(way / speed);
        load.course.push((start + time, at((time * speed).min(way))));
        load.total.push(total);
    }
    load
}

/// An axle: abscissa \[m\] and force \[N\].
type Axle = (f64, f64);

/// Most instants of a convoy's drive.
const MOST_INSTANTS: f64 = 100_000.0;

/// Moves that settlements ask of a support: downward velocity and its course.
pub(super) fn settlement(load: &Load) -> Result<Option<(Side, f64, History)>, MeshingError> {
    let Load::Settlement { side, velocity_m_s, from_s, to_s } = *load else { return Ok(None) };
    positive("loads.to_s - loads.from_s", to_s - from_s)?;
    positive("loads.from_s", from_s)?;
    let ramp = (1e-3_f64).min((to_s - from_s) / 4.0).min(from_s / 2.0);
    // ramps centred at both ends: the whole way is velocity times duration
    let history = vec![
        [from_s - ramp / 2.0, 0.0],
        [from_s + ramp / 2.0, 1.0],
        [to_s - ramp / 2.0, 1.0],
        [to_s + ramp / 2.0, 0.0],
    ];
    Ok(Some((side, velocity_m_s, history)))
}

/// The value of a history at an instant; 1 if it is empty.
pub(super) fn value(history: &[[f64; 2]], time: f64) -> f64 {
    let after = history.partition_point(|point| point[0] <= time);
    match (after.checked_sub(1).and_then(|k| history.get(k)), history.get(after)) {
        (None, None) => 1.0,
        (Some(last), None) => last[1],
        (None, Some(first)) => first[1],
        (Some([t0, f0]), Some([t1, f1])) => f0 + (f1 - f0) * ((time - t0) / (t1 - t0)),
    }
}
