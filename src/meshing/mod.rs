//! Generators: decks made from a description of the structure and its loads.
//!
//! A [`Scenario`] (a TOML file, or flags of `ypsilon mesh`) names a kind of structure with its
//! parameters, loads in words and the times of the run. [`Scenario::generate`] makes from it
//! - a [`Model`]: nodes, triangles, materials, supports ([`kinds`], one file each),
//! - property sets such that neighbouring blocks differ ([`PropertySets`]),
//! - node sets with load-time tables ([`NodeSets`]) whose sum is checked against the loads,
//! - a time step from the stiffest mode ([`TimeStepBounds`]),
//!
//! and writes them as a deck of the split dialect with a header that says how to make it again.
//! Lengths are in metres, forces in newtons on one metre of depth.

mod colouring;
mod error;
mod flags;
mod generate;
pub mod kinds;
mod loads;
mod mesh;
mod model;
mod node_sets;
mod pattern;
mod picture;
mod properties;
mod property_sets;
mod scenario;
pub mod spatial;
mod stability;
mod tidy;
mod write_deck;

pub use error::MeshingError;
pub use flags::{Flag, flags, scenario_from_flags};
pub use generate::{AnyGenerated, Generated};
pub use loads::{Load, Side, Staging};
pub use mesh::{Mesh, Triangle};
pub use model::{Bond, Drive, History, Joints, Model, Motion, Substance, Support};
pub use node_sets::{LoadSum, NodeSet, NodeSets};
pub use pattern::Point;
pub use picture::{picture, picture_in_space};
pub use properties::{Joint, Material};
pub use property_sets::{PropertySet, PropertySets};
pub use scenario::{AnyKind, Kind, RunTimes, Scenario, SpatialKind, Watch};
pub use spatial::{SpatialGenerated, SpatialModel};
pub use stability::TimeStepBounds;
