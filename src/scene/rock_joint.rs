//! Fractures in rock: roughness, aperture, fluid (classic, spec `mechanics.md` 7.10).

/// Properties of the fractures of a joint set.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct RockJoint {
    /// Joint roughness coefficient JRC of the laboratory sample.
    pub roughness: f64,
    /// Joint wall compressive strength JCS of the sample, MPa.
    pub wall_strength: f64,
    /// Length of the sample, m.
    pub sample_length: f64,
    /// Pressure of the fluid in open fractures, Pa.
    pub fluid_pressure: f64,
    /// First Lamé constant of the rock, Pa.
    pub lame_lambda: f64,
    /// Shear modulus of the rock, Pa.
    pub shear_modulus: f64,
}

/// Where the initial aperture of pre-existing fractures comes from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum InitialAperture {
    /// From roughness and wall strength.
    #[default]
    FromRoughness,
    /// From the length of the fracture.
    FromLength,
}
