//! The geometry section: initial coordinates and connectivity.

/// Initial coordinates and connectivity.
///
/// Node numbers and materials are those of the file: counted from 1.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Geometry {
    /// Initial coordinates, one entry per node; z is 0 in 2D.
    pub coordinates: Vec<[f32; 3]>,
    /// 8-node solids: tetrahedra and joints of a 3D run.
    pub solids: Vec<Solid>,
    /// 4-node shells: triangles and joints of a 2D run.
    pub shells: Vec<Shell>,
}

/// A 4-node shell: five words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shell {
    /// Node numbers, from 1; a triangle repeats its third.
    pub nodes: [i32; 4],
    /// Material number, from 1.
    pub material: i32,
}

/// An 8-node solid: nine words.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Solid {
    /// Node numbers, from 1; degenerate elements repeat nodes.
    pub nodes: [i32; 8],
    /// Material number, from 1.
    pub material: i32,
}

impl Shell {
    /// A triangle from node indices counted from 0; `material` is written as it is.
    pub fn triangle(nodes: [u32; 3], material: i32) -> Self {
        let [a, b, c] = nodes.map(number);
        Self { nodes: [a, b, c, c], material }
    }

    /// A 2D joint from its node indices counted from 0, in the joint's own order (the first
    /// two on one side, the last two on the other).
    ///
    /// ```
    /// use yformat::d3plot::Shell;
    /// assert_eq!(Shell::joint([10, 11, 20, 21], 2).nodes, [11, 22, 21, 12]);
    /// ```
    pub fn joint(nodes: [u32; 4], material: i32) -> Self {
        let [a, b, c, d] = nodes.map(number);
        Self { nodes: [a, d, c, b], material }
    }

    /// Whether the shell is a triangle: its last two nodes are the same.
    pub fn is_triangle(&self) -> bool {
        self.nodes[2] == self.nodes[3]
    }
}

impl Solid {
    /// A tetrahedron from node indices counted from 0; `material` is written as it is.
    pub fn tetrahedron(nodes: [u32; 4], material: i32) -> Self {
        let [a, b, c, d] = nodes.map(number);
        Self { nodes: [a, b, c, d, d, d, d, d], material }
    }

    /// A 3D joint from its node indices counted from 0 (the first three on one side, the last
    /// three on the other): a wedge.
    ///
    /// ```
    /// use yformat::d3plot::Solid;
    /// assert_eq!(Solid::joint([0, 1, 2, 3, 4, 5], 1).nodes, [1, 2, 5, 4, 3, 3, 6, 6]);
    /// ```
    pub fn joint(nodes: [u32; 6], material: i32) -> Self {
        let [a, b, c, d, e, f] = nodes.map(number);
        Self { nodes: [a, b, e, d, c, c, f, f], material }
    }

    /// Whether the solid is a tetrahedron: its last five nodes are the same.
    pub fn is_tetrahedron(&self) -> bool {
        self.nodes[4..].iter().all(|&n| n == self.nodes[3])
    }

    /// Whether the solid is a wedge: a 3D joint.
    pub fn is_wedge(&self) -> bool {
        let n = &self.nodes;
        !self.is_tetrahedron() && n[4] == n[5] && n[6] == n[7]
    }
}

/// The number of the node with this index. The control block limits nodes to `i32::MAX`, so
/// an index of a node that exists never saturates.
fn number(index: u32) -> i32 {
    i32::try_from(index).map_or(i32::MAX, |i| i.saturating_add(1))
}
