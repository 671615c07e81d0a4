//! Cells of an unstructured grid.

/// Kinds of cells, with the numbers VTK gives them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[repr(u8)]
pub enum CellType {
    /// One point.
    Vertex = 1,
    /// Two points.
    Line = 3,
    /// Three points.
    Triangle = 5,
    /// Four points, in order around.
    Quad = 9,
    /// Four points.
    Tetra = 10,
    /// Eight points: one face around, then the opposite face around.
    Hexahedron = 12,
    /// Six points: one triangle, then the opposite triangle.
    Wedge = 13,
    /// Ten points: four corners, then the middles of the edges (0,1), (1,2), (2,0), (0,3), (1,3)
    /// and (2,3).
    QuadraticTetra = 24,
}

impl CellType {
    /// The kind with a number of VTK's; `None` for kinds that no file of ours has.
    pub const fn from_number(number: u8) -> Option<Self> {
        Some(match number {
            1 => Self::Vertex,
            3 => Self::Line,
            5 => Self::Triangle,
            9 => Self::Quad,
            10 => Self::Tetra,
            12 => Self::Hexahedron,
            13 => Self::Wedge,
            24 => Self::QuadraticTetra,
            _ => return None,
        })
    }

    /// Points of a cell of this kind.
    pub const fn points(self) -> usize {
        match self {
            Self::Vertex => 1,
            Self::Line => 2,
            Self::Triangle => 3,
            Self::Quad | Self::Tetra => 4,
            Self::Wedge => 6,
            Self::Hexahedron => 8,
            Self::QuadraticTetra => 10,
        }
    }
}

/// The cells of a grid, in the three arrays that a `.vtu` file holds.
#[derive(Debug, Clone, Default, PartialEq, Eq)]
pub struct Cells {
    connectivity: Vec<i64>,
    offsets: Vec<i64>,
    types: Vec<u8>,
}

impl Cells {
    /// No cells.
    pub fn new() -> Self {
        Self::default()
    }

    /// No cells yet, with room for `cells` of the kind given.
    pub fn with_capacity(kind: CellType, cells: usize) -> Self {
        Self {
            connectivity: Vec::with_capacity(cells * kind.points()),
            offsets: Vec::with_capacity(cells),
            types: Vec::with_capacity(cells),
        }
    }

    /// Adds a cell.
    ///
    /// # Panics
    ///
    /// When the number of points is not that of the kind.
    pub fn push(&mut self, kind: CellType, points: &[u32]) {
        assert_eq!(points.len(), kind.points(), "points of a {kind:?}");
        self.connectivity.extend(points.iter().map(|&p| i64::from(p)));
        self.offsets.push(self.connectivity.len() as i64);
        self.types.push(kind as u8);
    }

    /// Removes all cells and keeps the memory.
    pub fn clear(&mut self) {
        self.connectivity.clear();
        self.offsets.clear();
        self.types.clear();
    }

    /// How many cells there are.
    pub fn len(&self) -> usize {
        self.types.len()
    }

    /// Whether there are no cells.
    pub fn is_empty(&self) -> bool {
        self.types.is_empty()
    }

    /// The points of all cells, one cell after the other.
    pub fn connectivity(&self) -> &[i64] {
        &self.connectivity
    }

    /// Where each cell ends in the connectivity.
    pub fn offsets(&self) -> &[i64] {
        &self.offsets
    }

    /// VTK's number of each cell's kind.
    pub fn types(&self) -> &[u8] {
        &self.types
    }
}
