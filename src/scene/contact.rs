use super::ContactSelection;
use serde::{Deserialize, Serialize};

/// Penalties and friction of a pair of materials.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairProperties {
    /// Normal penalty, Pa.
    pub penalty: f64,
    /// Tangential penalty, Pa.
    pub tangential_penalty: f64,
    /// Coulomb friction coefficient.
    pub friction: f64,
}

/// Contact properties of one pair of materials.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairRow {
    /// The two materials, the lower number first.
    pub materials: [i64; 2],
    /// Their properties.
    pub properties: PairProperties,
}

/// Where the contact properties of two materials come from.
#[derive(Debug, Clone, PartialEq)]
pub enum PairRule {
    /// The smaller value of each property of the two materials (split).
    SmallerOfEach,
    /// The smaller penalty, a tenth of it along the surface; the material's own
    /// friction inside it, the smaller interface friction between two (classic).
    InterfaceFriction,
    /// A table whose last matching row counts; pairs without row take what the
    /// pair before them had (Y-Geo).
    Table(Vec<PairRow>),
}

impl PairRule {
    /// What a pair without row takes if no pair before it has one (spec
    /// `contact.md` 3.1).
    pub const UNLISTED: PairProperties =
        PairProperties { penalty: 2e6, tangential_penalty: 1e6, friction: 0.0 };
}

/// How friction limits tangential contact forces.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FrictionModel {
    /// Coulomb's law on the accumulated sliding.
    #[default]
    Coulomb,
    /// Along fractures the friction angle of Barton and Bandis, fully
    /// mobilised (classic, spec `contact.md` 3.6).
    BartonBandis,
}

/// Which faces of two tetrahedra are pressed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub enum PressedFaces {
    /// Those of the element with the higher number, as in the original (spec `y2d3d.md` E.4).
    #[default]
    Contactor,
    /// Those of both, and the energy of each body counts: forces are the gradient of a potential
    /// and do not depend on the numbering.
    Both,
}

/// Contact of tetrahedra beyond the original's law. The default is that law.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default, Serialize, Deserialize)]
pub struct SpatialContact {
    /// Which faces are pressed.
    pub pressed: PressedFaces,
    /// Whether Coulomb friction acts, with tangential penalty and friction coefficient of the pair.
    pub has_friction: bool,
}

/// Settings of contact detection and of the couple list.
#[derive(Debug, Clone, PartialEq)]
pub struct ContactSettings {
    /// Buffer around elements, m: detection is due when the accumulated travel
    /// reaches it, and separated couples are dropped at twice this distance.
    pub buffer: f64,
    /// Travel accumulated since the last detection at the start, m; a value of
    /// at least `buffer` forces detection in the first step.
    pub initial_travel: f64,
    /// Which triangles take part.
    pub selection: ContactSelection,
    /// Contact properties of pairs of materials.
    pub pairs: PairRule,
    /// Friction along fractures.
    pub friction: FrictionModel,
    /// Sliding of the couple slots at the start, m².
    pub initial_sliding: Vec<[f64; 6]>,
    /// Contact of tetrahedra.
    pub spatial: SpatialContact,
}
