//! Which elements a d3plot file shows, and as which material.

use crate::{
    scene::{JointKind, Scene},
    simulation::Simulation,
};

/// Elements of a d3plot family: chosen at the first output, kept to the end.
///
/// Triangles, live joints and joints that have failed already; closed edges
/// and elements without property have no record. (The original leaves joints
/// that fail before the first output out of the list but not out of the
/// states, which shifts every later value of the file: spec `y2d3d.md` I.26.)
#[must_use]
pub fn shown_elements<const D: usize>(scene: &Scene<D>) -> Vec<usize> {
    (0..scene.elements.len())
        .filter(|&e| match scene.elements.joint_kind[e] {
            JointKind::NoJoint => scene.elements.property[e] >= 0,
            kind => kind != JointKind::FreeEdge,
        })
        .collect()
}

/// Whether an element is a joint: it has more nodes than bodies.
#[must_use]
pub fn is_joint<const D: usize>(scene: &Scene<D>, element: usize) -> bool {
    scene.elements.nodes[element][D + 1] >= 0
}

/// Material number of an element as d3plot files count them, from 1; 0 for a
/// broken joint. A joint belongs to the first material of the first table row
/// that names its joint set.
#[must_use]
pub fn material_number<const D: usize>(scene: &Scene<D>, element: usize) -> i32 {
    let property = scene.elements.property[element];
    let materials = scene.materials.len() as i32;
    if property < 0 || scene.elements.joint_kind[element].is_fracture() {
        return 0;
    }
    if property < materials {
        return property + 1;
    }
    material_of_joint_set(scene, property - materials)
}

/// Material number of an element for the connectivity, where a joint that has
/// failed already keeps the material of its joint set.
#[must_use]
pub fn original_material_number(simulation: &Simulation, element: usize) -> i32 {
    let scene = simulation.scene();
    if scene.elements.joint_kind[element] == JointKind::Broken {
        let failure = simulation.failures().iter().find(|f| f.element == element);
        return material_of_joint_set(scene, failure.map_or(0, |f| f.law as i32));
    }
    material_number(scene, element)
}

/// Material of the first table row that names a joint set; the number of the set where none does.
#[must_use]
pub fn material_of_joint_set<const D: usize>(scene: &Scene<D>, set: i32) -> i32 {
    let pairs = scene.insertion.iter().flat_map(|insertion| &insertion.pairs);
    let row = pairs.into_iter().find(|pair| pair.joint_set == set);
    row.map_or(set, |pair| pair.materials[0] + 1)
}
