//! Files that the classic dialect writes beside its snapshots: restart decks, the mesh for GiD and
//! the log of contact forces.
//!
//! Everything goes from plain data to the bytes of the original. Histories are in
//! [`history`](crate::history), snapshots in [`ym`](crate::ym). (outputs.md 3)
//!
//! ```
//! use yformat::classic_output::{MassCount, RestartDeck};
//!
//! let text = "/YD/YDC/MCSTEP 100 /YD/YDC/NCSTEP 50 /YD/YDE/MELNO 3 $YDOIT\n";
//! let (restart, notes) = RestartDeck::parse("a.y", text)?;
//! assert_eq!((restart.control.next_step, notes.len()), (50, 0));
//! let mut text = Vec::new();
//! restart.write_to(&mut text, MassCount::Correct)?;
//! assert!(text.starts_with(b"     /*   Control   */\n/YD/YDC/MCSTEP      100\n"));
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod contact_forces;
mod error;
mod gid_mesh;
mod history_point;
mod names;
mod restart;
mod table;
mod text;

pub use contact_forces::ContactForceSums;
pub use error::RestartError;
pub use gid_mesh::GidMesh;
pub use history_point::write_history_point;
pub use names::OutputNames;
pub use restart::{
    Contact, Control, Elements, HistoryState, JointState, MassCount, Nodes, PropertySet,
    RestartDeck,
};
pub use table::Table;
