use crate::{
    bench::work_precision::{Answer, InPlane, Parameter, Problem, Run, recommendations::Purpose},
    meshing::{Material, Scenario, kinds::Cube},
};
use std::f64::consts::TAU;

/// A square of four triangles that swings.
///
/// It is stretched a little along x and let go. Its corners carry the mass `ρ h²/6` each and pull
/// with `E a` when they are displaced by `a`, so that `a(t) = a₀ cos ω t` with
/// `ω = √(6 E/ρ)/h`: the exact solution of the mesh's equations of motion, in which only the
/// integration over time is wrong.
#[derive(Debug)]
pub struct Patch;

/// Displacement of the corners at the start by half the edge.
const STRAIN: f64 = 1e-6;
/// Periods that are watched.
const PERIODS: f64 = 3.0;

fn frequency(cube: &Cube) -> f64 {
    (6.0 * cube.material.young_pa / cube.material.density_kg_m3).sqrt() / cube.edge_m
}

fn cube() -> Cube {
    let own = Cube::default().material;
    // nothing touches: the stable step is that of the triangles
    let penalty_pa = 1e-3 * own.young_pa;
    let material = Material { viscosity_pa_s: Some(0.0), penalty_pa, ..own };
    Cube { gradient: [[1.0 + STRAIN, 0.0], [0.0, 1.0]], material, ..Cube::default() }
}

impl Problem for Patch {
    fn name(&self) -> &'static str {
        "patch"
    }

    fn title(&self) -> &'static str {
        "Oscillating patch of triangles"
    }

    fn error_is(&self) -> &'static str {
        "largest error of the displacement in the last of 3 periods, by the amplitude"
    }

    fn sweeps(&self) -> Vec<(Parameter, &'static [f64])> {
        vec![(Parameter::TimeStep, Parameter::TimeStep.values())]
    }

    fn purpose(&self) -> Purpose {
        Purpose::Motion
    }

    fn scenario(&self, _refinement: usize) -> Scenario {
        let cube = cube();
        let period = TAU / frequency(&cube);
        let mut scenario = Scenario { cube: Some(cube), ..Scenario::default() };
        scenario.run.contact = Some(false);
        scenario.run.end_s = Some(PERIODS * period);
        scenario
    }

    fn material<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut Material> {
        scenario.cube.as_mut().map(|cube| &mut cube.material)
    }

    fn answer(&self) -> Answer<'_> {
        Answer::Plane(self)
    }
}

impl InPlane for Patch {
    fn error(&self, run: &mut Run<'_>) -> f64 {
        let cube = cube();
        let (omega, half) = (frequency(&cube), 0.5 * cube.edge_m);
        let last = (PERIODS - 1.0) * TAU / omega;
        let mut worst: f64 = 0.0;
        while run.step() {
            let t = run.simulation.time();
            if t < last {
                continue;
            }
            let nodes = &run.simulation.scene().nodes;
            for (start, now) in nodes.initial.iter().zip(&nodes.current) {
                let exact = STRAIN * start.x * (omega * t).cos();
                let wrong = (now.x - start.x - exact).abs() / (STRAIN * half);
                worst = if wrong.is_nan() { f64::NAN } else { worst.max(wrong) };
            }
        }
        worst
    }
}
