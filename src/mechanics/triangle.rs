//! Constant-strain triangle, finite strain, compressible neo-Hookean
//! (spec `y2d3d.md` C.1).
//!
//! With deformation gradient F, J = det F, B = F Fᵀ and rate of deformation D
//! the Cauchy stress is T = (μ/J)(B − I) + (λ/2)(J − 1/J) I + η D: plane
//! strain with unit thickness, one stress per element.

pub mod lanes;

use super::Vec2;
use nalgebra::Matrix2;

/// Elastic constants and viscosity of a neo-Hookean triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Elasticity {
    /// First Lamé constant λ, Pa.
    pub lame_lambda: f64,
    /// Shear modulus μ, Pa.
    pub shear_modulus: f64,
    /// Viscosity η, Pa·s.
    pub viscosity: f64,
    /// Share of λ (J − 1/J) in the stress: ½ where λ is nominal (split), 1 in
    /// the classic dialect and Y-Geo.
    pub volumetric_share: f64,
}

/// Stress that depends linearly on the strain E = ½(B − I) (spec `mechanics.md`
/// 2.2: plane stress, plane strain and transverse isotropy of Y-Geo).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct LinearElasticity {
    /// Factor on the normal stresses σxx and σyy, Pa.
    pub stiffness: [f64; 2],
    /// Share of the strain along the same axis.
    pub own: [f64; 2],
    /// Share of the strain along the other axis.
    pub cross: [f64; 2],
    /// Factor on the shear strain, Pa.
    pub shear: f64,
    /// Viscosity η, Pa·s.
    pub viscosity: f64,
}

/// Law of an elastic triangle.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum StressLaw {
    /// Compressible neo-Hookean.
    NeoHookean(Elasticity),
    /// Linear in the strain.
    Linear(LinearElasticity),
}

impl StressLaw {
    /// The elastic part of the law.
    #[must_use]
    pub fn without_viscosity(self) -> Self {
        match self {
            Self::NeoHookean(law) => Self::NeoHookean(Elasticity { viscosity: 0.0, ..law }),
            Self::Linear(law) => Self::Linear(LinearElasticity { viscosity: 0.0, ..law }),
        }
    }
}

impl LinearElasticity {
    /// Cauchy stress, Pa.
    #[must_use]
    fn stress(&self, kinematics: &Kinematics) -> Matrix2<f64> {
        let strain = kinematics.strain();
        let rate = &kinematics.rate_of_deformation;
        Matrix2::from_fn(|i, j| {
            let elastic = if i == j {
                let other = strain[(1 - i, 1 - i)];
                self.stiffness[i] * (self.own[i] * strain[(i, i)] + self.cross[i] * other)
            } else {
                self.shear * strain[(i, j)]
            };
            elastic + self.viscosity * rate[(i, j)]
        })
    }
}

/// Undeformed shape of a triangle, computed once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReferenceShape {
    /// Inverse of the matrix whose columns are the edges 0→1 and 0→2.
    pub inverse_edges: Matrix2<f64>,
    /// Twice the area, m².
    pub double_area: f64,
}

impl ReferenceShape {
    /// Shape of the stress-free triangle.
    #[must_use]
    pub fn new(corners: &[Vec2; 3]) -> Self {
        let edges = edges(corners);
        let double_area = determinant(&edges);
        Self { inverse_edges: inverse(&edges, double_area), double_area }
    }

    /// Mass that the triangle gives each of its nodes, kg.
    #[must_use]
    pub fn nodal_mass(&self, density: f64) -> f64 {
        density * self.double_area / 6.0
    }
}

/// Deformation of a triangle at one instant.
#[derive(Debug, Clone, Copy)]
pub struct Kinematics {
    /// Left Cauchy-Green tensor B = F Fᵀ.
    pub left_cauchy_green: Matrix2<f64>,
    /// Rate of deformation D = sym(grad v), 1/s.
    pub rate_of_deformation: Matrix2<f64>,
    /// Twice the current area, m².
    pub double_area: f64,
}

impl Kinematics {
    /// Kinematics from current corners and corner velocities.
    #[inline(always)]
    #[must_use]
    pub fn new(reference: &ReferenceShape, corners: &[Vec2; 3], velocities: &[Vec2; 3]) -> Self {
        let edges = edges(corners);
        let double_area = determinant(&edges);
        let deformation = product(&edges, &reference.inverse_edges);
        let gradient = product(&self::edges(velocities), &inverse(&edges, double_area));
        Self {
            left_cauchy_green: product(&deformation, &deformation.transpose()),
            rate_of_deformation: Matrix2::from_fn(|i, j| {
                0.5 * (gradient[(i, j)] + gradient[(j, i)])
            }),
            double_area,
        }
    }

    /// Strain ½(B − I), as Y takes it.
    #[must_use]
    pub fn strain(&self) -> Matrix2<f64> {
        let b = &self.left_cauchy_green;
        Matrix2::from_fn(|i, j| 0.5 * b[(i, j)] - if i == j { 0.5 } else { 0.0 })
    }

    /// Shear and viscous part of the Cauchy stress, (μ/J)(B − I) + η D.
    #[inline(always)]
    #[must_use]
    pub fn deviator_like(
        &self,
        elasticity: &Elasticity,
        reference: &ReferenceShape,
    ) -> Matrix2<f64> {
        let compression = reference.double_area / self.double_area;
        Matrix2::from_fn(|i, j| {
            let identity = if i == j { 0.5 } else { 0.0 };
            let strain = 0.5 * self.left_cauchy_green[(i, j)] - identity;
            2.0 * elasticity.shear_modulus * strain * compression
                + elasticity.viscosity * self.rate_of_deformation[(i, j)]
        })
    }

    /// λ (J − 1/J), twice the volumetric part of the elastic stress.
    #[inline(always)]
    #[must_use]
    pub fn volumetric(&self, elasticity: &Elasticity, reference: &ReferenceShape) -> f64 {
        elasticity.lame_lambda
            * (self.double_area / reference.double_area - reference.double_area / self.double_area)
    }
}

/// Cauchy stress of the elastic triangle, Pa.
#[inline(always)]
#[must_use]
pub fn cauchy_stress(
    law: &StressLaw,
    reference: &ReferenceShape,
    corners: &[Vec2; 3],
    velocities: &[Vec2; 3],
) -> Matrix2<f64> {
    let kinematics = Kinematics::new(reference, corners, velocities);
    match law {
        StressLaw::NeoHookean(elasticity) => {
            let mut stress = kinematics.deviator_like(elasticity, reference);
            let volumetric = kinematics.volumetric(elasticity, reference);
            let pressure = volumetric * elasticity.volumetric_share;
            stress[(0, 0)] += pressure;
            stress[(1, 1)] += pressure;
            stress
        }
        StressLaw::Linear(elasticity) => elasticity.stress(&kinematics),
    }
}

/// Strain energy of the elastic triangle, J: exact for neo-Hookean ones, half of stress
/// times strain for linear ones. Viscosity stores none.
#[must_use]
pub fn strain_energy(law: &StressLaw, reference: &ReferenceShape, corners: &[Vec2; 3]) -> f64 {
    let kinematics = Kinematics::new(reference, corners, &[Vec2::zeros(); 3]);
    let b = &kinematics.left_cauchy_green;
    let density = match law {
        StressLaw::NeoHookean(elasticity) => {
            let ratio = kinematics.double_area / reference.double_area;
            let shear = 0.5 * elasticity.shear_modulus * (b.trace() - 2.0 - 2.0 * ratio.ln());
            let volumetric = elasticity.volumetric_share
                * elasticity.lame_lambda
                * (0.5 * (ratio * ratio - 1.0) - ratio.ln());
            shear + volumetric
        }
        StressLaw::Linear(elasticity) => {
            let stress = elasticity.stress(&kinematics);
            let strain = (b - Matrix2::identity()) * 0.5;
            0.5 * stress.component_mul(&strain).sum()
        }
    };
    0.5 * reference.double_area * density
}

/// Force of the stress on each node, N.
#[inline(always)]
#[must_use]
pub fn nodal_forces(stress: &Matrix2<f64>, corners: &[Vec2; 3]) -> [Vec2; 3] {
    std::array::from_fn(|i| {
        let normal = opposite_normal(corners, i);
        Vec2::new(
            (stress[(0, 0)] * normal.x + stress[(0, 1)] * normal.y) / 2.0,
            (stress[(1, 0)] * normal.x + stress[(1, 1)] * normal.y) / 2.0,
        )
    })
}

/// Outward normal of the edge opposite to node `i`, as long as the edge, m.
#[inline(always)]
#[must_use]
pub fn opposite_normal(corners: &[Vec2; 3], i: usize) -> Vec2 {
    let (from, to) = (corners[(i + 1) % 3], corners[(i + 2) % 3]);
    Vec2::new(to.y - from.y, from.x - to.x)
}

/// Whether a point lies strictly inside a counter-clockwise triangle.
#[must_use]
pub fn contains(corners: &[Vec2; 3], point: Vec2) -> bool {
    (0..3).all(|i| {
        let edge = corners[(i + 1) % 3] - corners[i];
        let to_point = point - corners[i];
        edge.x * to_point.y - edge.y * to_point.x > 0.0
    })
}

/// Twice the area of a triangle, m²; negative if its corners run clockwise.
#[inline]
#[must_use]
pub fn double_area(corners: &[Vec2; 3]) -> f64 {
    determinant(&edges(corners))
}

#[inline(always)]
fn edges(corners: &[Vec2; 3]) -> Matrix2<f64> {
    Matrix2::from_columns(&[corners[1] - corners[0], corners[2] - corners[0]])
}

#[inline(always)]
fn determinant(m: &Matrix2<f64>) -> f64 {
    m[(0, 0)] * m[(1, 1)] - m[(1, 0)] * m[(0, 1)]
}

/// Inverse of a 2×2 matrix, each cofactor divided by the determinant.
#[inline(always)]
#[must_use]
pub fn inverse(m: &Matrix2<f64>, determinant: f64) -> Matrix2<f64> {
    Matrix2::new(
        m[(1, 1)] / determinant,
        -m[(0, 1)] / determinant,
        -m[(1, 0)] / determinant,
        m[(0, 0)] / determinant,
    )
}

/// Matrix product whose sums start from 0 and run over k = 0, 1.
#[inline(always)]
fn product(a: &Matrix2<f64>, b: &Matrix2<f64>) -> Matrix2<f64> {
    Matrix2::from_fn(|i, j| (0.0 + a[(i, 0)] * b[(0, j)]) + a[(i, 1)] * b[(1, j)])
}

#[cfg(test)]
mod tests {
    use super::*;

    const ELASTICITY: Elasticity =
        Elasticity { lame_lambda: 2e9, shear_modulus: 3e9, viscosity: 1e4, volumetric_share: 0.5 };
    const LAW: StressLaw = StressLaw::NeoHookean(ELASTICITY);

    fn unit_triangle() -> ReferenceShape {
        ReferenceShape::new(&[Vec2::new(0.0, 0.0), Vec2::new(1.0, 0.0), Vec2::new(0.0, 1.0)])
    }

    /// Worked number J1 of the spec (without edge load).
    #[test]
    fn forces_equal_the_worked_example() {
        let corners = [Vec2::new(0.0, 0.0), Vec2::new(1.01, 0.002), Vec2::new(-0.003, 0.99)];
        let velocities = [Vec2::new(0.1, 0.0), Vec2::new(0.0, 0.2), Vec2::new(-0.3, 0.1)];
        let stress = cauchy_stress(&LAW, &unit_triangle(), &corners, &velocities);
        let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-14 * b.abs(), "{a} against {b}");
        close(stress[(0, 0)], 60_143_680.341_951_9);
        close(stress[(0, 1)], -2_851_300.522_249_09);
        close(stress[(1, 1)], -59_880_603.940_770_5);
        let forces = nodal_forces(&stress, &corners);
        close(forces[0].x, 28_266_794.374_405_1);
        close(forces[1].y, 1_501_214.664_424_46);
        close(forces[2].x, 1_500_050.444_077_74);
        close(unit_triangle().nodal_mass(2500.0), 416.666_666_666_667);
    }

    /// Worked example A of spec `mechanics.md` 10: λ acts whole, and the linear
    /// laws of Y-Geo.
    #[test]
    fn stresses_equal_the_worked_example_of_the_other_dialects() {
        let shape = [Vec2::new(0.0, 0.0), Vec2::new(2.0, 0.0), Vec2::new(0.5, 1.0)];
        let reference = ReferenceShape::new(&shape);
        let corners = [Vec2::new(0.0, 0.0), Vec2::new(2.01, 0.02), Vec2::new(0.48, 1.03)];
        let velocities = [Vec2::zeros(), Vec2::new(0.1, -0.2), Vec2::new(0.3, 0.05)];
        let (young, poisson, viscosity) = (1e8, 0.25, 2e3);
        let shear = young / (1.0 + poisson);
        let neo_hookean = StressLaw::NeoHookean(Elasticity {
            lame_lambda: 4e7,
            shear_modulus: 3e7,
            viscosity,
            volumetric_share: 1.0,
        });
        let plane_stress = StressLaw::Linear(LinearElasticity {
            stiffness: [young / (1.0 - poisson * poisson); 2],
            own: [1.0; 2],
            cross: [poisson; 2],
            shear,
            viscosity,
        });
        let plane_strain = StressLaw::Linear(LinearElasticity {
            stiffness: [young / ((1.0 + poisson) * (1.0 - 2.0 * poisson)); 2],
            own: [1.0 - poisson; 2],
            cross: [poisson; 2],
            shear,
            viscosity,
        });
        for (law, expected) in [
            (neo_hookean, [2_698_965.788_324_355, -378_707.235_405_443_7, 3_869_356.432_280_312]),
            (plane_stress, [1_238_094.142_767_007, -520_331.125_345_754_9, 2_845_940.711_894_031]),
            (plane_strain, [1_646_469.142_767_007, -520_331.125_345_754_9, 3_254_315.711_894_031]),
        ] {
            let stress = cauchy_stress(&law, &reference, &corners, &velocities);
            for (value, expected) in
                [stress[(0, 0)], stress[(0, 1)], stress[(1, 1)]].into_iter().zip(expected)
            {
                assert!((value - expected).abs() <= 1e-14 * expected.abs(), "{value} {expected}");
            }
        }
    }

    /// Simple shear γ keeps J = 1: T_xx = μγ², T_xy = μγ, all else 0.
    #[test]
    fn simple_shear_has_the_closed_form_stress() {
        let gamma = 0.25;
        let corners = [Vec2::new(0.0, 0.0), Vec2::new(1.0, 0.0), Vec2::new(gamma, 1.0)];
        let stress = cauchy_stress(&LAW, &unit_triangle(), &corners, &[Vec2::zeros(); 3]);
        let mu = ELASTICITY.shear_modulus;
        assert!((stress[(0, 0)] - mu * gamma * gamma).abs() < 1e-6);
        assert!((stress[(0, 1)] - mu * gamma).abs() < 1e-6);
        assert!(stress[(1, 1)].abs() < 1e-6);
    }

    /// A rigid rotation causes neither stress nor force.
    #[test]
    fn rigid_rotation_is_free_of_stress() {
        let (s, c) = 0.7f64.sin_cos();
        let corners =
            [Vec2::new(2.0, 1.0), Vec2::new(2.0 + c, 1.0 + s), Vec2::new(2.0 - s, 1.0 + c)];
        let stress = cauchy_stress(&LAW, &unit_triangle(), &corners, &[Vec2::zeros(); 3]);
        assert!(stress.amax() < 1e-5, "{stress}");
    }
}
