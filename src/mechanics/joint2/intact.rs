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
        Self {
            tensile_strength: L::splat(law.tensile_strength),
            peak_strength: L::splat(law.peak_strength),
            penalty: L::splat(law.penalty),
            friction: L::splat(law.friction),
            cohesion: (law.cohesion > 0.0).then(|| L::splat(law.cohesion)),
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
    let [zero, half, two] = [0.0, 0.5, 2.0].map(L::splat);
    let middle = [0, 1].map(|k| half * (b[k] + c[k] - a[k] - d[k]));
    let length = (middle[0] * middle[0] + middle[1] * middle[1]).sqrt();
    let [ex, ey] = middle.map(|m| m / (length + L::splat(TOLERANCE)));
    let apart = |p: [L; 2], q: [L; 2]| {
        let [x, y] = [p[0] - q[0], p[1] - q[1]];
        [y * ex - x * ey, y * ey + x * ex]
    };
    let (start, end) = (apart(a, d), apart(b, c));
    let middle = [0, 1].map(|k| half * (start[k] + end[k]));
    let points = [start, middle, end];

    let peak_opening = two * length * law.peak_strength / law.penalty;
    let peak_sliding = two * length * strength / law.penalty;
    let softens = |[opening, sliding]: [L; 2]| {
        opening.gt(peak_opening) | sliding.abs().gt(peak_sliding)
    };
    let softening = (softens(start) | softens(middle) | softens(end)).bits();

    let (left, end_weight) = (L::splat(INTACT), length / L::splat(6.0));
    let weights = [end_weight, length / L::splat(3.0), end_weight];
    let mut point_forces = [[zero; 2]; 3];
    for (point, [opening, sliding]) in points.into_iter().enumerate() {
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
        point_forces[point] = [
            weights[point] * (shear * ex - normal * ey),
            weights[point] * (shear * ey + normal * ex),
        ];
    }
    IntactLanes { point_forces, strength, softening }
}
