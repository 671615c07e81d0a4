//! Cohesive joint between two triangle edges (spec `y2d3d.md` D.6).
//!
//! Nodes a, b lie along one side, c faces b and d faces a. Opening and sliding
//! are taken along the middle line at its two ends and its middle; each point
//! softens with the combined damage of the two modes.

use super::{Vec2, softening::remaining_strength};
use crate::{TOLERANCE, scene::CohesiveLaw};

/// Result of one evaluation of a joint.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct JointResponse {
    /// Force carried across the joint at its start, middle and end, N. Node a
    /// loses points 0 and 1 in turn and d gains them; b loses points 1 and 2
    /// and c gains them.
    pub point_forces: [Vec2; 3],
    /// Whether two of the three points have lost all strength.
    pub fails: bool,
}

/// State of a joint for output.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct JointState {
    /// Opening (positive) or overlap (negative) in the middle, m.
    pub opening: f64,
    /// Sliding in the middle, m.
    pub sliding: f64,
    /// Largest damage of the three points, in [0, 1].
    pub damage: f64,
    /// 1 where the damage comes from opening alone, 2 from sliding alone, 1.5
    /// from both alike; 0 without damage.
    pub mode: f64,
}

/// Middle line and relative displacements of a joint.
#[derive(Debug, Clone, Copy)]
struct Geometry {
    /// Length of the middle line, m.
    length: f64,
    /// Direction of the middle line.
    tangent: Vec2,
    opening: [f64; 3],
    sliding: [f64; 3],
}

impl Geometry {
    #[inline]
    fn new([a, b, c, d]: &[Vec2; 4]) -> Self {
        let middle = Vec2::new(0.5 * (b.x + c.x - a.x - d.x), 0.5 * (b.y + c.y - a.y - d.y));
        let length = (middle.x * middle.x + middle.y * middle.y).sqrt();
        let e = Vec2::new(middle.x / (length + TOLERANCE), middle.y / (length + TOLERANCE));
        let (at_start, at_end) = (a - d, b - c);
        let sliding = |delta: Vec2| delta.y * e.y + delta.x * e.x;
        let opening = |delta: Vec2| delta.y * e.x - delta.x * e.y;
        let (s0, s2) = (sliding(at_start), sliding(at_end));
        let (o0, o2) = (opening(at_start), opening(at_end));
        Self {
            length,
            tangent: e,
            opening: [o0, 0.5 * (o0 + o2), o2],
            sliding: [s0, 0.5 * (s0 + s2), s2],
        }
    }
}

/// Opening and sliding at which softening starts and ends.
#[derive(Debug, Clone, Copy)]
struct Limits {
    peak_opening: f64,
    peak_sliding: f64,
    softening_opening: f64,
    softening_sliding: f64,
}

impl Limits {
    #[inline]
    fn new(law: &CohesiveLaw, shear_strength: f64, length: f64) -> Self {
        let peak_opening = 2.0 * length * law.tensile_strength / law.penalty;
        let peak_sliding = 2.0 * length * shear_strength / law.penalty;
        Self {
            peak_opening,
            peak_sliding,
            softening_opening: larger(
                2.0 * peak_opening,
                3.0 * law.fracture_energy / law.tensile_strength,
            ),
            softening_sliding: larger(
                2.0 * peak_sliding,
                3.0 * law.fracture_energy / shear_strength,
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
}

/// Evaluates a joint. `shear_strength` is the joint's current strength, Pa; it
/// is updated by the Mohr-Coulomb law at every point, and the next evaluation
/// starts from what the last point left.
#[inline]
#[must_use]
pub fn evaluate(law: &CohesiveLaw, corners: &[Vec2; 4], shear_strength: &mut f64) -> JointResponse {
    let geometry = Geometry::new(corners);
    let limits = Limits::new(law, *shear_strength, geometry.length);
    let e = geometry.tangent;
    let mut point_forces = [Vec2::zeros(); 3];
    let mut failed_points = 0;
    for (point, point_force) in point_forces.iter_mut().enumerate() {
        let (opening, sliding) = (geometry.opening[point], geometry.sliding[point]);
        let slip = sliding.abs();
        let mut damage = limits.damage(opening, slip);
        if damage >= 1.0 {
            failed_points += 1;
            damage = 1.0;
        }
        let left = remaining_strength(damage);
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
            (2.0 * ratio - ratio * ratio) * left * *shear_strength
        };
        let shear = if sliding < 0.0 { -shear_size } else { shear_size };
        let traction = Vec2::new(shear * e.x - normal * e.y, shear * e.y + normal * e.x);
        let weight = if point == 1 { geometry.length / 3.0 } else { geometry.length / 6.0 };
        *point_force = weight * traction;
    }
    JointResponse { point_forces, fails: failed_points > 1 }
}

impl JointResponse {
    /// Adds the joint's forces to those of its nodes a, b, c, d, point by point.
    #[inline]
    pub fn scatter(&self, nodes: [usize; 4], forces: &mut [Vec2]) {
        let [a, b, c, d] = nodes;
        for (point, force) in self.point_forces.iter().enumerate() {
            if point < 2 {
                forces[a] -= force;
                forces[d] += force;
            }
            if point > 0 {
                forces[b] -= force;
                forces[c] += force;
            }
        }
    }
}

/// State of a joint for output, without changing it.
#[must_use]
pub fn state(law: &CohesiveLaw, corners: &[Vec2; 4], shear_strength: f64) -> JointState {
    let geometry = Geometry::new(corners);
    let limits = Limits::new(law, shear_strength, geometry.length);
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

/// Opening and sliding in the middle of a joint that carries nothing any more, m.
#[must_use]
pub fn separation(corners: &[Vec2; 4]) -> (f64, f64) {
    let geometry = Geometry::new(corners);
    (geometry.opening[1], geometry.sliding[1])
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
            cohesion: 1.2e7,
            friction: 0.6,
            penalty: 1e10,
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
        let response = evaluate(&law(), &corners, &mut strength);
        let mut forces = [Vec2::zeros(); 4];
        response.scatter([0, 1, 2, 3], &mut forces);
        let close = |a: f64, b: f64| assert!((a - b).abs() <= 1e-13 * b.abs(), "{a} against {b}");
        close(forces[0].x, 2_513_371.415_971_21);
        close(forces[0].y, -9_687_874.719_966_04);
        close(forces[1].x, 3_096_572.756_676_33);
        close(forces[2].y, 9_896_192.577_208_26);
        assert_eq!(strength, 1.2e7);
        assert!(!response.fails);
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
        evaluate(&law(), &corners, &mut strength).scatter([0, 1, 2, 3], &mut forces);
        let peak = 2.0 * h * 1e7 / 1e10;
        let ratio = opening / peak;
        let sigma = (2.0 * ratio - ratio * ratio) * 1e7;
        for (node, sign) in [(0, -1.0), (1, -1.0), (2, 1.0), (3, 1.0)] {
            assert!((forces[node].y - sign * h / 2.0 * sigma).abs() < 1e-2);
            assert!(forces[node].x.abs() < 1e-2);
        }
    }
}
