//! The scene: everything a simulation needs, free of file syntax.
//!
//! A [`Scene`] is built from a deck by [`from_deck`], which makes every check
//! and reports each mistake with its place in the deck.

mod boundary;
mod contact;
mod control;
mod conventions;
mod face_pressure;
mod fracture_network;
mod from_deck;
mod joint_restart;
mod materials;
mod mesh;
mod meshing;
mod probes;
mod rock_joint;
mod snapshots;

pub use boundary::{Condition, InSituStress, LoadHistory, LoadRamp, NodeSet};
pub use contact::{
    ContactSettings, FrictionModel, PairProperties, PairRow, PairRule, PressedFaces, SpatialContact,
};
pub use control::{Control, RefinedOutput};
pub use conventions::{
    BROKEN_OFFSET, BondedPairs, ChainAfterDrop, CohesiveModel, ContactSelection, ContactSum,
    Conventions, ForceOrder, HistoryLines, Interfaces, OutputTime, Refresh, SPLIT_BROKEN,
    SPLIT_FREE_EDGE, VolumetricShare,
};
pub use face_pressure::FacePressure;
pub use fracture_network::{Fracture, FractureNetwork, FractureTreatment, SeismicMethod};
pub use from_deck::{
    BuildOutcome, Profile, from_deck, replay_settings, spatial_from_deck, update_scene,
    update_spatial_scene,
};
pub use joint_restart::JointRestart;
pub use materials::{
    CohesiveLaw, ElasticLaw, ElementKind, FailedJoints, Isotropy, JointPoints, Layering, Material,
    TransverseIsotropy,
};
pub use mesh::{Elements, JointKind, Nodes};
pub use meshing::{Combination, Insertion, JointPair};
pub use probes::{Probe, ProbeQuantity};
pub use rock_joint::{InitialAperture, RockJoint};
pub use snapshots::SnapshotSettings;

/// A scene in `D` dimensions, ready to be simulated.
///
/// Indices are 0-based deck numbers throughout. Property codes of elements:
/// `0..materials.len()` is a continuum element of that material,
/// `materials.len() + s` a joint of cohesive law `s`; which joints are intact
/// says [`Elements::joint_kind`].
#[derive(Debug, Clone)]
pub struct Scene<const D: usize = 2> {
    /// Base name of the output files (spec `y2d3d.md` G.1).
    pub name: String,
    /// What the deck's program does in its own way.
    pub conventions: Conventions,
    /// Time stepping and output intervals.
    pub control: Control,
    /// Nodal state at the start.
    pub nodes: Nodes<D>,
    /// Elements at the start.
    pub elements: Elements,
    /// Material of each element property set.
    pub materials: Vec<Material>,
    /// Cohesive law of each joint property set.
    pub cohesive_laws: Vec<CohesiveLaw>,
    /// Boundary conditions of each node set.
    pub node_sets: Vec<NodeSet<D>>,
    /// Load-time history of the node sets, if the deck has one.
    pub load_history: Option<LoadHistory>,
    /// Staged loading (classic).
    pub ramp: Option<LoadRamp>,
    /// Stress that all elastic triangles are under from the start (Y-Geo).
    pub in_situ: Option<InSituStress>,
    /// Fractures that are there before the run (Y-Geo).
    pub fracture_network: Option<FractureNetwork>,
    /// How the energy that breaking joints release is measured (Y-Geo).
    pub seismic: SeismicMethod,
    /// Where the aperture of old fractures comes from (classic).
    pub initial_aperture: InitialAperture,
    /// State of joints at the start, if the deck goes on from an earlier run (classic).
    pub joint_restart: Option<JointRestart>,
    /// Snapshots and restart decks (classic).
    pub snapshots: Option<SnapshotSettings>,
    /// Integration of joints between tetrahedra (3D).
    pub joint_points: JointPoints,
    /// What becomes of such joints when they fail (3D).
    pub failed_joints: FailedJoints,
    /// Whether joints unload along another path than they soften (Y-Geo).
    pub hysteretic_joints: bool,
    /// Pressures on faces of tetrahedra (`.Y3D`).
    pub face_pressures: Vec<FacePressure>,
    /// Time in which these rise from 0, s; 0 for all at once.
    pub pressure_ramp: f64,
    /// Contact settings; `None` switches contact off.
    pub contact: Option<ContactSettings>,
    /// Refinement and joint insertion to do in the first step.
    pub insertion: Option<Insertion>,
    /// History outputs.
    pub probes: Vec<Probe>,
    /// Change of a probe's value below which the stored value is kept:
    /// absolute for all quantities but the kinetic energy, where it is relative.
    pub probe_threshold: f64,
}

impl<const D: usize> Scene<D> {
    /// Material of an element; `None` for joints, live or broken.
    #[must_use]
    pub fn material_of(&self, element: usize) -> Option<&Material> {
        usize::try_from(self.elements.property[element]).ok().and_then(|p| self.materials.get(p))
    }

    /// Cohesive law of a joint; `None` for other elements and broken joints.
    #[must_use]
    pub fn law_of(&self, element: usize) -> Option<&CohesiveLaw> {
        let property = usize::try_from(self.elements.property[element]).ok()?;
        self.cohesive_laws.get(property.checked_sub(self.materials.len())?)
    }

    /// Property code of an element as decks and state files show it.
    #[must_use]
    pub fn property_code(&self, element: usize) -> i32 {
        let (property, kind) = (self.elements.property[element], self.elements.joint_kind[element]);
        let materials = self.materials.len();
        if self.failed_joints == FailedJoints::Opened && kind == JointKind::Broken {
            return property - materials as i32 - BROKEN_OFFSET;
        }
        self.conventions.property_code(property, kind, materials)
    }

    /// Factor on the amplitudes of a node set at `time`: that of the load-time history if it is
    /// active, otherwise that of staged loading.
    #[must_use]
    pub fn load_factor(&self, set: usize, time: f64) -> f64 {
        match self.load_history.as_ref().filter(|history| history.is_active()) {
            Some(history) => history.factor(set, time),
            None => self.ramp.map_or(1.0, |ramp| ramp.factor(time)),
        }
    }
}

impl Scene {
    /// Whether a point (initial coordinates, m) lies strictly inside an elastic
    /// triangle.
    #[must_use]
    pub fn contains_point(&self, point: nalgebra::Vector2<f64>) -> bool {
        (0..self.elements.len()).any(|e| {
            let elastic =
                self.material_of(e).is_some_and(|m| m.kind == ElementKind::ElasticTriangle);
            let corners = || self.elements.corners::<3>(e).map(|n| self.nodes.initial[n]);
            elastic && crate::mechanics::triangle::contains(&corners(), point)
        })
    }
}
