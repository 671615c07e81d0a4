//! The masonry shear wall of chapter 3.

mod pushed;
mod tu_eindhoven;

use crate::Case;

/// The cases of this group.
pub const CASES: &[&Case] = &[&tu_eindhoven::CASE];
