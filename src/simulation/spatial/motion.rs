//! Explicit integration of nodes (spec `y2d3d.md` F.3, F.4).

use super::{SpatialSimulation, forces::for_each};
use crate::{
    TOLERANCE,
    mechanics::Vec3,
    scene::{Condition, NodeSet, Scene},
};
use nalgebra::{Matrix3, Vector3};

/// Boundary condition of a node set at one instant.
#[derive(Debug, Clone)]
pub(super) struct Drive {
    conditions: [Condition; 3],
    /// Amplitudes times the factor of the load-time table.
    amplitudes: [f64; 3],
    gravity: [f64; 3],
    dt: f64,
    axes: Matrix3<f64>,
    /// Inverse of the axes, if a velocity is prescribed along one of them.
    inverse: Option<Matrix3<f64>>,
    /// What the amplitudes add to accelerations, where they are all 0 and no velocity is prescribed: a
    /// zero with the sign of their sum.
    nothing: Option<[f64; 3]>,
}

impl Drive {
    fn new(scene: &Scene<3>, set: usize, time: f64) -> Self {
        let NodeSet { conditions, amplitudes, .. } = &scene.node_sets[set];
        // without a table the original takes the global axes
        let (factor, axes) = match &scene.load_history {
            Some(history) => (
                // that the run stays within the table has been checked
                history
                    .factor_within(set, time)
                    .unwrap_or_else(|| history.points[set].last().map_or(1.0, |point| point.1)),
                scene.node_sets[set].clone(),
            ),
            None => (1.0, NodeSet { axes: Matrix3::identity(), ..scene.node_sets[set].clone() }),
        };
        let prescribed = conditions.contains(&Condition::Velocity);
        let amplitudes = amplitudes.map(|a| a * factor);
        let is_idle = !prescribed && amplitudes.iter().all(|a| a.to_bits() == 0);
        let nothing = |k| (0..3).map(|j| axes.axes[(k, j)] * 0.0).sum();
        Self {
            nothing: is_idle.then(|| std::array::from_fn(nothing)),
            conditions: *conditions,
            amplitudes,
            gravity: std::array::from_fn(|k| match axes.acceleration[k] {
                0.0 => scene.control.gravity[k],
                added => scene.control.gravity[k] + added,
            }),
            dt: scene.control.time_step,
            inverse: prescribed.then(|| axes.inverse_axes()),
            axes: axes.axes,
        }
    }

    /// Velocity at the end of the step.
    #[inline]
    fn velocity(&self, velocity: Vec3, force: Vec3, mass: f64) -> Vec3 {
        let acceleration = force / mass;
        if let Some(nothing) = &self.nothing {
            return Vec3::from_fn(|k, _| {
                let a = self.gravity[k] + acceleration[k] + nothing[k];
                velocity[k] + a * self.dt
            });
        }
        let added: [f64; 3] = std::array::from_fn(|k| match self.conditions[k] {
            Condition::Acceleration => self.amplitudes[k],
            Condition::Force => self.amplitudes[k] / mass,
            Condition::Velocity | Condition::Frozen | Condition::Absorbing => 0.0,
        });
        let [gx, gy, gz] = self.gravity;
        let axes = &self.axes;
        match &self.inverse {
            None => Vec3::from_fn(|k, _| {
                let a = self.gravity[k]
                    + acceleration[k]
                    + axes[(k, 0)] * added[0]
                    + axes[(k, 1)] * added[1]
                    + axes[(k, 2)] * added[2];
                velocity[k] + a * self.dt
            }),
            Some(inverse) => {
                let total =
                    Vec3::new(gx + acceleration.x, gy + acceleration.y, gz + acceleration.z);
                let local = apply(inverse, velocity);
                let new = Vec3::from_fn(|k, _| {
                    if self.conditions[k] == Condition::Velocity {
                        return self.amplitudes[k];
                    }
                    let a = added[k]
                        + total.x * inverse[(k, 0)]
                        + total.y * inverse[(k, 1)]
                        + total.z * inverse[(k, 2)];
                    local[k] + a * self.dt
                });
                apply(axes, new)
            }
        }
    }
}

#[inline]
fn apply(m: &Matrix3<f64>, v: Vec3) -> Vec3 {
    let row = |r: usize| m[(r, 0)] * v.x + m[(r, 1)] * v.y + m[(r, 2)] * v.z;
    Vector3::new(row(0), row(1), row(2))
}

impl SpatialSimulation {
    /// Moves all nodes that have mass and belong to a node set.
    pub(super) fn integrate(&mut self) {
        let Self { scene, force, joint_force, mass, drives, time, options, .. } = self;
        let team = &options.team;
        drives.clear();
        drives.extend((0..scene.node_sets.len()).map(|set| Drive::new(scene, set, *time)));
        let drives = &*drives;
        let dt = scene.control.time_step;
        let nodes = &mut scene.nodes;
        for_each(team, &mut nodes.velocity, |n, velocity| {
            let set = usize::try_from(nodes.set[n]).ok();
            let drive = set.and_then(|set| drives.get(set)).filter(|_| mass[n] >= TOLERANCE);
            if let Some(drive) = drive {
                *velocity = drive.velocity(*velocity, joint_force[n] + force[n], mass[n]);
            }
        });
        for_each(team, &mut nodes.current, |n, place| {
            let set = usize::try_from(nodes.set[n]).ok();
            if set.is_some_and(|set| set < drives.len()) && mass[n] >= TOLERANCE {
                *place += nodes.velocity[n] * dt;
            }
        });
    }

    /// Kinetic energy of the new velocities, if something needs it.
    pub(super) fn update_kinetic_energy(&mut self) {
        let interval = self.scene.control.output_interval;
        if self.plan.kinetic_energy_probes {
            self.kinetic_energy = self.sum_kinetic_energy();
            self.record_kinetic_energy();
        } else if (self.step + 1).is_multiple_of(interval) {
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
                sum += 0.5 * (v.x * v.x + v.y * v.y + v.z * v.z) * mass;
            }
        }
        sum
    }
}
