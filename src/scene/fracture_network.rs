//! Discrete fracture network of Y-Geo (spec `mechanics.md` 7.5): fractures that
//! are there before the run, named by the nodes that they pass.

use super::{CohesiveLaw, PairProperties};

/// What the joints on a fracture are at the start.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FractureTreatment {
    /// Broken.
    Broken,
    /// Cohesive, with the network's strengths.
    Cohesive,
    /// As everywhere else.
    Ordinary,
}

/// Fractures and their properties.
#[derive(Debug, Clone, PartialEq)]
pub struct FractureNetwork {
    /// What the joints on all fractures are; `None` where each fracture has its own.
    pub common: Option<FractureTreatment>,
    /// The fractures.
    pub fractures: Vec<Fracture>,
    /// Tensile strength of cohesive fractures, Pa.
    pub tensile_strength: f64,
    /// Cohesion of cohesive fractures, Pa.
    pub cohesion: f64,
    /// Mode I fracture energy of cohesive fractures, J/m².
    pub fracture_energy: f64,
    /// Mode II fracture energy of cohesive fractures, J/m².
    pub shear_fracture_energy: f64,
}

/// A fracture of the network.
#[derive(Debug, Clone, PartialEq)]
pub struct Fracture {
    /// Nodes of the mesh before insertion that it passes.
    pub nodes: Vec<usize>,
    /// Contact between triangles along it, if the network gives it.
    pub contact: PairProperties,
    /// What its joints are.
    pub treatment: FractureTreatment,
}

impl FractureNetwork {
    /// What the joints on a fracture are at the start.
    #[must_use]
    pub fn treatment(&self, fracture: usize) -> FractureTreatment {
        let own =
            || self.fractures.get(fracture).map_or(FractureTreatment::Ordinary, |f| f.treatment);
        self.common.unwrap_or_else(own)
    }

    /// The law of a joint on a cohesive fracture whose joint set has `law`. As
    /// in the original the peak stress stays that of the joint set: the
    /// network's tensile strength sets peak opening and softening extent only.
    #[must_use]
    pub fn cohesive_law(&self, law: &CohesiveLaw) -> CohesiveLaw {
        CohesiveLaw {
            peak_strength: self.tensile_strength,
            fracture_energy: self.fracture_energy,
            shear_fracture_energy: self.shear_fracture_energy,
            cohesion: self.cohesion,
            layering: None,
            ..law.clone()
        }
    }
}

/// How the kinetic energy that a breaking joint releases is measured (spec
/// `mechanics.md` 7.8).
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub enum SeismicMethod {
    /// The largest rise since the joint began to yield.
    #[default]
    SinceYield,
    /// The largest rise within windows of this length, s.
    Window(f64),
    /// The energy at failure.
    AtFailure,
}
