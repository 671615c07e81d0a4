//! Strain energies that keep their digits where strains are small.
//!
//! The formulas of `mechanics` subtract numbers near 1, which leaves of a strain of 1e-6 four digits
//! of its energy. Here the displacement gradient H comes from displacements, the Green strain is
//! E = ½ (H + Hᵀ + Hᵀ H), and with e = J² − 1 = det(I + 2 E) − 1 the terms of first order are gone
//! before anything is rounded: tr B − n − 2 ln J = 2 tr E − ln(1 + e) = (e − ln(1 + e)) − (e − 2 tr E).
//! Turning makes H large, but not E.

use crate::mechanics::{
    Vec2, Vec3,
    tetrahedron::{self, SolidLaw, Volumetric},
    triangle::{self, StressLaw},
};
use nalgebra::{Matrix2, Matrix3};

/// e − ln(1 + e).
fn excess(d: f64) -> f64 {
    if d.abs() > 0.02 {
        return d - d.ln_1p();
    }
    // the series to 1e-17 of its first term
    let mut sum = 0.0;
    for k in (2..=11).rev() {
        sum = 1.0 / f64::from(k) - d * sum;
    }
    d * d * sum
}

/// Strain energy of an elastic triangle, J/m. `places` are the undeformed and the present corners.
pub(super) fn of_triangle(
    law: &StressLaw,
    reference: &triangle::ReferenceShape,
    [initial, current]: [&[Vec2; 3]; 2],
) -> f64 {
    let StressLaw::NeoHookean(elasticity) = law else {
        return triangle::strain_energy(law, reference, current);
    };
    let moved = [0, 1, 2].map(|i| current[i] - initial[i]);
    let edges = Matrix2::from_columns(&[moved[1] - moved[0], moved[2] - moved[0]]);
    let h = edges * reference.inverse_edges;
    let strain = (h + h.transpose() + h.transpose() * h) * 0.5;
    let beyond = 4.0 * strain.determinant();
    let e = 2.0 * strain.trace() + beyond;
    let shear = 0.5 * elasticity.shear_modulus * (excess(e) - beyond);
    let volumetric = 0.5 * elasticity.volumetric_share * elasticity.lame_lambda * excess(e);
    0.5 * reference.double_area * (shear + volumetric)
}

/// Strain energy of a tetrahedron, J.
pub(in crate::simulation) fn of_tetrahedron(
    SolidLaw { elasticity, volumetric }: &SolidLaw,
    reference: &tetrahedron::ReferenceShape,
    [initial, current]: [&[Vec3; 4]; 2],
) -> f64 {
    let moved = [0, 1, 2, 3].map(|i| current[i] - initial[i]);
    let edges =
        Matrix3::from_columns(&[moved[1] - moved[0], moved[2] - moved[0], moved[3] - moved[0]]);
    let h = edges * reference.inverse_edges;
    let strain = (h + h.transpose() + h.transpose() * h) * 0.5;
    let minor =
        |i: usize, j: usize| strain[(i, i)] * strain[(j, j)] - strain[(i, j)] * strain[(j, i)];
    let minors = minor(0, 1) + minor(1, 2) + minor(2, 0);
    let beyond = 4.0 * minors + 8.0 * strain.determinant();
    let e = 2.0 * strain.trace() + beyond;
    let shear = 0.5 * elasticity.shear_modulus * (excess(e) - beyond);
    let pressed = match volumetric {
        Volumetric::Difference => {
            0.5 * elasticity.volumetric_share * elasticity.lame_lambda * excess(e)
        }
        Volumetric::Logarithm => 0.125 * elasticity.lame_lambda * e.ln_1p().powi(2),
    };
    reference.sixfold_volume / 6.0 * (shear + pressed)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::triangle::Elasticity;

    #[test]
    fn energies_are_those_of_the_plain_formulas() {
        let elasticity = Elasticity {
            lame_lambda: 2e9,
            shear_modulus: 3e9,
            viscosity: 0.0,
            volumetric_share: 0.5,
        };
        let initial = [Vec2::new(0.0, 0.0), Vec2::new(1.0, 0.1), Vec2::new(0.2, 0.9)];
        let current = [Vec2::new(0.01, 0.0), Vec2::new(1.2, 0.0), Vec2::new(0.1, 1.0)];
        let reference = triangle::ReferenceShape::new(&initial);
        let law = StressLaw::NeoHookean(elasticity);
        let plain = triangle::strain_energy(&law, &reference, &current);
        let found = of_triangle(&law, &reference, [&initial, &current]);
        assert!((found / plain - 1.0).abs() < 1e-13, "{found} {plain}");

        let initial =
            [Vec3::zeros(), Vec3::x(), Vec3::new(0.1, 0.9, 0.0), Vec3::new(0.2, 0.3, 0.8)];
        let current = initial.map(|p| p + Vec3::new(0.03 * p.y, -0.05 * p.x * p.x, 0.1 * p.z));
        let reference = tetrahedron::ReferenceShape::new(&initial);
        for volumetric in [Volumetric::Difference, Volumetric::Logarithm] {
            let law = SolidLaw { elasticity, volumetric };
            let plain = tetrahedron::strain_energy(&law, &reference, &current);
            let found = of_tetrahedron(&law, &reference, [&initial, &current]);
            assert!((found / plain - 1.0).abs() < 1e-12, "{found} {plain}");
        }
    }

    /// Turning by a radian changes nothing of the energy of a small strain.
    #[test]
    fn turning_costs_no_digits() {
        let elasticity = Elasticity {
            lame_lambda: 2e9,
            shear_modulus: 3e9,
            viscosity: 0.0,
            volumetric_share: 0.5,
        };
        let law = StressLaw::NeoHookean(elasticity);
        let initial = [Vec2::new(0.0, 0.0), Vec2::new(1.0, 0.1), Vec2::new(0.2, 0.9)];
        let strained = initial.map(|p| p + Vec2::new(1e-6 * p.x, -2e-6 * p.y));
        let turn = nalgebra::Rotation2::new(1.0);
        let reference = triangle::ReferenceShape::new(&initial);
        let still = of_triangle(&law, &reference, [&initial, &strained]);
        let turned = of_triangle(&law, &reference, [&initial, &strained.map(|p| turn * p)]);
        assert!((turned / still - 1.0).abs() < 1e-9, "{still} {turned}");
    }

    /// The series and the logarithm agree where they meet, and small strains keep their digits.
    #[test]
    fn the_excess_keeps_its_digits() {
        for d in [0.019_999_f64, -0.019_999] {
            assert!((excess(d) / (d - d.ln_1p()) - 1.0).abs() < 1e-11);
        }
        assert!((excess(1e-9) / 5e-19 - 1.0).abs() < 1e-8);
    }
}
