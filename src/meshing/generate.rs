//! From a scenario to a deck.

use super::{
    MeshingError, Scenario,
    model::Model,
    node_sets::NodeSets,
    property_sets::PropertySets,
    scenario::AnyKind,
    spatial::SpatialGenerated,
    stability::TimeStepBounds,
    write_deck::{self, Times},
};
use yformat::deck::Deck;

/// A deck with what it was made from.
#[derive(Debug, Clone)]
pub struct Generated {
    /// The deck, split dialect.
    pub deck: Deck,
    /// Mesh, materials, supports.
    pub model: Model,
    /// Property sets of the deck.
    pub properties: PropertySets,
    /// Node sets of the deck, load-time tables, sums of the loads.
    pub node_sets: NodeSets,
    /// What the time step may be.
    pub bounds: TimeStepBounds,
    /// The time step that the deck has \[s\].
    pub step_s: f64,
    /// End of the run \[s\].
    pub end_s: f64,
}

/// First line of the comment that starts a generated deck.
const MARK: &str = "made by ypsilon mesh";

impl Generated {
    /// Whether a deck's text was made by a generator, so that it may be made again in its place.
    #[must_use]
    pub fn is_generated(text: &str) -> bool {
        text.lines().next().is_some_and(|line| line.contains(MARK))
    }

    /// What is worth telling about the deck, one line each.
    #[must_use]
    pub fn report(&self) -> Vec<String> {
        let mesh = &self.model.mesh;
        let mut lines = vec![format!(
            "{}: {} nodes, {} triangles in {} blocks, {:.6} m²",
            self.model.title,
            mesh.nodes.len(),
            mesh.triangles.len(),
            mesh.blocks,
            mesh.total_area(),
        )];
        lines.extend(self.model.notes.iter().cloned());
        for (number, set) in self.node_sets.sets.iter().enumerate() {
            // many nodes of the top have a set each
            if set.name == "loaded" {
                continue;
            }
            let nodes = self.node_sets.of_node.iter().filter(|&&own| own == number).count();
            lines.push(format!("node set {number}: {} ({nodes} nodes)", set.name));
        }
        let loaded = self.node_sets.sets.iter().filter(|set| set.name == "loaded").count();
        if loaded > 0 {
            lines.push(format!("node sets of loaded nodes of the top: {loaded}"));
        }
        lines.extend(self.sum_of_loads());
        let bounds = &self.bounds;
        let viscosity = if self.properties.sets.iter().any(|set| set.viscosity_pa_s > 0.0) {
            format!("viscosity alone {:.3e} s", bounds.viscosity_s)
        } else {
            "no viscosity".to_owned()
        };
        lines.push(format!(
            "time step {:.3e} s; stable below {:.3e} s (stiffness alone {:.3e} s, {viscosity}, \
             wave across the flattest triangle {:.3e} s)",
            self.step_s, bounds.together_s, bounds.stiffness_s, bounds.wave_s,
        ));
        lines
    }

    /// What the loads amount to at the instants where that changes.
    fn sum_of_loads(&self) -> Vec<String> {
        let sums = &self.node_sets.sums;
        let Some(most) = sums.iter().map(|sum| sum.applied_n).reduce(f64::max) else {
            return Vec::new();
        };
        let worst =
            sums.iter().map(|sum| (sum.applied_n - sum.described_n).abs()).fold(0.0, f64::max);
        let mut lines = vec![format!(
            "loads: at most {:.6} kN downward; nodes and description differ by {worst:.1e} N at \
             most at {} instants",
            most / 1e3,
            sums.len()
        )];
        let mut steps: Vec<(f64, f64)> = Vec::new();
        for sum in sums {
            let level = steps.last().map_or(f64::NAN, |step| step.1);
            let is_stage = sums
                .iter()
                .any(|other| other.time_s > sum.time_s && other.applied_n == sum.applied_n);
            if sum.applied_n != level && is_stage {
                steps.push((sum.time_s, sum.applied_n));
            }
        }
        if (2..=12).contains(&steps.len()) {
            // sums of ramps and intervals are not round
            let round = |t: f64| (t * 1e9).round() / 1e9;
            let text = steps.iter().map(|(t, f)| format!("{:.3} kN from {} s", f / 1e3, round(*t)));
            lines.push(format!("stages: {}", text.collect::<Vec<_>>().join(", ")));
        }
        lines
    }
}

impl Scenario {
    /// Makes the deck of a structure in the plane.
    ///
    /// # Errors
    /// If a parameter has no sense, the mesh is not sound, the forces of the deck do not amount
    /// to the loads, or the structure is one in space.
    pub fn generate(&self) -> Result<Generated, MeshingError> {
        self.check()?;
        match self.kind()? {
            (_, AnyKind::Plane(kind)) => self.in_plane(kind.model()?),
            (name, AnyKind::Spatial(_)) => Err(MeshingError::Scenario(format!(
                "[{name}] is a structure in space, where one in the plane is needed"
            ))),
        }
    }

    /// Makes the deck of a structure in space.
    ///
    /// # Errors
    /// As [`Scenario::generate`], and if the structure is one in the plane.
    pub fn generate_in_space(&self) -> Result<SpatialGenerated, MeshingError> {
        self.check()?;
        match self.kind()? {
            (_, AnyKind::Spatial(kind)) => SpatialGenerated::of(self, kind.model()?),
            (name, AnyKind::Plane(_)) => Err(MeshingError::Scenario(format!(
                "[{name}] is a structure in the plane, where one in space is needed"
            ))),
        }
    }

    /// Makes the deck, in the plane or in space.
    ///
    /// # Errors
    /// As [`Scenario::generate`].
    pub fn generate_any(&self) -> Result<AnyGenerated, MeshingError> {
        match self.kind()? {
            (_, AnyKind::Plane(_)) => Ok(AnyGenerated::Plane(Box::new(self.generate()?))),
            (_, AnyKind::Spatial(_)) => {
                Ok(AnyGenerated::Spatial(Box::new(self.generate_in_space()?)))
            }
        }
    }

    fn in_plane(&self, mut model: Model) -> Result<Generated, MeshingError> {
        if let Some(title) = &self.title {
            model.title.clone_from(title);
        }
        model.check()?;
        let last = self.loads.iter().map(|load| load.end_s(&model, &self.staging));
        let ended = last.fold(model.settled_s, f64::max);
        let end_s = self.run.end_s.unwrap_or(ended);
        let properties = PropertySets::of(&model);
        let node_sets = NodeSets::of(&model, &self.loads, &self.staging, end_s)?;
        let bounds = TimeStepBounds::of(&model, &properties);
        let step_s = self.run.step_s.unwrap_or_else(|| bounds.suggestion_s());
        let times = Times { step_s, end_s, output_s: self.run.output_s.unwrap_or(end_s / 40.0) };
        let header = header(self, &model.title)?;
        let deck = write_deck::deck(&header, &model, &properties, &node_sets, times, self.run);
        Ok(Generated { deck, model, properties, node_sets, bounds, step_s, end_s })
    }
}

/// Comments that say how the deck of a scenario was made.
pub(super) fn header(scenario: &Scenario, title: &str) -> Result<Vec<String>, MeshingError> {
    let text = toml::to_string(scenario).map_err(|e| MeshingError::Scenario(e.to_string()))?;
    let mut lines = vec![
        format!("{MARK} {}", env!("CARGO_PKG_VERSION")),
        title.to_owned(),
        "from this scenario:".to_owned(),
    ];
    let lined = text.lines().filter(|line| !line.trim().is_empty());
    lines.extend(lined.map(|line| line.replace("*/", "* /")));
    Ok(lines)
}

/// A deck in the plane or in space.
#[derive(Debug, Clone)]
pub enum AnyGenerated {
    /// Of triangles.
    Plane(Box<Generated>),
    /// Of tetrahedra.
    Spatial(Box<SpatialGenerated>),
}

impl AnyGenerated {
    /// The deck.
    #[must_use]
    pub fn deck(&self) -> &Deck {
        match self {
            Self::Plane(generated) => &generated.deck,
            Self::Spatial(generated) => &generated.deck,
        }
    }

    /// Time step \[s\].
    #[must_use]
    pub fn step_s(&self) -> f64 {
        match self {
            Self::Plane(generated) => generated.step_s,
            Self::Spatial(generated) => generated.step_s,
        }
    }

    /// What is worth telling about the deck, one line each.
    #[must_use]
    pub fn report(&self) -> Vec<String> {
        match self {
            Self::Plane(generated) => generated.report(),
            Self::Spatial(generated) => generated.report(),
        }
    }
}
