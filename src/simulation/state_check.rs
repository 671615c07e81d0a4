//! Whether a state fits a scene: states come from files, and a step trusts them.

use super::state::{SimulationState, StateFault};
use crate::scene::{CohesiveModel, ContactSum, Elements, JointKind, Scene};

/// Larger numbers of property sets than any deck has.
const MOST_SETS: u32 = 1_000_000_000;
/// Latest step.
pub(super) const LAST_STEP: u64 = i64::MAX as u64;

pub(super) fn check(state: &SimulationState, scene: &Scene) -> Result<(), StateFault> {
    check_nodes(state)?;
    check_elements(state, scene)?;
    check_joints(state, scene)?;
    let is_apart = scene.conventions.contact_sum == ContactSum::Apart;
    let nodes = state.nodes.len();
    require(
        state.contact_force.len() == if is_apart { nodes } else { 0 },
        "it has contact forces of other nodes",
    )?;
    require(state.edge_factors.len() == scene.node_sets.len(), "it has other node sets")?;
    require(
        state.probe_values.len() == scene.probes.len()
            && state.probe_times.len() == scene.probes.len(),
        "it has another number of histories",
    )?;
    require(
        state.contact.is_some() == scene.contact.is_some(),
        "only one of the two knows contact",
    )?;
    require(state.step <= LAST_STEP, "its step is beyond all steps")
}

/// A fault unless the condition holds.
pub(super) fn require(condition: bool, fault: &'static str) -> Result<(), StateFault> {
    if condition { Ok(()) } else { Err(StateFault(fault)) }
}

/// A fault unless elements that are joints have property sets of joints, or none, and all others have
/// those of bodies: some of a step goes by the one, some by the other.
pub(super) fn check_kinds(elements: &Elements, materials: usize) -> Result<(), StateFault> {
    let bodies = 0..i32::try_from(materials).unwrap_or(i32::MAX);
    let mut kinds = elements.property.iter().zip(&elements.joint_kind);
    require(
        kinds.all(|(property, kind)| match kind {
            JointKind::NoJoint => *property < bodies.end,
            _ => !bodies.contains(property),
        }),
        "an element is a joint by its kind and none by its property set, or the other way round",
    )
}

fn check_nodes(state: &SimulationState) -> Result<(), StateFault> {
    let nodes = &state.nodes;
    let lengths = [
        nodes.initial.len(),
        nodes.velocity.len(),
        nodes.boundary_flag.len(),
        nodes.set.len(),
        state.force.len(),
        state.mass.len(),
    ];
    require(lengths.iter().all(|&len| len == nodes.len()), "values of nodes are missing")?;
    require(i32::try_from(nodes.len()).is_ok(), "it has too many nodes")
}

fn check_elements(state: &SimulationState, scene: &Scene) -> Result<(), StateFault> {
    let elements = &state.elements;
    let len = elements.len();
    let lengths = [
        elements.nodes.len(),
        elements.joint_kind.len(),
        elements.fracture.len(),
        elements.sides.len(),
        elements.contact_tag.len(),
        state.strength.len(),
    ];
    require(
        lengths.iter().all(|&l| l == len)
            && state.stress.len() == elements.stressed()
            && elements.state.iter().all(|row| row.len() == len),
        "values of elements are missing",
    )?;
    require(
        elements.state.len() == scene.elements.state.len()
            && elements.table_rows == scene.elements.table_rows,
        "its elements have other values",
    )?;
    require(i32::try_from(len).is_ok(), "it has too many elements")?;
    let is_node = |&n: &i32| usize::try_from(n).is_ok_and(|n| n < state.nodes.len());
    for (corners, kind) in elements.nodes.iter().zip(&elements.joint_kind) {
        let needed = if *kind == JointKind::NoJoint { 3 } else { 4 };
        require(corners[..needed].iter().all(is_node), "an element has a node that is not there")?;
        let others = &corners[needed..];
        require(
            others.iter().all(|n| *n < 0 || is_node(n)),
            "an element has a node that is not there",
        )?;
    }
    require(
        elements.property.iter().all(|p| p.unsigned_abs() < MOST_SETS),
        "an element has a property set that is not there",
    )?;
    check_kinds(elements, scene.materials.len())?;
    let is_element = |&e: &i32| e == -1 || usize::try_from(e).is_ok_and(|e| e < len);
    require(elements.sides.as_flattened().iter().all(is_element), "a joint has no sides")
}

fn check_joints(state: &SimulationState, scene: &Scene) -> Result<(), StateFault> {
    let len = state.elements.len();
    let is_failure = |element: usize, law: usize| element < len && law < scene.cohesive_laws.len();
    require(
        state.failures.iter().all(|f| is_failure(f.element, f.law)),
        "a joint has failed that is not there",
    )?;
    require(state.yielded_now.iter().all(|&e| e < len), "a joint yields that is not there")?;
    let records = scene.conventions.cohesive == CohesiveModel::YGeo;
    require(
        state.joint_records.len() == if records { len } else { 0 },
        "records of joints are missing",
    )?;
    if scene.conventions.cohesive == CohesiveModel::Classic {
        let is_joint = |kind: &JointKind| *kind != JointKind::NoJoint;
        let first = state.elements.joint_kind.iter().position(is_joint).unwrap_or(len);
        return require(state.classic.fits(len, first), "values of joints are missing");
    }
    Ok(())
}
