//! Lists made once per mesh: what the step loop visits, in the original's order.

use crate::{
    lanes::{LANES, each},
    mechanics::{
        tetrahedron::{ReferenceShape, SolidLaw, lanes::ReferenceLanes},
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
    /// Block and lane.
    pub place: [u32; 2],
}

/// Four tetrahedra of a material; less at the end of a material, where the last one fills up.
#[derive(Debug, Clone)]
pub(super) struct TetrahedronBlock {
    pub material: u32,
    pub elements: [u32; LANES],
    /// Of each of the four corners, in all lanes.
    pub corners: [[u32; LANES]; 4],
    pub reference: ReferenceLanes,
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

/// Four joints of a law; less at the end of a law, where the last one fills up.
#[derive(Debug, Clone)]
pub(super) struct JointBlock {
    /// The first one in the list of joints.
    pub first: u32,
    /// How many they are.
    pub len: u32,
    pub law: u32,
    /// Of each of the six corners, in all lanes.
    pub corners: [[u32; LANES]; 6],
}

impl JointBlock {
    /// Its joints in the list of all.
    pub fn joints(&self) -> std::ops::Range<usize> {
        self.first as usize..(self.first + self.len) as usize
    }
}

/// Which responses of elements a node sums up: their numbers, in the order of the sums.
#[derive(Debug, Clone, Default)]
pub(super) struct Shares {
    first: Vec<u32>,
    slots: Vec<u32>,
}

impl Shares {
    /// From nodes and the numbers of what they sum up.
    fn new(nodes: usize, shares: impl Iterator<Item = (u32, u32)> + Clone) -> Self {
        let mut first = vec![0; nodes + 1];
        for (n, _) in shares.clone() {
            first[n as usize + 1] += 1;
        }
        for n in 0..nodes {
            first[n + 1] += first[n];
        }
        let mut next = first.clone();
        let mut slots = vec![0; first[nodes] as usize];
        for (n, slot) in shares {
            let place = &mut next[n as usize];
            slots[*place as usize] = slot;
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
    pub tetrahedron_blocks: Vec<TetrahedronBlock>,
    /// Materials ascending, elements ascending within.
    pub quadratic: Vec<PlannedQuadratic>,
    /// Joint sets ascending, elements ascending within.
    pub joints: Vec<PlannedJoint>,
    pub joint_blocks: Vec<JointBlock>,
    /// Forces of tetrahedra: corner `i` in lane `l` of block `b` has number (4·b + l)·4 + i.
    pub tetrahedron_shares: Shares,
    /// Those of ten-node tetrahedra: node `i` of number `e` has number 10·e + i.
    pub quadratic_shares: Shares,
    /// Forces across joints: pair `i` in lane `l` of block `b` has number 2·((4·b + l)·3 + i), and
    /// 1 more for nodes of the upper face, which lose it.
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
        plan.share_out(nodes);
        plan.add_probes(scene);
        plan
    }

    fn share_out(&mut self, nodes: usize) {
        fn numbered<const N: usize>(
            first: u32,
            nodes: [u32; N],
        ) -> impl Iterator<Item = (u32, u32)> + Clone {
            nodes.into_iter().zip(first..)
        }
        let of_tetrahedra = self.tetrahedra.iter().flat_map(|t| {
            let [block, lane] = t.place;
            numbered((block * LANES as u32 + lane) * 4, t.corners)
        });
        self.tetrahedron_shares = Shares::new(nodes, of_tetrahedra);
        let of_quadratic = self
            .quadratic
            .iter()
            .zip(0..)
            .flat_map(|(t, e)| numbered(e * tetrahedron10::NODES as u32, t.nodes));
        self.quadratic_shares = Shares::new(nodes, of_quadratic);
        let joints = &self.joints;
        let of_joints = self.joint_blocks.iter().zip(0..).flat_map(|(block, b)| {
            block.joints().zip(0..).flat_map(move |(joint, lane)| {
                let pair = move |i: u32| (b * LANES as u32 + lane) * 3 + i % 3;
                let share = move |(i, n): (u32, u32)| (n, 2 * pair(i) + u32::from(i < 3));
                (0..).zip(joints[joint].corners).map(share)
            })
        });
        self.joint_shares = Shares::new(nodes, of_joints);
    }

    /// Undeformed shape of a tetrahedron.
    pub fn reference(&self, tetrahedron: &PlannedTetrahedron) -> ReferenceShape {
        let [block, lane] = tetrahedron.place.map(|place| place as usize);
        self.tetrahedron_blocks[block].reference.shape(lane)
    }

    fn add_tetrahedra(&mut self, scene: &Scene<3>, material: usize) {
        let m = &scene.materials[material];
        if m.kind != ElementKind::Tetrahedron {
            return;
        }
        let first = self.tetrahedra.len();
        let mut shapes = Vec::new();
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
            let block = self.tetrahedron_blocks.len() + shapes.len() / LANES;
            self.tetrahedra.push(PlannedTetrahedron {
                element: element as u32,
                material: material as u32,
                corners: corners.map(|n| n as u32),
                place: [block as u32, (shapes.len() % LANES) as u32],
            });
            shapes.push(reference);
        }
        let blocks = self.tetrahedra[first..].chunks(LANES).zip(shapes.chunks(LANES));
        self.tetrahedron_blocks.extend(
            blocks.map(|(tetrahedra, shapes)| {
                let of = |lane: usize| &tetrahedra[lane.min(tetrahedra.len() - 1)];
                TetrahedronBlock {
                    material: material as u32,
                    elements: each!(4, |lane| of(lane).element),
                    corners: each!(4, |i| each!(4, |lane| of(lane).corners[i])),
                    reference: ReferenceLanes::new(
                        each!(4, |lane| &shapes[lane.min(shapes.len() - 1)])
                    ),
                }
            }),
        );
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
        let first = self.joints.len();
        for element in 0..scene.elements.len() {
            if scene.elements.property[element] == property
                && scene.elements.joint_kind[element] == JointKind::Intact
            {
                let corners = scene.elements.corners::<6>(element).map(|n| n as u32);
                let (element, law) = (element as u32, law as u32);
                self.joints.push(PlannedJoint { element, law, corners, is_live: true });
            }
        }
        let blocks = self.joints[first..].chunks(LANES).zip((first as u32..).step_by(LANES));
        self.joint_blocks.extend(blocks.map(|(joints, first)| {
            let of = |lane: usize| &joints[lane.min(joints.len() - 1)];
            JointBlock {
                first,
                len: joints.len() as u32,
                law: law as u32,
                corners: std::array::from_fn(|i| each!(4, |lane| of(lane).corners[i])),
            }
        }));
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
