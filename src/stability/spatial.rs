//! The system of a scene of tetrahedra.

use super::{
    facing3::{self, Face},
    system::{ElementMatrices, Part, System},
};
use crate::{
    TOLERANCE,
    contact::PairTable,
    mechanics::{
        Vec3, joint3,
        tetrahedron::{ReferenceShape, SolidLaw, cauchy_stress, nodal_forces, sixfold_volume},
        tetrahedron10,
        triangle::Elasticity,
    },
    scene::{
        Condition, ContactSelection, ElementKind, JointKind, Material, PairRule, PressedFaces,
        Scene,
    },
};
use nalgebra::Matrix3;

/// The system of a scene in its present shape.
#[must_use]
pub fn system(scene: &Scene<3>) -> System<3> {
    let mut system = System::new(scene.nodes.len());
    for element in 0..scene.elements.len() {
        let Some(material) = scene.material_of(element) else { continue };
        let Some(matrices) = element_matrices(scene, element) else { continue };
        if material.kind == ElementKind::Tetrahedron {
            let nodes = scene.elements.corners::<4>(element);
            system.add_element(element, &nodes, &matrices);
            let mass = reference(scene, element).nodal_mass(material.density);
            nodes.into_iter().for_each(|n| system.mass[n] += mass);
        } else {
            let nodes = scene.elements.all_nodes(element);
            system.add_element(element, &nodes, &matrices);
            let reference =
                tetrahedron10::ReferenceShape::new(&nodes.map(|n| scene.nodes.initial[n]));
            for (n, mass) in nodes.into_iter().zip(reference.nodal_masses(material.density)) {
                system.mass[n] += mass;
            }
        }
    }
    hold_nodes(&mut system, scene);
    add_joints(&mut system, scene);
    add_contacts(&mut system, scene);
    system
}

fn reference(scene: &Scene<3>, element: usize) -> ReferenceShape {
    ReferenceShape::new(&scene.elements.corners::<4>(element).map(|n| scene.nodes.initial[n]))
}

fn law(scene: &Scene<3>, material: &Material) -> SolidLaw {
    SolidLaw {
        elasticity: Elasticity {
            lame_lambda: material.lame_lambda,
            shear_modulus: material.shear_modulus,
            viscosity: material.viscosity,
            volumetric_share: scene.conventions.volumetric.factor(),
        },
        volumetric: scene.conventions.solid_volumetric,
    }
}

/// Stiffness and viscosity of a tetrahedron in its present shape; none if it resists nothing.
#[must_use]
pub fn element_matrices(scene: &Scene<3>, element: usize) -> Option<ElementMatrices> {
    let material = scene.material_of(element)?;
    let law = law(scene, material);
    let corners = || scene.elements.corners::<4>(element).map(|n| scene.nodes.current[n]);
    match material.kind {
        ElementKind::Tetrahedron => {
            let reference = reference(scene, element);
            let corners = corners();
            let size = sixfold_volume(&corners).abs().cbrt();
            Some(ElementMatrices::by_differences(size, |u: &[Vec3; 4], v: &[Vec3; 4]| {
                let moved: [Vec3; 4] = std::array::from_fn(|i| corners[i] + u[i]);
                nodal_forces(&cauchy_stress(&law, &reference, &moved, v).0, &moved)
            }))
        }
        ElementKind::QuadraticTetrahedron => {
            let nodes = scene.elements.all_nodes(element);
            let reference =
                tetrahedron10::ReferenceShape::new(&nodes.map(|n| scene.nodes.initial[n]));
            let places = nodes.map(|n| scene.nodes.current[n]);
            let size = sixfold_volume(&corners()).abs().cbrt();
            Some(ElementMatrices::by_differences(size, |u: &[Vec3; 10], v: &[Vec3; 10]| {
                let moved: [Vec3; 10] = std::array::from_fn(|i| places[i] + u[i]);
                tetrahedron10::evaluate(&law, &reference, &moved, v).forces
            }))
        }
        _ => None,
    }
}

fn hold_nodes(system: &mut System<3>, scene: &Scene<3>) {
    for node in 0..scene.nodes.len() {
        let set = usize::try_from(scene.nodes.set[node]).ok();
        let set = set.and_then(|set| scene.node_sets.get(set));
        // in space only a prescribed velocity holds
        let held = set.map_or([true; 3], |set| set.conditions.map(|c| c == Condition::Velocity));
        if held == [true; 3] || system.mass[node] < TOLERANCE {
            system.mass[node] = 0.0;
        } else if let (Some(set), true) = (set, held.contains(&true)) {
            let free = Vec3::from(held.map(|h| f64::from(u8::from(!h))));
            let mask = Matrix3::from_diagonal(&free);
            // without a load-time table the global axes count
            system.free[node] = Some(match scene.load_history {
                Some(_) => set.axes * mask * set.inverse_axes(),
                None => mask,
            });
        }
    }
}

fn add_joints(system: &mut System<3>, scene: &Scene<3>) {
    let points = scene.joint_points.points();
    for element in 0..scene.elements.len() {
        if scene.elements.joint_kind[element] != JointKind::Intact {
            continue;
        }
        let law = scene.law_of(element).filter(|law| law.is_cohesive);
        let Some(law) = law else { continue };
        let nodes = scene.elements.corners::<6>(element);
        for spring in joint3::springs(law, &points, &nodes.map(|n| scene.nodes.current[n])) {
            let ends: [(usize, f64); 6] = std::array::from_fn(|i| {
                (nodes[i], if i < 3 { spring.shape[i] } else { -spring.shape[i - 3] })
            });
            system.add_tie(Part::Joint(element), &ends, Vec3::x(), [spring.stiffness; 2]);
        }
    }
}

/// Pressure of the potential by depth: 6 p times 4 of a height, 24 p/h for each area.
const STEEPNESS: f64 = 24.0;

fn add_contacts(system: &mut System<3>, scene: &Scene<3>) {
    let Some(settings) = &scene.contact else { return };
    let table = PairTable::new(&scene.materials, &PairRule::SmallerOfEach);
    let faces = facing3::without_shared(faces(scene));
    let both = settings.spatial.pressed == PressedFaces::Both;
    let mut faced = vec![false; faces.len()];
    for (numbers, points) in facing3::pairs(&faces) {
        let [a, b] = numbers.map(|f| &faces[f]);
        numbers.iter().for_each(|&f| faced[f] = true);
        if !may_touch(scene, a.element, b.element) {
            continue;
        }
        let [p, q] = [a, b].map(|face| scene.elements.property[face.element]);
        let Some(rank) = table.rank(p, q) else { continue };
        let penalty = table.properties(rank).penalty;
        // the face of the higher number is pressed into the other body
        let target = if a.element < b.element { a } else { b };
        let depth = if both { 1.0 / a.height + 1.0 / b.height } else { 1.0 / target.height };
        for point in points {
            let nodes: [(usize, f64); 6] = std::array::from_fn(|i| match i.checked_sub(3) {
                None => (a.nodes[i], point.coordinates[0][i]),
                Some(k) => (b.nodes[k], -point.coordinates[1][k]),
            });
            let stiffness = STEEPNESS * penalty * depth * point.area;
            let part = Part::Contact([a.element, b.element]);
            system.add_tie(part, &nodes, a.normal, [stiffness, 0.0]);
        }
    }
    for (face, faced) in faces.iter().zip(faced) {
        let property = scene.elements.property[face.element];
        let penalty = table.largest_penalty(property);
        if faced || penalty <= 0.0 {
            continue;
        }
        // its mirror image moves against it
        let times = if both { 4.0 } else { 2.0 };
        let stiffness = times * STEEPNESS * penalty * face.area / face.height;
        for k in 0..3 {
            let nodes = [(face.nodes[k], 0.5), (face.nodes[(k + 1) % 3], 0.5)];
            let part = Part::Impact(face.element);
            system.add_tie(part, &nodes, face.normal, [stiffness / 3.0, 0.0]);
        }
    }
}

fn may_touch(scene: &Scene<3>, a: usize, b: usize) -> bool {
    scene.conventions.selection != ContactSelection::Bodies
        || scene.elements.contact_tag[a] != scene.elements.contact_tag[b]
}

/// Faces of tetrahedra that take part in contact.
fn faces(scene: &Scene<3>) -> Vec<Face> {
    let mut faces = Vec::new();
    for element in 0..scene.elements.len() {
        let Some(material) = scene.material_of(element) else { continue };
        if !material.kind.takes_part_in_contact() || !takes_part(scene, element) {
            continue;
        }
        let corners = scene.elements.corners::<4>(element);
        let volume = sixfold_volume(&corners.map(|n| scene.nodes.current[n])).abs() / 6.0;
        for [i, j, k, opposite] in [[0, 1, 2, 3], [1, 3, 2, 0], [2, 3, 0, 1], [3, 1, 0, 2]] {
            let nodes = [i, j, k].map(|c| corners[c]);
            let places = nodes.map(|n| scene.nodes.current[n]);
            let vector = (places[1] - places[0]).cross(&(places[2] - places[0]));
            let inward = scene.nodes.current[corners[opposite]] - places[0];
            let is_outward = vector.dot(&inward) < 0.0;
            let normal = vector.normalize() * if is_outward { 1.0 } else { -1.0 };
            let (nodes, places) = match is_outward {
                true => (nodes, places),
                false => ([nodes[0], nodes[2], nodes[1]], [places[0], places[2], places[1]]),
            };
            let area = 0.5 * vector.norm();
            faces.push(Face { element, nodes, places, normal, area, height: 3.0 * volume / area });
        }
    }
    faces
}

fn takes_part(scene: &Scene<3>, element: usize) -> bool {
    let flags = scene.elements.corners::<4>(element).map(|n| scene.nodes.boundary_flag[n]);
    let selection = scene.conventions.selection;
    // detection gives tetrahedra with a node flagged 1 a tag
    let gets_tag = selection == ContactSelection::Tagged && flags.contains(&1);
    gets_tag || selection.selects(scene.elements.contact_tag[element], flags.into_iter())
}
