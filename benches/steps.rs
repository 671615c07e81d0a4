//! Speed of whole steps and of single kernels.
//!
//! `cargo bench` prints times and throughput; items are triangle-steps for
//! scenes, evaluations for kernels.

#[path = "../tests/support/mod.rs"]
mod support;

use divan::{Bencher, black_box, counter::ItemsCount};
use support::{
    grid_deck::jointed_wall,
    scenes::{on_threads, reference_scene, scene, step},
};
use ypsilon::{
    contact::{Couple, Motion, Shape, SideForces, overlap},
    mechanics::{
        Vec2,
        joint2::{self, SplitRules},
        triangle::{Elasticity, ReferenceShape, StressLaw, cauchy_stress, nodal_forces},
    },
    scene::{CohesiveLaw, PairProperties, RockJoint, Scene},
};

fn main() {
    divan::main();
}

/// Steps of a scene that has settled a little.
fn bench_steps(bencher: Bencher<'_, '_>, scene: Scene, threads: usize) {
    let mut simulation = on_threads(&scene, threads);
    simulation.prepare().expect("the deck leaves room for its joints");
    (0..20).for_each(|_| step(&mut simulation));
    let triangles = simulation.triangles().count();
    bencher.counter(ItemsCount::new(triangles)).bench_local(|| step(&mut simulation));
}

#[divan::bench(args = ["j_wall", "k_arch_fr0.7", "n_wall_tension"])]
fn reference_case(bencher: Bencher<'_, '_>, case: &str) {
    bench_steps(bencher, reference_scene(case), 1);
}

/// Square jointed walls: cost per triangle against size and threads.
#[divan::bench(args = [(16, 1), (48, 1), (48, 2), (128, 1), (128, 2)])]
fn wall(bencher: Bencher<'_, '_>, (cells, threads): (usize, usize)) {
    bench_steps(bencher, scene(&jointed_wall(cells, cells, 1_000_000)), threads);
}

#[divan::bench]
fn triangle_kernel(bencher: Bencher<'_, '_>) {
    let law = StressLaw::NeoHookean(Elasticity {
        lame_lambda: 2e9,
        shear_modulus: 3e9,
        viscosity: 1e4,
        volumetric_share: 0.5,
    });
    let reference =
        ReferenceShape::new(&[Vec2::new(0.0, 0.0), Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)]);
    let corners = [Vec2::new(0.0, 0.0), Vec2::new(1.01, 0.002), Vec2::new(-0.003, 0.99)];
    let velocities = [Vec2::new(0.1, 0.0), Vec2::new(0.0, 0.2), Vec2::new(-0.3, 0.1)];
    bencher.counter(ItemsCount::new(1usize)).bench_local(|| {
        let (corners, velocities) = (black_box(&corners), black_box(&velocities));
        nodal_forces(&cauchy_stress(&law, &reference, corners, velocities), corners)
    });
}

#[divan::bench(args = [1e-4, 5e-3])]
fn joint_kernel(bencher: Bencher<'_, '_>, opening: f64) {
    let law = CohesiveLaw {
        is_cohesive: true,
        tensile_strength: 1e7,
        shear_strength: 1.5e7,
        fracture_energy: 1e4,
        shear_fracture_energy: 1e4,
        cohesion: 1.2e7,
        friction: 0.6,
        residual_friction: 0.0,
        penalty: 1e10,
        peak_strength: 1e7,
        rock: RockJoint::default(),
        layering: None,
    };
    let corners = [
        Vec2::new(0.0, opening),
        Vec2::new(2.0, 2.0 * opening),
        Vec2::new(2.001, 0.0),
        Vec2::new(0.0005, 0.0),
    ];
    bencher.counter(ItemsCount::new(1usize)).bench_local(|| {
        let mut strength = black_box(1.2e7);
        joint2::evaluate::<SplitRules>(&law, black_box(&corners), &mut strength, None)
    });
}

/// Two triangles that overlap, and two that lie clear of each other.
#[divan::bench(args = [0.3, -0.1])]
fn couple_kernel(bencher: Bencher<'_, '_>, depth: f64) {
    let shapes = [
        Shape::new([Vec2::new(0.0, 0.0), Vec2::new(2.0, 0.0), Vec2::new(0.0, 2.0)]),
        Shape::new([Vec2::new(0.5, -1.0), Vec2::new(1.5, -1.0), Vec2::new(0.9, depth)]),
    ];
    let pair = PairProperties { penalty: 1e6, tangential_penalty: 1e9, friction: 0.3 };
    let couple = Couple {
        shapes: [&shapes[0], &shapes[1]],
        motions: [&Motion::new([Vec2::zeros(); 3]), &Motion::new([Vec2::new(5.0, 1.0); 3])],
        pair: &pair,
        dt: 1e-4,
        drop_distance_squared: 1.0,
    };
    let (mut sliding, mut sides) = ([0.0; 6], [SideForces::default(); 2]);
    bencher
        .counter(ItemsCount::new(1usize))
        .bench_local(|| overlap(black_box(&couple), &mut &pair, &mut sliding, &mut sides));
}
