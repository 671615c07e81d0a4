//! The system of a scene of triangles.

use super::{
    facing::{self, Side},
    system::{ElementMatrices, Part, System},
};
use crate::{
    TOLERANCE,
    contact::PairTable,
    mechanics::{
        Vec2,
        triangle::{
            Elasticity, ReferenceShape, StressLaw, cauchy_stress, double_area, nodal_forces,
        },
    },
    scene::{
        BondedPairs, CohesiveModel, Condition, ContactSelection, ElementKind, JointKind, Material,
        Scene,
    },
    simulation::stress_law,
};
use nalgebra::{Matrix2, Vector2};
use std::collections::HashSet;

/// The system of a scene in its present shape.
#[must_use]
pub fn system(scene: &Scene) -> System<2> {
    let mut system = System::new(scene.nodes.len());
    for element in 0..scene.elements.len() {
        if let Some(matrices) = element_matrices(scene, element) {
            system.add_element(element, &scene.elements.corners::<3>(element), &matrices);
        }
        add_mass(&mut system, scene, element);
        add_absorption(&mut system, scene, element);
    }
    hold_nodes(&mut system, scene);
    add_joints(&mut system, scene);
    add_contacts(&mut system, scene);
    system
}

/// Stiffness and viscosity of a triangle in its present shape; none if it resists nothing.
#[must_use]
pub fn element_matrices(scene: &Scene, element: usize) -> Option<ElementMatrices> {
    let material = scene.material_of(element)?;
    let law = match material.kind {
        ElementKind::ElasticTriangle => stress_law(material, scene.conventions.volumetric),
        // in extension the volumetric part is not halved
        ElementKind::SofteningTriangle => StressLaw::NeoHookean(Elasticity {
            lame_lambda: material.lame_lambda,
            shear_modulus: material.shear_modulus,
            viscosity: material.viscosity,
            volumetric_share: 1.0,
        }),
        _ => return None,
    };
    let nodes = scene.elements.corners::<3>(element);
    let reference = ReferenceShape::new(&nodes.map(|n| scene.nodes.initial[n]));
    let corners = nodes.map(|n| scene.nodes.current[n]);
    let size = double_area(&corners).abs().sqrt();
    Some(ElementMatrices::by_differences(size, |u: &[Vec2; 3], v: &[Vec2; 3]| {
        let moved: [Vec2; 3] = std::array::from_fn(|i| corners[i] + u[i]);
        nodal_forces(&cauchy_stress(&law, &reference, &moved, v), &moved)
    }))
}

/// Mass that a triangle gives each of its corners, kg.
#[must_use]
pub fn nodal_mass(scene: &Scene, element: usize, material: &Material) -> f64 {
    let corners = scene.elements.corners::<3>(element).map(|n| scene.nodes.initial[n]);
    ReferenceShape::new(&corners).nodal_mass(material.density)
}

fn add_mass(system: &mut System<2>, scene: &Scene, element: usize) {
    let Some(material) = scene.material_of(element) else { return };
    // rigid triangles have three free nodes here, which makes the bound shorter, not longer
    let has_mass = matches!(
        material.kind,
        ElementKind::ElasticTriangle | ElementKind::SofteningTriangle | ElementKind::RigidTriangle
    );
    if has_mass {
        let mass = nodal_mass(scene, element, material);
        scene.elements.corners::<3>(element).into_iter().for_each(|n| system.mass[n] += mass);
    }
}

/// Edges between absorbing nodes resist like the material beyond (Y-Geo, spec `mechanics.md` 2.3).
fn add_absorption(system: &mut System<2>, scene: &Scene, element: usize) {
    let Some(material) = scene.material_of(element) else { return };
    if material.kind != ElementKind::ElasticTriangle {
        return;
    }
    let (lambda, mu, rho) = (material.lame_lambda, material.shear_modulus, material.density);
    let [pressure, shear] = [(2.0 * mu + lambda) * rho, mu * rho].map(f64::sqrt);
    let nodes = scene.elements.corners::<3>(element);
    for k in 0..3 {
        let ends = [nodes[k], nodes[(k + 1) % 3]];
        let edge = scene.nodes.current[ends[1]] - scene.nodes.current[ends[0]];
        let normal = Vec2::new(edge.y.abs(), edge.x.abs());
        let resistance = Vector2::from_fn(|axis, _| {
            let absorbs = ends.iter().all(|&n| {
                set_of(scene, n)
                    .is_some_and(|s| scene.node_sets[s].conditions[axis] == Condition::Absorbing)
            });
            let along = pressure * normal[axis] + shear * normal[1 - axis];
            if absorbs { along / 2.0 } else { 0.0 }
        });
        if resistance != Vec2::zeros() {
            ends.into_iter().for_each(|n| system.add_dashpot(n, resistance));
        }
    }
}

fn set_of(scene: &Scene, node: usize) -> Option<usize> {
    usize::try_from(scene.nodes.set[node]).ok().filter(|&set| set < scene.node_sets.len())
}

fn hold_nodes(system: &mut System<2>, scene: &Scene) {
    for node in 0..scene.nodes.len() {
        let set = set_of(scene, node).map(|s| &scene.node_sets[s]).filter(|set| set.moves);
        let held = set.map_or([true; 2], |set| {
            set.conditions.map(|c| matches!(c, Condition::Velocity | Condition::Frozen))
        });
        if held == [true; 2] || system.mass[node] <= TOLERANCE {
            system.mass[node] = 0.0;
        } else if let (Some(set), true) = (set, held.contains(&true)) {
            let mask = Matrix2::from_diagonal(&Vec2::from(held.map(|h| f64::from(u8::from(!h)))));
            system.free[node] = Some(set.axes * mask * set.inverse_axes());
        }
    }
}

fn add_joints(system: &mut System<2>, scene: &Scene) {
    let cohesive = || scene.cohesive_laws.iter().filter(|law| law.is_cohesive);
    // every joint set acts on every joint of the classic dialect
    let all: f64 = cohesive().map(|law| law.penalty).sum();
    for element in 0..scene.elements.len() {
        if scene.elements.joint_kind[element] != JointKind::Intact {
            continue;
        }
        let penalty = match scene.conventions.cohesive {
            CohesiveModel::Classic => all,
            _ => scene.law_of(element).filter(|law| law.is_cohesive).map_or(0.0, |law| {
                law.penalty * (law.tensile_strength / law.peak_strength).max(1.0)
            }),
        };
        let [a, b, c, d] = scene.elements.corners::<4>(element);
        // p/h for each area at three points of weight h/6, 2h/3, h/6
        let half = [(a, 0.5), (d, -0.5), (b, 0.5), (c, -0.5)];
        let points: [(&[(usize, f64)], f64); 3] = [
            (&[(a, 1.0), (d, -1.0)], 1.0 / 6.0),
            (&half, 2.0 / 3.0),
            (&[(b, 1.0), (c, -1.0)], 1.0 / 6.0),
        ];
        for (nodes, weight) in points {
            let stiffness = penalty * weight;
            system.add_tie(Part::Joint(element), nodes, Vec2::x(), [stiffness; 2]);
        }
    }
}

fn add_contacts(system: &mut System<2>, scene: &Scene) {
    let Some(settings) = &scene.contact else { return };
    let table = PairTable::new(&scene.materials, &settings.pairs);
    let sides = free_sides(scene);
    let bonded = bonded_pairs(scene);
    let mut faced = vec![false; sides.len()];
    for pair in facing::pairs(&sides) {
        let [a, b] = pair.sides.map(|s| &sides[s]);
        if bonded.contains(&[a.element.min(b.element), a.element.max(b.element)]) {
            faced[pair.sides[0]] = true;
            faced[pair.sides[1]] = true;
            continue;
        }
        let [p, q] = [a, b].map(|side| scene.elements.property[side.element]);
        let Some(rank) = table.rank(p, q) else { continue };
        let properties = table.properties(rank);
        pair.sides.iter().for_each(|&s| faced[s] = true);
        let part = Part::Contact([a.element, b.element]);
        // the potential of a triangle rises from 0 at an edge to 3 at the opposite corner
        let per_length = 3.0 * properties.penalty * (1.0 / a.height + 1.0 / b.height);
        for (length, along) in &pair.points {
            let nodes = pair.nodes(&sides, along);
            system.add_tie(part, &nodes, a.normal, [per_length * length, 0.0]);
        }
        if properties.friction > 0.0 {
            let tangential =
                properties.tangential_penalty * (a.length * a.length + b.length * b.length);
            let nodes = pair.nodes(&sides, &pair.middle);
            system.add_tie(part, &nodes, a.normal, [0.0, tangential]);
        }
    }
    for (side, faced) in sides.iter().zip(faced) {
        let property = scene.elements.property[side.element];
        let penalty = table.largest_penalty(property);
        if faced || penalty <= 0.0 {
            continue;
        }
        // its mirror image moves against it
        let stiffness = 2.0 * 3.0 * penalty * 2.0 / side.height * side.length;
        for (share, s) in facing::GAUSS.map(|s| (0.5, s)) {
            let nodes = [(side.nodes[0], 1.0 - s), (side.nodes[1], s)];
            let part = Part::Impact(side.element);
            system.add_tie(part, &nodes, side.normal, [stiffness * share, 0.0]);
        }
    }
}

/// Pairs that contact leaves out because a joint holds them together (classic).
fn bonded_pairs(scene: &Scene) -> HashSet<[usize; 2]> {
    if scene.conventions.bonded != BondedPairs::Excluded {
        return HashSet::new();
    }
    let joints = scene.elements.sides.iter().zip(&scene.elements.joint_kind);
    let intact = joints.filter(|(_, kind)| **kind == JointKind::Intact);
    let pairs = intact.filter_map(|(&[a, b], _)| {
        let (a, b) = (usize::try_from(a).ok()?, usize::try_from(b).ok()?);
        Some([a.min(b), a.max(b)])
    });
    pairs.collect()
}

/// Edges of triangles that take part in contact and that no other triangle shares.
fn free_sides(scene: &Scene) -> Vec<Side> {
    let mut sides = Vec::new();
    for element in 0..scene.elements.len() {
        let Some(material) = scene.material_of(element) else { continue };
        if !material.kind.takes_part_in_contact() || !takes_part(scene, element) {
            continue;
        }
        let nodes = scene.elements.corners::<3>(element);
        let corners = nodes.map(|n| scene.nodes.current[n]);
        let area = double_area(&corners).abs();
        for k in 0..3 {
            let ends = [nodes[k], nodes[(k + 1) % 3]];
            let places = ends.map(|n| scene.nodes.current[n]);
            let edge = places[1] - places[0];
            let length = edge.norm();
            let normal = Vec2::new(edge.y, -edge.x) / length;
            let height = area / length;
            sides.push(Side { element, nodes: ends, places, normal, length, height });
        }
    }
    facing::without_shared(sides)
}

fn takes_part(scene: &Scene, element: usize) -> bool {
    let flags = scene.elements.corners::<3>(element).map(|n| scene.nodes.boundary_flag[n]);
    let selection = scene.conventions.selection;
    // detection gives triangles with a node flagged 1 a tag
    let gets_tag = selection != ContactSelection::Flagged && flags.contains(&1);
    gets_tag || selection.selects(scene.elements.contact_tag[element], flags.into_iter())
}
