//! Cases with published answers beyond the thesis.

mod arch;
mod arch_limit;
mod domino_theory;
mod dominoes;
mod incline;
mod rocking_block;

use crate::Case;

/// The cases of this group.
pub const CASES: &[&Case] = &[&arch::CASE, &rocking_block::CASE, &incline::CASE, &dominoes::CASE];
