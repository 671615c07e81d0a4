//! Lists made once per mesh: what the step loop visits, in the original's order.

use crate::{
    mechanics::{
        tetrahedron::{ReferenceShape, SolidLaw},
        tetrahedron10,
        triangle::Elasticity,
    },
    scene::{ElementKind, JointKind, ProbeQuantity, Scene},
};

/// A tetrahedron.
#[derive(Debug, Clone)]
pub(super) struct PlannedTetrahedron {
    pub element: u32,
    pub material: u32,
    pub corners: [u32; 4],
    pub reference: ReferenceShape,
}

/// A ten-node tetrahedron.
#[derive(Debug, Clone)]
pub(super) struct PlannedQuadratic {
    pub element: u32,
    pub material: u32,
    pub nodes: [u32; tetrahedron10::NODES],
    pub reference: tetrahedron10::ReferenceShape,
}

/// A joint that was live when the plan was made.
#[derive(Debug, Clone)]
pub(super) struct PlannedJoint {
    pub element: u32,
    pub law: u32,
    pub corners: [u32; 6],
    pub is_live: bool,
}

/// Which corners of elements a node is: element times corners plus corner, in the order of sums.
#[derive(Debug, Clone, Default)]
pub(super) struct Shares {
    first: Vec<u32>,
    slots: Vec<u32>,
}

impl Shares {
    fn new<const N: usize>(nodes: usize, corners: impl Iterator<Item = [u32; N]> + Clone) -> Self {
        let mut first = vec![0; nodes + 1];
        for n in corners.clone().flatten() {
            first[n as usize + 1] += 1;
        }
        for n in 0..nodes {
            first[n + 1] += first[n];
        }
        let mut next = first.clone();
        let mut slots = vec![0; first[nodes] as usize];
        for (slot, n) in corners.flatten().enumerate() {
            let place = &mut next[n as usize];
            slots[*place as usize] = slot as u32;
            *place += 1;
        }
        Self { first, slots }
    }

    /// Slots of a node.
    #[inline]
    pub fn of(&self, node: usize) -> &[u32] {
        &self.slots[self.first[node] as usize..self.first[node + 1] as usize]
    }
}

/// Everything that the step loop visits.
#[derive(Debug, Clone, Default)]
pub(super) struct Plan {
    /// Law of each material.
    pub laws: Vec<SolidLaw>,
    /// Materials ascending, elements ascending within.
    pub tetrahedra: Vec<PlannedTetrahedron>,
    /// Materials ascending, elements ascending within.
    pub quadratic: Vec<PlannedQuadratic>,
    /// Joint sets ascending, elements ascending within.
    pub joints: Vec<PlannedJoint>,
    pub tetrahedron_shares: Shares,
    pub quadratic_shares: Shares,
    pub joint_shares: Shares,
    /// Place of each element in the list of tetrahedra with four nodes, if it is one.
    pub slot_of_element: Vec<Option<u32>>,
    /// The same for those with ten.
    pub quadratic_of_element: Vec<Option<u32>>,
    /// Faces under pressure and this, Pa.
    pub pressed_faces: Vec<([u32; 3], f64)>,
    pub nodal_mass: Vec<f64>,
    /// Nodes at the place of a force probe.
    pub force_probes: Vec<(usize, u32)>,
    pub kinetic_energy_probes: bool,
}

impl Plan {
    pub fn new(scene: &Scene<3>) -> Self {
        let nodes = scene.nodes.len();
        let mut plan = Self {
            laws: scene
                .materials
                .iter()
                .map(|m| SolidLaw {
                    elasticity: Elasticity {
                        lame_lambda: m.lame_lambda,
                        shear_modulus: m.shear_modulus,
                        viscosity: m.viscosity,
                        volumetric_share: scene.conventions.volumetric.factor(),
                    },
                    volumetric: scene.conventions.solid_volumetric,
                })
                .collect(),
            nodal_mass: vec![0.0; nodes],
            slot_of_element: vec![None; scene.elements.len()],
            quadratic_of_element: vec![None; scene.elements.len()],
            pressed_faces: pressed_faces(scene),
            ..Self::default()
        };
        for material in 0..scene.materials.len() {
            plan.add_tetrahedra(scene, material);
            plan.add_quadratic(scene, material);
        }
        for law in 0..scene.cohesive_laws.len() {
            plan.add_joints(scene, law);
        }
        plan.tetrahedron_shares = Shares::new(nodes, plan.tetrahedra.iter().map(|t| t.corners));
        plan.quadratic_shares = Shares::new(nodes, plan.quadratic.iter().map(|t| t.nodes));
        plan.joint_shares = Shares::new(nodes, plan.joints.iter().map(|j| j.corners));
        plan.add_probes(scene);
        plan
    }

    fn add_tetrahedra(&mut self, scene: &Scene<3>, material: usize) {
        let m = &scene.materials[material];
        if m.kind != ElementKind::Tetrahedron {
            return;
        }
        for element in 0..scene.elements.len() {
            if scene.elements.property[element] != material as i32 {
                continue;
            }
            let corners = scene.elements.corners::<4>(element);
            let reference = ReferenceShape::new(&corners.map(|n| scene.nodes.initial[n]));
            let mass = reference.nodal_mass(m.density);
            for n in corners {
                self.nodal_mass[n] += mass;
            }
            self.slot_of_element[element] = Some(self.tetrahedra.len() as u32);
            self.tetrahedra.push(PlannedTetrahedron {
                element: element as u32,
                material: material as u32,
                corners: corners.map(|n| n as u32),
                reference,
            });
        }
    }

    fn add_quadratic(&mut self, scene: &Scene<3>, material: usize) {
        let m = &scene.materials[material];
        if m.kind != ElementKind::QuadraticTetrahedron {
            return;
        }
        for element in 0..scene.elements.len() {
            if scene.elements.property[element] != material as i32 {
                continue;
            }
            let nodes = scene.elements.all_nodes(element);
            let reference =
                tetrahedron10::ReferenceShape::new(&nodes.map(|n| scene.nodes.initial[n]));
            for (n, mass) in nodes.into_iter().zip(reference.nodal_masses(m.density)) {
                self.nodal_mass[n] += mass;
            }
            self.quadratic_of_element[element] = Some(self.quadratic.len() as u32);
            self.quadratic.push(PlannedQuadratic {
                element: element as u32,
                material: material as u32,
                nodes: nodes.map(|n| n as u32),
                reference,
            });
        }
    }

    fn add_joints(&mut self, scene: &Scene<3>, law: usize) {
        if !scene.cohesive_laws[law].is_cohesive {
            return;
        }
        let property = (scene.materials.len() + law) as i32;
        for element in 0..scene.elements.len() {
            if scene.elements.property[element] == property
                && scene.elements.joint_kind[element] == JointKind::Intact
            {
                let corners = scene.elements.corners::<6>(element).map(|n| n as u32);
                let (element, law) = (element as u32, law as u32);
                self.joints.push(PlannedJoint { element, law, corners, is_live: true });
            }
        }
    }

    fn add_probes(&mut self, scene: &Scene<3>) {
        for (probe, p) in scene.probes.iter().enumerate() {
            match p.quantity {
                ProbeQuantity::KineticEnergy => self.kinetic_energy_probes = true,
                ProbeQuantity::ForceX | ProbeQuantity::ForceY => {
                    let [x, y] = p.point;
                    let here = |n: &usize| {
                        let place = scene.nodes.initial[*n];
                        (place.x, place.y) == (x, y)
                    };
                    let nodes = (0..scene.nodes.len()).filter(here);
                    self.force_probes.extend(nodes.map(|n| (probe, n as u32)));
                }
                _ => {}
            }
        }
    }
}

/// Nodes of the faces under pressure as they are now, and the pressures.
fn pressed_faces(scene: &Scene<3>) -> Vec<([u32; 3], f64)> {
    let faces = scene.face_pressures.iter();
    faces
        .map(|face| {
            let nodes = scene.elements.corners::<4>(face.element);
            (face.corners.map(|i| nodes[usize::from(i)] as u32), face.pressure)
        })
        .collect()
}
