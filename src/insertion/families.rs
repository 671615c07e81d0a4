use serde::{Deserialize, Serialize};

/// Which nodes are copies of the same node: joint insertion gives every tetrahedron nodes of its
/// own.
#[derive(Debug, Clone, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct Families {
    /// The node that each is a copy of in the end, itself for those of the deck; nodes beyond were
    /// never copied.
    origin: Vec<u32>,
}

impl Families {
    /// Takes in all nodes so far.
    pub(super) fn grow(&mut self, nodes: usize) {
        self.origin.extend(self.origin.len() as u32..nodes as u32);
    }

    /// Takes in a copy, whose number is the next.
    pub(super) fn add_copy(&mut self, source: usize) {
        self.origin.push(self.origin[source]);
    }

    fn origin(&self, node: usize) -> usize {
        self.origin.get(node).map_or(node, |&origin| origin as usize)
    }

    /// Flags the families of some nodes as boundary nodes.
    pub fn flag(&self, nodes: impl IntoIterator<Item = usize>, flags: &mut [i32]) {
        let mut is_due = vec![false; flags.len()];
        nodes.into_iter().for_each(|node| is_due[self.origin(node)] = true);
        for (node, flag) in flags.iter_mut().enumerate() {
            if is_due[self.origin(node)] {
                *flag = 1;
            }
        }
    }

    /// Whether they can be those of so many nodes.
    #[must_use]
    pub fn fits(&self, nodes: usize) -> bool {
        let is_older = |(node, &origin): (usize, &u32)| origin as usize <= node;
        self.origin.len() <= nodes && self.origin.iter().enumerate().all(is_older)
    }
}
