//! Fictitious masses: every node gets the one with which the time step is just stable.
//!
//! With lumped masses the highest frequency of a mesh is at most the highest of any of its parts
//! alone (Hughes 1987, section 9.1.4). A triangle, joint or contact whose stiffness matrix has the
//! largest eigenvalue k gives each of its nodes the mass k Δt²/4, for which alone Δt would be
//! critical; nodes add up what their parts give.

use super::{super::Simulation, super::plan::stress_law, contact_stiffness::ContactStiffness};
use crate::{
    mechanics::{
        Vec2,
        triangle::{ReferenceShape, StressLaw, cauchy_stress, nodal_forces},
    },
    scene::{CohesiveModel, ElementKind, JointKind, Scene},
};
use nalgebra::{Matrix6, SymmetricEigen};

/// Share of the critical step that is used: stiffness grows with strain.
const MARGIN: f64 = 0.9;

/// Largest eigenvalues of the stiffness, summed at each node, N/m.
#[derive(Debug, Clone)]
pub(super) struct NodalStiffness {
    /// Of triangles and joints.
    elements: Vec<f64>,
    contact: ContactStiffness,
    weight: f64,
}

impl NodalStiffness {
    /// That of the present state. `weight` multiplies all masses.
    pub fn of(simulation: &Simulation, weight: f64) -> Self {
        let scene = &simulation.scene;
        let mut elements = vec![0.0; scene.nodes.len()];
        add_triangles(scene, &mut elements);
        add_joints(scene, &mut elements);
        Self { elements, contact: ContactStiffness::of(simulation), weight }
    }

    /// Takes over the couples of a new detection.
    pub fn update(&mut self, simulation: &Simulation) -> bool {
        self.contact.update(simulation)
    }

    /// Fictitious mass of a node, kg.
    pub fn mass(&self, node: u32, dt: f64) -> f64 {
        let node = node as usize;
        let step = dt / MARGIN;
        self.weight * (self.elements[node] + self.contact.at(node)) * step * step / 4.0
    }
}

fn add_triangles(scene: &Scene, stiffness: &mut [f64]) {
    for element in 0..scene.elements.len() {
        let Some(material) = scene.material_of(element) else { continue };
        let deforms =
            matches!(material.kind, ElementKind::ElasticTriangle | ElementKind::SofteningTriangle);
        if !deforms {
            continue;
        }
        let law = stress_law(material, scene.conventions.volumetric).without_viscosity();
        let nodes = scene.elements.corners::<3>(element);
        let reference = ReferenceShape::new(&nodes.map(|n| scene.nodes.initial[n]));
        let largest = triangle_stiffness(&law, &reference, &nodes.map(|n| scene.nodes.current[n]));
        nodes.into_iter().for_each(|n| stiffness[n] += largest);
    }
}

/// Largest eigenvalue of a triangle's tangent stiffness, N/m, by differences of its forces.
fn triangle_stiffness(law: &StressLaw, reference: &ReferenceShape, corners: &[Vec2; 3]) -> f64 {
    let step = 1e-6 * reference.double_area.abs().sqrt();
    let forces = |column: usize, by: f64| {
        let mut moved = *corners;
        moved[column / 2][column % 2] += by;
        let stress = cauchy_stress(law, reference, &moved, &[Vec2::zeros(); 3]);
        nodal_forces(&stress, &moved)
    };
    let mut stiffness = Matrix6::zeros();
    for column in 0..6 {
        let (ahead, behind) = (forces(column, step), forces(column, -step));
        for row in 0..6 {
            let change = ahead[row / 2][row % 2] - behind[row / 2][row % 2];
            stiffness[(row, column)] = change / (2.0 * step);
        }
    }
    // forces resist in the direction opposite to the internal forces' sign
    let symmetric = (stiffness + stiffness.transpose()) / 2.0;
    let values = SymmetricEigen::new(symmetric).eigenvalues;
    values.iter().fold(0.0, |largest, value| value.abs().max(largest))
}

/// A joint of penalty p resists a uniform opening of its length h with p/h for each area: two
/// times two nodes whose stiffest mode has the eigenvalue p.
fn add_joints(scene: &Scene, stiffness: &mut [f64]) {
    let cohesive = || scene.cohesive_laws.iter().filter(|law| law.is_cohesive);
    // every joint set acts on every joint of the classic dialect
    let together: f64 = cohesive().map(|law| law.penalty).sum();
    for element in 0..scene.elements.len() {
        if scene.elements.joint_kind[element] != JointKind::Intact {
            continue;
        }
        let penalty = match scene.conventions.cohesive {
            CohesiveModel::Classic => together,
            _ => scene.law_of(element).map_or(0.0, |law| {
                law.penalty * (law.tensile_strength / law.peak_strength).max(1.0)
            }),
        };
        let nodes = scene.elements.corners::<4>(element);
        nodes.into_iter().for_each(|n| stiffness[n] += penalty);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::triangle::Elasticity;

    /// Uniform volume change of an equilateral triangle is its stiffest mode: with the gradients
    /// of its shape functions as displacements, f = A (2 λ + 2 μ) g, and Σ g² = 3 · 4/(3 a²).
    #[test]
    fn stiffness_of_an_equilateral_triangle_is_that_of_its_volume() {
        let (lambda, mu, a) = (3e9, 2e9, 0.5_f64);
        let height = a * 0.75_f64.sqrt();
        let corners = [Vec2::zeros(), Vec2::new(a, 0.0), Vec2::new(a / 2.0, height)];
        let reference = ReferenceShape::new(&corners);
        let law = StressLaw::NeoHookean(Elasticity {
            lame_lambda: lambda,
            shear_modulus: mu,
            viscosity: 0.0,
            volumetric_share: 0.5,
        });
        let area = a * height / 2.0;
        let gradient_squared = 1.0 / (height * height);
        // u_i = g_i: div u = Σ g·g = 3/h², and the force on each node is A (λ+μ) div u g_i
        let expected = area * (lambda + mu) * 3.0 * gradient_squared;
        let found = triangle_stiffness(&law, &reference, &corners);
        assert!((found / expected - 1.0).abs() < 1e-6, "{found} against {expected}");
    }
}
