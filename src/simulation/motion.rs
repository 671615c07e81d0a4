use super::{Simulation, free_motion::Free, plan::MotionPhase};
use crate::{
    TOLERANCE,
    mechanics::{Vec2, rigid_triangle},
    scene::{Condition, NodeSet, Nodes},
};
use nalgebra::Matrix2;
use std::ops::Range;

/// Boundary condition of a node set at one instant.
struct Drive {
    conditions: [Condition; 2],
    amplitudes: [f64; 2],
    gravity: f64,
    dt: f64,
    /// Local axes and their inverse, unless they are the global ones.
    frame: Option<(Matrix2<f64>, Matrix2<f64>)>,
}

impl Drive {
    fn new(set: &NodeSet<2>, factor: f64, gravity: f64, dt: f64) -> Self {
        // multiplying by global axes changes nothing but the sign of a zero, which
        // only a prescribed velocity can bring in
        let prescribed = set.conditions.contains(&Condition::Velocity);
        let frame =
            (prescribed || set.axes != Matrix2::identity()).then(|| (set.axes, set.inverse_axes()));
        let amplitudes = set.amplitudes.map(|a| a * factor);
        Self { conditions: set.conditions, amplitudes, gravity, dt, frame }
    }

    /// Whether the nodes move under forces along the global axes.
    fn is_free(&self) -> bool {
        self.frame.is_none() && self.conditions == [Condition::Force; 2]
    }

    /// Velocity at the end of the step.
    #[inline]
    fn velocity(&self, velocity: Vec2, force: Vec2, mass: f64) -> Vec2 {
        let force = Vec2::new(force.x, force.y + self.gravity * mass);
        match &self.frame {
            None => self.local_velocity(velocity, force, mass),
            Some((axes, inverse)) => {
                let (v, f) = (apply(inverse, velocity), apply(inverse, force));
                apply(axes, self.local_velocity(v, f, mass))
            }
        }
    }

    #[inline]
    fn local_velocity(&self, velocity: Vec2, force: Vec2, mass: f64) -> Vec2 {
        let component = |k: usize| {
            let (v, f, a) = (velocity[k], force[k], self.amplitudes[k]);
            match self.conditions[k] {
                Condition::Force | Condition::Absorbing => v + (a + f) / mass * self.dt,
                Condition::Acceleration => v + (a + f / mass) * self.dt,
                Condition::Velocity => a,
                Condition::Frozen => v,
            }
        };
        Vec2::new(component(0), component(1))
    }
}

/// Moves the nodes of some runs that have mass as `drive` says.
fn integrate(
    runs: &[Range<u32>],
    nodes: &mut Nodes<2>,
    masses: &[f64],
    forces: &[Vec2],
    drive: &Drive,
) {
    for n in runs.iter().flat_map(|run| run.start as usize..run.end as usize) {
        let mass = masses[n];
        if mass > TOLERANCE {
            let velocity = drive.velocity(nodes.velocity[n], forces[n], mass);
            nodes.velocity[n] = velocity;
            nodes.current[n] += velocity * drive.dt;
        }
    }
}

#[inline]
fn apply(m: &Matrix2<f64>, v: Vec2) -> Vec2 {
    Vec2::new(m[(0, 0)] * v.x + m[(0, 1)] * v.y, m[(1, 0)] * v.x + m[(1, 1)] * v.y)
}

impl Simulation {
    /// Explicit integration of nodes and rigid triangles, in the plan's order.
    pub(super) fn integrate(&mut self) {
        for phase in 0..self.plan.motions.len() {
            match self.plan.motions[phase].clone() {
                MotionPhase::Nodes { set, runs } => self.move_nodes(set, runs),
                MotionPhase::Rigid(range) => self.move_rigid_triangles(range),
            }
        }
    }

    /// Moves the nodes of one set that have mass (spec `y2d3d.md` F.1).
    fn move_nodes(&mut self, set: usize, runs: Range<usize>) {
        let control = &self.scene.control;
        let (dt, gravity, time) = (control.time_step, control.gravity[1], self.time);
        let runs = &self.plan.node_runs[runs];
        let factor = self.scene.load_factor(set, time);
        let drive = Drive::new(&self.scene.node_sets[set], factor, gravity, dt);
        if !self.contact_force.is_empty() {
            for n in runs.iter().flat_map(|run| run.start as usize..run.end as usize) {
                if self.mass[n] > TOLERANCE {
                    self.force[n] += self.contact_force[n];
                }
            }
        }
        let nodes = &mut self.scene.nodes;
        if drive.is_free() {
            let free = Free { amplitudes: drive.amplitudes, gravity, dt };
            for run in runs {
                free.advance(run, nodes, &self.mass, &self.force);
            }
        } else {
            integrate(runs, nodes, &self.mass, &self.force, &drive);
        }
    }

    /// Rigid triangles move under the contact forces of their nodes.
    fn move_rigid_triangles(&mut self, range: Range<usize>) {
        let dt = self.scene.control.time_step;
        for planned in &self.plan.rigid[range] {
            let density = self.scene.materials[planned.material].density;
            let nodes = &mut self.scene.nodes;
            let corners = planned.corners.map(|n| n as usize);
            let motion = rigid_triangle::advance(
                density,
                &corners.map(|n| nodes.current[n]),
                &corners.map(|n| nodes.velocity[n]),
                &corners.map(|n| self.force[n]),
                dt,
            );
            for (i, n) in corners.into_iter().enumerate() {
                nodes.current[n] = motion.positions[i];
                nodes.velocity[n] = motion.velocities[i];
                self.mass[n] = motion.nodal_mass;
            }
        }
    }

    /// Kinetic energy of the new velocities, if something needs it.
    pub(super) fn update_kinetic_energy(&mut self) {
        if self.plan.kinetic_energy_probes {
            self.kinetic_energy = self.sum_kinetic_energy();
            self.record_kinetic_energy();
        } else if (self.step + 1).is_multiple_of(self.scene.control.output_interval) {
            // the next state is written with the energy at the end of this step
            self.kinetic_energy = self.sum_kinetic_energy();
        }
    }

    /// Kinetic energy of all nodes with mass, J, nodes ascending.
    #[must_use]
    pub fn sum_kinetic_energy(&self) -> f64 {
        let mut sum = 0.0;
        for (v, &mass) in self.scene.nodes.velocity.iter().zip(&self.mass) {
            if mass >= TOLERANCE {
                sum += 0.5 * (v.x * v.x + v.y * v.y) * mass;
            }
        }
        sum
    }
}
