//! Which triangles are bonded to each other by joints and may not become couples
//! (classic, spec `contact.md` 1.6).

use crate::scene::{Elements, JointKind};

/// Joints around triangles.
#[derive(Debug, Clone, Copy)]
pub struct Bonds<'a> {
    /// Joint on each edge of each triangle, −1 for none.
    pub edge_joint: &'a [[i32; 3]],
}

impl Bonds<'_> {
    /// Whether a pair is left out: two triangles inside unbroken material, two
    /// that an intact joint holds together, or two that share a node.
    #[must_use]
    pub fn exclude(&self, elements: &Elements, a: u32, b: u32) -> bool {
        let (a, b) = (a as usize, b as usize);
        let intact = |joint: &i32| {
            usize::try_from(*joint).is_ok_and(|j| elements.joint_kind[j] == JointKind::Intact)
        };
        let (of_a, of_b) = (&self.edge_joint[a], &self.edge_joint[b]);
        if of_a.iter().chain(of_b).all(intact) {
            return true;
        }
        if of_a.iter().any(|joint| of_b.contains(joint) && intact(joint)) {
            return true;
        }
        let [nodes_a, nodes_b] = [a, b].map(|e| elements.corners::<3>(e));
        nodes_a.iter().any(|node| nodes_b.contains(node))
    }
}
