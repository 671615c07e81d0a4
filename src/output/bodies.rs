//! Bodies: sets of triangles that hang together through shared nodes or live
//! joints. Fragments get numbers of their own as joints fail.

use crate::simulation::{JointCondition, Simulation, joint_views};

/// Body number of each element (0, 1, ... by lowest element number); −1 for
/// elements that are no triangles.
#[must_use]
pub fn body_of_elements(simulation: &Simulation) -> Vec<i32> {
    let scene = simulation.scene();
    let mut sets = DisjointSets::new(scene.nodes.len());
    let triangles: Vec<usize> = simulation.triangles().collect();
    for &triangle in &triangles {
        let [a, b, c] = scene.elements.corners::<3>(triangle);
        sets.join(a, b);
        sets.join(b, c);
    }
    for joint in joint_views(simulation).filter(|j| j.condition != JointCondition::Broken) {
        let [a, b, c, d] = joint.nodes;
        sets.join(a, d);
        sets.join(b, c);
    }
    let mut number_of_root = vec![-1; scene.nodes.len()];
    let mut bodies = vec![-1; scene.elements.len()];
    let mut count = 0;
    for &triangle in &triangles {
        let number = &mut number_of_root[sets.root(scene.elements.corners::<3>(triangle)[0])];
        if *number < 0 {
            *number = count;
            count += 1;
        }
        bodies[triangle] = *number;
    }
    bodies
}

/// Union-find with path halving.
pub(super) struct DisjointSets {
    parent: Vec<usize>,
}

impl DisjointSets {
    pub fn new(len: usize) -> Self {
        Self { parent: (0..len).collect() }
    }

    pub fn root(&mut self, mut node: usize) -> usize {
        while self.parent[node] != node {
            self.parent[node] = self.parent[self.parent[node]];
            node = self.parent[node];
        }
        node
    }

    pub fn join(&mut self, a: usize, b: usize) {
        let (a, b) = (self.root(a), self.root(b));
        self.parent[a.max(b)] = a.min(b);
    }
}
