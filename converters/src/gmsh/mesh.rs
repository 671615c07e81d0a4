//! A mesh as Gmsh files give it.

/// A node.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Node {
    /// Number in the file: from 1, with gaps, in any order.
    pub tag: i64,
    /// Coordinates; finite.
    pub position: [f64; 3],
}

/// The kinds of elements that a plane mesh consists of.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ElementKind {
    /// A point.
    Point,
    /// A line of two nodes.
    Line,
    /// A triangle of three nodes.
    Triangle,
    /// A quadrangle of four nodes, in order around.
    Quadrangle,
}

impl ElementKind {
    /// How many nodes it has.
    #[must_use]
    pub fn nodes(self) -> usize {
        match self {
            Self::Point => 1,
            Self::Line => 2,
            Self::Triangle => 3,
            Self::Quadrangle => 4,
        }
    }

    /// Dimension of the physical groups that it can belong to.
    #[must_use]
    pub fn dimension(self) -> i64 {
        match self {
            Self::Point => 0,
            Self::Line => 1,
            Self::Triangle | Self::Quadrangle => 2,
        }
    }
}

/// An element. Version 2.2 gives one that belongs to several physical groups several times.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Element {
    /// Number in the file.
    pub tag: i64,
    /// Kind.
    pub kind: ElementKind,
    /// Node numbers of the file, as many as the kind has nodes.
    pub nodes: Vec<i64>,
    /// Tag of the physical group, above 0, if it belongs to one.
    pub group: Option<i64>,
}

/// A name of a physical group.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct PhysicalName {
    /// Dimension of the group.
    pub dimension: i64,
    /// Its tag.
    pub tag: i64,
    /// Its name.
    pub name: String,
}

/// A mesh as the file gives it.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Mesh {
    /// Names of physical groups.
    pub names: Vec<PhysicalName>,
    /// Nodes in the order of the file.
    pub nodes: Vec<Node>,
    /// Elements in the order of the file.
    pub elements: Vec<Element>,
    /// What the file says and this does not: entities in several groups.
    pub notes: Vec<String>,
}

impl Mesh {
    /// Name of a physical group, if the file gives one.
    #[must_use]
    pub fn group_name(&self, dimension: i64, tag: i64) -> Option<&str> {
        let mut names = self.names.iter();
        names.find(|n| n.dimension == dimension && n.tag == tag).map(|n| n.name.as_str())
    }
}
