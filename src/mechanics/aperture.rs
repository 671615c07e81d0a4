//! Aperture of rock fractures by Barton and Bandis, as the classic dialect
//! computes it (spec `mechanics.md` 7.10): closure under normal stress, dilation
//! and mobilised roughness under shear, hydraulic aperture.

use super::Vec2;
use crate::{TOLERANCE, scene::InitialAperture, scene::RockJoint};
use nalgebra::Matrix2;
use serde::{Deserialize, Serialize};

/// Stiffness of a joint before it is set up, Pa/m.
const STIFF: f64 = 1e15;

/// State of a rock fracture.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Aperture {
    /// Initial normal stiffness, Pa/m.
    pub initial_stiffness: f64,
    /// Normal stiffness, Pa/m.
    pub normal_stiffness: f64,
    /// Shear stiffness, Pa/m.
    pub shear_stiffness: f64,
    /// Normal stress, Pa, positive in compression.
    pub normal_stress: f64,
    /// Shear stress, Pa.
    pub shear_stress: f64,
    /// Mechanical aperture at the start, m.
    pub initial: f64,
    /// Mechanical aperture, m.
    pub current: f64,
    /// Hydraulic aperture, m.
    pub hydraulic: f64,
    /// Least mechanical aperture, m.
    pub residual: f64,
    /// Shear displacement, m.
    pub slip: f64,
    /// Dilation, m.
    pub dilation: f64,
    /// Shear displacement at the peak stress, as set up, m.
    pub peak_slip: f64,
    /// Length that roughness is scaled to, m.
    pub length: f64,
    /// Joint roughness coefficient at that length.
    pub roughness: f64,
    /// Joint wall strength at that length, MPa.
    pub wall_strength: f64,
    /// Mobilised asperity angle, degrees.
    pub asperity_angle: f64,
    /// How the joint failed: 0 not or before the run, 1 in tension, 2 in shear.
    pub failure_mode: f64,
    /// Pressure of the fluid in it, Pa.
    pub fluid_pressure: f64,
    /// Time at which the fluid entered, s.
    pub entry_time: f64,
}

impl Default for Aperture {
    fn default() -> Self {
        Self {
            initial_stiffness: STIFF,
            normal_stiffness: STIFF,
            shear_stiffness: 0.0,
            normal_stress: 0.0,
            shear_stress: 0.0,
            initial: 0.0,
            current: 0.0,
            hydraulic: 0.0,
            residual: 0.0,
            slip: 0.0,
            dilation: 0.0,
            peak_slip: 0.0,
            length: 0.0,
            roughness: 0.0,
            wall_strength: 0.0,
            asperity_angle: 0.0,
            failure_mode: 0.0,
            fluid_pressure: 0.0,
            entry_time: 0.0,
        }
    }
}

/// Initial normal stiffness by Bandis, Pa/m.
fn initial_stiffness(roughness: f64, wall_strength: f64, aperture: f64) -> f64 {
    (-7.15 + 1.75 * roughness + 0.02 * wall_strength / aperture * 1e-3) * 1e9
}

/// Shear displacement at the peak stress by Barton, m.
fn peak_slip(length: f64, roughness: f64) -> f64 {
    length / 500.0 * (roughness / length).powf(0.33)
}

impl Aperture {
    /// An intact joint: what its fracture would begin with.
    #[must_use]
    pub fn intact(rock: &RockJoint) -> Self {
        let (roughness, wall_strength) = (rock.roughness, rock.wall_strength);
        let initial = roughness / 50.0 * 1e-3;
        let residual = (-0.296 - 0.0056 * roughness
            + 2.241 * (wall_strength / initial * 1e-3).powf(-0.245))
            * 1e-3;
        let stiffness = initial_stiffness(roughness, wall_strength, initial);
        Self {
            initial_stiffness: stiffness,
            normal_stiffness: stiffness,
            initial,
            current: initial,
            residual: larger(initial / 10.0, residual),
            peak_slip: peak_slip(rock.sample_length, roughness),
            length: rock.sample_length,
            roughness,
            wall_strength,
            ..Self::default()
        }
    }

    /// A joint of an old fracture of length `section` between ends or
    /// intersections, on a straight line of fractures of length `line`.
    #[must_use]
    pub fn of_fracture(
        rock: &RockJoint,
        origin: InitialAperture,
        opening_energy: f64,
        section: f64,
        line: f64,
    ) -> Self {
        let exponent = |per_roughness: f64| per_roughness * rock.roughness;
        let scale = section / rock.sample_length;
        let roughness = rock.roughness * scale.powf(exponent(-0.02));
        let wall_strength = rock.wall_strength * scale.powf(exponent(-0.03));
        let closure = |aperture: f64| {
            (-0.1032 - 0.0074 * roughness
                + 1.1350 * (wall_strength / aperture * 1e-3).powf(-0.2510))
                * 1e-3
        };
        let (initial, residual) = match origin {
            InitialAperture::FromRoughness => {
                let initial = rock.roughness / 50.0 * 1e-3;
                let mut largest = closure(initial);
                if largest < 0.0 {
                    largest = 0.9 * initial;
                }
                (initial, initial - largest)
            }
            InitialAperture::FromLength => {
                let (lambda, mu) = (rock.lame_lambda, rock.shear_modulus);
                let young = mu * (3.0 * lambda + 2.0 * mu) / (lambda + mu);
                let poisson = lambda / (2.0 * (lambda + mu));
                let widest = (8.0 * opening_energy * (1.0 - poisson * poisson)
                    / (young * std::f64::consts::PI)
                    * line)
                    .sqrt();
                let residual = larger(widest / 10.0, widest - closure(widest));
                let mean = std::f64::consts::FRAC_PI_4;
                (mean * widest, mean * residual)
            }
        };
        let stiffness = initial_stiffness(roughness, wall_strength, initial);
        let microns = initial * 1e6;
        Self {
            initial_stiffness: stiffness,
            normal_stiffness: stiffness,
            initial,
            current: initial,
            residual,
            hydraulic: microns * microns / roughness.powf(2.5) / 1e6,
            peak_slip: peak_slip(section, roughness),
            length: section,
            roughness,
            wall_strength,
            ..Self::default()
        }
    }
}

/// What an open fracture sees in a step.
#[derive(Debug, Clone, Copy)]
pub struct Surroundings {
    /// Opening in the middle, m.
    pub opening: f64,
    /// Sliding in the middle with its sign, m.
    pub sliding: f64,
    /// Normal stress of the two triangles across their sides, Pa, tension positive.
    pub normal_stresses: [f64; 2],
    /// Pressure of the fluid, Pa.
    pub fluid_pressure: f64,
    /// Friction coefficient of smooth surfaces.
    pub residual_friction: f64,
}

/// Normal stress across a side from `from` to `to` under a stress, Pa.
#[must_use]
pub fn normal_stress(stress: &Matrix2<f64>, from: Vec2, to: Vec2) -> f64 {
    let (x, y) = (from.y - to.y, to.x - from.x);
    let length = (x * x + y * y).sqrt() + TOLERANCE;
    let (x, y) = (x / length, y / length);
    stress[(0, 0)] * x * x + 2.0 * stress[(0, 1)] * x * y + stress[(1, 1)] * y * y
}

/// Share of the roughness that is mobilised at points of relative shear displacement.
const MOBILISED: [(f64, f64); 7] =
    [(0.3, 0.0), (0.6, 0.75), (1.0, 1.0), (2.0, 0.85), (4.0, 0.7), (10.0, 0.5), (100.0, 0.0)];

/// Share of the roughness that is mobilised; `start` is the value without displacement.
fn mobilised(relative: f64, start: f64) -> f64 {
    let mut before = (0.0, start);
    for point in MOBILISED {
        if relative < point.0 {
            return point.1 - (point.0 - relative) / (point.0 - before.0) * (point.1 - before.1);
        }
        before = point;
    }
    0.0
}

impl Aperture {
    /// Takes the fracture through a step.
    pub fn update(&mut self, seen: &Surroundings) {
        self.fluid_pressure = seen.fluid_pressure;
        if seen.opening < 0.0 {
            self.close(seen);
        } else {
            self.open(seen);
        }
    }

    fn open(&mut self, seen: &Surroundings) {
        self.normal_stiffness = self.initial_stiffness;
        self.shear_stiffness = 0.0;
        self.current = seen.opening + self.initial;
        let microns = self.initial * 1e6;
        self.hydraulic = seen.opening + microns * microns / self.roughness.powf(2.5) / 1e6;
        self.slip = seen.sliding;
        self.normal_stress = 0.0;
        self.shear_stress = 0.0;
    }

    fn close(&mut self, seen: &Surroundings) {
        let [first, second] = seen.normal_stresses;
        let mut stress = -0.5 * (first + second) - seen.fluid_pressure;
        if stress <= 0.0 {
            stress = TOLERANCE;
        }
        let (jrc, jcs) = (self.roughness, self.wall_strength);
        let ratio = (jcs * 1e6 / stress).log10();
        let friction = seen.residual_friction.atan().to_degrees();
        let (before, slip) = (self.slip, seen.sliding);
        let moved = (slip - before).abs();
        let stress_change = stress - self.normal_stress;
        let peak = larger(
            TOLERANCE,
            0.0077
                * self.length.powf(0.45)
                * (stress / jcs / 1e6).powf(0.34)
                * (jrc * ratio).to_radians().cos(),
        );
        let relative = (slip / peak).abs();
        let mobilised_roughness = jrc * mobilised(relative, -friction / (jrc * ratio));
        let damage = jrc / 12.0 / ratio + 0.70;
        let asperity = mobilised_roughness * ratio;
        let dilatancy = (asperity / damage).to_radians().tan();
        let range = self.initial - self.residual;
        let stiff = stress + self.initial_stiffness * range;
        let normal = stiff * stiff / self.initial_stiffness / (range * range);
        let shear_stress = stress * (asperity + friction).to_radians().tan();
        let cross = normal * dilatancy;
        let (dilation, closure);
        if (slip - before) * before >= 0.0 {
            dilation = self.dilation + moved * dilatancy;
            closure = (stress_change - cross * moved) / normal;
        } else if before * slip >= 0.0 {
            dilation = self.dilation - moved * dilatancy;
            closure = (stress_change + cross * moved) / normal;
        } else {
            dilation = slip.abs() * dilatancy;
            closure = (stress_change + cross * before.abs() - cross * slip.abs()) / normal;
        }
        let aperture = larger(self.residual, self.current - closure);
        self.shear_stiffness = (shear_stress - self.shear_stress) / moved;
        self.hydraulic = hydraulic(aperture, relative, jrc, mobilised_roughness);
        self.asperity_angle = asperity;
        self.normal_stiffness = stiff / range;
        (self.dilation, self.current, self.slip) = (dilation, aperture, slip);
        (self.normal_stress, self.shear_stress) = (stress, shear_stress);
    }
}

/// Hydraulic aperture of a closed fracture, m: never wider than the mechanical one.
fn hydraulic(aperture: f64, relative: f64, roughness: f64, mobilised: f64) -> f64 {
    let microns = aperture * 1e6;
    let unsheared = microns * microns / roughness.powf(2.5);
    let sheared = microns.sqrt() * mobilised;
    let width = if relative < 0.75 {
        unsheared / 1e6
    } else if relative > 1.0 {
        sheared / 1e6
    } else {
        let share = (1.0 - relative) / 0.25;
        ((1.0 - share) * sheared + share * unsheared) / 1e6
    };
    if width > aperture { aperture } else { width }
}

fn larger(a: f64, b: f64) -> f64 {
    if a < b { b } else { a }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Barton's table of mobilised roughness, between and on its points.
    #[test]
    fn roughness_is_mobilised_as_barton_says() {
        assert_eq!(mobilised(0.0, -0.5), -0.5);
        assert!((mobilised(0.15, -0.5) + 0.25).abs() < 1e-15);
        assert_eq!(mobilised(1.0, -0.5), 1.0);
        assert!((mobilised(3.0, -0.5) - 0.775).abs() < 1e-15);
        assert_eq!(mobilised(200.0, -0.5), 0.0);
    }

    /// A closed fracture under growing stress closes, but not below its residual aperture.
    #[test]
    fn fractures_close_under_normal_stress() {
        let rock = RockJoint {
            roughness: 15.0,
            wall_strength: 120.0,
            sample_length: 0.2,
            ..RockJoint::default()
        };
        let mut fracture =
            Aperture::of_fracture(&rock, InitialAperture::FromRoughness, 0.0, 0.5, 0.5);
        assert!((fracture.initial - 3e-4).abs() < 1e-18);
        let mut last = fracture.current;
        for step in 1..=1000 {
            let stress = f64::from(step) * -4e4;
            fracture.update(&Surroundings {
                opening: -1e-9,
                sliding: 0.0,
                normal_stresses: [stress; 2],
                fluid_pressure: 0.0,
                residual_friction: 0.5,
            });
            assert!(
                fracture.current <= last && fracture.current >= fracture.residual,
                "{fracture:?}"
            );
            last = fracture.current;
        }
        // Bandis: σ v / (k v + σ), which the small steps follow closely
        let range = fracture.initial - fracture.residual;
        let closure = 40e6 * range / (fracture.initial_stiffness * range + 40e6);
        assert!((fracture.initial - last - closure).abs() < 0.05 * closure, "{last}");
    }
}
