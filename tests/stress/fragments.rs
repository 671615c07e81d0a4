//! Bodies that fall into thousands of pieces, and blocks that lie against each other without a gap.

use super::motion::{Motion, step};
use crate::support::stability_scenes::{Body, Moving};
use ypsilon::scene::{PressedFaces, SpatialContact};

/// A body whose parts fly apart and turn, on weak joints and with friction.
fn bursting(body: Body, middle: f64) -> Moving {
    let d = body.dimension;
    let velocities = body.coordinates.chunks(d).flat_map(|x| {
        let r: Vec<f64> = x.iter().map(|x| x - middle).collect();
        // outwards, and around the last axis but one
        let mut v: Vec<f64> = r.iter().map(|r| 2e-3 * r).collect();
        v[0] -= 4e-3 * r[1];
        v[1] += 4e-3 * r[0];
        v
    });
    let spatial_contact = SpatialContact { pressed: PressedFaces::Both, has_friction: true };
    Body {
        velocities: velocities.collect(),
        joints: Some([1e5, 1.0]),
        fracture_energy: Some(1e-4),
        penalty: 1e5,
        friction: 0.5,
        spatial_contact,
        ..body
    }
    .simulation()
}

fn broken(moving: &Moving) -> usize {
    match moving {
        Moving::Plane(simulation) => simulation.failures().len(),
        Moving::Space(simulation) => simulation.failures().len(),
    }
}

#[test]
fn a_body_shatters_into_thousands_of_pieces() {
    for (name, mut moving, steps, joints) in [
        ("triangles", bursting(Body::rectangle([40, 40], 1.0, 0.2), 20.0), 1000, 4720),
        ("tetrahedra", bursting(Body::block([6, 6, 6], 1.0), 3.0), 400, 2376),
    ] {
        let limits = moving.limits();
        moving.run(0.2 * limits.impact_s.min(limits.critical_s), 0);
        let start = Motion::of(&moving);
        let mut most: f64 = 0.0;
        for _ in 0..steps {
            step(&mut moving);
            most = most.max(Motion::of(&moving).kinetic_energy());
        }
        let end = Motion::of(&moving);
        assert!(end.is_finite(), "{name}");
        // every triangle and every tetrahedron is on its own
        assert_eq!(broken(&moving), joints, "{name}");
        let change = (end.momentum() - start.momentum()).norm() / start.impetus();
        assert!(change < 1e-13, "{name}: {change:e} of the momentum");
        let about = start.centre();
        let turned = (end.angular_momentum(about) - start.angular_momentum(about)).norm()
            / start.spin(about);
        // tractions act across the opening of joints: a moment of second order
        assert!(turned < 1e-7, "{name}: {turned:e} of the angular momentum");
        // nothing moves faster for having broken: joints and friction take energy
        let energy = [most, end.kinetic_energy()].map(|e| e / start.kinetic_energy());
        assert!(energy[0] <= 1.0 + 1e-12 && energy[1] > 0.9, "{name}: {energy:?}");
    }
}

#[test]
fn blocks_without_gaps_stay_where_they_are() {
    for ratio in [1.0, 1e3, 1e6] {
        let mut plane = Body { penalty: ratio * 1e4, friction: 0.3, ..Body::new(2) };
        let mut space = Body { penalty: ratio * 1e4, ..Body::new(3) };
        for i in 0..6 {
            for j in 0..6 {
                plane.add_rectangle([0.1 * f64::from(i), 0.1 * f64::from(j)], [1, 1], 0.1, 0.0);
                let k = f64::from((i + j) % 3);
                space.add_block([0.1 * f64::from(i), 0.1 * f64::from(j), 0.1 * k], [1; 3], 0.1);
            }
        }
        for (name, body) in [("plane", plane), ("space", space)] {
            let mut moving = body.simulation();
            let limits = moving.limits();
            let start = Motion::of(&moving);
            moving.run(0.2 * limits.impact_s.min(limits.critical_s), 1000);
            let end = Motion::of(&moving);
            assert!(end.is_finite());
            let moved = start.places.iter().zip(&end.places).map(|(x, y)| (y - x).norm());
            // what rounding overlaps by, a part in 10¹⁶, is pushed apart
            let moved = moved.fold(0.0, f64::max);
            assert!(moved < 1e-14, "{name}, penalty of {ratio} E: {moved:e} m");
        }
    }
}
