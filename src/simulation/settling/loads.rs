//! Loads on edges and stress in situ, which element forces bring in.

use super::super::Simulation;
use crate::scene::{InSituStress, Scene};

/// What they are at the first instant.
#[derive(Debug, Clone)]
pub(super) struct DistributedLoads {
    /// Pressure and traction of each node set, Pa.
    edges: Vec<[f64; 2]>,
    in_situ: Option<InSituStress>,
}

impl DistributedLoads {
    pub fn of(scene: &Scene) -> Self {
        Self {
            edges: scene.node_sets.iter().map(|set| [set.pressure, set.traction]).collect(),
            in_situ: scene.in_situ,
        }
    }

    /// Whether there are any.
    pub fn act(&self) -> bool {
        self.in_situ.is_some() || self.edges.as_flattened().iter().any(|&load| load != 0.0)
    }

    /// Lets a share of them act.
    pub fn set_share(&self, simulation: &mut Simulation, share: f64) {
        if !self.act() {
            return;
        }
        let scene = &mut simulation.scene;
        for (set, [pressure, traction]) in scene.node_sets.iter_mut().zip(&self.edges) {
            (set.pressure, set.traction) = (share * pressure, share * traction);
        }
        scene.in_situ = self.in_situ.map(|stress| InSituStress {
            at_surface: stress.at_surface.map(|s| share * s),
            gradient: stress.gradient.map(|g| share * g),
            ..stress
        });
    }
}
