//! Structures of tetrahedra: the thesis's validations as printed, laws of contact, a wall.

mod contact_laws;
mod wall;

use super::validation::SOLIDS;
use crate::Case;

/// The cases of this group.
pub const CASES: &[&Case] = &{
    let mut cases = [&contact_laws::CASE; 11];
    let mut k = 0;
    while k < SOLIDS.len() {
        cases[k] = SOLIDS[k];
        k += 1;
    }
    cases[k] = &wall::CASE;
    cases
};
