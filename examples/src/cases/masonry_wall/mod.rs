//! The wall of TU Eindhoven.

use crate::Case;

/// The cases of this group.
pub const CASES: &[&Case] = &[];
