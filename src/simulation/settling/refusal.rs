//! Scenes that settling would make nonsense of.

use super::{super::Simulation, SettlingFault, SettlingOptions, Unsettleable, free_nodes::holds};
use crate::scene::{Condition, ElementKind, Scene};

/// Finds out whether settling makes sense.
pub(super) fn check(
    simulation: &Simulation,
    options: SettlingOptions,
) -> Result<(), SettlingFault> {
    if !(options.tolerance > 0.0 && options.tolerance.is_finite()) {
        return Err(SettlingFault::Tolerance(options.tolerance));
    }
    let scene = &simulation.scene;
    check_materials(scene)?;
    let absorbs = |node: &usize| {
        set_of(scene, *node).is_some_and(|s| s.conditions.contains(&Condition::Absorbing))
    };
    if (0..scene.nodes.len()).any(|node| absorbs(&node)) {
        return Err(Unsettleable::AbsorbingBoundaries.into());
    }
    check_velocities(scene)?;
    let held = (0..scene.nodes.len()).any(|node| match set_of(scene, node) {
        Some(set) => !set.moves || set.conditions.into_iter().any(holds),
        None => true,
    });
    if scene.control.gravity != 0.0 && !held {
        return Err(Unsettleable::NothingHeld.into());
    }
    Ok(())
}

fn set_of(scene: &Scene, node: usize) -> Option<&crate::scene::NodeSet<2>> {
    usize::try_from(scene.nodes.set[node]).ok().and_then(|set| scene.node_sets.get(set))
}

fn check_materials(scene: &Scene) -> Result<(), Unsettleable> {
    let mut used = vec![false; scene.materials.len()];
    for &property in &scene.elements.property {
        if let Some(used) = usize::try_from(property).ok().and_then(|p| used.get_mut(p)) {
            *used = true;
        }
    }
    for (material, _) in scene.materials.iter().zip(used).filter(|(_, used)| *used) {
        match material.kind {
            ElementKind::RigidTriangle => return Err(Unsettleable::RigidTriangles),
            ElementKind::SofteningTriangle if material.fractures => {
                return Err(Unsettleable::BreakingTriangles);
            }
            _ if material.is_excavated => return Err(Unsettleable::Excavation),
            _ => {}
        }
    }
    Ok(())
}

/// A velocity that a node set prescribes is held at zero; any other would be lost.
fn check_velocities(scene: &Scene) -> Result<(), Unsettleable> {
    for (node, velocity) in scene.nodes.velocity.iter().enumerate() {
        let prescribed =
            set_of(scene, node).is_some_and(|set| set.conditions == [Condition::Velocity; 2]);
        if !prescribed && (velocity.x != 0.0 || velocity.y != 0.0) {
            return Err(Unsettleable::Moving { node });
        }
    }
    Ok(())
}
