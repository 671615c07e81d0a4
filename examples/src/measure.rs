//! Quantities of a simulation: means, momenta, energies.

use ypsilon::{
    mechanics::Vec2,
    simulation::{Simulation, SpatialSimulation},
};
use ypsilon_post::{plot::Solid, results::Frame};

/// Bodies in motion, in the plane or in space: along, up in the plane; along, across, up in space.
pub trait Moving {
    /// Number of dimensions.
    fn dimension(&self) -> usize;
    /// Index of the step to be done.
    fn step_index(&self) -> u64;
    /// Time at its start \[s\].
    fn time(&self) -> f64;
    /// Index of the step with which the stage ends.
    fn end_step(&self) -> u64;
    /// Forces of the present place.
    fn evaluate_forces(&mut self);
    /// The motion that follows from them.
    fn advance(&mut self);
    /// Nodal masses \[kg\].
    fn masses(&self) -> &[f64];
    /// Velocity of a node \[m/s\].
    fn velocity(&self, node: usize) -> [f64; 3];
    /// Place of a node without stress \[m\].
    fn initial(&self, node: usize) -> [f64; 3];
    /// Place of a node \[m\].
    fn current(&self, node: usize) -> [f64; 3];
    /// Force on a node \[N\].
    fn force(&self, node: usize) -> [f64; 3];
    /// Triangles or tetrahedra.
    fn bodies(&self) -> Vec<usize>;
    /// Cauchy stress of a triangle or tetrahedron, as far as the dimensions go \[Pa\].
    fn stress(&self, element: usize) -> [[f64; 3]; 3];
    /// Strain energy of a triangle or tetrahedron \[J\].
    fn element_energy(&self, element: usize) -> f64;
    /// Index of the axis that points up.
    fn up(&self) -> usize {
        self.dimension() - 1
    }
}

macro_rules! moving {
    ($simulation:ty, $dimension:literal, $elements:ident, $stress:expr) => {
        impl Moving for $simulation {
            fn dimension(&self) -> usize {
                $dimension
            }

            fn step_index(&self) -> u64 {
                <$simulation>::step_index(self)
            }

            fn time(&self) -> f64 {
                <$simulation>::time(self)
            }

            fn end_step(&self) -> u64 {
                self.scene().control.end_step
            }

            fn evaluate_forces(&mut self) {
                <$simulation>::evaluate_forces(self);
            }

            fn advance(&mut self) {
                <$simulation>::advance(self);
            }

            fn masses(&self) -> &[f64] {
                <$simulation>::masses(self)
            }

            fn velocity(&self, node: usize) -> [f64; 3] {
                padded(self.scene().nodes.velocity[node].as_slice())
            }

            fn initial(&self, node: usize) -> [f64; 3] {
                padded(self.scene().nodes.initial[node].as_slice())
            }

            fn current(&self, node: usize) -> [f64; 3] {
                padded(self.scene().nodes.current[node].as_slice())
            }

            fn force(&self, node: usize) -> [f64; 3] {
                padded(self.forces()[node].as_slice())
            }

            fn bodies(&self) -> Vec<usize> {
                self.$elements().collect()
            }

            fn stress(&self, element: usize) -> [[f64; 3]; 3] {
                let mut stress = [[0.0; 3]; 3];
                for i in 0..$dimension {
                    for j in 0..$dimension {
                        stress[i][j] = $stress(self, element)[(i, j)];
                    }
                }
                stress
            }

            fn element_energy(&self, element: usize) -> f64 {
                self.strain_energy(element).unwrap_or(0.0)
            }
        }
    };
}

moving!(Simulation, 2, triangles, |s: &Simulation, e: usize| s.stresses()[e]);
moving!(SpatialSimulation, 3, tetrahedra, SpatialSimulation::stress);

fn padded(values: &[f64]) -> [f64; 3] {
    let mut all = [0.0; 3];
    all[..values.len()].copy_from_slice(values);
    all
}

/// Kinetic energy of all nodes \[J\].
#[must_use]
pub fn kinetic_energy(simulation: &(impl Moving + ?Sized)) -> f64 {
    let energy = |(node, mass): (usize, &f64)| {
        0.5 * mass * simulation.velocity(node).iter().map(|v| v * v).sum::<f64>()
    };
    simulation.masses().iter().enumerate().map(energy).sum()
}

/// Strain energy of all triangles or tetrahedra \[J\].
#[must_use]
pub fn strain_energy(simulation: &(impl Moving + ?Sized)) -> f64 {
    simulation.bodies().into_iter().map(|e| simulation.element_energy(e)).sum()
}

/// Momentum of some nodes \[kg m/s\].
#[must_use]
pub fn momentum(
    simulation: &(impl Moving + ?Sized),
    nodes: impl IntoIterator<Item = usize>,
) -> [f64; 3] {
    nodes.into_iter().fold([0.0; 3], |sum, node| {
        let (mass, v) = (simulation.masses()[node], simulation.velocity(node));
        [0, 1, 2].map(|k| sum[k] + mass * v[k])
    })
}

/// Angular momentum of some nodes about the origin \[kg m²/s\].
#[must_use]
pub fn angular_momentum(
    simulation: &(impl Moving + ?Sized),
    nodes: impl IntoIterator<Item = usize>,
) -> [f64; 3] {
    nodes.into_iter().fold([0.0; 3], |sum, node| {
        let (mass, x, v) =
            (simulation.masses()[node], simulation.current(node), simulation.velocity(node));
        [0, 1, 2].map(|k| {
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            sum[k] + mass * (x[i] * v[j] - x[j] * v[i])
        })
    })
}

/// Mass of some nodes \[kg\].
#[must_use]
pub fn mass(simulation: &(impl Moving + ?Sized), nodes: impl IntoIterator<Item = usize>) -> f64 {
    nodes.into_iter().map(|node| simulation.masses()[node]).sum()
}

/// Mean velocity of some nodes, weighted by mass \[m/s\].
#[must_use]
pub fn velocity(
    simulation: &(impl Moving + ?Sized),
    nodes: impl IntoIterator<Item = usize, IntoIter: Clone>,
) -> [f64; 3] {
    let nodes = nodes.into_iter();
    let whole = mass(simulation, nodes.clone());
    momentum(simulation, nodes).map(|p| p / whole)
}

/// Mean displacement of some nodes, weighted by mass \[m\].
#[must_use]
pub fn displacement(
    simulation: &(impl Moving + ?Sized),
    nodes: impl IntoIterator<Item = usize, IntoIter: Clone>,
) -> [f64; 3] {
    let nodes = nodes.into_iter();
    let whole = mass(simulation, nodes.clone());
    let sum = nodes.fold([0.0; 3], |sum, node| {
        let mass = simulation.masses()[node];
        let (x, y) = (simulation.initial(node), simulation.current(node));
        [0, 1, 2].map(|k| sum[k] + mass * (y[k] - x[k]))
    });
    sum.map(|u| u / whole)
}

/// Tetrahedra as they are, for a picture, each with a number.
#[must_use]
pub fn solid(simulation: &SpatialSimulation, value: impl Fn(usize) -> f64) -> Solid {
    let scene = simulation.scene();
    Solid {
        points: scene.nodes.current.iter().map(|p| [p[0], p[1], p[2]]).collect(),
        tetrahedra: simulation.tetrahedra().map(|e| scene.elements.corners::<4>(e)).collect(),
        values: simulation.tetrahedra().map(value).collect(),
    }
}

/// The bodies as they are, for a picture; without σzz.
#[must_use]
pub fn frame(simulation: &Simulation) -> Frame {
    let scene = simulation.scene();
    let pair = |v: &Vec2| [v[0], v[1]];
    let points: Vec<[f64; 2]> = scene.nodes.current.iter().map(pair).collect();
    let moved = scene.nodes.current.iter().zip(&scene.nodes.initial);
    let stress = |e: usize| {
        let t = &simulation.stresses()[e];
        [t[(0, 0)], t[(1, 1)], 0.0, t[(0, 1)], 0.0, 0.0]
    };
    Frame {
        time: simulation.time(),
        displacement: Some(moved.map(|(x, y)| pair(&(x - y))).collect()),
        elements: simulation
            .triangles()
            .map(|e| scene.elements.corners::<3>(e).map(|n| n as u32))
            .collect(),
        property: simulation.triangles().map(|e| scene.elements.property[e]).collect(),
        stress: Some(simulation.triangles().map(stress).collect()),
        points,
        ..Frame::default()
    }
}
