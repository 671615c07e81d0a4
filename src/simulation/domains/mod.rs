//! Parts of the mesh for the threads.
//!
//! Every node belongs to one domain. A domain holds, in the original's order, all triangles and
//! joints that touch its nodes, and adds their forces to these only: sums round the same
//! whatever the number of domains, and no domain waits for another. Elements with nodes of
//! several domains are evaluated in each of them.

mod joints;
mod owners;
mod triangles;

use super::{
    Simulation,
    disjoint::Disjoint,
    plan::{ForcePhase, Plan, PlannedJoint},
};
use crate::{
    lanes::LANES,
    mechanics::Vec2,
    scene::{CohesiveModel, ElementKind, JointKind, Scene},
    team::Team,
};
use joints::JointBlock;
use nalgebra::Matrix2;
use owners::Owners;
use std::ops::Range;
use triangles::TriangleBlock;

/// From so many triangles and joints on, threads are used: by estimate, about 20 µs of work for one.
const PARALLEL_FROM: usize = 2048;
/// Dead joints among the lanes, from which on blocks are packed anew: one in so many.
const PACK_FROM: usize = 8;

/// Elements that touch the nodes of one part of the mesh.
#[derive(Debug, Clone, Default)]
struct Domain {
    /// Triangles of each batch of the plan, in its order.
    triangles: Vec<Vec<TriangleBlock>>,
    /// Live joints of each cohesive law, in the plan's order.
    joints: Vec<Vec<JointBlock>>,
    /// Joints that failed in this step.
    failed: Vec<FailedJoint>,
}

/// All domains of a mesh.
#[derive(Debug, Clone, Default)]
pub(super) struct Domains {
    domains: Vec<Domain>,
    /// Parts of the nodes for the threads: those of each domain, where these follow each other.
    node_parts: Vec<Range<u32>>,
    /// Whether live joints are among the elements.
    holds_joints: bool,
    /// Joints that failed in this step, in the plan's order.
    failed: Vec<FailedJoint>,
    /// Joints in the blocks, and those of them that have failed.
    joints: usize,
    dead: usize,
}

/// A joint that failed and the point at which it did.
#[derive(Debug, Clone)]
struct FailedJoint {
    joint: PlannedJoint,
    point: u8,
}

/// What domains read and write.
struct Step<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    edge_factors: &'a [f64],
    time: f64,
    keeps_stress: bool,
    force: Disjoint<'a, Vec2>,
    stress: Disjoint<'a, Matrix2<f64>>,
    strength: Disjoint<'a, f64>,
}

impl Domains {
    /// Into `parts` domains if that is given, otherwise into as many as pay for `threads`.
    pub fn new(
        scene: &Scene,
        plan: &Plan,
        strength: &[f64],
        parts: Option<usize>,
        threads: usize,
    ) -> Self {
        let holds_joints =
            scene.conventions.cohesive == CohesiveModel::Split && scene.fracture_network.is_none();
        let triangles: usize = plan.batches.iter().map(|batch| batch.triangles.len()).sum();
        let elements = triangles + if holds_joints { plan.joints.len() } else { 0 };
        let is_plain = !plan.excavates
            && plan.batches.iter().all(|batch| batch.kind == ElementKind::ElasticTriangle);
        let pay = || if elements >= PARALLEL_FROM { threads } else { 1 };
        let count =
            if is_plain { parts.unwrap_or_else(pay).clamp(1, Team::MOST_PLACES) } else { 1 };
        let owners = Owners::new(scene, plan, count);
        let domain = |d| Domain {
            triangles: plan
                .batches
                .iter()
                .map(|batch| TriangleBlock::of_domain(&batch.triangles, &owners, d))
                .collect(),
            joints: match holds_joints {
                true => JointBlock::of_domain(scene, plan, strength, &owners, d),
                false => Vec::new(),
            },
            failed: Vec::new(),
        };
        let mut domains: Vec<Domain> = (0..count as u32).map(domain).collect();
        let joints = if holds_joints { plan.joints.len() } else { 0 };
        // room for every joint's failure: the step loop allocates nothing
        for domain in &mut domains {
            let lanes = domain.joints.iter().flatten().count() * LANES;
            domain.failed.reserve(lanes);
        }
        let failed = Vec::with_capacity(joints);
        let node_parts =
            owners.runs().map_or_else(|| even_parts(scene.nodes.len(), count), <[_]>::to_vec);
        Self { domains, node_parts, holds_joints, failed, joints, dead: 0 }
    }

    /// Parts of the nodes for the threads.
    pub fn node_parts(&self) -> &[Range<u32>] {
        &self.node_parts
    }

    /// How many of the plan's phases from the first one on domains can do in one go.
    pub fn reach(&self, plan: &Plan, first: usize) -> usize {
        let can = |phase: &&ForcePhase| match **phase {
            ForcePhase::Triangles(batch) => {
                plan.batches[batch].kind == ElementKind::ElasticTriangle && !plan.excavates
            }
            ForcePhase::Joints => self.holds_joints,
            ForcePhase::EveryJoint(_) | ForcePhase::LoadStep(_) => false,
        };
        plan.forces[first..].iter().take_while(can).count()
    }
}

/// So many parts of about the same size.
fn even_parts(nodes: usize, count: usize) -> Vec<Range<u32>> {
    let border = |part: usize| (nodes * part / count) as u32;
    (0..count).map(|part| border(part)..border(part + 1)).collect()
}

impl Domain {
    fn add_forces(&mut self, phases: &[ForcePhase], step: &Step<'_>) {
        for phase in phases {
            match *phase {
                ForcePhase::Triangles(batch) => {
                    triangles::add_forces(&self.triangles[batch], batch, step);
                }
                ForcePhase::Joints => {
                    for (law, blocks) in self.joints.iter_mut().enumerate() {
                        joints::add_forces(blocks, law, step, &mut self.failed);
                    }
                }
                ForcePhase::EveryJoint(_) | ForcePhase::LoadStep(_) => {}
            }
        }
    }
}

impl Simulation {
    /// From now on divides the mesh into so many parts for the threads, however small it is
    /// and however many threads there are. Results are the same to the last bit.
    pub fn divide_into(&mut self, parts: usize) {
        self.parts = Some(parts);
        self.divide_anew();
    }

    /// From now on keeps a list of all triangles, which an audit of energies goes through.
    pub fn keep_triangles(&mut self) {
        self.keeps_triangles = true;
        self.divide_anew();
    }

    fn divide_anew(&mut self) {
        self.plan = Plan::new(&self.scene);
        self.divide();
    }

    pub(super) fn divide(&mut self) {
        let threads = self.options.team.size();
        self.domains = Domains::new(&self.scene, &self.plan, &self.strength, self.parts, threads);
        self.plan.forget_divided(self.keeps_triangles);
    }

    /// Adds the forces of some phases that domains can do.
    pub(super) fn add_forces_of(&mut self, phases: Range<usize>) {
        let step = Step {
            scene: &self.scene,
            plan: &self.plan,
            edge_factors: &self.edge_factors,
            time: self.time,
            keeps_stress: self.needs_stress(),
            force: Disjoint::new(&mut self.force),
            stress: Disjoint::new(&mut self.stress),
            strength: Disjoint::new(&mut self.strength),
        };
        let phases = &self.plan.forces[phases];
        match &mut self.domains.domains[..] {
            [one] => one.add_forces(phases, &step),
            many => {
                let count = many.len();
                let many = Disjoint::new(many);
                self.options.team.share_places(count, |place| {
                    // SAFETY: there are so many, and each place is visited once
                    unsafe { many.entry(place) }.add_forces(phases, &step);
                });
            }
        }
        if phases.contains(&ForcePhase::Joints) {
            self.record_failed_joints();
        }
    }

    /// Joints that failed still acted in this step.
    fn record_failed_joints(&mut self) {
        let domains = &mut self.domains;
        domains.failed.clear();
        for domain in &mut domains.domains {
            domains.failed.append(&mut domain.failed);
        }
        if domains.failed.is_empty() {
            return;
        }
        domains.failed.sort_unstable_by_key(|f| (f.joint.law, f.joint.element));
        let failed = std::mem::take(&mut domains.failed);
        for FailedJoint { joint, point } in &failed {
            self.record_broken(joint, usize::from(*point));
        }
        self.domains.dead += failed.len();
        self.domains.failed = failed;
        let kind = &self.scene.elements.joint_kind;
        let is_live = |e: u32| kind[e as usize] == JointKind::Intact;
        self.plan.joints.retain(|j| is_live(j.element));
        if self.domains.dead * PACK_FROM >= self.domains.joints {
            self.domains.joints -= self.domains.dead;
            self.domains.dead = 0;
            for blocks in self.domains.domains.iter_mut().flat_map(|d| &mut d.joints) {
                JointBlock::pack(blocks);
            }
        }
    }
}
