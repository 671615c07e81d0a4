//! The `ypsilon` program.

use std::process::ExitCode;

fn main() -> ExitCode {
    ypsilon::cli::main()
}
