use crate::{
    bench::work_precision::{
        Answer, InSpace, Parameter, Problem, Settings, SpatialRun, recommendations::Purpose,
    },
    meshing::{Material, Scenario, spatial::kinds::TwoCubes3d},
    scene::{PressedFaces, SpatialContact},
};

/// Two cubes of tetrahedra that collide beside each other without friction and viscosity, with the
/// faces of both pressed: the energy after the impact, kinetic and of strain, is that before it,
/// whatever mesh and penalty.
#[derive(Debug)]
pub struct Impact3d;

impl Problem for Impact3d {
    fn name(&self) -> &'static str {
        "impact-3d"
    }

    fn title(&self) -> &'static str {
        "Impact of two cubes of tetrahedra"
    }

    fn error_is(&self) -> &'static str {
        "energy when the cubes have parted against that before the impact"
    }

    fn sweeps(&self) -> Vec<(Parameter, &'static [f64])> {
        vec![
            (Parameter::TimeStep, Parameter::TimeStep.values()),
            (Parameter::Penalty, Parameter::Penalty.values()),
            (Parameter::Mesh, &[1.0, 2.0, 3.0]),
        ]
    }

    fn purpose(&self) -> Purpose {
        Purpose::Motion
    }

    fn base(&self, _varied: Parameter) -> Settings {
        // the generator's step is too long for an impact: it would hide all else
        Settings::default().with(Parameter::TimeStep, 0.2)
    }

    fn scenario(&self, refinement: usize) -> Scenario {
        let cubes =
            TwoCubes3d { cells: [refinement; 3], shift_m: [0.4, 0.2], ..TwoCubes3d::default() };
        Scenario { two_cubes_3d: Some(cubes), ..Scenario::default() }
    }

    fn material<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut Material> {
        scenario.two_cubes_3d.as_mut().map(|cubes| &mut cubes.material)
    }

    fn answer(&self) -> Answer<'_> {
        Answer::Space(self)
    }
}

impl InSpace for Impact3d {
    fn contact(&self) -> SpatialContact {
        SpatialContact { pressed: PressedFaces::Both, ..SpatialContact::default() }
    }

    fn error(&self, run: &mut SpatialRun<'_>) -> f64 {
        let before = run.simulation.sum_kinetic_energy();
        run.finish();
        let simulation = &run.simulation;
        let after = simulation.sum_kinetic_energy() + simulation.sum_strain_energy();
        (after / before - 1.0).abs()
    }
}
