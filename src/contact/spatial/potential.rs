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
//! The volume integral follows from the surface: with c the centroid and P = 1 + (x−c)·g in one
//! sub-tetrahedron, div((x−c)(P/4 + 1/12)) = P, and the inner faces hold c.

use super::{FACES, Vec3, dot, vector_product};

/// Corners of a triangle cut by four planes.
const MOST: usize = 7;

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

/// The part of a triangle in which linear functions of the coordinates are positive.
#[derive(Debug, Clone, Copy)]
struct Piece {
    corners: [Corner; MOST],
    len: usize,
}

impl Piece {
    fn new(corners: &[Corner; 3]) -> Self {
        let mut piece = Self { corners: [Corner::default(); MOST], len: 3 };
        piece.corners[..3].copy_from_slice(corners);
        piece
    }

    fn corners(&self) -> &[Corner] {
        &self.corners[..self.len]
    }

    fn cut(&self, side: impl Fn(&[f64; 4]) -> f64) -> Self {
        let mut kept = Self { corners: [Corner::default(); MOST], len: 0 };
        let mut keep = |corner: Corner| {
            if kept.len < MOST {
                kept.corners[kept.len] = corner;
                kept.len += 1;
            }
        };
        let corners = self.corners();
        for (i, a) in corners.iter().enumerate() {
            let b = &corners[(i + 1) % corners.len()];
            let (here, there) = (side(&a.inside), side(&b.inside));
            if here >= 0.0 {
                keep(*a);
            }
            if (here > 0.0 && there < 0.0) || (here < 0.0 && there > 0.0) {
                keep(Corner::between(a, b, here / (here - there)));
            }
        }
        kept
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
    /// Share of each face that lies inside the other.
    pub share: [f64; 4],
    /// The part of ∫P dV that the faces add to, m³.
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

    /// Whether all of the other lies beyond a face of this one.
    pub fn excludes(&self, other: &Self) -> bool {
        (0..4).any(|i| {
            let base = self.corners[(i + 1) % 4];
            other.corners.iter().all(|x| dot(&self.gradients[i], &(x - base)) <= 0.0)
        })
    }
}

/// Integrals over the faces of `body` in the potential of `owner`.
pub(super) fn press(owner: &Shape3, body: &Shape3) -> Pressed {
    let mut sum = Pressed::default();
    let coordinates = body.corners.each_ref().map(|corner| owner.coordinates(corner));
    let centroid = owner.centroid();
    for (face, [p, q, r, opposite]) in FACES.into_iter().enumerate() {
        let nodes = [p, q, r];
        // outward, as long as the face's area
        let normal = body.gradients[opposite] * (-3.0 * body.volume);
        let area = dot(&normal, &normal).sqrt();
        let distance = dot(&(body.corners[p] - centroid), &normal);
        let corners = [0, 1, 2].map(|k| Corner {
            inside: coordinates[nodes[k]],
            on_face: std::array::from_fn(|i| f64::from(u8::from(i == k))),
        });
        if (0..4).any(|i| corners.iter().all(|corner| corner.inside[i] <= 0.0)) {
            continue;
        }
        for lowest in 0..4 {
            let mut piece = Piece::new(&corners).cut(|inside| inside[lowest]);
            for other in (0..4).filter(|&other| other != lowest) {
                piece = piece.cut(|inside| inside[other] - inside[lowest]);
            }
            let corners = piece.corners();
            for i in 1..corners.len().saturating_sub(1) {
                let triangle = [&corners[0], &corners[i], &corners[i + 1]];
                let [a, b, c] = triangle.map(|corner| corner.on_face);
                // share of the face's area
                let share = ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])).abs();
                let potential = triangle.map(|corner| 4.0 * corner.inside[lowest]);
                let total = potential[0] + potential[1] + potential[2];
                let moment = |values: [f64; 3]| {
                    let mixed = potential[0] * values[0]
                        + potential[1] * values[1]
                        + potential[2] * values[2];
                    share * (total * (values[0] + values[1] + values[2]) + mixed) / 12.0
                };
                for k in 0..3 {
                    sum.faces[nodes[k]] +=
                        normal * moment(triangle.map(|corner| corner.on_face[k]));
                }
                for k in 0..4 {
                    sum.owner[k] += normal * moment(triangle.map(|corner| corner.inside[k]));
                }
                let integral = share * total / 3.0;
                sum.pressure += integral * area;
                sum.area += share * area;
                sum.share[face] += share;
                sum.volume_integral += distance * (integral / 4.0 + share / 12.0);
            }
        }
    }
    sum
}
