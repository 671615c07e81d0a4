//! Leaving out couples that cannot touch changes no bit.

mod support;

use support::{
    grid_deck::jointed_wall,
    scenes::{bits, reference_scene, scene, step},
};
use ypsilon::{
    scene::Scene,
    simulation::{Simulation, SolverOptions},
};

/// Runs a scene with and without resting couples and compares every state.
/// Returns how many evaluations were spared.
fn compare(scene: &Scene, steps: u64) -> u64 {
    let simulate = |skip_separated_couples| {
        let options = SolverOptions { skip_separated_couples, ..SolverOptions::default() };
        let mut simulation = Simulation::with_options(scene.clone(), options);
        simulation.prepare().expect("the deck leaves room for its joints");
        simulation
    };
    let (mut skipping, mut thorough) = (simulate(true), simulate(false));
    for n in 0..steps {
        step(&mut skipping);
        step(&mut thorough);
        assert!(bits(&skipping) == bits(&thorough), "states differ after step {n}");
    }
    let work = |s: &Simulation| s.couple_work().expect("the scene has contact");
    assert_eq!(work(&thorough).rested, 0);
    work(&skipping).rested
}

#[test]
fn dry_wall_of_blocks() {
    assert!(compare(&reference_scene("j_wall"), 2000) > 0);
}

#[test]
fn arch_of_voussoirs() {
    assert!(compare(&reference_scene("k_arch_fr0.7"), 2000) > 0);
}

#[test]
fn tower_that_slides_and_falls_apart() {
    assert!(compare(&reference_scene("x_tower_slides"), 6000) > 0);
}

#[test]
fn sliding_block_detected_over_and_over() {
    let _ = compare(&reference_scene("d_slide_fr0.3"), 6000);
}

#[test]
fn wall_that_tears_along_its_joints() {
    assert!(compare(&reference_scene("n_wall_tension"), 3000) > 0);
}

#[test]
fn rigid_triangle_falls_on_a_block() {
    // nodes of rigid triangles move further than their velocities tell: no rest
    assert_eq!(compare(&reference_scene("x_rigid_drop"), 3000), 0);
}

#[test]
fn pushed_jointed_wall() {
    assert!(compare(&scene(&jointed_wall(12, 12, 1000)), 400) > 0);
}

#[test]
fn classic_walls_and_blocks() {
    for (case, steps) in [
        ("classic/j_wall_dry", 3000),
        ("classic/j_wall_jointed_mono", 3000),
        ("classic/c_contact_normal", 4000),
        ("classic/f_joint_shear_compression", 3000),
    ] {
        assert!(compare(&reference_scene(case), steps) > 0, "{case}");
    }
}
