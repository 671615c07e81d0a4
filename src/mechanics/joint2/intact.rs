//! Joints of the split dialect, four at a time, as long as none of their points softens: the
//! bits of [`super::evaluate`] at zero damage.

use super::super::softening::INTACT;
use crate::{
    TOLERANCE,
    lanes::{Lanes, Mask as _},
    scene::CohesiveLaw,
};

/// Constants of a cohesive law in all lanes.
#[derive(Debug, Clone, Copy)]
pub struct LawLanes<L> {
    tensile_strength: L,
    peak_strength: L,
    penalty: L,
    friction: L,
    /// Cohesion, Pa, if shear strengths follow the Mohr-Coulomb law.
    cohesion: Option<L>,
}

impl<L: Lanes> LawLanes<L> {
    /// The same constants in all lanes.
    #[inline(always)]
    pub fn new(law: &CohesiveLaw) -> Self {
        let cohesion = if law.cohesion > 0.0 { Some(L::splat(law.cohesion)) } else { None };
        Self {
            tensile_strength: L::splat(law.tensile_strength),
            peak_strength: L::splat(law.peak_strength),
            penalty: L::splat(law.penalty),
            friction: L::splat(law.friction),
            cohesion,
        }
    }
}

/// What four joints exert.
#[derive(Debug, Clone, Copy)]
pub struct IntactLanes<L> {
    /// Force at the start, the middle and the end, N.
    pub point_forces: [[L; 2]; 3],
    /// Shear strength afterwards, Pa.
    pub strength: L,
    /// Bit `i` is set where joint `i` softens, so that all that is given for it is void.
    pub softening: u32,
}

/// Evaluates four joints with nodes a, b, c, d.
#[inline(always)]
pub fn evaluate<L: Lanes>(
    law: &LawLanes<L>,
    [a, b, c, d]: [[L; 2]; 4],
    mut strength: L,
) -> IntactLanes<L> {
    // no closures here: code for the lanes would not be part of this function any more
    let (zero, half, two) = (L::splat(0.0), L::splat(0.5), L::splat(2.0));
    let mx = half * (b[0] + c[0] - a[0] - d[0]);
    let my = half * (b[1] + c[1] - a[1] - d[1]);
    let length = (mx * mx + my * my).sqrt();
    let divisor = length + L::splat(TOLERANCE);
    let tangent = [mx / divisor, my / divisor];
    let (start, end) = (apart(a, d, tangent), apart(b, c, tangent));
    let middle = [half * (start[0] + end[0]), half * (start[1] + end[1])];

    let peak_opening = two * length * law.peak_strength / law.penalty;
    let peak_sliding = two * length * strength / law.penalty;
    let opens = start[0].gt(peak_opening) | middle[0].gt(peak_opening) | end[0].gt(peak_opening);
    let slides = start[1].abs().gt(peak_sliding)
        | middle[1].abs().gt(peak_sliding)
        | end[1].abs().gt(peak_sliding);

    // half of a third has the bits of a sixth: no length but 0 is so small that halving rounds
    let third = length / L::splat(3.0);
    let sixth = half * third;
    let points = [(start, sixth), (middle, third), (end, sixth)];
    let (left, [ex, ey]) = (L::splat(INTACT), tangent);
    let mut point_forces = [[zero; 2]; 3];
    for point in 0..3 {
        let ([opening, sliding], weight) = points[point];
        let closed = opening.lt(zero);
        let size = L::select(closed, two * opening * law.tensile_strength, opening);
        let ratio = size / peak_opening;
        let open = (two * ratio - ratio * ratio) * left * law.tensile_strength;
        let normal = L::select(closed, ratio, open);
        if let Some(cohesion) = law.cohesion {
            let pressed = cohesion - normal * law.friction;
            strength = L::select(normal.gt(zero), cohesion, pressed);
        }
        let ratio = sliding.abs() / peak_sliding;
        let size = (two * ratio - ratio * ratio) * left * strength;
        let shear = L::select(sliding.lt(zero), -size, size);
        point_forces[point] =
            [weight * (shear * ex - normal * ey), weight * (shear * ey + normal * ex)];
    }
    IntactLanes { point_forces, strength, softening: (opens | slides).bits() }
}

/// Opening and sliding of two points.
#[inline(always)]
fn apart<L: Lanes>(p: [L; 2], q: [L; 2], [ex, ey]: [L; 2]) -> [L; 2] {
    let (x, y) = (p[0] - q[0], p[1] - q[1]);
    [y * ex - x * ey, y * ey + x * ex]
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{
        lanes::{self, Kernel, LANES},
        mechanics::{
            Vec2,
            joint2::{self, SplitRules},
        },
        scene::RockJoint,
    };
    use proptest::prelude::*;

    /// Nodes a, b, c, d of four joints.
    type Joints = [[[f64; 2]; 4]; LANES];

    struct Evaluate<'a> {
        law: &'a CohesiveLaw,
        joints: &'a Joints,
        strength: [f64; LANES],
    }

    impl Kernel for Evaluate<'_> {
        /// Point forces of each joint, its strength and whether it softens.
        type Output = [([[f64; 2]; 3], f64, bool); LANES];

        #[inline(always)]
        fn run<L: Lanes>(self) -> Self::Output {
            let corners =
                [0, 1, 2, 3].map(|i| L::pairs([0, 1, 2, 3].map(|lane| &self.joints[lane][i])));
            let law = LawLanes::<L>::new(self.law);
            let response = evaluate(&law, corners, L::load(&self.strength));
            let forces = response.point_forces.map(|f| f.map(L::array));
            let strength = response.strength.array();
            std::array::from_fn(|lane| {
                let forces = forces.map(|f| f.map(|component| component[lane]));
                (forces, strength[lane], response.softening & 1 << lane != 0)
            })
        }
    }

    proptest! {
        #[test]
        fn lanes_have_the_bits_of_the_scalar_joint(
            ends in prop::array::uniform4(prop::array::uniform2(prop::array::uniform2(-2.0..2.0))),
            gaps in prop::array::uniform4(prop::array::uniform2(prop::array::uniform2(-1.0..1.0))),
            reach in prop::sample::select(vec![0.0, 1e-12, 1e-3, 4e-3, 0.1]),
            strength in prop::array::uniform4(1e6..2e7),
            cohesion in prop::sample::select(vec![0.0, 1.2e7]),
        ) {
            let law = CohesiveLaw {
                is_cohesive: true,
                tensile_strength: 1e7,
                shear_strength: 1.5e7,
                fracture_energy: 1e4,
                shear_fracture_energy: 2e4,
                cohesion,
                friction: 0.6,
                residual_friction: 0.0,
                penalty: 1e10,
                peak_strength: 1.1e7,
                rock: RockJoint::default(),
                layering: None,
            };
            let joints: Joints = std::array::from_fn(|lane| {
                let [a, b] = ends[lane];
                let faces = |p: [f64; 2], gap: [f64; 2]| [0, 1].map(|k| p[k] + reach * gap[k]);
                [a, b, faces(b, gaps[lane][0]), faces(a, gaps[lane][1])]
            });
            let kernel = || Evaluate { law: &law, joints: &joints, strength };
            for lanes in [lanes::run(kernel()), lanes::run_portable(kernel())] {
                for lane in 0..LANES {
                    let mut left = strength[lane];
                    let corners = joints[lane].map(Vec2::from);
                    let response =
                        joint2::evaluate::<SplitRules>(&law, &corners, &mut left, None);
                    let (forces, strength, softens) = lanes[lane];
                    prop_assert_eq!(softens, response.softens);
                    if !softens {
                        let bits = |f: [f64; 2]| f.map(f64::to_bits);
                        let expected = response.point_forces.map(|f| bits(f.into()));
                        prop_assert_eq!(forces.map(bits), expected);
                        prop_assert_eq!(strength.to_bits(), left.to_bits());
                    }
                }
            }
        }
    }
}
