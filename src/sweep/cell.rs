//! What stands in a cell of a study's table.

use std::fmt;
use ypsilon_post::table::number;

/// A value of a parameter or an output.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// A number; NaN where there is none.
    Number(f64),
    /// A whole number of a scenario, which is not to become a real.
    Whole(i64),
    /// A word of a scenario.
    Word(String),
    /// A yes or no of a scenario.
    Truth(bool),
}

impl Cell {
    /// Its number; yes and no are 1 and 0, words have none.
    #[must_use]
    pub fn value(&self) -> Option<f64> {
        match self {
            Self::Number(value) => Some(*value),
            Self::Whole(value) => Some(*value as f64),
            Self::Truth(value) => Some(f64::from(u8::from(*value))),
            Self::Word(_) => None,
        }
    }
}

impl fmt::Display for Cell {
    /// As tables have it: numbers as short as they can be read back exactly.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Word(word) => f.write_str(word),
            Self::Whole(value) => write!(f, "{value}"),
            other => f.write_str(&number(other.value().unwrap_or(f64::NAN))),
        }
    }
}
