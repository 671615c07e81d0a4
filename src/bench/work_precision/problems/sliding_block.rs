use crate::{
    bench::work_precision::{Answer, InPlane, Parameter, Problem, Run, recommendations::Purpose},
    meshing::{Material, Scenario, kinds::BlockOnPlane},
};

/// A block that slides on a level plane until friction has stopped it, after `v²/(2 μ g)`.
#[derive(Debug)]
pub struct SlidingBlock;

impl Problem for SlidingBlock {
    fn name(&self) -> &'static str {
        "sliding-block"
    }

    fn title(&self) -> &'static str {
        "Sliding block"
    }

    fn error_is(&self) -> &'static str {
        "way of the block against v²/(2 μ g)"
    }

    fn sweeps(&self) -> Vec<(Parameter, &'static [f64])> {
        let mut sweeps = Parameter::ALL.map(|p| (p, p.values()));
        sweeps[Parameter::Mesh as usize].1 = &[1.0, 2.0, 4.0];
        sweeps.to_vec()
    }

    fn purpose(&self) -> Purpose {
        Purpose::Rest
    }

    fn scenario(&self, refinement: usize) -> Scenario {
        let block = BlockOnPlane { cells: 2 * refinement, ..BlockOnPlane::default() };
        Scenario { block_on_plane: Some(block), ..Scenario::default() }
    }

    fn material<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut Material> {
        scenario.block_on_plane.as_mut().map(|block| &mut block.material)
    }

    fn answer(&self) -> Answer<'_> {
        Answer::Plane(self)
    }
}

impl InPlane for SlidingBlock {
    fn error(&self, run: &mut Run<'_>) -> f64 {
        run.finish();
        let block = BlockOnPlane::default();
        let braking = block.material.friction * block.gravity_m_s2.abs();
        let stop = block.velocity_m_s * block.velocity_m_s / (2.0 * braking);
        // the plane lies from below 0 to 0
        let first = run.made.model.velocities.keys().next().copied().unwrap_or(0);
        let nodes = &run.simulation.scene().nodes;
        let (mut sum, mut mass) = (0.0, 0.0);
        for n in first..nodes.initial.len() {
            let m = run.simulation.masses()[n];
            mass += m;
            sum += m * (nodes.current[n].x - nodes.initial[n].x);
        }
        (sum / mass / stop - 1.0).abs()
    }
}
