//! Potential contact force between two triangles (spec `y2d3d.md` E.3).
//!
//! Each edge of each triangle is cut at the other triangle; along the piece
//! inside, the potential (the smallest area coordinate) is integrated exactly,
//! which gives a normal force distributed to the edge's two nodes and, by area
//! coordinates, to the nodes of the other triangle. The tangential force
//! follows the sliding accumulated on that edge.

use super::friction::PairProperties;
use crate::{TOLERANCE, mechanics::Vec2};

/// Stands for "no distance known".
const FAR: f64 = 1e15;

/// One triangle of a couple.
#[derive(Debug, Clone, Copy)]
pub struct Body {
    /// Current corners, counter-clockwise, m.
    pub corners: [Vec2; 3],
    /// Velocities of the corners, m/s.
    pub velocities: [Vec2; 3],
}

/// Contact forces caused by the edges of one triangle of a couple.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SideForces {
    /// Force on each corner of the triangle whose edges were cut, N.
    pub own: [Vec2; 3],
    /// `reaction[i][m]` is to be subtracted, m after m, from corner `i` of the
    /// other triangle.
    pub reaction: [[Vec2; 3]; 3],
}

impl SideForces {
    /// Adds the forces to those of the nodes in the original's order, which
    /// matters where the two triangles share a node.
    #[inline]
    pub fn scatter(&self, own: &[u32; 3], other: &[u32; 3], forces: &mut [Vec2]) {
        for i in 0..3 {
            forces[own[i] as usize] += self.own[i];
            let force = &mut forces[other[i] as usize];
            for part in &self.reaction[i] {
                *force -= part;
            }
        }
    }
}

/// What a couple does at one instant.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overlap {
    /// Forces from the edges of the target and of the contactor.
    pub sides: [Option<SideForces>; 2],
    /// Whether an edge of either triangle came close enough to be cut, even if
    /// nothing of it lies inside.
    pub near: bool,
    /// Smallest squared distance of an edge start from the other triangle's
    /// most violated edge line, m², among the edges that were not cut.
    pub distance_squared: f64,
}

/// Area coordinates of a triangle's corners in the other triangle:
/// `[i][e]` of corner `i` relative to edge `e` (0 on it, positive inside).
type AreaCoordinates = [[f64; 3]; 3];

/// Piecewise linear potential along the inner piece of an edge.
struct Profile {
    /// Edge parameter and potential of up to five points.
    points: [(f64, f64); 5],
    len: usize,
}

struct Triangle {
    normals: [Vec2; 3],
    double_area: f64,
}

impl Triangle {
    #[inline]
    fn new(corners: &[Vec2; 3]) -> Self {
        let normals = std::array::from_fn(|i| {
            let (from, to) = (corners[i], corners[(i + 1) % 3]);
            Vec2::new(to.y - from.y, from.x - to.x)
        });
        let (a, b) = (corners[1] - corners[0], corners[2] - corners[0]);
        Self { normals, double_area: a.x * b.y - a.y * b.x }
    }

    #[inline]
    fn area_coordinates(&self, corners: &[Vec2; 3], of: &[Vec2; 3]) -> AreaCoordinates {
        of.map(|p| {
            std::array::from_fn(|e| {
                ((corners[e].x - p.x) * self.normals[e].x + (corners[e].y - p.y) * self.normals[e].y)
                    / self.double_area
            })
        })
    }

    /// Squared distance of a point from the edge line it violates most.
    #[inline]
    fn distance_squared(&self, a: &[f64; 3]) -> f64 {
        let m = if a[0] <= a[1] && a[0] <= a[2] {
            0
        } else if a[1] <= a[0] && a[1] <= a[2] {
            1
        } else {
            2
        };
        let n = self.normals[m];
        a[m] * a[m] / ((n.x * n.x + n.y * n.y) / (self.double_area * self.double_area))
    }
}

/// Forces between the `target` (lower element number, index 0 of `bodies`) and
/// the contactor (index 1). `sliding` holds the sliding accumulated on the
/// three edges of the target and the three of the contactor, m².
#[inline]
#[must_use]
pub fn overlap(
    bodies: &[Body; 2],
    pair: &PairProperties,
    dt: f64,
    sliding: &mut [f64; 6],
) -> Overlap {
    let shapes = [Triangle::new(&bodies[0].corners), Triangle::new(&bodies[1].corners)];
    let coordinates = [
        shapes[1].area_coordinates(&bodies[1].corners, &bodies[0].corners),
        shapes[0].area_coordinates(&bodies[0].corners, &bodies[1].corners),
    ];
    let mut result = Overlap { sides: [None, None], near: false, distance_squared: FAR };
    for t in 0..2 {
        let u = 1 - t;
        let mut own: Option<[Vec2; 3]> = None;
        for i in 0..3 {
            let j = (i + 1) % 3;
            let (a, b) = (&coordinates[t][i], &coordinates[t][j]);
            let c = [coordinates[u][0][i], coordinates[u][1][i], coordinates[u][2][i]];
            if is_clear(a, b, &c) {
                let distance = shapes[u].distance_squared(a);
                if distance < result.distance_squared {
                    result.distance_squared = distance;
                }
                continue;
            }
            result.near = true;
            let Some(profile) = Profile::new(a, b) else { continue };
            let forces = own.get_or_insert([Vec2::zeros(); 3]);
            let normal = shapes[t].normals[i];
            let slip = slip_rate(&profile, a, b, &bodies[t], &bodies[u], i, normal);
            let slot = &mut sliding[3 * t + i];
            *slot += slip * dt;
            let (total, at_end) = profile.forces(pair.penalty);
            let at_start = total - at_end;
            let tangential = pair.tangential_force(slot, total);
            let (t_start, t_end) = share(tangential, at_start, at_end, total);
            for (node, n, s) in [(i, at_start, t_start), (j, at_end, t_end)] {
                let f = &mut forces[node];
                f.x = f.x - n * normal.x - s * normal.y;
                f.y = f.y - n * normal.y + s * normal.x;
            }
        }
        result.sides[t] = own.map(|own| SideForces {
            own,
            reaction: std::array::from_fn(|i| {
                std::array::from_fn(|m| own[m] * coordinates[t][m][(i + 1) % 3])
            }),
        });
    }
    result
}

/// Whether an edge lies clear of the other triangle: its line does not cut it,
/// or both ends lie outside one of its edges.
#[inline]
fn is_clear(a: &[f64; 3], b: &[f64; 3], c: &[f64; 3]) -> bool {
    c.iter().all(|&x| x > -TOLERANCE)
        || c.iter().all(|&x| x < TOLERANCE)
        || (0..3).any(|m| a[m] < TOLERANCE && b[m] < TOLERANCE)
}

/// Splits the tangential force like the normal one. A zero normal force, which
/// made the original's result not a number, carries no tangential force.
#[inline]
fn share(tangential: f64, at_start: f64, at_end: f64, total: f64) -> (f64, f64) {
    if total == 0.0 {
        return (0.0, 0.0);
    }
    (tangential * at_start / total, tangential * at_end / total)
}

/// Velocity of the other triangle relative to the edge, along the edge, times
/// the edge's length, m²/s, at the mean of the profile's points.
#[inline]
fn slip_rate(
    profile: &Profile,
    a: &[f64; 3],
    b: &[f64; 3],
    own: &Body,
    other: &Body,
    edge: usize,
    normal: Vec2,
) -> f64 {
    let s = profile.mean_parameter();
    let at: [f64; 3] = std::array::from_fn(|m| a[m] * (1.0 - s) + b[m] * s);
    let (v, w) = (&other.velocities, &own.velocities);
    let end = (edge + 1) % 3;
    let relative: [f64; 2] = std::array::from_fn(|k| {
        (at[0] * v[2][k] + at[1] * v[0][k] + at[2] * v[1][k])
            - ((1.0 - s) * w[edge][k] + s * w[end][k])
    });
    -relative[0] * normal.y + relative[1] * normal.x
}

impl Profile {
    /// Potential along the piece of the edge inside the other triangle;
    /// `a` and `b` are the area coordinates of the edge's ends.
    #[inline]
    fn new(a: &[f64; 3], b: &[f64; 3]) -> Option<Self> {
        let (mut low, mut high) = (0.0f64, 1.0f64);
        for m in 0..3 {
            if a[m] < 0.0 && b[m] > TOLERANCE {
                low = low.max(a[m] / (a[m] - b[m]));
            }
            if a[m] > TOLERANCE && b[m] < 0.0 {
                high = high.min(a[m] / (a[m] - b[m]));
            }
        }
        if high <= low {
            return None;
        }
        let at = |m: usize, s: f64| a[m] + s * (b[m] - a[m]);
        let lowest = |s: f64| at(0, s).min(at(1, s)).min(at(2, s));
        let mut profile = Self { points: [(0.0, 0.0); 5], len: 0 };
        profile.push((low, lowest(low)));
        for (k, l, third) in [(0, 1, 2), (0, 2, 1), (1, 2, 0)] {
            let slope = b[k] - a[k] + a[l] - b[l];
            if slope.abs() > TOLERANCE {
                let s = (a[l] - a[k]) / slope;
                if low < s && s < high && at(k, s) < at(third, s) {
                    profile.push((s, at(k, s)));
                }
            }
        }
        profile.push((high, lowest(high)));
        profile.sort();
        Some(profile)
    }

    #[inline]
    fn push(&mut self, point: (f64, f64)) {
        self.points[self.len] = point;
        self.len += 1;
    }

    /// Exchange sort: points with equal parameters keep the original's order.
    #[inline]
    fn sort(&mut self) {
        for i in 0..self.len {
            for j in i + 1..self.len {
                if self.points[i].0 > self.points[j].0 {
                    self.points.swap(i, j);
                }
            }
        }
    }

    #[inline]
    fn mean_parameter(&self) -> f64 {
        let mut sum = 0.0;
        for point in &self.points[..self.len] {
            sum += point.0;
        }
        sum / self.len as f64
    }

    /// Normal force per unit edge length and its share at the edge's end,
    /// 3·penalty·∫P ds and 3·penalty·∫P s ds by the trapezoid rule, exact for
    /// the piecewise linear potential.
    #[inline]
    fn forces(&self, penalty: f64) -> (f64, f64) {
        let p = &self.points[..self.len];
        let n = self.len - 1;
        let mut total = p[0].1 * (p[1].0 - p[0].0) + p[n].1 * (p[n].0 - p[n - 1].0);
        let mut moment = p[0].1 * (p[1].0 - p[0].0) * (p[1].0 + 2.0 * p[0].0)
            + p[n].1 * (p[n].0 - p[n - 1].0) * (p[n - 1].0 + 2.0 * p[n].0);
        for k in 1..n {
            let (before, here, after) = (p[k - 1].0, p[k].0, p[k + 1].0);
            total += p[k].1 * (after - before);
            moment += p[k].1
                * ((here - before) * (before + 2.0 * here) + (after - here) * (after + 2.0 * here));
        }
        (total * penalty * 1.5, moment * penalty * 0.5)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn worked_example() -> ([Body; 2], PairProperties) {
        let at_rest = [Vec2::zeros(); 3];
        let target = Body {
            corners: [Vec2::new(0.0, 0.0), Vec2::new(2.0, 0.0), Vec2::new(0.0, 2.0)],
            velocities: at_rest,
        };
        let contactor = Body {
            corners: [Vec2::new(0.5, -1.0), Vec2::new(1.5, -1.0), Vec2::new(0.9, 0.3)],
            velocities: [Vec2::new(5.0, 1.0); 3],
        };
        let pair = PairProperties { penalty: 1e6, tangential_penalty: 1e9, friction: 0.3 };
        ([target, contactor], pair)
    }

    /// Worked number J3 of the spec.
    #[test]
    fn forces_equal_the_worked_example() {
        let (bodies, pair) = worked_example();
        let result = overlap(&bodies, &pair, 1e-4, &mut [0.0; 6]);
        let mut forces = [Vec2::zeros(); 6];
        let nodes = [[0, 1, 2], [3, 4, 5]];
        for t in 0..2 {
            if let Some(side) = &result.sides[t] {
                side.scatter(&nodes[t], &nodes[1 - t], &mut forces);
            }
        }
        let expected = [
            (10745.6190259445, 45251.4223941739),
            (15255.8602639964, 41420.1752389622),
            (1557.69230769232, 5192.3076923077),
            (3330.45061447428, -7763.88256713701),
            (-7293.8097405553, -5447.31451979973),
            (-23595.8124715522, -78652.7082385071),
        ];
        for (force, (x, y)) in forces.iter().zip(expected) {
            assert!((force.x - x).abs() < 1e-8 && (force.y - y).abs() < 1e-8, "{force}");
        }
    }

    #[test]
    fn distant_triangles_report_their_distance() {
        let (mut bodies, pair) = worked_example();
        for corner in &mut bodies[1].corners {
            corner.y -= 1.3;
        }
        let result = overlap(&bodies, &pair, 1e-4, &mut [0.0; 6]);
        assert_eq!(result.sides, [None, None]);
        assert!(!result.near);
        assert!((result.distance_squared - 1.0).abs() < 1e-12);
    }
}
