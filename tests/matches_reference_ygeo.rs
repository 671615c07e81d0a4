//! States of Y-Geo, bit for bit (see `support/dialect_cases.rs`).

mod support;

fn main() -> std::process::ExitCode {
    support::dialect_cases::main("ygeo")
}
