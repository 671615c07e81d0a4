//! Worked numbers and answers in closed form.

use super::{JointResponse, Points, evaluate, point_states, state};
use crate::{
    mechanics::Vec3,
    scene::{CohesiveLaw, RockJoint},
};
use proptest::prelude::*;

fn law() -> CohesiveLaw {
    CohesiveLaw {
        is_cohesive: true,
        tensile_strength: 1e7,
        shear_strength: 1.5e7,
        fracture_energy: 1e4,
        shear_fracture_energy: 1e4,
        cohesion: 0.0,
        friction: 0.0,
        residual_friction: 0.0,
        penalty: 1e10,
        peak_strength: 1e7,
        rock: RockJoint::default(),
        layering: None,
    }
}

/// Spec `y2d3d.md` J5.
const WORKED: [Vec3; 6] = [
    Vec3::new(0.0, 0.0, 0.004),
    Vec3::new(1.0, 0.0, 0.003),
    Vec3::new(0.0, 1.0, 0.006),
    Vec3::new(0.0005, 0.0, 0.0),
    Vec3::new(1.0005, 0.0, 0.0),
    Vec3::new(0.0, 1.0005, 0.0),
];

/// A triangle with legs of 1 m whose upper face is moved by `gap`.
fn moved(gap: Vec3) -> [Vec3; 6] {
    let corners = [Vec3::zeros(), Vec3::x(), Vec3::y()];
    std::array::from_fn(|i| if i < 3 { corners[i] + gap } else { corners[i - 3] })
}

fn close(found: f64, expected: f64, scale: f64) {
    assert!((found - expected).abs() <= 1e-12 * scale, "{found} against {expected}");
}

fn check(points: &Points, states: &[[f64; 6]], forces: [[f64; 3]; 3]) {
    let found = point_states(&law(), points, &WORKED);
    assert_eq!(found.len(), states.len());
    for (p, [opening, sliding, damage, left, normal, shear]) in found.iter().zip(states) {
        close(p.opening, *opening, 1.0);
        close(p.sliding, *sliding, 1.0);
        close(p.damage, *damage, 1.0);
        close(p.left, *left, 1.0);
        close(p.normal, *normal, 1e7);
        close(p.shear, *shear, 1e7);
    }
    let response = evaluate(&law(), points, &WORKED);
    assert!(!response.fails);
    for (found, expected) in response.pair_forces.iter().zip(forces) {
        for k in 0..3 {
            // the upper node loses what is tabulated with its sign
            close(-found[k], expected[k], 5e5);
        }
    }
}

#[test]
fn three_points_give_the_worked_numbers() {
    check(
        &Points::THREE,
        &[
            [
                0.00366653934521245,
                0.000426015527896586,
                0.41663472172378,
                0.372926618471361,
                3729266.18471361,
                1475921.52389754,
            ],
            [
                0.00516691331431484,
                0.000369242651503502,
                0.791728167112699,
                0.125640979733138,
                1256409.79733138,
                435370.187047482,
            ],
            [
                0.00416653903290016,
                0.00042616798798834,
                0.54163462802072,
                0.275197889116885,
                2751978.89116885,
                1089503.16826042,
            ],
        ],
        [
            [164585.78132971, 41358.0094533543, -444419.003986632],
            [196165.063868878, 47575.4656618515, -525889.648215143],
            [92048.4409395882, 56616.0095366216, -319705.411793491],
        ],
    );
}

#[test]
fn seven_points_give_the_worked_numbers() {
    check(
        &Points::SEVEN,
        &[
            [
                0.00433333056370915,
                0.000372710193726217,
                0.583332505510733,
                0.248430639154518,
                2484306.39154518,
                868409.185642065,
            ],
            [
                0.00488066772593157,
                0.00035280986330113,
                0.720166778962054,
                0.167402234264134,
                1674022.34264134,
                555882.596109883,
            ],
            [
                0.00364908217530203,
                0.000472693870479046,
                0.412270429791711,
                0.37706425997195,
                3770642.5997195,
                1641941.04379469,
            ],
            [
                0.00447024178989386,
                0.000352922311122792,
                0.617560307778434,
                0.227537616153582,
                2275376.16153582,
                755796.331495379,
            ],
            [
                0.00340496984796484,
                0.000453526225448174,
                0.351242355585922,
                0.44229638845537,
                4422963.8845537,
                1854306.25069381,
            ],
            [
                0.00549391195202423,
                0.000406750954050557,
                0.873477816321341,
                0.0770648619332203,
                770648.619332203,
                292211.861875596,
            ],
            [
                0.00410110989113839,
                0.000453800503605336,
                0.525277344624937,
                0.286252577661908,
                2862525.77661908,
                1200766.50933576,
            ],
        ],
        [
            [167742.049370717, 39933.1390501456, -448624.317746632],
            [200290.841610537, 46650.9699115488, -533396.224888057],
            [89709.2741980832, 57733.6481813229, -316210.487410238],
        ],
    );
}

/// Below the peak a joint that opens evenly carries (2r − r²) f_t, a third of it at each pair.
#[test]
fn even_opening_is_the_parabola() {
    let (law, opening) = (law(), 0.0008);
    // 2 f_t h / p with the shortest edge h = 1 m
    let ratio = opening / 0.002;
    let stress = (2.0 * ratio - ratio * ratio) * law.tensile_strength;
    for points in [Points::THREE, Points::SEVEN] {
        let response = evaluate(&law, &points, &moved(Vec3::z() * opening));
        for force in response.pair_forces {
            assert!((force.z / (stress * 0.5 / 3.0) - 1.0).abs() < 1e-8, "{}", force.z);
            assert!(force.x.abs() < 1e-6 && force.y.abs() < 1e-6);
        }
    }
}

/// Nothing is left beyond peak and softening extent, in opening and in sliding.
#[test]
fn a_joint_pulled_far_apart_fails() {
    for (gap, mode) in [(Vec3::z() * 0.1, 1.0), (Vec3::x() * 0.1, 2.0)] {
        for points in [Points::THREE, Points::SEVEN] {
            let JointResponse { pair_forces, fails } = evaluate(&law(), &points, &moved(gap));
            assert!(fails);
            assert!(pair_forces.iter().all(|f| f.norm() < 1e-6));
            let state = state(&law(), &points, &moved(gap));
            assert_eq!((state.damage, state.mode), (1.0, mode));
        }
    }
}

/// Pushed together it stays elastic: 2 o f_t / o_p = o p / h, whatever the overlap.
#[test]
fn overlap_is_answered_by_the_penalty() {
    let law = law();
    let response = evaluate(&law, &Points::THREE, &moved(Vec3::z() * -0.01));
    let total: f64 = response.pair_forces.iter().map(|f| f.z).sum();
    close(total, -0.01 * law.penalty * 0.5, 1e8);
    assert!(!response.fails);
}

proptest! {
    /// Which pair of nodes is first does not matter.
    #[test]
    fn turning_the_joint_turns_its_forces(gaps in prop::array::uniform9(-0.004..0.004)) {
        let mut corners = moved(Vec3::zeros());
        for (i, gap) in gaps.as_chunks::<3>().0.iter().enumerate() {
            corners[i] += Vec3::from(*gap);
        }
        let turned = [1, 2, 0, 4, 5, 3].map(|i: usize| corners[i]);
        let forces = evaluate(&law(), &Points::THREE, &corners).pair_forces;
        let again = evaluate(&law(), &Points::THREE, &turned).pair_forces;
        for (i, force) in forces.iter().enumerate() {
            prop_assert!((force - again[(i + 2) % 3]).norm() < 1e-3);
        }
    }
}

/// Law of the `.Y3D` lineage (spec `y3d.md` 7, part D).
fn mohr_coulomb() -> CohesiveLaw {
    CohesiveLaw {
        tensile_strength: 1e6,
        shear_strength: 3e6,
        fracture_energy: 50.0,
        shear_fracture_energy: 100.0,
        cohesion: 3e6,
        friction: 0.577,
        penalty: 2e10,
        peak_strength: 1e6,
        ..law()
    }
}

#[test]
fn mid_edges_give_the_worked_forces() {
    let mut opened = moved(Vec3::new(0.0, 0.0, 5e-5));
    opened[0] += Vec3::new(2e-5, 1e-5, 3e-5);
    let forces = [
        [28808.7407792587, 14403.9860057806, 136011.3903369363],
        [14404.1291148275, 7201.7517280974, 125143.366123501],
        [14404.1291148919, 7201.751728144, 125143.366123501],
    ];
    let found = evaluate(&mohr_coulomb(), &Points::MID_EDGES, &opened);
    for (found, expected) in found.pair_forces.iter().zip(forces) {
        (0..3).for_each(|k| close(found[k], expected[k], 1e8));
    }
    assert!(!found.fails);
}

/// Pressure raises the shear strength.
#[test]
fn mid_edges_under_pressure_give_the_worked_forces() {
    let pressed = moved(Vec3::new(4e-5, 0.0, -2e-5));
    let found = evaluate(&mohr_coulomb(), &Points::MID_EDGES, &pressed);
    for force in found.pair_forces {
        close(force.x, 110728.9280408608, 1e8);
        close(force.y, 0.0, 1e8);
        close(force.z, -58578.6437626905, 1e8);
    }
}

/// Two of three points decide.
#[test]
fn mid_edges_fail_when_two_have() {
    let mut torn = moved(Vec3::zeros());
    let end = 1e-3;
    torn[0].z += end;
    // two edges meet in the torn corner
    assert!(evaluate(&mohr_coulomb(), &Points::MID_EDGES, &torn).fails);
    let mut half = moved(Vec3::zeros());
    (half[0].z, half[1].z) = (3.5e-4, 3.5e-4);
    // the edge between them has lost its strength, the others have not
    assert!(!evaluate(&mohr_coulomb(), &Points::MID_EDGES, &half).fails);
}
