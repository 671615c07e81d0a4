use super::Interfaces;

/// Refinement and joint insertion to be done in the first step.
#[derive(Debug, Clone, PartialEq)]
pub struct Insertion {
    /// What to do with which materials, in deck order.
    pub combinations: Vec<Combination>,
    /// Joint set between pairs of materials, in deck order.
    pub pairs: Vec<JointPair>,
    /// What becomes of edges without neighbour.
    pub interfaces: Interfaces,
    /// Whether faces of tetrahedra without neighbour flag their nodes as boundary nodes (spec
    /// `y2d3d.md` D.4).
    pub flags_free_faces: bool,
    /// Number of nodes that the deck leaves room for.
    pub node_capacity: usize,
    /// Number of elements that the deck leaves room for.
    pub element_capacity: usize,
}

/// One record of the meshing table.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Combination {
    /// Decimal digits are executed from the right, one per pass: 1 each
    /// triangle into 4, 2 into 6, 3 joints, 4 separation.
    pub code: i64,
    /// Materials it applies to.
    pub materials: Vec<usize>,
}

/// Joint set to be used between two materials (or inside one).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct JointPair {
    /// The two materials.
    pub materials: [i32; 2],
    /// Joint set.
    pub joint_set: i32,
}

impl Combination {
    /// Whether a digit of the code asks for joints.
    #[must_use]
    pub fn inserts_joints(&self) -> bool {
        self.code.to_string().contains('3')
    }

    /// How many triangles `triangles` become.
    #[must_use]
    pub fn refined(&self, triangles: u64) -> u64 {
        self.code.to_string().chars().fold(triangles, |sum, digit| match digit {
            '1' => sum.saturating_mul(4),
            '2' => sum.saturating_mul(6),
            _ => sum,
        })
    }
}

impl Insertion {
    /// Whether it changes the mesh at all: codes of 0 do nothing.
    #[must_use]
    pub fn changes_mesh(&self) -> bool {
        self.combinations.iter().any(|c| c.code != 0)
    }

    /// Whether joints will be inserted.
    #[must_use]
    pub fn inserts_joints(&self) -> bool {
        self.combinations.iter().any(Combination::inserts_joints)
    }
}
