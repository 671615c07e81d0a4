//! The cohesive law of the classic dialect (spec `mechanics.md` 4.2).
//!
//! Unlike the other dialects it keeps a strength for each point, updates it
//! before it is used, measures damage differently in mixed and in single mode,
//! and leaves residual friction to a joint that slides in compression.

use super::{
    super::{Vec2, softening::remaining_strength},
    JointResponse, JointState,
    geometry::Geometry,
};
use crate::scene::CohesiveLaw;

/// A point of a joint at one instant.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct PointState {
    /// Damage before clamping to 1.
    pub damage: f64,
    /// Failure mode if the joint fails here: 1 in tension, 2 in shear, up to
    /// 1 + π/2 in both.
    pub mode: f64,
}

struct Limits {
    peak_opening: f64,
    peak_sliding: f64,
    end_opening: f64,
    end_sliding: f64,
}

impl Limits {
    fn new(law: &CohesiveLaw, strength: f64, length: f64) -> Self {
        let peak_opening = 2.0 * length * law.tensile_strength / law.penalty;
        let peak_sliding = 2.0 * length * strength / law.penalty;
        Self {
            peak_opening,
            peak_sliding,
            end_opening: larger(
                2.0 * peak_opening,
                3.0 * law.fracture_energy / law.tensile_strength,
            ),
            end_sliding: larger(2.0 * peak_sliding, 3.0 * law.shear_fracture_energy / strength),
        }
    }

    fn point(&self, opening: f64, slip: f64) -> PointState {
        let beyond_opening = opening - self.peak_opening;
        let beyond_sliding = slip - self.peak_sliding;
        let damage = match (opening > self.peak_opening, slip > self.peak_sliding) {
            (true, true) => {
                let a = beyond_opening / self.end_opening;
                let b = beyond_sliding / self.end_sliding;
                (a * a + b * b).sqrt()
            }
            (true, false) => (beyond_opening / (self.end_opening - self.peak_opening)).abs(),
            (false, true) => beyond_sliding / (self.end_sliding - self.peak_sliding),
            (false, false) => 0.0,
        };
        let mode = if slip <= self.peak_sliding {
            1.0
        } else if opening <= self.peak_opening {
            2.0
        } else {
            1.0 + ((beyond_sliding / (self.end_sliding - self.peak_sliding))
                / (beyond_opening / (self.end_opening - self.peak_opening)))
                .atan()
        };
        PointState { damage, mode }
    }
}

/// Evaluates a joint. `strengths` are the shear strengths of its three points,
/// Pa; each is updated by the Mohr-Coulomb law. Returns the forces and the state
/// of each point.
#[must_use]
pub fn evaluate(
    law: &CohesiveLaw,
    corners: &[Vec2; 4],
    strengths: &mut [f64; 3],
) -> (JointResponse, [PointState; 3]) {
    let geometry = Geometry::new(corners);
    let mut response = JointResponse::default();
    let mut states = [PointState::default(); 3];
    let mut failed_points = 0;
    for point in 0..3 {
        let (opening, sliding) = (geometry.opening[point], geometry.sliding[point]);
        let slip = sliding.abs();
        let strength = &mut strengths[point];
        let limits = Limits::new(law, *strength, geometry.length);
        states[point] = limits.point(opening, slip);
        let mut damage = states[point].damage;
        response.softens |= damage > 0.0;
        if damage >= 1.0 {
            failed_points += 1;
            damage = 1.0;
            if failed_points == 2 {
                response.failed_point = Some(point as u8);
            }
        }
        let left = remaining_strength(damage);
        let normal = if opening < 0.0 {
            2.0 * opening * law.tensile_strength / limits.peak_opening
        } else if opening > limits.peak_opening {
            law.tensile_strength * left
        } else {
            let ratio = opening / limits.peak_opening;
            (2.0 * ratio - ratio * ratio) * law.tensile_strength
        };
        *strength = -smaller(normal, law.tensile_strength) * law.friction + law.cohesion;
        let shear_size = if slip > limits.peak_sliding {
            if normal > 0.0 {
                left * *strength
            } else {
                let residual = law.residual_friction * normal;
                left * (*strength + residual) - residual
            }
        } else {
            let ratio = slip / limits.peak_sliding;
            (2.0 * ratio - ratio * ratio) * *strength
        };
        let shear = if sliding < 0.0 { -shear_size } else { shear_size };
        response.point_forces[point] = geometry.point_force(point, normal, shear);
    }
    (response, states)
}

/// State of a joint for output, without changing it.
#[must_use]
pub fn state(law: &CohesiveLaw, corners: &[Vec2; 4], mut strengths: [f64; 3]) -> JointState {
    let (opening, sliding) = super::separation(corners);
    let (_, points) = evaluate(law, corners, &mut strengths);
    let worst = points.into_iter().fold(PointState::default(), |worst, point| {
        if point.damage > worst.damage { point } else { worst }
    });
    let mode = if worst.damage > 0.0 { worst.mode } else { 0.0 };
    JointState { opening, sliding, damage: worst.damage.min(1.0), mode }
}

/// The larger of two numbers as the original's macro has it.
fn larger(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

fn smaller(a: f64, b: f64) -> f64 {
    if a > b { b } else { a }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law() -> CohesiveLaw {
        CohesiveLaw {
            is_cohesive: true,
            tensile_strength: 1e6,
            shear_strength: 0.0,
            fracture_energy: 2.0,
            shear_fracture_energy: 8.0,
            cohesion: 2e6,
            friction: 0.6,
            residual_friction: 0.5,
            penalty: 1e11,
            peak_strength: 1e6,
            rock: crate::scene::RockJoint::default(),
            layering: None,
        }
    }

    /// Worked example C of spec `mechanics.md` 10: softening in opening.
    #[test]
    fn opening_beyond_the_peak_softens_as_in_the_worked_example() {
        let corners =
            [Vec2::new(0.0, 3e-6), Vec2::new(0.1, 5e-6), Vec2::new(0.1, 0.0), Vec2::new(0.0, 0.0)];
        let mut strengths = [2e6; 3];
        let (response, states) = evaluate(&law(), &corners, &mut strengths);
        for (state, expected) in states.iter().zip([0.25, 0.5, 0.75]) {
            assert!((state.damage - expected).abs() < 1e-6, "{state:?}");
        }
        // σ of each point: force over weight
        for (point, (weight, sigma)) in [
            (6.0, 587_841.705_572_964_2),
            (3.0, 304_138.074_955_286_3),
            (6.0, 150_054.018_226_845_8),
        ]
        .into_iter()
        .enumerate()
        {
            let found = response.point_forces[point].y * weight / 0.1;
            assert!((found - sigma).abs() < 1e-2, "{found} against {sigma}");
        }
    }

    /// Worked example E: sliding in compression keeps residual friction.
    #[test]
    fn sliding_in_compression_keeps_residual_friction() {
        let corners = [
            Vec2::new(6e-6, -1e-6),
            Vec2::new(0.1 + 6e-6, -2e-6),
            Vec2::new(0.1, 0.0),
            Vec2::new(0.0, 0.0),
        ];
        let mut strengths = [2e6; 3];
        let (response, _) = evaluate(&law(), &corners, &mut strengths);
        assert!((strengths[0] - 2_599_981.999_385_018).abs() < 1e-2, "{}", strengths[0]);
        let shear = response.point_forces[0].x * 6.0 / 0.1;
        assert!((shear - 1_734_448.595_535_887).abs() < 30.0, "{shear}");
    }
}
