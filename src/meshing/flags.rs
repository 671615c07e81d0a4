//! Parameters of scenarios as flags of the command line, from the scenarios' own schema: names,
//! meanings and defaults are told once, in the structures themselves.

use super::{MeshingError, Scenario};
use serde_json::Value;

/// A parameter that can be given as a flag.
#[derive(Debug, Clone, PartialEq)]
pub struct Flag {
    /// Name of the flag without its dashes, such as `stone.young-pa`.
    pub name: String,
    /// Where the value stands in a scenario, such as `bridge.stone.young_pa`.
    pub path: Vec<String>,
    /// Meaning and unit.
    pub help: String,
    /// What it is if it is not given; none where that follows from other parameters.
    pub default: Option<String>,
}

/// The flags of a kind of structure; none if there is no such kind.
///
/// Parameters of the structure and of the run have their own names, those of tables in them
/// `TABLE.NAME`, with dashes for underscores.
#[must_use]
pub fn flags(kind: &str) -> Vec<Flag> {
    let schema = schemars::schema_for!(Scenario).to_value();
    let defaults = Scenario::of_kind(kind)
        .and_then(|scenario| toml::Table::try_from(scenario).ok())
        .unwrap_or_default();
    let mut found = Vec::new();
    for (table, prefix) in [(kind, ""), ("run", ""), ("staging", "staging.")] {
        let Some(properties) = schema.pointer(&format!("/properties/{table}")) else { continue };
        let walk = Walk { schema: &schema, defaults: &defaults };
        walk.collect(properties, &[table.to_owned()], prefix, &mut found);
    }
    found
}

struct Walk<'a> {
    schema: &'a Value,
    defaults: &'a toml::Table,
}

impl Walk<'_> {
    fn collect(&self, node: &Value, path: &[String], prefix: &str, found: &mut Vec<Flag>) {
        let Some(properties) = self.resolve(node)["properties"].as_object() else { return };
        for (key, property) in properties {
            let mut path = path.to_vec();
            path.push(key.clone());
            let name = format!("{prefix}{}", key.replace('_', "-"));
            if self.resolve(property)["properties"].is_object() {
                self.collect(property, &path, &format!("{name}."), found);
                continue;
            }
            let help = property["description"].as_str().unwrap_or_default();
            let help = help.replace('\n', " ").replace("\\[", "[").replace("\\]", "]");
            let default = self.default(&path);
            found.push(Flag { name, path, help, default });
        }
    }

    /// Follows references, and optional values to what they may hold.
    fn resolve<'v>(&'v self, node: &'v Value) -> &'v Value {
        let reference = |node: &Value| {
            let path = node["$ref"].as_str()?.strip_prefix('#')?.to_owned();
            self.schema.pointer(&path)
        };
        let alternatives = node["anyOf"].as_array().into_iter().flatten();
        std::iter::once(node).chain(alternatives).find_map(reference).unwrap_or(node)
    }

    fn default(&self, path: &[String]) -> Option<String> {
        let (last, tables) = path.split_last()?;
        let table = tables
            .iter()
            .try_fold(self.defaults, |table, key| table.get(key).and_then(|v| v.as_table()))?;
        Some(table.get(last)?.to_string())
    }
}

/// A scenario of a kind from flags, over a scenario that may be given already. Loads are words:
/// the type, then `name=value`.
///
/// # Errors
/// If the values do not fit, with the flag.
pub fn scenario_from_flags(
    kind: &str,
    base: Option<&Scenario>,
    values: &[(Flag, String)],
    loads: &[String],
) -> Result<Scenario, MeshingError> {
    let own = Scenario::of_kind(kind);
    let start = base.or(own.as_ref()).cloned().unwrap_or_default();
    let mut table = toml::Table::try_from(&start).map_err(unusual)?;
    for (flag, text) in values {
        let Some((last, tables)) = flag.path.split_last() else { continue };
        let mut here = &mut table;
        for key in tables {
            let empty = || toml::Value::Table(toml::Table::new());
            let next = here.entry(key.clone()).or_insert_with(empty);
            here = next.as_table_mut().ok_or_else(|| misplaced(flag))?;
        }
        here.insert(last.clone(), value(text));
        // one at a time, so that a value that does not fit is told with its flag
        let attempt: Result<Scenario, _> = table.clone().try_into();
        if let Err(error) = attempt {
            return Err(MeshingError::Parameter {
                name: format!("--{}", flag.name),
                value: text.clone(),
                expected: error.message().to_owned(),
            });
        }
    }
    let mut scenario: Scenario = table.try_into().map_err(unusual)?;
    for text in loads {
        let mut load = toml::Table::new();
        let mut words = text.split_whitespace();
        load.insert("type".to_owned(), words.next().unwrap_or_default().into());
        for word in words {
            let Some((name, text)) = word.split_once('=') else {
                let expected = "a load is a type and its numbers: `point force_n=1e6 x_m=0`";
                return Err(MeshingError::parameter("--load", text, expected));
            };
            load.insert(name.replace('-', "_"), value(text));
        }
        scenario.loads.push(load.try_into().map_err(|error: toml::de::Error| {
            MeshingError::parameter("--load", text, error.message())
        })?);
    }
    Ok(scenario)
}

/// A value as TOML would read it; what it would not is a word.
fn value(text: &str) -> toml::Value {
    let parsed = toml::from_str::<toml::Table>(&format!("value = {text}"));
    let found = parsed.ok().filter(|table| table.len() == 1);
    found
        .and_then(|mut table| table.remove("value"))
        .unwrap_or_else(|| toml::Value::String(text.to_owned()))
}

fn misplaced(flag: &Flag) -> MeshingError {
    MeshingError::Scenario(format!("--{} has no place in this scenario", flag.name))
}

fn unusual(error: impl std::fmt::Display) -> MeshingError {
    MeshingError::Scenario(error.to_string())
}
