use super::{
    FACES, Vec3,
    common::Common,
    potential::{Pressed, Shape3, press},
};

/// The original's factor on the penalty.
pub(super) const FACTOR: f64 = 6.0;

/// What two tetrahedra exert on each other if the faces of both are pressed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct TwoSided {
    /// Forces on the nodes of both, N.
    pub forces: [[Vec3; 4]; 2],
    /// Their energy, J.
    pub energy: f64,
    /// Faces of the second in the potential of the first, and of the first in that of the second.
    pub pressed: [Pressed; 2],
}

impl TwoSided {
    /// Of two tetrahedra with a penalty, Pa; none if they have nothing in common.
    ///
    /// The same bits come out whichever body is the first.
    pub fn new(bodies: [&Shape3; 2], penalty: f64) -> Option<Self> {
        let pressed = pressed_both(bodies)?;
        let stiffness = FACTOR * penalty;
        let mut forces = [[Vec3::zeros(); 4]; 2];
        let mut energy = 0.0;
        for owner in 0..2 {
            let (body, by) = (bodies[owner], &pressed[owner]);
            energy += stiffness * by.volume_integral;
            for i in 0..FACES.len() {
                let held = body.gradients[i] * (stiffness * by.volume_integral);
                let own = by.owner[i] * stiffness - held;
                forces[owner][i] = own - pressed[1 - owner].faces.nodes[i] * stiffness;
            }
        }
        Some(Self { forces, energy, pressed })
    }
}

/// The faces of the second of two bodies in the potential of the first, and of the first in that
/// of the second; none if they have nothing in common.
pub(super) fn pressed_both(bodies: [&Shape3; 2]) -> Option<[Pressed; 2]> {
    let [first, second] = bodies;
    if first.excludes(second) || second.excludes(first) {
        return None;
    }
    // rounding must not depend on which is the first of the couple: let their places decide
    if comes_before(second, first) {
        let bodies = [second, first];
        let [of_second, of_first] = press(bodies, &Common::of(bodies)?);
        Some([of_first, of_second])
    } else {
        Some(press(bodies, &Common::of(bodies)?))
    }
}

/// Whether a body comes before another in an order that only their corners decide about.
fn comes_before(one: &Shape3, other: &Shape3) -> bool {
    let coordinates = |body: &Shape3| body.corners.map(|x| [x.x, x.y, x.z]);
    coordinates(one) < coordinates(other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::spatial::samples::{in_one_plane, number, overlapping, vector};
    use proptest::prelude::*;

    fn exerted(corners: &[[Vec3; 4]; 2]) -> Option<TwoSided> {
        let [a, b] = corners.map(Shape3::new);
        TwoSided::new([&a, &b], 1.0)
    }

    fn energy(corners: &[[Vec3; 4]; 2]) -> f64 {
        exerted(corners).map_or(0.0, |both| both.energy)
    }

    proptest! {
        /// Whatever node moves in whatever direction.
        #[test]
        fn forces_are_the_gradient_of_the_energy(corners in overlapping()) {
            let step = 1e-5;
            let exerted = exerted(&corners);
            for t in 0..2 {
                for i in 0..4 {
                    for k in 0..3 {
                        let (mut before, mut after) = (corners, corners);
                        before[t][i][k] -= step;
                        after[t][i][k] += step;
                        let slope = (energy(&after) - energy(&before)) / (2.0 * step);
                        let force = exerted.map_or(0.0, |both| both.forces[t][i][k]);
                        prop_assert!((force + slope).abs() < 1e-6, "{} {}", force, -slope);
                    }
                }
            }
        }

        /// The same where faces lie in one plane and bodies share nodes, as those of a mesh do.
        #[test]
        fn forces_are_the_gradient_where_planes_coincide(corners in in_one_plane()) {
            let step = 1e-6;
            let exerted = exerted(&corners);
            for t in 0..2 {
                for i in 0..4 {
                    for k in 0..3 {
                        let (mut before, mut after) = (corners, corners);
                        before[t][i][k] -= step;
                        after[t][i][k] += step;
                        let slope = (energy(&after) - energy(&before)) / (2.0 * step);
                        let force = exerted.map_or(0.0, |both| both.forces[t][i][k]);
                        prop_assert!((force + slope).abs() < 1e-4, "{} {}", force, -slope);
                    }
                }
            }
        }

        /// The two bodies may change places: numbering decides about nothing.
        #[test]
        fn no_body_comes_first(corners in overlapping()) {
            let [a, b] = corners;
            match (exerted(&[a, b]), exerted(&[b, a])) {
                (Some(one), Some(other)) => {
                    prop_assert_eq!(one.forces, [other.forces[1], other.forces[0]]);
                }
                (one, other) => prop_assert_eq!(one, other),
            }
        }

        /// Nor does a node, but for rounding.
        #[test]
        fn no_node_comes_first(corners in in_one_plane()) {
            let turned = corners.map(|[a, b, c, d]| [b, d, c, a]);
            let forces = |corners| exerted(corners).map_or([[Vec3::zeros(); 4]; 2], |f| f.forces);
            let (here, there) = (forces(&corners), forces(&turned));
            for t in 0..2 {
                for (i, k) in [(0, 3), (1, 0), (2, 2), (3, 1)] {
                    let difference = here[t][i] - there[t][k];
                    prop_assert!(difference.norm() < 1e-11, "{difference}");
                }
            }
        }

        /// Newton's third law, for forces and for moments.
        #[test]
        fn forces_and_moments_balance(corners in overlapping(), far in vector(), scale in number()) {
            let moved = corners.map(|body| body.map(|x| x + far * (10.0 * scale)));
            let Some(both) = exerted(&moved) else { return Ok(()) };
            let (mut force, mut moment) = (Vec3::zeros(), Vec3::zeros());
            for (f, x) in both.forces.as_flattened().iter().zip(moved.as_flattened()) {
                force += f;
                moment += x.cross(f);
            }
            prop_assert!(force.norm() < 1e-12 && moment.norm() < 1e-10, "{force} {moment}");
        }
    }

    /// Two rigid tetrahedra fly at each other, deform nothing and part again as fast as they came.
    #[test]
    fn an_elastic_collision_conserves_energy() {
        let unit = [Vec3::zeros(), Vec3::x(), Vec3::y(), Vec3::z()];
        let tip = Vec3::new(0.2, 0.25, 0.3);
        let start = unit.map(|x| tip + Vec3::new(0.25, 0.25, 0.25) + x * 0.8);
        let (mass, dt) = (1.0, 1e-4);
        let (mut place, mut velocity) = (Vec3::zeros(), Vec3::new(-0.5, -0.4, -0.6));
        let at = |place: Vec3| [unit, start.map(|x| x + place)];
        let before = 0.5 * mass * velocity.norm_squared();
        let (mut deepest, mut worst) = (0.0f64, 0.0f64);
        for _ in 0..40_000 {
            let force = |place| {
                exerted(&at(place)).map_or(Vec3::zeros(), |both| both.forces[1].iter().sum())
            };
            velocity += force(place) * (0.5 * dt / mass);
            place += velocity * dt;
            velocity += force(place) * (0.5 * dt / mass);
            let stored = energy(&at(place));
            deepest = deepest.max(stored);
            worst = worst.max((stored + 0.5 * mass * velocity.norm_squared() - before).abs());
        }
        assert!(deepest > 0.1 * before, "they never touched");
        assert_eq!(energy(&at(place)), 0.0, "they did not part");
        assert!(worst < 1e-6 * before, "energy differs by {worst}");
    }
}
