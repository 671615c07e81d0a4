use nalgebra::SVector;

/// Property code of a joint that has failed: it carries nothing any more.
pub const BROKEN_JOINT: i32 = -1001;
/// Property code of a joint on a free edge, closed when joints were inserted:
/// it has element number but no faces to hold together, and no output record.
pub const CLOSED_EDGE: i32 = -1000;

/// Nodal state in `D` dimensions, one entry per node in deck order.
#[derive(Debug, Clone, Default)]
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
#[derive(Debug, Clone, Default)]
pub struct Elements {
    /// Rows of the deck's topology table: how many node numbers each element
    /// shows in state files.
    pub table_rows: usize,
    /// Node numbers, −1 where there is none. Triangles use three (counter-
    /// clockwise), 2D joints four: 0–1 along the first side, 2 faces 1, 3 faces 0.
    pub nodes: Vec<[i32; 6]>,
    /// Property code (see [`super::Scene`]).
    pub property: Vec<i32>,
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

    /// The first `N` node numbers of an element as indices.
    ///
    /// Validation guarantees that every element that takes part has them; a
    /// missing one (−1) would wrap and be caught by the slice bound.
    #[must_use]
    pub fn corners<const N: usize>(&self, element: usize) -> [usize; N] {
        std::array::from_fn(|i| self.nodes[element][i] as usize)
    }

    /// Gives a triangle other corners.
    pub fn set_corners(&mut self, element: usize, corners: [usize; 3]) {
        for (slot, node) in self.nodes[element].iter_mut().zip(corners) {
            *slot = node as i32;
        }
    }

    /// Appends an element without contact tag whose state variables are zero.
    pub fn push(&mut self, nodes: [i32; 6], property: i32) -> usize {
        self.nodes.push(nodes);
        self.property.push(property);
        self.contact_tag.push(-1);
        for row in &mut self.state {
            row.push(0.0);
        }
        self.len() - 1
    }
}
