//! What is varied.

/// A setting of a deck that decides about accuracy and cost. All are given without dimension, so
/// that problems can be compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Parameter {
    /// `DCSTEC` by the longest stable time step
    /// ([`TimeStepBounds::together_s`](crate::meshing::TimeStepBounds)).
    TimeStep,
    /// `D1PEPE` by Young's modulus; `D1PEPT` keeps its ratio to it.
    Penalty,
    /// `DIEZON` by the mean height of the triangles.
    Buffer,
    /// Cells along an edge by those of the problem's coarsest mesh.
    Mesh,
    /// `D1PEKS` by 2 h √(E ρ), h being the mean height of the triangles.
    Viscosity,
}

impl Parameter {
    /// All of them.
    pub const ALL: [Self; 5] =
        [Self::TimeStep, Self::Penalty, Self::Buffer, Self::Mesh, Self::Viscosity];

    /// Name in file names.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::TimeStep => "time-step",
            Self::Penalty => "penalty",
            Self::Buffer => "diezon",
            Self::Mesh => "mesh",
            Self::Viscosity => "viscosity",
        }
    }

    /// What an axis says.
    #[must_use]
    pub fn label(self) -> &'static str {
        match self {
            Self::TimeStep => "time step by the stable one",
            Self::Penalty => "penalty by Young's modulus",
            Self::Buffer => "DIEZON by the height of triangles",
            Self::Mesh => "cells by those of the coarsest mesh",
            Self::Viscosity => "D1PEKS by 2 h √(E ρ)",
        }
    }

    /// Values that are tried. Time steps beyond 1 are there to show where the bound lies.
    #[must_use]
    pub fn values(self) -> &'static [f64] {
        match self {
            Self::TimeStep => &[0.02, 0.05, 0.1, 0.2, 0.4, 0.6, 0.8, 0.95, 1.05, 1.2, 1.5],
            Self::Penalty => &[0.1, 0.3, 1.0, 3.0, 10.0, 30.0, 100.0],
            Self::Buffer => &[0.003, 0.01, 0.03, 0.1, 0.2, 0.4, 0.8, 1.6],
            Self::Mesh => &[1.0, 2.0, 4.0, 8.0],
            Self::Viscosity => &[0.003, 0.01, 0.03, 0.1, 0.3, 1.0, 3.0],
        }
    }

    /// What the generators choose: `None` where each kind of structure has its own value.
    #[must_use]
    pub fn of_generators(self) -> Option<f64> {
        match self {
            Self::Buffer => Some(0.1),
            Self::Mesh | Self::Viscosity => Some(1.0),
            // the step is rounded to a digit, penalties are those of the kinds of structures
            Self::TimeStep | Self::Penalty => None,
        }
    }
}

/// Settings of one solution; what is not given is as the generator of the structure makes it.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub struct Settings {
    /// See [`Parameter::TimeStep`].
    pub time_step: Option<f64>,
    /// See [`Parameter::Penalty`].
    pub penalty: Option<f64>,
    /// See [`Parameter::Buffer`].
    pub buffer: Option<f64>,
    /// See [`Parameter::Mesh`]; rounded.
    pub mesh: Option<f64>,
    /// See [`Parameter::Viscosity`].
    pub viscosity: Option<f64>,
}

impl Settings {
    /// The same with one setting given.
    #[must_use]
    pub fn with(mut self, parameter: Parameter, value: f64) -> Self {
        let own = match parameter {
            Parameter::TimeStep => &mut self.time_step,
            Parameter::Penalty => &mut self.penalty,
            Parameter::Buffer => &mut self.buffer,
            Parameter::Mesh => &mut self.mesh,
            Parameter::Viscosity => &mut self.viscosity,
        };
        *own = Some(value);
        self
    }
}
