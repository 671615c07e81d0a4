//! The masonry cases in their short variants: large blocks, loads that come and go fast.

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

macro_rules! cases {
    ($($test:ident: $name:literal;)*) => {
        $(#[test]
        fn $test() {
            check($name);
        })*

        #[test]
        fn no_case_of_these_groups_is_left_out() {
            use ypsilon_examples::Group::{Bridges, MasonryWall};
            let here = [$($name),*];
            for case in cases::all() {
                let is_here = here.contains(&case.name);
                assert_eq!(is_here, matches!(case.group, Bridges | MasonryWall), "{}", case.name);
            }
        }
    };
}

cases! {
    bridges_are_symmetric_under_self_weight: "self-weight";
    symmetry_needs_a_symmetric_mesh: "mesh-symmetry";
    a_point_load_arrives_at_the_ground: "point-load";
    a_distributed_load_arrives_at_the_ground: "distributed-load";
    deflection_and_arch_compression_under_the_train_grow_with_the_arch: "train";
    settling_supports_crack_the_ring_on_both_sides: "settlement";
    stresses_go_with_a_wave_of_load: "sine-load";
    the_weight_of_a_convoy_is_constant_and_bears_where_it_stands: "convoy";
    abrupt_loads_open_the_ring_at_key_and_flanks: "abrupt-load";
    the_shear_wall_is_linear_first: "tu-eindhoven";
}
