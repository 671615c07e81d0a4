//! Cases with published answers beyond the thesis.

use crate::Case;

/// The cases of this group.
pub const CASES: &[&Case] = &[];
