//! Which result files a run writes.

use super::{Format, run::RunOptions};
use crate::{
    output::{
        Background, D3plotOutput, EnergyOutput, HistoryOutput, MonitorOutput, OutputError,
        OutputNames, RestartDeckOutput, ResultWriter, SnapshotOutput, SpatialD3plotOutput,
        SpatialVtuOutput, StateFileOutput, VtuOutput, YGeoOutput,
    },
    simulation::{PlaneAudit, Simulation, SpaceAudit, SpatialSimulation},
};
use yformat::{d3plot::StartDate, dialect::Dialect};

/// The writers of a run; those of a run that goes on from a checkpoint have no files yet. They
/// hand over to `background` what takes long.
pub(super) fn open_writers(
    options: &RunOptions,
    names: &OutputNames,
    background: &Background,
    simulation: &Simulation,
    is_resumed: bool,
) -> Result<Vec<Box<dyn ResultWriter>>, OutputError> {
    let mut writers: Vec<Box<dyn ResultWriter>> = Vec::new();
    let formats = Format::expand(&options.formats, simulation.scene().conventions.dialect);
    if formats.contains(&Format::Yh) {
        writers.push(Box::new(match is_resumed {
            false => HistoryOutput::open(names, simulation.scene())?,
            true => HistoryOutput::closed(),
        }));
    }
    let is_classic = simulation.classic_joints().is_some();
    if is_classic && formats.contains(&Format::Ym) {
        writers.push(Box::new(match is_resumed {
            false => SnapshotOutput::open(names, background, simulation)?,
            true => SnapshotOutput::closed(names, background),
        }));
    }
    if is_classic && formats.contains(&Format::Restart) {
        writers.push(Box::new(RestartDeckOutput::new(names, background)));
    }
    if simulation.scene().conventions.dialect == Dialect::YGeo && formats.contains(&Format::Vtp) {
        writers.push(Box::new(YGeoOutput::new(names, background)));
    }
    if formats.contains(&Format::D3plot) {
        let legacy = options.legacy_d3plot;
        writers.push(Box::new(D3plotOutput::new(names, background, today(), legacy)));
    }
    if formats.contains(&Format::Vtu) {
        writers.push(Box::new(VtuOutput::new(names, background)));
    }
    if !options.monitors.is_empty() {
        let plan = &options.monitors;
        writers.push(Box::new(match is_resumed {
            false => MonitorOutput::open(names, plan, simulation)?,
            true => MonitorOutput::closed(plan),
        }));
    }
    if let Some(interval) = options.watch.energy_interval {
        let audit = PlaneAudit::new(simulation);
        writers.push(Box::new(match is_resumed {
            false => EnergyOutput::open(names, audit, interval)?,
            true => EnergyOutput::closed(audit, interval),
        }));
    }
    if !options.states.is_empty() {
        writers.push(Box::new(StateFileOutput::new(
            names,
            background,
            options.states.iter().copied(),
        )));
    }
    Ok(writers)
}

/// The same in three dimensions.
pub(super) fn open_in_space(
    options: &RunOptions,
    names: &OutputNames,
    background: &Background,
    simulation: &SpatialSimulation,
    is_resumed: bool,
) -> Result<Vec<Box<dyn ResultWriter<SpatialSimulation>>>, OutputError> {
    if let Some(monitor) = options.monitors.monitors.first() {
        return Err(OutputError::MonitorInSpace { name: monitor.name.clone() });
    }
    let mut writers: Vec<Box<dyn ResultWriter<SpatialSimulation>>> = Vec::new();
    let formats = Format::expand(&options.formats, simulation.scene().conventions.dialect);
    if formats.contains(&Format::Yh) {
        writers.push(Box::new(match is_resumed {
            false => HistoryOutput::open(names, simulation.scene())?,
            true => HistoryOutput::closed(),
        }));
    }
    if formats.contains(&Format::D3plot) {
        let legacy = options.legacy_d3plot;
        writers.push(Box::new(SpatialD3plotOutput::new(names, background, today(), legacy)));
    }
    if formats.contains(&Format::Vtu) {
        writers.push(Box::new(SpatialVtuOutput::new(names, background)));
    }
    if let Some(interval) = options.watch.energy_interval {
        let audit = SpaceAudit::new();
        writers.push(Box::new(match is_resumed {
            false => EnergyOutput::open(names, audit, interval)?,
            true => EnergyOutput::closed(audit, interval),
        }));
    }
    if !options.states.is_empty() {
        let states = options.states.iter().copied();
        writers.push(Box::new(StateFileOutput::new(names, background, states)));
    }
    Ok(writers)
}

/// The date for the title of a d3plot family.
fn today() -> StartDate {
    let today = jiff::Zoned::now().date();
    StartDate {
        day: today.day().unsigned_abs(),
        month: today.month().unsigned_abs(),
        year: today.year().unsigned_abs(),
    }
}
