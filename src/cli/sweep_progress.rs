//! How far a sweep is.

use super::{console::say, sweep::ended};
use crate::sweep::{Event, Study};
use indicatif::{HumanDuration, ProgressBar, ProgressDrawTarget, ProgressStyle};
use std::{
    collections::BTreeSet,
    io::{IsTerminal, stderr},
    time::{Duration, Instant},
};

/// Shows a sweep on the screen: a line for each case that is over, and on a terminal a bar below.
pub(super) struct Display {
    bar: Option<ProgressBar>,
    quiet: bool,
    running: BTreeSet<usize>,
    total: usize,
    done: usize,
    failed: usize,
    started: Instant,
}

impl Display {
    /// A display of so many cases that are to be run.
    pub fn new(study: &Study, total: usize, jobs: usize, threads: usize, quiet: bool) -> Self {
        if !quiet {
            let all = study.cases.len();
            let over = if total < all {
                format!(", {} are over already", all - total)
            } else {
                String::new()
            };
            let plural = if threads == 1 { "thread" } else { "threads" };
            say(&format!("{all} cases{over}; {jobs} at a time, {threads} {plural} each"));
        }
        let bar = (!quiet && stderr().is_terminal()).then(|| {
            let target = ProgressDrawTarget::stderr();
            let bar = ProgressBar::with_draw_target(Some(total as u64), target);
            let style = ProgressStyle::with_template("{bar:24} {pos}/{len} {msg}");
            bar.enable_steady_tick(Duration::from_millis(500));
            bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
        });
        let (running, started) = (BTreeSet::new(), Instant::now());
        Self { bar, quiet, running, total, done: 0, failed: 0, started }
    }

    /// Takes notice.
    pub fn show(&mut self, study: &Study, event: &Event<'_>) {
        match event {
            Event::Started(case) => {
                self.running.insert(case.number);
            }
            Event::Ended(case, record) => {
                self.running.remove(&case.number);
                self.done += 1;
                self.failed += usize::from(record.has_failed());
                let mut line = ended(case, record);
                if self.bar.is_none() {
                    let left = self.time_left().map_or_else(String::new, |left| {
                        format!(", {:.0} s left", left.as_secs_f64())
                    });
                    line.push_str(&format!(" [{}/{}{left}]", self.done, self.total));
                }
                self.print(&line);
            }
        }
        if let Some(bar) = &self.bar {
            bar.set_position(self.done as u64);
            bar.set_message(self.message(study));
        }
    }

    fn message(&self, study: &Study) -> String {
        let running: Vec<String> = self.running.iter().map(usize::to_string).collect();
        let mut parts = Vec::new();
        if self.failed > 0 {
            parts.push(format!("{} failed", self.failed));
        }
        if !running.is_empty() && study.cases.len() > 1 {
            parts.push(format!("running {}", running.join(", ")));
        }
        parts.extend(self.time_left().map(|left| format!("{} left", HumanDuration(left))));
        parts.join("  ")
    }

    /// The mean time of those that are done, for those that are not.
    fn time_left(&self) -> Option<Duration> {
        let done = u32::try_from(self.done).ok().filter(|&done| done > 0)?;
        let left = u32::try_from(self.total.saturating_sub(self.done)).ok()?;
        Some(self.started.elapsed() / done * left)
    }

    fn print(&self, line: &str) {
        match &self.bar {
            Some(bar) => bar.suspend(|| say(line)),
            None if !self.quiet => say(line),
            None => {}
        }
    }

    /// Takes the bar away.
    pub fn close(&self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}
