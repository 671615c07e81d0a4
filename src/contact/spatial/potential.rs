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

/// Corners of a polygon divided by three planes: more than any has, rounded as it may be.
const MOST: usize = 24;

/// Volume coordinates that differ by less are equal, but for their rounding.
pub(super) const ROUNDING: f64 = 1e-14;

/// A corner of a piece of a face: volume coordinates in the other body, area coordinates in the face.
#[derive(Debug, Clone, Copy, Default)]
struct Corner {
    inside: [f64; 4],
    on_face: [f64; 3],
}

impl Corner {
    fn between(a: &Self, b: &Self, weight: f64) -> Self {
        Self {
            inside: std::array::from_fn(|i| a.inside[i] + weight * (b.inside[i] - a.inside[i])),
            on_face: std::array::from_fn(|i| a.on_face[i] + weight * (b.on_face[i] - a.on_face[i])),
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

    /// Calls `exert` with the parts in each of which one coordinate in the other body is the
    /// lowest. Every part of the piece is passed on once: if all of it lies where two are equal, to
    /// one of them.
    fn divide(&self, exert: &mut impl FnMut(&Self, usize)) {
        self.divide_from(0, 1, exert);
    }

    /// The same if `lowest` is the lowest of the coordinates before `next`.
    fn divide_from(&self, lowest: usize, next: usize, exert: &mut impl FnMut(&Self, usize)) {
        if next == FACES.len() {
            exert(self, lowest);
            return;
        }
        let above = |corner: &Corner| corner.inside[lowest] - corner.inside[next];
        let corners = self.corners();
        let Some(start) = corners.iter().position(|corner| above(corner) <= ROUNDING) else {
            return self.divide_from(next, next + 1, exert);
        };
        if corners.iter().all(|corner| above(corner) <= ROUNDING) {
            return self.divide_from(lowest, next + 1, exert);
        }
        // what is taken from the one part is what the other gets, wherever rounding puts the border
        let (mut kept, mut rest) = (Self::empty(), Self::empty());
        for i in start..start + self.len {
            let [a, b] = [i, i + 1].map(|i| &corners[i % self.len]);
            let (here, there) = (above(a), above(b));
            let [is_above, will_be] = [here, there].map(|height| height > ROUNDING);
            let part = if is_above { &mut rest } else { &mut kept };
            part.push(*a);
            if is_above != will_be {
                let weight = here / (here - there);
                let corner = Corner::between(a, b, weight.clamp(0.0, 1.0));
                kept.push(corner);
                rest.push(corner);
            }
            if is_above && !will_be {
                rest.divide_from(next, next + 1, exert);
                rest = Self::empty();
            }
        }
        kept.divide_from(lowest, next + 1, exert);
    }
}

/// The faces of one tetrahedron in the potential of another.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct Pressed {
    /// ∫P n N dA of each node of the one whose faces they are, n its outward normal, N its shape
    /// function, m².
    pub faces: [Vec3; 4],
    /// The same with the shape functions of the other.
    pub owner: [Vec3; 4],
    /// ∫P dA over all faces, m².
    pub pressure: f64,
    /// Area on which the potential acts, m².
    pub area: f64,
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
        let nodes = face_nodes(opposite);
        let mut piece = Piece::empty();
        for corner in corners {
            piece.push(Corner {
                inside: corner.inside[1 - of],
                on_face: nodes.map(|node| corner.inside[of][node]),
            });
        }
        // the potential of the body itself is 0 on its face
        let whole: f64 = triangles(&piece).map(|triangle| share(&triangle)).sum();
        pressed[of].volume_integral += whole * 0.75 * body.volume / 12.0;
        let normal = body.normal(opposite);
        let distance = dot(&(body.corners[nodes[0]] - centroids[1 - of]), &normal);
        let sum = &mut pressed[1 - of];
        let [on_face, in_owner] = [&mut sum.faces, &mut sum.owner];
        let (mut all, mut integral) = (0.0, 0.0);
        piece.divide(&mut |part, lowest| {
            for triangle in triangles(part) {
                let share = share(&triangle);
                let potential = triangle.map(|corner| 4.0 * corner.inside[lowest]);
                let total = potential[0] + potential[1] + potential[2];
                let moment = |values: [f64; 3]| {
                    let mixed = potential[0] * values[0]
                        + potential[1] * values[1]
                        + potential[2] * values[2];
                    share * (total * (values[0] + values[1] + values[2]) + mixed) / 12.0
                };
                for k in 0..3 {
                    on_face[nodes[k]] += normal * moment(triangle.map(|corner| corner.on_face[k]));
                }
                for k in 0..4 {
                    in_owner[k] += normal * moment(triangle.map(|corner| corner.inside[k]));
                }
                all += share;
                integral += share * total / 3.0;
            }
        });
        let area = dot(&normal, &normal).sqrt();
        sum.pressure += integral * area;
        sum.area += all * area;
        sum.volume_integral += distance * (integral / 4.0 + all / 12.0);
    }
    pressed
}

/// Nodes of the face opposite to a node.
fn face_nodes(opposite: usize) -> [usize; 3] {
    let face = FACES.into_iter().find(|face| face[3] == opposite);
    face.map_or([0; 3], |[p, q, r, _]| [p, q, r])
}

/// The triangles between the first corner and each edge.
fn triangles(piece: &Piece) -> impl Iterator<Item = [&Corner; 3]> {
    let corners = piece.corners();
    (2..corners.len()).map(move |i| [&corners[0], &corners[i - 1], &corners[i]])
}

/// A triangle's share of the face's area.
fn share(triangle: &[&Corner; 3]) -> f64 {
    let [a, b, c] = triangle.map(|corner| corner.on_face);
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}
