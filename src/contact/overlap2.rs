//! Potential contact force between two triangles (spec `y2d3d.md` E.3).
//!
//! Each edge of each triangle is cut at the other triangle; along the piece
//! inside, the potential (the smallest area coordinate) is integrated exactly,
//! which gives a normal force distributed to the edge's two nodes and, by area
//! coordinates, to the nodes of the other triangle. The tangential force
//! follows the sliding accumulated on that edge.

use super::friction::PairProperties;
use crate::{TOLERANCE, mechanics::Vec2};
use wide::{CmpGt, CmpLt, f64x2};

/// Stands for "no distance known".
const FAR: f64 = 1e15;

/// Contact forces caused by the edges of one triangle of a couple.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SideForces {
    /// Whether there are any.
    pub acts: bool,
    /// Force on each corner of the triangle whose edges were cut, N.
    pub own: [Vec2; 3],
    /// Area coordinates of those corners in the other triangle: the share of
    /// `own[m]` that corner `i` of the other triangle has to bear is
    /// `shares[m][(i + 1) % 3]`.
    pub shares: AreaCoordinates,
}

impl SideForces {
    /// Adds the forces to those of the nodes in the original's order, which
    /// matters where the two triangles share a node.
    #[inline]
    pub fn scatter(&self, own: &[u32; 3], other: &[u32; 3], forces: &mut [Vec2]) {
        if !self.acts {
            return;
        }
        for i in 0..3 {
            forces[own[i] as usize] += self.own[i];
            let force = &mut forces[other[i] as usize];
            for m in 0..3 {
                let share = self.shares[m][(i + 1) % 3];
                force.x -= self.own[m].x * share;
                force.y -= self.own[m].y * share;
            }
        }
    }
}

/// How close the two triangles of a couple are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Proximity {
    /// An edge of either came close enough to be cut, even if nothing of it
    /// lies inside.
    Near,
    /// No edge was cut.
    Apart {
        /// Smallest squared distance of a corner from the edge line of the
        /// other triangle that it violates most, m².
        distance_squared: f64,
    },
}

/// Area coordinates of a triangle's corners in the other triangle:
/// `[i][e]` of corner `i` relative to edge `e` (0 on it, positive inside).
pub type AreaCoordinates = [[f64; 3]; 3];

/// Piecewise linear potential along the inner piece of an edge.
struct Profile {
    /// Edge parameter and potential of up to five points.
    points: [(f64, f64); 5],
    len: usize,
}

/// Where the corners of two triangles lie relative to each other's edges.
///
/// The two lanes of every vector belong to the two triangles, so that all
/// eighteen area coordinates take nine divisions.
struct Placement {
    /// `[i][e]`: lane `t` is the area coordinate of corner `i` of triangle `t`
    /// relative to edge `e` of the other.
    coordinates: [[f64x2; 3]; 3],
    /// Outward edge normals, as long as the edges: `[i]`, lane `t`.
    normals: [[f64x2; 2]; 3],
    /// Twice the areas.
    double_area: f64x2,
}

impl Placement {
    #[inline(always)]
    fn new(corners: &[[Vec2; 3]; 2]) -> Self {
        let lanes = |i: usize| {
            let (p, q) = (&corners[0][i], &corners[1][i]);
            [f64x2::new([p.x, q.x]), f64x2::new([p.y, q.y])]
        };
        let swapped = |i: usize| {
            let (p, q) = (&corners[1][i], &corners[0][i]);
            [f64x2::new([p.x, q.x]), f64x2::new([p.y, q.y])]
        };
        let (own, other) = ([lanes(0), lanes(1), lanes(2)], [swapped(0), swapped(1), swapped(2)]);
        let normal = |from: [f64x2; 2], to: [f64x2; 2]| [to[1] - from[1], from[0] - to[0]];
        let normals = [normal(own[0], own[1]), normal(own[1], own[2]), normal(own[2], own[0])];
        let other_normals =
            [normal(other[0], other[1]), normal(other[1], other[2]), normal(other[2], other[0])];
        let double = |c: &[[f64x2; 2]; 3]| {
            (c[1][0] - c[0][0]) * (c[2][1] - c[0][1]) - (c[1][1] - c[0][1]) * (c[2][0] - c[0][0])
        };
        let (double_area, other_area) = (double(&own), double(&other));
        let mut coordinates = [[f64x2::ZERO; 3]; 3];
        for i in 0..3 {
            for e in 0..3 {
                coordinates[i][e] = ((other[e][0] - own[i][0]) * other_normals[e][0]
                    + (other[e][1] - own[i][1]) * other_normals[e][1])
                    / other_area;
            }
        }
        Self { coordinates, normals, double_area }
    }

    /// Bit `t` of entry `i`: edge `i` of triangle `t` has to be cut. It lies
    /// clear of the other triangle if its line does not cut it or if both its
    /// ends lie outside one of the other's edges.
    #[inline(always)]
    fn edges_to_cut(&self) -> [u32; 3] {
        let (upper, lower) = (f64x2::splat(TOLERANCE), f64x2::splat(-TOLERANCE));
        let mut below = [[0u32; 3]; 3];
        let mut above = [[0u32; 3]; 3];
        for i in 0..3 {
            for e in 0..3 {
                let c = self.coordinates[i][e];
                below[i][e] = mask(c.cmp_lt(upper));
                above[i][e] = mask(c.cmp_gt(lower));
            }
        }
        let mut cut = [0; 3];
        for i in 0..3 {
            let j = (i + 1) % 3;
            let outside = (below[i][0] & below[j][0])
                | (below[i][1] & below[j][1])
                | (below[i][2] & below[j][2]);
            // where the other triangle's corners lie: the lanes are the other way round
            let line = (below[0][i] & below[1][i] & below[2][i])
                | (above[0][i] & above[1][i] & above[2][i]);
            let swapped = (line >> 1 | line << 1) & 3;
            cut[i] = 3 & !(outside | swapped);
        }
        cut
    }

    /// Area coordinates of corner `i` of triangle `t` in the other triangle.
    #[inline(always)]
    fn of_corner(&self, t: usize, i: usize) -> [f64; 3] {
        let c = &self.coordinates[i];
        [c[0].as_array_ref()[t], c[1].as_array_ref()[t], c[2].as_array_ref()[t]]
    }

    #[inline(always)]
    fn normal(&self, t: usize, i: usize) -> Vec2 {
        Vec2::new(self.normals[i][0].as_array_ref()[t], self.normals[i][1].as_array_ref()[t])
    }

    /// Smallest squared distance of a corner from the edge line of the other
    /// triangle that it violates most, m².
    fn distance_squared(&self) -> f64 {
        let mut smallest = FAR;
        for t in 0..2 {
            let area = self.double_area.as_array_ref()[1 - t];
            for i in 0..3 {
                let a = self.of_corner(t, i);
                let m = if a[0] <= a[1] && a[0] <= a[2] {
                    0
                } else if a[1] <= a[0] && a[1] <= a[2] {
                    1
                } else {
                    2
                };
                let n = self.normal(1 - t, m);
                let distance = a[m] * a[m] / ((n.x * n.x + n.y * n.y) / (area * area));
                if distance < smallest {
                    smallest = distance;
                }
            }
        }
        smallest
    }
}

/// Bit `t` is set where the comparison held in lane `t`.
#[inline(always)]
fn mask(comparison: f64x2) -> u32 {
    comparison.move_mask() as u32
}

/// Forces between the target (lower element number, index 0 of `corners`) and
/// the contactor (index 1). `velocity(t, i)` is that of corner `i` of triangle
/// `t`, asked for only where there is contact. `sliding` holds the sliding
/// accumulated on the three edges of the target and the three of the
/// contactor, m². The forces go to `sides`: from the edges of the target, then
/// from those of the contactor.
#[inline]
pub fn overlap(
    corners: &[[Vec2; 3]; 2],
    velocity: impl Fn(usize, usize) -> Vec2,
    pair: &PairProperties,
    dt: f64,
    sliding: &mut [f64; 6],
    sides: &mut [SideForces; 2],
) -> Proximity {
    let placement = Placement::new(corners);
    let cut = placement.edges_to_cut();
    sides[0].acts = false;
    sides[1].acts = false;
    if cut == [0; 3] {
        return Proximity::Apart { distance_squared: placement.distance_squared() };
    }
    for t in 0..2 {
        let side = &mut sides[t];
        for i in 0..3 {
            if cut[i] >> t & 1 == 0 {
                continue;
            }
            let (u, j) = (1 - t, (i + 1) % 3);
            let (a, b) = (placement.of_corner(t, i), placement.of_corner(t, j));
            let Some(profile) = Profile::new(&a, &b) else { continue };
            if !side.acts {
                side.acts = true;
                side.own = [Vec2::zeros(); 3];
                side.shares = [
                    placement.of_corner(t, 0),
                    placement.of_corner(t, 1),
                    placement.of_corner(t, 2),
                ];
            }
            let normal = placement.normal(t, i);
            let s = profile.mean_parameter();
            let at = |m: usize| a[m] * (1.0 - s) + b[m] * s;
            let other = velocity(u, 2) * at(0) + velocity(u, 0) * at(1) + velocity(u, 1) * at(2);
            let own = velocity(t, i) * (1.0 - s) + velocity(t, j) * s;
            let relative = other - own;
            let slip_rate = -relative.x * normal.y + relative.y * normal.x;
            let slot = &mut sliding[3 * t + i];
            *slot += slip_rate * dt;
            let (total, at_end) = profile.forces(pair.penalty);
            let at_start = total - at_end;
            let tangential = pair.tangential_force(slot, total);
            let (t_start, t_end) = share(tangential, at_start, at_end, total);
            for (node, n, s) in [(i, at_start, t_start), (j, at_end, t_end)] {
                let f = &mut side.own[node];
                f.x = f.x - n * normal.x - s * normal.y;
                f.y = f.y - n * normal.y + s * normal.x;
            }
        }
    }
    Proximity::Near
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

    const AT: [[Vec2; 3]; 2] = [
        [Vec2::new(0.0, 0.0), Vec2::new(2.0, 0.0), Vec2::new(0.0, 2.0)],
        [Vec2::new(0.5, -1.0), Vec2::new(1.5, -1.0), Vec2::new(0.9, 0.3)],
    ];
    const PAIR: PairProperties =
        PairProperties { penalty: 1e6, tangential_penalty: 1e9, friction: 0.3 };

    /// The target rests, the contactor moves.
    fn velocity(t: usize, _corner: usize) -> Vec2 {
        if t == 0 { Vec2::zeros() } else { Vec2::new(5.0, 1.0) }
    }

    /// Worked number J3 of the spec.
    #[test]
    fn forces_equal_the_worked_example() {
        let mut sides = [SideForces::default(); 2];
        let _ = overlap(&AT, velocity, &PAIR, 1e-4, &mut [0.0; 6], &mut sides);
        let mut forces = [Vec2::zeros(); 6];
        let nodes = [[0, 1, 2], [3, 4, 5]];
        for t in 0..2 {
            sides[t].scatter(&nodes[t], &nodes[1 - t], &mut forces);
        }
        let expected = [
            (10_745.619_025_944_5, 45_251.422_394_173_9),
            (15_255.860_263_996_4, 41_420.175_238_962_2),
            (1_557.692_307_692_32, 5_192.307_692_307_7),
            (3_330.450_614_474_28, -7_763.882_567_137_01),
            (-7_293.809_740_555_3, -5_447.314_519_799_73),
            (-23_595.812_471_552_2, -78_652.708_238_507_1),
        ];
        for (force, (x, y)) in forces.iter().zip(expected) {
            assert!((force.x - x).abs() < 1e-8 && (force.y - y).abs() < 1e-8, "{force}");
        }
    }

    #[test]
    fn distant_triangles_report_their_distance() {
        let mut corners = AT;
        for corner in &mut corners[1] {
            corner.y -= 1.3;
        }
        let mut sides = [SideForces::default(); 2];
        let proximity = overlap(&corners, velocity, &PAIR, 1e-4, &mut [0.0; 6], &mut sides);
        assert!(!sides[0].acts && !sides[1].acts);
        let Proximity::Apart { distance_squared } = proximity else { panic!("they are apart") };
        assert!((distance_squared - 1.0).abs() < 1e-12);
    }
}
