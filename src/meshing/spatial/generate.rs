//! From a scenario in space to a deck.

use super::{
    deck::{self, Conditions},
    model::SpatialModel,
    property_sets,
};
use crate::meshing::{
    MeshingError, Scenario, TimeStepBounds,
    generate::header,
    model::Motion,
    node_sets::{NodeSet, gather, instants},
    property_sets::PropertySets,
    write_deck::Times,
};
use yformat::deck::Deck;

/// A deck in space with what it was made from.
#[derive(Debug, Clone)]
pub struct SpatialGenerated {
    /// The deck, split dialect.
    pub deck: Deck,
    /// Mesh, materials, supports.
    pub model: SpatialModel,
    /// Property sets of the deck; those of its triangles are the tetrahedra's.
    pub properties: PropertySets,
    /// Node sets of the deck.
    pub node_sets: Vec<NodeSet<3>>,
    /// What the time step may be.
    pub bounds: TimeStepBounds,
    /// The time step that the deck has \[s\].
    pub step_s: f64,
    /// End of the run \[s\].
    pub end_s: f64,
}

impl SpatialGenerated {
    /// Makes the deck of a model.
    ///
    /// # Errors
    /// If the mesh is not sound or loads are asked for, which act in the plane only.
    pub(in crate::meshing) fn of(
        scenario: &Scenario,
        mut model: SpatialModel,
    ) -> Result<Self, MeshingError> {
        if !scenario.loads.is_empty() {
            let expected = "none: loads act on structures in the plane only";
            return Err(MeshingError::parameter("loads", "given", expected));
        }
        if let Some(title) = &scenario.title {
            model.title.clone_from(title);
        }
        model.check()?;
        let end_s = scenario.run.end_s.unwrap_or(model.settled_s);
        let properties = property_sets::sets(&model);
        let bounds = super::stability::bounds(&model, &properties);
        let step_s = scenario.run.step_s.unwrap_or_else(|| bounds.suggestion_s());
        let output_s = scenario.run.output_s.unwrap_or(end_s / 40.0);
        let mut own = vec![("free".to_owned(), Motion::<3>::FREE); model.mesh.nodes.len()];
        for support in &model.supports {
            for &node in &support.nodes {
                own[node] = (support.name.clone(), support.motion.clone());
            }
        }
        let (sets, of_node) = gather(own);
        let instants = instants(&sets, end_s);
        let conditions = Conditions { sets, of_node, instants };
        let header = header(scenario, &model.title)?;
        let times = Times { step_s, end_s, output_s };
        let deck = deck::deck(&header, &model, &properties, &conditions, times, scenario.run);
        let node_sets = conditions.sets;
        Ok(SpatialGenerated { deck, model, properties, node_sets, bounds, step_s, end_s })
    }

    /// What is worth telling about the deck, one line each.
    #[must_use]
    pub fn report(&self) -> Vec<String> {
        let mesh = &self.model.mesh;
        let mut lines = vec![format!(
            "{}: {} nodes, {} tetrahedra in {} blocks, {:.6} m³",
            self.model.title,
            mesh.nodes.len(),
            mesh.tetrahedra.len(),
            mesh.blocks,
            mesh.total_volume(),
        )];
        lines.extend(self.model.notes.iter().cloned());
        for (number, set) in self.node_sets.iter().enumerate() {
            lines.push(format!("node set {number}: {}", set.name));
        }
        let bounds = &self.bounds;
        lines.push(format!(
            "time step {:.3e} s; stable below {:.3e} s (stiffness alone {:.3e} s, wave across the \
             flattest tetrahedron {:.3e} s)",
            self.step_s, bounds.together_s, bounds.stiffness_s, bounds.wave_s,
        ));
        lines
    }
}
