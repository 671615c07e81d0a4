use super::bar_wave::{AMPLITUDE, DENSITY, WAY, YOUNG, exact, hump, wave_speed};
use crate::{
    bench::work_precision::{
        Answer, InSpace, Parameter, Problem, SpatialRun, recommendations::Purpose,
    },
    meshing::{Material, Scenario, spatial::kinds::TwoBars3d},
    scene::Scene,
};

/// The stress wave of [`BarWave`](super::bar_wave::BarWave) in a bar of tetrahedra.
#[derive(Debug)]
pub struct BarWave3d;

impl Problem for BarWave3d {
    fn name(&self) -> &'static str {
        "bar-wave-3d"
    }

    fn title(&self) -> &'static str {
        "Stress wave in a bar of tetrahedra"
    }

    fn error_is(&self) -> &'static str {
        "velocities when the waves have run 0.5 m, root mean square by that of d'Alembert's solution"
    }

    fn sweeps(&self) -> Vec<(Parameter, &'static [f64])> {
        vec![
            (Parameter::TimeStep, Parameter::TimeStep.values()),
            (Parameter::Mesh, &[1.0, 2.0, 4.0]),
            (Parameter::Viscosity, Parameter::Viscosity.values()),
        ]
    }

    fn purpose(&self) -> Purpose {
        Purpose::Motion
    }

    fn scenario(&self, refinement: usize) -> Scenario {
        let bars = TwoBars3d {
            length_m: super::bar_wave::LENGTH,
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
                // nothing touches: the stable step is that of the tetrahedra
                penalty_pa: 1e-3 * YOUNG,
                tangential_penalty_pa: 1e-4 * YOUNG,
                ..TwoBars3d::default().material
            },
            ..TwoBars3d::default()
        };
        let mut scenario = Scenario { two_bars_3d: Some(bars), ..Scenario::default() };
        scenario.run.contact = Some(false);
        scenario.run.end_s = Some(WAY / wave_speed());
        scenario
    }

    fn material<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut Material> {
        scenario.two_bars_3d.as_mut().map(|bars| &mut bars.material)
    }

    fn answer(&self) -> Answer<'_> {
        Answer::Space(self)
    }
}

impl InSpace for BarWave3d {
    fn start(&self, scene: &mut Scene<3>) {
        let nodes = &mut scene.nodes;
        for (velocity, place) in nodes.velocity.iter_mut().zip(&nodes.initial) {
            velocity.x = AMPLITUDE * wave_speed() * hump(place.x);
        }
    }

    fn error(&self, run: &mut SpatialRun<'_>) -> f64 {
        run.finish();
        let simulation = &run.simulation;
        let nodes = &simulation.scene().nodes;
        let (mut wrong, mut all) = (0.0, 0.0);
        for (n, place) in nodes.initial.iter().enumerate() {
            let (mass, v) = (simulation.masses()[n], nodes.velocity[n]);
            let exact = exact(place.x, simulation.time());
            wrong += mass * ((v.x - exact).powi(2) + v.y * v.y + v.z * v.z);
            all += mass * exact * exact;
        }
        (wrong / all).sqrt()
    }
}
