use super::{
    Contactor, FaceForce, Tetrahedron, Vec3,
    clearance3::{ALL_PAIRS, Asked},
    oracle,
    overlap3::overlap_in,
    samples::{neighbours, overlapping, vector},
};
use crate::lanes::{self, Kernel, Lanes};
use proptest::prelude::*;

/// Forces of the couple of a target and a contactor.
fn exerted([target, contactor]: &[[Vec3; 4]; 2], active: u16, penalty: f64) -> Vec<FaceForce> {
    let mut forces = Vec::new();
    let (target, contactor) = (Tetrahedron::new(*target), Contactor::new(contactor));
    let exert = |force| forces.push(force);
    lanes::run(Couple { target: &target, contactor: &contactor, active, penalty, exert });
    forces
}

/// A couple to be evaluated in lanes.
struct Couple<'a, F> {
    target: &'a Tetrahedron,
    contactor: &'a Contactor,
    active: u16,
    penalty: f64,
    exert: F,
}

impl<F: FnMut(FaceForce)> Kernel for Couple<'_, F> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(mut self) {
        let exert = |force, _| (self.exert)(force);
        overlap_in::<L>(self.target, self.contactor, self.active, self.penalty, exert);
    }
}

/// Sums over the nodes 0 to 3 of the target and 4 to 7 of the contactor.
fn on_nodes(forces: &[FaceForce]) -> [Vec3; 8] {
    let mut sum = [Vec3::zeros(); 8];
    forces.iter().for_each(|force| force.scatter(&[0, 1, 2, 3], &[4, 5, 6, 7], &mut sum));
    sum
}

fn worked_couple() -> [[Vec3; 4]; 2] {
    [
        [[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 2.0]],
        [[0.2, 0.2, -0.9], [1.2, 0.3, -0.95], [0.25, 1.2, -0.93], [0.35, 0.37, 0.3]],
    ]
    .map(|body| body.map(Vec3::from))
}

/// Spec `y2d3d.md` J6.
#[test]
fn worked_numbers_of_the_description() {
    let forces = exerted(&worked_couple(), ALL_PAIRS, 1e6);
    let expected = [
        [32636.5099489686, 30072.0305890097, 21327.0015151696],
        [-31886.9321173872, -749.57783158119, 6802.53763050266],
        [-749.577831581163, -29322.4527574285, 7159.97304944973],
        [0.0, 0.0, 0.0],
        [2466.43902439023, 2569.39024390244, -672.301829268291],
        [-2645.34146341464, 141.585365853659, -1806.76097560976],
        [282.073170731699, -2650.60975609756, -1811.55562165378],
        [-103.170731707416, -60.3658536585281, -30998.8937685901],
    ];
    for (force, expected) in on_nodes(&forces).iter().zip(expected) {
        assert!((force - Vec3::from(expected)).norm() < 1e-8, "{force} {expected:?}");
    }
    // the target's first face against the contactor's second
    let first = &forces[0];
    let normal = [-0.63606742422968, -0.662617408384514, -0.395419273606649];
    assert!((first.normal - Vec3::from(normal)).norm() < 1e-14);
    let shares = [0.0, 3722.53219268724, 3783.06117143012, 54536.6098473366];
    for (share, expected) in first.contactor.iter().zip(shares) {
        assert!((share - expected).abs() < 1e-8, "{:?}", first.contactor);
    }
    let shares = [52156.9053573704, 4765.27437662175, 5120.02347746186, 0.0];
    for (share, expected) in first.target.iter().zip(shares) {
        assert!((share - expected).abs() < 1e-8, "{:?}", first.target);
    }
}

/// By how much forces may differ that are computed another way. The law passes over what reaches less
/// than its tolerance of 1e-10 into the other body, whatever the area: rounding decides which side of
/// it a corner is on, and a force of 1e-10 times penalty and area comes or goes (both are at most
/// about 1 here).
fn unevenness(forces: &[Vec3; 8]) -> f64 {
    let largest = forces.iter().map(|f| f.norm()).fold(0.0, f64::max);
    1e-5 * largest + 1e-9
}

/// The sum over the target's nodes.
fn on_target(forces: &[Vec3; 8]) -> Vec3 {
    forces[..4].iter().sum()
}

/// Some nodes of the contactor become nodes of the target.
fn shared(corners: [[Vec3; 4]; 2], count: usize) -> ([[u32; 4]; 2], [[Vec3; 4]; 2]) {
    let (mut nodes, mut corners) = ([[0, 1, 2, 3], [4, 5, 6, 7]], corners);
    for k in 0..count {
        nodes[1][k] = k as u32;
        corners[1][k] = corners[0][k];
    }
    (nodes, corners)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(4000))]

    /// Bit for bit, also with nodes in common.
    #[test]
    fn lanes_give_what_the_description_gives(corners in neighbours(), count in 0usize..4) {
        let (_, corners) = shared(corners, count);
        let expected = oracle::overlap(&Tetrahedron::new(corners[0]), &corners[1], 1e6);
        let found = exerted(&corners, ALL_PAIRS, 1e6);
        // a number that is none is equal to itself here
        prop_assert_eq!(format!("{found:?}"), format!("{expected:?}"));
    }

    /// Whatever the nodes do within the clearance, the pairs of faces left out exert nothing.
    #[test]
    fn nothing_happens_within_the_clearance(
        corners in neighbours(),
        count in 0usize..4,
        moves in proptest::collection::vec(vector(), 8),
        horizon in 0.0f64..0.02,
    ) {
        let (nodes, corners) = shared(corners, count);
        let bodies = corners.map(Tetrahedron::new);
        let faces = corners.map(|corners| Contactor::new(&corners));
        let clearance = Asked {
            nodes: [&nodes[0], &nodes[1]],
            bodies: [&bodies[0], &bodies[1]],
            faces: [&faces[0], &faces[1]],
        }
        .clearance(horizon);
        for share in [0.0, 0.5, 1.0] {
            let moved = [0, 1].map(|t| {
                std::array::from_fn(|i| {
                    // a unit move is at most √3 long
                    let step = clearance.free * share / 3f64.sqrt();
                    corners[t][i] + moves[nodes[t][i] as usize] * step
                })
            });
            let all = exerted(&moved, ALL_PAIRS, 1e6);
            let some = exerted(&moved, clearance.active, 1e6);
            prop_assert_eq!(format!("{some:?}"), format!("{all:?}"), "{:?}", clearance);
        }
    }

    /// Newton's third law for forces; that for moments holds where the target's face is not seen
    /// from the side.
    #[test]
    fn forces_add_up_to_nothing(corners in overlapping()) {
        let sum = on_nodes(&exerted(&corners, ALL_PAIRS, 1.0));
        let largest = sum.iter().map(|f| f.norm()).fold(0.0, f64::max);
        let total: Vec3 = sum.iter().sum();
        prop_assert!(total.norm() <= 1e-9 * largest.max(1e-9), "{total} of {largest}");
    }

    /// Both bodies moved together exert the same but for rounding. What each node of the target bears
    /// is left to rounding where a face is seen from the side, not their sum.
    #[test]
    fn the_place_does_not_matter(corners in overlapping(), far in vector()) {
        let here = on_nodes(&exerted(&corners, ALL_PAIRS, 1.0));
        let moved = corners.map(|body| body.map(|x| x + far * 8.0));
        let there = on_nodes(&exerted(&moved, ALL_PAIRS, 1.0));
        let uneven = unevenness(&here);
        for i in 4..8 {
            prop_assert!((here[i] - there[i]).norm() < uneven, "{i}: {here:?} {there:?}");
        }
        prop_assert!((on_target(&here) - on_target(&there)).norm() < uneven);
    }

    /// A contactor renumbered without turning it inside out feels the same. What each node of the
    /// target bears depends on the numbering where a face is seen from the side, not their sum.
    #[test]
    fn numbering_of_the_contactors_nodes_does_not_matter_to_it(corners in overlapping()) {
        let here = on_nodes(&exerted(&corners, ALL_PAIRS, 1.0));
        let [target, [a, b, c, d]] = corners;
        let renumbered = on_nodes(&exerted(&[target, [b, c, a, d]], ALL_PAIRS, 1.0));
        let uneven = unevenness(&here);
        for (i, k) in [(4, 6), (5, 4), (6, 5), (7, 7)] {
            prop_assert!((here[i] - renumbered[k]).norm() < uneven);
        }
        prop_assert!((on_target(&here) - on_target(&renumbered)).norm() < uneven);
    }

    #[test]
    fn bodies_apart_exert_nothing(corners in overlapping(), direction in vector()) {
        prop_assume!(direction.norm() > 0.1);
        let [target, contactor] = corners;
        let away = direction.normalize() * 4.0;
        prop_assert!(exerted(&[target, contactor.map(|x| x + away)], ALL_PAIRS, 1e6).is_empty());
    }
}
