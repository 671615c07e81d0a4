use super::{
    Simulation, as_usize,
    disjoint::Disjoint,
    free_motion::{Free, Part},
    plan::{MotionPhase, Plan},
};
use crate::{
    TOLERANCE,
    mechanics::{Vec2, rigid_triangle},
    scene::{Condition, NodeSet, Scene},
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

/// What the motion of nodes depends on, and what it changes.
struct Motion<'a> {
    scene: &'a Scene,
    plan: &'a Plan,
    time: f64,
    mass: &'a [f64],
    /// Contact forces, where they are summed apart.
    contact_force: &'a [Vec2],
    force: Disjoint<'a, Vec2>,
    current: Disjoint<'a, Vec2>,
    velocity: Disjoint<'a, Vec2>,
}

impl Motion<'_> {
    /// Moves the nodes of one set that are in `part` (spec `y2d3d.md` F.1).
    ///
    /// # Safety
    /// Nobody else moves nodes of this part meanwhile.
    unsafe fn advance(&self, set: usize, runs: &[Range<u32>], part: &Range<u32>) {
        let control = &self.scene.control;
        let (dt, gravity) = (control.time_step, control.gravity[1]);
        let factor = self.scene.load_factor(set, self.time);
        let drive = Drive::new(&self.scene.node_sets[set], factor, gravity, dt);
        let free = Free { amplitudes: drive.amplitudes, gravity, dt };
        for run in runs {
            let run = run.start.max(part.start)..run.end.min(part.end);
            if run.is_empty() {
                continue;
            }
            let run = as_usize(&run);
            // SAFETY: the caller's promise
            let (force, current, velocity) = unsafe {
                (
                    self.force.part(run.clone()),
                    self.current.part(run.clone()),
                    self.velocity.part(run.clone()),
                )
            };
            let mass = &self.mass[run.clone()];
            if !self.contact_force.is_empty() {
                add_where_massive(force, &self.contact_force[run], mass);
            }
            let part = Part { current, velocity, force, mass };
            if drive.is_free() {
                free.advance(part);
            } else {
                integrate(part, &drive);
            }
        }
    }
}

fn add_where_massive(force: &mut [Vec2], more: &[Vec2], mass: &[f64]) {
    for ((force, more), &mass) in force.iter_mut().zip(more).zip(mass) {
        if mass > TOLERANCE {
            *force += more;
        }
    }
}

/// Moves nodes that have mass as `drive` says.
fn integrate(part: Part<'_>, drive: &Drive) {
    for (n, &mass) in part.mass.iter().enumerate() {
        if mass > TOLERANCE {
            let velocity = drive.velocity(part.velocity[n], part.force[n], mass);
            part.velocity[n] = velocity;
            part.current[n] += velocity * drive.dt;
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
        let mut next = 0;
        while next < self.plan.motions.len() {
            let is_nodes = |motion: &&MotionPhase| matches!(motion, MotionPhase::Nodes { .. });
            let nodes = self.plan.motions[next..].iter().take_while(is_nodes).count();
            self.move_nodes(next..next + nodes);
            next += nodes;
            if let Some(MotionPhase::Rigid(range)) = self.plan.motions.get(next) {
                self.move_rigid_triangles(range.clone());
                next += 1;
            }
        }
    }

    /// Moves the nodes of some sets, each thread its part of them.
    fn move_nodes(&mut self, motions: Range<usize>) {
        let mut nodes = std::mem::take(&mut self.scene.nodes);
        let motion = Motion {
            scene: &self.scene,
            plan: &self.plan,
            time: self.time,
            mass: &self.mass,
            contact_force: &self.contact_force,
            force: Disjoint::new(&mut self.force),
            current: Disjoint::new(&mut nodes.current),
            velocity: Disjoint::new(&mut nodes.velocity),
        };
        let parts = self.domains.node_parts();
        self.options.team.share_places(parts.len(), |place| {
            for phase in &motion.plan.motions[motions.clone()] {
                let MotionPhase::Nodes { set, runs } = phase else { continue };
                let runs = &motion.plan.node_runs[runs.clone()];
                // SAFETY: parts have no nodes in common, and each place is visited once
                unsafe { motion.advance(*set, runs, &parts[place]) };
            }
        });
        self.scene.nodes = nodes;
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
