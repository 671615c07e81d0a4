//! Sweeps of one parameter of a problem, the others being as the generator makes them or as the
//! [problem](Problem::base) wants them.

use super::{
    problem::{Problem, Solution, solve},
    recommendations::settings,
    settings::{Parameter, Settings},
};
use crate::bench::BenchError;

/// One solution of a sweep.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// The solution; its time is the least of repeated runs.
    pub solution: Solution,
    /// Whether the parameter is what the generator chooses.
    pub is_default: bool,
}

/// A parameter varied.
#[derive(Debug, Clone, PartialEq)]
pub struct Sweep {
    /// What is varied.
    pub parameter: Parameter,
    /// Solutions, values ascending.
    pub points: Vec<Point>,
}

/// A problem with all its sweeps.
#[derive(Debug, Clone, PartialEq)]
pub struct Study {
    /// Name in file names.
    pub name: &'static str,
    /// What it is.
    pub title: &'static str,
    /// What its error is.
    pub error_is: &'static str,
    /// The sweeps.
    pub sweeps: Vec<Sweep>,
    /// The solution with all settings as the generator makes them.
    pub own: Solution,
    /// The solution with all [recommended](super::recommendations) settings.
    pub recommended: Solution,
}

/// Solves a problem for all values of all its parameters, each `repeats` times for its run time.
///
/// # Errors
/// If a deck cannot be made.
pub fn study(
    problem: &dyn Problem,
    repeats: usize,
    say: &mut dyn FnMut(&str),
) -> Result<Study, BenchError> {
    let own = timed(problem, Settings::default(), repeats)?;
    let mut sweeps = Vec::new();
    for (parameter, values) in problem.sweeps() {
        say(&format!("{}: {}", problem.title(), parameter.label()));
        let chosen = parameter.of_generators().unwrap_or(own.value(parameter));
        let base = problem.base(parameter);
        let solved = |value: f64| timed(problem, base.with(parameter, value), repeats);
        let mut points = Vec::new();
        for &value in values {
            if (value / chosen - 1.0).abs() > 1e-9 {
                let solution = solved(value)?;
                points.push(Point { solution, is_default: false });
            }
        }
        points.push(Point { solution: solved(chosen)?, is_default: true });
        let value = |point: &Point| point.solution.value(parameter);
        points.sort_by(|a, b| value(a).total_cmp(&value(b)));
        sweeps.push(Sweep { parameter, points });
    }
    let varied = problem.sweeps().into_iter().map(|(parameter, _)| parameter);
    let recommended = timed(problem, settings(problem.purpose(), varied), repeats)?;
    Ok(Study {
        name: problem.name(),
        title: problem.title(),
        error_is: problem.error_is(),
        sweeps,
        own,
        recommended,
    })
}

/// Runs are repeated until they take so long together, s.
const SHORT: f64 = 0.02;
/// But so many times as often as asked for at most.
const MOST_REPEATS: usize = 10;

/// A solution with the least time of several runs, which agree in all else: others have been
/// interrupted by what the machine does besides.
fn timed(
    problem: &dyn Problem,
    settings: Settings,
    repeats: usize,
) -> Result<Solution, BenchError> {
    let first = solve(problem, settings)?;
    let (mut least, mut sum, mut runs) = (first.seconds, first.seconds, 1);
    // a run of a millisecond says little
    while runs < repeats || (sum < SHORT && runs < repeats * MOST_REPEATS) {
        let again = solve(problem, settings)?.seconds;
        (least, sum, runs) = (least.min(again), sum + again, runs + 1);
    }
    Ok(Solution { seconds: least, ..first })
}
