//! d3plot families as Y writes them: binary results that LS-PrePost opens.
//!
//! A family is one or more files of little-endian 4-byte words. The first file begins with a
//! [`ControlBlock`] of 64 words and the [`Geometry`] (initial coordinates and connectivity);
//! then come the states, one record each. When a file holds its share of states
//! ([`states_per_file`]), the marker [`END_OF_FILE_MARKER`] closes it and the next file
//! (`name01`, `name02`, ...) begins with a state at once. The last file has no marker.
//!
//! [`FamilyWriter`] streams states out of a running computation, [`FamilyReader`] gives them
//! back in any order. What a file holds is single precision; the writer takes `f64` and rounds.
//!
//! ```
//! use yformat::d3plot::{
//!     ControlBlock, Counts, FamilyReader, FamilyWriter, Geometry, NodeVectors, Shell,
//!     StartDate, StateView, Stresses, Title, states_per_file,
//! };
//!
//! # let folder = std::env::temp_dir().join(format!("yformat-doc-{}", std::process::id()));
//! # std::fs::create_dir_all(&folder)?;
//! let path = folder.join("triangle");
//! let date = StartDate { day: 27, month: 7, year: 2021 };
//! let counts = Counts { nodes: 3, elements: 1, properties: 1 };
//! let control = ControlBlock::two_dimensional(Title::new("triangle", date), counts)?;
//! let geometry = Geometry {
//!     coordinates: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
//!     shells: vec![Shell::triangle([0, 1, 2], 1)],
//!     ..Geometry::default()
//! };
//! let mut writer = FamilyWriter::create(&path, control, &geometry, states_per_file(3, 1))?;
//! writer.write_state(&StateView {
//!     time: 0.5,
//!     kinetic_energy: 2.0,
//!     coordinates: NodeVectors::Plane(&[[0.0, 0.0], [1.0, 0.0], [0.0, 1.5]]),
//!     velocities: NodeVectors::Zero,
//!     accelerations: NodeVectors::Zero,
//!     stresses: Stresses::Plane(&[[1.0e5, -2.0e5, 3.0e4]]),
//!     deletion_table: &[1.0],
//! })?;
//! writer.finish()?;
//!
//! let mut reader = FamilyReader::open(&path)?;
//! let state = reader.state(0)?;
//! assert_eq!(state.time, 0.5);
//! assert_eq!(state.shell_data[..2], [1.0e5, -2.0e5]);
//! # std::fs::remove_dir_all(&folder)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod blocks;
mod control;
mod decode;
mod encode;
mod error;
mod family;
mod geometry;
mod layout;
mod reader;
mod state;
mod title;
mod writer;

pub use control::{ControlBlock, Counts};
pub use error::{ReadError, WriteError};
pub use family::{END_OF_FILE_MARKER, member_path, states_per_file};
pub use geometry::{Geometry, Shell, Solid};
pub use layout::StateLayout;
pub use reader::{FamilyReader, Notice};
pub use state::{NodeVectors, State, StateView, Stresses};
pub use title::{StartDate, Title};
pub use writer::{FamilyMark, FamilyWriter, Finished};
