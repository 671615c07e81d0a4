/// Refinement and joint insertion to be done in the first step.
#[derive(Debug, Clone, PartialEq)]
pub struct Insertion {
    /// What to do with which materials, in deck order.
    pub combinations: Vec<Combination>,
    /// Joint set between pairs of materials, in deck order.
    pub pairs: Vec<JointPair>,
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
}

impl Insertion {
    /// Whether joints will be inserted.
    #[must_use]
    pub fn inserts_joints(&self) -> bool {
        self.combinations.iter().any(Combination::inserts_joints)
    }
}
