use std::process::ExitCode;

/// Exit codes, as the help shows them.
pub(super) const HELP: &str = "\
Exit codes:
  0    all steps are done
  1    the deck cannot be read or has errors; no output file was touched
  2    the command line is wrong
  3    a result file cannot be written
  4    the run became unstable (results up to then are complete), or did not settle
  130  interrupted (results up to then are complete)";

/// How the program ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Exit {
    /// Everything asked for is done.
    Done = 0,
    /// An input file cannot be read or has errors.
    Input = 1,
    /// The command line is wrong.
    Usage = 2,
    /// A result file cannot be written.
    Output = 3,
    /// The run became unstable, or did not come to rest with `--settle`.
    Unstable = 4,
    /// A deck that was checked runs, but there are warnings.
    Doubtful = 5,
    /// Some cases of a sweep have failed or are missing.
    SomeFailed = 6,
    /// The user interrupted the run.
    Interrupted = 130,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        ExitCode::from(exit as u8)
    }
}
