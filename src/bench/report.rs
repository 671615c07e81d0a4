use super::{Machine, Spread};
use crate::simulation::PhaseTimes;
use serde::{Deserialize, Serialize};

/// Figures of a whole suite.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Report {
    /// Version of Ypsilon.
    pub version: String,
    /// When it was measured.
    pub date: String,
    /// What it was measured on.
    pub machine: Machine,
    /// Runs of each scene with each number of threads.
    pub repeats: usize,
    /// One entry for each scene or deck.
    pub scenes: Vec<SceneReport>,
    /// Growth series.
    pub growth: Vec<Growth>,
    /// What could not be measured, and why.
    pub notes: Vec<String>,
}

/// Figures of a scene.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct SceneReport {
    /// Its name.
    pub name: String,
    /// What it is.
    pub about: String,
    /// Number of triangles.
    pub triangles: usize,
    /// Number of joints at the start.
    pub joints: usize,
    /// Number of nodes at the end.
    pub nodes: usize,
    /// Steps of a run.
    pub steps: u64,
    /// Figures for each number of threads.
    pub runs: Vec<Run>,
    /// Instructions for each triangle-step on one thread; start-up cancels out. `None` if they
    /// were not counted.
    pub instructions_per_triangle_step: Option<f64>,
}

/// Figures of a scene with a number of threads.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Run {
    /// Threads.
    pub threads: usize,
    /// Triangle-steps per second of the whole process, reading the deck and writing results
    /// included.
    pub process: Spread,
    /// Triangle-steps per second of the step loop, output included.
    pub step_loop: Spread,
    /// Speed of the step loop by that of the smallest number of threads, medians.
    pub speed_up: f64,
    /// Wall-clock time of the step loop of the run whose phases were timed, s.
    pub phases_of_seconds: f64,
    /// Where it went, s; what is left over went into output and histories.
    pub phases: PhaseTimes,
    /// Joints that broke.
    pub broken_joints: usize,
    /// Contact detections.
    pub detections: u64,
    /// Couples evaluated, in the mean of all steps.
    pub couples_per_step: f64,
    /// Couples at rest, in the mean of all steps.
    pub rested_per_step: f64,
    /// Most memory of the process, bytes; `None` where the system does not tell.
    pub peak_memory: Option<u64>,
    /// The same by the number of triangles.
    pub memory_per_triangle: Option<f64>,
}

impl Run {
    /// Time of output and histories, s.
    #[must_use]
    pub fn output_seconds(&self) -> f64 {
        (self.phases_of_seconds - self.phases.sum()).max(0.0)
    }
}

/// How the cost of a scene grows with its size.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Growth {
    /// The scene.
    pub name: String,
    /// Threads.
    pub threads: usize,
    /// The same scene in several sizes, smallest first.
    pub sizes: Vec<SceneReport>,
    /// p of time per step ∝ trianglesᵖ; `None` with fewer than two sizes.
    pub time_exponent: Option<f64>,
    /// p of peak memory ∝ trianglesᵖ.
    pub memory_exponent: Option<f64>,
}

impl Report {
    /// The report as JSON.
    ///
    /// # Errors
    /// If a figure cannot be written, which does not happen to finite ones.
    pub fn to_json(&self) -> serde_json::Result<String> {
        serde_json::to_string_pretty(self)
    }

    /// Reads what [`Self::to_json`] gave.
    ///
    /// # Errors
    /// If it is no such report.
    pub fn from_json(text: &str) -> serde_json::Result<Self> {
        serde_json::from_str(text)
    }
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A report with one scene on one and two threads.
    pub fn example() -> Report {
        let spread = |median: f64| Spread { median, min: median - 2e5, max: median + 2e5 };
        let run = |threads: usize, speed: f64| Run {
            threads,
            process: spread(speed - 1e5),
            step_loop: spread(speed),
            speed_up: speed / 2e6,
            phases_of_seconds: 1.0,
            phases: PhaseTimes {
                triangles: 0.1,
                joints: 0.2,
                detection: 0.05,
                overlap: 0.5,
                integration: 0.1,
            },
            broken_joints: 3,
            detections: 7,
            couples_per_step: 1234.5,
            rested_per_step: 0.25,
            peak_memory: Some(12_345_625),
            memory_per_triangle: Some(2469.125),
        };
        let scene = SceneReport {
            name: "jointed".to_owned(),
            about: "a sheet".to_owned(),
            triangles: 5000,
            joints: 7400,
            nodes: 15_000,
            steps: 1000,
            runs: vec![run(1, 2e6), run(2, 3e6)],
            instructions_per_triangle_step: Some(3177.0),
        };
        Report {
            version: "0.1.0".to_owned(),
            date: "2026-01-02".to_owned(),
            machine: Machine {
                processor: "P".to_owned(),
                cores: 2,
                system: "s".to_owned(),
                load: None,
            },
            repeats: 3,
            growth: vec![Growth {
                name: "jointed".to_owned(),
                threads: 1,
                sizes: vec![scene.clone()],
                time_exponent: Some(1.01),
                memory_exponent: None,
            }],
            scenes: vec![scene],
            notes: vec!["a note".to_owned()],
        }
    }

    #[test]
    fn reports_survive_json() {
        let report = example();
        let text = report.to_json().expect("JSON");
        assert_eq!(Report::from_json(&text).expect("the report"), report);
        let value: serde_json::Value = serde_json::from_str(&text).expect("JSON");
        assert_eq!(value["scenes"][0]["runs"][1]["step_loop"]["median"], 3e6);
        assert_eq!(value["growth"][0]["memory_exponent"], serde_json::Value::Null);
    }

    #[test]
    fn what_phases_leave_is_output() {
        let run = &example().scenes[0].runs[0];
        assert!((run.output_seconds() - 0.05).abs() < 1e-12);
    }
}
