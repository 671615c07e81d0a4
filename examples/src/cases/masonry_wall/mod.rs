//! The masonry shear wall of chapter 3.

mod tu_eindhoven;

use crate::Case;

/// The cases of this group.
pub const CASES: &[&Case] = &[&tu_eindhoven::CASE];
