//! Coulomb friction of a couple of tetrahedra: an option, the original has none.
//!
//! A spring of stiffness kₜ·√A joins the two bodies where they press on each other, kₜ the tangential
//! penalty and A the area of contact: as in the plane, where the sliding counts times the length of
//! the edge. It is stretched by the motion along the surface and slips where its force would exceed
//! μ·N. A spring, unlike a law of the velocity, holds bodies at rest on a slope. It is let go when
//! the couple comes apart.

use super::{
    FACES, Slip, Vec3, dot,
    overlap3::FaceForce,
    potential::{OnFaces, Shape3},
    two_sided::FACTOR,
};
use crate::scene::PairProperties;

/// Where and how strongly a contactor presses on a target.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Contact {
    /// Unit vector from the target towards the contactor.
    pub normal: Vec3,
    /// Normal force, N.
    pub force: f64,
    /// Centre of pressure, m.
    pub centre: Vec3,
    /// Area of contact, m².
    pub area: f64,
}

/// The normal forces of a couple, summed up.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Pressure {
    /// On the contactor, N.
    sum: Vec3,
    /// Sizes of the forces, N, and these times where they act, N m.
    size: f64,
    moment: Vec3,
    double_area: f64,
}

impl Pressure {
    /// Adds the force on a face of a contactor with these corners, and twice the area on which it
    /// acts, m².
    #[inline(always)]
    pub fn add(&mut self, corners: &[Vec3; 4], force: &FaceForce, double_area: f64) {
        let mut size = 0.0;
        for (share, corner) in force.contactor.iter().zip(corners) {
            size += share;
            self.moment += corner * *share;
        }
        self.sum += force.normal * size;
        self.size += size;
        self.double_area += double_area;
    }

    /// Where and how strongly the contactor presses on the target, if it does.
    pub fn contact(&self) -> Option<Contact> {
        let force = dot(&self.sum, &self.sum).sqrt();
        (force > 0.0 && self.size > 0.0).then(|| Contact {
            normal: self.sum / force,
            force,
            centre: self.moment / self.size,
            // corners of a sliver may be in the wrong order, but for rounding
            area: (0.5 * self.double_area).max(0.0),
        })
    }
}

impl Contact {
    /// From the faces of the contactor in the target's potential, and the faces of the target in that
    /// of the contactor.
    pub fn new(
        [target, contactor]: [&Shape3; 2],
        [on_contactor, on_target]: [&OnFaces; 2],
        penalty: f64,
    ) -> Option<Self> {
        let mut sum = Vec3::zeros();
        let mut centre = Vec3::zeros();
        let mut weight = 0.0;
        let sides = [(on_contactor, contactor, -1.0), (on_target, target, 1.0)];
        let mut area = 0.0;
        for (pressed, body, sign) in sides {
            area += pressed.area;
            for i in 0..FACES.len() {
                let force = pressed.nodes[i] * sign;
                let size = dot(&force, &force).sqrt();
                sum += force;
                centre += body.corners[i] * size;
                weight += size;
            }
        }
        let size = dot(&sum, &sum).sqrt();
        (size > 0.0 && weight > 0.0).then(|| Self {
            normal: sum / size,
            force: FACTOR * penalty * size,
            centre: centre / weight,
            area,
        })
    }

    /// The friction on the contactor, N; takes the spring along. `sliding` is the velocity of the
    /// contactor relative to the target in the centre of pressure, m/s.
    pub fn friction(
        &self,
        slip: &mut Slip,
        sliding: &Vec3,
        pair: &PairProperties,
        dt: f64,
    ) -> Vec3 {
        let along = |v: Vec3| v - self.normal * dot(&v, &self.normal);
        // the spring turns with the surface
        let stretch = along(Vec3::from(*slip)) + along(*sliding) * dt;
        let stiffness = pair.tangential_penalty * self.area.sqrt();
        let force = stretch * -stiffness;
        let size = dot(&force, &force).sqrt();
        let limit = pair.friction * self.force;
        let share = if size > limit { limit / size } else { 1.0 };
        *slip = (stretch * share).into();
        force * share
    }
}

/// Velocity of a body in a point.
pub(super) fn velocity(body: &Shape3, velocities: &[Vec3; 4], point: &Vec3) -> (Vec3, [f64; 4]) {
    let shares = body.coordinates(point);
    let sum = (1..4).fold(velocities[0] * shares[0], |sum, i| sum + velocities[i] * shares[i]);
    (sum, shares)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::contact::spatial::samples::vector;
    use proptest::prelude::*;

    const PAIR: PairProperties =
        PairProperties { penalty: 1e6, tangential_penalty: 1e4, friction: 0.5 };

    /// Rounding can turn the corners of a sliver round.
    #[test]
    fn a_sliver_without_area_rubs_with_finite_force() {
        let corners = [[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]].map(Vec3::from);
        let force =
            FaceForce { normal: Vec3::z(), target: [0.0; 4], contactor: [0.1, 0.2, 0.3, 0.0] };
        let mut pressure = Pressure::default();
        pressure.add(&corners, &force, -1e-18);
        let contact = pressure.contact().expect("a force");
        assert!((contact.centre - Vec3::new(0.2, 0.3, 0.0) / 0.6).norm() < 1e-12);
        let mut slip = [0.0; 3];
        let friction = contact.friction(&mut slip, &Vec3::x(), &PAIR, 1e-3);
        assert!(friction.norm() <= 0.5 * 0.6 * (1.0 + 1e-12), "{friction}");
    }

    proptest! {
        /// Friction lies in the surface, within the cone, and never drives the sliding.
        #[test]
        fn friction_stays_within_coulombs_cone(
            normal in vector(),
            slides in proptest::collection::vec(vector(), 1..40),
            force in 0.0f64..100.0,
        ) {
            prop_assume!(normal.norm() > 0.1);
            let contact =
                Contact { normal: normal.normalize(), force, centre: Vec3::zeros(), area: 0.04 };
            let mut slip = [0.0; 3];
            for sliding in slides {
                let friction = contact.friction(&mut slip, &sliding, &PAIR, 1e-3);
                prop_assert!(friction.norm() <= 0.5 * force * (1.0 + 1e-12));
                prop_assert!(friction.dot(&contact.normal).abs() <= 1e-12 * friction.norm());
                prop_assert!(friction.dot(&Vec3::from(slip)) <= 0.0);
            }
        }
    }

    #[test]
    fn a_small_displacement_is_taken_back_elastically() {
        let contact =
            Contact { normal: Vec3::z(), force: 100.0, centre: Vec3::zeros(), area: 0.04 };
        let mut slip = [0.0; 3];
        let there = contact.friction(&mut slip, &Vec3::x(), &PAIR, 1e-3);
        // 1 mm on a spring of 10⁴·0.2 N/m
        assert!((there - Vec3::new(-2.0, 0.0, 0.0)).norm() < 1e-12);
        assert_eq!(contact.friction(&mut slip, &-Vec3::x(), &PAIR, 1e-3), Vec3::zeros());
    }

    #[test]
    fn a_sliding_body_feels_the_full_friction_against_its_motion() {
        let contact =
            Contact { normal: Vec3::z(), force: 100.0, centre: Vec3::zeros(), area: 0.04 };
        let mut slip = [0.0; 3];
        let mut friction = Vec3::zeros();
        for _ in 0..1000 {
            friction = contact.friction(&mut slip, &Vec3::new(0.6, 0.8, 0.0), &PAIR, 1e-3);
        }
        assert!((friction - Vec3::new(-30.0, -40.0, 0.0)).norm() < 1e-10, "{friction}");
    }
}
