use crate::{
    bench::work_precision::{Answer, InPlane, Parameter, Problem, Run, recommendations::Purpose},
    meshing::{Material, Scenario, kinds::TwoBars},
};

/// A bar that is pulled until it presses on a second one beyond a gap.
///
/// With x = F l/(E A g) = 2 and a second bar of half the length the pulled end moves
/// (2 + x)/3 = 4/3 of the gap, if bodies cannot overlap.
#[derive(Debug)]
pub struct TwoBarsContact;

/// The gap, m: strains are of its size, so that Hooke's law holds.
const GAP: f64 = 1e-5;
/// Time in which the force grows, s; the longest wave of the bar has a period of 1.3 s.
const RAMP: f64 = 1.5;

impl Problem for TwoBarsContact {
    fn name(&self) -> &'static str {
        "two-bars"
    }

    fn title(&self) -> &'static str {
        "Contact of two bars"
    }

    fn error_is(&self) -> &'static str {
        "displacement of the pulled end against 4/3 of the gap"
    }

    fn sweeps(&self) -> Vec<(Parameter, &'static [f64])> {
        vec![
            (Parameter::TimeStep, &[0.1, 0.2, 0.4, 0.6, 0.8, 0.95, 1.05, 1.2, 1.5]),
            (Parameter::Penalty, Parameter::Penalty.values()),
            (Parameter::Buffer, Parameter::Buffer.values()),
            (Parameter::Mesh, &[1.0, 2.0, 3.0]),
            (Parameter::Viscosity, Parameter::Viscosity.values()),
        ]
    }

    fn purpose(&self) -> Purpose {
        Purpose::Rest
    }

    fn scenario(&self, refinement: usize) -> Scenario {
        let own = TwoBars::default();
        let force_n = 2.0 * own.material.young_pa * own.height_m * GAP / own.length_m;
        let bars = TwoBars { gap_m: GAP, force_n, ramp_s: RAMP, cells: refinement, ..own };
        let mut scenario = Scenario { two_bars: Some(bars), ..Scenario::default() };
        scenario.run.end_s = Some(4.0 * RAMP);
        scenario
    }

    fn material<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut Material> {
        scenario.two_bars.as_mut().map(|bars| &mut bars.material)
    }

    fn answer(&self) -> Answer<'_> {
        Answer::Plane(self)
    }
}

impl InPlane for TwoBarsContact {
    fn error(&self, run: &mut Run<'_>) -> f64 {
        run.finish();
        let end = TwoBars::default().length_m;
        let [u, _] = run.displacement(|[x, _]| x == end);
        (u / (4.0 / 3.0 * GAP) - 1.0).abs()
    }
}
