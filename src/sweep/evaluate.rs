//! The numbers of a case, from its results.

use super::outputs::{Figure, Output, Source, When};
use crate::{output::OutputNames, session::RunSummary};
use std::path::Path;
use ypsilon_post::{
    PostError,
    extract::{Place, energy, extremes, force_displacement, histories, joint_counts, on_bodies},
    field::Field,
    results::Results,
    selection::Selection,
    table::Table,
};

/// The numbers of all outputs of a run whose deck had this name.
///
/// # Errors
/// One sentence that names the output.
pub(super) fn evaluate(outputs: &[Output], deck: &Path, folder: &Path) -> Result<Vec<f64>, String> {
    let names = OutputNames::new(deck, folder);
    let mut tables = Tables { names, results: None, histories: None };
    let mut found = Vec::new();
    for output in outputs {
        let value = tables.value(output, outputs);
        found.push(value.map_err(|words| format!("output `{}`: {words}", output.name))?);
    }
    Ok(found)
}

/// Tables of one run, made when they are asked for.
struct Tables {
    names: OutputNames,
    results: Option<Results>,
    /// Places, fields and values of all histories: files are read once for all of them.
    histories: Option<(Vec<Place>, Vec<Field>, Table)>,
}

impl Tables {
    fn results(&mut self) -> Result<&mut Results, String> {
        let results = match self.results.take() {
            Some(results) => results,
            None => Results::open(&self.names.pvd()).map_err(|error| error.to_string())?,
        };
        Ok(self.results.insert(results))
    }

    fn value(&mut self, output: &Output, all: &[Output]) -> Result<f64, String> {
        let words = |error: PostError| error.to_string();
        let (table, column) = match &output.source {
            Source::Run(figure) => return self.figure(*figure),
            Source::History(place, field) => {
                let (places, fields, table) = self.histories(all)?;
                let place = places.iter().position(|other| other == place).unwrap_or(0);
                let field = fields.iter().position(|other| other == field).unwrap_or(0);
                let column = 1 + place * fields.len() + field;
                return pick(table, column, output.at);
            }
            Source::Energy => (energy(self.results()?).map_err(words)?, 1),
            Source::Joints(column) => {
                let table = joint_counts(self.results()?).map_err(words)?;
                let column = table.find(column).map_err(words)?;
                (table, column)
            }
            Source::Extremes(field, column) => {
                let table = extremes(self.results()?, &[*field]).map_err(words)?;
                let column = table.find(&format!("{column} {}", field.name())).map_err(words)?;
                (table, column)
            }
            Source::Reaction(nodes, axis) => self.sum(nodes, *axis, "reaction ")?,
            Source::MeanDisplacement(nodes, axis) => {
                self.sum(nodes, *axis, "mean displacement u")?
            }
            Source::Monitors(column) => named(&self.names.monitors(), column)?,
            Source::Balance(column) => named(&self.names.energy(), column)?,
            Source::Yh(number) => (Table::read(&self.names.history(*number)).map_err(words)?, 1),
        };
        pick(&table, column, output.at)
    }

    /// The table of forces and displacements of nodes, and the column of an axis.
    fn sum(
        &mut self,
        nodes: &Selection,
        axis: usize,
        column: &str,
    ) -> Result<(Table, usize), String> {
        let words = |error: PostError| error.to_string();
        let results = self.results()?;
        let name = ["x", "y", "z"].get(axis).copied().unwrap_or_default();
        let table = force_displacement(results, nodes, nodes).map_err(words)?;
        let column = table.find(&format!("{column}{name}")).map_err(words)?;
        Ok((table, column))
    }

    fn histories(
        &mut self,
        outputs: &[Output],
    ) -> Result<&(Vec<Place>, Vec<Field>, Table), String> {
        if self.histories.is_none() {
            let (mut places, mut fields) = (Vec::new(), Vec::new());
            for output in outputs {
                if let Source::History(place, field) = output.source {
                    if !places.contains(&place) {
                        places.push(place);
                    }
                    if !fields.contains(&field) {
                        fields.push(field);
                    }
                }
            }
            let results = self.results()?;
            let anchors = on_bodies(results, &places).map_err(|error| error.to_string())?;
            let table = histories(results, &anchors, &fields).map_err(|error| error.to_string())?;
            self.histories = Some((places, fields, table));
        }
        self.histories.as_ref().ok_or_else(|| "there are no histories".to_owned())
    }

    fn figure(&self, figure: Figure) -> Result<f64, String> {
        let path = self.names.summary();
        let wrong = |error: &dyn std::fmt::Display| format!("{}: {error}", path.display());
        let text = std::fs::read_to_string(&path).map_err(|error| wrong(&error))?;
        let summary: RunSummary = serde_json::from_str(&text).map_err(|error| wrong(&error))?;
        Ok(match figure {
            Figure::Seconds => summary.seconds,
            Figure::Steps => summary.steps as f64,
            Figure::Time => summary.time,
            Figure::BrokenJoints => summary.broken_joints as f64,
            Figure::KineticEnergy => summary.kinetic_energy,
            Figure::EnergyError => {
                let energy = summary.energy.ok_or(
                    "the run was not asked to watch its energy: \
                                                   write flags = [\"--energy\"] into [run]",
                )?;
                energy.worst_relative_error
            }
            Figure::SettlingIterations => {
                let settling = summary.settling.ok_or(
                    "the run was not asked to settle: write \
                                                       flags = [\"--settle\"] into [run]",
                )?;
                settling.settled.iterations as f64
            }
        })
    }
}

/// A column of a table that the run has written.
fn named(path: &Path, column: &str) -> Result<(Table, usize), String> {
    let table = Table::read(path).map_err(|error| error.to_string())?;
    let column = table.find(column).map_err(|error| error.to_string())?;
    Ok((table, column))
}

/// One value of a column over time, which is the first column.
fn pick(table: &Table, column: usize, when: When) -> Result<f64, String> {
    let (times, values) = (table.column(0), table.column(column));
    let known: Vec<(f64, f64)> =
        times.into_iter().zip(values).filter(|(_, value)| !value.is_nan()).collect();
    let (Some(&first), Some(&last)) = (known.first(), known.last()) else {
        return Ok(f64::NAN);
    };
    // the first of several that are alike
    let best = |better: &dyn Fn(f64, f64) -> bool| {
        known.iter().fold(first, |best, &point| if better(point.1, best.1) { point } else { best })
    };
    Ok(match when {
        When::End => last.1,
        When::Start => first.1,
        When::Max => best(&|a, b| a > b).1,
        When::Min => best(&|a, b| a < b).1,
        When::MaxAbs => best(&|a, b| a.abs() > b.abs()).1,
        When::TimeOfMax => best(&|a, b| a > b).0,
        When::TimeOfMin => best(&|a, b| a < b).0,
        When::Time(time) => {
            // times of outputs are sums of time steps
            let slack = 1e-9 * last.0.abs().max(first.0.abs());
            if time < first.0 - slack || time > last.0 + slack {
                return Err(format!(
                    "there is no result at {time} s: they run from {} s to {} s",
                    first.0, last.0
                ));
            }
            let after = known.partition_point(|(t, _)| *t < time);
            match (after.checked_sub(1).and_then(|at| known.get(at)), known.get(after)) {
                (Some(a), Some(b)) => a.1 + (b.1 - a.1) * (time - a.0) / (b.0 - a.0),
                (None, Some(b)) => b.1,
                (Some(a), None) => a.1,
                (None, None) => f64::NAN,
            }
        }
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let rows = [[0.0, 1.0], [0.1, -4.0], [0.2, f64::NAN], [0.3, 3.0], [0.4, 2.0]];
        Table {
            headings: vec!["time (s)".into(), "ux (m)".into()],
            rows: rows.map(Vec::from).to_vec(),
        }
    }

    #[test]
    fn values_over_time_become_one() {
        let value = |when| pick(&table(), 1, when).expect("a value");
        assert_eq!(value(When::End), 2.0);
        assert_eq!(value(When::Start), 1.0);
        assert_eq!(value(When::Max), 3.0);
        assert_eq!(value(When::Min), -4.0);
        assert_eq!(value(When::MaxAbs), -4.0);
        assert_eq!(value(When::TimeOfMax), 0.3);
        assert_eq!(value(When::TimeOfMin), 0.1);
        assert!((value(When::Time(0.05)) + 1.5).abs() < 1e-12);
        // across the gap
        assert!((value(When::Time(0.2)) + 0.5).abs() < 1e-12);
        assert_eq!(value(When::Time(0.4 + 1e-13)), 2.0);
        assert!(pick(&table(), 1, When::Time(0.5)).expect_err("a fault").contains("0 s to 0.4 s"));
    }
}
