//! The state at one time.

use ypsilon_converters::stress_measures::SymmetricTensor;

use crate::selection::Mesh;
use crate::vectors::{area_between, length, minus};

/// How a joint is doing.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum JointState {
    /// Below its strength.
    Intact,
    /// Softening somewhere.
    Softening,
    /// Carries nothing any more.
    Broken,
}

/// A joint, halfway between its two sides: a line in the plane, a triangle in space.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joint<const D: usize = 2> {
    /// The two ends of the line or the three corners of the triangle where they are now, m.
    pub ends: [[f64; D]; D],
    /// What they have moved, m.
    pub displacement: [[f64; D]; D],
    /// How it is doing.
    pub state: JointState,
    /// Joint set, where known.
    pub set: Option<i32>,
    /// Damage in [0, 1], where known.
    pub damage: Option<f64>,
    /// Opening in the middle, m, where known.
    pub opening: Option<f64>,
    /// Sliding in the middle, m, where known.
    pub sliding: Option<f64>,
    /// How it failed: 1 in tension, 2 in shear, between them in both; where known.
    pub mode: Option<f64>,
}

impl<const D: usize> Joint<D> {
    /// Length in the plane, m; area in space, m².
    #[must_use]
    pub fn extent(&self) -> f64 {
        match self.ends[..] {
            [a, b] => length(minus(b, a)),
            [a, b, c] => 0.5 * area_between(minus(b, a), minus(c, a)),
            _ => f64::NAN,
        }
    }
}

/// Bodies and joints at one time, in `D` dimensions: elements with `C` corners, triangles in the
/// plane (2, 3) or tetrahedra in space (3, 4). Parts that the files leave out are `None`.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Frame<const D: usize = 2, const C: usize = 3> {
    /// Time, s.
    pub time: f64,
    /// Kinetic energy that the file tells, J.
    pub kinetic_energy: Option<f64>,
    /// Current coordinates, m.
    pub points: Vec<[f64; D]>,
    /// Displacements, m.
    pub displacement: Option<Vec<[f64; D]>>,
    /// Velocities, m/s.
    pub velocity: Option<Vec<[f64; D]>>,
    /// Nodal forces (internal, joints, contact, edge loads), N.
    pub force: Option<Vec<[f64; D]>>,
    /// Nodal masses, kg.
    pub mass: Option<Vec<f64>>,
    /// Node set of each node.
    pub node_set: Option<Vec<i32>>,
    /// Corners of the triangles or tetrahedra.
    pub elements: Vec<[u32; C]>,
    /// Nodes in the middle of the edges 01, 12, 20, 03, 13 and 23 of tetrahedra that have them;
    /// empty where no element has.
    pub edge_nodes: Vec<Option<[u32; 6]>>,
    /// Property (material) of each element, as the deck counts: from 0.
    pub property: Vec<i32>,
    /// Body of each element.
    pub body: Option<Vec<i32>>,
    /// Cauchy stress of each element, xx, yy, zz, xy, yz, xz, Pa, tension positive.
    pub stress: Option<Vec<SymmetricTensor>>,
    /// Damage of each element.
    pub damage: Option<Vec<f64>>,
    /// Joints.
    pub joints: Vec<Joint<D>>,
}

impl<const D: usize, const C: usize> Frame<D, C> {
    /// Where the nodes were at the start, m: where they are now if no displacements are known.
    #[must_use]
    pub fn initial(&self) -> Vec<[f64; D]> {
        match &self.displacement {
            Some(moved) => self.points.iter().zip(moved).map(|(x, u)| minus(*x, *u)).collect(),
            None => self.points.clone(),
        }
    }

    /// Corners of an element among `points`.
    #[must_use]
    pub fn corners(element: [u32; C], points: &[[f64; D]]) -> [[f64; D]; C] {
        element.map(|n| points.get(n as usize).copied().unwrap_or([f64::NAN; D]))
    }

    /// What a selection of nodes is made among, with the places of the nodes at the start.
    #[must_use]
    pub fn mesh<'a>(&'a self, initial: &'a [[f64; D]]) -> Mesh<'a, D, C> {
        Mesh {
            initial,
            node_set: self.node_set.as_deref(),
            elements: &self.elements,
            edge_nodes: &self.edge_nodes,
            property: &self.property,
            body: self.body.as_deref(),
        }
    }

    /// Values at the nodes of an element, corners first, each with its weight where the corners
    /// have these weights: the element's shape functions, linear or quadratic.
    pub fn shape(&self, element: usize, weights: [f64; C]) -> impl Iterator<Item = (u32, f64)> {
        let corners = self.elements.get(element).copied().unwrap_or([u32::MAX; C]);
        let edge_nodes = self.edge_nodes.get(element).copied().flatten();
        let at = move |corner: usize| weights.get(corner).copied().unwrap_or(0.0);
        let is_quadratic = edge_nodes.is_some();
        let of_corners = corners
            .into_iter()
            .zip(weights)
            .map(move |(node, w)| (node, if is_quadratic { w * (2.0 * w - 1.0) } else { w }));
        let edges = [(0, 1), (1, 2), (2, 0), (0, 3), (1, 3), (2, 3)];
        let of_edges = edge_nodes.into_iter().flatten().zip(edges);
        of_corners.chain(of_edges.map(move |(node, (a, b))| (node, 4.0 * at(a) * at(b))))
    }

    /// Kinetic energy: of masses and velocities where both are known, or as the file tells it.
    #[must_use]
    pub fn energy(&self) -> Option<f64> {
        match (&self.mass, &self.velocity) {
            (Some(mass), Some(velocity)) => {
                let square = |v: &[f64; D]| v.iter().map(|x| x * x).sum::<f64>();
                let each = mass.iter().zip(velocity);
                Some(each.map(|(m, v)| 0.5 * m * square(v)).sum())
            }
            _ => self.kinetic_energy,
        }
    }

    /// Every element and every array must fit the points.
    pub(super) fn check(&self) -> Result<(), String> {
        let (points, elements) = (self.points.len(), self.elements.len());
        let on_edges = self.edge_nodes.iter().flatten().flatten();
        let worst = self.elements.iter().flatten().chain(on_edges).max();
        if let Some(node) = worst.filter(|&&node| node as usize >= points) {
            let name = element_name(D);
            return Err(format!("a {name} names node {node}; nodes run from 0 to {points} - 1"));
        }
        let lengths = [
            ("displacements", self.displacement.as_ref().map(Vec::len), points),
            ("velocities", self.velocity.as_ref().map(Vec::len), points),
            ("forces", self.force.as_ref().map(Vec::len), points),
            ("masses", self.mass.as_ref().map(Vec::len), points),
            ("node sets", self.node_set.as_ref().map(Vec::len), points),
            ("properties", Some(self.property.len()), elements),
            ("bodies", self.body.as_ref().map(Vec::len), elements),
            ("stresses", self.stress.as_ref().map(Vec::len), elements),
            ("damages", self.damage.as_ref().map(Vec::len), elements),
        ];
        for (name, found, expected) in lengths {
            if let Some(found) = found.filter(|&found| found != expected) {
                return Err(format!("there are {found} {name}; expected {expected}"));
            }
        }
        Ok(())
    }
}

/// What the elements of so many dimensions are called.
pub(crate) fn element_name(dimension: usize) -> &'static str {
    if dimension > 2 { "tetrahedron" } else { "triangle" }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shape_functions_are_linear_at_corners_and_quadratic_with_nodes_on_edges() {
        let frame = Frame::<3, 4> { elements: vec![[4, 5, 6, 7]], ..Frame::default() };
        let weights = [0.5, 0.25, 0.125, 0.125];
        let linear: Vec<_> = frame.shape(0, weights).collect();
        assert_eq!(linear, [(4, 0.5), (5, 0.25), (6, 0.125), (7, 0.125)]);
        let edge_nodes = vec![Some([8, 9, 10, 11, 12, 13])];
        let frame = Frame { edge_nodes, ..frame };
        let quadratic: Vec<_> = frame.shape(0, weights).collect();
        assert_eq!(quadratic.len(), 10);
        assert_eq!(quadratic[4], (8, 0.5));
        assert_eq!(quadratic[9], (13, 0.0625));
        assert!((quadratic.iter().map(|(_, w)| w).sum::<f64>() - 1.0).abs() < 1e-15);
        // one at a node on an edge, none elsewhere
        let middle: Vec<_> = frame.shape(0, [0.0, 0.5, 0.0, 0.5]).filter(|w| w.1 != 0.0).collect();
        assert_eq!(middle, [(12, 1.0)]);
    }

    #[test]
    fn joints_have_length_or_area() {
        let joint = |ends| Joint {
            ends,
            displacement: [[0.0; 3]; 3],
            state: JointState::Broken,
            set: None,
            damage: None,
            opening: None,
            sliding: None,
            mode: None,
        };
        let corners = [[0.0, 0.0, 1.0], [0.0, 2.0, 1.0], [0.0, 0.0, 4.0]];
        assert_eq!(joint(corners).extent(), 3.0);
    }
}
