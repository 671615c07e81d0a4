//! How long a time step may be.
//!
//! A step of the program moves a mode of angular frequency ω and damping rate γ (viscous force by
//! mass and velocity) without growth as long as ω² dt² + 2 γ dt ≤ 4. The largest ω² comes from
//! triangles, joints and the contacts of neighbours together, the largest γ from viscosity. Both
//! are found by power iteration on the assembled mesh, with the nodes that it has after joint
//! insertion.

use super::{
    model::Model,
    pattern::{Point, distance},
    property_sets::PropertySets,
};
use std::collections::BTreeMap;

/// Bounds of the time step \[s\].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct TimeStepBounds {
    /// The time that a pressure wave takes across the flattest triangle.
    pub wave_s: f64,
    /// From viscosity alone: 2/γ.
    pub viscosity_s: f64,
    /// From triangles, joints and contact penalties without viscosity: 2/ω.
    pub stiffness_s: f64,
    /// From all of it.
    pub together_s: f64,
}

impl TimeStepBounds {
    /// A time step below the bounds: three quarters of it, rounded down to one digit.
    #[must_use]
    pub fn suggestion_s(&self) -> f64 {
        let most = 0.75 * self.together_s;
        let decade = 10f64.powf(most.log10().floor());
        let digit = (most / decade).floor().max(1.0);
        // through text: 5e-6, not 4.999999999999999e-6
        format!("{digit}e{}", decade.log10().round()).parse().unwrap_or(digit * decade)
    }

    /// The bounds of a model.
    #[must_use]
    pub fn of(model: &Model, sets: &PropertySets) -> Self {
        let network = Network::of(model, sets);
        let stiffness = network.largest(|network, u, f| network.elastic(u, f));
        let damping = network.largest(|network, u, f| network.viscous(u, f));
        let mut wave_s = f64::INFINITY;
        for (triangle, &set) in model.mesh.triangles.iter().zip(&sets.of_triangle) {
            let material = sets.sets[set].material;
            let speed = ((material.lambda() + 2.0 * material.mu()) / material.density_kg_m3).sqrt();
            wave_s = wave_s.min(model.mesh.height(triangle) / speed);
        }
        Self::from_modes(wave_s, stiffness, damping)
    }

    /// Bounds from the largest squared angular frequency and damping rate.
    pub(super) fn from_modes(wave_s: f64, stiffness: f64, damping: f64) -> Self {
        // ω² dt² + 2 γ dt = 4, without cancellation
        let root = (damping * damping + 4.0 * stiffness).sqrt();
        TimeStepBounds {
            wave_s,
            viscosity_s: 2.0 / damping.max(f64::MIN_POSITIVE),
            stiffness_s: 2.0 / stiffness.sqrt().max(f64::MIN_POSITIVE),
            together_s: 4.0 / (damping + root),
        }
    }
}

/// Triangles and springs between nodes.
struct Network {
    mass: Vec<f64>,
    triangles: Vec<Stiff>,
    springs: Vec<Spring>,
}

/// A triangle as small strains see it.
struct Stiff {
    nodes: [usize; 3],
    /// Gradients of the three shape functions.
    gradient: [Point; 3],
    area: f64,
    lambda: f64,
    mu: f64,
    viscosity: f64,
}

/// A joint or contact between two edges: pairs of nodes that face each other.
struct Spring {
    pairs: [[Option<usize>; 2]; 2],
    stiffness: f64,
}

impl Network {
    fn of(model: &Model, sets: &PropertySets) -> Self {
        let mesh = &model.mesh;
        let mut mass = vec![0.0; mesh.nodes.len()];
        let mut triangles = Vec::with_capacity(mesh.triangles.len());
        for (triangle, &set) in mesh.triangles.iter().zip(&sets.of_triangle) {
            let set = &sets.sets[set];
            let nodes = if model.bonded(triangle.material) {
                let first = mass.len();
                mass.extend([0.0; 3]);
                [first, first + 1, first + 2]
            } else {
                triangle.nodes
            };
            let area = mesh.area(triangle);
            let share = set.material.density_kg_m3 * area / 3.0;
            nodes.iter().for_each(|&node| mass[node] += share);
            let c = mesh.corners(triangle);
            let gradient = [0, 1, 2].map(|k| {
                let (a, b) = (c[(k + 1) % 3], c[(k + 2) % 3]);
                [(a[1] - b[1]) / (2.0 * area), (b[0] - a[0]) / (2.0 * area)]
            });
            let (lambda, mu) = (set.material.lambda(), set.material.mu());
            let viscosity = set.viscosity_pa_s;
            triangles.push(Stiff { nodes, gradient, area, lambda, mu, viscosity });
        }
        let springs = springs(model, sets, &triangles);
        Network { mass, triangles, springs }
    }

    /// Elastic forces, signed so that they point along the displacements that cause them.
    fn elastic(&self, u: &[Point], f: &mut [Point]) {
        for t in &self.triangles {
            t.add(u, f, t.lambda, t.mu);
        }
        for spring in &self.springs {
            spring.add(u, f);
        }
    }

    /// Viscous forces: stress is viscosity times strain rate.
    fn viscous(&self, u: &[Point], f: &mut [Point]) {
        for t in &self.triangles {
            t.add(u, f, 0.0, t.viscosity / 2.0);
        }
    }

    /// The largest eigenvalue of forces by masses.
    fn largest(&self, forces: impl Fn(&Network, &[Point], &mut [Point])) -> f64 {
        // any start will do that has a part of every mode, and the same one each time
        let mut state = 0x2545_F491_4F6C_DD1D_u64;
        let mut random = || {
            state ^= state << 13;
            state ^= state >> 7;
            state ^= state << 17;
            (state >> 11) as f64 / (1u64 << 53) as f64 - 0.5
        };
        let mut u: Vec<Point> = self.mass.iter().map(|_| [random(), random()]).collect();
        let mut f = vec![[0.0; 2]; u.len()];
        let mut value = 0.0;
        for _ in 0..ITERATIONS {
            f.fill([0.0; 2]);
            forces(self, &u, &mut f);
            let (mut above, mut below) = (0.0, 0.0);
            let mut size: f64 = 0.0;
            for ((u, f), &mass) in u.iter_mut().zip(&f).zip(&self.mass) {
                if mass <= 0.0 {
                    continue;
                }
                above += u[0] * f[0] + u[1] * f[1];
                below += mass * (u[0] * u[0] + u[1] * u[1]);
                *u = [f[0] / mass, f[1] / mass];
                size = size.max(u[0].abs()).max(u[1].abs());
            }
            if below <= 0.0 || size <= 0.0 {
                return value;
            }
            value = above / below;
            u.iter_mut().flatten().for_each(|u| *u /= size);
        }
        value
    }
}

/// Enough for a bound that is then halved.
const ITERATIONS: usize = 200;

impl Stiff {
    fn add(&self, u: &[Point], f: &mut [Point], lambda: f64, mu: f64) {
        let mut h = [[0.0; 2]; 2];
        for (&node, g) in self.nodes.iter().zip(&self.gradient) {
            for i in 0..2 {
                for j in 0..2 {
                    h[i][j] += u[node][i] * g[j];
                }
            }
        }
        let shear = mu * (h[0][1] + h[1][0]);
        let volume = lambda * (h[0][0] + h[1][1]);
        let s = [[2.0 * mu * h[0][0] + volume, shear], [shear, 2.0 * mu * h[1][1] + volume]];
        for (&node, g) in self.nodes.iter().zip(&self.gradient) {
            for i in 0..2 {
                f[node][i] += self.area * (s[i][0] * g[0] + s[i][1] * g[1]);
            }
        }
    }
}

impl Spring {
    fn add(&self, u: &[Point], f: &mut [Point]) {
        let gap = self.pairs.map(|[a, b]| {
            let [a, b] = [a, b].map(|node| node.map_or([0.0; 2], |n| u[n]));
            [a[0] - b[0], a[1] - b[1]]
        });
        for k in 0..2 {
            for i in 0..2 {
                let force = self.stiffness * (gap[k][i] / 3.0 + gap[1 - k][i] / 6.0);
                let [a, b] = self.pairs[k];
                if let Some(a) = a {
                    f[a][i] += force;
                }
                if let Some(b) = b {
                    f[b][i] -= force;
                }
            }
        }
    }
}

/// Joints, and contacts that neighbours have or edges of bodies may get.
fn springs(model: &Model, sets: &PropertySets, triangles: &[Stiff]) -> Vec<Spring> {
    let mesh = &model.mesh;
    // a contact's stiffness by the edge's length, for one of the two triangles
    let contact = |t: usize, length: f64| {
        let penalty = sets.sets[sets.of_triangle[t]].material.penalty_pa;
        3.0 * penalty * length * length / (2.0 * triangles[t].area)
    };
    let mut open: BTreeMap<[usize; 2], (usize, usize)> = BTreeMap::new();
    let mut springs = Vec::new();
    for (index, triangle) in mesh.triangles.iter().enumerate() {
        for k in 0..3 {
            let (a, b) = (triangle.nodes[k], triangle.nodes[(k + 1) % 3]);
            let Some((other, l)) = open.remove(&[b, a]) else {
                open.insert([a, b], (index, k));
                continue;
            };
            let (here, there) = (&triangles[index].nodes, &triangles[other].nodes);
            let pairs = [
                [Some(here[k]), Some(there[(l + 1) % 3])],
                [Some(here[(k + 1) % 3]), Some(there[l])],
            ];
            if pairs.iter().all(|[a, b]| a == b) {
                continue;
            }
            let length = distance(mesh.nodes[a], mesh.nodes[b]);
            let mut stiffness = contact(index, length) + contact(other, length);
            let [p, q] = [index, other].map(|t| sets.of_triangle[t]);
            if let (Some(set), Some(joints)) = (sets.joint_between(model, p, q), model.joints) {
                let joint =
                    if set == super::property_sets::INSIDE { joints.inside } else { joints.mortar };
                stiffness += joint.penalty_pa;
            }
            springs.push(Spring { pairs, stiffness });
        }
    }
    for ([a, b], (index, k)) in open {
        let length = distance(mesh.nodes[a], mesh.nodes[b]);
        let nodes = &triangles[index].nodes;
        let pairs = [[Some(nodes[k]), None], [Some(nodes[(k + 1) % 3]), None]];
        springs.push(Spring { pairs, stiffness: 2.0 * contact(index, length) });
    }
    springs
}
