//! The four-node tetrahedron, four at a time: the bits of [`super::cauchy_stress`] and
//! [`super::nodal_forces`].

use super::{ReferenceShape, SolidLaw, Volumetric};
use crate::lanes::{LANES, Lanes, each};
use nalgebra::Matrix3;

/// Vectors of four lanes.
pub type VectorLanes<L> = [L; 3];

/// Undeformed shapes of four tetrahedra.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(32))]
pub struct ReferenceLanes {
    /// Entries of the inverse of the matrix of edges, row by row.
    inverse_edges: [[[f64; LANES]; 3]; 3],
    /// Six times the volumes, m³.
    sixfold_volume: [f64; LANES],
}

impl ReferenceLanes {
    /// From the shape of each tetrahedron.
    #[must_use]
    pub fn new(shapes: [&ReferenceShape; LANES]) -> Self {
        Self {
            inverse_edges: each!(3, |r| each!(3, |c| shapes.map(|s| s.inverse_edges[(r, c)]))),
            sixfold_volume: shapes.map(|s| s.sixfold_volume),
        }
    }

    /// The shape of one of them.
    #[must_use]
    pub fn shape(&self, lane: usize) -> ReferenceShape {
        ReferenceShape {
            inverse_edges: Matrix3::from_fn(|r, c| self.inverse_edges[r][c][lane]),
            sixfold_volume: self.sixfold_volume[lane],
        }
    }
}

/// Constants of a law in all lanes.
#[derive(Debug, Clone, Copy)]
pub struct LawLanes<L> {
    lame_lambda: L,
    double_shear_modulus: L,
    viscosity: L,
    volumetric_share: L,
    volumetric: Volumetric,
}

impl<L: Lanes> LawLanes<L> {
    /// The same constants in all lanes.
    #[inline(always)]
    pub fn new(SolidLaw { elasticity, volumetric }: &SolidLaw) -> Self {
        Self {
            lame_lambda: L::splat(elasticity.lame_lambda),
            double_shear_modulus: L::splat(2.0 * elasticity.shear_modulus),
            viscosity: L::splat(elasticity.viscosity),
            volumetric_share: L::splat(elasticity.volumetric_share),
            volumetric: *volumetric,
        }
    }

    #[inline(always)]
    fn pressure(&self, before: L, now: L) -> L {
        let (compression, expansion) = (before / now, now / before);
        match self.volumetric {
            Volumetric::Difference => {
                self.lame_lambda * (expansion - compression) * self.volumetric_share
            }
            Volumetric::Logarithm => {
                let expansion = expansion.array();
                let logarithm = L::new(each!(4, |lane| expansion[lane].ln()));
                self.lame_lambda * logarithm * compression
            }
        }
    }
}

/// What four tetrahedra do.
#[derive(Debug, Clone, Copy)]
pub struct ResponseLanes<L> {
    /// Cauchy stress, which is symmetric: rows, Pa.
    pub stress: [[L; 3]; 3],
    /// Force on each node, N.
    pub forces: [VectorLanes<L>; 4],
    /// Six times the current volume, m³.
    pub sixfold_volume: L,
}

/// Stresses and forces of four tetrahedra.
#[inline(always)]
pub fn respond<L: Lanes>(
    law: &LawLanes<L>,
    reference: &ReferenceLanes,
    corners: &[VectorLanes<L>; 4],
    velocities: &[VectorLanes<L>; 4],
) -> ResponseLanes<L> {
    // no closures here: code for the lanes would not be part of this function any more
    let edges = edges(corners);
    let volume = determinant(&edges);
    let before = L::load(&reference.sixfold_volume);
    let inverse_edges = each!(3, |r| each!(3, |c| L::load(&reference.inverse_edges[r][c])));
    let deformation = product(&edges, &inverse_edges);
    let gradient = product(&self::edges(velocities), &inverse(&edges, volume));
    let compression = before / volume;
    let pressure = law.pressure(before, volume);
    let (zero, half) = (L::splat(0.0), L::splat(0.5));
    let mut stress = [[zero; 3]; 3];
    for i in 0..3 {
        for j in i..3 {
            let mut left_cauchy_green = zero;
            for k in 0..3 {
                left_cauchy_green = left_cauchy_green + deformation[i][k] * deformation[j][k];
            }
            let mut strain = half * left_cauchy_green;
            if i == j {
                strain = strain - half;
            }
            let rate = half * (gradient[i][j] + gradient[j][i]);
            let mut sum = law.double_shear_modulus * strain * compression + law.viscosity * rate;
            if i == j {
                sum = sum + pressure;
            }
            stress[i][j] = sum;
            stress[j][i] = sum;
        }
    }
    ResponseLanes { forces: nodal_forces(&stress, corners), stress, sixfold_volume: volume }
}

#[inline(always)]
fn nodal_forces<L: Lanes>(
    stress: &[[L; 3]; 3],
    corners: &[VectorLanes<L>; 4],
) -> [VectorLanes<L>; 4] {
    let six = L::splat(6.0);
    each!(4, |i| {
        let [j, k, l] = [(i + 1) % 4, (i + 2) % 4, (i + 3) % 4];
        let a = each!(3, |c| corners[k][c] - corners[j][c]);
        let b = each!(3, |c| corners[l][c] - corners[j][c]);
        let normal = [
            (a[1] * b[2] - a[2] * b[1]) / six,
            (a[2] * b[0] - a[0] * b[2]) / six,
            (a[0] * b[1] - a[1] * b[0]) / six,
        ];
        let force = each!(3, |r| {
            stress[r][0] * normal[0] + stress[r][1] * normal[1] + stress[r][2] * normal[2]
        });
        if i.is_multiple_of(2) { force } else { each!(3, |r| -force[r]) }
    })
}

/// The matrix whose columns are the edges 0→1, 0→2 and 0→3.
#[inline(always)]
fn edges<L: Lanes>(corners: &[VectorLanes<L>; 4]) -> [[L; 3]; 3] {
    each!(3, |r| each!(3, |c| corners[c + 1][r] - corners[0][r]))
}

#[inline(always)]
fn determinant<L: Lanes>(m: &[[L; 3]; 3]) -> L {
    m[0][0] * (m[1][1] * m[2][2] - m[1][2] * m[2][1])
        - m[0][1] * (m[1][0] * m[2][2] - m[1][2] * m[2][0])
        + m[0][2] * (m[1][0] * m[2][1] - m[1][1] * m[2][0])
}

#[inline(always)]
fn inverse<L: Lanes>(m: &[[L; 3]; 3], determinant: L) -> [[L; 3]; 3] {
    each!(3, |i| each!(3, |j| {
        let [r, s] = [(j + 1) % 3, (j + 2) % 3];
        let [p, q] = [(i + 1) % 3, (i + 2) % 3];
        (m[r][p] * m[s][q] - m[r][q] * m[s][p]) / determinant
    }))
}

/// Each entry summed from zero in ascending order.
#[inline(always)]
fn product<L: Lanes>(a: &[[L; 3]; 3], b: &[[L; 3]; 3]) -> [[L; 3]; 3] {
    let zero = L::splat(0.0);
    each!(3, |i| each!(3, |j| zero + a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        lanes::{self, Kernel},
        mechanics::{Vec3, tetrahedron, triangle::Elasticity},
    };
    use proptest::prelude::*;

    struct Respond<'a> {
        law: &'a SolidLaw,
        shapes: [&'a ReferenceShape; LANES],
        corners: [[[f64; 3]; 4]; LANES],
        velocities: [[[f64; 3]; 4]; LANES],
    }

    /// Stress, forces and volume of a tetrahedron.
    type Found = ([[f64; 3]; 3], [[f64; 3]; 4], f64);

    impl Kernel for Respond<'_> {
        type Output = [Found; LANES];

        #[inline(always)]
        fn run<L: Lanes>(self) -> Self::Output {
            let law = LawLanes::<L>::new(self.law);
            let gather = |of: &[[[f64; 3]; 4]; LANES]| {
                each!(4, |i| each!(3, |k| L::new(each!(4, |lane| of[lane][i][k]))))
            };
            let (corners, velocities) = (gather(&self.corners), gather(&self.velocities));
            let found = respond(&law, &ReferenceLanes::new(self.shapes), &corners, &velocities);
            each!(4, |lane| (
                found.stress.map(|row| row.map(|x| x.array()[lane])),
                found.forces.map(|f| f.map(|x| x.array()[lane])),
                found.sixfold_volume.array()[lane],
            ))
        }
    }

    fn places() -> impl Strategy<Value = [[[f64; 3]; 4]; LANES]> {
        prop::array::uniform4(prop::array::uniform4(prop::array::uniform3(-1.0..1.0)))
    }

    proptest! {
        /// Also of tetrahedra that are flat or inside out.
        #[test]
        fn lanes_have_the_bits_of_the_scalar_tetrahedron(
            (reference, corners, velocities) in (places(), places(), places()),
            moves in prop::sample::select(vec![0.0, 1e-9, 1e-3, 0.3]),
            viscosity in prop::sample::select(vec![0.0, 3e4]),
            volumetric in prop::sample::select(vec![Volumetric::Difference, Volumetric::Logarithm]),
        ) {
            let elasticity = Elasticity {
                lame_lambda: 2e9,
                shear_modulus: 3e9,
                viscosity,
                volumetric_share: 0.5,
            };
            let law = SolidLaw { elasticity, volumetric };
            let vectors = |of: [[f64; 3]; 4]| of.map(Vec3::from);
            let shapes = reference.map(|places| ReferenceShape::new(&vectors(places)));
            let corners = each!(4, |lane| each!(4, |i| each!(3, |k| {
                reference[lane][i][k] + moves * corners[lane][i][k]
            })));
            let kernel = || Respond { law: &law, shapes: shapes.each_ref(), corners, velocities };
            for found in [lanes::run(kernel()), lanes::run_portable(kernel())] {
                for lane in 0..LANES {
                    let places = vectors(corners[lane]);
                    let (stress, volume) = tetrahedron::cauchy_stress(
                        &law, &shapes[lane], &places, &vectors(velocities[lane]),
                    );
                    let forces = tetrahedron::nodal_forces(&stress, &places);
                    let bits = |x: f64| if x.is_nan() { f64::NAN.to_bits() } else { x.to_bits() };
                    let (found_stress, found_forces, found_volume) = found[lane];
                    prop_assert_eq!(bits(found_volume), bits(volume));
                    for r in 0..3 {
                        for c in 0..3 {
                            prop_assert_eq!(bits(found_stress[r][c]), bits(stress[(r, c)]));
                        }
                    }
                    for (found, force) in found_forces.iter().zip(&forces) {
                        for k in 0..3 {
                            prop_assert_eq!(bits(found[k]), bits(force[k]));
                        }
                    }
                }
            }
        }
    }
}
