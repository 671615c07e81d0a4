//! The nodes that settle, and the residual forces along the axes in which they are free.

use super::super::Simulation;
use crate::{
    TOLERANCE,
    mechanics::Vec2,
    scene::{Condition, Nodes},
};
use nalgebra::Matrix2;

/// Whether a condition keeps a node where it is: prescribed velocities are held at zero.
pub(super) fn holds(condition: Condition) -> bool {
    matches!(condition, Condition::Velocity | Condition::Frozen)
}

/// What a node set does to the forces on its nodes.
#[derive(Debug, Clone)]
struct Constraint {
    /// Force on each node and acceleration, in local axes, N and m/s².
    force: Vec2,
    acceleration: Vec2,
    /// Local axes, their inverse, and which of them are held; none where a node is free along
    /// the global axes.
    axes: Option<(Matrix2<f64>, Matrix2<f64>, [bool; 2])>,
}

/// A node that settles.
#[derive(Debug, Clone, Copy)]
pub(super) struct FreeNode {
    pub node: u32,
    set: u32,
    /// Its mass, kg.
    pub mass: f64,
}

/// All nodes that settle.
#[derive(Debug, Clone)]
pub(super) struct FreeNodes {
    pub list: Vec<FreeNode>,
    constraints: Vec<Constraint>,
    gravity: f64,
}

impl FreeNodes {
    /// The nodes of a simulation whose masses are known: after the first evaluation of forces.
    pub fn of(simulation: &Simulation) -> Self {
        let scene = &simulation.scene;
        let constraints = scene.node_sets.iter().enumerate().map(|(index, set)| {
            let factor = scene.load_factor(index, simulation.time);
            let along = |kind: Condition| {
                let amplitude = |k: usize| match set.conditions[k] == kind {
                    true => set.amplitudes[k] * factor,
                    false => 0.0,
                };
                Vec2::new(amplitude(0), amplitude(1))
            };
            let held = set.conditions.map(holds);
            let is_global = set.axes == Matrix2::identity() && held == [false; 2];
            Constraint {
                force: along(Condition::Force),
                acceleration: along(Condition::Acceleration),
                axes: (!is_global).then(|| (set.axes, set.inverse_axes(), held)),
            }
        });
        let constraints: Vec<Constraint> = constraints.collect();
        let free = |node: usize| {
            let set = usize::try_from(scene.nodes.set[node]).ok()?;
            let moves = scene.node_sets.get(set)?.moves;
            let held = constraints[set].axes.as_ref().is_some_and(|(_, _, h)| *h == [true; 2]);
            let mass = simulation.mass[node];
            (moves && !held && mass > TOLERANCE).then_some(FreeNode {
                node: node as u32,
                set: set as u32,
                mass,
            })
        };
        let list = (0..scene.nodes.len()).filter_map(free).collect();
        Self { list, constraints, gravity: scene.control.gravity[1] }
    }

    /// Gravity and nodal loads on a node, along its free axes, N.
    pub fn load(&self, free: &FreeNode) -> Vec2 {
        let constraint = &self.constraints[free.set as usize];
        let mut load = self.along_free_axes(free, Vec2::new(0.0, self.gravity * free.mass));
        let own = constraint.force + constraint.acceleration * free.mass;
        load += match &constraint.axes {
            None => own,
            Some((axes, _, held)) => axes * without(own, *held),
        };
        load
    }

    /// The part of a force along the axes in which a node is free, N.
    pub fn along_free_axes(&self, free: &FreeNode, force: Vec2) -> Vec2 {
        match &self.constraints[free.set as usize].axes {
            None => force,
            Some((axes, inverse, held)) => axes * without(inverse * force, *held),
        }
    }

    /// Moves the nodes with their velocities for one time step.
    pub fn advance(&self, nodes: &mut Nodes<2>, dt: f64) {
        for free in &self.list {
            let n = free.node as usize;
            nodes.current[n] += nodes.velocity[n] * dt;
        }
    }
}

fn without(vector: Vec2, held: [bool; 2]) -> Vec2 {
    let component = |k: usize| if held[k] { 0.0 } else { vector[k] };
    Vec2::new(component(0), component(1))
}
