//! What a study varies: a deck or a scenario, with other values in some places.

use super::{cell::Cell, scenario_path::ScenarioPath};
use crate::{
    meshing::{AnyKind, Scenario},
    session::monitors,
};
use std::path::{Component, Path, PathBuf};
use yformat::{
    checksum::Checksum,
    deck::{Deck, DeckReader, Entry, EntryPath, Number},
    diagnostic::Diagnostic,
    dialect::Dialect,
    keywords::NumberKind,
    source::SourceMap,
};

/// The deck or scenario that all cases of a study begin with.
#[derive(Debug)]
pub enum Base {
    /// A deck of any dialect.
    Deck {
        /// Its file.
        path: PathBuf,
        /// The deck.
        deck: Box<Deck>,
        /// Checksum of its files.
        print: u64,
    },
    /// A scenario of `ypsilon mesh`.
    Scenario {
        /// Its file.
        path: PathBuf,
        /// All parameters, those with defaults among them.
        table: toml::Table,
        /// Whether it asks for monitors.
        has_monitors: bool,
        /// Number of dimensions.
        dimension: usize,
    },
}

/// Why a base cannot be read.
#[derive(Debug)]
pub(super) enum BaseError {
    /// One sentence.
    Words(String),
    /// The deck has errors.
    Deck(Box<SourceMap>, Vec<Diagnostic>),
}

/// A place of the base that a parameter sets.
#[derive(Debug, Clone, PartialEq)]
pub enum Target {
    /// Numbers of a deck.
    Entries(Vec<Entry>),
    /// A parameter of a scenario.
    Parameter(ScenarioPath),
}

/// A value and where it goes.
#[derive(Debug, Clone)]
pub(super) struct Setting<'a> {
    pub target: &'a Target,
    pub cell: &'a Cell,
    /// Whether the value multiplies what the base has.
    pub is_factor: bool,
    /// Whether numbers are rounded to whole ones.
    pub is_rounded: bool,
}

/// A file of a case: its name in the folder of the case, and its bytes.
pub(super) type CaseFile = (PathBuf, Vec<u8>);

impl Base {
    /// Reads a base: scenarios end in `.toml`.
    pub(super) fn read(path: &Path, dialect: Option<Dialect>) -> Result<Self, BaseError> {
        if path.extension().is_some_and(|ending| ending == "toml") {
            let words = |error: &dyn std::fmt::Display| {
                BaseError::Words(format!("{}: {error}", path.display()))
            };
            let scenario = Scenario::read(path).map_err(|e| words(&e))?;
            let (_, kind) = scenario.kind().map_err(|e| words(&e))?;
            let dimension = if matches!(kind, AnyKind::Spatial(_)) { 3 } else { 2 };
            let plan = monitors(&scenario, path).map_err(|e| BaseError::Words(e.to_string()))?;
            let table = toml::Table::try_from(&scenario).map_err(|e| words(&e))?;
            let has_monitors = !plan.is_empty();
            let path = path.to_path_buf();
            return Ok(Self::Scenario { path, table, has_monitors, dimension });
        }
        let outcome = DeckReader::new().dialect(dialect).read(path);
        let outcome = outcome.map_err(|error| {
            BaseError::Words(format!("cannot read {}: {error}", path.display()))
        })?;
        if outcome.has_errors() {
            let sources = Box::new(outcome.deck.sources().clone());
            return Err(BaseError::Deck(sources, outcome.diagnostics));
        }
        let mut print = Checksum::new();
        for source in outcome.deck.sources().iter().skip(1) {
            inside(source.name()).map_err(BaseError::Words)?;
            print.add(source.name().as_bytes());
        }
        outcome.deck.sources().iter().for_each(|source| print.add(source.bytes()));
        let (path, print) = (path.to_path_buf(), print.value());
        Ok(Self::Deck { path, deck: Box::new(outcome.deck), print })
    }

    /// Its file.
    #[must_use]
    pub fn path(&self) -> &Path {
        match self {
            Self::Deck { path, .. } | Self::Scenario { path, .. } => path,
        }
    }

    /// Whether runs of it write monitors, beside those of the command line.
    #[must_use]
    pub fn has_monitors(&self) -> bool {
        matches!(self, Self::Scenario { has_monitors: true, .. })
    }

    /// Number of dimensions of its results, 2 or 3.
    #[must_use]
    pub fn dimension(&self) -> usize {
        let deck = match self {
            Self::Scenario { dimension, .. } => return *dimension,
            Self::Deck { deck, .. } => deck,
        };
        let told = || {
            let entries = deck.entries(&"YDN/NNODIM".parse().ok()?).ok()?;
            deck.number(*entries.first()?).map(Number::value)
        };
        match deck.dialect() {
            Dialect::Y3d => 3,
            Dialect::Split if told() == Some(3.0) => 3,
            _ => 2,
        }
    }

    /// The place that words mean.
    ///
    /// # Errors
    /// If the base has no such place; one sentence.
    pub fn target(&self, words: &str) -> Result<Target, String> {
        match self {
            Self::Deck { deck, .. } => {
                let path: EntryPath = words.parse().map_err(|e| format!("{e}"))?;
                deck.entries(&path).map(Target::Entries).map_err(|e| e.to_string())
            }
            Self::Scenario { table, .. } => {
                let path: ScenarioPath = words.parse()?;
                path.check(table)?;
                Ok(Target::Parameter(path))
            }
        }
    }

    /// Unit of the numbers at a place, where it is known.
    #[must_use]
    pub fn unit(&self, target: &Target) -> Option<&'static str> {
        match (self, target) {
            (Self::Deck { deck, .. }, Target::Entries(entries)) => {
                let item = deck.item(entries.first()?.item)?;
                let unit = item.assignment()?.keyword.unit;
                Some(unit).filter(|unit| *unit != "-")
            }
            (_, Target::Parameter(path)) => path.unit(),
            _ => None,
        }
    }

    /// Whether the place holds whole numbers, as far as it is known.
    #[must_use]
    pub fn is_whole(&self, target: &Target) -> bool {
        match (self, target) {
            (Self::Deck { deck, .. }, Target::Entries(entries)) => {
                let assignment = entries.first().and_then(|e| deck.item(e.item)?.assignment());
                assignment.is_some_and(|a| a.keyword.number == NumberKind::Integer)
            }
            (Self::Scenario { table, .. }, Target::Parameter(path)) => {
                matches!(path.get(table), Some(toml::Value::Integer(_)))
            }
            _ => false,
        }
    }

    /// What a case differs by from the base, as text for its checksum, one line for each number.
    pub(super) fn describe(&self, settings: &[Setting<'_>]) -> Result<String, String> {
        match self {
            Self::Deck { print, .. } => {
                let changes = self.changes(settings)?;
                let line = |(entry, number): &(Entry, Number)| {
                    format!("{}:{}={number}\n", entry.item, entry.ordinal)
                };
                Ok(format!("{print:016x}\n{}", changes.iter().map(line).collect::<String>()))
            }
            Self::Scenario { .. } => self.scenario(settings),
        }
    }

    /// The files of a case.
    pub(super) fn files(&self, settings: &[Setting<'_>]) -> Result<Vec<CaseFile>, String> {
        let name = PathBuf::from(self.path().file_name().unwrap_or_default());
        let Self::Deck { deck, .. } = self else {
            return Ok(vec![(name, self.scenario(settings)?.into_bytes())]);
        };
        let changed = deck.with_numbers(&self.changes(settings)?).map_err(|e| e.to_string())?;
        let mut files: Vec<CaseFile> = Vec::new();
        for (index, source) in deck.sources().iter().enumerate() {
            let own = if index == 0 { name.clone() } else { inside(source.name())? };
            let new = changed.iter().find(|(id, _)| id.index() == index);
            let bytes = new.map_or_else(|| source.bytes().to_vec(), |(_, bytes)| bytes.clone());
            match files.iter().find(|(other, _)| *other == own) {
                Some((_, other)) if *other != bytes => {
                    return Err(format!(
                        "{} is included twice, and its numbers are not to be the same each time: \
                         set them with @*",
                        own.display()
                    ));
                }
                Some(_) => {}
                None => files.push((own, bytes)),
            }
        }
        Ok(files)
    }

    fn changes(&self, settings: &[Setting<'_>]) -> Result<Vec<(Entry, Number)>, String> {
        let Self::Deck { deck, .. } = self else { return Ok(Vec::new()) };
        let mut changes = Vec::new();
        for setting in settings {
            let Target::Entries(entries) = setting.target else { continue };
            let value = setting.cell.value().ok_or_else(|| {
                format!("`{}` is no number; decks hold nothing but numbers", setting.cell)
            })?;
            for &entry in entries {
                let was = deck.number(entry).map_or(f64::NAN, Number::value);
                let value = setting.number(value, was);
                let number = deck.number_for(entry, value).map_err(|e| e.to_string())?;
                changes.push((entry, number));
            }
        }
        Ok(changes)
    }

    fn scenario(&self, settings: &[Setting<'_>]) -> Result<String, String> {
        let Self::Scenario { table, .. } = self else { return Ok(String::new()) };
        let mut table = table.clone();
        for setting in settings {
            if let Target::Parameter(path) = setting.target {
                path.set(&mut table, setting)?;
            }
        }
        toml::to_string(&table).map_err(|error| error.to_string())
    }
}

impl Setting<'_> {
    /// What a number becomes that was `was`.
    pub fn number(&self, value: f64, was: f64) -> f64 {
        let value = if self.is_factor { value * was } else { value };
        if self.is_rounded { value.round() } else { value }
    }
}

/// The place of an included file within the folder of a case.
fn inside(name: &str) -> Result<PathBuf, String> {
    let path = PathBuf::from(name);
    let is_inside =
        path.components().all(|c| matches!(c, Component::Normal(_) | Component::CurDir));
    if is_inside && !name.contains('\\') {
        return Ok(path);
    }
    Err(format!(
        "the deck includes `{name}`, which lies outside of its folder: every case gets copies of \
         included files, so they have to lie in or below the folder of the deck"
    ))
}
