use crate::{
    bench::work_precision::{Answer, InPlane, Parameter, Problem, Run, recommendations::Purpose},
    meshing::{Material, Scenario, kinds::TwoBars},
    scene::Scene,
};
use std::f64::consts::PI;

/// A stress wave in a bar.
///
/// An elastic bar without lateral contraction is at rest but for a velocity `V g(x)` around its
/// middle. d'Alembert's solution, until the waves come to the ends, is
/// `v(x, t) = V/2 (g(x − c t) + g(x + c t))` with `c = √(E/ρ)`: two waves of half the height.
#[derive(Debug)]
pub struct BarWave;

/// Length of the bar, m.
pub(super) const LENGTH: f64 = 2.0;
/// Width of the hump g, m.
const WIDTH: f64 = 0.8;
/// How far the waves run, m: they keep off the ends.
pub(super) const WAY: f64 = 0.5;
/// Young's modulus, Pa.
pub(super) const YOUNG: f64 = 10e3;
/// Density, kg/m³.
pub(super) const DENSITY: f64 = 1000.0;
/// Velocity by the wave's: strains are as large, so that the answer is that of small strains.
pub(super) const AMPLITUDE: f64 = 1e-6;

pub(super) fn wave_speed() -> f64 {
    (YOUNG / DENSITY).sqrt()
}

/// A smooth hump of height 1 in the middle of the bar.
pub(super) fn hump(x: f64) -> f64 {
    let from_middle = (x - 0.5 * LENGTH) / WIDTH;
    if from_middle.abs() < 0.5 { (PI * from_middle).cos().powi(4) } else { 0.0 }
}

/// Velocity at a place and time, m/s.
pub(super) fn exact(x: f64, t: f64) -> f64 {
    let c = wave_speed();
    0.5 * AMPLITUDE * c * (hump(x - c * t) + hump(x + c * t))
}

impl Problem for BarWave {
    fn name(&self) -> &'static str {
        "bar-wave"
    }

    fn title(&self) -> &'static str {
        "Stress wave in a bar"
    }

    fn error_is(&self) -> &'static str {
        "velocities when the waves have run 0.5 m, root mean square by that of d'Alembert's solution"
    }

    fn sweeps(&self) -> Vec<(Parameter, &'static [f64])> {
        vec![
            (Parameter::TimeStep, Parameter::TimeStep.values()),
            (Parameter::Mesh, Parameter::Mesh.values()),
            (Parameter::Viscosity, Parameter::Viscosity.values()),
        ]
    }

    fn purpose(&self) -> Purpose {
        Purpose::Motion
    }

    fn scenario(&self, refinement: usize) -> Scenario {
        let bars = TwoBars {
            length_m: LENGTH,
            right_length_m: 0.1,
            height_m: 0.1,
            force_n: 0.0,
            rigid_right: true,
            cells: refinement,
            material: Material {
                young_pa: YOUNG,
                poisson: 0.0,
                density_kg_m3: DENSITY,
                viscosity_pa_s: Some(0.0),
                // nothing touches: the stable step is that of the triangles
                penalty_pa: 1e-3 * YOUNG,
                tangential_penalty_pa: 1e-4 * YOUNG,
                ..TwoBars::default().material
            },
            ..TwoBars::default()
        };
        let mut scenario = Scenario { two_bars: Some(bars), ..Scenario::default() };
        scenario.run.contact = Some(false);
        scenario.run.end_s = Some(WAY / wave_speed());
        scenario
    }

    fn material<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut Material> {
        scenario.two_bars.as_mut().map(|bars| &mut bars.material)
    }

    fn answer(&self) -> Answer<'_> {
        Answer::Plane(self)
    }
}

impl InPlane for BarWave {
    fn start(&self, scene: &mut Scene) {
        let nodes = &mut scene.nodes;
        for (velocity, place) in nodes.velocity.iter_mut().zip(&nodes.initial) {
            velocity.x = AMPLITUDE * wave_speed() * hump(place.x);
        }
    }

    fn error(&self, run: &mut Run<'_>) -> f64 {
        run.finish();
        let simulation = &run.simulation;
        let nodes = &simulation.scene().nodes;
        let (mut wrong, mut all) = (0.0, 0.0);
        for (n, place) in nodes.initial.iter().enumerate() {
            let (mass, v) = (simulation.masses()[n], nodes.velocity[n]);
            let exact = exact(place.x, simulation.time());
            wrong += mass * ((v.x - exact).powi(2) + v.y * v.y);
            all += mass * exact * exact;
        }
        (wrong / all).sqrt()
    }
}
