use super::{Frame, Vec3};
use crate::{lanes::each, scene::Elements};

/// No place among the participants.
const NOWHERE: u32 = u32::MAX;

/// A tetrahedron as the target of a couple.
#[derive(Debug, Clone, Copy, Default)]
pub struct Tetrahedron {
    /// Its nodes, m.
    pub corners: [Vec3; 4],
    /// Mean of the nodes, m.
    pub centroid: Vec3,
}

impl Tetrahedron {
    /// The tetrahedron with these nodes; (x₁−x₀)×(x₂−x₀) points towards x₃.
    #[inline(always)]
    #[must_use]
    pub fn new(corners: [Vec3; 4]) -> Self {
        let [a, b, c, d] = each!(4, |i| corners[i] * 0.25);
        Self { corners, centroid: a + b + c + d }
    }
}

/// A tetrahedron as the contactor of a couple: its four faces.
#[derive(Debug, Clone, Copy, Default)]
pub struct Contactor {
    /// In the order of [`super::FACES`].
    pub frames: [Frame; 4],
}

impl Contactor {
    /// The tetrahedron with these nodes.
    #[inline(always)]
    #[must_use]
    pub fn new(corners: &[Vec3; 4]) -> Self {
        Self { frames: each!(4, |face| Frame::new(corners, face)) }
    }
}

/// The elements that take part in a couple.
#[derive(Debug, Clone, Default)]
pub(super) struct Bodies {
    /// Corners.
    pub nodes: Vec<[u32; 4]>,
    /// Nodes on the edges of ten-node tetrahedra.
    pub edge_nodes: Vec<Option<[u32; 6]>>,
    /// As they lie in this step, where a couple that is evaluated needs them.
    pub targets: Vec<Tetrahedron>,
    pub contactors: Vec<Contactor>,
    /// In which evaluation each was made last.
    made: Vec<u64>,
    /// Place of each element among them.
    place: Vec<u32>,
}

impl Bodies {
    /// Forgets all participants.
    pub fn clear(&mut self, elements: usize) {
        self.nodes.clear();
        self.edge_nodes.clear();
        self.made.clear();
        self.place.clear();
        self.place.resize(elements, NOWHERE);
    }

    /// Place of an element, which takes part from now on.
    pub fn place_of(&mut self, element: u32, elements: &Elements) -> u32 {
        let place = &mut self.place[element as usize];
        if *place == NOWHERE {
            *place = self.nodes.len() as u32;
            self.nodes.push(elements.corners::<4>(element as usize).map(|n| n as u32));
            let edges = elements.edge_nodes.get(element as usize).filter(|edges| edges[0] >= 0);
            self.edge_nodes.push(edges.map(|edges| edges.map(|n| n as u32)));
        }
        *place
    }

    /// Makes room for all participants.
    pub fn settle(&mut self) {
        self.targets.resize(self.nodes.len(), Tetrahedron::default());
        self.contactors.resize(self.nodes.len(), Contactor::default());
        self.made.resize(self.nodes.len(), 0);
    }

    /// Brings a couple up to the positions of evaluation number `evaluation`, which is above 0.
    pub fn update(&mut self, participants: [u32; 2], positions: &[Vec3], evaluation: u64) {
        for place in participants.map(|place| place as usize) {
            if self.made[place] != evaluation {
                self.made[place] = evaluation;
                let nodes = &self.nodes[place];
                let corners = each!(4, |i| positions[nodes[i] as usize]);
                self.targets[place] = Tetrahedron::new(corners);
                self.contactors[place] = Contactor::new(&corners);
            }
        }
    }
}
