//! How long a time step may be in space: what `stability` finds in the plane, with the springs of
//! joints and contacts bounded from above node by node.

use super::{
    mesh::{Place, cross, difference, dot},
    model::SpatialModel,
};
use crate::meshing::{TimeStepBounds, property_sets::PropertySets};

/// Enough for a bound of which three quarters are used.
const ITERATIONS: usize = 200;

/// A tetrahedron as small strains see it.
struct Stiff {
    nodes: [usize; 4],
    /// Gradients of the four shape functions.
    gradient: [Place; 4],
    volume: f64,
    lambda: f64,
    mu: f64,
    viscosity: f64,
}

/// The bounds of a model.
pub(super) fn bounds(model: &SpatialModel, sets: &PropertySets) -> TimeStepBounds {
    let mesh = &model.mesh;
    let mut mass = vec![0.0; mesh.nodes.len()];
    let mut spring = vec![0.0; mesh.nodes.len()];
    let mut parts = Vec::with_capacity(mesh.tetrahedra.len());
    let mut wave_s = f64::INFINITY;
    let faces = mesh.faces();
    for (index, tetrahedron) in mesh.tetrahedra.iter().enumerate() {
        let set = &sets.sets[sets.of_triangle[index]];
        let material = set.material;
        let bonded = model.bonded(tetrahedron.material);
        let nodes = if bonded {
            let first = mass.len();
            mass.extend([0.0; 4]);
            spring.extend([0.0; 4]);
            [first, first + 1, first + 2, first + 3]
        } else {
            tetrahedron.nodes
        };
        let volume = mesh.volume(tetrahedron);
        nodes.iter().for_each(|&node| mass[node] += material.density_kg_m3 * volume / 4.0);
        for face in tetrahedron.faces() {
            let mut key = face;
            key.sort_unstable();
            let is_outer = faces.get(&key).is_none_or(|sides| sides.len() == 1);
            let area = mesh.face_area(face);
            let mut stiffness = 0.0;
            if bonded || is_outer {
                // both faces pressed: twice 6 p 4 A/H with the height H = 3 V/A
                stiffness += 48.0 * material.penalty_pa * area * area / (3.0 * volume);
            }
            if let Some(joints) = model.joints.as_ref().filter(|_| bonded && !is_outer) {
                // 2 f/o_p = p/h with the mean edge h
                let stiff = joints.inside.penalty_pa.max(joints.mortar.penalty_pa);
                stiffness += stiff * area / area.sqrt();
            }
            for corner in face {
                if let Some(k) = tetrahedron.nodes.iter().position(|&node| node == corner) {
                    spring[nodes[k]] += stiffness / 3.0;
                }
            }
        }
        let modulus = material.lambda() + 2.0 * material.mu();
        wave_s = wave_s.min(mesh.height(tetrahedron) / (modulus / material.density_kg_m3).sqrt());
        let gradient = gradients(mesh.corners(tetrahedron), volume);
        let (lambda, mu) = (material.lambda(), material.mu());
        parts.push(Stiff { nodes, gradient, volume, lambda, mu, viscosity: set.viscosity_pa_s });
    }
    let elastic = largest(&parts, &mass, |t| [t.lambda, t.mu]);
    let damping = largest(&parts, &mass, |t| [0.0, t.viscosity / 2.0]);
    // a node and the one that faces it move against each other at most
    let springs = spring.iter().zip(&mass).filter(|(_, m)| **m > 0.0);
    let stiffness = elastic + springs.map(|(k, m)| 2.0 * k / m).fold(0.0, f64::max);
    TimeStepBounds::from_modes(wave_s, stiffness, damping)
}

fn gradients(c: [Place; 4], volume: f64) -> [Place; 4] {
    [0, 1, 2, 3].map(|k| {
        let [p, q, r] = [[1, 2, 3], [0, 3, 2], [0, 1, 3], [0, 2, 1]][k];
        let normal = cross(difference(c[p], c[q]), difference(c[p], c[r]));
        let sign = dot(normal, difference(c[p], c[k])).signum();
        normal.map(|n| sign * n / (6.0 * volume))
    })
}

/// The largest eigenvalue of the forces of some moduli by masses.
fn largest(parts: &[Stiff], mass: &[f64], moduli: impl Fn(&Stiff) -> [f64; 2]) -> f64 {
    // any start will do that has a part of every mode, and the same one each time
    let mut state = 0x2545_F491_4F6C_DD1D_u64;
    let mut random = || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
    };
    let mut u: Vec<Place> = mass.iter().map(|_| [random(), random(), random()]).collect();
    let mut f = vec![[0.0; 3]; u.len()];
    let mut value = 0.0;
    for _ in 0..ITERATIONS {
        f.fill([0.0; 3]);
        for part in parts {
            part.add(&u, &mut f, moduli(part));
        }
        let (mut above, mut below, mut size) = (0.0, 0.0, 0.0_f64);
        for ((u, f), &mass) in u.iter_mut().zip(&f).zip(mass) {
            if mass <= 0.0 {
                continue;
            }
            above += dot(*u, *f);
            below += mass * dot(*u, *u);
            *u = f.map(|f| f / mass);
            size = u.iter().fold(size, |size, u| size.max(u.abs()));
        }
        if below <= 0.0 || size <= 0.0 {
            return value;
        }
        value = above / below;
        u.iter_mut().flatten().for_each(|u| *u /= size);
    }
    value
}

impl Stiff {
    /// Adds forces, signed so that they point along the displacements that cause them.
    fn add(&self, u: &[Place], f: &mut [Place], [lambda, mu]: [f64; 2]) {
        let mut h = [[0.0; 3]; 3];
        for (&node, g) in self.nodes.iter().zip(&self.gradient) {
            for i in 0..3 {
                for j in 0..3 {
                    h[i][j] += u[node][i] * g[j];
                }
            }
        }
        let volume = lambda * (h[0][0] + h[1][1] + h[2][2]);
        for (&node, g) in self.nodes.iter().zip(&self.gradient) {
            for i in 0..3 {
                let shear: f64 = (0..3).map(|j| mu * (h[i][j] + h[j][i]) * g[j]).sum();
                f[node][i] += self.volume * (shear + volume * g[i]);
            }
        }
    }
}
