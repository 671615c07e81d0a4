//! Studies as curves.

use super::{
    settings::Parameter,
    study::{Study, Sweep},
};
use ypsilon_post::{
    PostError,
    plot::{Curve, CurveOptions, Picture, Scale, curves_on},
};

const DEFAULTS: &str = "default of the generator";
const GAP: [f64; 2] = [f64::NAN; 2];

/// Error over run time of a problem, one curve for each parameter.
///
/// # Errors
/// If no run was stable.
pub fn work_precision(study: &Study) -> Result<Picture, PostError> {
    let point = |sweep: &Sweep| -> Vec<[f64; 2]> {
        sweep.points.iter().map(|p| [p.solution.seconds, p.solution.error]).collect()
    };
    let mut curves: Vec<Curve> = study
        .sweeps
        .iter()
        .map(|sweep| Curve { name: sweep.parameter.label().to_owned(), points: point(sweep) })
        .collect();
    let defaults = study.sweeps.iter().flat_map(|sweep| {
        let chosen = sweep.points.iter().filter(|p| p.is_default);
        chosen.flat_map(|p| [[p.solution.seconds, p.solution.error], GAP])
    });
    curves.push(marked(defaults.collect()));
    draw(study.title, ["run time (s)", "error"], &curves)
}

/// Error over a parameter, one curve for each problem that has it.
///
/// # Errors
/// If no run was stable.
pub fn over_parameter(studies: &[Study], parameter: Parameter) -> Result<Picture, PostError> {
    over(studies, parameter, "error", |sweep, k| sweep.points[k].solution.error)
}

/// Run time over a parameter, by that of the generator's choice.
///
/// # Errors
/// If no run was stable.
pub fn cost(studies: &[Study], parameter: Parameter) -> Result<Picture, PostError> {
    let seconds = |sweep: &Sweep, k: usize| {
        let chosen = sweep.points.iter().find(|p| p.is_default);
        chosen.map_or(f64::NAN, |p| sweep.points[k].solution.seconds / p.solution.seconds)
    };
    over(studies, parameter, "run time by that of the default", seconds)
}

fn over(
    studies: &[Study],
    parameter: Parameter,
    label: &str,
    value: impl Fn(&Sweep, usize) -> f64,
) -> Result<Picture, PostError> {
    let (mut curves, mut defaults) = (Vec::new(), Vec::new());
    for study in studies {
        for sweep in study.sweeps.iter().filter(|sweep| sweep.parameter == parameter) {
            let point = |k: usize| {
                let s = &sweep.points[k].solution;
                [s.value(parameter), if s.error.is_nan() { f64::NAN } else { value(sweep, k) }]
            };
            let points = (0..sweep.points.len()).map(point).collect();
            curves.push(Curve { name: study.title.to_owned(), points });
            let chosen = (0..sweep.points.len()).filter(|&k| sweep.points[k].is_default);
            defaults.extend(chosen.flat_map(|k| [point(k), GAP]));
        }
    }
    curves.push(marked(defaults));
    draw("", [parameter.label(), label], &curves)
}

/// Points that are apart: they are drawn larger than those of lines.
fn marked(points: Vec<[f64; 2]>) -> Curve {
    Curve { name: DEFAULTS.to_owned(), points }
}

fn draw(title: &str, labels: [&str; 2], curves: &[Curve]) -> Result<Picture, PostError> {
    let options = CurveOptions {
        title: title.to_owned(),
        labels: labels.map(str::to_owned),
        ranges: [None, None],
        markers: true,
        size: [720, 440],
    };
    curves_on([Scale::Logarithmic; 2], curves, &options)
}
