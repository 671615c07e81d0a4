//! Potential contact force between two triangles (spec `y2d3d.md` E.3).
//!
//! Each edge of each triangle is cut at the other triangle; along the piece
//! inside, the potential (the smallest area coordinate) is integrated exactly,
//! which gives a normal force distributed to the edge's two nodes and, by area
//! coordinates, to the nodes of the other triangle. The tangential force
//! follows the sliding accumulated on that edge.

use super::{
    placement::{AreaCoordinates, Lanes, Motion, Placement, Shape},
    profile::Integrals,
};
use crate::{mechanics::Vec2, scene::PairProperties};

/// Contact forces caused by the edges of one triangle of a couple.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct SideForces {
    /// Whether there are any.
    pub acts: bool,
    /// Force on each corner of the triangle whose edges were cut, N.
    pub own: [Vec2; 3],
    /// Area coordinates of those corners in the other triangle: the share of
    /// `own[m]` that corner `i` of the other triangle has to bear is
    /// `shares[(i + 1) % 3][m]`.
    pub shares: AreaCoordinates,
}

impl SideForces {
    /// Adds the forces to those of the nodes in the original's order, which
    /// matters where the two triangles share a node.
    #[inline(always)]
    pub fn scatter(&self, own: &[u32; 3], other: &[u32; 3], forces: &mut [Vec2]) {
        if !self.acts {
            return;
        }
        for i in 0..3 {
            forces[own[i] as usize] += self.own[i];
            let force = &mut forces[other[i] as usize];
            let shares = &self.shares[(i + 1) % 3];
            for m in 0..3 {
                force.x -= self.own[m].x * shares[m];
                force.y -= self.own[m].y * shares[m];
            }
        }
    }
}

/// How close the two triangles of a couple are.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Proximity {
    /// An edge of either came close enough to be cut, even if nothing of it
    /// lies inside.
    Near,
    /// No edge was cut, and a corner is within the dropping distance.
    Clear,
    /// No edge was cut, and no corner is within the dropping distance of the
    /// edge line that it violates most.
    Beyond,
}

/// A couple of triangles at one instant.
#[derive(Debug, Clone, Copy)]
pub struct Couple<'a> {
    /// Target (lower element number) and contactor.
    pub shapes: [&'a Shape; 2],
    /// Velocities of their corners.
    pub motions: [&'a Motion; 2],
    /// Contact properties of the two materials.
    pub pair: &'a PairProperties,
    /// Time step, s.
    pub dt: f64,
    /// Square of the distance beyond which the couple is dropped, m².
    pub drop_distance_squared: f64,
}

/// The piece of an edge that lies inside the other triangle.
#[derive(Debug, Clone, Copy)]
pub struct EdgeContact {
    /// Whose edge it is: 0 the target's, 1 the contactor's.
    pub side: usize,
    /// Number of the edge.
    pub edge: usize,
    /// Outward normal of the edge, as long as the edge, m.
    pub normal: Vec2,
    /// Relative velocity along the edge times its length, m²/s.
    pub sliding_velocity: f64,
    /// Normal force per length of the edge, N/m.
    pub normal_force: f64,
}

/// How the tangential force on an edge follows from its sliding.
pub trait TangentialLaw {
    /// The force, and the sliding as the force leaves it.
    fn force(&mut self, contact: &EdgeContact, sliding: &mut f64) -> f64;
}

/// Coulomb's law with the properties of the pair of materials.
impl TangentialLaw for &PairProperties {
    #[inline(always)]
    fn force(&mut self, contact: &EdgeContact, sliding: &mut f64) -> f64 {
        self.tangential_force(sliding, contact.normal_force)
    }
}

/// Forces between the two triangles of a couple. `sliding` holds the sliding
/// accumulated on the three edges of the target and the three of the contactor,
/// m². The forces go to `sides`: from the edges of the target, then from those
/// of the contactor.
#[inline(always)]
pub fn overlap(
    couple: &Couple<'_>,
    law: &mut impl TangentialLaw,
    sliding: &mut [f64; 6],
    sides: &mut [SideForces; 2],
) -> Proximity {
    let placement = Placement::new(couple.shapes);
    let cut = placement.edges_to_cut();
    let [target, contactor] = sides;
    target.acts = false;
    contactor.acts = false;
    if cut == [0; 2] {
        let beyond = placement.is_beyond(couple.shapes, couple.drop_distance_squared);
        return if beyond { Proximity::Beyond } else { Proximity::Clear };
    }
    let (of_target, of_contactor) = sliding.split_at_mut(3);
    let [inside_other, inside_target] = &placement.coordinates;
    cut_side(couple, law, 0, cut[0], inside_other, of_target, target);
    cut_side(couple, law, 1, cut[1], inside_target, of_contactor, contactor);
    Proximity::Near
}

/// Cuts the chosen edges of triangle `t` at the other.
#[inline(always)]
fn cut_side(
    couple: &Couple<'_>,
    law: &mut impl TangentialLaw,
    t: usize,
    cut: u32,
    coordinates: &AreaCoordinates,
    sliding: &mut [f64],
    side: &mut SideForces,
) {
    for i in 0..3 {
        if cut >> i & 1 == 0 {
            continue;
        }
        let j = (i + 1) % 3;
        let [c0, c1, c2] = coordinates;
        let (a, b) = ([c0[i], c1[i], c2[i]], [c0[j], c1[j], c2[j]]);
        let Some(integrals) = Integrals::along(&a, &b) else { continue };
        if !side.acts {
            *side = SideForces { acts: true, own: [Vec2::zeros(); 3], shares: *coordinates };
        }
        let normal = couple.shapes[t].normal(i);
        let s = integrals.mean_parameter;
        let at = |m: usize| a[m] * (1.0 - s) + b[m] * s;
        let inside = [at(0), at(1), at(2)];
        let relative = |own: &Lanes, other: &Lanes| {
            let there = other[2] * inside[0] + other[0] * inside[1] + other[1] * inside[2];
            there - (own[i] * (1.0 - s) + own[j] * s)
        };
        let (own, other) = (couple.motions[t], couple.motions[1 - t]);
        let (x, y) = (relative(&own.x, &other.x), relative(&own.y, &other.y));
        let sliding_velocity = -x * normal.y + y * normal.x;
        sliding[i] += sliding_velocity * couple.dt;
        let total = integrals.total * couple.pair.penalty * 1.5;
        let at_end = integrals.moment * couple.pair.penalty * 0.5;
        let at_start = total - at_end;
        let contact =
            EdgeContact { side: t, edge: i, normal, sliding_velocity, normal_force: total };
        let tangential = law.force(&contact, &mut sliding[i]);
        let (t_start, t_end) = share(tangential, at_start, at_end, total);
        for (node, n, s) in [(i, at_start, t_start), (j, at_end, t_end)] {
            let f = &mut side.own[node];
            f.x = f.x - n * normal.x - s * normal.y;
            f.y = f.y - n * normal.y + s * normal.x;
        }
    }
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
    const MOTIONS: [Motion; 2] =
        [Motion { x: [0.0; 4], y: [0.0; 4] }, Motion { x: [5.0; 4], y: [1.0; 4] }];

    fn couple(shapes: &[Shape; 2]) -> Couple<'_> {
        Couple {
            shapes: [&shapes[0], &shapes[1]],
            motions: [&MOTIONS[0], &MOTIONS[1]],
            pair: &PAIR,
            dt: 1e-4,
            drop_distance_squared: 0.9 * 0.9,
        }
    }

    /// Worked number J3 of the spec.
    #[test]
    fn forces_equal_the_worked_example() {
        let mut sides = [SideForces::default(); 2];
        let _ = overlap(&couple(&AT.map(Shape::new)), &mut &PAIR, &mut [0.0; 6], &mut sides);
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
    fn separated_triangles_are_told_apart_by_their_distance() {
        for (down, expected) in [(0.31, Proximity::Clear), (1.3, Proximity::Beyond)] {
            let mut corners = AT;
            for corner in &mut corners[1] {
                corner.y -= down;
            }
            let mut sides = [SideForces::default(); 2];
            let shapes = corners.map(Shape::new);
            let proximity = overlap(&couple(&shapes), &mut &PAIR, &mut [0.0; 6], &mut sides);
            assert!(!sides[0].acts && !sides[1].acts);
            assert_eq!(proximity, expected);
        }
    }
}
