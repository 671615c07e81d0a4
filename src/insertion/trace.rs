//! Which edges lie on fractures of a network (Y-Geo, spec `mechanics.md` 7.5).

use crate::scene::{FractureNetwork, Nodes};
use std::collections::HashMap;

/// Fractures by the places of their nodes.
pub(super) struct Trace {
    at: HashMap<[u64; 2], Vec<usize>>,
}

impl Trace {
    pub fn new(network: &FractureNetwork, nodes: &Nodes<2>) -> Self {
        let mut at: HashMap<[u64; 2], Vec<usize>> = HashMap::new();
        for (fracture, listed) in network.fractures.iter().enumerate() {
            for &node in &listed.nodes {
                let here = at.entry(place(nodes, node)).or_default();
                if here.last() != Some(&fracture) {
                    here.push(fracture);
                }
            }
        }
        Self { at }
    }

    /// The last fracture that passes both ends of an edge: their initial
    /// coordinates must be exactly those of two of its nodes.
    pub fn along(&self, nodes: &Nodes<2>, a: usize, b: usize) -> Option<usize> {
        let through = |n| self.at.get(&place(nodes, n));
        let (at_a, at_b) = (through(a)?, through(b)?);
        at_a.iter().rev().copied().find(|fracture| at_b.contains(fracture))
    }
}

/// Initial coordinates as a key; both zeros are one.
fn place(nodes: &Nodes<2>, node: usize) -> [u64; 2] {
    let at = nodes.initial[node];
    [(at.x + 0.0).to_bits(), (at.y + 0.0).to_bits()]
}
