//! Scenes that settling would make nonsense of.

use super::{
    super::Simulation, SettlingFault, SettlingOptions, Unsettleable, free_nodes::holds,
    loads::DistributedLoads,
};
use crate::scene::{Condition, ElementKind, NodeSet, Scene};

impl Simulation {
    /// Whether settling makes sense, as far as the scene tells without computing anything.
    ///
    /// # Errors
    /// If it does not, or the tolerance is no number above 0.
    pub fn check_settling(&self, options: SettlingOptions) -> Result<(), SettlingFault> {
        if !(options.tolerance > 0.0 && options.tolerance.is_finite()) {
            return Err(SettlingFault::Tolerance(options.tolerance));
        }
        check_materials(&self.scene)?;
        check_nodes(&self.scene)?;
        let loads_act = self.scene.control.gravity[1] != 0.0
            || DistributedLoads::of(&self.scene).act()
            || self.nodal_loads_act();
        if loads_act { Ok(()) } else { Err(Unsettleable::NoLoad.into()) }
    }

    fn nodal_loads_act(&self) -> bool {
        let loaded = |(index, set): (usize, &NodeSet<2>)| {
            let factor = self.scene.load_factor(index, self.time);
            let along = |k: usize| !holds(set.conditions[k]) && set.amplitudes[k] * factor != 0.0;
            along(0) || along(1)
        };
        self.scene.node_sets.iter().enumerate().any(loaded)
    }
}

fn check_nodes(scene: &Scene) -> Result<(), Unsettleable> {
    let (mut free, mut held) = (false, false);
    for node in 0..scene.nodes.len() {
        let conditions = set_of(scene, node)
            .filter(|set| set.moves)
            .map_or([Condition::Frozen; 2], |set| set.conditions);
        if conditions.contains(&Condition::Absorbing) {
            return Err(Unsettleable::AbsorbingBoundaries);
        }
        free |= !conditions.into_iter().all(holds);
        held |= conditions.into_iter().any(holds);
        // a velocity that a node set prescribes is held at zero; any other would be lost
        let velocity = scene.nodes.velocity[node];
        let prescribed = conditions == [Condition::Velocity; 2];
        if !prescribed && (velocity.x != 0.0 || velocity.y != 0.0) {
            return Err(Unsettleable::Moving { node });
        }
    }
    if !free {
        return Err(Unsettleable::NoFreeNode);
    }
    if scene.control.gravity[1] != 0.0 && !held {
        return Err(Unsettleable::NothingHeld);
    }
    Ok(())
}

fn set_of(scene: &Scene, node: usize) -> Option<&NodeSet<2>> {
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
