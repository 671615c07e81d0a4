//! Worked numbers and answers in closed form.

use super::{
    ReferenceShape, SolidLaw, Volumetric, cauchy_stress, nodal_forces, sixfold_volume,
    strain_energy,
};
use crate::mechanics::{Vec3, triangle::Elasticity};
use nalgebra::{Matrix3, Rotation3};
use proptest::prelude::*;

const UNIT: [Vec3; 4] = [
    Vec3::new(0.0, 0.0, 0.0),
    Vec3::new(1.0, 0.0, 0.0),
    Vec3::new(0.0, 1.0, 0.0),
    Vec3::new(0.0, 0.0, 1.0),
];

const LAW: SolidLaw = SolidLaw {
    elasticity: Elasticity {
        lame_lambda: 2e9,
        shear_modulus: 3e9,
        viscosity: 1e4,
        volumetric_share: 0.5,
    },
    volumetric: Volumetric::Difference,
};

fn close(found: f64, expected: f64, scale: f64) {
    assert!((found - expected).abs() <= 1e-13 * scale, "{found} against {expected}");
}

fn deformed(by: &Matrix3<f64>) -> [Vec3; 4] {
    UNIT.map(|x| by * x)
}

/// Spec `y2d3d.md` J4.
#[test]
fn stress_and_forces_are_the_worked_ones() {
    let corners = [
        Vec3::new(0.0, 0.0, 0.0),
        Vec3::new(1.01, 0.002, 0.001),
        Vec3::new(-0.003, 0.99, 0.0),
        Vec3::new(0.0, 0.004, 1.02),
    ];
    let velocities = [
        Vec3::new(0.1, 0.0, 0.0),
        Vec3::new(0.0, 0.2, 0.0),
        Vec3::new(-0.3, 0.1, 0.4),
        Vec3::new(0.0, 0.0, 1.0),
    ];
    let reference = ReferenceShape::new(&UNIT);
    let (stress, volume) = cauchy_stress(&LAW, &reference, &corners, &velocities);
    let worked = Matrix3::new(
        98568471.3501275,
        -2795412.94533152,
        2970376.41797595,
        -2795412.94533152,
        -19055295.5050206,
        12009029.3361187,
        2970376.41797595,
        12009029.3361187,
        158267204.876554,
    );
    for (found, expected) in stress.iter().zip(worked.iter()) {
        close(*found, *expected, 158e6);
    }
    close(volume, sixfold_volume(&corners), 1.0);
    close(reference.nodal_mass(2400.0), 100.0, 100.0);
    let forces = [
        [16550975.9031243, -1757354.43996051, 28834990.0696196],
        [-16587642.1268715, 480210.217465528, -505722.42169702],
        [515420.024113003, 3278931.74117224, -1954375.80466354],
        [-478753.800365812, -2001787.51867725, -26374891.843259],
    ];
    for (found, expected) in nodal_forces(&stress, &corners).iter().zip(forces) {
        for k in 0..3 {
            close(found[k], expected[k], 29e6);
        }
    }
}

/// Simple shear γ keeps the volume: T_xx = μγ², T_xy = μγ, all others are zero.
#[test]
fn simple_shear_gives_its_two_stresses() {
    let shear = 0.2;
    let by = Matrix3::new(1.0, shear, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0);
    let reference = ReferenceShape::new(&UNIT);
    let (stress, _) = cauchy_stress(&LAW, &reference, &deformed(&by), &[Vec3::zeros(); 4]);
    let mu = LAW.elasticity.shear_modulus;
    let mut expected = Matrix3::zeros();
    expected[(0, 0)] = mu * shear * shear;
    expected[(0, 1)] = mu * shear;
    expected[(1, 0)] = mu * shear;
    for (found, expected) in stress.iter().zip(expected.iter()) {
        close(*found, *expected, mu);
    }
}

/// A tetrahedron that swells by J in volume is under (λ/2)(J − 1/J) where it has no shear modulus.
#[test]
fn swelling_gives_the_volumetric_stress() {
    let law = SolidLaw { elasticity: Elasticity { shear_modulus: 0.0, ..LAW.elasticity }, ..LAW };
    let reference = ReferenceShape::new(&UNIT);
    for (ratio, expected) in [(1.1_f64, 0.095_454_545_454_545_45), (0.9, -0.105_555_555_555_555_6)]
    {
        let by = Matrix3::identity() * ratio.cbrt();
        let (stress, _) = cauchy_stress(&law, &reference, &deformed(&by), &[Vec3::zeros(); 4]);
        for k in 0..3 {
            let lambda = law.elasticity.lame_lambda;
            close(stress[(k, k)], expected * lambda, lambda);
        }
    }
}

prop_compose! {
    fn stretch()(entries in prop::array::uniform9(-0.2..0.2)) -> Matrix3<f64> {
        Matrix3::identity() + Matrix3::from_row_slice(&entries)
    }
}

fn elastic(volumetric: Volumetric) -> SolidLaw {
    SolidLaw { elasticity: Elasticity { viscosity: 0.0, ..LAW.elasticity }, volumetric }
}

const BOTH: [Volumetric; 2] = [Volumetric::Difference, Volumetric::Logarithm];

fn forces_of(corners: &[Vec3; 4]) -> [Vec3; 4] {
    forces_under(&elastic(Volumetric::Difference), corners)
}

fn forces_under(law: &SolidLaw, corners: &[Vec3; 4]) -> [Vec3; 4] {
    let reference = ReferenceShape::new(&UNIT);
    let (stress, _) = cauchy_stress(law, &reference, corners, &[Vec3::zeros(); 4]);
    nodal_forces(&stress, corners)
}

proptest! {
    /// Forces of a body without loads have no resultant and no moment.
    #[test]
    fn forces_are_in_equilibrium(by in stretch()) {
        let corners = deformed(&by);
        let forces = forces_of(&corners);
        let resultant: Vec3 = forces.iter().sum();
        let moment: Vec3 = corners.iter().zip(&forces).map(|(x, f)| x.cross(f)).sum();
        prop_assert!(resultant.norm() < 1e-5 && moment.norm() < 1e-5, "{resultant} {moment}");
    }

    /// A rotated body has rotated forces.
    #[test]
    fn forces_turn_with_the_body(by in stretch(), angles in prop::array::uniform3(-3.0..3.0)) {
        let [a, b, c] = angles;
        let turn = Rotation3::from_euler_angles(a, b, c);
        let still = forces_of(&deformed(&by));
        let turned = forces_of(&deformed(&by).map(|x| turn * x));
        for (f, g) in still.iter().zip(&turned) {
            prop_assert!((turn * f - g).norm() < 1e-4);
        }
    }

    /// Forces are minus the gradient of the strain energy.
    #[test]
    fn forces_are_those_of_the_energy(by in stretch(), node in 0..4_usize, axis in 0..3_usize) {
        let reference = ReferenceShape::new(&UNIT);
        let corners = deformed(&by);
        for law in BOTH.map(elastic) {
            let energy = |by: f64| {
                let mut moved = corners;
                moved[node][axis] += by;
                strain_energy(&law, &reference, &moved)
            };
            let step = 1e-5;
            let slope = (energy(step) - energy(-step)) / (2.0 * step);
            let force = forces_under(&law, &corners)[node][axis];
            let scale = law.elasticity.shear_modulus;
            prop_assert!((slope + force).abs() < 1e-5 * scale, "{slope} {force}");
        }
    }
}

/// Spec `y3d.md` 7, part A: the law of the `.Y3D` lineage, with and without viscosity.
#[test]
fn the_logarithmic_law_gives_the_worked_stress_and_forces() {
    let initial = [
        Vec3::zeros(),
        Vec3::new(1.0, 0.0, 0.0),
        Vec3::new(0.2, 1.1, 0.0),
        Vec3::new(0.1, 0.3, 0.9),
    ];
    let by = Matrix3::new(1.02, 0.03, -0.01, 0.0, 0.97, 0.02, 0.015, -0.005, 1.01);
    let corners = initial.map(|x| by * x + Vec3::new(0.5, -0.2, 0.1));
    let velocities = [
        Vec3::new(0.1, 0.0, 0.0),
        Vec3::new(0.0, 0.2, 0.0),
        Vec3::new(0.0, 0.0, -0.3),
        Vec3::new(0.05, 0.05, 0.05),
    ];
    let law = |viscosity| SolidLaw {
        elasticity: Elasticity {
            lame_lambda: 4e8,
            shear_modulus: 4e8,
            viscosity,
            volumetric_share: 0.5,
        },
        volumetric: Volumetric::Logarithm,
    };
    let reference = ReferenceShape::new(&initial);
    close(reference.nodal_mass(2500.0), 103.125, 1e3);
    let (stress, _) = cauchy_stress(&law(0.0), &reference, &corners, &velocities);
    let worked = [
        16387525.770670328,
        11565198.55675125,
        2020908.3983250365,
        -23670480.30305979,
        6142761.171146468,
        7963739.278642425,
    ];
    let upper = [(0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)];
    for (at, expected) in upper.into_iter().zip(worked) {
        close(stress[at], expected, 1e9);
    }
    let (stress, _) = cauchy_stress(&law(2e5), &reference, &corners, &velocities);
    let forces = [
        [4246851.831584601, -222660.1511193477, 2035749.0594611822],
        [-2219831.561019196, -2687911.7516547046, -59173.4568036189],
        [-1692723.7815241276, 3965613.0563321984, -525729.8895498936],
        [-334296.4890412767, -1055041.1535581464, -1450845.7131076697],
    ];
    for (found, expected) in nodal_forces(&stress, &corners).iter().zip(forces) {
        for k in 0..3 {
            close(found[k], expected[k], 1e9);
        }
    }
}
