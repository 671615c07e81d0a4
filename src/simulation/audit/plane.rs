//! The audit of a simulation of triangles.

use super::{
    super::{
        Simulation,
        extra_loads::{ExtraLoads, LoadedTriangle},
    },
    Ledger, Origin, Stored, joint_energy, overlap_energy, strain,
};
use crate::{
    contact::{Couple, EdgeContact, Motion, PairTable, Shape, SideForces, TangentialLaw, overlap},
    mechanics::{
        Vec2,
        triangle::{cauchy_stress, nodal_forces},
    },
    scene::{ElementKind, FrictionModel, JointKind, PairProperties},
};

/// Energies and works of a simulation in the plane.
#[derive(Debug, Clone)]
pub struct PlaneAudit {
    ledger: Ledger<2>,
    pairs: PairTable,
    has_friction: bool,
}

/// Normal forces alone, and what tangential springs store, J/m.
struct NormalOnly {
    stored: f64,
    penalty: f64,
}

impl TangentialLaw for NormalOnly {
    fn force(&mut self, _contact: &EdgeContact, sliding: &mut f64) -> f64 {
        self.stored += 0.5 * self.penalty * *sliding * *sliding;
        0.0
    }
}

impl PlaneAudit {
    /// An audit that begins with the next step. The simulation has to watch its contact forces and to
    /// keep its triangles.
    #[must_use]
    pub fn new(simulation: &Simulation) -> Self {
        let scene = &simulation.scene;
        let (pairs, has_friction) = match &scene.contact {
            Some(settings) => {
                let table = PairTable::new(&scene.materials, &settings.pairs);
                let materials = scene.materials.len() as i32;
                let ranks = (0..materials).flat_map(|p| (p..materials).map(move |q| (p, q)));
                let ranks = ranks.filter_map(|(p, q)| table.rank(p, q));
                let rubs = ranks.map(|rank| table.properties(rank).friction).any(|f| f > 0.0);
                (table, rubs)
            }
            None => (PairTable::default(), false),
        };
        Self { ledger: Ledger::new(), pairs, has_friction }
    }

    /// Looks at a state after its forces were evaluated.
    pub fn after_forces(&mut self, simulation: &Simulation) {
        let scene = &simulation.scene;
        let nodes = &scene.nodes;
        let (pairs, has_friction) = (&self.pairs, self.has_friction);
        self.ledger.look(&nodes.current, &nodes.velocity, |forces| {
            let mut loads = vec![Vec2::zeros(); nodes.len()];
            let strain = add_triangles(simulation, forces, &mut loads);
            let share = simulation.contact_share();
            let apart = !simulation.contact_force.is_empty();
            for n in 0..nodes.len() {
                let contact = share.get(n).copied().unwrap_or_default();
                // in the classic dialect contact is not in the sum yet
                let others = simulation.force[n] - if apart { Vec2::zeros() } else { contact };
                let elastic = forces[Origin::Strain as usize][n];
                let viscous = forces[Origin::Viscosity as usize][n];
                forces[Origin::Joints as usize][n] = others - elastic - viscous - loads[n];
                forces[Origin::Contact as usize][n] = contact;
            }
            if !loads_joints(simulation) {
                // only rounding is left
                forces[Origin::Joints as usize].fill(Vec2::zeros());
            }
            let (overlaps, sticking) = contacts(simulation, pairs, has_friction, forces);
            Stored {
                strain: Some(strain),
                joints: joints(simulation),
                contact: Some(overlaps),
                friction: sticking,
            }
        });
    }

    /// Looks at it after it has moved.
    pub fn after_motion(&mut self, simulation: &Simulation) {
        let scene = &simulation.scene;
        self.ledger.close(&scene.nodes.velocity, &simulation.mass, scene.control.time_step);
    }

    /// Energies and works so far.
    #[must_use]
    pub fn ledger(&self) -> &Ledger<2> {
        &self.ledger
    }

    /// Goes on with the works of an earlier audit of the same run; false if they are not complete.
    #[must_use]
    pub fn go_on_with(&mut self, ledger: Ledger<2>) -> bool {
        self.ledger = ledger;
        self.ledger.is_whole()
    }
}

/// Whether something besides triangles, loads and contact exerts forces.
fn loads_joints(simulation: &Simulation) -> bool {
    !simulation.plan.joints.is_empty()
        || simulation.plan.batches.iter().any(|b| b.kind == ElementKind::SofteningTriangle)
}

/// Adds forces of elastic triangles and of loads on them: the strain energy, J/m.
fn add_triangles(
    simulation: &Simulation,
    forces: &mut [Vec<Vec2>; super::ORIGINS],
    loads: &mut [Vec2],
) -> f64 {
    let scene = &simulation.scene;
    let extra = ExtraLoads::new(scene, &simulation.edge_factors, simulation.time);
    let mut energy = 0.0;
    for batch in &simulation.plan.batches {
        if batch.kind != ElementKind::ElasticTriangle {
            continue;
        }
        let elastic = batch.law.without_viscosity();
        for planned in &batch.triangles {
            let corners = planned.corners.map(|n| scene.nodes.current[n as usize]);
            let velocities = planned.corners.map(|n| scene.nodes.velocity[n as usize]);
            let still = [Vec2::zeros(); 3];
            let stress = cauchy_stress(&elastic, &planned.reference, &corners, &still);
            let whole = cauchy_stress(&batch.law, &planned.reference, &corners, &velocities);
            let strain = nodal_forces(&stress, &corners);
            let viscous = nodal_forces(&(whole - stress), &corners);
            let mut loaded = [Vec2::zeros(); 3];
            if planned.has_extras {
                let triangle = LoadedTriangle::new(scene, batch, &planned.corners, &corners);
                (0..3).for_each(|i| extra.apply(i, &triangle, &mut loaded));
            }
            for (i, &n) in planned.corners.iter().enumerate() {
                let n = n as usize;
                forces[Origin::Strain as usize][n] += strain[i];
                forces[Origin::Viscosity as usize][n] += viscous[i];
                loads[n] += loaded[i];
            }
            let initial = planned.corners.map(|n| scene.nodes.initial[n as usize]);
            energy += strain::of_triangle(&elastic, &planned.reference, [&initial, &corners]);
        }
    }
    energy
}

/// Moves friction out of the contact forces: energy of overlaps and of tangential springs, J/m.
fn contacts(
    simulation: &Simulation,
    pairs: &PairTable,
    has_friction: bool,
    forces: &mut [Vec<Vec2>; super::ORIGINS],
) -> (f64, f64) {
    let Some(contact) = &simulation.contact else { return (0.0, 0.0) };
    let scene = &simulation.scene;
    let settings = scene.contact.as_ref();
    let sticks = settings.is_some_and(|s| s.friction == FrictionModel::Coulomb);
    let (mut overlaps, mut sticking) = (0.0, 0.0);
    let mut normal = vec![Vec2::zeros(); if has_friction { scene.nodes.len() } else { 0 }];
    for (couple, mut sliding) in contact.couples() {
        let [target, contactor] = couple.map(|e| e as usize);
        let [p, q] = [target, contactor].map(|e| scene.elements.property[e]);
        let Some(rank) = pairs.rank(p, q) else { continue };
        let along = pairs.along_fracture(&scene.elements, contactor as u32, target as u32);
        let pair: PairProperties = *pairs.properties(along.unwrap_or(rank));
        let nodes = [target, contactor].map(|e| scene.elements.corners::<3>(e));
        let corners = nodes.map(|nodes| nodes.map(|n| scene.nodes.current[n]));
        if overlap_energy::are_apart(&corners[0], &corners[1]) {
            continue;
        }
        overlaps += pair.penalty * overlap_energy::of_overlapping(&corners[0], &corners[1]);
        if !has_friction {
            continue;
        }
        let shapes = corners.map(Shape::new);
        let motions = nodes.map(|nodes| Motion::new(nodes.map(|n| scene.nodes.velocity[n])));
        let couple = Couple {
            shapes: [&shapes[0], &shapes[1]],
            motions: [&motions[0], &motions[1]],
            pair: &pair,
            // the sliding is that after this step's friction already
            dt: 0.0,
            drop_distance_squared: f64::INFINITY,
        };
        let mut law = NormalOnly { stored: 0.0, penalty: pair.tangential_penalty };
        let mut sides = [SideForces::default(); 2];
        let _ = overlap(&couple, &mut law, &mut sliding, &mut sides);
        if sticks && pair.friction > 0.0 {
            sticking += law.stored;
        }
        let places = nodes.map(|nodes| nodes.map(|n| n as u32));
        sides[0].scatter(&places[0], &places[1], &mut normal);
        sides[1].scatter(&places[1], &places[0], &mut normal);
    }
    if has_friction {
        for (n, normal) in normal.into_iter().enumerate() {
            let both = forces[Origin::Contact as usize][n];
            forces[Origin::Friction as usize][n] = both - normal;
            forces[Origin::Contact as usize][n] = normal;
        }
    }
    (overlaps, sticking)
}

/// Recoverable energy of all intact joints, J/m.
fn joints(simulation: &Simulation) -> f64 {
    let scene = &simulation.scene;
    let intact = |e: &usize| scene.elements.joint_kind[*e] == JointKind::Intact;
    let energies = (0..scene.elements.len()).filter(intact).filter_map(|element| {
        let law = scene.law_of(element).filter(|law| law.is_cohesive)?;
        let corners = scene.elements.corners::<4>(element).map(|n| scene.nodes.current[n]);
        let strength = simulation.strength[element];
        Some(joint_energy::of_joint(law, scene.conventions.cohesive, &corners, strength))
    });
    energies.sum()
}
