//! Ten-node tetrahedron, finite strain, compressible neo-Hookean, free of volumetric locking
//! (spec `y3d.md` 2.4).
//!
//! Nodes 0 to 3 are corners, 4 to 9 lie on the edges (0,1), (1,2), (2,0), (0,3), (1,3), (2,3).
//! The element is isoparametric in both configurations, so edges may be curved. Stresses are taken
//! at four points. There the change of volume is that of the middle of the element (F-bar):
//! with J₀ in the middle, J and B = F Fᵀ at a point
//!
//! > T = (μ/J₀)((J₀/J)^⅔ B − I) + p(J₀) I + η D,
//!
//! p as in [`super::tetrahedron`]. One condition on the volume for ten nodes is few enough for an
//! element that nearly keeps its volume to bend freely. Momentum and angular momentum are
//! conserved; the forces are not the exact gradient of an energy.

use super::{
    Vec3,
    tetrahedron::{SolidLaw, determinant, inverse, product},
};
use nalgebra::Matrix3;

/// Number of nodes.
pub const NODES: usize = 10;

/// Corners at the ends of the edges that nodes 4 to 9 lie on.
pub const EDGES: [[usize; 2]; 6] = [[0, 1], [1, 2], [2, 0], [0, 3], [1, 3], [2, 3]];

/// Stable time step over the time that a compression wave takes across the smallest height of a
/// straight element: below what the highest frequency allows for all shapes that were tried.
pub const STABLE_SHARE: f64 = 0.25;

/// Volume coordinates of a point of integration: (5 + 3√5)/20 of one corner, (5 − √5)/20 of the others.
const NEAR: f64 = 0.585_410_196_624_968_5;
const FAR: f64 = 0.138_196_601_125_010_5;

/// What a corner bears of the mass: diagonal scaling of the consistent mass of the same four points.
const CORNER_SHARE: f64 = DIAGONAL[0] / (4.0 * DIAGONAL[0] + 6.0 * DIAGONAL[1]);
/// What a node on an edge bears of it.
const EDGE_SHARE: f64 = DIAGONAL[1] / (4.0 * DIAGONAL[0] + 6.0 * DIAGONAL[1]);

/// Diagonal of that mass for an element of mass 1: at a corner, on an edge.
const DIAGONAL: [f64; 2] = {
    let corner = [NEAR * (2.0 * NEAR - 1.0), FAR * (2.0 * FAR - 1.0)];
    let edge = [4.0 * NEAR * FAR, 4.0 * FAR * FAR];
    [
        0.25 * (corner[0] * corner[0] + 3.0 * corner[1] * corner[1]),
        0.5 * (edge[0] * edge[0] + edge[1] * edge[1]),
    ]
};

/// Gradients of the shape functions along the last three volume coordinates.
type Gradients = [Vec3; NODES];

/// Undeformed shape, computed once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ReferenceShape {
    /// Gradients of the shape functions at the four points, 1/m.
    points: [Gradients; 4],
    /// The same in the middle.
    middle: Gradients,
    /// Volume by the four points, m³.
    pub volume: f64,
    /// Six times the smallest volume per point, m³: not above 0 where an edge is curved too much.
    pub least_jacobian: f64,
}

impl ReferenceShape {
    /// Shape of the stress-free tetrahedron.
    #[must_use]
    pub fn new(nodes: &[Vec3; NODES]) -> Self {
        let mut volume = 0.0;
        let mut least = f64::INFINITY;
        let points = point_gradients().map(|natural| {
            let (gradients, jacobian) = in_space(&natural, nodes);
            volume += 0.25 * jacobian / 6.0;
            least = least.min(jacobian);
            gradients
        });
        let (middle, jacobian) = in_space(&natural_gradients([0.25; 4]), nodes);
        Self { points, middle, volume, least_jacobian: least.min(jacobian) }
    }

    /// Masses that the element gives its corners and its other nodes, kg.
    #[must_use]
    pub fn nodal_masses(&self, density: f64) -> [f64; NODES] {
        let mass = density * self.volume;
        std::array::from_fn(|i| mass * if i < 4 { CORNER_SHARE } else { EDGE_SHARE })
    }
}

/// What an element does to its nodes.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Response {
    /// Force on each node, N.
    pub forces: [Vec3; NODES],
    /// Cauchy stress, Pa: mean of the four points.
    pub stress: Matrix3<f64>,
    /// Six times the least current volume per point, m³: not above 0 where the element has turned
    /// inside out.
    pub least_jacobian: f64,
}

/// Forces and stress of an element.
#[must_use]
pub fn evaluate(
    law: &SolidLaw,
    reference: &ReferenceShape,
    nodes: &[Vec3; NODES],
    velocities: &[Vec3; NODES],
) -> Response {
    let ratio = determinant(&gradient(nodes, &reference.middle));
    let (shear, viscosity) = (law.elasticity.shear_modulus, law.elasticity.viscosity);
    let tension = law.tension(ratio);
    let mut response = Response {
        forces: [Vec3::zeros(); NODES],
        stress: Matrix3::zeros(),
        least_jacobian: f64::INFINITY,
    };
    for (natural, initial) in point_gradients().iter().zip(&reference.points) {
        let (current, jacobian) = in_space(natural, nodes);
        let deformation = gradient(nodes, initial);
        let expansion = determinant(&deformation);
        let left_cauchy_green = product(&deformation, &deformation.transpose());
        // of the same volume as in the middle
        let scale = (ratio / expansion).cbrt().powi(2);
        let rate = gradient(velocities, &current);
        let stress = Matrix3::from_fn(|i, j| {
            let unit = if i == j { 1.0 } else { 0.0 };
            shear / ratio * (scale * left_cauchy_green[(i, j)] - unit)
                + tension * unit
                + viscosity * 0.5 * (rate[(i, j)] + rate[(j, i)])
        });
        let weight = 0.25 * jacobian / 6.0;
        for (force, gradient) in response.forces.iter_mut().zip(&current) {
            *force -= (stress * gradient) * weight;
        }
        response.stress += stress * 0.25;
        response.least_jacobian = response.least_jacobian.min(jacobian);
    }
    response
}

/// Gradients of the shape functions at the four points along the natural coordinates.
fn point_gradients() -> [Gradients; 4] {
    [0, 1, 2, 3].map(|point| {
        natural_gradients(std::array::from_fn(|i| if i == point { NEAR } else { FAR }))
    })
}

/// Gradients along the volume coordinates 1, 2 and 3 where these are `l`; the first is what is
/// left of 1.
fn natural_gradients(l: [f64; 4]) -> Gradients {
    let along = [Vec3::new(-1.0, -1.0, -1.0), Vec3::x(), Vec3::y(), Vec3::z()];
    std::array::from_fn(|node| match node.checked_sub(4) {
        None => along[node] * (4.0 * l[node] - 1.0),
        Some(edge) => {
            let [a, b] = EDGES[edge];
            along[a] * (4.0 * l[b]) + along[b] * (4.0 * l[a])
        }
    })
}

/// Gradients in space, and the determinant of the map from natural coordinates.
fn in_space(natural: &Gradients, nodes: &[Vec3; NODES]) -> (Gradients, f64) {
    let map = gradient(nodes, natural);
    let jacobian = determinant(&map);
    let inverse = inverse(&map, jacobian).transpose();
    (natural.map(|g| inverse * g), jacobian)
}

/// Gradient of a field with values at the nodes.
fn gradient(values: &[Vec3; NODES], gradients: &Gradients) -> Matrix3<f64> {
    let mut sum = Matrix3::zeros();
    for (value, gradient) in values.iter().zip(gradients) {
        for j in 0..3 {
            for i in 0..3 {
                sum[(i, j)] += value[i] * gradient[j];
            }
        }
    }
    sum
}

#[cfg(test)]
mod tests;
