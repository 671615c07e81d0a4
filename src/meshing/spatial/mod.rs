//! Structures in space: tetrahedra in place of triangles, z upward, materials, motions, joints and
//! scenario files shared with those in the plane.

mod deck;
mod generate;
pub mod kinds;
mod mesh;
mod model;
mod property_sets;
mod stability;

pub use generate::SpatialGenerated;
pub use mesh::{Place, SpatialMesh, Tetrahedron};
pub use model::SpatialModel;
