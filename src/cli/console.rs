//! Lines on the screen. A screen that is gone (a closed pipe, say) is no reason to end a run.

use std::io::{Write, stderr, stdout};

/// Prints a line on the standard output.
pub(super) fn say(line: &str) {
    let _ = writeln!(stdout(), "{line}");
}

/// Prints a line on the error stream.
pub(super) fn warn(line: &str) {
    let _ = writeln!(stderr(), "{line}");
}
