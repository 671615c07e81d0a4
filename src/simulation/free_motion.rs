//! Motion of nodes under forces along the global axes: nearly all nodes of nearly all scenes.

use crate::{
    TOLERANCE,
    lanes::{self, Kernel, LANES, Lanes, Mask as _},
    mechanics::Vec2,
};

/// Forces and gravity on the nodes of a set.
#[derive(Debug, Clone, Copy)]
pub(super) struct Free {
    /// Force on each node along each axis, N.
    pub amplitudes: [f64; 2],
    /// Acceleration along y, m/s².
    pub gravity: f64,
    /// Time step, s.
    pub dt: f64,
}

/// Nodes that follow each other.
pub(super) struct Part<'a> {
    pub current: &'a mut [Vec2],
    pub velocity: &'a mut [Vec2],
    pub force: &'a [Vec2],
    pub mass: &'a [f64],
}

impl Free {
    /// Moves the nodes that have mass.
    pub fn advance(&self, part: Part<'_>) {
        lanes::run(Advance { free: self, part });
    }

    /// Moves a node if it has mass.
    #[inline(always)]
    fn advance_node(&self, current: &mut Vec2, velocity: &mut Vec2, force: &Vec2, mass: f64) {
        if mass > TOLERANCE {
            let [ax, ay] = self.amplitudes;
            let fy = force.y + self.gravity * mass;
            let v = Vec2::new(
                velocity.x + (ax + force.x) / mass * self.dt,
                velocity.y + (ay + fy) / mass * self.dt,
            );
            *velocity = v;
            *current += v * self.dt;
        }
    }
}

struct Advance<'a> {
    free: &'a Free,
    part: Part<'a>,
}

impl Kernel for Advance<'_> {
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes>(self) {
        let Self { free, part } = self;
        let [ax, ay] = free.amplitudes;
        // forces are sums that start from +0, so that adding 0 to them changes no bit
        let amplitude = L::new([ax, ay, ax, ay]);
        let gravity = L::new([0.0, free.gravity, 0.0, free.gravity]);
        let (dt, tolerance) = (L::splat(free.dt), L::splat(TOLERANCE));
        let (mut current, mut velocity) =
            (part.current.chunks_exact_mut(LANES), part.velocity.chunks_exact_mut(LANES));
        let (mut force, mut mass) = (part.force.chunks_exact(LANES), part.mass.chunks_exact(LANES));
        let four = current.by_ref().zip(velocity.by_ref()).zip(force.by_ref().zip(mass.by_ref()));
        for ((x, v), (f, m)) in four {
            let m: &[f64; LANES] = m.try_into().unwrap_or_else(|_| unreachable!("four"));
            if tolerance.lt(L::load(m)).all() {
                for half in [0, 2] {
                    let mass = L::new([m[half], m[half], m[half + 1], m[half + 1]]);
                    let force = two::<L>(f, half) + gravity * mass;
                    let velocity = two::<L>(v, half) + (amplitude + force) / mass * dt;
                    set_two(velocity, v, half);
                    set_two(two::<L>(x, half) + velocity * dt, x, half);
                }
            } else {
                for i in 0..LANES {
                    free.advance_node(&mut x[i], &mut v[i], &f[i], m[i]);
                }
            }
        }
        let (x, v) = (current.into_remainder(), velocity.into_remainder());
        let (f, m) = (force.remainder(), mass.remainder());
        for i in 0..m.len() {
            free.advance_node(&mut x[i], &mut v[i], &f[i], m[i]);
        }
    }
}

/// Components of two neighbours.
#[inline(always)]
fn two<L: Lanes>(values: &[Vec2], first: usize) -> L {
    let [a, b] = [values[first], values[first + 1]];
    L::new([a.x, a.y, b.x, b.y])
}

#[inline(always)]
fn set_two<L: Lanes>(lanes: L, values: &mut [Vec2], first: usize) {
    let [ax, ay, bx, by] = lanes.array();
    values[first] = Vec2::new(ax, ay);
    values[first + 1] = Vec2::new(bx, by);
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    fn vectors() -> impl Strategy<Value = Vec<Vec2>> {
        prop::collection::vec(prop::array::uniform2(-9.0..9.0).prop_map(Vec2::from), 40)
    }

    proptest! {
        #[test]
        fn lanes_move_nodes_as_one_by_one(
            current in vectors(),
            velocity in vectors(),
            force in vectors(),
            mass in prop::collection::vec(prop::sample::select(vec![0.0, 0.3, 2.0, 7.1]), 40),
            massive in 0usize..40,
            gravity in prop::sample::select(vec![0.0, -9.81]),
            amplitudes in prop::sample::select(vec![[0.0, 0.0], [-0.0, 3.0]]),
        ) {
            let mut mass = mass;
            mass[..massive].fill(1.7);
            let free = Free { amplitudes, gravity, dt: 1e-3 };
            let (mut together, mut speeds) = (current.clone(), velocity.clone());
            let (mut x, mut v) = (current, velocity);
            for i in 3..39 {
                free.advance_node(&mut x[i], &mut v[i], &force[i], mass[i]);
            }
            free.advance(Part {
                current: &mut together[3..39],
                velocity: &mut speeds[3..39],
                force: &force[3..39],
                mass: &mass[3..39],
            });
            let bits = |all: &[Vec2]| -> Vec<[u64; 2]> {
                all.iter().map(|p| [p.x.to_bits(), p.y.to_bits()]).collect()
            };
            prop_assert_eq!(bits(&together), bits(&x));
            prop_assert_eq!(bits(&speeds), bits(&v));
        }
    }
}
