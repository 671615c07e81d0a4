//! Joints between tetrahedra before the first step (spec `y2d3d.md` D.1, D.4).

use super::{
    CapacityError, Families, InsertionReport, MOST_COUNTED, PASSES, Room, name_joint_sets, use_up,
};
use crate::scene::{ElementKind, Elements, Insertion, JointKind, Material, Nodes, Scene};

/// Corners of the four faces, in the original's order.
const FACES: [[usize; 3]; 4] = [[1, 2, 3], [3, 2, 0], [3, 0, 1], [1, 0, 2]];

/// Executes the meshing codes of a scene in three dimensions and sets them to 0. Digits other
/// than 3 do nothing. Copies of nodes join the families of those that they are copies of.
///
/// # Errors
/// If nodes or elements exceed what the deck declares.
pub fn execute_in_space(
    insertion: &mut Insertion,
    nodes: &mut Nodes<3>,
    elements: &mut Elements,
    materials: &mut [Material],
    families: &mut Families,
) -> Result<InsertionReport, CapacityError> {
    name_joint_sets(insertion, materials);
    let mut report = InsertionReport::default();
    let mut codes: Vec<i64> = insertion.combinations.iter().map(|c| c.code).collect();
    for _ in 0..PASSES {
        // elements made in this pass are not processed in it
        let properties = elements.property.clone();
        for (code, combination) in codes.iter_mut().zip(&insertion.combinations) {
            let digit = *code % 10;
            *code /= 10;
            let last = combination.materials.last().and_then(|&m| materials.get(m));
            let meshable = last.is_some_and(|m| m.kind == ElementKind::Tetrahedron);
            report.skipped_combination |= !meshable && digit > 0;
            if digit != 3 || !meshable {
                continue;
            }
            let listed = |&e: &usize| {
                usize::try_from(properties[e]).is_ok_and(|p| combination.materials.contains(&p))
            };
            let tagged: Vec<usize> = (0..properties.len()).filter(listed).collect();
            report.executed += 1;
            let materials = materials.len() as i32;
            families.grow(nodes.len());
            Joining { nodes, elements, families, insertion, materials }.insert(&tagged)?;
        }
    }
    use_up(insertion);
    Ok(report)
}

/// The room that a scene's mesh needs when all joints are inserted, if that is not absurdly much.
#[must_use]
pub fn room_needed_in_space(scene: &Scene<3>) -> Option<Room> {
    let mut scene = scene.clone();
    let mut insertion = scene.insertion.take()?;
    insertion.node_capacity = MOST_COUNTED;
    insertion.element_capacity = MOST_COUNTED;
    let (nodes, elements) = (&mut scene.nodes, &mut scene.elements);
    let families = &mut Families::default();
    execute_in_space(&mut insertion, nodes, elements, &mut scene.materials, families).ok()?;
    Some(Room { nodes: scene.nodes.len(), elements: scene.elements.len() })
}

/// A joint that waits for a second tetrahedron.
struct Candidate {
    element: usize,
    /// Property of the tetrahedron that made it.
    creator: i32,
}

/// The mesh whose tetrahedra are being joined.
struct Joining<'a> {
    nodes: &'a mut Nodes<3>,
    elements: &'a mut Elements,
    families: &'a mut Families,
    insertion: &'a Insertion,
    materials: i32,
}

impl Joining<'_> {
    /// Gives every tetrahedron nodes of its own and joins neighbours by joints. Faces without
    /// neighbour among the listed tetrahedra are closed on themselves.
    fn insert(&mut self, tetrahedra: &[usize]) -> Result<(), CapacityError> {
        let (first_joint, old_nodes) = (self.elements.len(), self.nodes.len());
        // joints of this pass, kept at the highest old node of their face
        let mut waiting: Vec<Vec<Candidate>> = (0..old_nodes).map(|_| Vec::new()).collect();
        for &element in tetrahedra {
            let property = self.elements.property[element];
            let old = self.elements.corners::<4>(element);
            let new = old.map(|n| {
                self.families.add_copy(n);
                self.nodes.push_copy(n, self.nodes.boundary_flag[n])
            });
            for face in FACES {
                let corners = face.map(|i| old[i] as i32);
                let own = face.map(|i| new[i] as i32);
                let list = &mut waiting[face.map(|i| old[i]).into_iter().max().unwrap_or(0)];
                match self.find(list, corners) {
                    Some((joint, creator, turn)) => {
                        for i in 0..3 {
                            self.elements.nodes[joint][3 + i] = own[(turn + i) % 3];
                        }
                        self.elements.sides[joint][1] = element as i32;
                        if let Some(joined) = self.joint_property(property, creator) {
                            self.elements.property[joint] = joined;
                        }
                    }
                    None => {
                        let [a, b, c] = own;
                        let [p, q, r] = corners;
                        let set = self.last_row(property).unwrap_or(-1);
                        let nodes = [a, c, b, p, r, q];
                        let joint = self.elements.push(nodes, set, JointKind::Intact);
                        self.elements.sides[joint][0] = element as i32;
                        list.push(Candidate { element: joint, creator: property });
                    }
                }
            }
            for (slot, node) in self.elements.nodes[element].iter_mut().zip(new) {
                *slot = node as i32;
            }
            self.check_capacity()?;
        }
        self.close(first_joint, old_nodes);
        Ok(())
    }

    /// The newest joint that waits for a tetrahedron with this face, its creator's property, and
    /// by how much its nodes are turned against those of the face.
    fn find(&self, list: &[Candidate], face: [i32; 3]) -> Option<(usize, i32, usize)> {
        list.iter().rev().find_map(|candidate| {
            let lower = &self.elements.nodes[candidate.element][3..];
            let turn = face.iter().position(|&n| n == lower[0])?;
            let fits = (0..3).all(|i| lower[i] == face[(turn + i) % 3]);
            fits.then_some((candidate.element, candidate.creator, turn))
        })
    }

    /// Property code of joints between two materials, of the first table row that joins them.
    fn joint_property(&self, a: i32, b: i32) -> Option<i32> {
        let joins = |m: [i32; 2]| m == [a, b] || m == [b, a];
        let row = self.insertion.pairs.iter().find(|pair| joins(pair.materials))?;
        Some(self.materials + row.joint_set)
    }

    /// Property code of joints inside a material that have one side yet, of the last table row.
    fn last_row(&self, material: i32) -> Option<i32> {
        let inside = |m: [i32; 2]| m == [material; 2];
        let row = self.insertion.pairs.iter().rev().find(|pair| inside(pair.materials))?;
        Some(self.materials + row.joint_set)
    }

    /// Closes the joints that still wait for a second tetrahedron, and flags their nodes where the
    /// deck is to be run so.
    fn close(&mut self, first_joint: usize, old_nodes: usize) {
        for joint in first_joint..self.elements.len() {
            let nodes = &mut self.elements.nodes[joint];
            if nodes[3] < old_nodes as i32 {
                nodes.copy_within(..3, 3);
                self.elements.joint_kind[joint] = JointKind::FreeEdge;
                self.elements.sides[joint][1] = self.elements.sides[joint][0];
            }
        }
        if self.insertion.flags_free_faces {
            let is_closed = |&e: &usize| self.elements.joint_kind[e] == JointKind::FreeEdge;
            let joints = (first_joint..self.elements.len()).filter(is_closed);
            let nodes = joints.flat_map(|joint| self.elements.corners::<3>(joint));
            self.families.flag(nodes, &mut self.nodes.boundary_flag);
        }
    }

    fn check_capacity(&self) -> Result<(), CapacityError> {
        let check = |what, keyword, needed, capacity| {
            let stage = "joint insertion";
            if needed > capacity {
                return Err(CapacityError { what, keyword, stage, needed, capacity });
            }
            Ok(())
        };
        check("nodes", "MNOPO", self.nodes.len(), self.insertion.node_capacity)?;
        check("elements", "MELEM", self.elements.len(), self.insertion.element_capacity)
    }
}
