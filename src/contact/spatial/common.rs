//! The part that two tetrahedra have in common: a convex body, closed whatever is rounded.
//!
//! The first is cut by the planes of the second's faces. A cut asks each corner once on which side
//! it lies and each edge once where it is cut, and closes the hole that it leaves with a new face:
//! so every edge lies between two faces, also where planes coincide, as those of a mesh's
//! tetrahedra do, and rounding decides which of two faces the part is bounded by. Integrals over
//! the part that are made from its faces err by rounding only, which they would not if each face
//! were cut on its own: of two that coincide both, one or none could be found.
//!
//! Corners are kept as volume coordinates in both bodies, in which everything is linear.

use super::{
    FACES,
    potential::{ROUNDING, Shape3},
};

/// Corners made by four cuts: 26, as a cut crosses each of the 4 to 7 faces once; some more where
/// rounding makes it cross one twice.
const MOST_CORNERS: usize = 36;
/// Faces, and corners of all faces, with as much room.
const MOST_FACES: usize = 12;
const MOST_PLACES: usize = 64;

/// A corner: its volume coordinates in both bodies.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Corner {
    pub inside: [[f64; 4]; 2],
}

/// A face: part of a face of one of the bodies.
#[derive(Debug, Clone, Copy, Default)]
struct Face {
    /// Which body.
    body: usize,
    /// Its node opposite to the face.
    opposite: usize,
    /// The corners' places in the list, up to the next face's.
    end: usize,
}

/// Faces one after the other, each a loop of corners counter-clockwise seen from inside.
#[derive(Debug, Clone, Copy)]
struct Hull {
    places: [u8; MOST_PLACES],
    len: usize,
    faces: [Face; MOST_FACES],
    count: usize,
}

impl Hull {
    fn empty() -> Self {
        Self { places: [0; MOST_PLACES], len: 0, faces: [Face::default(); MOST_FACES], count: 0 }
    }

    fn loops(&self) -> impl Iterator<Item = (Face, &[u8])> {
        let starts = std::iter::once(0).chain(self.faces.iter().map(|face| face.end));
        let faces = &self.faces[..self.count];
        faces.iter().zip(starts).map(|(face, start)| (*face, &self.places[start..face.end]))
    }

    /// Adds a corner to the face that is being made.
    fn push(&mut self, corner: u8) -> Option<()> {
        *self.places.get_mut(self.len)? = corner;
        self.len += 1;
        Some(())
    }

    /// Ends the face that is being made, if it has corners.
    fn finish(&mut self, body: usize, opposite: usize) -> Option<()> {
        let start = if self.count == 0 { 0 } else { self.faces[self.count - 1].end };
        if self.len > start {
            *self.faces.get_mut(self.count)? = Face { body, opposite, end: self.len };
            self.count += 1;
        }
        Some(())
    }
}

/// What two bodies have in common.
#[derive(Debug, Clone, Copy)]
pub(super) struct Common {
    corners: [Corner; MOST_CORNERS],
    len: usize,
    hull: Hull,
}

impl Common {
    /// Of two bodies; none if they have nothing in common, but for rounding.
    pub fn of(bodies: [&Shape3; 2]) -> Option<Self> {
        let mut common = Self {
            corners: [Corner::default(); MOST_CORNERS],
            len: FACES.len(),
            hull: Hull::empty(),
        };
        for (i, x) in bodies[0].corners.iter().enumerate() {
            common.corners[i].inside[0][i] = 1.0;
            common.corners[i].inside[1] = bodies[1].coordinates(x);
        }
        for [p, q, r, opposite] in FACES {
            // the nodes of a body that is inside out are counted the other way round
            let nodes = if bodies[0].volume < 0.0 { [p, r, q] } else { [p, q, r] };
            nodes.into_iter().try_for_each(|node| common.hull.push(node as u8))?;
            common.hull.finish(0, opposite)?;
        }
        (0..FACES.len()).try_for_each(|node| common.cut(node))?;
        Some(common)
    }

    /// The faces: which body's, the node opposite, the corners counter-clockwise seen from inside.
    pub fn faces(&self) -> impl Iterator<Item = (usize, usize, impl Iterator<Item = &Corner>)> {
        self.hull.loops().map(|(face, corners)| {
            let corners = corners.iter().map(|&place| &self.corners[usize::from(place)]);
            (face.body, face.opposite, corners)
        })
    }

    /// The part in which the second body's volume coordinate of a node is positive.
    fn cut(&mut self, node: usize) -> Option<()> {
        let side = |corner: &Corner| corner.inside[1][node];
        let hull = &self.hull;
        let (mut any_inside, mut outside) = (false, 0u64);
        for &place in &hull.places[..hull.len] {
            let height = side(&self.corners[usize::from(place)]);
            any_inside |= height > ROUNDING;
            outside |= u64::from(height < -ROUNDING) << place;
        }
        if !any_inside {
            return None;
        }
        if outside == 0 {
            return Some(());
        }
        let whole = std::mem::replace(&mut self.hull, Hull::empty());
        let mut cuts = Cuts { first: self.len, edges: [[0; 2]; MOST_CORNERS] };
        // the corner that follows each new corner on the new face
        let mut next = [0; MOST_CORNERS];
        for (face, corners) in whole.loops() {
            let (mut left, mut entered) = (None, None);
            for (i, &from) in corners.iter().enumerate() {
                let to = corners[(i + 1) % corners.len()];
                let [is_out, will_be] = [from, to].map(|place| outside >> place & 1 != 0);
                if !is_out {
                    self.hull.push(from)?;
                }
                if is_out == will_be {
                    continue;
                }
                let [inner, outer] = if is_out { [to, from] } else { [from, to] };
                let corner = cuts.corner(self, [inner, outer], side)?;
                self.hull.push(corner)?;
                if !is_out {
                    left = Some(corner);
                } else if let Some(before) = left.take() {
                    next[usize::from(corner)] = before;
                } else {
                    entered = Some(corner);
                }
            }
            if let (Some(before), Some(corner)) = (left, entered) {
                next[usize::from(corner)] = before;
            }
            self.hull.finish(face.body, face.opposite)?;
        }
        let mut open = (cuts.first..self.len).fold(0u64, |all, corner| all | 1 << corner);
        while open != 0 {
            let mut corner = open.trailing_zeros() as u8;
            while open >> corner & 1 != 0 {
                open &= !(1 << corner);
                self.hull.push(corner)?;
                corner = next[usize::from(corner)];
            }
            self.hull.finish(1, node)?;
        }
        Some(())
    }
}

/// The corners that a cut has made, and the edges that they lie on.
struct Cuts {
    first: usize,
    edges: [[u8; 2]; MOST_CORNERS],
}

impl Cuts {
    /// The corner on the edge between a corner inside and one outside.
    fn corner(
        &mut self,
        common: &mut Common,
        edge: [u8; 2],
        side: impl Fn(&Corner) -> f64,
    ) -> Option<u8> {
        let known = (self.first..common.len).find(|&corner| self.edges[corner] == edge);
        if let Some(corner) = known {
            return Some(corner as u8);
        }
        let [a, b] = edge.map(|place| common.corners[usize::from(place)]);
        let (here, there) = (side(&a).max(0.0), side(&b));
        let weight = here / (here - there);
        *common.corners.get_mut(common.len)? = Corner {
            inside: [0, 1].map(|t| {
                std::array::from_fn(|i| a.inside[t][i] + weight * (b.inside[t][i] - a.inside[t][i]))
            }),
        };
        self.edges[common.len] = edge;
        common.len += 1;
        Some((common.len - 1) as u8)
    }
}
