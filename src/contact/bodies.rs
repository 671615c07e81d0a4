//! The elements that take part in a couple, as contact sees them in a step.

use super::placement::{Motion, Shape};
use crate::{
    lanes::{LANES, Lanes, each},
    mechanics::Vec2,
    scene::{Elements, Nodes},
    team::Team,
};
use bytemuck::{Pod, Zeroable};

/// From so many triangles on, threads are used: about 10 µs of work for one.
const PARALLEL_FROM: usize = 512;

/// No place among the participants.
const NOWHERE: u32 = u32::MAX;

/// Corners of a triangle in one cache line.
#[derive(Debug, Clone, Copy, Default, Pod, Zeroable)]
#[repr(C, align(64))]
pub(super) struct Body {
    /// x and y of corners 0, 1, 2 and 0: each edge's ends lie one after the other.
    rows: [[f64; 4]; 2],
}

impl Body {
    /// The triangle with these corners.
    #[inline(always)]
    pub fn new([p, q, r]: [Vec2; 3]) -> Self {
        Self { rows: [[p.x, p.y, q.x, q.y], [r.x, r.y, p.x, p.y]] }
    }

    /// Corner `i`.
    #[inline(always)]
    pub fn corner(&self, i: usize) -> &[f64; 2] {
        &self.rows.as_flattened().as_chunks().0[i]
    }

    /// All corners.
    pub fn corners(&self) -> [Vec2; 3] {
        [0, 1, 2].map(|i| Vec2::from(*self.corner(i)))
    }

    /// Shape of the triangle.
    pub fn shape(&self) -> Shape {
        Shape::new(self.corners())
    }
}

/// Four triangles, one per lane.
#[derive(Clone, Copy)]
pub(super) struct Triangles<L> {
    /// Coordinates of the corners.
    pub x: [L; 3],
    pub y: [L; 3],
    pub double_area: L,
}

impl<L: Lanes> Triangles<L> {
    #[inline(always)]
    pub fn new(bodies: [&Body; LANES]) -> Self {
        let [x0, y0, x1, y1] = L::transpose(each!(4, |k| L::load(&bodies[k].rows[0])));
        let [x2, y2] = L::pairs(each!(4, |k| bodies[k].corner(2)));
        let double_area = (x1 - x0) * (y2 - y0) - (x2 - x0) * (y1 - y0);
        Self { x: [x0, x1, x2], y: [y0, y1, y2], double_area }
    }

    /// Outward normal of edge `e`, as long as the edge.
    #[inline(always)]
    pub fn normal(&self, e: usize) -> [L; 2] {
        let next = (e + 1) % 3;
        [self.y[next] - self.y[e], self.x[e] - self.x[next]]
    }
}

/// Edges of all bodies: edge `e` of the body at `place` has the number 4 `place` + `e`.
#[derive(Clone, Copy)]
pub(super) struct BodyEdges<'a>(&'a [[f64; 2]]);

impl BodyEdges<'_> {
    /// Start and end of an edge: x, y, x, y.
    #[inline(always)]
    pub fn at(&self, edge: u32) -> &[f64; 4] {
        let edge = edge as usize;
        &self.0[edge..edge + 2].as_flattened().as_chunks().0[0]
    }
}

/// What corners of four triangles have, one triangle per lane.
#[inline(always)]
pub(super) fn of_corners<L: Lanes>(values: &[Vec2], corners: [&[u32; 3]; LANES]) -> [[L; 2]; 3] {
    each!(3, |i| L::pairs(each!(4, |k| &values[corners[k][i] as usize].data.0[0])))
}

/// All participants of couples.
#[derive(Debug, Clone, Default)]
pub(super) struct Bodies {
    /// Their numbers among the elements.
    pub elements: Vec<u32>,
    /// Corner nodes.
    pub corners: Vec<[u32; 3]>,
    /// Present corners.
    pub bodies: Vec<Body>,
    /// Present shapes and velocities of the corners, where couples are evaluated one by one.
    pub shapes: Vec<Shape>,
    pub motions: Vec<Motion>,
    /// Place of each element among them.
    place: Vec<u32>,
}

impl Bodies {
    /// Triangles with these corner nodes, given their places.
    #[cfg(test)]
    pub fn of(corners: Vec<[u32; 3]>, places: &[Vec2]) -> Self {
        let at = |corners: &[u32; 3]| Body::new(corners.map(|n| places[n as usize]));
        Self { bodies: corners.iter().map(at).collect(), corners, ..Self::default() }
    }

    /// Forgets all participants.
    pub fn clear(&mut self, elements: usize) {
        self.elements.clear();
        self.corners.clear();
        self.place.clear();
        self.place.resize(elements, NOWHERE);
    }

    /// Place of an element, which takes part from now on.
    pub fn place_of(&mut self, element: u32, elements: &Elements) -> u32 {
        let place = &mut self.place[element as usize];
        if *place == NOWHERE {
            *place = self.corners.len() as u32;
            self.elements.push(element);
            self.corners.push(elements.corners::<3>(element as usize).map(|n| n as u32));
        }
        *place
    }

    /// Edges of all bodies.
    #[inline(always)]
    pub fn edges(&self) -> BodyEdges<'_> {
        BodyEdges(bytemuck::cast_slice(&self.bodies))
    }

    /// Takes over the present positions.
    pub fn update(&mut self, nodes: &Nodes<2>, team: &Team) {
        self.bodies.resize(self.corners.len(), Body::default());
        let current = &nodes.current;
        let part = match self.corners.len() {
            few if few < PARALLEL_FROM => PARALLEL_FROM,
            many => many.div_ceil(team.size()),
        };
        let parts = self.bodies.chunks_mut(part).zip(self.corners.chunks(part));
        team.share(parts, |(bodies, corners)| {
            for (body, corners) in bodies.iter_mut().zip(corners) {
                *body = Body::new(corners.map(|n| current[n as usize]));
            }
        });
    }

    /// Takes over the present positions and velocities as shapes and motions.
    pub fn update_shapes(&mut self, nodes: &Nodes<2>) {
        self.shapes.resize(self.corners.len(), Shape::default());
        self.motions.resize(self.corners.len(), Motion::default());
        let Self { corners, shapes, motions, .. } = self;
        for ((shape, motion), corners) in shapes.iter_mut().zip(motions).zip(&*corners) {
            *shape = Shape::new(corners.map(|n| nodes.current[n as usize]));
            *motion = Motion::new(corners.map(|n| nodes.velocity[n as usize]));
        }
    }
}
