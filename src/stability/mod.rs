//! How long a time step may be: the highest mode of elements, joints, contacts and viscosity
//! together, found without assembling a matrix.

mod facing;
mod facing3;
mod lanczos;
mod limits;
mod plane;
mod spatial;
mod system;

pub use limits::{Culprit, Limits};
pub use plane::element_matrices;
pub use spatial::element_matrices as solid_matrices;
pub use system::{ElementMatrices, Part, Share};

use crate::{scene::Scene, simulation::AnySimulation};

impl Limits {
    /// Those of a scene of triangles in its present shape, after joint insertion.
    #[must_use]
    pub fn of_plane(scene: &Scene) -> Self {
        Self::of(&plane::system(scene))
    }

    /// Those of a scene of tetrahedra in its present shape, after joint insertion.
    #[must_use]
    pub fn of_space(scene: &Scene<3>) -> Self {
        Self::of(&spatial::system(scene))
    }

    /// Those of a simulation as it stands.
    #[must_use]
    pub fn of_simulation(simulation: &AnySimulation) -> Self {
        match simulation {
            AnySimulation::Plane(simulation) => Self::of_plane(simulation.scene()),
            AnySimulation::Spatial(simulation) => Self::of_space(simulation.scene()),
        }
    }
}
