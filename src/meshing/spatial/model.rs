//! What a kind of structure in space hands to the deck.

use super::mesh::{Place, SpatialMesh};
use crate::meshing::{
    MeshingError,
    model::{Bond, Joints, Motion, Substance, Support},
    properties::Material,
};
use std::collections::{BTreeMap, BTreeSet};

/// A mesh in space with all that a deck needs but times.
#[derive(Debug, Clone)]
pub struct SpatialModel {
    /// One line that says what it is.
    pub title: String,
    /// Nodes and tetrahedra.
    pub mesh: SpatialMesh,
    /// The materials that tetrahedra point to.
    pub substances: Vec<Substance>,
    /// Joints, where substances are bonded by them.
    pub joints: Option<Joints>,
    /// Whether bonded tetrahedra touch only where a joint between them has failed: for runs that follow
    /// the published source, which flags the nodes of such joints.
    pub contact_at_cracks: bool,
    /// Nodes that are held or driven, by name; later ones replace earlier ones.
    pub supports: Vec<Support<3>>,
    /// Velocities at the start; zero where there are none \[m/s\].
    pub velocities: BTreeMap<usize, Place>,
    /// Places at the start, where they are not those of the mesh, which is free of stress \[m\].
    pub start: BTreeMap<usize, Place>,
    /// What the tetrahedra have to fill \[m³\].
    pub volume: f64,
    /// Number of bodies: parts that share no node.
    pub bodies: usize,
    /// When what the model itself does is over \[s\].
    pub settled_s: f64,
    /// Vertical acceleration \[m/s²\].
    pub gravity_m_s2: f64,
    /// What is worth telling.
    pub notes: Vec<String>,
}

impl SpatialModel {
    /// A model of separate bodies without joints.
    pub(super) fn of_bodies(
        title: &str,
        mesh: SpatialMesh,
        volume: f64,
        materials: Vec<(&'static str, Material)>,
    ) -> Self {
        let substance = |(name, material)| Substance { name, material, bond: Bond::Continuous };
        SpatialModel {
            title: title.to_owned(),
            volume,
            bodies: mesh.blocks,
            mesh,
            substances: materials.into_iter().map(substance).collect(),
            joints: None,
            contact_at_cracks: false,
            supports: Vec::new(),
            velocities: BTreeMap::new(),
            start: BTreeMap::new(),
            settled_s: 1.0,
            gravity_m_s2: -9.81,
            notes: Vec::new(),
        }
    }

    /// Whether a tetrahedron of a material is bonded by joints.
    #[must_use]
    pub fn bonded(&self, material: usize) -> bool {
        self.joints.is_some() && self.substances[material].bond != Bond::Continuous
    }

    /// Nodes whose place fulfils a condition.
    pub(super) fn nodes_where(&self, condition: impl Fn(Place) -> bool) -> Vec<usize> {
        (0..self.mesh.nodes.len()).filter(|&n| condition(self.mesh.nodes[n])).collect()
    }

    /// Adds a support.
    pub(super) fn hold(&mut self, name: &str, nodes: Vec<usize>, motion: Motion<3>) {
        self.supports.push(Support { name: name.to_owned(), nodes, motion });
    }

    /// Checks volumes, neighbours and connection.
    ///
    /// Tetrahedra that are not inside out, lie on both sides of their shared faces and fill
    /// exactly the volume of the outline do not overlap.
    ///
    /// # Errors
    /// If the mesh is not sound.
    pub fn check(&self) -> Result<(), MeshingError> {
        let mesh = &self.mesh;
        let mut body: Vec<usize> = (0..mesh.nodes.len()).collect();
        for tetrahedron in &mesh.tetrahedra {
            let volume = mesh.volume(tetrahedron);
            if volume.is_nan() || volume <= 0.0 {
                let [x, y, z] = mesh.nodes[tetrahedron.nodes[0]];
                return Err(MeshingError::FlatTetrahedron { x, y, z, volume });
            }
            for pair in tetrahedron.nodes.windows(2) {
                let (a, b) = (root(&mut body, pair[0]), root(&mut body, pair[1]));
                body[a.max(b)] = a.min(b);
            }
        }
        if let Some((face, _)) = mesh.faces().iter().find(|(_, sides)| sides.len() > 2) {
            let [x, y, z] = mesh.nodes[face[0]];
            return Err(MeshingError::OverlapInSpace { x, y, z });
        }
        let filled = mesh.total_volume();
        if (filled - self.volume).abs() > 1e-9 * self.volume {
            return Err(MeshingError::Fill { filled, expected: self.volume });
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
