//! Chapter 3 of the thesis but for its wall, in plane form.

use crate::Case;

/// The cases of this group.
pub const CASES: &[&Case] = &[];
