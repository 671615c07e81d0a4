//! The values that a deck's items leave in the program, item after item.
//!
//! A deck is a little program: an array is sized by what its size keywords hold *at that moment*, a
//! size keyword of the split dialect makes arrays anew, a later item replaces an earlier one.
//! [`Database`] executes it.

mod apply;
mod field;
mod values;

pub use field::Field;
pub use values::Database;
