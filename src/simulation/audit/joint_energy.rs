//! What a joint would give back.

use crate::{
    mechanics::{
        Vec2, Vec3,
        joint2::{self, SplitRules, YGeoRules},
        joint3::{self, Points},
        softening::remaining_strength,
    },
    scene::{CohesiveLaw, CohesiveModel},
};
/// Energy by area of one mode at an opening, J/m²: the integral of the parabola below the peak,
/// what closing along a parabola would give back beyond it.
fn of_mode(way: f64, peak: f64, strength: f64, left: f64) -> f64 {
    if way <= 0.0 {
        // pressed: linear with the parabola's initial slope
        strength * way * way / peak
    } else if way <= peak {
        strength * left * (way * way / peak - way.powi(3) / (3.0 * peak * peak))
    } else {
        strength * left * way * (2.0 / 3.0)
    }
}

/// Recoverable energy of a joint between triangles, J/m.
pub(super) fn of_joint(
    law: &CohesiveLaw,
    model: CohesiveModel,
    corners: &[Vec2; 4],
    shear_strength: f64,
) -> f64 {
    let strength = if shear_strength > 0.0 { shear_strength } else { law.initial_shear_strength() };
    let (points, limits) = match model {
        CohesiveModel::YGeo => joint2::points::<YGeoRules>(law, corners, strength),
        CohesiveModel::Split | CohesiveModel::Classic => {
            joint2::points::<SplitRules>(law, corners, strength)
        }
    };
    let [a, b, c, d] = corners;
    let length = (b + c - a - d).norm() * 0.5;
    let weights = [1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0];
    let energies = points.iter().zip(weights).map(|(point, weight)| {
        let left = remaining_strength(point.damage.min(1.0));
        let opening = of_mode(point.opening, limits.peak_opening, law.tensile_strength, left);
        let sliding = of_mode(point.slip, limits.peak_sliding, strength, left);
        weight * length * (opening + sliding)
    });
    energies.sum()
}

/// Recoverable energy of a joint between tetrahedra, J.
pub(super) fn of_face_joint(law: &CohesiveLaw, points: &Points, corners: &[Vec3; 6]) -> f64 {
    let springs = joint3::springs(law, points, corners);
    let states = joint3::point_states(law, points, corners);
    let energies = springs.iter().zip(&states).map(|(spring, point)| {
        let of = |way: f64, strength: f64| {
            let peak = 2.0 * strength * spring.area / spring.stiffness;
            if strength > 0.0 { of_mode(way, peak, strength, point.left) } else { 0.0 }
        };
        let opening = of(point.opening, law.tensile_strength);
        spring.area * (opening + of(point.sliding, law.shear_strength))
    });
    energies.sum()
}

#[cfg(test)]
mod tests {
    use super::of_mode;

    #[test]
    fn energy_is_the_integral_of_the_parabola_and_goes_on_smoothly() {
        let (peak, strength) = (2e-3, 1e6);
        let steps = 100_000;
        let stress = |way: f64| {
            let ratio = way / peak;
            (2.0 * ratio - ratio * ratio) * strength
        };
        let width = 0.7 * peak / f64::from(steps);
        let sum: f64 = (0..steps).map(|i| stress((f64::from(i) + 0.5) * width) * width).sum();
        assert!((of_mode(0.7 * peak, peak, strength, 1.0) / sum - 1.0).abs() < 1e-9);
        let below = of_mode(peak, peak, strength, 1.0);
        let above = of_mode(peak * (1.0 + 1e-12), peak, strength, 1.0);
        assert!((above / below - 1.0).abs() < 1e-11);
        assert_eq!(of_mode(5.0 * peak, peak, strength, 0.0), 0.0);
    }
}
