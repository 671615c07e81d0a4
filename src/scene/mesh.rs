use nalgebra::SVector;
use serde::{Deserialize, Serialize};

/// What an element is to the joints: the codes are those of the classic deck
/// (spec `deck.md` 3.2, I1ELTY).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum JointKind {
    /// A triangle, or an element of another type.
    #[default]
    NoJoint = -1,
    /// A joint that holds two triangles together.
    Intact = 0,
    /// A joint on a free edge, closed when joints were inserted: it has an
    /// element number but no second face.
    FreeEdge = 1,
    /// A fracture that was there before the run.
    PreExisting = 2,
    /// A joint that has failed: it carries no cohesive force any more.
    Broken = 3,
}

impl JointKind {
    /// Whether it is an open fracture, old or new.
    #[must_use]
    pub fn is_fracture(self) -> bool {
        matches!(self, Self::PreExisting | Self::Broken)
    }
}

/// Nodal state in `D` dimensions, one entry per node in deck order.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Nodes<const D: usize> {
    /// Stress-free coordinates, m.
    pub initial: Vec<SVector<f64, D>>,
    /// Current coordinates, m.
    pub current: Vec<SVector<f64, D>>,
    /// Velocities, m/s.
    pub velocity: Vec<SVector<f64, D>>,
    /// Boundary flags: only elements with a node flagged exactly 1 take part
    /// in contact (unless all do).
    pub boundary_flag: Vec<i32>,
    /// Node set (boundary condition) of each node; outside `0..node_sets` the
    /// node never moves.
    pub set: Vec<i32>,
}

impl<const D: usize> Nodes<D> {
    /// Number of nodes.
    #[must_use]
    pub fn len(&self) -> usize {
        self.current.len()
    }

    /// Whether there are no nodes.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.current.is_empty()
    }

    /// Appends a copy of node `source` at the same place, flagged as boundary
    /// node, and returns its number.
    pub fn push_copy(&mut self, source: usize, boundary_flag: i32) -> usize {
        self.initial.push(self.initial[source]);
        self.current.push(self.current[source]);
        self.velocity.push(self.velocity[source]);
        self.boundary_flag.push(boundary_flag);
        self.set.push(self.set[source]);
        self.len() - 1
    }
}

/// Elements in deck order: triangles and joints in one table.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct Elements {
    /// Rows of the deck's topology table: how many node numbers each element
    /// shows in state files.
    pub table_rows: usize,
    /// Node numbers, −1 where there is none. Triangles use three (counter-
    /// clockwise), 2D joints four: 0–1 along the first side, 2 faces 1, 3 faces 0.
    pub nodes: Vec<[i32; 6]>,
    /// Nodes on the edges of ten-node tetrahedra, in the order of
    /// [`crate::mechanics::tetrahedron10::EDGES`]; empty where there are none.
    pub edge_nodes: Vec<[i32; 6]>,
    /// Property set (see [`super::Scene`]).
    pub property: Vec<i32>,
    /// What each element is to the joints.
    pub joint_kind: Vec<JointKind>,
    /// Fracture of the network that a joint or a triangle's edge lies on, −1 for none.
    pub fracture: Vec<i32>,
    /// The two triangles of each joint, −1 where there is none or none is known.
    pub sides: Vec<[i32; 2]>,
    /// Contact tag: elements with equal tags never touch, elements without a
    /// positive tag take no part. Elements with a boundary node get their own.
    pub contact_tag: Vec<i32>,
    /// State variables, `state[row][element]`; a material's damage row holds
    /// the damage of its softening triangles.
    pub state: Vec<Vec<f64>>,
}

impl Elements {
    /// Number of elements.
    #[must_use]
    pub fn len(&self) -> usize {
        self.property.len()
    }

    /// Whether there are no elements.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.property.is_empty()
    }

    /// Number of elements up to the last one that is no joint: those beyond have no stress.
    #[must_use]
    pub fn stressed(&self) -> usize {
        let is_body = |kind: &JointKind| *kind == JointKind::NoJoint;
        self.joint_kind.iter().rposition(is_body).map_or(0, |last| last + 1)
    }

    /// The first `N` node numbers of an element as indices.
    ///
    /// Validation guarantees that every element that takes part has them; a
    /// missing one (−1) would wrap and be caught by the slice bound.
    #[must_use]
    pub fn corners<const N: usize>(&self, element: usize) -> [usize; N] {
        std::array::from_fn(|i| self.nodes[element][i] as usize)
    }

    /// The ten node numbers of a quadratic tetrahedron.
    #[must_use]
    pub fn all_nodes(&self, element: usize) -> [usize; 10] {
        let edges = &self.edge_nodes[element];
        std::array::from_fn(|i| {
            (if i < 4 { self.nodes[element][i] } else { edges[i - 4] }) as usize
        })
    }

    /// What a row of the element table holds, −1 where there is no node.
    #[must_use]
    pub fn node_number(&self, element: usize, row: usize) -> i32 {
        let edges = self.edge_nodes.get(element).filter(|edges| edges[0] >= 0);
        let row_of = |nodes: &[i32; 6], row: usize| nodes.get(row).copied().unwrap_or(-1);
        match (edges, row.checked_sub(4)) {
            (Some(edges), Some(row)) => row_of(edges, row),
            _ => row_of(&self.nodes[element], row),
        }
    }

    /// Gives a triangle other corners.
    pub fn set_corners(&mut self, element: usize, corners: [usize; 3]) {
        for (slot, node) in self.nodes[element].iter_mut().zip(corners) {
            *slot = node as i32;
        }
    }

    /// Removes an element; those behind it move down by one.
    pub fn remove(&mut self, element: usize) {
        self.nodes.remove(element);
        self.property.remove(element);
        self.joint_kind.remove(element);
        self.fracture.remove(element);
        self.sides.remove(element);
        self.contact_tag.remove(element);
        for row in &mut self.state {
            row.remove(element);
        }
    }

    /// Appends an element without contact tag whose state variables are zero.
    pub fn push(&mut self, nodes: [i32; 6], property: i32, joint_kind: JointKind) -> usize {
        self.nodes.push(nodes);
        self.property.push(property);
        self.joint_kind.push(joint_kind);
        self.fracture.push(-1);
        self.sides.push([-1; 2]);
        self.contact_tag.push(-1);
        for row in &mut self.state {
            row.push(0.0);
        }
        self.len() - 1
    }
}
