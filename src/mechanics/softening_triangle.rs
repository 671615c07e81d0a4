//! Triangle that softens with its largest stretch (spec `y2d3d.md` C.2): the
//! kinematics of the elastic triangle, its stress scaled by the damage.

use super::{
    Vec2,
    triangle::{Elasticity, Kinematics, ReferenceShape},
};
use crate::TOLERANCE;
use nalgebra::Matrix2;

/// Damage value that marks a triangle shrunk away from its neighbours.
pub const DETACHED: f64 = -1.0;

/// What the damage state means for one evaluation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Softening {
    /// Share of the stiffness that is lost, in [0, 1].
    pub loss: f64,
    /// Factor on the nodal masses: 1, or 1/r² for a triangle shrunk by r.
    pub mass_factor: f64,
}

/// Largest principal stretch of a left Cauchy-Green tensor, at least 1.
#[must_use]
pub fn largest_stretch(b: &Matrix2<f64>) -> f64 {
    let difference = b[(0, 0)] - b[(1, 1)];
    let squared = 0.5
        * ((b[(0, 0)] + b[(1, 1)])
            + (difference * difference + 4.0 * b[(1, 0)] * b[(0, 1)]).sqrt());
    squared.sqrt().max(1.0)
}

/// Updates `damage` (0 undamaged, grows with the largest stretch, negative
/// once detached) and returns its effect. `shrinkage` is the ratio by which a
/// detached triangle was shrunk.
#[must_use]
pub fn soften(damage: &mut f64, stretch: f64, softening_stretch: f64, shrinkage: f64) -> Softening {
    if *damage > -TOLERANCE {
        let driven = (stretch - 1.0) / softening_stretch;
        if driven > *damage {
            *damage = driven;
        }
        Softening { loss: loss(*damage), mass_factor: 1.0 }
    } else {
        Softening { loss: 0.0, mass_factor: 1.0 / (shrinkage * shrinkage) }
    }
}

/// Share of the stiffness that a damage takes; none from a detached triangle.
#[must_use]
pub fn loss(damage: f64) -> f64 {
    if damage > -TOLERANCE { (damage * damage * damage).min(1.0) } else { 0.0 }
}

/// Cauchy stress, Pa. In extension the volumetric part lacks the factor ½ that
/// the split dialect has in compression: a quirk of the original that is kept.
#[must_use]
pub fn cauchy_stress(
    elasticity: &Elasticity,
    reference: &ReferenceShape,
    kinematics: &Kinematics,
    loss: f64,
) -> Matrix2<f64> {
    let mut stress =
        kinematics.deviator_like(elasticity, reference).map(|component| (1.0 - loss) * component);
    let volumetric = kinematics.volumetric(elasticity, reference);
    let pressure = if kinematics.double_area < reference.double_area {
        volumetric * elasticity.volumetric_share
    } else {
        (1.0 - loss) * volumetric
    };
    stress[(0, 0)] += pressure;
    stress[(1, 1)] += pressure;
    stress
}

/// Corners of a triangle shrunk by `ratio` about its centroid when it
/// detaches; `double_areas` are the undeformed and the current ones.
#[must_use]
pub fn shrunk_corners(corners: &[Vec2; 3], ratio: f64, double_areas: [f64; 2]) -> [Vec2; 3] {
    let centroid = (corners[0] + corners[1] + corners[2]) / 3.0;
    let scale = ratio * (double_areas[0] / double_areas[1]).min(1.0).sqrt();
    std::array::from_fn(|i| centroid + (corners[i] - centroid) * scale)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn uniaxial_stretch_is_found() {
        let f = Matrix2::new(1.2, 0.0, 0.0, 0.9);
        assert!((largest_stretch(&(f * f.transpose())) - 1.2).abs() < 1e-15);
        assert_eq!(largest_stretch(&Matrix2::identity().scale(0.25)), 1.0);
    }

    #[test]
    fn damage_never_heals() {
        let mut damage = 0.0;
        let softened = soften(&mut damage, 1.05, 0.1, 0.9);
        assert!((damage - 0.5).abs() < 1e-12);
        assert!((softened.loss - 0.125).abs() < 1e-12);
        let _ = soften(&mut damage, 1.0, 0.1, 0.9);
        assert!((damage - 0.5).abs() < 1e-12);
    }

    #[test]
    fn detached_triangles_are_stiff_and_heavier() {
        let mut damage = DETACHED;
        let softened = soften(&mut damage, 2.0, 0.1, 0.5);
        assert_eq!(softened, Softening { loss: 0.0, mass_factor: 4.0 });
        assert_eq!(damage, DETACHED);
    }
}
