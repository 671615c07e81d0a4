//! Studies as tables.

use super::{
    settings::Parameter,
    study::{Study, Sweep},
};
use ypsilon_post::table::Table;

/// A sweep as a table: settings, cost, error. Unstable runs have no error.
#[must_use]
pub fn table(sweep: &Sweep) -> Table {
    let mut headings: Vec<String> = vec![sweep.parameter.label().to_owned()];
    let others = Parameter::ALL.into_iter().filter(|&other| other != sweep.parameter);
    let fixed = [
        "run time (s)",
        "error",
        "default of the generator",
        "steps",
        "triangles",
        "triangle-steps",
        "detections",
        "couples evaluated",
        "time step (s)",
        "penalty (Pa)",
        "DIEZON (m)",
        "D1PEKS (Pa s)",
    ];
    headings.extend(fixed.map(str::to_owned));
    headings.extend(others.clone().map(|other| other.label().to_owned()));
    let mut table = Table::new(headings);
    for point in &sweep.points {
        let s = &point.solution;
        let mut row = vec![
            s.value(sweep.parameter),
            s.seconds,
            s.error,
            f64::from(u8::from(point.is_default)),
            s.steps as f64,
            s.triangles as f64,
            s.triangle_steps(),
            s.detections as f64,
            s.couples as f64,
            s.step_s,
            s.penalty_pa,
            s.buffer_m,
            s.viscosity_pa_s,
        ];
        row.extend(others.clone().map(|other| s.value(other)));
        table.rows.push(row);
    }
    table
}

/// All sweeps of all problems as one CSV text, the names of problem and parameter in front.
#[must_use]
pub fn all(studies: &[Study]) -> String {
    let mut text = String::from(
        "problem,parameter,value,run time (s),error,default of the generator,steps,triangles,\
         detections,couples evaluated\n",
    );
    for study in studies {
        for sweep in &study.sweeps {
            for point in &sweep.points {
                let s = &point.solution;
                let error = number(s.error);
                text.push_str(&format!(
                    "{},{},{},{},{error},{},{},{},{},{}\n",
                    study.name,
                    sweep.parameter.name(),
                    s.value(sweep.parameter),
                    s.seconds,
                    u8::from(point.is_default),
                    s.steps,
                    s.triangles,
                    s.detections,
                    s.couples,
                ));
            }
        }
    }
    text
}

/// Each problem with all settings of the generator and with all recommended ones, as CSV text.
#[must_use]
pub fn recommended(studies: &[Study]) -> String {
    let mut text = String::from("problem,settings,run time (s),error,steps");
    for parameter in Parameter::ALL {
        text.push_str(&format!(",{}", parameter.label()));
    }
    text.push('\n');
    for study in studies {
        for (name, s) in [("generator", &study.own), ("recommended", &study.recommended)] {
            let error = number(s.error);
            text.push_str(&format!("{},{name},{},{error},{}", study.name, s.seconds, s.steps));
            for parameter in Parameter::ALL {
                text.push_str(&format!(",{}", number(s.value(parameter))));
            }
            text.push('\n');
        }
    }
    text
}

/// A number as tables of Ypsilon write it.
fn number(value: f64) -> String {
    if value.is_nan() { "nan".to_owned() } else { value.to_string() }
}
