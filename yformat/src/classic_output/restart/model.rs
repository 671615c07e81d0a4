//! What a restart deck holds.

use super::{HistoryState, JointState, PropertySet};
use crate::classic_output::{GidMesh, Table};
use crate::ym::Scales;

/// All values of a restart deck. (outputs.md 3.4, deck.md 7.1)
///
/// Not preserved by the original: accumulated sliding and couples of contacts, acoustic emission,
/// damage of softening triangles.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct RestartDeck {
    /// Steps, times, scales and intervals.
    pub control: Control,
    /// Triangles and joints.
    pub elements: Elements,
    /// State of the joints.
    pub joints: Vec<JointState>,
    /// Contact detection.
    pub contact: Contact,
    /// Nodes.
    pub nodes: Nodes,
    /// How many property sets the arrays hold, `MPROP`.
    pub property_capacity: i64,
    /// Property sets.
    pub properties: Vec<PropertySet>,
    /// How many histories the arrays hold, `MOHYS`.
    pub history_capacity: i64,
    /// Relative change that refreshes a history, `DOHYP`.
    pub history_threshold: f64,
    /// Histories.
    pub histories: Vec<HistoryState>,
}

/// Database YDC.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Control {
    /// `MCSTEP`: steps run while the step is less.
    pub end_step: i64,
    /// `NCSTEP`: the step to come.
    pub next_step: i64,
    /// `DCGRAY`, m/s².
    pub gravity: f64,
    /// Output scales.
    pub scales: Scales,
    /// `DCSTEC`, s.
    pub time_step: f64,
    /// `DCTIME`, s: the time at the step to come.
    pub time: f64,
    /// `DCGRST`, s: loads are 0 before.
    pub settling_time: f64,
    /// `DCRMPT`, s: loads grow during this time.
    pub ramp_time: f64,
    /// `ICOUTF`: steps from snapshot to snapshot.
    pub output_interval: i64,
    /// `ICOUTI`: number of the snapshot to come.
    pub next_snapshot: i64,
    /// `ICSAVF`: steps from restart deck to restart deck.
    pub restart_interval: i64,
    /// `ICOUTP`: digits per number of snapshots.
    pub digits: i64,
    /// `ICFMTY`: 0 Coulomb, 1 Barton and Bandis.
    pub friction_law: i64,
    /// `ICIATY`: initial aperture from roughness (0) or length (1).
    pub aperture_law: i64,
}

/// Database YDE. Rows of the tables are elements.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Elements {
    /// `MELEM`.
    pub capacity: i64,
    /// `MELST`: rows of the state array.
    pub state_rows: i64,
    /// `NELST`.
    pub states: i64,
    /// `NELNO`: nodes of a triangle.
    pub nodes_per_element: i64,
    /// `I1ELTY`: -1 triangle, 0 intact joint, 1 boundary, 2 old fracture, 3 new crack.
    pub kinds: Vec<i64>,
    /// `I1ELPR`: property set.
    pub properties: Vec<i64>,
    /// `I2ELTO`: nodes from 0, -1 for none; the row length is `MELNO`.
    pub nodes: Table<i64>,
    /// `D2ELFS`, Pa: shear strengths of joints, as the original prints them: in storage where the
    /// value of point `k` of element `e` lies at `3 k + e` and is overwritten by its neighbours.
    pub shear_strengths: Table<f64>,
    /// `I2ELJP`: joint on each edge of a triangle.
    pub joints: Table<i64>,
}

/// Database YDI. The other values are always those that make the program detect contact anew.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Contact {
    /// `MICOUP`.
    pub couple_capacity: i64,
    /// `DIEZON`, m.
    pub buffer: f64,
}

/// Database YDN. All lists have one entry per node.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Nodes {
    /// `MNODIM`.
    pub dimension_capacity: i64,
    /// `MNOPO`.
    pub capacity: i64,
    /// `D2NCC`, m: present coordinates.
    pub coordinates: Vec<[f64; 2]>,
    /// `D2NCI`, m: initial coordinates.
    pub initial_coordinates: Vec<[f64; 2]>,
    /// `D2NFC`, N.
    pub forces: Vec<[f64; 2]>,
    /// `D1NMCT`, kg.
    pub masses: Vec<f64>,
    /// `D2NVC`, m/s.
    pub velocities: Vec<[f64; 2]>,
    /// `I1NOBF`: boundary flag.
    pub boundary_flags: Vec<i64>,
    /// `I1NOPR`: property set.
    pub properties: Vec<i64>,
}

impl RestartDeck {
    /// The mesh that the original writes beside the restart deck.
    #[must_use]
    pub fn mesh(&self) -> GidMesh<'_> {
        GidMesh {
            coordinates: &self.nodes.coordinates,
            elements: &self.elements.nodes,
            nodes_per_element: usize::try_from(self.elements.nodes_per_element).unwrap_or(0),
        }
    }
}
