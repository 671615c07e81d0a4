//! Restart decks: all that the program remembers, as a deck.

mod model;
mod reader;
mod rows;
mod writer;

pub use model::{Contact, Control, Elements, Nodes, RestartDeck};
pub use rows::{HistoryState, JointState, PropertySet};
pub use writer::MassCount;
