//! What a deck means, in terms that are the same in all dialects.

use super::contact::PairTable;

/// The scene and the run that a deck describes.
#[derive(Debug, Clone, Default)]
pub(super) struct Model {
    /// Control values.
    pub(super) control: Control,
    /// Capacity for nodes.
    pub(super) node_room: i64,
    /// Nodes.
    pub(super) nodes: Vec<Node>,
    /// Capacity for elements.
    pub(super) element_room: i64,
    /// Rows of the state table, `MELST`.
    pub(super) state_rows: i64,
    /// Triangles.
    pub(super) triangles: Vec<Triangle>,
    /// Contact.
    pub(super) contact: Contact,
    /// Element sets.
    pub(super) element_sets: Vec<ElementSet>,
    /// Contact laws of pairs of element sets.
    pub(super) pairs: PairTable,
    /// Node sets.
    pub(super) node_sets: Vec<NodeSet>,
    /// Joint sets.
    pub(super) joint_sets: Vec<JointSet>,
    /// What is meshed: mesh code and element sets.
    pub(super) meshing: Vec<(i64, Vec<usize>)>,
    /// Joint sets of pairs of element sets: set, set, joint set.
    pub(super) joint_of_pair: Vec<[i64; 3]>,
}

/// Time, steps, gravity, output.
#[derive(Debug, Clone, Default)]
pub(super) struct Control {
    pub(super) last_step: i64,
    pub(super) first_step: i64,
    /// m/s².
    pub(super) gravity: f64,
    /// s.
    pub(super) time_step: f64,
    /// s.
    pub(super) start: f64,
    pub(super) output_interval: i64,
    pub(super) output_number: i64,
    pub(super) output_digits: i64,
    /// Output scales of coordinates, forces, stresses, velocities; `None` where not given.
    pub(super) scales: [Option<f64>; 4],
}

/// A node.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Node {
    pub(super) initial: [f64; 2],
    pub(super) current: [f64; 2],
    pub(super) velocity: [f64; 2],
    /// Whether its elements may touch others.
    pub(super) flagged: bool,
    /// Its node set.
    pub(super) set: Option<usize>,
}

/// A triangle.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Triangle {
    pub(super) nodes: [i64; 3],
    pub(super) set: usize,
}

/// How contact is looked for.
#[derive(Debug, Clone, Default)]
pub(super) struct Contact {
    /// Capacity for couples.
    pub(super) couples: i64,
    /// Way travelled since the last detection, m.
    pub(super) travelled: f64,
    /// Buffer, m.
    pub(super) buffer: f64,
}

/// A set of triangles.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct ElementSet {
    /// 1 elastic, 2 rigid, 4 softening.
    pub(super) kind: i64,
    /// Lamé's λ at small strains, Pa.
    pub(super) lambda: f64,
    /// Lamé's μ, Pa.
    pub(super) mu: f64,
    /// kg/m³.
    pub(super) density: f64,
    /// Pa s.
    pub(super) viscosity: f64,
    /// Largest tensile stretch of type 4.
    pub(super) stretch: f64,
    /// Whether elements of type 4 may fracture.
    pub(super) fractures: i64,
    /// Whether refinement marks true boundary nodes only.
    pub(super) boundary_mode: i64,
    /// Row of the damage.
    pub(super) state_row: i64,
}

/// A set of nodes with a boundary condition.
#[derive(Debug, Clone, Default)]
pub(super) struct NodeSet {
    /// Codes in the local directions.
    pub(super) codes: [i64; 2],
    /// Amplitudes in the local directions.
    pub(super) amplitudes: [f64; 2],
    /// Pressure and traction on edges, Pa.
    pub(super) edge_loads: [f64; 2],
    /// Local axes: x of the first, y of it, x of the second, y of it.
    pub(super) axes: [f64; 4],
    /// Times and factors of all loads; 1 outside.
    pub(super) factors: Vec<(f64, f64)>,
}

impl NodeSet {
    /// Whether a factor would change anything.
    pub(super) fn is_loaded(&self) -> bool {
        self.amplitudes.iter().chain(&self.edge_loads).any(|&value| value != 0.0)
    }
}

/// A set of joints.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct JointSet {
    /// Joint type: 3 between triangles.
    pub(super) kind: i64,
    /// Pa.
    pub(super) tensile_strength: f64,
    /// Shear strength where there is no cohesion, Pa.
    pub(super) shear_strength: f64,
    /// Pa.
    pub(super) cohesion: f64,
    /// Friction coefficient.
    pub(super) friction: f64,
    /// J/m², mode I.
    pub(super) opening_energy: f64,
    /// J/m², mode II.
    pub(super) sliding_energy: f64,
    /// Pa.
    pub(super) penalty: f64,
}
