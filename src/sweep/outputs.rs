//! What is told of each case: columns of the table, from the tables that `ypsilon extract` makes.

use super::study_file::{At, OutputTable};
use crate::session::Format;
use ypsilon_post::{PostError, extract::Place, field::Field, selection::Selection};

/// A number of each case.
#[derive(Debug, Clone, PartialEq)]
pub struct Output {
    /// Its name, a column of the table.
    pub name: String,
    /// Where it comes from.
    pub source: Source,
    /// Which value of a table over time it is.
    pub at: When,
}

/// Where a number comes from.
#[derive(Debug, Clone, PartialEq)]
pub enum Source {
    /// A field at a place.
    History(Place, Field),
    /// Kinetic energy.
    Energy,
    /// A column of the table of joints.
    Joints(String),
    /// A column of the table of extremes of a field: `min`, `max`, `x of max`, ...
    Extremes(Field, String),
    /// Reaction of nodes along an axis.
    Reaction(Selection, usize),
    /// Mean displacement of nodes along an axis.
    MeanDisplacement(Selection, usize),
    /// A column of the table that `--monitor` writes.
    Monitors(String),
    /// A column of the table that `--energy` writes.
    Balance(String),
    /// A history that the deck asks for, by number.
    Yh(usize),
    /// A figure of the run's summary.
    Run(Figure),
}

/// A figure of a run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Figure {
    /// Wall-clock time of the steps, s.
    Seconds,
    /// Steps done.
    Steps,
    /// Physical time at the end, s.
    Time,
    /// Joints that failed.
    BrokenJoints,
    /// Kinetic energy at the end, J.
    KineticEnergy,
    /// Largest error of the energy balance by the largest energy, with `--energy`.
    EnergyError,
    /// Iterations of `--settle`.
    SettlingIterations,
}

/// Figures with their names and units.
const FIGURES: [(Figure, &str, &str); 7] = [
    (Figure::Seconds, "seconds", "s"),
    (Figure::Steps, "steps", ""),
    (Figure::Time, "time", "s"),
    (Figure::BrokenJoints, "broken-joints", ""),
    (Figure::KineticEnergy, "kinetic-energy", "J"),
    (Figure::EnergyError, "energy-error", ""),
    (Figure::SettlingIterations, "settling-iterations", ""),
];

/// Which value of a table over time is taken.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum When {
    /// The last.
    End,
    /// The first.
    Start,
    /// The largest.
    Max,
    /// The smallest.
    Min,
    /// The one with the largest magnitude, with its sign.
    MaxAbs,
    /// The time of the largest, s.
    TimeOfMax,
    /// The time of the smallest, s.
    TimeOfMin,
    /// That at a time, s: on the straight line between its neighbours.
    Time(f64),
}

const WHENS: [(When, &str); 7] = [
    (When::End, "end"),
    (When::Start, "start"),
    (When::Max, "max"),
    (When::Min, "min"),
    (When::MaxAbs, "max-abs"),
    (When::TimeOfMax, "time-of-max"),
    (When::TimeOfMin, "time-of-min"),
];

/// Sources with the keys that they take.
const SOURCES: [(&str, &[&str]); 10] = [
    ("history", &["field", "node", "point", "nearest"]),
    ("energy", &[]),
    ("joints", &["column"]),
    ("extremes", &["field", "column"]),
    ("reaction", &["nodes", "direction"]),
    ("mean-displacement", &["nodes", "direction"]),
    ("monitors", &["column"]),
    ("balance", &["column"]),
    ("yh", &["number"]),
    ("run", &["column"]),
];

impl Output {
    /// An output of a study file.
    pub(super) fn of(name: &str, table: &OutputTable) -> Result<Self, String> {
        check_keys(table)?;
        let needed = |key: &str| format!("`what = \"{}\"` needs `{key}`", table.what);
        let field = || -> Result<Field, String> {
            let words = table.field.as_ref().ok_or_else(|| needed("field"))?;
            words.parse().map_err(|error: PostError| error.to_string())
        };
        let column = || table.column.clone().ok_or_else(|| needed("column"));
        let nodes = || -> Result<Selection, String> {
            let words = table.nodes.as_ref().ok_or_else(|| needed("nodes"))?;
            words.parse().map_err(|error: PostError| error.to_string())
        };
        let axis = || match table.direction.as_deref() {
            Some("x") => Ok(0),
            Some("y") => Ok(1),
            Some("z") => Ok(2),
            Some(other) => {
                Err(format!("the direction `{other}` is none: expected x, y or, in space, z"))
            }
            None => Err(needed("direction")),
        };
        let source = match table.what.as_str() {
            "history" => {
                let places = [
                    table.node.map(Place::Node),
                    table.point.map(|point| Place::Point(point.into())),
                    table.nearest.map(|point| Place::Nearest(point.into())),
                ];
                let mut places = places.into_iter().flatten();
                match (places.next(), places.next()) {
                    (Some(place), None) => Source::History(place, field()?),
                    _ => {
                        return Err("`what = \"history\"` needs one of `node`, `point` and \
                                    `nearest`"
                            .to_owned());
                    }
                }
            }
            "energy" => Source::Energy,
            "joints" => Source::Joints(column()?),
            "extremes" => {
                Source::Extremes(field()?, table.column.clone().unwrap_or("max".to_owned()))
            }
            "reaction" => Source::Reaction(nodes()?, axis()?),
            "mean-displacement" => Source::MeanDisplacement(nodes()?, axis()?),
            "monitors" => Source::Monitors(column()?),
            "balance" => Source::Balance(column()?),
            "yh" => Source::Yh(table.number.unwrap_or(0)),
            _ => {
                let column = column()?;
                let figure = FIGURES.iter().find(|(_, name, _)| *name == column);
                let names = || FIGURES.map(|(_, name, _)| name).join(", ");
                let wrong = || format!("the run has no figure `{column}`: expected {}", names());
                if table.at.is_some() {
                    return Err("figures of the run have no times: leave `at` out".to_owned());
                }
                Source::Run(figure.ok_or_else(wrong)?.0)
            }
        };
        Ok(Self { name: name.to_owned(), source, at: when(table.at.as_ref())? })
    }

    /// Checks that results of so many dimensions have it; one sentence if they do not.
    pub(super) fn check(&self, dimension: usize) -> Result<(), String> {
        let words = |error: PostError| error.to_string();
        match &self.source {
            Source::History(place, field) => {
                field.check(dimension).map_err(words)?;
                match place {
                    Place::Point(point) | Place::Nearest(point) => {
                        point.check(dimension).map_err(words)
                    }
                    Place::Node(_) => Ok(()),
                }
            }
            Source::Extremes(field, _) => field.check(dimension).map_err(words),
            Source::Reaction(nodes, axis) | Source::MeanDisplacement(nodes, axis) => {
                if *axis >= dimension {
                    let expected = "expected x or y: the base is one of the plane";
                    return Err(format!("there is no direction z; {expected}"));
                }
                nodes.check(dimension).map_err(words)
            }
            Source::Monitors(_) if dimension > 2 => Err("monitors are sums over bodies in the \
                                                         plane: take `reaction`, \
                                                         `mean-displacement` or `energy`"
                .to_owned()),
            _ => Ok(()),
        }
    }

    /// Its name with the unit behind it in brackets, where there is one.
    #[must_use]
    pub fn heading(&self) -> String {
        let unit = match (&self.source, self.at) {
            (_, When::TimeOfMax | When::TimeOfMin) => "s",
            (Source::Extremes(_, column), _) if column.contains(" of ") => "m",
            (Source::History(_, field) | Source::Extremes(field, _), _) => field.quantity().unit(),
            (Source::Energy | Source::Balance(_), _) => "J",
            (Source::Reaction(..), _) => "N",
            (Source::MeanDisplacement(..), _) => "m",
            (Source::Joints(column), _) if column.contains("length") => "m",
            (Source::Joints(column), _) if column.contains("area") => "m²",
            (Source::Joints(_) | Source::Monitors(_) | Source::Yh(_), _) => "",
            (Source::Run(figure), _) => {
                FIGURES.iter().find(|(f, ..)| f == figure).map_or("", |(.., unit)| *unit)
            }
        };
        heading(&self.name, unit)
    }

    /// The kind of result file that it is read from.
    #[must_use]
    pub fn format(&self) -> Option<Format> {
        match self.source {
            Source::Yh(_) => Some(Format::Yh),
            Source::Run(_) | Source::Monitors(_) | Source::Balance(_) => None,
            _ => Some(Format::Vtu),
        }
    }
}

/// A name with a unit in brackets behind it.
pub(super) fn heading(name: &str, unit: &str) -> String {
    if unit.is_empty() { name.to_owned() } else { format!("{name} ({unit})") }
}

fn check_keys(table: &OutputTable) -> Result<(), String> {
    let Some((_, keys)) = SOURCES.iter().find(|(what, _)| *what == table.what) else {
        let names = SOURCES.map(|(what, _)| what).join(", ");
        return Err(format!("there is no `what = \"{}\"`: expected {names}", table.what));
    };
    let given = [
        ("field", table.field.is_some()),
        ("node", table.node.is_some()),
        ("point", table.point.is_some()),
        ("nearest", table.nearest.is_some()),
        ("nodes", table.nodes.is_some()),
        ("direction", table.direction.is_some()),
        ("column", table.column.is_some()),
        ("number", table.number.is_some()),
    ];
    match given.iter().find(|(key, is_given)| *is_given && !keys.contains(key)) {
        Some((key, _)) => Err(format!("`{key}` means nothing for `what = \"{}\"`", table.what)),
        None => Ok(()),
    }
}

fn when(at: Option<&At>) -> Result<When, String> {
    match at {
        None => Ok(When::End),
        Some(At::Time(time)) if time.is_finite() => Ok(When::Time(*time)),
        Some(At::Time(time)) => Err(format!("the time {time} is not finite")),
        Some(At::Word(word)) => {
            let known = WHENS.iter().find(|(_, name)| name == word).map(|(when, _)| *when);
            known.ok_or_else(|| {
                let names = WHENS.map(|(_, name)| name).join(", ");
                format!("`at = \"{word}\"` is no time: expected a time in s, or {names}")
            })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn fault(text: &str) -> String {
        let table: OutputTable = toml::from_str(text).expect("a table");
        Output::of("u", &table).expect_err("a fault")
    }

    #[test]
    fn bad_outputs_are_told() {
        assert!(fault("what = 'histories'").contains("expected history, energy"));
        assert!(
            fault("what = 'history'\nfield = 'ux'")
                .contains("one of `node`, `point` and `nearest`")
        );
        assert!(fault("what = 'history'\nnode = 1\nfield = 'ur'").contains("`ur`"));
        assert!(fault("what = 'energy'\nnode = 1").contains("`node` means nothing"));
        assert!(fault("what = 'run'\ncolumn = 'second'").contains("expected seconds, steps"));
        assert!(fault("what = 'run'\ncolumn = 'steps'\nat = 'max'").contains("no times"));
        assert!(fault("what = 'energy'\nat = 'top'").contains("max-abs"));
        let reaction = "what = 'reaction'\nnodes = 'set:1'\ndirection = 'w'";
        assert!(fault(reaction).contains("expected x, y or, in space, z"));
    }

    #[test]
    fn points_have_two_or_three_coordinates() {
        for point in ["[1]", "[1, 2, 3, 4]", "'1,2'"] {
            let text = format!("what = 'history'\nfield = 'ux'\nnearest = {point}");
            let fault = toml::from_str::<OutputTable>(&text).expect_err("a fault").to_string();
            assert!(fault.contains("expected [X, Y] in the plane or [X, Y, Z]"), "{fault}");
        }
    }

    #[test]
    fn headings_have_units() {
        let heading = |text: &str| {
            let table: OutputTable = toml::from_str(text).expect("a table");
            Output::of("u", &table).expect("an output").heading()
        };
        assert_eq!(heading("what = 'history'\nnode = 1\nfield = 'syy'"), "u (Pa)");
        assert_eq!(heading("what = 'energy'\nat = 'time-of-max'"), "u (s)");
        assert_eq!(heading("what = 'joints'\ncolumn = 'broken'"), "u");
        assert_eq!(heading("what = 'extremes'\nfield = 'uy'\ncolumn = 'x of min'"), "u (m)");
        assert_eq!(heading("what = 'joints'\ncolumn = 'broken area'"), "u (m²)");
        assert_eq!(heading("what = 'history'\nfield = 'uz'\npoint = [0, 0.5, 1]"), "u (m)");
    }
}
