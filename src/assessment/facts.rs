//! Sizes, speeds and moduli of a scene, in the plane or in space.

use crate::{
    TOLERANCE,
    mechanics::{tetrahedron::sixfold_volume, triangle::double_area},
    scene::{CohesiveLaw, Condition, ContactSettings, ElementKind, Material, PairRule, Scene},
    stability::{ElementMatrices, element_matrices, solid_matrices},
};
use nalgebra::SymmetricEigen;
use serde::Serialize;

/// A property set and its smallest element.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SetFacts {
    /// Its number in the deck.
    pub set: usize,
    /// Elements.
    pub elements: usize,
    /// Smallest height of its elements, m.
    pub smallest_height_m: f64,
    /// The element that has it.
    pub smallest_element: usize,
    /// Young's modulus of small strains, Pa.
    pub young_pa: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// D1PEKS, Pa s.
    pub viscosity_pa_s: f64,
    /// 2 h √(E ρ) of the smallest element: critical damping by the manual of Y, Pa s.
    pub critical_viscosity_pa_s: f64,
    /// Viscosity with which each element alone is stable at the time step of the deck, Pa s; 0 if
    /// its stiffness alone is not. More may be stable where neighbours are larger.
    pub safe_viscosity_pa_s: f64,
    /// Contact penalty, Pa.
    pub penalty_pa: f64,
}

/// What the judges look at.
#[derive(Debug, Clone)]
pub struct Facts {
    /// Number of dimensions.
    pub dimension: usize,
    /// s
    pub time_step_s: f64,
    /// Steps of the first stage.
    pub steps: u64,
    /// Steps between two states.
    pub output_interval: u64,
    /// Property sets that have elements which deform.
    pub sets: Vec<SetFacts>,
    /// Cohesive laws that have joints, with the longest one, m.
    pub joints: Vec<(usize, CohesiveLaw, f64)>,
    /// Contact settings.
    pub contact: Option<ContactSettings>,
    /// Largest speed at the start, prescribed ones among them, m/s.
    pub speed_m_s: f64,
    /// Largest distance between coordinates, and largest coordinate, m.
    pub extent_m: [f64; 2],
    /// Whether gravity acts.
    pub has_gravity: bool,
    /// Node sets whose load is not 0 in the first step: number and kind.
    pub sudden: Vec<(usize, Sudden)>,
    /// Mean place of each element, m.
    centres: Vec<[f64; 3]>,
}

/// A load that starts at once.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sudden {
    /// Force on nodes, or acceleration.
    Force,
    /// Pressure or traction on edges.
    Pressure,
    /// Velocity that the nodes do not have, m/s.
    Velocity(f64),
}

impl Facts {
    /// Those of a scene of triangles.
    #[must_use]
    pub fn of_plane(scene: &Scene) -> Self {
        let shape = |e: usize| {
            let corners = scene.elements.corners::<3>(e).map(|n| scene.nodes.current[n]);
            let longest =
                (0..3).map(|k| (corners[(k + 1) % 3] - corners[k]).norm()).fold(0.0, f64::max);
            let area = double_area(&corners).abs();
            Shape { height: area / longest, content: 0.5 * area, corners: 3 }
        };
        let length = |e: usize| {
            let [a, b, ..] = scene.elements.corners::<4>(e).map(|n| scene.nodes.current[n]);
            (b - a).norm()
        };
        Self::of(scene, shape, |e| element_matrices(scene, e), length)
    }

    /// Those of a scene of tetrahedra.
    #[must_use]
    pub fn of_space(scene: &Scene<3>) -> Self {
        let shape = |e: usize| {
            let c = scene.elements.corners::<4>(e).map(|n| scene.nodes.current[n]);
            let volume = sixfold_volume(&c).abs() / 6.0;
            let area = |[i, j, k]: [usize; 3]| 0.5 * (c[j] - c[i]).cross(&(c[k] - c[i])).norm();
            let largest = [[0, 1, 2], [1, 3, 2], [2, 3, 0], [3, 1, 0]].map(area);
            let largest = largest.into_iter().fold(0.0, f64::max);
            Shape { height: 3.0 * volume / largest, content: volume, corners: 4 }
        };
        let length = |e: usize| {
            let [a, b, ..] = scene.elements.corners::<6>(e).map(|n| scene.nodes.current[n]);
            (b - a).norm()
        };
        Self::of(scene, shape, |e| solid_matrices(scene, e), length)
    }

    fn of<const D: usize>(
        scene: &Scene<D>,
        shape: impl Fn(usize) -> Shape,
        matrices: impl Fn(usize) -> Option<ElementMatrices>,
        length: impl Fn(usize) -> f64,
    ) -> Self {
        let control = &scene.control;
        let dt = control.time_step;
        let mut sets: Vec<Option<SetFacts>> = vec![None; scene.materials.len()];
        let mut centres = Vec::with_capacity(scene.elements.len());
        let mut longest = vec![0.0; scene.cohesive_laws.len()];
        for e in 0..scene.elements.len() {
            centres.push(centre(scene, e));
            let Some(material) = scene.material_of(e) else {
                let law = scene.elements.property[e] - scene.materials.len() as i32;
                if let Some(longest) = usize::try_from(law).ok().and_then(|l| longest.get_mut(l)) {
                    *longest = length(e).max(*longest);
                }
                continue;
            };
            let Some(matrices) = matrices(e) else { continue };
            let shape = shape(e);
            let set = scene.elements.property[e] as usize;
            let facts = sets[set].get_or_insert_with(|| SetFacts::of(set, material, scene));
            facts.add(e, &shape, &matrices, material, dt);
        }
        let sets: Vec<SetFacts> = sets.into_iter().flatten().collect();
        let joints = scene.cohesive_laws.iter().enumerate().zip(longest);
        let joints = joints
            .filter(|((_, law), longest)| law.is_cohesive && *longest > 0.0)
            .map(|((number, law), longest)| (number, law.clone(), longest))
            .collect();
        let places = &scene.nodes.current;
        let largest = places.iter().map(|p| p.amax()).fold(0.0, f64::max);
        let extent = |k: usize| {
            let (low, high) = places
                .iter()
                .fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), p| (l.min(p[k]), h.max(p[k])));
            high - low
        };
        let (sudden, prescribed) = sudden_loads(scene);
        let moving = scene.nodes.velocity.iter().map(|v| v.norm()).fold(prescribed, f64::max);
        let axes = if D == 2 { 1..2 } else { 0..3 };
        Self {
            dimension: D,
            time_step_s: dt,
            steps: control.end_step.saturating_sub(control.first_step),
            output_interval: control.output_interval,
            sets,
            joints,
            contact: scene.contact.clone(),
            speed_m_s: moving,
            extent_m: [(0..D).map(extent).fold(0.0, f64::max), largest],
            has_gravity: control.gravity[axes].iter().any(|g| *g != 0.0),
            sudden,
            centres,
        }
    }

    /// Mean place of an element, m.
    #[must_use]
    pub fn place_of(&self, element: usize) -> Option<Vec<f64>> {
        self.centres.get(element).map(|place| place[..self.dimension].to_vec())
    }

    /// The smallest height of all elements, m.
    #[must_use]
    pub fn smallest_height(&self) -> f64 {
        self.sets.iter().map(|set| set.smallest_height_m).fold(f64::INFINITY, f64::min)
    }

    /// Whether pairs of materials have contact properties of their own.
    #[must_use]
    pub fn has_pair_table(&self) -> bool {
        self.contact.as_ref().is_some_and(|c| matches!(c.pairs, PairRule::Table(_)))
    }
}

struct Shape {
    height: f64,
    content: f64,
    corners: usize,
}

impl SetFacts {
    fn of<const D: usize>(set: usize, material: &Material, scene: &Scene<D>) -> Self {
        // what the original's law does with λ: the classic dialect and Y-Geo take it twice
        let doubled = 2.0 * scene.conventions.volumetric.factor();
        let is_lame = !matches!(
            material.elastic_law,
            crate::scene::ElasticLaw::PlaneStress(_)
                | crate::scene::ElasticLaw::PlaneStrain(_)
                | crate::scene::ElasticLaw::Transverse(_)
        );
        let (lambda, mu) = (material.lame_lambda * doubled, material.shear_modulus);
        let young = match material.elastic_law {
            crate::scene::ElasticLaw::PlaneStress(law)
            | crate::scene::ElasticLaw::PlaneStrain(law) => law.young,
            crate::scene::ElasticLaw::Transverse(law) => law.young[0].max(law.young[1]),
            _ if is_lame && lambda + mu > 0.0 => mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu),
            _ => 0.0,
        };
        Self {
            set,
            elements: 0,
            smallest_height_m: f64::INFINITY,
            smallest_element: 0,
            young_pa: young,
            density_kg_m3: material.density,
            viscosity_pa_s: material.viscosity,
            critical_viscosity_pa_s: f64::INFINITY,
            safe_viscosity_pa_s: f64::INFINITY,
            penalty_pa: material.contact_penalty,
        }
    }

    fn add(
        &mut self,
        element: usize,
        shape: &Shape,
        matrices: &ElementMatrices,
        material: &Material,
        dt: f64,
    ) {
        self.elements += 1;
        if shape.height < self.smallest_height_m {
            self.smallest_height_m = shape.height;
            self.smallest_element = element;
            self.critical_viscosity_pa_s =
                2.0 * shape.height * (self.young_pa * self.density_kg_m3).sqrt();
        }
        if material.kind == ElementKind::QuadraticTetrahedron {
            // its masses differ from node to node: the scene's limit says more
            return;
        }
        let mass = material.density * shape.content / shape.corners as f64;
        if mass <= TOLERANCE || self.viscosity_pa_s <= 0.0 {
            return;
        }
        let largest = |m: &nalgebra::DMatrix<f64>| SymmetricEigen::new(m.clone()).eigenvalues.max();
        let stiffness = largest(&matrices.stiffness) / mass;
        let damping = largest(&matrices.viscosity) / mass;
        if damping > 0.0 {
            let room = ((4.0 - dt * dt * stiffness) / (2.0 * dt)).max(0.0);
            let safe = self.viscosity_pa_s * room / damping;
            self.safe_viscosity_pa_s = self.safe_viscosity_pa_s.min(safe);
        }
    }
}

fn centre<const D: usize>(scene: &Scene<D>, element: usize) -> [f64; 3] {
    let nodes = scene.elements.nodes[element];
    let corners = nodes.iter().filter_map(|&n| usize::try_from(n).ok());
    let (mut sum, mut count) = ([0.0; 3], 0.0);
    for place in corners.filter_map(|n| scene.nodes.current.get(n)) {
        (0..D).for_each(|k| sum[k] += place[k]);
        count += 1.0;
    }
    sum.map(|s: f64| s / f64::max(count, 1.0))
}

/// Node sets with nodes whose load starts at once, and the largest prescribed speed, m/s.
fn sudden_loads<const D: usize>(scene: &Scene<D>) -> (Vec<(usize, Sudden)>, f64) {
    let (mut sudden, mut fastest) = (Vec::new(), 0.0_f64);
    for (number, set) in scene.node_sets.iter().enumerate() {
        let mut nodes = (0..scene.nodes.len()).filter(|&n| scene.nodes.set[n] == number as i32);
        let Some(first) = nodes.next() else { continue };
        let factor = match &scene.load_history {
            Some(history) if D == 3 => {
                history.factor_within(number, scene.control.start_time).unwrap_or(1.0)
            }
            _ => scene.load_factor(number, scene.control.start_time),
        };
        let amplitude = |kind: Condition| {
            (0..D)
                .filter(|&k| set.conditions[k] == kind)
                .map(|k| set.amplitudes[k].powi(2))
                .sum::<f64>()
                .sqrt()
        };
        let prescribed = amplitude(Condition::Velocity);
        fastest = fastest.max(prescribed);
        if factor == 0.0 {
            continue;
        }
        if amplitude(Condition::Force) + amplitude(Condition::Acceleration) != 0.0 {
            sudden.push((number, Sudden::Force));
        }
        if set.pressure != 0.0 || set.traction != 0.0 {
            sudden.push((number, Sudden::Pressure));
        }
        let jump = (prescribed * factor - scene.nodes.velocity[first].norm()).abs();
        if prescribed > 0.0 && jump > 1e-9 * prescribed {
            sudden.push((number, Sudden::Velocity(jump)));
        }
    }
    if scene.pressure_ramp <= 0.0 && !scene.face_pressures.is_empty() {
        sudden.push((0, Sudden::Pressure));
    }
    (sudden, fastest)
}
