//! The method at its extremes: conservation over a million steps, parameters over many orders,
//! degenerate overlaps, thousands of fragments, and what must not depend on axes, units and numbers.
//!
//! What is measured, and why the tolerances are what they are: `docs/src/robustness.md`.

#[path = "../support/mod.rs"]
mod support;

mod conservation;
mod extremes;
mod fragments;
mod invariance;
mod motion;
mod overlaps;
