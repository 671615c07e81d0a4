//! Parameters over as many orders as anybody may use, at steps from `stability::Limits`.

use super::motion::{Conserved, conserved};
use crate::support::stability_scenes::{Body, YOUNG};

/// Vibrates at half the critical step and keeps its energy to 1e-6, momentum to rounding. The error
/// has two parts: forces are not linear, which goes with the strain, and stresses of stiff parts are
/// rounded, which goes against it.
fn vibrates(name: &str, body: &Body, strain: f64) -> Conserved {
    let mut moving = body.simulation();
    moving.disturb(strain);
    let dt = 0.5 * moving.limits().critical_s;
    let found = conserved(&mut moving, dt, 3_000);
    assert!(found.worst < 1e-6, "{name}: {:e} of the energy", found.worst);
    assert!(found.momentum < 1e-13, "{name}: {:e} of the momentum", found.momentum);
    // to and fro
    assert!(found.last.strain > 0.05 * found.first.kinetic, "{name}: {found:?}");
    found
}

#[test]
fn poisson_ratios_up_to_the_incompressible() {
    for poisson in [0.0, 0.3, 0.49, 0.4999, 0.499_999] {
        for body in [Body::rectangle([3, 3], 1.0, 0.3), Body::block([1, 1, 2], 1.0)] {
            let name = format!("ν = {poisson}, {}D", body.dimension);
            let found = vibrates(&name, &Body { poisson, ..body }, 3e-6);
            assert!(found.angular < 1e-13, "{name}: {found:?}");
        }
    }
}

#[test]
fn elements_a_thousand_times_as_long_as_wide() {
    for aspect in [10.0, 100.0, 1000.0] {
        for dimension in [2, 3] {
            for axis in 0..dimension {
                let mut body = match dimension {
                    2 => Body::rectangle([3, 3], 1.0, 0.0),
                    _ => Body::block([1, 2, 1], 1.0),
                };
                for x in body.coordinates.iter_mut().skip(axis).step_by(dimension) {
                    *x *= aspect;
                }
                let name = format!("{aspect} times as long, {dimension}D, axis {axis}");
                let found = vibrates(&name, &body, 3e-6);
                assert!(found.angular < 1e-13, "{name}: {found:?}");
            }
        }
    }
}

#[test]
fn joint_penalties_of_nine_orders() {
    for ratio in [1e-3, 1e-1, 10.0, 1e3, 1e6] {
        let joints = Some([ratio * YOUNG, 1e3]);
        for body in [Body::rectangle([2, 2], 1.0, 0.2), Body::block([1, 1, 1], 1.0)] {
            let name = format!("joints of {ratio} E, {}D", body.dimension);
            let found = vibrates(&name, &Body { joints, ..body }, 1e-5);
            // tractions act across the opening: a moment of second order
            assert!(found.angular < 1e-8, "{name}: {found:?}");
        }
    }
}

/// Blocks that lie against each other and are driven into each other: soft ones pass through each
/// other, hard ones rebound many times.
#[test]
fn contact_penalties_of_nine_orders() {
    for ratio in [1e-3, 1e-1, 10.0, 1e3, 1e6] {
        let mut body = Body { penalty: ratio * YOUNG, ..Body::rectangle([2, 2], 1.0, 0.0) };
        body.add_rectangle([0.3, 2.0], [2, 2], 1.0, 0.0);
        for n in 0..18 {
            body.velocities.extend([0.0, if n < 9 { 1e-3 } else { -1e-3 }]);
        }
        let mut moving = body.simulation();
        let dt = 0.2 * moving.limits().impact_s;
        let found = conserved(&mut moving, dt, 10_000);
        assert!(found.worst < 0.02, "penalty of {ratio} E: {:e}", found.worst);
        assert!(found.momentum < 1e-13 && found.angular < 1e-13, "{ratio}: {found:?}");
        assert!(found.last.strain > 0.0, "{ratio}: they have not touched");
    }
}

/// What stays of the error over a million steps where one stiffness is a million times the other.
#[test]
#[ignore = "minutes: a million steps; prints the table of the manual"]
fn extremes_for_a_million_steps() {
    let mut long = Body::rectangle([3, 3], 1.0, 0.0);
    long.coordinates.iter_mut().step_by(2).for_each(|x| *x *= 1000.0);
    let plate = Body::rectangle([3, 3], 1.0, 0.3);
    for (name, body) in [
        ("ν = 0.4999", Body { poisson: 0.4999, ..plate.clone() }),
        ("ν = 0.499999", Body { poisson: 0.499_999, ..plate }),
        ("1000 times as long as wide", long),
        (
            "joints of 1e6 E",
            Body { joints: Some([1e6 * YOUNG, 1e3]), ..Body::rectangle([2, 2], 1.0, 0.2) },
        ),
    ] {
        for strain in [1e-5, 1e-4, 1e-3] {
            let mut moving = body.simulation();
            moving.disturb(strain);
            let dt = 0.5 * moving.limits().critical_s;
            let Conserved { worst, drift, momentum, angular, .. } =
                conserved(&mut moving, dt, 1_000_000);
            println!(
                "| {name} | {strain:e} | {worst:.1e} | {drift:.1e} | {momentum:.1e} | {angular:.1e} |"
            );
            assert!(worst < 1e-3);
        }
    }
}
