//! Lists made once per mesh, so that the step loop visits only what carries
//! force, in the original's order, and looks nothing up.

use crate::{
    mechanics::{
        Vec2,
        triangle::{Elasticity, ReferenceShape, contains},
    },
    scene::{ElementKind, ProbeQuantity, Scene},
};

/// A triangle with stress.
#[derive(Debug, Clone)]
pub(super) struct PlannedTriangle {
    pub element: u32,
    pub corners: [u32; 3],
    pub reference: ReferenceShape,
    /// Whether one of its edges may carry pressure or traction.
    pub has_loaded_edge: bool,
}

/// Triangles of one material.
#[derive(Debug, Clone)]
pub(super) struct Batch {
    pub material: usize,
    pub kind: ElementKind,
    pub elasticity: Elasticity,
    pub triangles: Vec<PlannedTriangle>,
}

/// A live joint.
#[derive(Debug, Clone)]
pub(super) struct PlannedJoint {
    pub element: u32,
    pub law: u32,
    pub corners: [u32; 4],
}

/// A rigid triangle.
#[derive(Debug, Clone)]
pub(super) struct PlannedRigid {
    pub material: usize,
    pub corners: [u32; 3],
}

/// A node that moves.
#[derive(Debug, Clone, Copy)]
pub(super) struct PlannedNode {
    pub node: u32,
    pub set: u32,
}

/// A probe and the triangle that it lies in.
#[derive(Debug, Clone)]
pub(super) struct PlannedProbe {
    pub probe: usize,
    pub element: u32,
}

/// Everything that the step loop visits.
#[derive(Debug, Clone, Default)]
pub(super) struct Plan {
    /// Materials ascending, elements ascending within.
    pub batches: Vec<Batch>,
    pub rigid: Vec<PlannedRigid>,
    /// Joint sets ascending, elements ascending within.
    pub joints: Vec<PlannedJoint>,
    /// Node sets ascending, nodes ascending within.
    pub nodes: Vec<PlannedNode>,
    pub probes: Vec<PlannedProbe>,
    /// Nodes at the place of a force probe.
    pub force_probes: Vec<(usize, u32)>,
    /// Mass that elastic triangles give the nodes.
    pub nodal_mass: Vec<f64>,
    /// Whether softening or rigid triangles change the masses during a step.
    pub masses_change: bool,
    pub kinetic_energy_probes: bool,
}

impl Plan {
    pub fn new(scene: &Scene) -> Self {
        let mut plan = Self { nodal_mass: vec![0.0; scene.nodes.len()], ..Self::default() };
        for material in 0..scene.materials.len() {
            plan.add_material(scene, material);
        }
        for law in 0..scene.cohesive_laws.len() {
            plan.add_joints(scene, law);
        }
        for set in 0..scene.node_sets.len() {
            let members = (0..scene.nodes.len()).filter(|&n| scene.nodes.set[n] == set as i32);
            plan.nodes.extend(members.map(|n| PlannedNode { node: n as u32, set: set as u32 }));
        }
        plan.add_force_probes(scene);
        plan
    }

    fn add_material(&mut self, scene: &Scene, material: usize) {
        let m = &scene.materials[material];
        let members = (0..scene.elements.len())
            .filter(|&e| scene.elements.property[e] == material as i32)
            .map(|e| (e as u32, scene.elements.corners::<3>(e)));
        match m.kind {
            ElementKind::Inert(_) => {}
            ElementKind::RigidTriangle => {
                self.masses_change = true;
                self.rigid.extend(members.map(|(_, corners)| PlannedRigid {
                    material,
                    corners: corners.map(|n| n as u32),
                }));
            }
            ElementKind::ElasticTriangle | ElementKind::SofteningTriangle => {
                let elastic = m.kind == ElementKind::ElasticTriangle;
                self.masses_change |= !elastic;
                let mut triangles = Vec::new();
                for (element, corners) in members {
                    let shape = corners.map(|n| scene.nodes.initial[n]);
                    let reference = ReferenceShape::new(&shape);
                    if elastic {
                        for node in corners {
                            self.nodal_mass[node] += reference.nodal_mass(m.density);
                        }
                    }
                    if elastic {
                        self.add_probes(scene, element, &shape);
                    }
                    triangles.push(PlannedTriangle {
                        element,
                        corners: corners.map(|n| n as u32),
                        reference,
                        has_loaded_edge: elastic && has_loaded_edge(scene, &corners),
                    });
                }
                let elasticity = Elasticity {
                    lame_lambda: m.lame_lambda,
                    shear_modulus: m.shear_modulus,
                    viscosity: m.viscosity,
                };
                self.batches.push(Batch { material, kind: m.kind, elasticity, triangles });
            }
        }
    }

    fn add_probes(&mut self, scene: &Scene, element: u32, shape: &[Vec2; 3]) {
        for (probe, p) in scene.probes.iter().enumerate() {
            if p.quantity.is_elemental() && contains(shape, Vec2::from(p.point)) {
                self.probes.push(PlannedProbe { probe, element });
            }
        }
    }

    fn add_joints(&mut self, scene: &Scene, law: usize) {
        if !scene.cohesive_laws[law].is_cohesive {
            return;
        }
        let property = (scene.materials.len() + law) as i32;
        for element in 0..scene.elements.len() {
            if scene.elements.property[element] == property {
                let corners = scene.elements.corners::<4>(element).map(|n| n as u32);
                self.joints.push(PlannedJoint {
                    element: element as u32,
                    law: law as u32,
                    corners,
                });
            }
        }
    }

    fn add_force_probes(&mut self, scene: &Scene) {
        for (probe, p) in scene.probes.iter().enumerate() {
            match p.quantity {
                ProbeQuantity::KineticEnergy => self.kinetic_energy_probes = true,
                ProbeQuantity::ForceX | ProbeQuantity::ForceY => {
                    let here = |n: &usize| scene.nodes.initial[*n] == Vec2::from(p.point);
                    let nodes = (0..scene.nodes.len()).filter(here);
                    self.force_probes.extend(nodes.map(|n| (probe, n as u32)));
                }
                _ => {}
            }
        }
    }
}

/// Whether both ends of an edge belong to node sets with pressure or traction.
fn has_loaded_edge(scene: &Scene, corners: &[usize; 3]) -> bool {
    let set =
        |n: usize| usize::try_from(scene.nodes.set[n]).ok().and_then(|s| scene.node_sets.get(s));
    let loaded = corners.map(|n| set(n).is_some_and(|s| s.pressure != 0.0 || s.traction != 0.0));
    loaded.iter().filter(|&&l| l).count() > 1
}
