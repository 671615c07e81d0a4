//! Results do not depend on the number of threads.

mod support;

use support::{
    grid_deck::jointed_wall,
    scenes::{bits, on_threads, reference_scene, scene, step},
};
use yformat::dialect::Dialect;
use ypsilon::{
    scene::Scene,
    simulation::{Simulation, joint_views},
};
use ypsilon_converters::dialects::convert_deck;

/// The wall is above every threshold from which threads are used.
#[test]
fn a_jointed_wall_moves_alike_on_1_2_3_and_8_threads() {
    moves_alike(&scene(&jointed_wall(96, 96, 1000)));
}

/// The same wall as a deck of Y-Geo and of the classic dialect.
#[test]
fn walls_of_the_other_dialects_move_alike() {
    for dialect in [Dialect::YGeo, Dialect::Classic] {
        let converted = convert_deck(&jointed_wall(96, 96, 1000), dialect).expect("a sound deck");
        moves_alike(&scene(&converted.deck));
    }
}

fn moves_alike(scene: &Scene) {
    let run = |threads| {
        let mut simulation = on_threads(scene, threads);
        simulation.prepare().expect("the deck leaves room for its joints");
        (0..25).for_each(|_| step(&mut simulation));
        let work = simulation.couple_work().expect("the scene has contact");
        assert!(work.most_couples > 1000, "{work:?}");
        assert!(simulation.triangles().count() > 16_384);
        assert!(joint_views(&simulation).count() > 16_384);
        bits(&simulation)
    };
    let alone = run(1);
    for threads in [2, 3, 8] {
        assert!(run(threads) == alone, "{threads} threads give other bits");
    }
    assert!(run(8) == alone, "a second run gives other bits");
}

/// Elements across borders of domains, with loads on their edges, joints that soften and break
/// and every dialect.
#[test]
fn scenes_move_alike_in_any_number_of_parts() {
    for (case, steps) in [
        ("i_pres_fac", 400),
        ("n_wall_tension", 3000),
        ("k_arch_fr0.7", 300),
        ("d_slide_fr0.3", 500),
        ("classic/j_wall_jointed_mono", 500),
        ("classic/e_joint_tension", 2900),
        ("ygeo/y_absorbing", 500),
        ("ygeo/y_planestress", 500),
        ("ygeo/j_wall_dry", 500),
    ] {
        let scene = reference_scene(case);
        let run = |parts| {
            let mut simulation = Simulation::new(scene.clone());
            simulation.prepare().expect("the deck leaves room for its joints");
            simulation.divide_into(parts);
            (0..steps).for_each(|_| step(&mut simulation));
            let stresses = simulation.stresses().iter().flat_map(|s| s.iter());
            let stresses: Vec<u64> = stresses.map(|s| s.to_bits()).collect();
            (bits(&simulation), stresses, simulation.failures().len())
        };
        let whole = run(1);
        for parts in [2, 3, 7] {
            assert!(run(parts) == whole, "{case} in {parts} parts gives other bits");
        }
    }
}
