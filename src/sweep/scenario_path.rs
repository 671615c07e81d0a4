//! Parameters of scenarios by path: `wall.mortar.tensile_pa`, `loads[0].force_n`.

use super::{base::Setting, cell::Cell};
use crate::meshing::Scenario;
use std::{fmt, str::FromStr};
use toml::{Table, Value};

/// Where a parameter stands in a scenario file.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct ScenarioPath(Vec<Step>);

#[derive(Debug, Clone, PartialEq, Eq)]
enum Step {
    Key(String),
    Index(usize),
}

impl FromStr for ScenarioPath {
    type Err = String;

    fn from_str(words: &str) -> Result<Self, String> {
        parse(words.trim()).ok_or_else(|| {
            format!(
                "`{words}` names no parameter of a scenario: expected a path such as \
                 wall.mortar.tensile_pa or loads[0].force_n"
            )
        })
    }
}

fn parse(words: &str) -> Option<ScenarioPath> {
    let mut steps = Vec::new();
    for word in words.split('.') {
        let mut parts = word.split('[');
        let key = parts.next().filter(|key| !key.is_empty())?;
        let is_key = key.bytes().all(|b| b.is_ascii_alphanumeric() || b == b'_' || b == b'-');
        steps.push(Step::Key(Some(key).filter(|_| is_key)?.to_owned()));
        for index in parts {
            steps.push(Step::Index(index.strip_suffix(']')?.parse().ok()?));
        }
    }
    Some(ScenarioPath(steps))
}

impl fmt::Display for ScenarioPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        for (position, step) in self.0.iter().enumerate() {
            match step {
                Step::Key(key) if position == 0 => write!(f, "{key}")?,
                Step::Key(key) => write!(f, ".{key}")?,
                Step::Index(index) => write!(f, "[{index}]")?,
            }
        }
        Ok(())
    }
}

impl ScenarioPath {
    /// The value there.
    pub(super) fn get<'a>(&self, table: &'a Table) -> Option<&'a Value> {
        let (first, rest) = self.0.split_first()?;
        let Step::Key(key) = first else { return None };
        rest.iter().try_fold(table.get(key)?, |value, step| match step {
            Step::Key(key) => value.as_table()?.get(key),
            Step::Index(index) => value.as_array()?.get(*index),
        })
    }

    /// Whether a scenario has such a parameter; one that is left out may be set, too.
    pub(super) fn check(&self, table: &Table) -> Result<(), String> {
        match self.get(table) {
            Some(Value::Table(_) | Value::Array(_)) => {
                Err(format!("`{self}` is not a single value, but a table or an array"))
            }
            Some(_) => Ok(()),
            None => {
                // what values there would be told: an unknown name, or nothing of the kind
                let mut attempt = table.clone();
                for value in [Value::Float(1.0), Value::Boolean(true)] {
                    self.put(&mut attempt, value)?;
                    let complaint = match attempt.clone().try_into::<Scenario>() {
                        Ok(scenario) => scenario.kind().err().map(|error| error.to_string()),
                        Err(error) => Some(error.message().to_owned())
                            .filter(|message| message.starts_with("unknown field")),
                    };
                    if let Some(complaint) = complaint {
                        return Err(format!("the scenario has no parameter `{self}`: {complaint}"));
                    }
                }
                Ok(())
            }
        }
    }

    /// Puts the value of a setting there.
    pub(super) fn set(&self, table: &mut Table, setting: &Setting<'_>) -> Result<(), String> {
        let was = self.get(table).cloned();
        let number = was.as_ref().and_then(as_number);
        if setting.is_factor && number.is_none() {
            return Err(format!("`{self}` has no number that a factor could multiply"));
        }
        let value = match setting.cell {
            Cell::Word(word) => Value::String(word.clone()),
            Cell::Truth(truth) => Value::Boolean(*truth),
            Cell::Whole(whole) if !setting.is_factor && !matches!(was, Some(Value::Float(_))) => {
                Value::Integer(*whole)
            }
            cell => {
                let given = cell.value().unwrap_or(f64::NAN);
                let value = setting.number(given, number.unwrap_or(f64::NAN));
                if !value.is_finite() {
                    return Err(format!("`{self}` = {value} is not finite"));
                }
                match was {
                    Some(Value::Integer(_)) => Value::Integer(whole(self, value)?),
                    None if setting.is_rounded => Value::Integer(whole(self, value)?),
                    _ => Value::Float(value),
                }
            }
        };
        self.put(table, value.clone())?;
        match table.clone().try_into::<Scenario>() {
            Ok(_) => Ok(()),
            Err(error) => Err(format!("`{self}` = {value}: {}", error.message())),
        }
    }

    fn put(&self, table: &mut Table, value: Value) -> Result<(), String> {
        let nowhere = || format!("the scenario has no parameter `{self}`");
        let (last, steps) = self.0.split_last().ok_or_else(nowhere)?;
        let mut whole = Value::Table(std::mem::take(table));
        let mut here = Some(&mut whole);
        for step in steps {
            here = match (step, here) {
                (Step::Key(key), Some(Value::Table(t))) => {
                    Some(t.entry(key.clone()).or_insert_with(|| Value::Table(Table::new())))
                }
                (Step::Index(index), Some(Value::Array(a))) => a.get_mut(*index),
                _ => None,
            };
        }
        let placed = match (last, here) {
            (Step::Key(key), Some(Value::Table(t))) => {
                t.insert(key.clone(), value);
                true
            }
            (Step::Index(index), Some(Value::Array(a))) => {
                a.get_mut(*index).map(|slot| *slot = value).is_some()
            }
            _ => false,
        };
        if let Value::Table(back) = whole {
            *table = back;
        }
        placed.then_some(()).ok_or_else(nowhere)
    }

    /// The unit that the name tells, as names of scenarios do.
    pub(super) fn unit(&self) -> Option<&'static str> {
        let name = self.0.iter().rev().find_map(|step| match step {
            Step::Key(key) => Some(key),
            Step::Index(_) => None,
        })?;
        let units = [
            ("_kg_m3", "kg/m³"),
            ("_n_per_m", "N/m"),
            ("_n_m", "N/m"),
            ("_m_s2", "m/s²"),
            ("_m_s", "m/s"),
            ("_pa_s", "Pa s"),
            ("_pa", "Pa"),
            ("_deg", "°"),
            ("_n", "N"),
            ("_m", "m"),
            ("_s", "s"),
        ];
        units.iter().find(|(ending, _)| name.ends_with(ending)).map(|(_, unit)| *unit)
    }
}

fn as_number(value: &Value) -> Option<f64> {
    value.as_float().or_else(|| value.as_integer().map(|whole| whole as f64))
}

fn whole(path: &ScenarioPath, value: f64) -> Result<i64, String> {
    if value.fract() == 0.0 && value.abs() <= 9e15 {
        return Ok(value as i64);
    }
    Err(format!("`{path}` holds whole numbers, {value:?} is none; `round = true` rounds"))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn table() -> Table {
        let text = "[wall]\ncourses = 3\n[[loads]]\ntype = \"point\"\nforce_n = 1e4\n";
        let scenario = Scenario::parse(text).expect("a scenario");
        Table::try_from(scenario).expect("a table")
    }

    fn set(words: &str, cell: Cell, is_factor: bool) -> Result<Value, String> {
        let path: ScenarioPath = words.parse()?;
        let mut table = table();
        path.check(&table)?;
        let target = super::super::Target::Parameter(path.clone());
        let setting = Setting { target: &target, cell: &cell, is_factor, is_rounded: false };
        path.set(&mut table, &setting)?;
        Ok(path.get(&table).expect("the value").clone())
    }

    #[test]
    fn parameters_are_set_and_multiplied() {
        let number = Cell::Number;
        assert_eq!(set("wall.courses", number(5.0), false), Ok(Value::Integer(5)));
        assert_eq!(set("wall.mortar.tensile_pa", number(2.0), true), Ok(Value::Float(0.5e6)));
        assert_eq!(set("wall.brick.young_pa", Cell::Whole(5), false), Ok(Value::Float(5.0)));
        assert_eq!(set("loads[0].force_n", number(2e4), false), Ok(Value::Float(2e4)));
        // left out in the scenario
        assert_eq!(set("run.end_s", number(0.5), false), Ok(Value::Float(0.5)));
        assert_eq!(set("run.contact", Cell::Truth(false), false), Ok(Value::Boolean(false)));
    }

    #[test]
    fn what_does_not_fit_is_told() {
        let fault = |words: &str, cell: Cell| set(words, cell, false).expect_err("a fault");
        assert!(fault("wall.corses", Cell::Number(1.0)).contains("unknown field `corses`"));
        assert!(fault("wall.mortar", Cell::Number(1.0)).contains("not a single value"));
        assert!(fault("loads[1].force_n", Cell::Number(1.0)).contains("no parameter"));
        assert!(fault("wall.courses", Cell::Number(2.5)).contains("`round = true` rounds"));
        assert!(fault("wall.courses", Cell::Word("x".into())).contains("invalid type"));
        assert!(fault("wall..x", Cell::Number(1.0)).contains("names no parameter"));
        assert!(set("run.end_s", Cell::Number(2.0), true).expect_err("a fault").contains("factor"));
    }

    #[test]
    fn units_follow_from_names() {
        let unit = |words: &str| words.parse::<ScenarioPath>().ok()?.unit();
        assert_eq!(unit("wall.mortar.fracture_energy_n_m"), Some("N/m"));
        assert_eq!(unit("wall.gravity_m_s2"), Some("m/s²"));
        assert_eq!(unit("wall.courses"), None);
    }
}
