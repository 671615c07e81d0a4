//! Insertion of joints between triangles, and separation without joints
//! (spec `y2d3d.md` D.1 code 4, D.3).

use super::{CapacityError, Mesh};
use crate::scene::CLOSED_EDGE;

/// A joint made in this pass.
struct Candidate {
    element: usize,
    /// Property of the triangle that made it.
    creator: i32,
}

/// Joints made in a pass, kept at the higher old node of their edge.
pub(super) struct JointList {
    at: Vec<Vec<Candidate>>,
}

impl JointList {
    pub(super) fn new(nodes: usize) -> Self {
        Self { at: (0..nodes).map(|_| Vec::new()).collect() }
    }

    /// Makes room for joints of nodes made since the pass began.
    fn resize(&mut self, nodes: usize) {
        self.at.resize_with(nodes, Vec::new);
    }

    /// The newest joint that waits for a triangle along a→b.
    fn find(&self, mesh: &Mesh<'_>, a: usize, b: usize) -> Option<&Candidate> {
        let waits = |c: &&Candidate| {
            let nodes = mesh.elements.nodes[c.element];
            nodes[2] == a as i32 && nodes[3] == b as i32
        };
        self.at[a.max(b)].iter().rev().find(waits)
    }
}

/// Gives every triangle nodes of its own and joins neighbours by joints. Edges
/// without neighbour among the listed triangles are closed on themselves.
pub(super) fn insert(
    mesh: &mut Mesh<'_>,
    triangles: &[usize],
    old_nodes: usize,
    joints: &mut JointList,
) -> Result<(), CapacityError> {
    let first_joint = mesh.elements.len();
    joints.resize(mesh.nodes.len());
    let mut inherited_property = -1;
    for &element in triangles {
        let old = mesh.elements.corners::<3>(element);
        let property = mesh.elements.property[element];
        let new = copy_corners(mesh, old);
        for i in 0..3 {
            let j = (i + 1) % 3;
            let (a, b) = (old[i], old[j]);
            if let Some(found) = joints.find(mesh, a, b) {
                let (joint, creator) = (found.element, found.creator);
                if let Some(joined) = mesh.joint_property(property, creator) {
                    mesh.elements.property[joint] = joined;
                }
                mesh.elements.nodes[joint][2] = new[i] as i32;
                mesh.elements.nodes[joint][3] = new[j] as i32;
            } else {
                let own = mesh.joint_property(property, property).unwrap_or(inherited_property);
                inherited_property = own;
                let nodes = [new[i], new[j], b, a].map(|n| n as i32);
                let joint =
                    mesh.elements.push([nodes[0], nodes[1], nodes[2], nodes[3], -1, -1], own);
                joints.at[a.max(b)].push(Candidate { element: joint, creator: property });
            }
        }
        mesh.elements.set_corners(element, new);
        mesh.check_capacity()?;
    }
    for joint in first_joint..mesh.elements.len() {
        let nodes = &mut mesh.elements.nodes[joint];
        if nodes[2] < old_nodes as i32 {
            (nodes[2], nodes[3]) = (nodes[1], nodes[0]);
            mesh.elements.property[joint] = CLOSED_EDGE;
        }
    }
    Ok(())
}

/// Gives every triangle nodes of its own, without joints.
pub(super) fn separate(mesh: &mut Mesh<'_>, triangles: &[usize]) -> Result<(), CapacityError> {
    for &element in triangles {
        let old = mesh.elements.corners::<3>(element);
        let new = copy_corners(mesh, old);
        mesh.elements.set_corners(element, new);
        mesh.check_capacity()?;
    }
    Ok(())
}

fn copy_corners(mesh: &mut Mesh<'_>, old: [usize; 3]) -> [usize; 3] {
    old.map(|node| mesh.nodes.push_copy(node, 1))
}
