//! The process of a case: how it is waited for, ended and asked what went wrong.

use std::{
    fs,
    path::Path,
    process::{Child, ExitStatus},
    thread::sleep,
    time::Duration,
};

/// What the run of a case says goes here.
pub(super) const LOG: &str = "run.log";

/// Of the flags of a run those that a run which goes on takes: the checkpoint tells the others.
pub(super) fn flags_of_a_resumed_run(flags: &[String]) -> Vec<String> {
    let mut kept = Vec::new();
    let mut flags = flags.iter();
    while let Some(flag) = flags.next() {
        let (name, has_value) = match flag.split_once('=') {
            Some((name, _)) => (name, true),
            None => (flag.as_str(), false),
        };
        if ["--steps", "--states", "--on-instability", "--no-skip"].contains(&name) {
            kept.push(flag.clone());
            if !has_value && name != "--no-skip" {
                kept.extend(flags.next().cloned());
            }
        }
    }
    kept
}

/// Waits for a run; lets go of its input when it is to stop, upon which it writes a checkpoint.
pub(super) fn wait(mut child: Child, wants_stop: &dyn Fn() -> bool) -> std::io::Result<ExitStatus> {
    let mut input = child.stdin.take();
    let mut pause = Duration::from_millis(1);
    loop {
        if wants_stop() {
            input = None;
        }
        if let Some(status) = child.try_wait()? {
            drop(input);
            return Ok(status);
        }
        sleep(pause);
        pause = (pause * 2).min(Duration::from_millis(50));
    }
}

/// The exit code; 128 and the signal of a process that was killed, as shells have it.
pub(super) fn exit_code(status: ExitStatus) -> i32 {
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        return 128 + signal;
    }
    status.code().unwrap_or(1)
}

/// The reason that a run gave for its failure.
pub(super) fn why(folder: &Path, status: i32) -> String {
    let log = fs::read(folder.join(LOG)).unwrap_or_default();
    let log = String::from_utf8_lossy(&log);
    let error = log.lines().find(|line| line.starts_with("error"));
    let said = error.or_else(|| log.lines().rfind(|line| !line.trim().is_empty()));
    match said {
        Some(line) => line.trim_start_matches("error: ").to_owned(),
        None if status == 137 => "killed (signal 9): out of memory?".to_owned(),
        None if status > 128 => format!("killed by signal {}", status - 128),
        None => format!("ended with exit code {status}"),
    }
}

#[cfg(test)]
mod tests {
    use super::flags_of_a_resumed_run;

    #[test]
    fn a_resumed_run_takes_few_flags() {
        let words = |text: &str| text.split_whitespace().map(str::to_owned).collect::<Vec<_>>();
        let given = words("--settle --steps 5 --contact two-sided --on-instability=stop --no-skip");
        let kept = words("--steps 5 --on-instability=stop --no-skip");
        assert_eq!(flags_of_a_resumed_run(&given), kept);
    }
}
