//! Errors fall as theory says: with the time step, the mesh and the penalty.

use ypsilon::bench::{
    growth_exponent,
    work_precision::{PROBLEMS, Parameter, Problem, Settings, Solution, recommendations, solve},
};

fn problem(name: &str) -> &'static dyn Problem {
    PROBLEMS.into_iter().find(|problem| problem.name() == name).expect("the problem")
}

fn solved(name: &str, settings: Settings) -> Solution {
    solve(problem(name), settings).expect("a deck")
}

/// Order of convergence over a setting, and the errors.
fn order(name: &str, base: Settings, parameter: Parameter, values: &[f64]) -> (f64, Vec<f64>) {
    let errors: Vec<f64> =
        values.iter().map(|&value| solved(name, base.with(parameter, value)).error).collect();
    let points: Vec<[f64; 2]> = values.iter().zip(&errors).map(|(&x, &y)| [x, y]).collect();
    (growth_exponent(&points).unwrap_or(f64::NAN), errors)
}

#[test]
fn integration_over_time_is_of_first_order_at_least() {
    // velocities lag half a step behind places: the start at rest is half a step off
    let (p, errors) =
        order("patch", Settings::default(), Parameter::TimeStep, &[0.005, 0.01, 0.02]);
    assert!((0.9..1.3).contains(&p), "order {p}: {errors:?}");
    // at longer steps the frequency is wrong, by the square of the step
    let (p, errors) = order("patch", Settings::default(), Parameter::TimeStep, &[0.2, 0.3, 0.4]);
    assert!((1.3..2.3).contains(&p), "order {p}: {errors:?}");
}

#[test]
fn waves_converge_with_the_mesh_at_first_order_or_better() {
    // a fixed share of the stable step: mesh and step become finer together
    let base = Settings::default().with(Parameter::TimeStep, 0.05);
    let (p, errors) = order("bar-wave", base, Parameter::Mesh, &[1.0, 2.0, 4.0]);
    assert!(p < -0.95, "order {p}: {errors:?}");
    assert!(errors[2] < 0.1, "{errors:?}");
}

#[test]
fn overlap_falls_with_the_penalty() {
    for name in ["two-bars", "self-weight"] {
        let (p, errors) = order(name, Settings::default(), Parameter::Penalty, &[0.3, 1.0, 3.0]);
        assert!((-1.15..-0.8).contains(&p), "{name}: order {p}: {errors:?}");
    }
}

#[test]
fn steps_beyond_the_bound_are_unstable_and_steps_below_are_not() {
    let at = |share| solved("self-weight", Settings::default().with(Parameter::TimeStep, share));
    let (half, near) = (at(0.5).error, at(0.95).error);
    assert!((near / half - 1.0).abs() < 1e-3, "{half} {near}");
    assert!(at(1.2).error.is_nan());
}

#[test]
fn impacts_keep_their_energy_at_recommended_steps_and_not_at_long_ones() {
    let at = |share| solved("impact", Settings::default().with(Parameter::TimeStep, share)).error;
    let recommended = at(recommendations::TIME_STEP_IN_MOTION);
    assert!(recommended < 2e-3, "{recommended}");
    assert!(at(0.95) > 0.05);
}

#[test]
fn impacts_in_space_keep_their_energy_the_better_the_shorter_the_step() {
    let steps = [0.2, 0.1, 0.05];
    let (p, errors) = order("impact-3d", Settings::default(), Parameter::TimeStep, &steps);
    assert!(p > 0.8, "order {p}: {errors:?}");
    assert!(errors[2] < 3e-4, "{errors:?}");
}

#[test]
fn the_buffer_changes_cost_and_nothing_else() {
    let at = |buffer| solved("sliding-block", Settings::default().with(Parameter::Buffer, buffer));
    let (narrow, wide) = (at(0.01), at(0.4));
    assert!((narrow.error - wide.error).abs() < 1e-6, "{narrow:?} {wide:?}");
    assert!(narrow.detections > 10 * wide.detections.max(1), "{narrow:?} {wide:?}");
}
