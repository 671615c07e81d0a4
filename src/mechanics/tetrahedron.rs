//! Four-node tetrahedron, finite strain, compressible neo-Hookean (spec `y2d3d.md` C.4,
//! `y3d.md` 2).
//!
//! The law is that of the elastic triangle in space: with deformation gradient F, J = det F,
//! B = F Fᵀ and rate of deformation D the Cauchy stress is
//! T = (μ/J)(B − I) + p(J) I + η D, one stress per element; p = (λ/2)(J − 1/J) in the split
//! dialect, (λ/J) ln J in the `.Y3D` lineage.

pub mod lanes;

use super::{Vec3, triangle::Elasticity};
use nalgebra::Matrix3;

/// How the change of volume presses on a solid. Both agree to first order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Volumetric {
    /// The share of λ(J − 1/J) that the elasticity names (spec `y2d3d.md` C.4).
    #[default]
    Difference,
    /// (λ/J) ln J (spec `y3d.md` 2.2, variant 1).
    Logarithm,
}

/// Elastic law of a solid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SolidLaw {
    /// Constants.
    pub elasticity: Elasticity,
    /// Answer to a change of volume.
    pub volumetric: Volumetric,
}

impl SolidLaw {
    /// Pressure term of the stress, Pa, positive in tension, where the volume has grown by `ratio`.
    #[inline]
    #[must_use]
    pub fn tension(&self, ratio: f64) -> f64 {
        let lambda = self.elasticity.lame_lambda;
        match self.volumetric {
            Volumetric::Difference => {
                lambda * (ratio - 1.0 / ratio) * self.elasticity.volumetric_share
            }
            Volumetric::Logarithm => lambda * ratio.ln() / ratio,
        }
    }
}

/// Undeformed shape of a tetrahedron, computed once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReferenceShape {
    /// Inverse of the matrix whose columns are the edges 0→1, 0→2 and 0→3.
    pub inverse_edges: Matrix3<f64>,
    /// Six times the volume, m³.
    pub sixfold_volume: f64,
}

impl ReferenceShape {
    /// Shape of the stress-free tetrahedron.
    #[must_use]
    pub fn new(corners: &[Vec3; 4]) -> Self {
        let edges = edges(corners);
        let sixfold_volume = determinant(&edges);
        Self { inverse_edges: inverse(&edges, sixfold_volume), sixfold_volume }
    }

    /// Mass that the tetrahedron gives each of its nodes, kg.
    #[must_use]
    pub fn nodal_mass(&self, density: f64) -> f64 {
        density * self.sixfold_volume / 24.0
    }
}

/// Six times the volume, m³: positive if corners 1, 2, 3 run counter-clockwise seen from
/// outside of the face opposite to corner 0.
#[must_use]
pub fn sixfold_volume(corners: &[Vec3; 4]) -> f64 {
    determinant(&edges(corners))
}

/// Cauchy stress, Pa, and six times the current volume, m³ (not above 0 where the
/// tetrahedron has turned inside out).
#[inline]
#[must_use]
pub fn cauchy_stress(
    SolidLaw { elasticity: law, volumetric }: &SolidLaw,
    reference: &ReferenceShape,
    corners: &[Vec3; 4],
    velocities: &[Vec3; 4],
) -> (Matrix3<f64>, f64) {
    let edges = edges(corners);
    let volume = determinant(&edges);
    let deformation = product(&edges, &reference.inverse_edges);
    let gradient = product(&self::edges(velocities), &inverse(&edges, volume));
    let left_cauchy_green = product(&deformation, &deformation.transpose());
    let (compression, expansion) =
        (reference.sixfold_volume / volume, volume / reference.sixfold_volume);
    let pressure = match volumetric {
        Volumetric::Difference => {
            law.lame_lambda * (expansion - compression) * law.volumetric_share
        }
        Volumetric::Logarithm => law.lame_lambda * expansion.ln() * compression,
    };
    let stress = Matrix3::from_fn(|i, j| {
        let strain = 0.5 * left_cauchy_green[(i, j)] - if i == j { 0.5 } else { 0.0 };
        let rate = 0.5 * (gradient[(i, j)] + gradient[(j, i)]);
        let shear = 2.0 * law.shear_modulus * strain * compression + law.viscosity * rate;
        if i == j { shear + pressure } else { shear }
    });
    (stress, volume)
}

/// Force of the stress on each node, N.
#[inline]
#[must_use]
pub fn nodal_forces(stress: &Matrix3<f64>, corners: &[Vec3; 4]) -> [Vec3; 4] {
    std::array::from_fn(|i| {
        let [j, k, l] = [1, 2, 3].map(|step| corners[(i + step) % 4]);
        let (a, b) = (k - j, l - j);
        // a third of the vector of the opposite face
        let normal = Vec3::new(
            (a.y * b.z - a.z * b.y) / 6.0,
            (a.z * b.x - a.x * b.z) / 6.0,
            (a.x * b.y - a.y * b.x) / 6.0,
        );
        let row = |r: usize| {
            stress[(r, 0)] * normal.x + stress[(r, 1)] * normal.y + stress[(r, 2)] * normal.z
        };
        let force = Vec3::new(row(0), row(1), row(2));
        // the corners of opposite faces run one way and the other in turn
        if i % 2 == 0 { force } else { -force }
    })
}

/// Strain energy, J: exact. Viscosity stores none.
#[must_use]
pub fn strain_energy(
    SolidLaw { elasticity: law, volumetric }: &SolidLaw,
    reference: &ReferenceShape,
    corners: &[Vec3; 4],
) -> f64 {
    let edges = edges(corners);
    let deformation = product(&edges, &reference.inverse_edges);
    let trace = deformation.norm_squared();
    let ratio = determinant(&edges) / reference.sixfold_volume;
    let shear = 0.5 * law.shear_modulus * (trace - 3.0 - 2.0 * ratio.ln());
    let pressed = match volumetric {
        Volumetric::Difference => {
            law.volumetric_share * law.lame_lambda * (0.5 * (ratio * ratio - 1.0) - ratio.ln())
        }
        Volumetric::Logarithm => 0.5 * law.lame_lambda * ratio.ln().powi(2),
    };
    reference.sixfold_volume / 6.0 * (shear + pressed)
}

#[inline(always)]
fn edges(corners: &[Vec3; 4]) -> Matrix3<f64> {
    let [a, b, c, d] = corners;
    Matrix3::from_columns(&[b - a, c - a, d - a])
}

/// Expanded along the first row.
#[inline(always)]
pub(crate) fn determinant(m: &Matrix3<f64>) -> f64 {
    m[(0, 0)] * (m[(1, 1)] * m[(2, 2)] - m[(1, 2)] * m[(2, 1)])
        - m[(0, 1)] * (m[(1, 0)] * m[(2, 2)] - m[(1, 2)] * m[(2, 0)])
        + m[(0, 2)] * (m[(1, 0)] * m[(2, 1)] - m[(1, 1)] * m[(2, 0)])
}

/// Cofactors, each divided by the determinant.
#[inline(always)]
pub(crate) fn inverse(m: &Matrix3<f64>, determinant: f64) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| {
        let [r, s] = [(j + 1) % 3, (j + 2) % 3];
        let [p, q] = [(i + 1) % 3, (i + 2) % 3];
        (m[(r, p)] * m[(s, q)] - m[(r, q)] * m[(s, p)]) / determinant
    })
}

/// Matrix product, each entry summed from zero in ascending order.
#[inline(always)]
pub(super) fn product(a: &Matrix3<f64>, b: &Matrix3<f64>) -> Matrix3<f64> {
    Matrix3::from_fn(|i, j| {
        let mut sum = 0.0;
        for k in 0..3 {
            sum += a[(i, k)] * b[(k, j)];
        }
        sum
    })
}

#[cfg(test)]
mod tests;
