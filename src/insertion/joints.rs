//! Insertion of joints between triangles, and separation without joints
//! (spec `y2d3d.md` D.1 code 4, D.3).

use super::{CapacityError, Mesh, trace::Trace};
use crate::{
    TOLERANCE,
    mechanics::Vec2,
    scene::{FractureTreatment, Interfaces, JointKind},
};

/// A joint made in this pass.
struct Candidate {
    element: usize,
    /// Property of the triangle that made it.
    creator: i32,
}

/// Joints made in a pass, kept at the higher old node of their edge.
struct JointList {
    at: Vec<Vec<Candidate>>,
}

impl JointList {
    fn new(nodes: usize) -> Self {
        Self { at: (0..nodes).map(|_| Vec::new()).collect() }
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
) -> Result<(), CapacityError> {
    let first_joint = mesh.elements.len();
    let mut joints = JointList::new(mesh.nodes.len());
    let trace = mesh.network.map(|network| Trace::new(network, mesh.nodes));
    let mut inherited_property = -1;
    for &element in triangles {
        let old = mesh.elements.corners::<3>(element);
        let property = mesh.elements.property[element];
        let new = copy_corners(mesh, old);
        for i in 0..3 {
            let j = (i + 1) % 3;
            let (a, b) = (old[i], old[j]);
            let fracture = trace.as_ref().and_then(|t| t.along(mesh.nodes, a, b));
            if let Some(fracture) = fracture {
                mesh.elements.fracture[element] = fracture as i32;
            }
            if let Some(found) = joints.find(mesh, a, b) {
                let (joint, creator) = (found.element, found.creator);
                if let Some(joined) = mesh.joint_property(property, creator) {
                    mesh.elements.property[joint] = joined;
                    if let Some((network, fracture)) = mesh.network.zip(fracture) {
                        mesh.elements.fracture[joint] = fracture as i32;
                        if network.common == Some(FractureTreatment::Broken) {
                            mesh.elements.joint_kind[joint] = JointKind::Broken;
                        }
                    }
                }
                mesh.elements.sides[joint][1] = element as i32;
                mesh.elements.nodes[joint][2] = new[i] as i32;
                mesh.elements.nodes[joint][3] = new[j] as i32;
            } else {
                let own = mesh.joint_property(property, property).unwrap_or(inherited_property);
                inherited_property = own;
                let [p, q, r, s] = [new[i], new[j], b, a].map(|n| n as i32);
                let joint = mesh.elements.push([p, q, r, s, -1, -1], own, JointKind::Intact);
                mesh.elements.sides[joint][0] = element as i32;
                joints.at[a.max(b)].push(Candidate { element: joint, creator: property });
            }
        }
        mesh.elements.set_corners(element, new);
        mesh.check_capacity()?;
    }
    close(mesh, first_joint, old_nodes);
    Ok(())
}

/// Closes the joints that still wait for a second triangle: as old fractures
/// where another of them lies at the same place, as free edges elsewhere.
fn close(mesh: &mut Mesh<'_>, first_joint: usize, old_nodes: usize) {
    let merges = mesh.insertion.interfaces == Interfaces::Fractures;
    let mut joint = first_joint;
    while joint < mesh.elements.len() {
        if waits(mesh, joint, old_nodes) {
            let other = merges.then(|| coincident(mesh, joint, old_nodes)).flatten();
            if let Some(other) = other {
                merge(mesh, joint, other);
            } else {
                let nodes = &mut mesh.elements.nodes[joint];
                (nodes[2], nodes[3]) = (nodes[1], nodes[0]);
                mesh.elements.joint_kind[joint] = JointKind::FreeEdge;
                mesh.elements.sides[joint][1] = mesh.elements.sides[joint][0];
            }
        }
        joint += 1;
    }
}

fn waits(mesh: &Mesh<'_>, joint: usize, old_nodes: usize) -> bool {
    mesh.elements.joint_kind[joint] == JointKind::Intact
        && mesh.elements.nodes[joint][2] < old_nodes as i32
}

/// The first later joint that waits along the same edge the other way round.
fn coincident(mesh: &Mesh<'_>, joint: usize, old_nodes: usize) -> Option<usize> {
    let ends = |j: usize| mesh.elements.corners::<2>(j).map(|n| mesh.nodes.initial[n]);
    let same = |p: Vec2, q: Vec2| {
        let d = p - q;
        d.x.abs() < TOLERANCE && d.y.abs() < TOLERANCE
    };
    let [a, b] = ends(joint);
    (joint + 1..mesh.elements.len()).find(|&other| {
        waits(mesh, other, old_nodes) && {
            let [c, d] = ends(other);
            same(a, d) && same(b, c)
        }
    })
}

/// Makes one old fracture of two joints that wait at the same place; its first
/// side is the upper one (spec `mechanics.md` 5.3).
fn merge(mesh: &mut Mesh<'_>, joint: usize, other: usize) {
    let [a, b] = mesh.elements.corners::<2>(joint).map(|n| mesh.nodes.initial[n]);
    let normal = Vec2::new(b.y - a.y, a.x - b.x);
    let is_lower = normal.y > TOLERANCE || (normal.y.abs() <= TOLERANCE && normal.x > 0.0);
    let (first, second) = if is_lower { (other, joint) } else { (joint, other) };
    let elements = &mut *mesh.elements;
    let [p, q] = [0, 1].map(|i| elements.nodes[first][i]);
    let [r, s] = [0, 1].map(|i| elements.nodes[second][i]);
    let sides = [elements.sides[first][0], elements.sides[second][0]];
    elements.nodes[joint] = [p, q, r, s, -1, -1];
    elements.sides[joint] = sides;
    elements.joint_kind[joint] = JointKind::PreExisting;
    elements.remove(other);
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
