use super::{console::say, deck_report, interrupt};
use crate::{
    output::TABLE_HEADER,
    session::{Observer, Progress, RunSummary, SceneSize, SettlingSummary, StopReason},
    simulation::{SettlingOptions, SettlingProgress, Simulation},
};
use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::{
    io::{IsTerminal, stderr},
    path::{Path, PathBuf},
    time::Duration,
};
use yformat::{
    c_format::Exponential,
    diagnostic::{Diagnostic, Severity},
    source::SourceMap,
};

/// Shows a run on the screen: the original's table, and on a terminal a bar
/// below it; elsewhere the bar's figures follow each row.
pub(super) struct Screen {
    bar: Option<ProgressBar>,
    is_terminal: bool,
    /// Whether the heading of the table stands on the screen: once for all stages.
    has_heading: bool,
    /// The checkpoint written last, and its step.
    checkpoint: Option<(PathBuf, u64)>,
}

impl Screen {
    pub fn new() -> Self {
        Self {
            bar: None,
            is_terminal: stderr().is_terminal(),
            has_heading: false,
            checkpoint: None,
        }
    }

    fn print(&self, line: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| say(line)),
            None => say(line),
        }
    }
}

fn rate(progress: &Progress) -> f64 {
    progress.done as f64 / progress.seconds.max(1e-9)
}

fn time_left(progress: &Progress) -> Duration {
    let rate = rate(progress);
    if rate > 0.0 {
        Duration::from_secs_f64((progress.total - progress.done) as f64 / rate)
    } else {
        Duration::ZERO
    }
}

impl Observer for Screen {
    fn stage_starts(&mut self, deck: &str, size: SceneSize, steps: u64, time_step: f64) {
        say(&format!("\nNEW INPUT: {deck}"));
        say(&format!(
            "{} nodes, {}, {} joints, {} materials; {} steps of {:e} s",
            size.nodes,
            size.bodies_in_words(),
            size.joints,
            size.materials,
            steps,
            time_step
        ));
        say("Start calculating ...");
        if !self.has_heading {
            let more =
                if self.is_terminal { "" } else { "   Kinetic energy     Steps/s   Time left" };
            say(&format!("{TABLE_HEADER}{more}"));
            self.has_heading = true;
        }
        if self.is_terminal {
            let bar = ProgressBar::with_draw_target(Some(steps), ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{bar:24} {percent:>3}% {msg}");
            self.bar = Some(bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())));
        }
    }

    fn findings(&mut self, findings: &[Diagnostic], sources: &SourceMap) {
        deck_report::print(findings, sources, Severity::Warning);
    }

    fn settling_starts(&mut self, simulation: &Simulation, options: &SettlingOptions) {
        let joints = crate::simulation::joint_views(simulation).count();
        say(&format!(
            "Settling {} triangles and {joints} joints to an unbalanced force ratio of {:e} ...",
            simulation.triangles().count(),
            options.tolerance
        ));
        if self.is_terminal {
            let bar = ProgressBar::with_draw_target(None, ProgressDrawTarget::stderr());
            let style = ProgressStyle::with_template("{spinner} {msg}");
            self.bar = Some(bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())));
        }
    }

    fn settling(&mut self, progress: &SettlingProgress) {
        if let Some(bar) = &self.bar {
            bar.set_message(format!(
                "iteration {}  {:.1} % of the loads  unbalanced force ratio {:.2e}",
                progress.iterations,
                100.0 * progress.load,
                progress.ratio
            ));
            bar.tick();
        }
    }

    fn settled(&mut self, summary: &SettlingSummary) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
        let SettlingSummary { settled, seconds, .. } = summary;
        say(&format!(
            "Settled in {} iterations ({seconds:.3} s): unbalanced force ratio {:.2e}",
            settled.iterations, settled.ratio
        ));
        if settled.broken_joints > 0 {
            say(&format!("{} joints have failed on the way", settled.broken_joints));
        }
    }

    fn row(&mut self, row: &str, progress: &Progress) {
        if self.is_terminal {
            self.print(row);
            self.progress(progress);
        } else {
            say(&format!(
                "{row}  {} {:11.1} {:>11}",
                Exponential::new(7).width(15).format(progress.kinetic_energy),
                rate(progress),
                format!("{:.0} s", time_left(progress).as_secs_f64())
            ));
        }
    }

    fn progress(&mut self, progress: &Progress) {
        if let Some(bar) = &self.bar {
            bar.set_length(progress.total);
            bar.set_position(progress.done);
            bar.set_message(format!(
                "step {}  t {:.4e} s  Ek {:.3e} J  {:.0} steps/s  {} left",
                progress.step,
                progress.time,
                progress.kinetic_energy,
                rate(progress),
                HumanDuration(time_left(progress))
            ));
        }
    }

    fn checkpoint(&mut self, path: &Path, step: u64) {
        self.checkpoint = Some((path.to_path_buf(), step));
    }

    fn wants_stop(&self) -> bool {
        interrupt::is_requested()
    }

    fn finished(&mut self, summary: &RunSummary) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
        if summary.stop == StopReason::Interrupted {
            say(&format!("   interrupted: all files are complete up to time {:e} s", summary.time));
        } else {
            say("   ***** Y HAS ORDERLY FINISHED *****");
        }
        let body = if summary.tetrahedra > 0 { "tetrahedron" } else { "triangle" };
        say(&format!(
            "{} steps in {:.3} s: {:.1} ns per {body}-step, {:.3} million {body}-steps per second",
            summary.steps,
            summary.seconds,
            1e9 / summary.triangle_steps_per_second.max(1e-300),
            summary.triangle_steps_per_second / 1e6
        ));
        if summary.broken_joints > 0 {
            let plural = if summary.broken_joints == 1 { "joint has" } else { "joints have" };
            say(&format!("{} {plural} failed", summary.broken_joints));
        }
        if let Some(file) = &self.checkpoint {
            let step = file.1;
            let file = file.0.display();
            say(&format!("{file}: go on from step {step} with `ypsilon resume {file}`"));
        }
        let more = summary.files.len().saturating_sub(1);
        if let Some(file) = summary.files.first() {
            say(&format!("{} and {more} more files written", file.display()));
        }
    }
}
