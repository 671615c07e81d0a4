//! Stiffness of contacts that edges have or may get.

use super::super::Simulation;
use crate::{
    contact::PairTable,
    mechanics::Vec2,
    scene::{PairProperties, Scene},
};
use std::collections::HashMap;

/// An edge at which a triangle may touch another.
#[derive(Debug, Clone)]
struct Edge {
    nodes: [u32; 2],
    triangle: u32,
    length: f64,
}

/// Stiffness of contact at each node.
///
/// Two triangles that overlap along an edge of length L, with heights h and h′ above it, resist
/// with 3 p_n L (1/h + 1/h′): the potential rises from 0 at an edge to 3 at the opposite corner.
/// Sliding is resisted with p_t L for each of the two edges.
#[derive(Debug, Clone)]
pub(super) struct ContactStiffness {
    edges: Vec<Edge>,
    /// Stiffest pair that each triangle may be part of.
    pairs: Vec<Option<PairProperties>>,
    /// Smallest height of each triangle, m.
    height: Vec<f64>,
    at_node: Vec<f64>,
    detections: Option<u64>,
}

impl ContactStiffness {
    pub fn of(simulation: &Simulation) -> Self {
        let scene = &simulation.scene;
        let pairs = stiffest_pairs(scene);
        let corners = |e: usize| scene.elements.corners::<3>(e).map(|n| scene.nodes.current[n]);
        let height = |e: usize| pairs[e].map_or(0.0, |_| smallest_height(&corners(e)));
        let mut contact = Self {
            edges: open_edges(scene, &pairs),
            height: (0..pairs.len()).map(height).collect(),
            pairs,
            at_node: vec![0.0; scene.nodes.len()],
            detections: None,
        };
        contact.update(simulation);
        contact
    }

    /// Stiffness at a node, N/m.
    pub fn at(&self, node: usize) -> f64 {
        self.at_node[node]
    }

    /// Takes over the couples of a new detection; whether there was one.
    pub fn update(&mut self, simulation: &Simulation) -> bool {
        let Some(detections) = simulation.couple_work().map(|work| work.detections) else {
            return false;
        };
        if self.detections == Some(detections) {
            return false;
        }
        self.detections = Some(detections);
        let mut facing = self.height.clone();
        for (couple, _) in simulation.couples() {
            let [a, b] = couple.map(|e| e as usize);
            facing[a] = facing[a].min(self.height[b]);
            facing[b] = facing[b].min(self.height[a]);
        }
        self.at_node.fill(0.0);
        for edge in &self.edges {
            let t = edge.triangle as usize;
            let Some(pair) = self.pairs[t] else { continue };
            let (own, other) = (self.height[t], facing[t]);
            let normal = 3.0 * pair.penalty * edge.length * (1.0 / own + 1.0 / other);
            let tangential = 2.0 * pair.tangential_penalty * edge.length;
            for node in edge.nodes {
                self.at_node[node as usize] += normal.max(tangential);
            }
        }
        true
    }
}

/// The largest penalties of the pairs that each element's material is part of; none where it
/// takes no part in contact.
fn stiffest_pairs(scene: &Scene) -> Vec<Option<PairProperties>> {
    let Some(settings) = &scene.contact else { return vec![None; scene.elements.len()] };
    let table = PairTable::new(&scene.materials, &settings.pairs);
    let materials = scene.materials.len() as i32;
    let stiffest = |material: i32| {
        let ranks = (0..materials).filter_map(|other| table.rank(material, other));
        let mut pairs: Vec<PairProperties> = ranks.map(|r| *table.properties(r)).collect();
        if pairs.is_empty() {
            return None;
        }
        pairs.extend(scene.fracture_network.iter().flat_map(|n| &n.fractures).map(|f| f.contact));
        pairs.into_iter().reduce(|a, b| PairProperties {
            penalty: a.penalty.max(b.penalty),
            tangential_penalty: a.tangential_penalty.max(b.tangential_penalty),
            ..a
        })
    };
    let of_material: Vec<Option<PairProperties>> = (0..materials).map(stiffest).collect();
    let of = |p: &i32| usize::try_from(*p).ok().and_then(|p| of_material.get(p).copied().flatten());
    scene.elements.property.iter().map(of).collect()
}

/// Edges that no other triangle shares by its nodes.
fn open_edges(scene: &Scene, pairs: &[Option<PairProperties>]) -> Vec<Edge> {
    let mut open: HashMap<[u32; 2], usize> = HashMap::new();
    let mut edges: Vec<Option<Edge>> = Vec::new();
    for triangle in (0..pairs.len()).filter(|&e| pairs[e].is_some()) {
        let nodes = scene.elements.corners::<3>(triangle);
        for k in 0..3 {
            let ends = [nodes[k], nodes[(k + 1) % 3]];
            let [a, b] = ends.map(|n| n as u32);
            if let Some(twin) = open.remove(&[b, a]) {
                edges[twin] = None;
                continue;
            }
            let [p, q] = ends.map(|n| scene.nodes.current[n]);
            open.insert([a, b], edges.len());
            edges.push(Some(Edge {
                nodes: [a, b],
                triangle: triangle as u32,
                length: (q - p).norm(),
            }));
        }
    }
    edges.into_iter().flatten().collect()
}

fn smallest_height(corners: &[Vec2; 3]) -> f64 {
    let longest = (0..3).map(|k| (corners[(k + 1) % 3] - corners[k]).norm()).fold(0.0, f64::max);
    crate::mechanics::triangle::double_area(corners) / longest
}
