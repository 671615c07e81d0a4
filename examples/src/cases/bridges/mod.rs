//! Chapter 4 of the thesis.

use crate::Case;

/// The cases of this group.
pub const CASES: &[&Case] = &[];
