//! Worked numbers, patch test, equilibrium.

use super::{EDGES, NODES, ReferenceShape, Response, STABLE_SHARE, evaluate};
use crate::mechanics::{
    Vec3,
    tetrahedron::{self, SolidLaw, Volumetric},
    triangle::Elasticity,
};
use nalgebra::{Matrix3, Rotation3};
use proptest::prelude::*;

/// E = 1 GPa, ν = 0.25.
const LAW: SolidLaw = SolidLaw {
    elasticity: Elasticity {
        lame_lambda: 4e8,
        shear_modulus: 4e8,
        viscosity: 0.0,
        volumetric_share: 0.5,
    },
    volumetric: Volumetric::Logarithm,
};

const STILL: [Vec3; NODES] = [Vec3::new(0.0, 0.0, 0.0); NODES];

/// With nodes in the middle of straight edges.
fn straight(corners: [Vec3; 4]) -> [Vec3; NODES] {
    std::array::from_fn(|i| match i.checked_sub(4) {
        None => corners[i],
        Some(edge) => {
            let [a, b] = EDGES[edge];
            (corners[a] + corners[b]) / 2.0
        }
    })
}

fn unit() -> [Vec3; NODES] {
    straight([Vec3::zeros(), Vec3::x(), Vec3::y(), Vec3::z()])
}

fn stretched() -> Matrix3<f64> {
    Matrix3::new(1.02, 0.03, -0.01, 0.0, 0.97, 0.02, 0.015, -0.005, 1.01)
}

fn deformed(initial: &[Vec3; NODES], current: &[Vec3; NODES]) -> Response {
    evaluate(&LAW, &ReferenceShape::new(initial), current, &STILL)
}

fn close(found: f64, expected: f64, scale: f64) {
    assert!((found - expected).abs() <= 1e-13 * scale, "{found} against {expected}");
}

/// Spec `y3d.md` 7, part B.
#[test]
fn forces_of_a_bent_element_are_the_worked_ones() {
    let mut current = unit().map(|x| stretched() * x);
    current[5] += Vec3::new(0.02, -0.01, 0.015);
    current[7] += Vec3::new(0.0, 0.01, 0.02);
    let worked = [
        [-1133943.103445074, 422940.0991650511, 2078250.3642887687],
        [169887.6846110059, -1085825.6220270153, -43934.7788799871],
        [537469.1924364454, 212209.7893335633, -73706.6998340117],
        [971582.4649985507, 1524577.016855714, 1068335.7143983536],
        [4081944.4584073145, -4446343.944289866, 3216889.0709134527],
        [-9179110.259927444, 5499427.005557891, -2431149.519466168],
        [6404197.75151327, 2150487.6293396866, 925002.5680598954],
        [6118695.262701815, -6883755.531985376, -4298805.4650370525],
        [-5736709.568919837, -2949422.9967580256, -660704.3090758482],
        [-2234013.8823760473, 5555706.5548083745, 219823.0546325967],
    ];
    for (found, expected) in deformed(&unit(), &current).forces.iter().zip(worked) {
        for k in 0..3 {
            close(found[k], expected[k], 1e10);
        }
    }
}

/// Spec `y3d.md` 2.4: the shares of the mass to ten digits.
#[test]
fn nodes_bear_the_worked_shares_of_the_mass() {
    let masses = ReferenceShape::new(&unit()).nodal_masses(2500.0);
    let mass = 2500.0 / 6.0;
    for (i, found) in masses.into_iter().enumerate() {
        let expected = if i < 4 { 0.0269054549 } else { 0.1487296967 };
        assert!((found / mass - expected).abs() < 5e-11, "{i}: {}", found / mass);
    }
    close(masses.iter().sum(), mass, 1e3);
}

prop_compose! {
    fn tetrahedron()(moves in prop::array::uniform12(-0.15..0.15)) -> [Vec3; NODES] {
        let corners = [Vec3::zeros(), Vec3::x(), Vec3::y(), Vec3::z()];
        straight(std::array::from_fn(|i| {
            corners[i] + Vec3::new(moves[3 * i], moves[3 * i + 1], moves[3 * i + 2])
        }))
    }
}

prop_compose! {
    fn stretch()(entries in prop::array::uniform9(-0.2..0.2)) -> Matrix3<f64> {
        Matrix3::identity() + Matrix3::from_row_slice(&entries)
    }
}

proptest! {
    /// Under a uniform deformation the stress is that of the four-node element, and the corners
    /// bear nothing.
    #[test]
    fn a_patch_of_constant_strain_has_constant_stress(initial in tetrahedron(), by in stretch()) {
        let current = initial.map(|x| by * x);
        let found = deformed(&initial, &current);
        let four = |nodes: &[Vec3; NODES]| [0, 1, 2, 3].map(|i| nodes[i]);
        let shape = tetrahedron::ReferenceShape::new(&four(&initial));
        let (stress, volume) =
            tetrahedron::cauchy_stress(&LAW, &shape, &four(&current), &[Vec3::zeros(); 4]);
        prop_assert!((found.stress - stress).norm() < 1e-5, "{}", found.stress - stress);
        prop_assert!((found.least_jacobian - volume).abs() < 1e-12);
        for force in &found.forces[..4] {
            prop_assert!(force.norm() < 1e-5, "{force}");
        }
        // the forces do the work of the stress: Σ f ⊗ x = −V T
        let virial = found.forces.iter().zip(&current).fold(Matrix3::zeros(), |sum, (f, x)| {
            sum + f * x.transpose()
        });
        prop_assert!((virial + stress * (volume / 6.0)).norm() < 1e-5);
    }

    /// Neither displacement nor rotation gives a force.
    #[test]
    fn a_rigid_motion_gives_no_force(
        initial in tetrahedron(),
        angles in prop::array::uniform3(-3.0..3.0),
        shift in prop::array::uniform3(-2.0..2.0),
    ) {
        let [a, b, c] = angles;
        let turn = Rotation3::from_euler_angles(a, b, c);
        let current = initial.map(|x| turn * x + Vec3::from(shift));
        let found = deformed(&initial, &current);
        for force in found.forces {
            prop_assert!(force.norm() < 1e-5, "{force}");
        }
    }

    /// Forces of any shape have no resultant and no moment.
    #[test]
    fn forces_are_in_equilibrium(
        initial in tetrahedron(),
        moves in proptest::collection::vec(-0.03..0.03, 3 * NODES),
    ) {
        let current = std::array::from_fn(|i| {
            initial[i] + Vec3::new(moves[3 * i], moves[3 * i + 1], moves[3 * i + 2])
        });
        let found = deformed(&initial, &current);
        let resultant: Vec3 = found.forces.iter().sum();
        let moment: Vec3 = current.iter().zip(&found.forces).map(|(x, f)| x.cross(f)).sum();
        prop_assert!(resultant.norm() < 1e-5 && moment.norm() < 1e-5, "{resultant} {moment}");
    }

    /// Spinning is no straining; stretching at the rate D is resisted by ηD.
    #[test]
    fn viscosity_resists_straining_alone(
        initial in tetrahedron(),
        entries in prop::array::uniform9(-1.0..1.0),
    ) {
        let law = SolidLaw {
            elasticity: Elasticity {
                lame_lambda: 0.0,
                shear_modulus: 0.0,
                viscosity: 2.0,
                volumetric_share: 0.5,
            },
            volumetric: Volumetric::Logarithm,
        };
        let by = Matrix3::from_row_slice(&entries);
        let velocities = initial.map(|x| by * x);
        let found = evaluate(&law, &ReferenceShape::new(&initial), &initial, &velocities);
        prop_assert!((found.stress - (by + by.transpose())).norm() < 1e-12);
    }
}

/// Highest frequency of an element that swings freely, 1/s, density 1 kg/m³.
fn highest_frequency(law: &SolidLaw, nodes: &[Vec3; NODES]) -> f64 {
    let shape = ReferenceShape::new(nodes);
    let masses = shape.nodal_masses(1.0);
    let mut mode: [Vec3; NODES] =
        std::array::from_fn(|i| Vec3::new((i as f64).sin(), (1.7 * i as f64).cos(), 0.3));
    let mut squared = 0.0;
    for _ in 0..400 {
        let step = 1e-7;
        let moved = |by: f64| {
            let now = std::array::from_fn(|i| nodes[i] + mode[i] * by);
            evaluate(law, &shape, &now, &STILL).forces
        };
        let (before, after) = (moved(-step), moved(step));
        mode = std::array::from_fn(|i| (before[i] - after[i]) / (2.0 * step * masses[i]));
        squared = mode.iter().map(Vec3::norm_squared).sum::<f64>().sqrt();
        mode = mode.map(|m| m / squared);
    }
    squared.sqrt()
}

#[test]
fn steps_below_the_stated_share_are_stable() {
    let regular = [
        Vec3::new(1.0, 1.0, 1.0),
        Vec3::new(1.0, -1.0, -1.0),
        Vec3::new(-1.0, -1.0, 1.0),
        Vec3::new(-1.0, 1.0, -1.0),
    ];
    let corner = [Vec3::zeros(), Vec3::x(), Vec3::y(), Vec3::z()];
    let path = [Vec3::zeros(), Vec3::x(), Vec3::new(1.0, 1.0, 0.0), Vec3::new(1.0, 1.0, 1.0)];
    let flat = [Vec3::zeros(), Vec3::x(), Vec3::y(), Vec3::new(0.3, 0.3, 0.1)];
    let slim = [Vec3::zeros(), Vec3::x(), Vec3::y() * 0.2, Vec3::z() * 0.2];
    let mut least = f64::INFINITY;
    for corners in [regular, corner, path, flat, slim] {
        for poisson in [0.0, 0.3, 0.49, 0.4999] {
            let law = SolidLaw {
                elasticity: Elasticity {
                    lame_lambda: poisson / ((1.0 + poisson) * (1.0 - 2.0 * poisson)),
                    shear_modulus: 0.5 / (1.0 + poisson),
                    viscosity: 0.0,
                    volumetric_share: 0.5,
                },
                volumetric: Volumetric::Logarithm,
            };
            let area = |[a, b, c]: [usize; 3]| {
                (corners[b] - corners[a]).cross(&(corners[c] - corners[a])).norm()
            };
            let faces = [[0, 1, 2], [0, 1, 3], [0, 2, 3], [1, 2, 3]].map(area);
            let volume = tetrahedron::sixfold_volume(&corners).abs();
            let height = volume / faces.into_iter().fold(0.0, f64::max);
            let speed = (law.elasticity.lame_lambda + 2.0 * law.elasticity.shear_modulus).sqrt();
            let nodes = straight(corners);
            let stable = 2.0 / highest_frequency(&law, &nodes) * speed / height;
            least = least.min(stable);
            assert!(stable > STABLE_SHARE, "ν = {poisson}, {corners:?}: {stable}");
        }
    }
    assert!(least < 1.6 * STABLE_SHARE, "the share could be larger: {least}");
}

/// The price of one condition on the volume: an element on its own does not resist what changes
/// the size of its parts but not their shape, as long as its middle keeps its volume. In a mesh
/// its neighbours do.
#[test]
fn an_element_alone_does_not_resist_a_conformal_bending() {
    let initial = unit();
    let middle = Vec3::new(0.25, 0.25, 0.25);
    let strained = |amount: f64| {
        // strain = amount (a·x) I
        let along = Vec3::new(0.6, -0.5, 0.3);
        initial.map(|x| {
            let r = x - middle;
            x + (r * along.dot(&r) - along * (0.5 * r.norm_squared())) * amount
        })
    };
    let force = |amount: f64| {
        let forces = deformed(&initial, &strained(amount)).forces;
        forces.iter().map(Vec3::norm).fold(0.0, f64::max)
    };
    // of second order, where the stiffness is of the order of 1e8 N/m
    assert!(force(1e-5) < 1e-2, "{}", force(1e-5));
    assert!(force(1e-2) < 1e4, "{}", force(1e-2));
}
