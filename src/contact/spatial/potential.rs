//! The potential contact force as a gradient: what the options beyond the original's law use.
//!
//! The potential of a tetrahedron is P = 4·min λᵢ, λ its area (here volume) coordinates: 0 on the
//! surface, 1 in the centroid. The energy of a couple is
//!
//! > U = 6·p·(∫ P_t dV + ∫ P_c dV) over the part that both share,
//!
//! p the penalty; the factor is the original's. Moving a face of the one through the potential of
//! the other changes U by the integral of P over the face: so the pressure 6·p·P acts against it.
//! The other bears the same at the same place, and, because its potential deforms with it, the
//! pressure of the energy it holds: −6·p·∫P dV·∇λᵢ on node i. Forces are the exact gradient of U
//! for any motion of the eight nodes, rigid or not.
//!
//! The volume integral follows from the surface of that part: with c the centroid and
//! P = 1 + (x−c)·g in one sub-tetrahedron, div((x−c)(P/4 + 1/12)) = P, and the inner faces hold c.
//! The surface has to be closed, or what is missing counts with its distance from c: see `common`.

use super::{FACES, Vec3, common::Common, dot, vector_product};
use crate::lanes::each;

/// Corners of a polygon divided by three planes: more than any has, rounded as it may be.
const MOST: usize = 16;

/// Volume coordinates that differ by less are equal, but for their rounding.
pub(super) const ROUNDING: f64 = 1e-14;

/// A corner of a piece of a face: volume coordinates in the other body, and the first two area
/// coordinates in the face.
#[derive(Debug, Clone, Copy, Default)]
struct Corner {
    inside: [f64; 4],
    on_face: [f64; 2],
}

impl Corner {
    fn between(a: &Self, b: &Self, weight: f64) -> Self {
        Self {
            inside: each!(4, |i| a.inside[i] + weight * (b.inside[i] - a.inside[i])),
            on_face: each!(2, |i| a.on_face[i] + weight * (b.on_face[i] - a.on_face[i])),
        }
    }
}

/// A piece of a face.
#[derive(Debug, Clone, Copy)]
struct Piece {
    corners: [Corner; MOST],
    len: usize,
}

impl Piece {
    fn empty() -> Self {
        Self { corners: [Corner::default(); MOST], len: 0 }
    }

    fn corners(&self) -> &[Corner] {
        &self.corners[..self.len]
    }

    fn push(&mut self, corner: Corner) {
        if let Some(free) = self.corners.get_mut(self.len) {
            *free = corner;
            self.len += 1;
        }
    }

    /// Adds the parts in each of which one coordinate in the other body is the lowest. Every part of
    /// the piece counts once: if all of it lies where two are equal, for one of them.
    fn add_to(&self, sums: &mut FaceSums) {
        self.divide(0, 1, sums);
    }

    /// The same if `lowest` is the lowest of the coordinates before `next`.
    fn divide(&self, lowest: usize, next: usize, sums: &mut FaceSums) {
        if next == FACES.len() {
            sums.add(self.corners(), lowest);
            return;
        }
        let mut heights = [0.0; MOST];
        let (mut highest, mut start) = (f64::NEG_INFINITY, None);
        for (i, corner) in self.corners().iter().enumerate() {
            let height = corner.inside[lowest] - corner.inside[next];
            heights[i] = height;
            if height > highest {
                highest = height;
            }
            if height <= ROUNDING && start.is_none() {
                start = Some(i);
            }
        }
        let Some(start) = start else {
            return self.divide(next, next + 1, sums);
        };
        if highest <= ROUNDING {
            return self.divide(lowest, next + 1, sums);
        }
        // what is taken from the one part is what the other gets, wherever rounding puts the border
        let (mut kept, mut rest) = (Self::empty(), Self::empty());
        let mut i = start;
        for _ in 0..self.len {
            let k = if i + 1 == self.len { 0 } else { i + 1 };
            let [is_above, will_be] = [heights[i] > ROUNDING, heights[k] > ROUNDING];
            let part = if is_above { &mut rest } else { &mut kept };
            part.push(self.corners[i]);
            if is_above != will_be {
                let weight = (heights[i] / (heights[i] - heights[k])).clamp(0.0, 1.0);
                let corner = Corner::between(&self.corners[i], &self.corners[k], weight);
                kept.push(corner);
                rest.push(corner);
            }
            if is_above && !will_be {
                rest.divide(next, next + 1, sums);
                rest.len = 0;
            }
            i = k;
        }
        kept.divide(lowest, next + 1, sums);
    }
}

/// What is summed over a face, by its area.
#[derive(Debug, Clone, Copy, Default)]
struct FaceSums {
    /// The area, where the potential acts.
    share: f64,
    /// The potential.
    potential: f64,
    /// The potential times the area coordinates of the face's first two nodes.
    on_face: [f64; 2],
    /// The potential times the first three volume coordinates in the other body.
    inside: [f64; 3],
}

impl FaceSums {
    /// Adds a polygon in which a coordinate is the lowest, as the triangles between its first
    /// corner and each edge.
    fn add(&mut self, corners: &[Corner], lowest: usize) {
        for i in 2..corners.len() {
            let triangle = [&corners[0], &corners[i - 1], &corners[i]];
            let share = double_share(triangle);
            let [p, q, r] = each!(3, |k| 4.0 * triangle[k].inside[lowest]);
            let total = p + q + r;
            let moment = |[a, b, c]: [f64; 3]| {
                share * (total * (a + b + c) + (p * a + q * b + r * c)) / 12.0
            };
            self.share += share;
            self.potential += share * total / 3.0;
            for k in 0..2 {
                self.on_face[k] += moment(each!(3, |i| triangle[i].on_face[k]));
            }
            for k in 0..3 {
                self.inside[k] += moment(each!(3, |i| triangle[i].inside[k]));
            }
        }
    }

    /// The potential times the area coordinates of the face's nodes.
    fn of_face(&self) -> [f64; 3] {
        let [a, b] = self.on_face;
        [a, b, self.potential - a - b]
    }

    /// The potential times the volume coordinates in the other body.
    fn of_owner(&self) -> [f64; 4] {
        let [a, b, c] = self.inside;
        [a, b, c, self.potential - a - b - c]
    }
}

/// A triangle's share of the face's area.
fn double_share([a, b, c]: [&Corner; 3]) -> f64 {
    let along = |p: &Corner| [p.on_face[0] - a.on_face[0], p.on_face[1] - a.on_face[1]];
    let ([b0, b1], [c0, c1]) = (along(b), along(c));
    b0 * c1 - b1 * c0
}

/// The faces of one tetrahedron in the potential of another.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct OnFaces {
    /// ∫P n N dA of each node, n the outward normal, N its shape function, m².
    pub nodes: [Vec3; 4],
    /// Area on which the potential acts, m².
    pub area: f64,
}

impl OnFaces {
    /// Adds a face with these nodes and this outward normal, as long as its area.
    fn add(&mut self, nodes: [usize; 3], normal: &Vec3, sums: &FaceSums) {
        for (node, moment) in nodes.into_iter().zip(sums.of_face()) {
            self.nodes[node] += normal * moment;
        }
        self.area += sums.share * dot(normal, normal).sqrt();
    }
}

/// The potential of one tetrahedron on the part that it shares with another.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Pressed {
    /// The other's faces.
    pub faces: OnFaces,
    /// ∫P n N dA over them with the shape functions of the one whose potential it is, m².
    pub owner: [Vec3; 4],
    /// ∫P dV over the part that both share, m³.
    pub volume_integral: f64,
}

/// Tetrahedron with what its shape functions need.
#[derive(Debug, Clone, Copy)]
pub(super) struct Shape3 {
    pub corners: [Vec3; 4],
    /// Gradients of the volume coordinates, 1/m.
    pub gradients: [Vec3; 4],
    pub volume: f64,
}

impl Shape3 {
    pub fn new(corners: [Vec3; 4]) -> Self {
        let [a, b, c, d] = corners;
        let volume = dot(&vector_product(&(b - a), &(c - a)), &(d - a)) / 6.0;
        let mut gradients = [Vec3::zeros(); 4];
        for [p, q, r, opposite] in FACES {
            let inward =
                vector_product(&(corners[q] - corners[p]), &(corners[r] - corners[p])) * 0.5;
            gradients[opposite] = inward / (3.0 * volume);
        }
        Self { corners, gradients, volume }
    }

    /// Volume coordinates of a point.
    pub fn coordinates(&self, x: &Vec3) -> [f64; 4] {
        // from the node that is not zero there: the coordinate of a node itself is exact
        std::array::from_fn(|i| dot(&self.gradients[i], &(x - self.corners[(i + 1) % 4])))
    }

    fn centroid(&self) -> Vec3 {
        let [a, b, c, d] = self.corners;
        (a + b + c + d) * 0.25
    }

    /// Whether all of the other lies beyond a face of this one, but for rounding: neighbours of one
    /// mesh do.
    pub fn excludes(&self, other: &Self) -> bool {
        (0..4).any(|i| {
            let base = self.corners[(i + 1) % 4];
            other.corners.iter().all(|x| dot(&self.gradients[i], &(x - base)) <= ROUNDING)
        })
    }

    /// Of the face opposite to a node: outward, as long as its area, m².
    fn normal(&self, opposite: usize) -> Vec3 {
        self.gradients[opposite] * (-3.0 * self.volume)
    }
}

/// Integrals over the part that two bodies share: each time the faces of one in the potential of
/// the other, whose place in the pair is that of the result.
pub(super) fn press(bodies: [&Shape3; 2], common: &Common) -> [Pressed; 2] {
    let mut pressed = [Pressed::default(); 2];
    let centroids = bodies.map(Shape3::centroid);
    for (of, opposite, corners) in common.faces() {
        let body = bodies[of];
        let nodes = FACE_NODES[opposite];
        let mut piece = Piece::empty();
        for corner in corners {
            piece.push(Corner {
                inside: corner.inside[1 - of],
                on_face: each!(2, |k| corner.inside[of][nodes[k]]),
            });
        }
        let mut sums = FaceSums::default();
        piece.add_to(&mut sums);
        // the potential of the body itself is 0 on its face
        pressed[of].volume_integral += sums.share * 0.75 * body.volume / 12.0;
        let normal = body.normal(opposite);
        let distance = dot(&(body.corners[nodes[0]] - centroids[1 - of]), &normal);
        let sum = &mut pressed[1 - of];
        sum.faces.add(nodes, &normal, &sums);
        for (owner, moment) in sum.owner.iter_mut().zip(sums.of_owner()) {
            *owner += normal * moment;
        }
        sum.volume_integral += distance * (sums.potential / 4.0 + sums.share / 12.0);
    }
    pressed
}

/// Nodes of the face opposite to each node.
const FACE_NODES: [[usize; 3]; 4] = {
    let mut nodes = [[0; 3]; 4];
    let mut face = 0;
    while face < FACES.len() {
        let [p, q, r, opposite] = FACES[face];
        nodes[opposite] = [p, q, r];
        face += 1;
    }
    nodes
};
