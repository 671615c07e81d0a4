//! Kernels: one file per element kind, state in, force out.
//!
//! The order of every operation is part of the contract: it is that of spec
//! `y2d3d.md` (sections C, D and H), without fused multiply-add and without
//! reassociation, so that states equal the original's bit for bit.

pub mod aperture;
pub mod edge_load;
pub mod face_load;
pub mod joint2;
pub mod joint3;
pub mod rigid_triangle;
pub mod softening;
pub mod softening_triangle;
pub mod tetrahedron;
pub mod tetrahedron10;
pub mod triangle;

use nalgebra::{Vector2, Vector3};

/// A point or vector of the plane.
pub type Vec2 = Vector2<f64>;

/// A point or vector in space.
pub type Vec3 = Vector3<f64>;
