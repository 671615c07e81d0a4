//! Sums over nodes during a run: reactions, contact forces, displacements, energies.

use super::{
    FilePosition, OutputError, OutputNames, ResultWriter, body_of_elements, decode, encode,
    table_file::TableFile,
};
use crate::{TOLERANCE, mechanics::Vec2, simulation::Simulation};
use serde::{Deserialize, Serialize};
use std::{fmt, path::PathBuf, str::FromStr};
use ypsilon_post::{
    PostError,
    selection::{Mesh, Selection},
    table::number,
};

/// What checkpoints call the table.
const KIND: &str = "monitors";

/// What is told of the nodes of a selection.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum MonitorQuantity {
    /// Sum of the nodal forces along an axis (0 or 1): internal, joints, contact, edge loads;
    /// without gravity and nodal loads.
    Force(usize),
    /// Minus that sum: what holds the nodes pushes the body so, apart from their own weight
    /// and loads.
    Reaction(usize),
    /// Sum of the contact forces along an axis.
    Contact(usize),
    /// Mean displacement along an axis.
    Displacement(usize),
    /// Largest magnitude of a displacement.
    LargestDisplacement,
    /// Kinetic energy.
    KineticEnergy,
    /// Strain energy of the elastic triangles all of whose nodes are selected.
    StrainEnergy,
    /// Number of joints that failed so far all of whose nodes are selected.
    BrokenJoints,
}

/// Quantities with their names and units.
const QUANTITIES: [(MonitorQuantity, &str, &str); 12] = [
    (MonitorQuantity::Reaction(0), "reaction-x", "N"),
    (MonitorQuantity::Reaction(1), "reaction-y", "N"),
    (MonitorQuantity::Force(0), "force-x", "N"),
    (MonitorQuantity::Force(1), "force-y", "N"),
    (MonitorQuantity::Contact(0), "contact-x", "N"),
    (MonitorQuantity::Contact(1), "contact-y", "N"),
    (MonitorQuantity::Displacement(0), "ux", "m"),
    (MonitorQuantity::Displacement(1), "uy", "m"),
    (MonitorQuantity::LargestDisplacement, "umax", "m"),
    (MonitorQuantity::KineticEnergy, "kinetic-energy", "J"),
    (MonitorQuantity::StrainEnergy, "strain-energy", "J"),
    (MonitorQuantity::BrokenJoints, "broken-joints", ""),
];

impl MonitorQuantity {
    /// Its name, and its unit behind it in brackets.
    fn heading(self) -> String {
        let entry = QUANTITIES.iter().find(|(quantity, ..)| *quantity == self);
        match entry {
            Some((_, name, "")) => (*name).to_owned(),
            Some((_, name, unit)) => format!("{name} ({unit})"),
            None => String::new(),
        }
    }
}

/// Quantities watched on a selection of nodes.
///
/// ```
/// use ypsilon::output::{Monitor, MonitorQuantity};
/// let monitor: Monitor = "support=set:1:reaction-x,reaction-y".parse()?;
/// assert_eq!(monitor.name, "support");
/// assert_eq!(monitor.quantities[1], MonitorQuantity::Reaction(1));
/// # Ok::<(), ypsilon_post::PostError>(())
/// ```
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(try_from = "String", into = "String")]
pub struct Monitor {
    /// Its name in the table.
    pub name: String,
    /// The nodes, by what they are at the start of the run.
    pub selection: Selection,
    /// What is told of them.
    pub quantities: Vec<MonitorQuantity>,
}

impl FromStr for Monitor {
    type Err = PostError;

    /// `NAME=SELECTION:QUANTITY[,QUANTITY...]`
    fn from_str(words: &str) -> Result<Self, PostError> {
        let form = "expected NAME=SELECTION:QUANTITY[,QUANTITY...]";
        let parts = words.split_once('=').and_then(|(name, rest)| {
            let (selection, quantities) = rest.rsplit_once(':')?;
            (!name.trim().is_empty()).then_some((name.trim(), selection, quantities))
        });
        let (name, selection, quantities) =
            parts.ok_or_else(|| PostError::words("the monitor", words, form))?;
        let quantity = |word: &str| {
            let entry = QUANTITIES.iter().find(|(_, name, _)| *name == word.trim());
            entry.map(|(quantity, ..)| *quantity).ok_or_else(|| {
                let names: Vec<&str> = QUANTITIES.iter().map(|(_, name, _)| *name).collect();
                let expected = format!("{form}; quantities are {}", names.join(", "));
                PostError::words("the quantity of a monitor", word, expected)
            })
        };
        Ok(Self {
            name: name.to_owned(),
            selection: selection.parse()?,
            quantities: quantities.split(',').map(quantity).collect::<Result<_, _>>()?,
        })
    }
}

impl TryFrom<String> for Monitor {
    type Error = PostError;

    fn try_from(words: String) -> Result<Self, PostError> {
        words.parse()
    }
}

impl From<Monitor> for String {
    fn from(monitor: Monitor) -> Self {
        monitor.to_string()
    }
}

impl fmt::Display for Monitor {
    /// The words that it can be read from.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = |quantity: &MonitorQuantity| {
            let entry = QUANTITIES.iter().find(|(q, ..)| q == quantity);
            entry.map_or("", |(_, name, _)| *name)
        };
        let quantities: Vec<&str> = self.quantities.iter().map(name).collect();
        write!(f, "{}={}:{}", self.name, self.selection, quantities.join(","))
    }
}

/// What is watched during a run, and how often.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MonitorPlan {
    /// The monitors.
    pub monitors: Vec<Monitor>,
    /// A line is written at steps whose index is a multiple of this.
    pub interval: u64,
}

impl Default for MonitorPlan {
    fn default() -> Self {
        Self { monitors: Vec::new(), interval: 100 }
    }
}

impl MonitorPlan {
    /// Whether nothing is watched.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.monitors.is_empty()
    }

    /// Whether contact forces have to be told apart.
    #[must_use]
    pub fn needs_contact_forces(&self) -> bool {
        let quantities = self.monitors.iter().flat_map(|m| &m.quantities);
        quantities.into_iter().any(|q| matches!(q, MonitorQuantity::Contact(_)))
    }
}

/// Writes the table of the monitors.
pub struct MonitorOutput {
    plan: MonitorPlan,
    /// None until a table of an earlier run is gone on with.
    table: Option<TableFile>,
    chosen: Chosen,
}

/// The nodes of the monitors.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
struct Chosen {
    /// Nodes of each monitor, ascending.
    nodes: Vec<Vec<usize>>,
    /// How many nodes there were when they were chosen.
    among: usize,
}

/// How to go on with a table of monitors.
#[derive(Serialize, Deserialize)]
struct MonitorMark {
    position: FilePosition,
    plan: MonitorPlan,
    chosen: Chosen,
}

impl MonitorOutput {
    /// Starts the table and chooses the nodes.
    ///
    /// # Errors
    /// If a selection holds no node or the file cannot be created.
    pub fn open(
        names: &OutputNames,
        plan: &MonitorPlan,
        simulation: &Simulation,
    ) -> Result<Self, OutputError> {
        let chosen = choose(plan, simulation)?;
        let mut headings = vec!["time (s)".to_owned(), "step".to_owned()];
        for monitor in &plan.monitors {
            let name = monitor.name.replace([',', '"'], " ");
            headings.extend(monitor.quantities.iter().map(|q| format!("{name} {}", q.heading())));
        }
        let table = Some(TableFile::with_heading(names.monitors(), &headings.join(","))?);
        Ok(Self { plan: plan.clone(), table, chosen })
    }

    /// A table of an earlier run, to be gone on with.
    #[must_use]
    pub fn closed(plan: &MonitorPlan) -> Self {
        Self { plan: plan.clone(), table: None, chosen: Chosen::default() }
    }

    fn line(&self, simulation: &Simulation) -> String {
        let mut line = format!("{},{}", number(simulation.time()), simulation.step_index());
        for (monitor, nodes) in self.plan.monitors.iter().zip(&self.chosen.nodes) {
            for &quantity in &monitor.quantities {
                line.push(',');
                line.push_str(&number(value(simulation, nodes, quantity)));
            }
        }
        line
    }
}

impl ResultWriter for MonitorOutput {
    fn after_forces(&mut self, simulation: &Simulation) -> Result<(), OutputError> {
        if !simulation.step_index().is_multiple_of(self.plan.interval) {
            return Ok(());
        }
        if simulation.scene().nodes.len() != self.chosen.among {
            self.chosen = choose(&self.plan, simulation)?;
        }
        let line = self.line(simulation);
        self.table.as_mut().map_or(Ok(()), |table| table.line(&line))
    }

    fn kind(&self) -> &'static str {
        KIND
    }

    fn mark(&mut self) -> Result<Vec<u8>, OutputError> {
        let table = self.table.as_mut().ok_or(OutputError::Mark { kind: KIND })?;
        let position = table.mark()?;
        let (plan, chosen) = (self.plan.clone(), self.chosen.clone());
        encode(KIND, &MonitorMark { position, plan, chosen })
    }

    fn resume(
        &mut self,
        mark: &[u8],
        names: &OutputNames,
        simulation: &Simulation,
    ) -> Result<(), OutputError> {
        let mark: MonitorMark = decode(KIND, mark)?;
        let nodes = simulation.scene().nodes.len();
        if mark.plan != self.plan
            || mark.chosen.nodes.len() != self.plan.monitors.len()
            || mark.chosen.nodes.iter().flatten().any(|&node| node >= nodes)
        {
            return Err(OutputError::Mark { kind: KIND });
        }
        self.table = Some(TableFile::resume(names.monitors(), mark.position)?);
        self.chosen = mark.chosen;
        Ok(())
    }

    fn finish(self: Box<Self>) -> Result<Vec<PathBuf>, OutputError> {
        self.table.map(TableFile::finish).into_iter().collect()
    }
}

fn choose(plan: &MonitorPlan, simulation: &Simulation) -> Result<Chosen, OutputError> {
    let scene = simulation.scene();
    let initial: Vec<[f64; 2]> = scene.nodes.initial.iter().map(|x| [x.x, x.y]).collect();
    let elements: Vec<usize> = simulation.triangles().collect();
    let triangles: Vec<[u32; 3]> =
        elements.iter().map(|&e| scene.elements.corners::<3>(e).map(|n| n as u32)).collect();
    let property: Vec<i32> = elements.iter().map(|&e| scene.elements.property[e]).collect();
    let bodies = body_of_elements(simulation);
    let body: Vec<i32> = elements.iter().map(|&e| bodies[e]).collect();
    let mesh = Mesh {
        initial: &initial,
        node_set: Some(&scene.nodes.set),
        elements: &triangles,
        edge_nodes: &[],
        property: &property,
        body: Some(&body),
    };
    let nodes = |monitor: &Monitor| {
        let name = monitor.name.clone();
        monitor.selection.nodes(&mesh).map_err(|source| OutputError::Monitor { name, source })
    };
    let nodes = plan.monitors.iter().map(nodes).collect::<Result<_, _>>()?;
    Ok(Chosen { nodes, among: scene.nodes.len() })
}

fn value(simulation: &Simulation, nodes: &[usize], quantity: MonitorQuantity) -> f64 {
    let scene = simulation.scene();
    let displacement = |n: usize| scene.nodes.current[n] - scene.nodes.initial[n];
    match quantity {
        MonitorQuantity::Force(axis) => force(simulation, nodes)[axis],
        MonitorQuantity::Reaction(axis) => 0.0 - force(simulation, nodes)[axis],
        MonitorQuantity::Contact(axis) => sum(simulation.contact_share(), nodes)[axis],
        MonitorQuantity::Displacement(axis) => {
            nodes.iter().map(|&n| displacement(n)[axis]).sum::<f64>() / nodes.len() as f64
        }
        MonitorQuantity::LargestDisplacement => {
            nodes.iter().map(|&n| displacement(n).norm()).fold(0.0, f64::max)
        }
        MonitorQuantity::KineticEnergy => {
            let mass = |n: usize| Some(simulation.masses()[n]).filter(|m| *m >= TOLERANCE);
            let energy = |&n: &usize| Some(0.5 * mass(n)? * scene.nodes.velocity[n].norm_squared());
            nodes.iter().filter_map(energy).sum()
        }
        MonitorQuantity::StrainEnergy => {
            let within = simulation.triangles().filter(|&e| {
                scene.elements.corners::<3>(e).iter().all(|n| nodes.binary_search(n).is_ok())
            });
            within.filter_map(|e| simulation.strain_energy(e)).sum()
        }
        MonitorQuantity::BrokenJoints => {
            let is_within = |element: usize| {
                let corners = scene.elements.nodes[element].into_iter();
                let mut corners = corners.filter_map(|n| usize::try_from(n).ok());
                corners.all(|n| nodes.binary_search(&n).is_ok())
            };
            simulation.failures().iter().filter(|f| is_within(f.element)).count() as f64
        }
    }
}

/// Sum of all nodal forces; in the classic dialect contact forces join them only in the motion.
fn force(simulation: &Simulation, nodes: &[usize]) -> Vec2 {
    sum(simulation.forces(), nodes) + sum(simulation.contact_forces(), nodes)
}

fn sum(vectors: &[Vec2], nodes: &[usize]) -> Vec2 {
    nodes.iter().filter_map(|&n| vectors.get(n)).fold(Vec2::zeros(), |sum, v| sum + v)
}
