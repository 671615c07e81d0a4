//! Lists made once per mesh, so that the step loop visits only what carries
//! force, in the original's order, and looks nothing up.

use crate::{
    mechanics::{
        Vec2,
        triangle::{Elasticity, LinearElasticity, ReferenceShape, StressLaw, contains},
    },
    scene::{
        Condition, ElasticLaw, ElementKind, ForceOrder, JointKind, Material, ProbeQuantity, Scene,
        VolumetricShare,
    },
};
use std::ops::Range;

/// A triangle with stress.
#[derive(Debug, Clone)]
pub(super) struct PlannedTriangle {
    pub element: u32,
    pub corners: [u32; 3],
    pub reference: ReferenceShape,
    /// Whether more than its stress acts on its nodes: loads on its edges,
    /// stress in situ, absorbing nodes, excavation.
    pub has_extras: bool,
}

/// Triangles of one material.
#[derive(Debug, Clone)]
pub(super) struct Batch {
    pub material: usize,
    pub kind: ElementKind,
    pub elasticity: Elasticity,
    pub law: StressLaw,
    /// None where domains have taken them over.
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

/// A probe and the triangle that it lies in.
#[derive(Debug, Clone)]
pub(super) struct PlannedProbe {
    pub probe: usize,
    pub element: u32,
}

/// A part of the force evaluation, in the order of the sums.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum ForcePhase {
    /// Triangles of one batch.
    Triangles(usize),
    /// All live joints, each with its own law.
    Joints,
    /// Every joint with the law of one set (classic).
    EveryJoint(usize),
    /// The edge load factor of a node set steps on (classic).
    LoadStep(usize),
}

/// A part of the motion, in order.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum MotionPhase {
    /// Nodes of one set, as runs of numbers.
    Nodes { set: usize, runs: Range<usize> },
    /// Rigid triangles of one material.
    Rigid(Range<usize>),
}

/// Everything that the step loop visits.
#[derive(Debug, Clone, Default)]
pub(super) struct Plan {
    pub forces: Vec<ForcePhase>,
    pub motions: Vec<MotionPhase>,
    /// Materials ascending, elements ascending within.
    pub batches: Vec<Batch>,
    pub rigid: Vec<PlannedRigid>,
    /// Joint sets ascending, elements ascending within.
    pub joints: Vec<PlannedJoint>,
    /// Nodes that follow each other and move: sets ascending, nodes ascending within.
    pub node_runs: Vec<Range<u32>>,
    pub probes: Vec<PlannedProbe>,
    /// Nodes at the place of a force probe.
    pub force_probes: Vec<(usize, u32)>,
    /// Mass that elastic triangles give the nodes; none once it is taken over and does not change.
    pub nodal_mass: Vec<f64>,
    /// Whether softening or rigid triangles change the masses during a step.
    pub masses_change: bool,
    pub kinetic_energy_probes: bool,
    pub strain_energy_probes: Vec<usize>,
    /// Whether a material is excavated.
    pub excavates: bool,
}

impl Plan {
    /// Forgets masses that stay as they are and, unless they are to be kept, the triangles that
    /// domains have taken over, where nobody else asks for them.
    pub fn forget_divided(&mut self, keeps_triangles: bool) {
        if !self.masses_change {
            self.nodal_mass = Vec::new();
        }
        if keeps_triangles || self.excavates || !self.strain_energy_probes.is_empty() {
            return;
        }
        for batch in &mut self.batches {
            if batch.kind == ElementKind::ElasticTriangle {
                batch.triangles = Vec::new();
            }
        }
    }

    pub fn new(scene: &Scene) -> Self {
        let mut plan = Self { nodal_mass: vec![0.0; scene.nodes.len()], ..Self::default() };
        match scene.conventions.forces {
            ForceOrder::TrianglesThenJoints => plan.add_stage_by_stage(scene),
            ForceOrder::PropertyByProperty => plan.add_property_by_property(scene),
        }
        plan.add_force_probes(scene);
        plan.excavates = scene.materials.iter().any(|m| m.is_excavated);
        plan
    }

    fn add_stage_by_stage(&mut self, scene: &Scene) {
        for material in 0..scene.materials.len() {
            self.add_material(scene, material);
        }
        for law in 0..scene.cohesive_laws.len() {
            self.add_joints(scene, law);
        }
        self.forces.push(ForcePhase::Joints);
        for set in 0..scene.node_sets.len() {
            self.add_nodes(scene, set);
        }
        for material in 0..scene.materials.len() {
            self.add_rigid(scene, material);
        }
    }

    /// Materials, joint sets and node sets are numbered together.
    fn add_property_by_property(&mut self, scene: &Scene) {
        for property in 0..scene.materials.len() {
            self.add_material(scene, property);
            if scene.cohesive_laws.get(property).is_some_and(|law| law.is_cohesive) {
                self.forces.push(ForcePhase::EveryJoint(property));
            }
            if scene.node_sets.get(property).is_some_and(|set| set.edge_factor_step != 0.0) {
                self.forces.push(ForcePhase::LoadStep(property));
            }
            self.add_rigid(scene, property);
            self.add_nodes(scene, property);
        }
        let is_joint = |&e: &usize| scene.elements.joint_kind[e] != JointKind::NoJoint;
        self.joints.extend((0..scene.elements.len()).filter(is_joint).map(|element| {
            PlannedJoint {
                element: element as u32,
                law: 0,
                corners: scene.elements.corners::<4>(element).map(|n| n as u32),
            }
        }));
    }

    fn add_nodes(&mut self, scene: &Scene, set: usize) {
        let Some(node_set) = scene.node_sets.get(set) else { return };
        if !node_set.moves {
            return;
        }
        let start = self.node_runs.len();
        let members = (0..scene.nodes.len()).filter(|&n| scene.nodes.set[n] == set as i32);
        for node in members.map(|n| n as u32) {
            match self.node_runs[start..].last_mut() {
                Some(run) if run.end == node => run.end += 1,
                _ => self.node_runs.push(node..node + 1),
            }
        }
        let runs = start..self.node_runs.len();
        if !runs.is_empty() {
            self.motions.push(MotionPhase::Nodes { set, runs });
        }
    }

    fn add_rigid(&mut self, scene: &Scene, material: usize) {
        if scene.materials[material].kind != ElementKind::RigidTriangle {
            return;
        }
        self.masses_change = true;
        let start = self.rigid.len();
        let property = &scene.elements.property;
        let members = (0..scene.elements.len()).filter(|&e| property[e] == material as i32);
        self.rigid.extend(members.map(|e| PlannedRigid {
            material,
            corners: scene.elements.corners::<3>(e).map(|n| n as u32),
        }));
        if self.rigid.len() > start {
            self.motions.push(MotionPhase::Rigid(start..self.rigid.len()));
        }
    }

    fn add_material(&mut self, scene: &Scene, material: usize) {
        let m = &scene.materials[material];
        let members = (0..scene.elements.len())
            .filter(|&e| scene.elements.property[e] == material as i32)
            .map(|e| (e as u32, scene.elements.corners::<3>(e)));
        match m.kind {
            ElementKind::Inert(_)
            | ElementKind::RigidTriangle
            | ElementKind::Tetrahedron
            | ElementKind::QuadraticTetrahedron => {}
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
                        has_extras: elastic && has_extras(scene, m, &corners),
                    });
                }
                let elasticity = elasticity(m, scene.conventions.volumetric);
                self.forces.push(ForcePhase::Triangles(self.batches.len()));
                let (kind, law) = (m.kind, stress_law(m, scene.conventions.volumetric));
                self.batches.push(Batch { material, kind, elasticity, law, triangles });
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
            if scene.elements.property[element] == property
                && scene.elements.joint_kind[element] == JointKind::Intact
            {
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
                ProbeQuantity::StrainEnergy => self.strain_energy_probes.push(probe),
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

fn elasticity(material: &Material, share: VolumetricShare) -> Elasticity {
    Elasticity {
        lame_lambda: material.lame_lambda,
        shear_modulus: material.shear_modulus,
        viscosity: material.viscosity,
        volumetric_share: share.factor(),
    }
}

/// The law that a material's elastic triangles follow.
pub(crate) fn stress_law(material: &Material, share: VolumetricShare) -> StressLaw {
    let viscosity = material.viscosity;
    let linear = |stiffness, own, cross, shear| {
        StressLaw::Linear(LinearElasticity { stiffness, own, cross, shear, viscosity })
    };
    match material.elastic_law {
        ElasticLaw::NeoHookean => StressLaw::NeoHookean(elasticity(material, share)),
        ElasticLaw::PlaneStress(m) => {
            let k = m.young / (1.0 - m.poisson * m.poisson);
            linear([k; 2], [1.0; 2], [m.poisson; 2], m.young / (1.0 + m.poisson))
        }
        ElasticLaw::PlaneStrain(m) => {
            let k = m.young / ((1.0 + m.poisson) * (1.0 - 2.0 * m.poisson));
            linear([k; 2], [1.0 - m.poisson; 2], [m.poisson; 2], m.young / (1.0 + m.poisson))
        }
        ElasticLaw::Transverse(m) => {
            let [x, y] = m.poisson;
            let k = m.young.map(|young| young / (1.0 - x * y));
            linear(k, [1.0; 2], [y, x], 2.0 * m.shear)
        }
    }
}

/// Whether both ends of an edge belong to node sets with pressure or traction,
/// or more acts on all triangles of the material.
fn has_extras(scene: &Scene, material: &Material, corners: &[usize; 3]) -> bool {
    let set =
        |n: usize| usize::try_from(scene.nodes.set[n]).ok().and_then(|s| scene.node_sets.get(s));
    let loaded = corners.map(|n| {
        set(n).is_some_and(|s| {
            let absorbs = s.conditions.contains(&Condition::Absorbing);
            s.pressure != 0.0 || s.traction != 0.0 || absorbs
        })
    });
    loaded.iter().filter(|&&l| l).count() > 1 || scene.in_situ.is_some() || material.is_excavated
}
