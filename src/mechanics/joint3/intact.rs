//! Joints without cohesion, four at a time, as long as none of their points softens: the bits of
//! [`super::evaluate`] at zero damage.

use super::{Length, Points};
use crate::{
    TOLERANCE,
    lanes::{Lanes, Mask as _, each},
    mechanics::softening::INTACT,
    scene::CohesiveLaw,
};

/// Constants of a cohesive law in all lanes.
#[derive(Debug, Clone, Copy)]
pub struct LawLanes<L> {
    tensile_strength: L,
    shear_strength: L,
    /// Opening and sliding at the peaks by the length of the surface.
    peaks: [L; 2],
}

impl<L: Lanes> LawLanes<L> {
    /// The same constants in all lanes.
    #[inline(always)]
    pub fn new(law: &CohesiveLaw) -> Self {
        Self {
            tensile_strength: L::splat(law.tensile_strength),
            shear_strength: L::splat(law.shear_strength),
            peaks: [
                L::splat(2.0 * law.tensile_strength / law.penalty),
                L::splat(2.0 * law.shear_strength / law.penalty),
            ],
        }
    }
}

/// Whether joints of a law can be evaluated so: pressure must not raise their strength.
#[must_use]
pub fn covers(law: &CohesiveLaw) -> bool {
    law.cohesion <= 0.0
}

/// What four joints exert.
#[derive(Debug, Clone, Copy)]
pub struct IntactLanes<L> {
    /// Force across the joint at each pair of nodes, N.
    pub pair_forces: [[L; 3]; 3],
    /// Bit `i` is set where joint `i` softens, so that all that is given for it is void.
    pub softening: u32,
}

/// Evaluates four joints. Nodes 0, 1, 2 of `corners` face 3, 4, 5.
#[inline(always)]
pub fn evaluate<L: Lanes>(
    law: &LawLanes<L>,
    points: &Points,
    corners: &[[L; 3]; 6],
) -> IntactLanes<L> {
    // no closures here: code for the lanes would not be part of this function any more
    let (zero, half, two) = (L::splat(0.0), L::splat(0.5), L::splat(2.0));
    let middles = each!(3, |i| each!(3, |k| half * (corners[i][k] + corners[i + 3][k])));
    let a = each!(3, |k| middles[1][k] - middles[0][k]);
    let b = each!(3, |k| middles[2][k] - middles[0][k]);
    let c = each!(3, |k| b[k] - a[k]);
    let sizes = [size(&a), size(&b), size(&c)];
    let length = match points.length {
        Length::ShortestEdge => sizes[0].smaller(sizes[1]).smaller(sizes[2]),
        Length::MeanEdge => (sizes[0] + sizes[1] + sizes[2]) / L::splat(3.0),
    };
    let cross = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
    let double_area = size(&cross);
    let is_flat = !double_area.gt(L::splat(TOLERANCE));
    let normal = each!(3, |k| L::select(is_flat, cross[k], cross[k] / double_area));
    let area = half * double_area;
    let gaps = each!(3, |i| each!(3, |k| corners[i][k] - corners[i + 3][k]));
    let [peak_opening, peak_sliding] = [law.peaks[0] * length, law.peaks[1] * length];
    let left = L::splat(INTACT);
    let mut pair_forces = [[zero; 3]; 3];
    let mut softening = zero.lt(zero);
    for (shape, weight) in points.shapes.iter().zip(points.weights) {
        let shares = each!(3, |i| L::splat(shape[i]));
        let gap = each!(3, |k| {
            shares[0] * gaps[0][k] + shares[1] * gaps[1][k] + shares[2] * gaps[2][k]
        });
        let opening = dot(&gap, &normal);
        let slip = each!(3, |k| gap[k] - opening * normal[k]);
        let sliding = size(&slip);
        let slides = sliding.gt(L::splat(TOLERANCE));
        let direction = each!(3, |k| L::select(slides, slip[k] / sliding, slip[k]));
        softening = softening | opening.gt(peak_opening) | sliding.gt(peak_sliding);
        let closed = two * opening * law.tensile_strength / peak_opening;
        let ratio = opening / peak_opening;
        let open = (two * ratio - ratio * ratio) * left * law.tensile_strength;
        let pressure = L::select(opening.lt(zero), closed, open);
        let ratio = sliding / peak_sliding;
        let shear = (two * ratio - ratio * ratio) * left * law.shear_strength;
        let weight = L::splat(*weight);
        let traction = each!(3, |k| weight * (pressure * normal[k] + shear * direction[k]));
        for (force, share) in pair_forces.iter_mut().zip(&shares) {
            *force = each!(3, |k| force[k] + traction[k] * *share * area);
        }
    }
    IntactLanes { pair_forces, softening: softening.bits() }
}

#[inline(always)]
fn dot<L: Lanes>(a: &[L; 3], b: &[L; 3]) -> L {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn size<L: Lanes>(v: &[L; 3]) -> L {
    dot(v, v).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        lanes::{self, Kernel, LANES},
        mechanics::{Vec3, joint3},
        scene::RockJoint,
    };
    use proptest::prelude::*;

    struct Evaluate<'a> {
        law: &'a CohesiveLaw,
        points: &'a Points,
        joints: [[[f64; 3]; 6]; LANES],
    }

    impl Kernel for Evaluate<'_> {
        /// Pair forces of each joint, and whether it softens.
        type Output = [([[f64; 3]; 3], bool); LANES];

        #[inline(always)]
        fn run<L: Lanes>(self) -> Self::Output {
            let joints = &self.joints;
            let corners = [0, 1, 2, 3, 4, 5]
                .map(|i| each!(3, |k| L::new(each!(4, |lane| joints[lane][i][k]))));
            let found = evaluate(&LawLanes::<L>::new(self.law), self.points, &corners);
            each!(4, |lane| {
                let forces = found.pair_forces.map(|f| f.map(|x| x.array()[lane]));
                (forces, found.softening & 1 << lane != 0)
            })
        }
    }

    fn triangle() -> impl Strategy<Value = [[f64; 3]; 3]> {
        prop::array::uniform3(prop::array::uniform3(-1.0..1.0))
    }

    proptest! {
        #[test]
        fn lanes_have_the_bits_of_the_scalar_joint(
            faces in prop::array::uniform4(triangle()),
            gaps in prop::array::uniform4(triangle()),
            reach in prop::sample::select(vec![0.0, 1e-12, 1e-4, 5e-4, 2e-3, 0.1]),
            points in prop::sample::select(vec![Points::THREE, Points::SEVEN, Points::MID_EDGES]),
        ) {
            let law = CohesiveLaw {
                is_cohesive: true,
                tensile_strength: 1e7,
                shear_strength: 1.5e7,
                fracture_energy: 1e4,
                shear_fracture_energy: 2e4,
                cohesion: 0.0,
                friction: 0.6,
                residual_friction: 0.0,
                penalty: 1e10,
                peak_strength: 1e7,
                rock: RockJoint::default(),
                layering: None,
            };
            let joints = each!(4, |lane| {
                let face = faces[lane];
                let across = |i: usize| each!(3, |k| face[i][k] + reach * gaps[lane][i][k]);
                [face[0], face[1], face[2], across(0), across(1), across(2)]
            });
            let kernel = || Evaluate { law: &law, points: &points, joints };
            for found in [lanes::run(kernel()), lanes::run_portable(kernel())] {
                for lane in 0..LANES {
                    let corners = joints[lane].map(Vec3::from);
                    let expected = joint3::evaluate(&law, &points, &corners);
                    let states = joint3::point_states(&law, &points, &corners);
                    let (forces, softens) = found[lane];
                    prop_assert_eq!(softens, states.iter().any(|point| point.damage > 0.0));
                    if !softens {
                        let bits = |f: [f64; 3]| f.map(f64::to_bits);
                        let expected = expected.pair_forces.map(|f| bits(f.into()));
                        prop_assert_eq!(forces.map(bits), expected);
                    }
                }
            }
        }
    }
}
