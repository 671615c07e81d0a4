//! The readers as the tests of the program have them: there is one definition for both.

#[path = "../../tests/readers/mod.rs"]
pub mod readers;
