//! Quantities of a simulation: means, momenta, energies.

use ypsilon::{mechanics::Vec2, simulation::Simulation};
use ypsilon_post::results::Frame;

/// Kinetic energy of all nodes \[J\].
#[must_use]
pub fn kinetic_energy(simulation: &Simulation) -> f64 {
    simulation.sum_kinetic_energy()
}

/// Strain energy of all triangles \[J\].
#[must_use]
pub fn strain_energy(simulation: &Simulation) -> f64 {
    simulation.triangles().filter_map(|e| simulation.strain_energy(e)).sum()
}

/// Momentum of some nodes \[kg m/s\].
#[must_use]
pub fn momentum(simulation: &Simulation, nodes: impl IntoIterator<Item = usize>) -> [f64; 2] {
    let scene = simulation.scene();
    nodes.into_iter().fold([0.0; 2], |sum, node| {
        let (mass, v) = (simulation.masses()[node], scene.nodes.velocity[node]);
        [sum[0] + mass * v[0], sum[1] + mass * v[1]]
    })
}

/// Mass of some nodes \[kg\].
#[must_use]
pub fn mass(simulation: &Simulation, nodes: impl IntoIterator<Item = usize>) -> f64 {
    nodes.into_iter().map(|node| simulation.masses()[node]).sum()
}

/// Mean velocity of some nodes, weighted by mass \[m/s\].
#[must_use]
pub fn velocity(
    simulation: &Simulation,
    nodes: impl IntoIterator<Item = usize, IntoIter: Clone>,
) -> [f64; 2] {
    let nodes = nodes.into_iter();
    let whole = mass(simulation, nodes.clone());
    momentum(simulation, nodes).map(|p| p / whole)
}

/// Mean displacement of some nodes, weighted by mass \[m\].
#[must_use]
pub fn displacement(
    simulation: &Simulation,
    nodes: impl IntoIterator<Item = usize, IntoIter: Clone>,
) -> [f64; 2] {
    let nodes = nodes.into_iter();
    let whole = mass(simulation, nodes.clone());
    let scene = simulation.scene();
    let sum = nodes.fold([0.0; 2], |sum, node| {
        let mass = simulation.masses()[node];
        let u = scene.nodes.current[node] - scene.nodes.initial[node];
        [sum[0] + mass * u[0], sum[1] + mass * u[1]]
    });
    sum.map(|u| u / whole)
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
        [t[(0, 0)], t[(1, 1)], 0.0, t[(0, 1)]]
    };
    Frame {
        time: simulation.time(),
        displacement: Some(moved.map(|(x, y)| pair(&(x - y))).collect()),
        triangles: simulation
            .triangles()
            .map(|e| scene.elements.corners::<3>(e).map(|n| n as u32))
            .collect(),
        property: simulation.triangles().map(|e| scene.elements.property[e]).collect(),
        stress: Some(simulation.triangles().map(stress).collect()),
        points,
        ..Frame::default()
    }
}
