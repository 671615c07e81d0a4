use crate::{
    bench::work_precision::{
        Answer, InPlane, Parameter, Problem, Run, Settings, recommendations::Purpose,
    },
    meshing::{Material, Scenario, kinds::TwoBlocks},
};

/// Two blocks that collide without friction and viscosity: the energy after the impact, kinetic
/// and of strain, is that before it, whatever mesh and penalty.
#[derive(Debug)]
pub struct Impact;

impl Problem for Impact {
    fn name(&self) -> &'static str {
        "impact"
    }

    fn title(&self) -> &'static str {
        "Impact of two blocks"
    }

    fn error_is(&self) -> &'static str {
        "energy when the blocks have parted against that before the impact"
    }

    fn sweeps(&self) -> Vec<(Parameter, &'static [f64])> {
        vec![
            (Parameter::TimeStep, Parameter::TimeStep.values()),
            (Parameter::Penalty, Parameter::Penalty.values()),
            (Parameter::Buffer, Parameter::Buffer.values()),
            (Parameter::Mesh, &[1.0, 2.0, 4.0]),
        ]
    }

    fn purpose(&self) -> Purpose {
        Purpose::Motion
    }

    fn base(&self, varied: Parameter) -> Settings {
        // the generator's step is too long for an impact: it would hide all else
        let base = Settings::default().with(Parameter::TimeStep, 0.2);
        // what the buffer costs shows where there are triangles
        if varied == Parameter::Buffer { base.with(Parameter::Mesh, 4.0) } else { base }
    }

    fn scenario(&self, refinement: usize) -> Scenario {
        let blocks = TwoBlocks { cells: 4 * refinement, ..TwoBlocks::default() };
        Scenario { two_blocks: Some(blocks), ..Scenario::default() }
    }

    fn material<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut Material> {
        scenario.two_blocks.as_mut().map(|blocks| &mut blocks.material)
    }

    fn answer(&self) -> Answer<'_> {
        Answer::Plane(self)
    }
}

impl InPlane for Impact {
    fn error(&self, run: &mut Run<'_>) -> f64 {
        let before = run.simulation.sum_kinetic_energy();
        run.finish();
        let simulation = &run.simulation;
        let strain: f64 = simulation.triangles().filter_map(|e| simulation.strain_energy(e)).sum();
        ((simulation.sum_kinetic_energy() + strain) / before - 1.0).abs()
    }
}
