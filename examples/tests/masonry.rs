//! The masonry cases in their short variants: large blocks, a twentieth of the time.

use ypsilon_examples::{Bench, Finding, Length, cases};

/// Runs a case and checks that every judged finding agrees.
fn check(name: &str) {
    let case = cases::find(name).expect("a case");
    let work = tempfile::tempdir().expect("a folder");
    let bench = Bench::new(case, work.path(), Length::Short);
    let outcome = (case.evaluate)(&bench).unwrap_or_else(|error| panic!("{name}: {error}"));
    let differing: Vec<&Finding> = outcome.findings.iter().filter(|f| !f.agrees()).collect();
    assert!(differing.is_empty(), "{name}: {differing:#?}");
    assert!(outcome.findings.iter().any(Finding::is_judged), "{name} judges nothing");
}

#[test]
fn bridges_are_symmetric_under_self_weight() {
    check("self-weight");
}

#[test]
fn symmetry_needs_a_symmetric_mesh() {
    check("mesh-symmetry");
}

#[test]
fn deflection_and_arch_compression_under_the_train_grow_with_the_arch() {
    check("train");
}

#[test]
fn settling_supports_crack_the_ring_on_both_sides() {
    check("settlement");
}

#[test]
fn abrupt_loads_open_joints_of_the_ring() {
    check("abrupt-load");
}

#[test]
fn the_weight_of_a_convoy_is_constant() {
    check("convoy");
}

#[test]
fn the_shear_wall_is_linear_first() {
    check("tu-eindhoven");
}
