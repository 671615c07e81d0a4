//! States that make no sense any more: what is wrong, and where.

use super::{Simulation, audit::overlap_potential, spatial::SpatialSimulation};
use crate::{
    mechanics::triangle::double_area,
    scene::{ElementKind, Material, Scene},
};
use nalgebra::SVector;
use std::fmt;

/// What is wrong with a state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Wrong {
    /// A velocity or a place is no number.
    NotANumber,
    /// An element has turned inside out.
    TurnedOver,
    /// A node is faster than this times the speed of waves in the stiffest material.
    Runaway {
        /// m/s
        speed: f64,
        /// m/s
        wave_speed: f64,
    },
    /// The balance of energies is off by this share of the largest energy.
    Energy(f64),
}

/// Where a state is wrong.
#[derive(Debug, Clone, PartialEq)]
pub struct Trouble {
    /// What is wrong.
    pub wrong: Wrong,
    /// The node, where it is one.
    pub node: Option<usize>,
    /// The element, or one of those around the node.
    pub element: Option<usize>,
    /// An element that overlaps with it.
    pub in_contact_with: Option<usize>,
    /// Where that is, m.
    pub place: Vec<f64>,
}

impl fmt::Display for Trouble {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match (self.wrong, self.node) {
            (Wrong::NotANumber, Some(node)) => write!(f, "the motion of node {node} is no number")?,
            (Wrong::NotANumber, None) => write!(f, "the motion is no number")?,
            (Wrong::TurnedOver, _) => write!(f, "an element has turned inside out")?,
            (Wrong::Energy(error), _) => {
                let percent = 100.0 * error;
                write!(f, "the balance of energies is off by ")?;
                match percent {
                    ..0.1 => write!(f, "{percent:.1e} %")?,
                    _ => write!(f, "{percent:.1} %")?,
                }
            }
            (Wrong::Runaway { speed, wave_speed }, node) => {
                let node = node.map_or_else(String::new, |node| format!("node {node} "));
                write!(
                    f,
                    "{node}moves with {speed:.3e} m/s, {:.0} times as fast as waves",
                    speed / wave_speed
                )?;
            }
        }
        if let Some(element) = self.element {
            write!(f, ", element {element}")?;
        }
        if let Some(other) = self.in_contact_with {
            write!(f, " in contact with element {other}")?;
        }
        if !self.place.is_empty() {
            let place: Vec<String> = self.place.iter().map(|x| format!("{x:.6}")).collect();
            write!(f, ", at ({})", place.join(", "))?;
        }
        Ok(())
    }
}

/// Speed of nodes by that of waves beyond which nothing is right any more.
const RUNAWAY: f64 = 10.0;

impl Simulation {
    /// What is wrong with the present state, if anything is.
    #[must_use]
    pub fn trouble(&self) -> Option<Trouble> {
        let nodes = &self.scene.nodes;
        let found = wrong_motion(&nodes.velocity, &nodes.current, &self.scene.materials);
        if let Some((wrong, node)) = found {
            return Some(self.around(wrong, Some(node), None));
        }
        self.turned_over().map(|element| self.around(Wrong::TurnedOver, None, Some(element)))
    }

    /// The first triangle that has turned over though its undeformed shape has not.
    fn turned_over(&self) -> Option<usize> {
        let Scene { nodes, elements, .. } = &self.scene;
        let is_triangle = |&element: &usize| {
            self.scene.material_of(element).is_some_and(|m| {
                matches!(m.kind, ElementKind::ElasticTriangle | ElementKind::SofteningTriangle)
            })
        };
        let has_turned_over = |&element: &usize| {
            let corners = elements.corners::<3>(element);
            double_area(&corners.map(|n| nodes.current[n])) <= 0.0
                && double_area(&corners.map(|n| nodes.initial[n])) > 0.0
        };
        (0..elements.len()).filter(is_triangle).find(has_turned_over)
    }

    fn around(&self, wrong: Wrong, node: Option<usize>, element: Option<usize>) -> Trouble {
        let element = element.or_else(|| element_of(&self.scene, node?, 3));
        let place = |n: usize| self.scene.nodes.current[n];
        let corners = |e: usize| self.scene.elements.corners::<3>(e).map(place);
        let in_contact_with = element.and_then(|element| {
            let couples = self.contact.as_ref()?.couples();
            let others = couples.into_iter().filter_map(|(couple, _)| {
                let [a, b] = couple.map(|e| e as usize);
                (a == element).then_some(b).or((b == element).then_some(a))
            });
            let overlap = |other: &usize| overlap_potential(&corners(element), &corners(*other));
            others.filter(|other| overlap(other) > 0.0).min()
        });
        let place = centre(&self.scene, node, element, 3);
        Trouble { wrong, node, element, in_contact_with, place }
    }
}

impl SpatialSimulation {
    /// What is wrong with the present state, if anything is.
    #[must_use]
    pub fn trouble(&self) -> Option<Trouble> {
        let scene = self.scene();
        let nodes = &scene.nodes;
        let found = wrong_motion(&nodes.velocity, &nodes.current, &scene.materials);
        let (wrong, node, element) = match found {
            Some((wrong, node)) => (wrong, Some(node), element_of(scene, node, 4)),
            None => (Wrong::TurnedOver, None, Some(self.first_inversion()?.1)),
        };
        let place = centre(scene, node, element, 4);
        Some(Trouble { wrong, node, element, in_contact_with: None, place })
    }
}

/// A node whose motion makes no sense.
fn wrong_motion<const D: usize>(
    velocities: &[SVector<f64, D>],
    places: &[SVector<f64, D>],
    materials: &[Material],
) -> Option<(Wrong, usize)> {
    let mut fastest = 0.0;
    let mut sum = 0.0;
    for velocity in velocities {
        let squared = velocity.norm_squared();
        sum += squared;
        fastest = if squared > fastest { squared } else { fastest };
    }
    // what is no number makes the sum none, too
    if !f64::is_finite(sum) {
        let is_wrong = |n: &usize| {
            let numbers = velocities[*n].iter().chain(places[*n].iter());
            !numbers.copied().all(f64::is_finite) || !velocities[*n].norm_squared().is_finite()
        };
        let node = (0..velocities.len()).find(is_wrong)?;
        return Some((Wrong::NotANumber, node));
    }
    let wave_speed = materials.iter().map(wave_speed).fold(0.0, f64::max);
    let limit = RUNAWAY * wave_speed;
    if wave_speed > 0.0 && fastest > limit * limit {
        let node = velocities.iter().position(|v| v.norm_squared() == fastest)?;
        let speed = fastest.sqrt();
        return Some((Wrong::Runaway { speed, wave_speed }, node));
    }
    None
}

/// Speed of pressure waves, m/s; 0 for what has no stiffness.
fn wave_speed(material: &Material) -> f64 {
    let deforms = !matches!(material.kind, ElementKind::RigidTriangle | ElementKind::Inert(_));
    let modulus = match material.elastic_law {
        crate::scene::ElasticLaw::NeoHookean => material.lame_lambda + 2.0 * material.shear_modulus,
        crate::scene::ElasticLaw::PlaneStress(law) | crate::scene::ElasticLaw::PlaneStrain(law) => {
            2.0 * law.young
        }
        crate::scene::ElasticLaw::Transverse(law) => 2.0 * law.young[0].max(law.young[1]),
    };
    if deforms && material.density > 0.0 { (modulus / material.density).sqrt() } else { 0.0 }
}

/// The first element with a node.
fn element_of<const D: usize>(scene: &Scene<D>, node: usize, corners: usize) -> Option<usize> {
    (0..scene.elements.len()).find(|&e| {
        scene.material_of(e).is_some()
            && scene.elements.nodes[e][..corners].contains(&(node as i32))
    })
}

/// Place of a node, or mean place of an element's corners, as far as they are numbers.
fn centre<const D: usize>(
    scene: &Scene<D>,
    node: Option<usize>,
    element: Option<usize>,
    corners: usize,
) -> Vec<f64> {
    let nodes: Vec<usize> = match (node, element) {
        (Some(node), _) => vec![node],
        (None, Some(element)) => {
            let nodes = &scene.elements.nodes[element][..corners];
            nodes.iter().filter_map(|&n| usize::try_from(n).ok()).collect()
        }
        (None, None) => return Vec::new(),
    };
    // where the motion is no number the undeformed place is
    let place = |n: usize| {
        let current = scene.nodes.current[n];
        if current.iter().all(|x| x.is_finite()) { current } else { scene.nodes.initial[n] }
    };
    let sum: SVector<f64, D> = nodes.iter().map(|&n| place(n)).sum();
    (sum / nodes.len().max(1) as f64).iter().copied().collect()
}
