//! Cohesive joint between two faces of tetrahedra (spec `y2d3d.md` D.7, `y3d.md` 4).
//!
//! Nodes 0, 1, 2 lie on the upper face, 3, 4, 5 face them on the lower one. Opening and sliding
//! are taken at points of the surface midway; each point softens with the combined damage of the
//! two modes. Where a law has cohesion (the `.Y3D` lineage), pressure raises the shear strength.

pub mod intact;

use super::{Vec3, softening::remaining_strength};
use crate::{TOLERANCE, scene::CohesiveLaw};

/// Integration points of a joint: their coordinates in the triangle, weights, and how many may
/// lose all strength before the joint fails.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Points {
    /// Shape functions of the three pairs of nodes at each point.
    shapes: &'static [[f64; 3]],
    /// Share of the area that each point stands for.
    weights: &'static [f64],
    /// Points that may have failed while the joint still holds.
    spare: usize,
    /// Which length of the surface turns the penalty into a stiffness.
    length: Length,
}

/// A length of a triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Length {
    ShortestEdge,
    MeanEdge,
}

const SIXTH: f64 = 1.0 / 6.0;
const TWO_THIRDS: f64 = 2.0 / 3.0;
const THIRD: f64 = 1.0 / 3.0;
// decimals as the original has them
const CENTRE: f64 = 0.333_333_333_3;
const EDGE: [f64; 2] = [0.059_715_871_7, 0.470_142_064_1];
const CORNER: [f64; 2] = [0.797_426_985_3, 0.101_286_507_3];

impl Points {
    /// Three points; the joint fails when all have.
    pub const THREE: Self = Self {
        shapes: &[
            shape([TWO_THIRDS, SIXTH, SIXTH]),
            shape([SIXTH, TWO_THIRDS, SIXTH]),
            shape([SIXTH, SIXTH, TWO_THIRDS]),
        ],
        weights: &[THIRD; 3],
        spare: 2,
        length: Length::ShortestEdge,
    };

    /// The middles of the edges; the joint fails when two have (spec `y3d.md` 4.2, 4.4).
    pub const MID_EDGES: Self = Self {
        shapes: &[[0.5, 0.5, 0.0], [0.0, 0.5, 0.5], [0.5, 0.0, 0.5]],
        weights: &[THIRD; 3],
        spare: 1,
        length: Length::MeanEdge,
    };

    /// Seven points; the joint fails when five have.
    pub const SEVEN: Self = Self {
        shapes: &[
            shape([CENTRE; 3]),
            shape([EDGE[0], EDGE[1], EDGE[1]]),
            shape([EDGE[1], EDGE[0], EDGE[1]]),
            shape([EDGE[1], EDGE[1], EDGE[0]]),
            shape([CORNER[0], CORNER[1], CORNER[1]]),
            shape([CORNER[1], CORNER[0], CORNER[1]]),
            shape([CORNER[1], CORNER[1], CORNER[0]]),
        ],
        weights: &[
            0.225,
            0.132_394_152_7,
            0.132_394_152_7,
            0.132_394_152_7,
            0.125_939_180_5,
            0.125_939_180_5,
            0.125_939_180_5,
        ],
        spare: 4,
        length: Length::ShortestEdge,
    };

    /// Number of points.
    #[must_use]
    pub fn count(&self) -> usize {
        self.weights.len()
    }
}

/// Shape functions of the node pairs at a point with coordinates (g1, g2, g3).
const fn shape([g1, g2, g3]: [f64; 3]) -> [f64; 3] {
    [g3, g1, g2]
}

/// Where a point of a joint stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointState {
    /// Opening (positive) or overlap (negative), m.
    pub opening: f64,
    /// Size of the sliding, m.
    pub sliding: f64,
    /// Damage, not clamped.
    pub damage: f64,
    /// Share of the strength that is left.
    pub left: f64,
    /// Normal stress, Pa, positive in tension.
    pub normal: f64,
    /// Shear stress along the sliding, Pa.
    pub shear: f64,
}

/// Result of one evaluation of a joint.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct JointResponse {
    /// Force across the joint at each pair of nodes, N: the upper node loses it, the lower
    /// one gains it.
    pub pair_forces: [Vec3; 3],
    /// Whether so many points have lost all strength that the joint fails.
    pub fails: bool,
}

/// State of a joint for output.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct JointState {
    /// Opening (positive) or overlap (negative) in the middle, m.
    pub opening: f64,
    /// Sliding in the middle, m.
    pub sliding: f64,
    /// Largest damage of the points, in [0, 1].
    pub damage: f64,
    /// 1 where the damage comes from opening alone, 2 from sliding alone, between them where it
    /// comes from both; 0 without damage.
    pub mode: f64,
}

/// Opening and sliding at which softening starts and ends, m.
#[derive(Debug, Clone, Copy)]
struct Limits {
    peak: [f64; 2],
    softening: [f64; 2],
    /// Shear strength, Pa.
    shear_strength: f64,
}

impl Limits {
    #[inline(always)]
    fn new(law: &CohesiveLaw, length: f64) -> Self {
        let of = |strength: f64, energy: f64| {
            let peak = 2.0 * strength / law.penalty * length;
            let (least, critical) = (2.0 * peak, 3.0 * energy / strength);
            (peak, if least > critical { least } else { critical })
        };
        let (opening, opening_end) = of(law.tensile_strength, law.fracture_energy);
        let (sliding, sliding_end) = of(law.shear_strength, law.shear_fracture_energy);
        Self {
            peak: [opening, sliding],
            softening: [opening_end, sliding_end],
            shear_strength: law.shear_strength,
        }
    }

    /// Limits at a point with this opening: pressure raises the shear strength.
    #[inline(always)]
    fn at(&self, law: &CohesiveLaw, length: f64, opening: f64) -> Self {
        if law.cohesion <= 0.0 || opening >= 0.0 {
            return *self;
        }
        let normal = 2.0 * opening * law.tensile_strength / self.peak[0];
        let shear_strength = law.cohesion - law.friction * normal;
        Self::new(&CohesiveLaw { shear_strength, ..law.clone() }, length)
    }

    /// Damage by opening and by sliding, 0 below the peaks.
    #[inline(always)]
    fn damages(&self, opening: f64, sliding: f64) -> [f64; 2] {
        let beyond = |value: f64, k: usize| {
            if value > self.peak[k] { (value - self.peak[k]) / self.softening[k] } else { 0.0 }
        };
        [beyond(opening, 0), beyond(sliding, 1)]
    }

    /// Damage before clamping to 1.
    #[inline(always)]
    fn damage(&self, opening: f64, sliding: f64) -> f64 {
        let [o, s] = self.damages(opening, sliding);
        match (o > 0.0, s > 0.0) {
            (true, true) => (o * o + s * s).sqrt(),
            (true, false) => o,
            _ => s,
        }
    }
}

/// The surface midway between the two faces.
struct Surface {
    normal: Vec3,
    area: f64,
    /// Shortest or mean edge, m.
    length: f64,
    /// Upper node minus lower node of each pair.
    gaps: [Vec3; 3],
}

impl Surface {
    #[inline(always)]
    fn new(corners: &[Vec3; 6], of: Length) -> Self {
        let middle = |i: usize| 0.5 * (corners[i] + corners[i + 3]);
        let (a, b) = (middle(1) - middle(0), middle(2) - middle(0));
        let mut length = size(a);
        for other in [size(b), size(b - a)] {
            if other < length {
                length = other;
            }
        }
        if of == Length::MeanEdge {
            length = (size(a) + size(b) + size(b - a)) / 3.0;
        }
        let cross = Vec3::new(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
        let double_area = size(cross);
        let normal = if double_area > TOLERANCE { cross / double_area } else { cross };
        let gaps = std::array::from_fn(|i| corners[i] - corners[i + 3]);
        Self { normal, area: 0.5 * double_area, length, gaps }
    }

    /// Opening, and the sliding as a vector.
    #[inline(always)]
    fn gap(&self, shape: &[f64; 3]) -> (f64, Vec3) {
        let [a, b, c] = shape;
        let gap = *a * self.gaps[0] + *b * self.gaps[1] + *c * self.gaps[2];
        let opening = dot(gap, self.normal);
        (opening, gap - opening * self.normal)
    }
}

#[inline(always)]
fn dot(a: Vec3, b: Vec3) -> f64 {
    a.x * b.x + a.y * b.y + a.z * b.z
}

#[inline(always)]
fn size(v: Vec3) -> f64 {
    dot(v, v).sqrt()
}

/// State of one point, and the direction of its sliding.
#[inline(always)]
fn at_point(
    law: &CohesiveLaw,
    limits: &Limits,
    surface: &Surface,
    shape: &[f64; 3],
) -> (PointState, Vec3) {
    let (opening, slip) = surface.gap(shape);
    let sliding = size(slip);
    let direction = if sliding > TOLERANCE { slip / sliding } else { slip };
    let limits = &limits.at(law, surface.length, opening);
    let damage = limits.damage(opening, sliding);
    let left = remaining_strength(if damage >= 1.0 { 1.0 } else { damage });
    let [peak_opening, peak_sliding] = limits.peak;
    let normal = if opening < 0.0 {
        2.0 * opening * law.tensile_strength / peak_opening
    } else if opening > peak_opening {
        law.tensile_strength * left
    } else {
        let ratio = opening / peak_opening;
        (2.0 * ratio - ratio * ratio) * left * law.tensile_strength
    };
    let shear = if sliding > peak_sliding {
        left * limits.shear_strength
    } else {
        let ratio = sliding / peak_sliding;
        (2.0 * ratio - ratio * ratio) * left * limits.shear_strength
    };
    (PointState { opening, sliding, damage, left, normal, shear }, direction)
}

/// Evaluates a joint. Nodes 0, 1, 2 of `corners` face 3, 4, 5.
#[inline]
#[must_use]
pub fn evaluate(law: &CohesiveLaw, points: &Points, corners: &[Vec3; 6]) -> JointResponse {
    let surface = Surface::new(corners, points.length);
    let limits = Limits::new(law, surface.length);
    let mut response = JointResponse::default();
    let mut failed = 0;
    for (shape, weight) in points.shapes.iter().zip(points.weights) {
        let (point, direction) = at_point(law, &limits, &surface, shape);
        if point.damage >= 1.0 {
            failed += 1;
        }
        let traction = point.normal * surface.normal + point.shear * direction;
        for (force, share) in response.pair_forces.iter_mut().zip(shape) {
            *force += *weight * traction * *share * surface.area;
        }
    }
    response.fails = failed > points.spare;
    response
}

/// An integration point of a joint that has not moved yet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointSpring {
    /// Shape functions of the three pairs of nodes.
    pub shape: [f64; 3],
    /// Area that it stands for, m².
    pub area: f64,
    /// Initial stiffness in all directions, N/m: the parabolas of both modes begin with the
    /// penalty by a length of the surface.
    pub stiffness: f64,
}

/// The integration points of a joint as springs.
#[must_use]
pub fn springs(law: &CohesiveLaw, points: &Points, corners: &[Vec3; 6]) -> Vec<PointSpring> {
    let surface = Surface::new(corners, points.length);
    let pairs = points.shapes.iter().zip(points.weights);
    let spring = |(shape, weight): (&[f64; 3], &f64)| {
        let area = weight * surface.area;
        PointSpring { shape: *shape, area, stiffness: law.penalty / surface.length * area }
    };
    pairs.map(spring).collect()
}

/// State of each integration point.
#[must_use]
pub fn point_states(law: &CohesiveLaw, points: &Points, corners: &[Vec3; 6]) -> Vec<PointState> {
    let surface = Surface::new(corners, points.length);
    let limits = Limits::new(law, surface.length);
    points.shapes.iter().map(|shape| at_point(law, &limits, &surface, shape).0).collect()
}

/// State for output, without changing the joint.
#[must_use]
pub fn state(law: &CohesiveLaw, points: &Points, corners: &[Vec3; 6]) -> JointState {
    let surface = Surface::new(corners, points.length);
    let limits = Limits::new(law, surface.length);
    let (opening, slip) = surface.gap(&[THIRD; 3]);
    let mut state = JointState { opening, sliding: size(slip), ..JointState::default() };
    for shape in points.shapes {
        let (opening, slip) = surface.gap(shape);
        let limits = limits.at(law, surface.length, opening);
        let [o, s] = limits.damages(opening, size(slip));
        let damage = limits.damage(opening, size(slip));
        if damage > state.damage {
            state.damage = damage;
            state.mode = (o + 2.0 * s) / (o + s);
        }
    }
    state.damage = state.damage.min(1.0);
    state
}

/// Opening and sliding in the middle of a joint that carries nothing any more, m.
#[must_use]
pub fn separation(corners: &[Vec3; 6]) -> (f64, f64) {
    let (opening, slip) = Surface::new(corners, Length::ShortestEdge).gap(&[THIRD; 3]);
    (opening, size(slip))
}

/// Area of the surface midway, m².
#[must_use]
pub fn area(corners: &[Vec3; 6]) -> f64 {
    Surface::new(corners, Length::ShortestEdge).area
}

#[cfg(test)]
mod tests;
