//! The longest time step at which no mode of a system grows.

use super::{
    lanczos::{Mode, highest},
    system::{Share, System, Weights},
};
use std::collections::BTreeMap;

/// Critical time steps, s; infinite where nothing limits the step.
#[derive(Debug, Clone, PartialEq)]
pub struct Limits {
    /// Of the elasticity of elements alone.
    pub elements_s: f64,
    /// With intact joints.
    pub joints_s: f64,
    /// With contacts that are closed at the start, too.
    pub contact_s: f64,
    /// Of viscosity alone.
    pub viscosity_s: f64,
    /// Of all of it: the critical time step of the scene as it stands.
    pub critical_s: f64,
    /// The same if every free edge or face is pressed by one like it: what the run may come to.
    pub impact_s: f64,
    /// Relative error of `critical_s`, as far as the iteration knows.
    pub error: f64,
    /// What sets the critical step.
    pub set_by: Option<Culprit>,
}

/// The part with the largest share of the mode that grows first.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Culprit {
    /// Stiffness or viscosity of which part.
    pub part: Share,
    /// Its share of the mode's energy.
    pub share: f64,
}

const ELASTIC: Weights =
    Weights { elastic: 1.0, viscous: 0.0, joints: 0.0, contact: 0.0, impact: 0.0 };
const JOINTED: Weights = Weights { joints: 1.0, ..ELASTIC };
const TOUCHING: Weights = Weights { contact: 1.0, ..JOINTED };
const VISCOUS: Weights =
    Weights { elastic: 0.0, viscous: 1.0, joints: 0.0, contact: 0.0, impact: 0.0 };
const PRESSED: Weights = Weights { impact: 1.0, ..TOUCHING };

impl Limits {
    /// Those of a system.
    ///
    /// The step takes v ← v − Δt M⁻¹(K x + C v), then x ← x + Δt v: viscous forces are those of
    /// the old velocity. A vibration that changes its sign in every step neither grows nor decays
    /// where det(4 M − 2 Δt C − Δt² K) = 0, and for symmetric K and C that are not negative this
    /// is the first instability: the critical Δt is the smallest at which the largest eigenvalue
    /// of M⁻¹(Δt² K + 2 Δt C) is 4. For one mode that is ω² Δt² + 2 γ Δt = 4.
    #[must_use]
    pub fn of<const D: usize>(system: &System<D>) -> Self {
        let of_stiffness = |weights: &Weights| {
            highest(system, weights).map_or(f64::INFINITY, |mode| 2.0 / mode.value.sqrt())
        };
        let elements_s = of_stiffness(&ELASTIC);
        let has = |weights: Weights| system.has(&weights);
        let joints_s = match has(Weights { joints: 1.0, ..Weights::default() }) {
            true => of_stiffness(&JOINTED),
            false => elements_s,
        };
        let contact_s = match has(Weights { contact: 1.0, ..Weights::default() }) {
            true => of_stiffness(&TOUCHING),
            false => joints_s,
        };
        let viscosity_s = highest(system, &VISCOUS).map_or(f64::INFINITY, |mode| 2.0 / mode.value);
        let touching = together(system, &TOUCHING, contact_s, viscosity_s);
        let impact_s = match has(Weights { impact: 1.0, ..Weights::default() }) {
            true => {
                let alone_s = of_stiffness(&PRESSED);
                together(system, &PRESSED, alone_s, viscosity_s).step_s
            }
            false => touching.step_s,
        };
        Self {
            elements_s,
            joints_s,
            contact_s,
            viscosity_s,
            critical_s: touching.step_s,
            impact_s,
            error: touching.error,
            set_by: touching.set_by,
        }
    }
}

struct Together {
    step_s: f64,
    error: f64,
    set_by: Option<Culprit>,
}

/// The step at which stiffness and viscosity together are critical; each alone is so at the steps
/// given.
fn together<const D: usize>(
    system: &System<D>,
    stiffness: &Weights,
    stiffness_s: f64,
    viscosity_s: f64,
) -> Together {
    // as if one mode had the largest of both: not too long
    let (omega, gamma) = (2.0 / stiffness_s, 2.0 / viscosity_s);
    let mut step = root(omega * omega, gamma);
    if !step.is_finite() {
        return Together { step_s: f64::INFINITY, error: 0.0, set_by: None };
    }
    let mut set_by = None;
    let mut error = 0.0;
    for _ in 0..MOST_ROUNDS {
        let weights = scaled(stiffness, step);
        let Some(mode) = highest(system, &weights) else { break };
        let energies = system.energies(&weights, &mode.shape);
        set_by = culprit(&energies);
        error = mode.error;
        let next = step_of_mode(&energies, &mode, step);
        let change = (next / step - 1.0).abs();
        step = next;
        if change < 1e-3 {
            break;
        }
    }
    Together { step_s: step, error, set_by }
}

const MOST_ROUNDS: usize = 8;

fn scaled(stiffness: &Weights, step: f64) -> Weights {
    let square = step * step;
    Weights {
        elastic: square * stiffness.elastic,
        viscous: 2.0 * step,
        joints: square * stiffness.joints,
        contact: square * stiffness.contact,
        impact: square * stiffness.impact,
    }
}

/// ω² Δt² + 2 γ Δt = 4, without cancellation.
fn root(stiffness: f64, damping: f64) -> f64 {
    4.0 / (damping + (damping * damping + 4.0 * stiffness).sqrt())
}

/// The critical step of a mode, from the parts of its eigenvalue at another step.
fn step_of_mode<const D: usize>(energies: &[(Share, f64)], mode: &Mode<D>, step: f64) -> f64 {
    let total: f64 = energies.iter().map(|(_, energy)| energy).sum();
    let viscous: f64 = energies
        .iter()
        .filter(|(part, _)| matches!(part, Share::Viscosity(_)))
        .map(|(_, energy)| energy)
        .sum();
    let share = if total > 0.0 { viscous / total } else { 0.0 };
    let damping = share * mode.value / (2.0 * step);
    let stiffness = (1.0 - share) * mode.value / (step * step);
    root(stiffness, damping)
}

fn culprit(energies: &[(Share, f64)]) -> Option<Culprit> {
    let total: f64 = energies.iter().map(|(_, energy)| energy).sum();
    // a pair in contact has several springs
    let mut sums: BTreeMap<(u8, [usize; 2]), (Share, f64)> = BTreeMap::new();
    for &(part, energy) in energies {
        sums.entry(key(part)).or_insert((part, 0.0)).1 += energy;
    }
    let largest = sums.into_values().reduce(|a, b| if b.1 > a.1 { b } else { a });
    largest.filter(|_| total > 0.0).map(|(part, energy)| Culprit { part, share: energy / total })
}

fn key(share: Share) -> (u8, [usize; 2]) {
    use super::system::Part;
    let of = |part: Part| match part {
        Part::Element(e) => (0, [e, 0]),
        Part::Joint(e) => (1, [e, 0]),
        Part::Contact(pair) => (2, pair),
        Part::Impact(e) => (3, [e, 0]),
    };
    match share {
        Share::Stiffness(part) => of(part),
        Share::Viscosity(part) => (4 + of(part).0, of(part).1),
    }
}
