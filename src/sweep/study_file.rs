//! The TOML file of a study, with the places of what may be wrong.

use serde::Deserialize;
use std::{collections::BTreeMap, path::PathBuf};
use toml::Spanned;
use ypsilon_post::Point;

/// The whole file.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct StudyFile {
    pub title: Option<String>,
    pub base: Spanned<PathBuf>,
    pub folder: Option<PathBuf>,
    pub table: Option<Vec<Spanned<String>>>,
    pub sampling: Option<Spanned<SamplingTable>>,
    pub run: Option<Spanned<RunTable>>,
    #[serde(default)]
    pub parameters: BTreeMap<Spanned<String>, ParameterTable>,
    #[serde(default)]
    pub outputs: BTreeMap<Spanned<String>, Spanned<OutputTable>>,
}

/// `[sampling]`
#[derive(Debug, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SamplingTable {
    pub method: Option<Spanned<String>>,
    pub samples: Option<usize>,
    pub seed: Option<u64>,
}

/// `[run]`
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct RunTable {
    pub flags: Option<Spanned<Vec<String>>>,
    #[serde(default)]
    pub formats: Vec<String>,
    pub threads: Option<usize>,
    pub checkpoint_every: Option<u64>,
    #[serde(default = "yes")]
    pub keep: bool,
}

fn yes() -> bool {
    true
}

/// `[parameters.NAME]`
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ParameterTable {
    pub target: Spanned<OneOrMore>,
    pub values: Option<Spanned<Vec<toml::Value>>>,
    pub linspace: Option<Spanned<Spacing>>,
    pub logspace: Option<Spanned<Spacing>>,
    pub uniform: Option<Spanned<Range>>,
    pub log_uniform: Option<Spanned<Range>>,
    #[serde(default)]
    pub factor: bool,
    #[serde(default)]
    pub round: bool,
    pub unit: Option<String>,
}

/// A word, or a list of them.
#[derive(Debug, Deserialize)]
#[serde(untagged, expecting = "expected a target, or a list of targets: words")]
pub(super) enum OneOrMore {
    One(String),
    More(Vec<String>),
}

impl OneOrMore {
    pub fn words(&self) -> &[String] {
        match self {
            Self::One(word) => std::slice::from_ref(word),
            Self::More(words) => words,
        }
    }
}

/// `{ from = 1e9, to = 9e9, count = 5 }`
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Spacing {
    pub from: f64,
    pub to: f64,
    pub count: usize,
}

/// `[LOW, HIGH]`
pub(super) type Range = [f64; 2];

/// `[outputs.NAME]`
#[derive(Debug, Clone, Default, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OutputTable {
    pub what: String,
    pub field: Option<String>,
    pub node: Option<usize>,
    pub point: Option<Coordinates>,
    pub nearest: Option<Coordinates>,
    pub nodes: Option<String>,
    pub direction: Option<String>,
    pub column: Option<String>,
    pub number: Option<usize>,
    pub at: Option<At>,
}

/// A point in the plane or in space, m.
#[derive(Debug, Clone, Copy, Deserialize)]
#[serde(untagged, expecting = "expected [X, Y] in the plane or [X, Y, Z] in space")]
pub(super) enum Coordinates {
    Plane([f64; 2]),
    Space([f64; 3]),
}

impl From<Coordinates> for Point {
    fn from(coordinates: Coordinates) -> Self {
        match coordinates {
            Coordinates::Plane(x) => Self::Plane(x),
            Coordinates::Space(x) => Self::Space(x),
        }
    }
}

/// A time in s, or a word.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(untagged, expecting = "expected a time in s, or one of end, start, max, min, ...")]
pub(super) enum At {
    Time(f64),
    Word(String),
}
