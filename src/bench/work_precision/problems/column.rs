use crate::{
    bench::work_precision::{Answer, InPlane, Parameter, Problem, Run, recommendations::Purpose},
    meshing::{Material, Scenario, kinds::Column},
};

/// Dry blocks on a held one that come to rest under their own weight: their top sinks by
/// `ρ g H²/(2 E)`, if bodies cannot overlap.
#[derive(Debug)]
pub struct SelfWeight;

/// Time that the blocks have, s: 24 periods of the column's longest wave.
const TIME: f64 = 0.03;

fn column(refinement: usize) -> Column {
    let own = Column::default();
    let stone = Material { poisson: 0.0, ..own.stone };
    Column { cells: [2 * refinement, refinement], stone, ..own }
}

impl Problem for SelfWeight {
    fn name(&self) -> &'static str {
        "self-weight"
    }

    fn title(&self) -> &'static str {
        "Column under its own weight"
    }

    fn error_is(&self) -> &'static str {
        "settlement of the top after 0.03 s against ρ g H²/(2 E)"
    }

    fn sweeps(&self) -> Vec<(Parameter, &'static [f64])> {
        let mut sweeps = Parameter::ALL.map(|p| (p, p.values()));
        sweeps[Parameter::TimeStep as usize].1 = &[0.1, 0.2, 0.4, 0.6, 0.8, 0.95, 1.05, 1.2, 1.5];
        sweeps[Parameter::Mesh as usize].1 = &[1.0, 2.0, 4.0];
        sweeps.to_vec()
    }

    fn purpose(&self) -> Purpose {
        Purpose::Rest
    }

    fn scenario(&self, refinement: usize) -> Scenario {
        let mut scenario = Scenario { column: Some(column(refinement)), ..Scenario::default() };
        scenario.run.end_s = Some(TIME);
        scenario
    }

    fn material<'a>(&self, scenario: &'a mut Scenario) -> Option<&'a mut Material> {
        scenario.column.as_mut().map(|column| &mut column.stone)
    }

    fn answer(&self) -> Answer<'_> {
        Answer::Plane(self)
    }
}

impl InPlane for SelfWeight {
    fn error(&self, run: &mut Run<'_>) -> f64 {
        run.finish();
        let column = column(1);
        let top = column.blocks as f64 * column.height_m;
        let height = top - column.height_m;
        let stone = column.stone;
        let exact =
            stone.density_kg_m3 * column.gravity_m_s2 * height * height / (2.0 * stone.young_pa);
        let [_, settled] = run.displacement(|[_, y]| y == top);
        (settled / exact - 1.0).abs()
    }
}
