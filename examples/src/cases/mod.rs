//! The cases, by group.

pub mod bridges;
pub mod classical;
pub mod masonry_wall;
pub mod solids;
pub mod validation;

use crate::Case;

/// All cases, in the order of the report.
#[must_use]
pub fn all() -> Vec<&'static Case> {
    let groups =
        [validation::CASES, solids::CASES, masonry_wall::CASES, bridges::CASES, classical::CASES];
    groups.into_iter().flatten().copied().collect()
}

/// The case with a name.
#[must_use]
pub fn find(name: &str) -> Option<&'static Case> {
    all().into_iter().find(|case| case.name == name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::collections::BTreeSet;

    #[test]
    fn every_case_has_a_name_of_its_own_and_a_folder() {
        let cases = all();
        let names: BTreeSet<&str> = cases.iter().map(|case| case.name).collect();
        assert_eq!(names.len(), cases.len());
        for case in cases {
            assert!(case.folder().is_dir(), "{} is missing", case.folder().display());
        }
    }
}
