//! Cases with analytic and published answers, in their short variants.

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
    for figure in &outcome.pictures {
        assert!(bench.work().join(&figure.file).is_file(), "{name}: {} is missing", figure.file);
    }
}

macro_rules! cases {
    ($($test:ident: $name:literal;)*) => {
        $(#[test]
        fn $test() {
            check($name);
        })*

        #[test]
        fn no_case_of_these_groups_is_left_out() {
            use ypsilon_examples::Group::{Classical, Validation};
            let here = [$($name),*];
            for case in cases::all() {
                let is_here = here.contains(&case.name);
                assert_eq!(is_here, matches!(case.group, Validation | Classical), "{}", case.name);
            }
        }
    };
}

cases! {
    simple_shear: "simple-shear";
    uniaxial: "uniaxial";
    pressure: "pressure";
    rotation: "rotation";
    two_bars: "two-bars";
    one_bar: "one-bar";
    sliding_block: "sliding-block";
    inelastic_impact: "inelastic-impact";
    elastic_impact: "elastic-impact";
    damping: "damping";
    semicircular_arch: "semicircular-arch";
    rocking_block: "rocking-block";
    incline: "incline";
    dominoes: "dominoes";
}
