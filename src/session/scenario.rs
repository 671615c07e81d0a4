//! Scenario files as input of a run: the deck is made into the folder of the results.

use crate::{
    meshing::{AnyGenerated, Generated, MeshingError, Scenario},
    output::{Monitor, MonitorPlan},
};
use std::{
    io::{self, Write},
    path::{Path, PathBuf},
};
use thiserror::Error;
use yformat::{deck::Deck, part_file::PartFile};

/// The deck of a scenario file, and what is to be watched while it runs.
#[derive(Debug)]
pub struct ScenarioDeck {
    /// Where the deck is: `FOLDER/NAME.y` for the scenario `NAME.toml`.
    pub path: PathBuf,
    /// The scenario's monitors.
    pub monitors: MonitorPlan,
    /// What was made.
    pub generated: AnyGenerated,
}

/// Why a scenario's deck cannot be made.
#[derive(Debug, Error)]
pub enum ScenarioError {
    /// The scenario is wrong.
    #[error("{path}: {source}")]
    Meshing {
        /// The scenario.
        path: PathBuf,
        /// Why.
        source: Box<MeshingError>,
    },
    /// A monitor makes no sense.
    #[error("{path}: monitor `{name}`: {why}")]
    Monitor {
        /// The scenario.
        path: PathBuf,
        /// The monitor.
        name: String,
        /// Why.
        why: String,
    },
    /// Something else would be lost.
    #[error("{0} is not a deck that ypsilon made from a scenario: it stays as it is")]
    Foreign(PathBuf),
    /// The deck cannot be written.
    #[error("cannot write {path}: {source}")]
    Io {
        /// The deck.
        path: PathBuf,
        /// Why.
        source: io::Error,
    },
}

/// Makes the deck of a scenario file in a folder.
///
/// # Errors
/// If the scenario is wrong, or the deck cannot be written or would replace a deck that was not
/// made from a scenario.
pub fn deck_of_scenario(scenario: &Path, folder: &Path) -> Result<ScenarioDeck, ScenarioError> {
    let meshing = |source: MeshingError| ScenarioError::Meshing {
        path: scenario.to_path_buf(),
        source: Box::new(source),
    };
    let read = Scenario::read(scenario).map_err(meshing)?;
    let name = scenario.file_stem().unwrap_or_default();
    let path = folder.join(name).with_extension("y");
    let monitors = monitors(&read, scenario)?;
    let generated = read.generate_any().map_err(meshing)?;
    write(generated.deck(), &path)?;
    Ok(ScenarioDeck { path, monitors, generated })
}

/// Writes the deck of a scenario; folders are made.
///
/// # Errors
/// If it cannot be written or would replace a deck that was not made from a scenario.
pub fn write(deck: &Deck, path: &Path) -> Result<(), ScenarioError> {
    let io = |source| ScenarioError::Io { path: path.to_path_buf(), source };
    if let Ok(there) = std::fs::read(path)
        && !Generated::is_generated(&String::from_utf8_lossy(&there))
    {
        return Err(ScenarioError::Foreign(path.to_path_buf()));
    }
    if let Some(folder) = path.parent() {
        std::fs::create_dir_all(folder).map_err(io)?;
    }
    let mut file = PartFile::create(path).map_err(io)?;
    file.write_all(deck.to_text().as_bytes()).map_err(io)?;
    file.complete().map_err(io)?;
    Ok(())
}

/// The monitors of a scenario.
///
/// # Errors
/// If a selection or quantity is none.
pub fn monitors(scenario: &Scenario, path: &Path) -> Result<MonitorPlan, ScenarioError> {
    let mut plan = MonitorPlan::default();
    for watch in &scenario.monitors {
        let words = format!("{}={}:{}", watch.name, watch.nodes, watch.quantities.join(","));
        let monitor: Monitor = words.parse().map_err(|why: ypsilon_post::PostError| {
            let (path, name) = (path.to_path_buf(), watch.name.clone());
            ScenarioError::Monitor { path, name, why: why.to_string() }
        })?;
        plan.monitors.push(monitor);
    }
    if let Some(interval) = scenario.run.monitor_interval {
        plan.interval = interval as u64;
    }
    Ok(plan)
}
