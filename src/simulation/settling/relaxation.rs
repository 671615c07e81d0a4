//! The iteration.

use super::{
    super::{Simulation, plan::Plan},
    SettlingFault, SettlingOptions, SettlingProgress, Unsettleable,
    damping::FrequencyEstimate,
    free_nodes::FreeNodes,
    loads::DistributedLoads,
    masses::NodalStiffness,
};
use crate::mechanics::Vec2;

/// Loads rise by this share of themselves in an iteration at most.
const LOAD_STEP: f64 = 1.0 / 400.0;
/// They rise only while the forces are out of balance by less than this share of all loads: what
/// friction and damage remember differs from the slowest path in proportion to it.
const GENTLE: f64 = 0.04;
/// Share of critical damping while loads rise: what rises at a steady rate lags behind in
/// proportion to the damping.
const RISING_DAMPING: f64 = 0.3;
/// Forces out of balance by so many times the loads are those of an unstable motion.
const UNSTABLE: f64 = 1e4;

/// How the iteration ended.
#[derive(Debug, Clone, Copy)]
pub(super) enum Course {
    /// At rest.
    Settled { iterations: u64, ratio: f64 },
    /// At the bound of the iterations.
    Exhausted { ratio: f64, load: f64 },
    /// Forces grew without bound.
    Unstable { iterations: u64 },
    /// Nobody wanted to wait any longer.
    Stopped,
}

/// A scene on its way to rest.
pub(super) struct Relaxation {
    free: FreeNodes,
    stiffness: NodalStiffness,
    /// Fictitious masses of the free nodes, kg.
    masses: Vec<f64>,
    /// Their loads in full, N.
    loads: Vec<Vec2>,
    /// Sum of the sizes of all loads, N.
    total_load: f64,
    distributed: DistributedLoads,
    /// Nodal forces of the distributed loads in full, N; empty where there are none.
    of_distributed: Vec<Vec2>,
    viscosities: Vec<f64>,
    frequency: FrequencyEstimate,
    /// The internal forces without the distributed loads among them, N.
    resisting: Vec<Vec2>,
    /// Forces that elements and contacts exert on the free nodes, along their free axes, N.
    internal: Vec<Vec2>,
    dt: f64,
}

/// How far forces are from balance, relative to the loads.
#[derive(Debug, Clone, Copy)]
struct Imbalance {
    largest: f64,
    mean: f64,
}

impl Relaxation {
    /// Prepares a scene: no viscosity, no distributed loads yet. `weight` multiplies the
    /// fictitious masses.
    pub fn new(simulation: &mut Simulation, weight: f64) -> Result<Self, SettlingFault> {
        let dt = simulation.scene.control.time_step;
        let materials = &mut simulation.scene.materials;
        let viscosities = materials.iter_mut().map(|m| std::mem::take(&mut m.viscosity)).collect();
        simulation.plan = Plan::new(&simulation.scene);
        let distributed = DistributedLoads::of(&simulation.scene);
        simulation.evaluate_forces();
        let free = FreeNodes::of(simulation);
        if free.list.is_empty() {
            return Err(Unsettleable::NoFreeNode.into());
        }
        let mut relaxation = Self {
            loads: free.list.iter().map(|f| free.load(f)).collect(),
            total_load: 0.0,
            masses: Vec::new(),
            stiffness: NodalStiffness::of(simulation, weight),
            distributed,
            of_distributed: Vec::new(),
            viscosities,
            frequency: FrequencyEstimate::default(),
            resisting: Vec::new(),
            internal: Vec::new(),
            dt,
            free,
        };
        relaxation.collect_internal(simulation);
        relaxation.add_distributed_loads(simulation);
        relaxation.total_load = relaxation.loads.iter().map(|load| load.norm()).sum();
        if relaxation.total_load <= 0.0 {
            return Err(Unsettleable::NoLoad.into());
        }
        relaxation.weigh();
        Ok(relaxation)
    }

    /// Loads on edges and stress in situ act through the elements: their nodal forces are what
    /// the forces lose when they are taken away.
    fn add_distributed_loads(&mut self, simulation: &mut Simulation) {
        if !self.distributed.act() {
            return;
        }
        let with = self.internal.clone();
        self.distributed.set_share(simulation, 0.0);
        simulation.evaluate_forces();
        self.collect_internal(simulation);
        let differ = with.iter().zip(&self.internal).map(|(with, without)| with - without);
        self.of_distributed = differ.collect();
        for (load, distributed) in self.loads.iter_mut().zip(&self.of_distributed) {
            *load += distributed;
        }
    }

    fn weigh(&mut self) {
        let mass = |free: &super::free_nodes::FreeNode| self.stiffness.mass(free.node, self.dt);
        self.masses = self.free.list.iter().map(mass).collect();
    }

    /// Iterates until the scene is at rest, then puts viscosities and loads back.
    pub fn run(
        mut self,
        simulation: &mut Simulation,
        options: SettlingOptions,
        done: u64,
        goes_on: &mut dyn FnMut(&SettlingProgress) -> bool,
    ) -> Course {
        let course = self.iterate(simulation, options, done, goes_on);
        self.distributed.set_share(simulation, 1.0);
        for (material, &viscosity) in simulation.scene.materials.iter_mut().zip(&self.viscosities) {
            material.viscosity = viscosity;
        }
        course
    }

    fn iterate(
        &mut self,
        simulation: &mut Simulation,
        options: SettlingOptions,
        done: u64,
        goes_on: &mut dyn FnMut(&SettlingProgress) -> bool,
    ) -> Course {
        let (mut load, mut ratio) = (0.0, f64::INFINITY);
        for iterations in done + 1..=options.most_iterations {
            self.distributed.set_share(simulation, load);
            simulation.evaluate_forces();
            self.collect_internal(simulation);
            let imbalance = self.imbalance(load);
            ratio = imbalance.largest;
            if !imbalance.mean.is_finite() || imbalance.mean > UNSTABLE {
                return Course::Unstable { iterations };
            }
            if load >= 1.0
                && ratio <= options.tolerance
                && let Some(ratio) = self.at_rest(simulation, options.tolerance)
            {
                return Course::Settled { iterations: iterations + 1, ratio };
            }
            if !goes_on(&SettlingProgress { iterations, load, ratio }) {
                return Course::Stopped;
            }
            let damping = self.damping(simulation, load);
            if load < 1.0 && imbalance.mean < GENTLE {
                load = (load + LOAD_STEP).min(1.0);
            }
            self.move_nodes(simulation, load, damping);
            if self.stiffness.update(simulation) {
                self.weigh();
            }
        }
        Course::Exhausted { ratio, load }
    }

    /// Whether the forces are still in balance with all velocities zero, as the first step finds
    /// them; the ratio if so.
    fn at_rest(&mut self, simulation: &mut Simulation, tolerance: f64) -> Option<f64> {
        simulation.scene.nodes.velocity.fill(Vec2::zeros());
        simulation.evaluate_forces();
        self.collect_internal(simulation);
        let ratio = self.imbalance(1.0).largest;
        (ratio <= tolerance).then_some(ratio)
    }

    /// Takes the forces of the last evaluation.
    fn collect_internal(&mut self, simulation: &Simulation) {
        let contact = &simulation.contact_force;
        self.internal.clear();
        self.internal.extend(self.free.list.iter().map(|free| {
            let n = free.node as usize;
            let apart = contact.get(n).copied().unwrap_or_default();
            self.free.along_free_axes(free, simulation.force[n] + apart)
        }));
    }

    /// Residual forces, relative to the mean load. Distributed loads are among the internal
    /// forces already.
    fn imbalance(&self, load: f64) -> Imbalance {
        let (mut largest, mut sum) = (0.0_f64, 0.0);
        for k in 0..self.internal.len() {
            let residual = self.residual(k, load).norm();
            largest = largest.max(residual);
            sum += residual;
        }
        let mean_load = self.total_load / self.internal.len() as f64;
        Imbalance { largest: largest / mean_load, mean: sum / self.total_load }
    }

    fn residual(&self, k: usize, load: f64) -> Vec2 {
        self.internal[k] + self.free.load(&self.free.list[k]) * load
    }

    /// Damping coefficient, 1/s, after an evaluation with this share of the loads.
    fn damping(&mut self, simulation: &Simulation, load: f64) -> f64 {
        self.resisting.clone_from(&self.internal);
        for (resisting, distributed) in self.resisting.iter_mut().zip(&self.of_distributed) {
            *resisting -= distributed * load;
        }
        let velocities = &simulation.scene.nodes.velocity;
        let critical = self.frequency.critical_damping(
            &self.free,
            velocities,
            &self.masses,
            &self.resisting,
            self.dt,
        );
        if load < 1.0 { RISING_DAMPING * critical } else { critical }
    }

    /// Central differences with damping c; positions move by the velocities times the time step
    /// of the deck, so that sliding and travel of the contacts are those of the positions.
    fn move_nodes(&mut self, simulation: &mut Simulation, load: f64, c: f64) {
        let dt = self.dt;
        let (keep, push) = ((2.0 - c * dt) / (2.0 + c * dt), 2.0 * dt / (2.0 + c * dt));
        for k in 0..self.internal.len() {
            let residual = self.residual(k, load);
            let velocity = &mut simulation.scene.nodes.velocity[self.free.list[k].node as usize];
            *velocity = *velocity * keep + residual * (push / self.masses[k]);
        }
        self.free.advance(&mut simulation.scene.nodes, dt);
    }
}
