//! The traction-separation law of the split dialect and of Y-Geo (spec
//! `y2d3d.md` D.6, `mechanics.md` 4.3): limits from the strength that the last
//! point left, damage consistent over the modes, damage times parabola.

use super::{
    super::{Vec2, softening::remaining_strength},
    JointResponse, JointState,
    geometry::Geometry,
};
use crate::{TOLERANCE, scene::CohesiveLaw};

/// In what the split dialect and Y-Geo differ.
pub trait Rules {
    /// Softening extent of a mode, m, from its peak and its critical extent 3G/f.
    fn softening_extent(peak: f64, critical: f64) -> f64;
    /// Shear stress below the peak, Pa, under the given normal stress.
    fn shear_below_peak(parabola: f64, left: f64, strength: f64, normal: f64) -> f64;
}

/// Rules of the split dialect.
#[derive(Debug, Clone, Copy)]
pub struct SplitRules;

/// Rules of Y-Geo.
#[derive(Debug, Clone, Copy)]
pub struct YGeoRules;

impl Rules for SplitRules {
    #[inline(always)]
    fn softening_extent(peak: f64, critical: f64) -> f64 {
        larger(2.0 * peak, critical)
    }

    #[inline(always)]
    fn shear_below_peak(parabola: f64, left: f64, strength: f64, _normal: f64) -> f64 {
        parabola * left * strength
    }
}

impl Rules for YGeoRules {
    #[inline(always)]
    fn softening_extent(_peak: f64, critical: f64) -> f64 {
        larger(TOLERANCE, critical)
    }

    #[inline(always)]
    fn shear_below_peak(parabola: f64, left: f64, strength: f64, normal: f64) -> f64 {
        // same terms, rounded in another order
        if normal > 0.0 { parabola * left * strength } else { parabola * (left * strength) }
    }
}

/// Opening and sliding at which softening starts and ends.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Opening at the tensile strength, m.
    pub peak_opening: f64,
    /// Sliding at the shear strength, m.
    pub peak_sliding: f64,
    /// Opening beyond the peak at which nothing is left, m.
    pub softening_opening: f64,
    /// Sliding beyond the peak at which nothing is left, m.
    pub softening_sliding: f64,
}

impl Limits {
    #[inline]
    fn new<R: Rules>(law: &CohesiveLaw, shear_strength: f64, length: f64) -> Self {
        let peak_opening = 2.0 * length * law.peak_strength / law.penalty;
        let peak_sliding = 2.0 * length * shear_strength / law.penalty;
        Self {
            peak_opening,
            peak_sliding,
            softening_opening: R::softening_extent(
                peak_opening,
                3.0 * law.fracture_energy / law.peak_strength,
            ),
            softening_sliding: R::softening_extent(
                peak_sliding,
                3.0 * law.shear_fracture_energy / shear_strength,
            ),
        }
    }

    /// Damage before clamping to 1.
    #[inline]
    fn damage(&self, opening: f64, slip: f64) -> f64 {
        let in_opening = (opening - self.peak_opening) / self.softening_opening;
        let in_sliding = (slip - self.peak_sliding) / self.softening_sliding;
        match (opening > self.peak_opening, slip > self.peak_sliding) {
            (true, true) => (in_opening * in_opening + in_sliding * in_sliding).sqrt(),
            (true, false) => in_opening,
            (false, true) => in_sliding,
            (false, false) => 0.0,
        }
    }

    /// Share of the strength left at damage `damage` when the largest damage so
    /// far is `largest`, which is updated: unloading is linear in the opening.
    fn left_after(&self, damage: f64, largest: &mut f64) -> f64 {
        if damage >= *largest {
            *largest = damage;
            return remaining_strength(damage);
        }
        let at = |d: f64| self.peak_opening + d * self.softening_opening;
        (at(damage) / at(*largest)) * remaining_strength(*largest)
    }
}

/// Evaluates a joint. `shear_strength` is the joint's current strength, Pa; it
/// is updated by the Mohr-Coulomb law at every point, and the next evaluation
/// starts from what the last point left. `largest_damage` of the three points
/// makes unloading hysteretic.
#[inline]
#[must_use]
pub fn evaluate<R: Rules>(
    law: &CohesiveLaw,
    corners: &[Vec2; 4],
    shear_strength: &mut f64,
    mut largest_damage: Option<&mut [f64; 3]>,
) -> JointResponse {
    let geometry = Geometry::new(corners);
    let limits = Limits::new::<R>(law, *shear_strength, geometry.length);
    let mut response = JointResponse::default();
    let mut failed_points = 0;
    for point in 0..3 {
        let (opening, sliding) = (geometry.opening[point], geometry.sliding[point]);
        let slip = sliding.abs();
        let mut damage = limits.damage(opening, slip);
        response.softens |= damage > 0.0;
        if damage >= 1.0 {
            failed_points += 1;
            damage = 1.0;
            if failed_points == 2 {
                response.failed_point = Some(point as u8);
            }
        }
        let left = match &mut largest_damage {
            None => remaining_strength(damage),
            Some(largest) => limits.left_after(damage, &mut largest[point]),
        };
        let normal = if opening < 0.0 {
            2.0 * opening * law.tensile_strength / limits.peak_opening
        } else if opening > limits.peak_opening {
            law.tensile_strength * left
        } else {
            let ratio = opening / limits.peak_opening;
            (2.0 * ratio - ratio * ratio) * left * law.tensile_strength
        };
        if law.cohesion > 0.0 {
            *shear_strength =
                if normal > 0.0 { law.cohesion } else { law.cohesion - normal * law.friction };
        }
        let shear_size = if slip > limits.peak_sliding {
            left * *shear_strength
        } else {
            let ratio = slip / limits.peak_sliding;
            R::shear_below_peak(2.0 * ratio - ratio * ratio, left, *shear_strength, normal)
        };
        let shear = if sliding < 0.0 { -shear_size } else { shear_size };
        response.point_forces[point] = geometry.point_force(point, normal, shear);
    }
    response
}

/// Where a point of a joint stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointState {
    /// Opening, m.
    pub opening: f64,
    /// Sliding without sign, m.
    pub slip: f64,
    /// Damage, not clamped.
    pub damage: f64,
}

impl PointState {
    /// How a joint that fails here fails: 1 in opening, 2 in sliding, 3 where
    /// both are used up, between them where only both together are.
    #[must_use]
    pub fn failure_mode(&self, limits: &Limits) -> f64 {
        let opened = self.opening >= limits.peak_opening + limits.softening_opening;
        let slid = self.slip >= limits.peak_sliding + limits.softening_sliding;
        match (opened, slid) {
            (true, true) => 3.0,
            (true, false) => 1.0,
            (false, true) => 2.0,
            (false, false) => 1.0 + (self.slip - limits.peak_sliding) / limits.softening_sliding,
        }
    }
}

/// The three points of a joint and their limits, without changing it.
#[must_use]
pub fn points<R: Rules>(
    law: &CohesiveLaw,
    corners: &[Vec2; 4],
    shear_strength: f64,
) -> ([PointState; 3], Limits) {
    let geometry = Geometry::new(corners);
    let limits = Limits::new::<R>(law, shear_strength, geometry.length);
    let point = |i: usize| {
        let (opening, slip) = (geometry.opening[i], geometry.sliding[i].abs());
        PointState { opening, slip, damage: limits.damage(opening, slip) }
    };
    ([point(0), point(1), point(2)], limits)
}

/// State of a joint for output, without changing it.
#[must_use]
pub fn state<R: Rules>(law: &CohesiveLaw, corners: &[Vec2; 4], shear_strength: f64) -> JointState {
    let geometry = Geometry::new(corners);
    let limits = Limits::new::<R>(law, shear_strength, geometry.length);
    let (mut damage, mut mode) = (0.0, 0.0);
    for (&opening, sliding) in geometry.opening.iter().zip(geometry.sliding) {
        let at_point = limits.damage(opening, sliding.abs()).min(1.0);
        if at_point > damage {
            let in_opening = (opening - limits.peak_opening) / limits.softening_opening;
            let in_sliding = (sliding.abs() - limits.peak_sliding) / limits.softening_sliding;
            let angle = in_sliding.max(0.0).atan2(in_opening.max(0.0));
            (damage, mode) = (at_point, 1.0 + angle / std::f64::consts::FRAC_PI_2);
        }
    }
    JointState { opening: geometry.opening[1], sliding: geometry.sliding[1], damage, mode }
}

/// The larger of two numbers, the second if they do not compare.
#[inline]
fn larger(a: f64, b: f64) -> f64 {
    if a > b { a } else { b }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn law() -> CohesiveLaw {
        CohesiveLaw {
            is_cohesive: true,
            tensile_strength: 1e7,
            shear_strength: 1.5e7,
            fracture_energy: 1e4,
            shear_fracture_energy: 1e4,
            cohesion: 1.2e7,
            friction: 0.6,
            residual_friction: 0.0,
            penalty: 1e10,
            peak_strength: 1e7,
            rock: crate::scene::RockJoint::default(),
            layering: None,
        }
    }

    /// Worked number J2 of the spec.
    #[test]
    fn forces_equal_the_worked_example() {
        let corners = [
            Vec2::new(0.0, 0.003),
            Vec2::new(2.0, 0.004),
            Vec2::new(2.001, 0.0),
            Vec2::new(0.0005, 0.0),
        ];
        let mut strength = law().initial_shear_strength();
        let response = evaluate::<SplitRules>(&law(), &corners, &mut strength, None);
        let mut forces = [Vec2::zeros(); 4];
        response.scatter([0, 1, 2, 3], &mut forces);
        let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-13 * b.abs(), "{a} against {b}");
        close(forces[0].x, 2_513_371.415_971_21);
        close(forces[0].y, -9_687_874.719_966_04);
        close(forces[1].x, 3_096_572.756_676_33);
        close(forces[2].y, 9_896_192.577_208_26);
        assert_eq!(strength, 1.2e7);
        assert_eq!(response.failed_point, None);
    }

    /// Uniform opening below the peak gives h/2·σ on every node.
    #[test]
    fn uniform_opening_loads_all_nodes_alike() {
        let (h, opening) = (2.0, 1e-3);
        let corners = [
            Vec2::new(0.0, opening),
            Vec2::new(h, opening),
            Vec2::new(h, 0.0),
            Vec2::new(0.0, 0.0),
        ];
        let mut strength = 1.5e7;
        let mut forces = [Vec2::zeros(); 4];
        evaluate::<SplitRules>(&law(), &corners, &mut strength, None)
            .scatter([0, 1, 2, 3], &mut forces);
        let peak = 2.0 * h * 1e7 / 1e10;
        let ratio = opening / peak;
        let sigma = (2.0 * ratio - ratio * ratio) * 1e7;
        for (node, sign) in [(0, -1.0), (1, -1.0), (2, 1.0), (3, 1.0)] {
            assert!((forces[node].y - sign * h / 2.0 * sigma).abs() < 1e-2);
            assert!(forces[node].x.abs() < 1e-2);
        }
    }
}
