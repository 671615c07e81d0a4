//! Tetrahedra for tests.

use super::{Vec3, dot, vector_product};
use proptest::prelude::*;

/// A number in [-1, 1] from a small integer, so that cases shrink well.
pub fn number() -> impl Strategy<Value = f64> {
    (-1000i32..=1000).prop_map(|n| f64::from(n) / 1000.0)
}

pub fn vector() -> impl Strategy<Value = Vec3> {
    (number(), number(), number()).prop_map(|(x, y, z)| Vec3::new(x, y, z))
}

/// Six times the volume.
pub fn volume(corners: &[Vec3; 4]) -> f64 {
    let [a, b, c, d] = corners;
    dot(&vector_product(&(b - a), &(c - a)), &(d - a))
}

/// A tetrahedron that is not flat, within the unit cube around the origin or nearly so.
pub fn tetrahedron() -> impl Strategy<Value = [Vec3; 4]> {
    [vector(), vector(), vector(), vector()]
        .prop_map(|mut corners| {
            if volume(&corners) < 0.0 {
                corners.swap(1, 2);
            }
            corners
        })
        .prop_filter("flat", |corners| volume(corners) > 0.2)
}

/// Two that most likely overlap.
pub fn overlapping() -> impl Strategy<Value = [[Vec3; 4]; 2]> {
    [tetrahedron(), tetrahedron()]
}

/// Two that are apart by some distance more often than not.
pub fn neighbours() -> impl Strategy<Value = [[Vec3; 4]; 2]> {
    (overlapping(), vector()).prop_map(|([a, b], apart)| [a, b.map(|x| x + apart * 2.5)])
}

/// Two that have a plane in common: a face of the second lies, but for rounding, in that of a face
/// of the first, or in the plane of one of its edges and its centroid. They may have nodes in
/// common and lie on either side of the plane.
pub fn in_one_plane() -> impl Strategy<Value = [[Vec3; 4]; 2]> {
    let weight = prop_oneof![Just(0.0), Just(1.0), number(), number().prop_map(f64::abs)];
    let place = [weight.clone(), weight];
    (tetrahedron(), 0usize..6, 0usize..3, [place.clone(), place.clone(), place], vector())
        .prop_map(|(first, plane, turn, places, apex)| {
            let centroid = first.iter().sum::<Vec3>() / 4.0;
            let [p, q, r] = if plane < 4 {
                [1, 2, 3].map(|k| first[(plane + k) % 4])
            } else {
                [first[turn], first[plane - 2], centroid]
            };
            let [a, b, c] = places.map(|[v, w]| p * v + q * w + r * (1.0 - v - w));
            let mut second = [a, b, c, apex];
            second.rotate_left(turn);
            if volume(&second) < 0.0 {
                second.swap(1, 2);
            }
            [first, second]
        })
        .prop_filter("flat", |[_, second]| volume(second) > 0.1)
}
