//! What bodies, joints and contacts are made of.

use super::MeshingError;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// An elastic material and its contact.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Material {
    /// Young's modulus \[Pa\].
    pub young_pa: f64,
    /// Poisson's ratio.
    pub poisson: f64,
    /// Density \[kg/m³\].
    pub density_kg_m3: f64,
    /// Coulomb's coefficient of friction of contacts.
    pub friction: f64,
    /// Normal contact penalty \[Pa\].
    pub penalty_pa: f64,
    /// Tangential contact penalty \[Pa\].
    pub tangential_penalty_pa: f64,
    /// Viscosity \[Pa s\]; 2 h √(E ρ) with the mean height h of the triangles if it is not given.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub viscosity_pa_s: Option<f64>,
    /// Part of the viscosity that the smallest triangles get.
    pub small_viscosity_factor: f64,
}

impl Default for Material {
    /// The stone of the bridges.
    fn default() -> Self {
        Material {
            young_pa: 25e9,
            poisson: 0.2,
            density_kg_m3: 2400.0,
            friction: 0.57,
            penalty_pa: 10e9,
            tangential_penalty_pa: 5e9,
            viscosity_pa_s: None,
            small_viscosity_factor: 0.2,
        }
    }
}

impl Material {
    /// The soil beside the bridges.
    #[must_use]
    pub fn soil() -> Self {
        Material { young_pa: 0.24e9, density_kg_m3: 1800.0, ..Material::default() }
    }

    /// Lamé's first parameter λ \[Pa\].
    #[must_use]
    pub fn lambda(&self) -> f64 {
        self.young_pa * self.poisson / ((1.0 + self.poisson) * (1.0 - 2.0 * self.poisson))
    }

    /// The shear modulus μ \[Pa\].
    #[must_use]
    pub fn mu(&self) -> f64 {
        self.young_pa / (2.0 * (1.0 + self.poisson))
    }

    /// Viscosity of triangles whose mean height is given \[Pa s\].
    #[must_use]
    pub fn viscosity(&self, height: f64) -> f64 {
        let own = 2.0 * height * (self.young_pa * self.density_kg_m3).sqrt();
        self.viscosity_pa_s.unwrap_or(own)
    }

    pub(super) fn check(&self, table: &str) -> Result<(), MeshingError> {
        let name = |key: &str| format!("{table}.{key}");
        positive(&name("young_pa"), self.young_pa)?;
        positive(&name("density_kg_m3"), self.density_kg_m3)?;
        positive(&name("penalty_pa"), self.penalty_pa)?;
        positive(&name("tangential_penalty_pa"), self.tangential_penalty_pa)?;
        not_negative(&name("friction"), self.friction)?;
        not_negative(&name("viscosity_pa_s"), self.viscosity_pa_s.unwrap_or(0.0))?;
        not_negative(&name("small_viscosity_factor"), self.small_viscosity_factor)?;
        if !(0.0..0.5).contains(&self.poisson) {
            let expected = "a Poisson's ratio lies from 0 to below 0.5";
            return Err(MeshingError::parameter(&name("poisson"), self.poisson, expected));
        }
        Ok(())
    }
}

/// A joint that softens and breaks.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Joint {
    /// Tensile strength \[Pa\].
    pub tensile_pa: f64,
    /// Shear strength without normal stress (cohesion) \[Pa\].
    pub cohesion_pa: f64,
    /// Coefficient of friction: what compression adds to the shear strength.
    pub friction: f64,
    /// Fracture energy \[N/m\].
    pub fracture_energy_n_m: f64,
    /// Penalty \[Pa\]: the joint's stiffness times its length.
    pub penalty_pa: f64,
}

impl Default for Joint {
    /// The mortar of the bridges.
    fn default() -> Self {
        Joint {
            tensile_pa: 0.2e6,
            cohesion_pa: 0.23e6,
            friction: 0.57,
            fracture_energy_n_m: 0.5,
            penalty_pa: 8e9,
        }
    }
}

impl Joint {
    /// What holds the triangles of a stone of the bridges together.
    #[must_use]
    pub fn inside_stone() -> Self {
        Joint {
            tensile_pa: 3e6,
            cohesion_pa: 2e12,
            friction: 0.57,
            fracture_energy_n_m: 7.5,
            penalty_pa: 141e9,
        }
    }

    pub(super) fn check(&self, table: &str) -> Result<(), MeshingError> {
        let name = |key: &str| format!("{table}.{key}");
        positive(&name("tensile_pa"), self.tensile_pa)?;
        positive(&name("cohesion_pa"), self.cohesion_pa)?;
        positive(&name("fracture_energy_n_m"), self.fracture_energy_n_m)?;
        positive(&name("penalty_pa"), self.penalty_pa)?;
        not_negative(&name("friction"), self.friction)
    }
}

/// Checks that a number is above 0.
pub(super) fn positive(name: &str, value: f64) -> Result<(), MeshingError> {
    if value.is_finite() && value > 0.0 {
        return Ok(());
    }
    Err(MeshingError::parameter(name, value, "a number above 0 is needed"))
}

/// Checks that a number is 0 or above.
pub(super) fn not_negative(name: &str, value: f64) -> Result<(), MeshingError> {
    if value.is_finite() && value >= 0.0 {
        return Ok(());
    }
    Err(MeshingError::parameter(name, value, "a number that is not negative is needed"))
}

/// Checks that a count lies within sensible bounds.
pub(super) fn count(name: &str, value: usize, least: usize) -> Result<(), MeshingError> {
    if (least..=MOST).contains(&value) {
        return Ok(());
    }
    let expected = format!("a number from {least} to {MOST} is needed");
    Err(MeshingError::parameter(name, value, &expected))
}

/// Checks the size of a mesh before it is made: elements that are there, and a product of numbers that
/// are to come.
pub(super) fn check_elements(present: usize, more: &[usize]) -> Result<(), MeshingError> {
    let elements = present as f64 + more.iter().map(|&n| n as f64).product::<f64>();
    let most = MOST_ELEMENTS;
    if elements <= most { Ok(()) } else { Err(MeshingError::TooLarge { elements, most }) }
}

/// Most elements of a mesh: as many take tens of gigabytes.
const MOST_ELEMENTS: f64 = 2e7;
/// Most courses, blocks in a row, voussoirs.
const MOST: usize = 2000;
