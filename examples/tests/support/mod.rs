//! Short variants of cases as tests.

use ypsilon_examples::{Bench, Finding, Length, cases};

/// Runs a case and checks that every judged finding agrees.
pub fn check(name: &str) {
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

/// One test for each case, and one that no case of the groups is left out.
macro_rules! test_cases {
    ($groups:pat => $($test:ident: $name:literal;)*) => {
        $(#[test]
        fn $test() {
            support::check($name);
        })*

        #[test]
        fn no_case_of_these_groups_is_left_out() {
            use ypsilon_examples::{Group::*, cases};
            let here = [$($name),*];
            for case in cases::all() {
                let is_here = here.contains(&case.name);
                assert_eq!(is_here, matches!(case.group, $groups), "{}", case.name);
            }
        }
    };
}

pub(crate) use test_cases;
