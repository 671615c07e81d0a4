//! Work-precision: what accuracy costs.
//!
//! [Problems](PROBLEMS) with known answers are solved with one setting varied, the others being
//! as the generators make them; [`run`] writes error, run time and where the generators' own
//! choice lies as tables and pictures. What follows for decks is in `docs/src/work-precision.md`.

mod pictures;
mod problem;
mod problems;
pub mod recommendations;
mod settings;
mod study;
mod tables;

pub use problem::{Answer, InPlane, InSpace, Problem, Run, Solution, SpatialRun, Stepped, solve};
pub use problems::PROBLEMS;
pub use settings::{Parameter, Settings};
pub use study::{Point, Study, Sweep, study};

use super::BenchError;
use std::path::Path;
use ypsilon_post::plot::Picture;

/// Studies problems and writes tables and pictures into a folder.
///
/// # Errors
/// If there is no problem of a name, a deck cannot be made, or a file cannot be written.
pub fn run(
    names: &[String],
    repeats: usize,
    folder: &Path,
    say: &mut dyn FnMut(&str),
) -> Result<(), BenchError> {
    let known = || PROBLEMS.iter().map(|problem| problem.name().to_owned()).collect();
    if let Some(name) = names.iter().find(|name| PROBLEMS.iter().all(|p| p.name() != **name)) {
        return Err(BenchError::NoScene { name: name.clone(), known: known() });
    }
    std::fs::create_dir_all(folder).map_err(BenchError::io(folder))?;
    let mut studies = Vec::new();
    for problem in PROBLEMS {
        if names.is_empty() || names.iter().any(|name| name == problem.name()) {
            studies.push(study(problem, repeats, say)?);
        }
    }
    write(&studies, folder)?;
    for study in &studies {
        let told = |solution: &Solution| {
            format!("error {:.2e} in {:.2e} s", solution.error, solution.seconds)
        };
        say(&format!(
            "{}: {} as the generator makes it, {} as recommended",
            study.title,
            told(&study.own),
            told(&study.recommended)
        ));
    }
    say(&format!("tables and pictures are in {}", folder.display()));
    Ok(())
}

/// Writes studies into a folder.
fn write(studies: &[Study], folder: &Path) -> Result<(), BenchError> {
    for study in studies {
        for sweep in &study.sweeps {
            let name = format!("{}_{}.csv", study.name, sweep.parameter.name());
            tables::table(sweep).write(&folder.join(name))?;
        }
        both(&pictures::work_precision(study)?, folder, study.name)?;
    }
    for parameter in Parameter::ALL {
        let varies = |study: &Study| study.sweeps.iter().any(|s| s.parameter == parameter);
        if studies.iter().any(varies) {
            both(&pictures::over_parameter(studies, parameter)?, folder, parameter.name())?;
            let name = format!("{}-cost", parameter.name());
            both(&pictures::cost(studies, parameter)?, folder, &name)?;
        }
    }
    for (name, text) in
        [("all.csv", tables::all(studies)), ("recommended.csv", tables::recommended(studies))]
    {
        let path = folder.join(name);
        std::fs::write(&path, text).map_err(BenchError::io(&path))?;
    }
    Ok(())
}

/// A picture as PNG and SVG.
fn both(picture: &Picture, folder: &Path, name: &str) -> Result<(), BenchError> {
    for ending in ["png", "svg"] {
        picture.write(&folder.join(format!("{name}.{ending}")))?;
    }
    Ok(())
}
