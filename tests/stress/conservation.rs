//! Scenes that lose nothing keep their energy and momentum.
//!
//! Energy is that which the step keeps to rounding where forces are linear (`simulation/audit`): the
//! error of its balance is the error of the step for forces that are not.

use super::motion::{Conserved, conserved};
use crate::support::{
    dialect_scenes::free_cube_of_ten_nodes,
    stability_scenes::{Body, Moving},
};
use yformat::dialect::Dialect;
use ypsilon::{
    scene::{PressedFaces, SpatialContact},
    simulation::Simulation,
};

/// Two blocks that press on each other, with the viscosity gone that brought them to rest.
fn pressed_blocks() -> Moving {
    let mut body =
        Body { penalty: 1e5, viscosity: 4e3, load: -20.0, ..Body::rectangle([4, 2], 1.0, 0.0) };
    body.add_rectangle([0.7, 2.0], [2, 2], 1.0, 0.0);
    let mut moving = body.put(1, 0.0..=0.0).put(2, 4.0..=4.0).simulation();
    let limits = moving.limits();
    moving.run(0.3 * limits.critical_s.min(limits.impact_s), 60_000);
    let Moving::Plane(simulation) = &moving else { unreachable!() };
    let mut scene = simulation.scene().clone();
    scene.materials.iter_mut().for_each(|material| material.viscosity = 0.0);
    scene.nodes.velocity.iter_mut().for_each(|v| *v = nalgebra::Vector2::zeros());
    let mut simulation = Simulation::new(scene);
    simulation.prepare().expect("room");
    Moving::Plane(Box::new(simulation))
}

/// A plate that turns as a whole besides its vibrations.
fn spinning_plate() -> Moving {
    let mut moving = Body::rectangle([3, 3], 1.0, 0.2).simulation();
    moving.push(|_, x| [-1e-3 * (x[1] - 1.5), 1e-3 * (x[0] - 1.5), 0.0]);
    moving
}

/// Scenes without losses, and whether nothing from outside acts.
fn scenes() -> Vec<(&'static str, Moving, bool)> {
    let joints = Some([1e5, 1e3]);
    vec![
        ("plate, distorted", Body::rectangle([4, 4], 1.0, 0.3).simulation(), true),
        (
            "plate, ν = 0.49",
            Body { poisson: 0.49, ..Body::rectangle([4, 4], 1.0, 0.3) }.simulation(),
            true,
        ),
        (
            "plate on joints",
            Body { joints, ..Body::rectangle([2, 2], 1.0, 0.2) }.simulation(),
            true,
        ),
        ("plate that spins", spinning_plate(), true),
        ("blocks pressed together", pressed_blocks(), false),
        ("tetrahedra", Body::block([1, 1, 2], 1.0).simulation(), true),
        ("tetrahedra on joints", Body { joints, ..Body::block([1, 1, 1], 1.0) }.simulation(), true),
        (
            "classic: plate on joints",
            Body { joints, dialect: Dialect::Classic, ..Body::rectangle([2, 2], 1.0, 0.2) }
                .simulation(),
            true,
        ),
        (
            "Y-Geo: plate on joints",
            Body { joints, dialect: Dialect::YGeo, ..Body::rectangle([2, 2], 1.0, 0.2) }
                .simulation(),
            true,
        ),
        (".Y3D: tetrahedra of ten nodes", free_cube_of_ten_nodes(), true),
    ]
}

/// Speed of waves, m/s: a velocity by it is a strain.
fn wave_speed(name: &str) -> f64 {
    if name.starts_with(".Y3D") { 5e3 } else { 1.0 }
}

/// Vibrations at half the critical step.
fn vibrate(name: &str, moving: &Moving, strain: f64, steps: usize) -> Conserved {
    let mut moving = moving.clone();
    moving.disturb(strain * wave_speed(name));
    let dt = 0.5 * moving.limits().critical_s;
    conserved(&mut moving, dt, steps)
}

/// The error of the balance goes with the strain: it is what forces are not linear. It comes and goes
/// with the vibration; what stays of it is the drift.
fn check(name: &str, is_closed: bool, strain: f64, steps: usize, found: &Conserved) {
    let Conserved { worst, drift, momentum, angular, .. } = *found;
    assert!(worst < 0.1 * strain, "{name}, strain {strain}: {worst:e} of the energy");
    assert!(drift.abs() < 0.03 * strain, "{name}, strain {strain}: drift of {drift:e}");
    if is_closed {
        assert!(momentum < 1e-12, "{name}: {momentum:e} of the momentum");
        // tractions of joints act across their opening: a moment of second order, which may add up over the steps
        let of_joints = 1e-3 * strain * (steps as f64 / 3e3);
        let most = if name.contains("joints") { of_joints } else { 1e-12 };
        assert!(angular < most, "{name}: {angular:e} of the angular momentum");
    }
}

/// Strains at which a scene is looked at. What is pressed together by a strain of 1e-3 must not part.
fn strains(name: &str) -> &'static [f64] {
    if name.contains("pressed") { &[1e-5] } else { &[1e-3, 1e-5] }
}

#[test]
fn energy_and_momentum_are_kept() {
    for (name, moving, is_closed) in scenes() {
        for &strain in strains(name) {
            let steps = 3_000;
            check(name, is_closed, strain, steps, &vibrate(name, &moving, strain, steps));
        }
    }
}

/// Under 1e-6 of the largest energy at strains of 1e-5. `SCENES=Y-Geo` in the environment chooses scenes whose
/// names contain that.
#[test]
#[ignore = "half an hour: a million steps of each scene; prints the table of the manual"]
fn energy_and_momentum_are_kept_for_a_million_steps() {
    println!("| scene | strain | energy | drift | momentum | angular momentum |");
    println!("|---|---|---|---|---|---|");
    let chosen = std::env::var("SCENES").unwrap_or_default();
    for (name, moving, is_closed) in scenes().into_iter().filter(|scene| scene.0.contains(&chosen))
    {
        for &strain in strains(name) {
            let steps = 1_000_000;
            let found = vibrate(name, &moving, strain, steps);
            let Conserved { worst, drift, momentum, angular, .. } = found;
            println!(
                "| {name} | {strain:e} | {worst:.1e} | {drift:.1e} | {momentum:.1e} | {angular:.1e} |"
            );
            check(name, is_closed, strain, steps, &found);
        }
    }
}

/// Two bodies that meet at a hundredth of the speed of waves, where a penalty of ten times Young's
/// modulus parts them.
fn collision(dimension: usize) -> Moving {
    let spatial_contact = SpatialContact { pressed: PressedFaces::Both, has_friction: false };
    let mut body = Body { penalty: 1e5, spatial_contact, ..Body::new(dimension) };
    let half = if dimension == 2 {
        body.add_rectangle([0.0, 0.0], [2, 2], 1.0, 0.0);
        let half = body.sets.len();
        body.add_rectangle([0.3, 2.01], [2, 2], 1.0, 0.0);
        half
    } else {
        body.add_block([0.0; 3], [1, 1, 1], 1.0);
        let half = body.sets.len();
        body.add_block([0.3, 0.2, 1.01], [1, 1, 1], 1.0);
        half
    };
    for n in 0..body.sets.len() {
        let speed = if n < half { 1e-2 } else { -1e-2 };
        body.velocities.extend(&[0.0, 0.0, speed][3 - dimension..]);
    }
    body.simulation()
}

/// Contact forces begin and end with a kink, which a step passes over: energy after a collision is
/// off by what goes with the step, momentum by nothing.
#[test]
fn collisions_keep_energy_as_far_as_the_step_goes() {
    for (dimension, most) in [(2, [0.1, 0.02, 1e-3]), (3, [0.05, 2e-3, 1e-3])] {
        let start = collision(dimension);
        for (share, most) in [0.5, 0.2, 0.05].into_iter().zip(most) {
            let mut moving = start.clone();
            let dt = share * moving.limits().impact_s;
            let found = conserved(&mut moving, dt, (20.0 / dt) as usize);
            assert!(found.last.contact_stored.abs() < 0.1 * found.first.kinetic);
            assert!(found.gain().abs() < most, "{dimension}D, {share}: {:e}", found.gain());
            assert!(found.momentum < 1e-13 && found.angular < 1e-13, "{found:?}");
            if dimension == 2 {
                // in space what contacts store is what they have taken
                assert!(found.worst < most, "{share}: {:e}", found.worst);
            }
        }
    }
}

/// Blocks that rattle: contacts close and open again and again, and each time a step passes over the
/// kink. At half the limit that takes them for springs which act both ways they gain energy without end.
#[test]
#[ignore = "minutes; prints the table of the manual"]
fn rattling_blocks_gain_energy_at_long_steps() {
    let mut start = pressed_blocks();
    start.disturb(1e-3);
    let limits = start.limits();
    println!("| step by critical | by impact limit | steps | energy gained |\n|---|---|---|---|");
    for share in [0.5, 0.3, 0.2, 0.1, 0.05] {
        let mut moving = start.clone();
        let dt = share * limits.impact_s;
        let found = conserved(&mut moving, dt, 300_000);
        let critical = dt / limits.critical_s;
        println!(
            "| {critical:.2} | {share} | 300000 | {:.1e} {:.1e} |",
            found.worst,
            found.last.error / found.first.kinetic
        );
    }
}
