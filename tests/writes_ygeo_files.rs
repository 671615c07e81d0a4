//! Result files of Y-Geo, equal to the original's to the byte.
//!
//! Documented exceptions: `fluid pressure` behind the last real point of meshes
//! with shared nodes shows memory that the original never sets, and so do gaps of
//! boundary joints, whose sign of zero depends on memory in front of an array.

mod support;

use std::{path::Path, process::ExitCode};
use support::result_files::{self, Comparison};

fn main() -> ExitCode {
    result_files::main("ygeo", Comparison { comparable, agree: |_: &Path, _: &Path| true })
}

/// The text without what the original leaves to chance.
fn comparable(file: &str, text: &str) -> String {
    let is_chance = |line: &str| {
        file.ends_with(".vtp") && line.contains("fluid pressure")
            || file.contains("_broken_joints_") && line.contains("Name='broken_")
    };
    let mut lines = Vec::new();
    let mut follows = false;
    for line in text.lines() {
        if follows && file.contains("_broken_joints_") {
            // zeros without their signs
            lines.push(line.replace("-0.000000000 ", "0.000000000 "));
        } else if !follows {
            lines.push(line.to_owned());
        }
        follows = is_chance(line);
    }
    lines.join("\n")
}
