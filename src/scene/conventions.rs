//! What the programs of the family do differently.
//!
//! One row per dialect; the simulation reads the fields, never the dialect.

use crate::mechanics::tetrahedron::Volumetric;
use yformat::dialect::Dialect;

/// Share of λ (J − 1/J) in the stress of the elastic triangle.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum VolumetricShare {
    /// Half of it, so that λ acts with its nominal value.
    Half,
    /// All of it, so that λ acts with twice its nominal value at small strain
    /// (spec `mechanics.md` 2.2).
    Whole,
}

impl VolumetricShare {
    /// The share as a factor.
    #[must_use]
    pub fn factor(self) -> f64 {
        match self {
            Self::Half => 0.5,
            Self::Whole => 1.0,
        }
    }
}

/// How joints soften.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum CohesiveModel {
    /// Split dialect (spec `y2d3d.md` D.6): damage multiplies the pre-peak
    /// parabola; the softening extents are at least twice the peak's.
    Split,
    /// Y-Geo (spec `mechanics.md` 4.3): as split, but without that least extent.
    YGeo,
    /// Classic (spec `mechanics.md` 4.2): strengths at each point, shared
    /// between joints by the original's store; residual friction while intact.
    Classic,
}

/// In which order internal forces are summed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ForceOrder {
    /// All triangles, material by material, then all joints, set by set.
    TrianglesThenJoints,
    /// Property set by property set, whatever it is of: every joint set acts on
    /// every joint (spec `mechanics.md` 4.2.1).
    PropertyByProperty,
}

/// Which triangles take part in contact.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactSelection {
    /// All.
    All,
    /// Those with a contact tag; nodes flagged exactly 1 give one.
    Tagged,
    /// Those with a node flagged above 0.
    Flagged,
    /// Those with a body number above 0, which the deck alone gives; elements of one body never
    /// touch (spec `y3d.md` 1.1, 1.2).
    Bodies,
}

impl ContactSelection {
    /// Whether an element with this tag, and with these flags of its nodes, takes part.
    pub fn selects(self, tag: i32, mut flags: impl Iterator<Item = i32>) -> bool {
        match self {
            Self::All => true,
            Self::Tagged | Self::Bodies => tag > 0,
            Self::Flagged => flags.any(|flag| flag > 0),
        }
    }
}

/// Whether triangles bonded by intact joints may become couples.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum BondedPairs {
    /// They may.
    MayTouch,
    /// They are left out (spec `contact.md` 1.6).
    Excluded,
}

/// Where contact forces are summed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ContactSum {
    /// On top of the internal forces.
    WithInternal,
    /// Apart from them; the two sums are added when nodes move. Rigid
    /// triangles do not feel contact then (spec `mechanics.md` 9, quirk 9).
    Apart,
}

/// What becomes of a couple's neighbour in the chain when the couple is dropped.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ChainAfterDrop {
    /// Nothing.
    Untouched,
    /// The last sliding state of the next couple in the chain is lost (spec
    /// `contact.md` 3.7).
    NextLosesSliding,
}

/// What becomes of edges without neighbour when joints are inserted.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interfaces {
    /// Free edges.
    Free,
    /// Edges that coincide with one of another meshing set become pre-existing
    /// fractures (spec `mechanics.md` 5.3).
    Fractures,
}

/// When a stored kinetic energy is replaced, by its relative change.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Refresh {
    /// From the threshold on.
    AtThreshold,
    /// Above the threshold only.
    AboveThreshold,
}

/// When history lines are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum HistoryLines {
    /// At every hundredth step.
    EveryHundredSteps,
    /// At every step that refreshed the value.
    WhenRefreshed,
}

/// Which state a result file of a step shows.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutputTime {
    /// Before the nodes move.
    BeforeMotion,
    /// After the nodes have moved; the time is still the step's.
    AfterMotion,
}

/// The conventions of a dialect.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Conventions {
    /// Whose they are: decides keywords and files, nothing in between.
    pub dialect: Dialect,
    /// Stress of the elastic triangle.
    pub volumetric: VolumetricShare,
    /// Answer of tetrahedra to a change of volume.
    pub solid_volumetric: Volumetric,
    /// Law of joints.
    pub cohesive: CohesiveModel,
    /// Order of internal forces.
    pub forces: ForceOrder,
    /// Triangles in contact.
    pub selection: ContactSelection,
    /// Contact of bonded triangles.
    pub bonded: BondedPairs,
    /// Sum of contact forces.
    pub contact_sum: ContactSum,
    /// Dropped couples.
    pub after_drop: ChainAfterDrop,
    /// Edges between meshing sets.
    pub interfaces: Interfaces,
    /// Stored kinetic energies.
    pub energy_refresh: Refresh,
    /// History lines.
    pub history_lines: HistoryLines,
    /// States in result files.
    pub output: OutputTime,
}

impl Conventions {
    /// Split dialect (spec `y2d3d.md`).
    pub const SPLIT: Self = Self {
        dialect: Dialect::Split,
        volumetric: VolumetricShare::Half,
        solid_volumetric: Volumetric::Difference,
        cohesive: CohesiveModel::Split,
        forces: ForceOrder::TrianglesThenJoints,
        selection: ContactSelection::Tagged,
        bonded: BondedPairs::MayTouch,
        contact_sum: ContactSum::WithInternal,
        after_drop: ChainAfterDrop::Untouched,
        interfaces: Interfaces::Free,
        energy_refresh: Refresh::AtThreshold,
        history_lines: HistoryLines::EveryHundredSteps,
        output: OutputTime::BeforeMotion,
    };

    /// Y-Geo (spec `mechanics.md`, `contact.md`: YG).
    pub const Y_GEO: Self = Self {
        dialect: Dialect::YGeo,
        volumetric: VolumetricShare::Whole,
        cohesive: CohesiveModel::YGeo,
        selection: ContactSelection::Flagged,
        history_lines: HistoryLines::WhenRefreshed,
        output: OutputTime::AfterMotion,
        ..Self::SPLIT
    };

    /// Classic (spec `mechanics.md`, `contact.md`: CL).
    pub const CLASSIC: Self = Self {
        dialect: Dialect::Classic,
        cohesive: CohesiveModel::Classic,
        forces: ForceOrder::PropertyByProperty,
        bonded: BondedPairs::Excluded,
        contact_sum: ContactSum::Apart,
        after_drop: ChainAfterDrop::NextLosesSliding,
        interfaces: Interfaces::Fractures,
        energy_refresh: Refresh::AboveThreshold,
        ..Self::Y_GEO
    };

    /// The `.Y3D` lineage (spec `y3d.md`).
    pub const Y3D: Self = Self {
        dialect: Dialect::Y3d,
        solid_volumetric: Volumetric::Logarithm,
        selection: ContactSelection::Bodies,
        ..Self::SPLIT
    };

    /// The row of a dialect.
    #[must_use]
    pub fn of(dialect: Dialect) -> Self {
        match dialect {
            Dialect::Split => Self::SPLIT,
            Dialect::YGeo => Self::Y_GEO,
            Dialect::Classic => Self::CLASSIC,
            Dialect::Y3d => Self::Y3D,
        }
    }

    /// Property code of an element as decks and state files of the dialect show
    /// it (spec `deck.md` 8.2).
    #[must_use]
    pub fn property_code(&self, property: i32, kind: super::JointKind, materials: usize) -> i32 {
        use super::JointKind::{Broken, FreeEdge};
        match (self.dialect, kind) {
            (_, super::JointKind::NoJoint) => property,
            (Dialect::Split, FreeEdge) => SPLIT_FREE_EDGE,
            (Dialect::Split, Broken) => SPLIT_BROKEN,
            (Dialect::YGeo, Broken) => property - BROKEN_OFFSET,
            (Dialect::Classic, _) => property - materials as i32,
            _ => property,
        }
    }
}

/// Code of broken joints in the split dialect.
pub const SPLIT_BROKEN: i32 = -1001;
/// Code of joints on free edges in the split dialect.
pub const SPLIT_FREE_EDGE: i32 = -1000;
/// What Y-Geo subtracts from the code of a joint that breaks.
pub const BROKEN_OFFSET: i32 = 1000;
