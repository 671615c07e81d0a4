//! What a kind of mesh hands to the deck: mesh, materials, supports, where loads act.

use super::{
    MeshingError,
    mesh::Mesh,
    pattern::Point,
    properties::{Joint, Material},
};
use std::collections::{BTreeMap, BTreeSet};

/// Pairs of time \[s\] and factor, linear in between and constant outside.
pub type History = Vec<[f64; 2]>;

/// A material with the part that it plays.
#[derive(Debug, Clone, PartialEq)]
pub struct Substance {
    /// Its name.
    pub name: &'static str,
    /// Its properties.
    pub material: Material,
    /// How its triangles hold together.
    pub bond: Bond,
}

/// How triangles of a material hold together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Bond {
    /// They share nodes; neighbours of other materials are touched only.
    Continuous,
    /// By joints: the strong ones inside a block, mortar between blocks.
    Blocks,
    /// By joints, all of them strong, also to other materials with joints.
    Strong,
}

/// The two kinds of joints.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Joints {
    /// Between triangles of a block.
    pub inside: Joint,
    /// Between blocks.
    pub mortar: Joint,
}

/// What moves the nodes of a set in one direction.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Drive {
    /// Forces: those of elements and contacts, and this one for each of the deck's nodes \[N\].
    Force(f64),
    /// A velocity \[m/s\].
    Velocity(f64),
}

/// What moves a node of a mesh in so many dimensions: all directions share the history.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion<const D: usize = 2> {
    /// Along each axis.
    pub drives: [Drive; D],
    /// The same in the second stage, if that differs.
    pub later: Option<[Drive; D]>,
    /// Factor of all over time; empty for a constant 1.
    pub history: History,
}

impl<const D: usize> Motion<D> {
    /// No force from outside.
    pub const FREE: Self =
        Motion { drives: [Drive::Force(0.0); D], later: None, history: Vec::new() };
    /// At rest for ever.
    pub const CLAMPED: Self =
        Motion { drives: [Drive::Velocity(0.0); D], later: None, history: Vec::new() };
}

/// A mesh with all that a deck needs but times and loads.
#[derive(Debug, Clone)]
pub struct Model {
    /// One line that says what it is.
    pub title: String,
    /// Nodes and triangles.
    pub mesh: Mesh,
    /// The materials that triangles point to.
    pub substances: Vec<Substance>,
    /// Joints, where substances are bonded by them.
    pub joints: Option<Joints>,
    /// Nodes that are held or driven, by name.
    pub supports: Vec<Support>,
    /// Nodes of the top, from left to right, that can be loaded.
    pub top: Vec<usize>,
    /// Velocities at the start; zero where there are none \[m/s\].
    pub velocities: BTreeMap<usize, Point>,
    /// Places at the start, where they are not those of the mesh, which is free of stress \[m\].
    pub start: BTreeMap<usize, Point>,
    /// What the triangles have to cover \[m²\].
    pub area: f64,
    /// Number of bodies.
    pub bodies: usize,
    /// When the second stage begins, if there is one \[s\].
    pub second_stage_s: Option<f64>,
    /// When what the model itself does is over \[s\].
    pub settled_s: f64,
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// What is worth telling.
    pub notes: Vec<String>,
}

/// Named nodes with their motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Support<const D: usize = 2> {
    /// Name, for comments.
    pub name: String,
    /// The nodes.
    pub nodes: Vec<usize>,
    /// What moves them.
    pub motion: Motion<D>,
}

impl Model {
    /// Whether a triangle is bonded by joints.
    #[must_use]
    pub fn bonded(&self, material: usize) -> bool {
        self.joints.is_some() && self.substances[material].bond != Bond::Continuous
    }

    /// Number of copies that joint insertion makes of each node: one for each bonded triangle at
    /// it. The node itself counts where other triangles keep it.
    #[must_use]
    pub fn copies(&self) -> Vec<usize> {
        let mut copies = vec![0; self.mesh.nodes.len()];
        let mut kept = vec![false; copies.len()];
        for triangle in &self.mesh.triangles {
            for node in triangle.nodes {
                match self.bonded(triangle.material) {
                    true => copies[node] += 1,
                    false => kept[node] = true,
                }
            }
        }
        copies.iter().zip(kept).map(|(n, kept)| n + usize::from(kept)).collect()
    }

    /// Nodes whose place fulfils a condition.
    pub(super) fn nodes_where(&self, condition: impl Fn(Point) -> bool) -> Vec<usize> {
        (0..self.mesh.nodes.len()).filter(|&n| condition(self.mesh.nodes[n])).collect()
    }

    /// Checks areas, neighbours, cover and connection.
    ///
    /// Triangles that all run counter-clockwise, lie on both sides of their shared edges and cover
    /// exactly the area of the outline do not overlap.
    ///
    /// # Errors
    /// If the mesh is not sound.
    pub fn check(&self) -> Result<(), MeshingError> {
        let mut edges: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        let mut body: Vec<usize> = (0..self.mesh.nodes.len()).collect();
        for (index, triangle) in self.mesh.triangles.iter().enumerate() {
            let [x, y] = super::pattern::middle(&self.mesh.corners(triangle));
            let area = self.mesh.area(triangle);
            if area.is_nan() || area <= 0.0 {
                return Err(MeshingError::FlatBlock { x, y, area });
            }
            for k in 0..3 {
                let edge = [triangle.nodes[k], triangle.nodes[(k + 1) % 3]];
                if edges.insert(edge, index).is_some() {
                    let [[x0, y0], [x1, y1]] = edge.map(|node| self.mesh.nodes[node]);
                    return Err(MeshingError::Overlap { x0, y0, x1, y1 });
                }
                join(&mut body, edge);
            }
        }
        let covered = self.mesh.total_area();
        if (covered - self.area).abs() > 1e-9 * self.area {
            let help = "choose other numbers of courses or voussoirs";
            return Err(MeshingError::Cover { covered, expected: self.area, help });
        }
        let roots: BTreeSet<usize> = (0..body.len()).map(|n| root(&mut body, n)).collect();
        if roots.len() != self.bodies {
            return Err(MeshingError::Parts { parts: roots.len(), expected: self.bodies });
        }
        Ok(())
    }
}

/// The representative of a node's body.
fn root(body: &mut [usize], mut node: usize) -> usize {
    while body[node] != node {
        body[node] = body[body[node]];
        node = body[node];
    }
    node
}

fn join(body: &mut [usize], [a, b]: [usize; 2]) {
    let (a, b) = (root(body, a), root(body, b));
    body[a.max(b)] = a.min(b);
}
