//! Contact of tetrahedra (spec `y2d3d.md` E.4).
//!
//! Each face of the contactor (the higher element number of a couple) is cut
//! at the target: at the four sub-tetrahedra that each of the target's faces
//! spans with its centroid. The potential, 0 on the target's surface and 1 in
//! its centroid, is integrated over the piece inside, which gives a force along
//! the contactor's inward normal at the centre of pressure.
//!
//! Terms: `target` and `contactor` as above; a `Frame` is a contactor's face
//! with its axes; a `Section` the cut of a sub-tetrahedron with the plane of
//! that face; what both have in common is the `polygon` over which the
//! potential is integrated (`pressure`), and `shares` says what each node bears.

mod bodies;
mod clearance3;
mod common;
mod detection;
mod evaluation;
mod frame;
mod friction3;
mod interaction;
#[cfg(test)]
mod interaction_tests;
#[cfg(test)]
mod oracle;
mod overlap3;
#[cfg(test)]
mod overlap_tests;
mod pair_index;
mod polygon;
mod potential;
mod pressure;
#[cfg(test)]
mod samples;
mod section;
mod shares;
mod signs;
mod surfaces;
mod two_sided;
mod visits;

pub use bodies::{Contactor, Tetrahedron};
pub use frame::{FACES, Frame};
pub use interaction::{Contact3, ContactState3, Motion3};
pub use overlap3::FaceForce;

use nalgebra::Vector3;

/// A point or vector of space.
pub type Vec3 = Vector3<f64>;

/// What a couple has slid, m.
pub(crate) type Slip = [f64; 3];

/// A point of a face's plane.
pub(crate) type Point = [f64; 2];

/// Twice the area of the triangle `a`, `b`, `p`, positive if they are counter-clockwise.
#[inline(always)]
pub(crate) fn cross(a: Point, b: Point, p: Point) -> f64 {
    (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])
}

/// Scalar product, summed from x to z.
#[inline(always)]
pub(crate) fn dot(a: &Vec3, b: &Vec3) -> f64 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

/// Vector product.
#[inline(always)]
pub(crate) fn vector_product(a: &Vec3, b: &Vec3) -> Vec3 {
    Vec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x)
}
