//! The elastic triangle, four at a time.
//!
//! Stresses have the bits of [`super::cauchy_stress`], forces those of [`super::nodal_forces`]
//! but for the sign of a zero, which no sum that starts from +0 keeps. Terms are left out or
//! turned round only where that changes no bit: `a + (-b)` is `a - b`, products and sums
//! commute, `x / 2` is `0.5 * x`, and `0.5 * (x + x)` is `x`.

use super::{Elasticity, LinearElasticity, ReferenceShape};
use crate::lanes::{LANES, Lanes};

/// Undeformed shapes of four triangles.
#[derive(Debug, Clone, Copy)]
#[repr(C, align(32))]
pub struct ReferenceLanes {
    /// Entries 00, 01, 10, 11 of the inverse of the matrix of edges.
    inverse_edges: [[f64; LANES]; 4],
    /// Twice the areas, m².
    double_area: [f64; LANES],
}

impl ReferenceLanes {
    /// From the shape of each triangle.
    #[must_use]
    pub fn new(shapes: [&ReferenceShape; LANES]) -> Self {
        let entries = [(0, 0), (0, 1), (1, 0), (1, 1)];
        Self {
            inverse_edges: entries.map(|entry| shapes.map(|s| s.inverse_edges[entry])),
            double_area: shapes.map(|s| s.double_area),
        }
    }
}

/// A symmetric tensor: components xx, xy, yy.
pub type Symmetric<L> = [L; 3];

/// Constants of a stress law in all lanes.
pub trait StressLanes<L: Lanes>: Copy {
    /// Cauchy stress, Pa, from the strain ½(B − I), twice the areas before and now, and, if
    /// `VISCOUS`, the rate of deformation, 1/s.
    fn stress<const VISCOUS: bool>(
        &self,
        strain: Symmetric<L>,
        areas: [L; 2],
        rate: Symmetric<L>,
    ) -> Symmetric<L>;
}

/// Compressible neo-Hookean.
#[derive(Debug, Clone, Copy)]
pub struct NeoHookeanLanes<L> {
    lame_lambda: L,
    double_shear_modulus: L,
    viscosity: L,
    volumetric_share: L,
}

impl<L: Lanes> NeoHookeanLanes<L> {
    /// The same constants in all lanes.
    #[inline(always)]
    pub fn new(law: &Elasticity) -> Self {
        Self {
            lame_lambda: L::splat(law.lame_lambda),
            double_shear_modulus: L::splat(2.0 * law.shear_modulus),
            viscosity: L::splat(law.viscosity),
            volumetric_share: L::splat(law.volumetric_share),
        }
    }
}

impl<L: Lanes> StressLanes<L> for NeoHookeanLanes<L> {
    #[inline(always)]
    fn stress<const VISCOUS: bool>(
        &self,
        strain: Symmetric<L>,
        [before, now]: [L; 2],
        rate: Symmetric<L>,
    ) -> Symmetric<L> {
        let compression = before / now;
        let volumetric = self.lame_lambda * (now / before - compression);
        let pressure = volumetric * self.volumetric_share;
        let modulus = self.double_shear_modulus;
        let mut stress = [
            modulus * strain[0] * compression,
            modulus * strain[1] * compression,
            modulus * strain[2] * compression,
        ];
        if VISCOUS {
            stress = add_viscous(stress, self.viscosity, rate);
        }
        [stress[0] + pressure, stress[1], stress[2] + pressure]
    }
}

/// Linear in the strain.
#[derive(Debug, Clone, Copy)]
pub struct LinearLanes<L> {
    stiffness: [L; 2],
    own: [L; 2],
    cross: [L; 2],
    shear: L,
    viscosity: L,
}

impl<L: Lanes> LinearLanes<L> {
    /// The same constants in all lanes.
    #[inline(always)]
    pub fn new(law: &LinearElasticity) -> Self {
        Self {
            stiffness: [L::splat(law.stiffness[0]), L::splat(law.stiffness[1])],
            own: [L::splat(law.own[0]), L::splat(law.own[1])],
            cross: [L::splat(law.cross[0]), L::splat(law.cross[1])],
            shear: L::splat(law.shear),
            viscosity: L::splat(law.viscosity),
        }
    }
}

impl<L: Lanes> StressLanes<L> for LinearLanes<L> {
    #[inline(always)]
    fn stress<const VISCOUS: bool>(
        &self,
        [xx, xy, yy]: Symmetric<L>,
        _areas: [L; 2],
        rate: Symmetric<L>,
    ) -> Symmetric<L> {
        let stress = [
            self.stiffness[0] * (self.own[0] * xx + self.cross[0] * yy),
            self.shear * xy,
            self.stiffness[1] * (self.own[1] * yy + self.cross[1] * xx),
        ];
        if VISCOUS { add_viscous(stress, self.viscosity, rate) } else { stress }
    }
}

#[inline(always)]
fn add_viscous<L: Lanes>(elastic: Symmetric<L>, viscosity: L, rate: Symmetric<L>) -> Symmetric<L> {
    [
        elastic[0] + viscosity * rate[0],
        elastic[1] + viscosity * rate[1],
        elastic[2] + viscosity * rate[2],
    ]
}

/// Stress and nodal forces of four triangles.
#[derive(Debug, Clone, Copy)]
pub struct ResponseLanes<L> {
    /// Cauchy stress, Pa.
    pub stress: Symmetric<L>,
    /// Force on each node, N.
    pub forces: [[L; 2]; 3],
}

/// Stresses and forces of four triangles.
///
/// Without `VISCOUS` the law's viscosity has to be 0, and without `SIGNED` zeros among the
/// stresses may have the wrong sign.
#[inline(always)]
pub fn respond<L: Lanes, W: StressLanes<L>, const VISCOUS: bool, const SIGNED: bool>(
    law: &W,
    reference: &ReferenceLanes,
    corners: [[L; 2]; 3],
    velocities: [[L; 2]; 3],
) -> ResponseLanes<L> {
    // no closures here: code for the lanes would not be part of this function any more
    let [[ax, ay], [bx, by]] = edges(corners);
    let double_area = ax * by - ay * bx;
    let areas = [L::load(&reference.double_area), double_area];
    let strain = strain::<L, SIGNED>(reference, ax, ay, bx, by);
    let mut rate = strain;
    if VISCOUS {
        let [[ux, uy], [vx, vy]] = edges(velocities);
        // cofactors of the inverse of the edges, without their signs
        let (c00, c01) = (by / double_area, bx / double_area);
        let (c10, c11) = (ay / double_area, ax / double_area);
        let xx = difference::<L, SIGNED>(ux * c00, vx * c10);
        let xy = opposite_difference::<L, SIGNED>(ux * c01, vx * c11);
        let yx = difference::<L, SIGNED>(uy * c00, vy * c10);
        let yy = opposite_difference::<L, SIGNED>(uy * c01, vy * c11);
        rate = [xx, L::splat(0.5) * (xy + yx), yy];
    }
    let stress = law.stress::<VISCOUS>(strain, areas, rate);
    let [xx, xy, yy] = stress;
    // outward normal of the edge opposite to the first node; those of the others are edges
    let nx = corners[2][1] - corners[1][1];
    let ny = corners[1][0] - corners[2][0];
    let half = L::splat(0.5);
    let forces = [
        [half * (xx * nx + xy * ny), half * (xy * nx + yy * ny)],
        [half * (xy * bx - xx * by), half * (yy * bx - xy * by)],
        [half * (xx * ay - xy * ax), half * (xy * ay - yy * ax)],
    ];
    ResponseLanes { stress, forces }
}

/// Strain ½(B − I), with the left Cauchy-Green tensor B of the deformation that makes the
/// edges of the reference a, b.
#[inline(always)]
fn strain<L: Lanes, const SIGNED: bool>(
    reference: &ReferenceLanes,
    ax: L,
    ay: L,
    bx: L,
    by: L,
) -> Symmetric<L> {
    let [i00, i01, i10, i11] = &reference.inverse_edges;
    let (i00, i01, i10, i11) = (L::load(i00), L::load(i01), L::load(i10), L::load(i11));
    let fxx = sum::<L, SIGNED>(ax * i00, bx * i10);
    let fxy = sum::<L, SIGNED>(ax * i01, bx * i11);
    let fyx = sum::<L, SIGNED>(ay * i00, by * i10);
    let fyy = sum::<L, SIGNED>(ay * i01, by * i11);
    let half = L::splat(0.5);
    [
        half * sum::<L, SIGNED>(fxx * fxx, fxy * fxy) - half,
        half * sum::<L, SIGNED>(fxx * fyx, fxy * fyy),
        half * sum::<L, SIGNED>(fyx * fyx, fyy * fyy) - half,
    ]
}

/// Edges 0→1 and 0→2.
#[inline(always)]
fn edges<L: Lanes>([a, b, c]: [[L; 2]; 3]) -> [[L; 2]; 2] {
    [[b[0] - a[0], b[1] - a[1]], [c[0] - a[0], c[1] - a[1]]]
}

/// Sum of two terms that starts from 0, which only the sign of a zero tells from one that does not.
#[inline(always)]
fn sum<L: Lanes, const SIGNED: bool>(a: L, b: L) -> L {
    if SIGNED { L::splat(0.0) + a + b } else { a + b }
}

/// `sum` of `a` and `-b`.
#[inline(always)]
fn difference<L: Lanes, const SIGNED: bool>(a: L, b: L) -> L {
    if SIGNED { L::splat(0.0) + a - b } else { a - b }
}

/// `sum` of `-a` and `b`.
#[inline(always)]
fn opposite_difference<L: Lanes, const SIGNED: bool>(a: L, b: L) -> L {
    if SIGNED { L::splat(0.0) - a + b } else { b - a }
}

#[cfg(test)]
mod tests {
    use super::{
        super::{StressLaw, cauchy_stress, nodal_forces},
        *,
    };
    use crate::{
        lanes::{self, Kernel},
        mechanics::Vec2,
    };
    use proptest::prelude::*;

    /// Corners and velocities of four triangles, reference corners first.
    type Shapes = [[[f64; 2]; 3]; LANES];

    struct Respond<'a, const VISCOUS: bool, const SIGNED: bool> {
        law: &'a StressLaw,
        reference: &'a ReferenceLanes,
        corners: &'a Shapes,
        velocities: &'a Shapes,
    }

    /// Stress and forces of each lane.
    type Response = [([f64; 3], [[f64; 2]; 3]); LANES];

    impl<const VISCOUS: bool, const SIGNED: bool> Kernel for Respond<'_, VISCOUS, SIGNED> {
        type Output = Response;

        #[inline(always)]
        fn run<L: Lanes>(self) -> Response {
            let lanes = |shapes: &Shapes| {
                [0, 1, 2].map(|k| L::pairs([0, 1, 2, 3].map(|lane| &shapes[lane][k])))
            };
            let (x, v) = (lanes(self.corners), lanes(self.velocities));
            let response = match self.law {
                StressLaw::NeoHookean(law) => {
                    let law = NeoHookeanLanes::<L>::new(law);
                    respond::<L, _, VISCOUS, SIGNED>(&law, self.reference, x, v)
                }
                StressLaw::Linear(law) => {
                    let law = LinearLanes::<L>::new(law);
                    respond::<L, _, VISCOUS, SIGNED>(&law, self.reference, x, v)
                }
            };
            let (stress, forces) =
                (response.stress.map(L::array), response.forces.map(|f| f.map(L::array)));
            std::array::from_fn(|i| (stress.map(|s| s[i]), forces.map(|f| f.map(|c| c[i]))))
        }
    }

    fn check(law: &StressLaw, initial: &Shapes, corners: &Shapes, velocities: &Shapes) {
        let at = |shape: &[[f64; 2]; 3]| shape.map(Vec2::from);
        let shapes = initial.map(|shape| ReferenceShape::new(&at(&shape)));
        let reference = &ReferenceLanes::new(shapes.each_ref());
        let viscous = Respond::<true, true> { law, reference, corners, velocities };
        let unsigned = Respond::<true, false> { law, reference, corners, velocities };
        let inviscid = Respond::<false, false> { law, reference, corners, velocities };
        let is_viscous = law.without_viscosity() != *law;
        let mut responses = vec![
            (true, lanes::run_portable(viscous_copy(&viscous))),
            (true, lanes::run(viscous)),
            (false, lanes::run(unsigned)),
        ];
        if !is_viscous {
            responses.push((false, lanes::run(inviscid)));
        }
        for lane in 0..LANES {
            let x = at(&corners[lane]);
            let stress = cauchy_stress(law, &shapes[lane], &x, &at(&velocities[lane]));
            let forces = nodal_forces(&stress, &x);
            for (signed, response) in &responses {
                let (s, f) = &response[lane];
                // as a sum that starts from +0 sees it
                let seen = |x: f64| if *signed { x } else { x + 0.0 }.to_bits();
                let expected = [(0, 0), (0, 1), (1, 1)].map(|entry| seen(stress[entry]));
                assert_eq!(s.map(seen), expected);
                assert_eq!(stress[(0, 1)].to_bits(), stress[(1, 0)].to_bits());
                for (f, expected) in f.iter().zip(&forces) {
                    let expected = [expected.x, expected.y].map(|x| (x + 0.0).to_bits());
                    assert_eq!(f.map(|x| (x + 0.0).to_bits()), expected);
                }
            }
        }
    }

    fn viscous_copy<'a>(r: &Respond<'a, true, true>) -> Respond<'a, true, true> {
        Respond { ..*r }
    }

    fn laws(viscosity: f64) -> [StressLaw; 2] {
        [
            StressLaw::NeoHookean(Elasticity {
                lame_lambda: 2e9,
                shear_modulus: 3.1e9,
                viscosity,
                volumetric_share: 0.5,
            }),
            StressLaw::Linear(LinearElasticity {
                stiffness: [3e9, 2.7e9],
                own: [0.8, 0.9],
                cross: [0.2, 0.25],
                shear: 1.1e9,
                viscosity,
            }),
        ]
    }

    fn shapes(size: f64) -> impl Strategy<Value = Shapes> {
        prop::array::uniform4(prop::array::uniform3(prop::array::uniform2(-size..size)))
    }

    proptest! {
        /// Sheared, inverted, far away and nearly flat triangles alike.
        #[test]
        fn lanes_have_the_bits_of_the_scalar_triangle(
            initial in shapes(1.0),
            moves in shapes(1.0),
            reach in prop::sample::select(vec![0.0, 1e-12, 1e-3, 2.0]),
            place in prop::sample::select(vec![0.0, 1e3]),
            velocities in shapes(3.0),
            speed in prop::sample::select(vec![0.0, 1.0]),
            viscosity in prop::sample::select(vec![0.0, 2e4]),
        ) {
            let mut corners = initial;
            for (corner, by) in corners.as_flattened_mut().iter_mut().zip(moves.as_flattened()) {
                *corner = [0, 1].map(|k| corner[k] + reach * by[k] + place);
            }
            let velocities = velocities.map(|t| t.map(|v| v.map(|v| speed * v)));
            for law in laws(viscosity) {
                check(&law, &initial, &corners, &velocities);
            }
        }
    }

    /// Exact zeros of either sign.
    #[test]
    fn zeros_keep_their_signs() {
        let unit = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
        let mirrored = [[0.0, 0.0], [-1.0, 0.0], [0.0, -1.0]];
        let inverted = [[0.0, 0.0], [0.0, 1.0], [1.0, 0.0]];
        let wide = [[-0.0, 0.0], [2.0, 0.0], [0.0, 2.0]];
        let at_rest = [[0.0; 2]; 3];
        let moving = [[-0.0, 0.0], [-0.0, -0.0], [-1.0, 0.5]];
        for law in laws(0.0).into_iter().chain(laws(2e4)) {
            for v in [[at_rest; 4], [moving; 4], [at_rest, moving, moving, at_rest]] {
                check(&law, &[unit; 4], &[unit, mirrored, inverted, wide], &v);
                check(&law, &[unit, mirrored, wide, inverted], &[unit; 4], &v);
            }
        }
    }
}
