//! Settings that the curves of work-precision speak for, without dimension as in
//! [`Parameter`]. Figures are those of `docs/src/work-precision.md`.

use super::settings::{Parameter, Settings};

/// What a run is made for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Purpose {
    /// Bodies come to rest, or are moved slowly: settlement, static loads, sliding to a stop.
    Rest,
    /// Bodies collide, swing, carry waves.
    Motion,
}

/// Time step by the stable one where bodies come to rest. Up to the bound it decides about
/// nothing else: `self-weight` and `two-bars` have the same error to three digits from 0.1 to 0.95
/// of it, and `self-weight` is unstable at 1.05.
pub const TIME_STEP_AT_REST: f64 = 0.75;

/// Time step by the stable one where bodies collide. `impact` keeps its energy to 0.1 % at 0.2, to
/// 0.4 % at 0.4, and gains half of it at 0.7: an edge that enters a triangle within one step is
/// pushed out with more than it brought.
pub const TIME_STEP_IN_MOTION: f64 = 0.2;

/// Contact penalty by Young's modulus. Each contact is as soft as a layer of thickness
/// h E/(6 D1PEPE), h being the height of its triangles, so that errors go with 1/D1PEPE:
/// `self-weight` sinks 53 % too far at 0.4 and 2.6 % at 10, `two-bars` is wrong by 0.06 % at 10.
/// Compared with 0.4 steps become 1.8 times as many. Beyond 10 `self-weight` gains a factor 3.6
/// for 2.5 times the steps: the mesh is what is left of its error.
pub const PENALTY: f64 = 10.0;

/// DIEZON by the mean height of the triangles. It decides about no error: the curves are flat to
/// nine digits. `impact` with 1024 triangles takes 1.9 times as long at 0.003, where detections are
/// many, and 1.3 times from 0.8 on, where couples are; between 0.03 and 0.4 nothing is gained.
pub const BUFFER: f64 = 0.1;

/// D1PEKS by 2 h √(E ρ) where bodies come to rest. With a tenth `self-weight` still swings after
/// 24 periods and `sliding-block` hops (2 % of the way), with three times as much the stable step
/// is a third.
pub const VISCOSITY_AT_REST: f64 = 1.0;

/// D1PEKS by 2 h √(E ρ) where waves are of interest. `bar-wave` with 8 triangles to its length
/// loses nothing at 0.03 and half of the wave at 1.
pub const VISCOSITY_OF_WAVES: f64 = 0.03;

/// What is recommended for a purpose.
#[must_use]
pub fn recommended(purpose: Purpose, parameter: Parameter) -> Option<f64> {
    Some(match (parameter, purpose) {
        (Parameter::TimeStep, Purpose::Rest) => TIME_STEP_AT_REST,
        (Parameter::TimeStep, Purpose::Motion) => TIME_STEP_IN_MOTION,
        (Parameter::Penalty, _) => PENALTY,
        (Parameter::Buffer, _) => BUFFER,
        (Parameter::Viscosity, Purpose::Rest) => VISCOSITY_AT_REST,
        (Parameter::Viscosity, Purpose::Motion) => VISCOSITY_OF_WAVES,
        (Parameter::Mesh, _) => return None,
    })
}

/// Settings with all that is recommended for some parameters.
#[must_use]
pub fn settings(purpose: Purpose, parameters: impl IntoIterator<Item = Parameter>) -> Settings {
    parameters.into_iter().fold(Settings::default(), |settings, parameter| {
        match recommended(purpose, parameter) {
            Some(value) => settings.with(parameter, value),
            None => settings,
        }
    })
}
