//! What a case expects and what comes out.

use serde::{Deserialize, Serialize};

/// A quantity of a case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Finding {
    /// Its name.
    pub quantity: String,
    /// Its unit; empty for numbers and statements.
    pub unit: String,
    /// What it should be.
    pub expected: Expected,
    /// What it is.
    pub obtained: Obtained,
    /// How far apart they may be.
    pub tolerance: Tolerance,
    /// What is worth saying; why they do not agree, where they do not.
    #[serde(default, skip_serializing_if = "String::is_empty")]
    pub note: String,
}

/// What a quantity should be.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Expected {
    /// A number.
    Value(f64),
    /// Any number from the first to the second.
    Range([f64; 2]),
    /// A statement.
    Text(String),
}

/// What a quantity is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Obtained {
    /// A number.
    Value(f64),
    /// A statement, and whether it is the expected one.
    Text {
        /// What is seen.
        text: String,
        /// Whether that is what is expected.
        holds: bool,
    },
}

/// How far expected and obtained may be apart.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum Tolerance {
    /// By this part of the expected number (of the bounds of a range).
    Relative(f64),
    /// By this much.
    Absolute(f64),
    /// Not judged, for this reason.
    NotJudged(String),
}

impl Finding {
    /// A number with a tolerance relative to what is expected.
    #[must_use]
    pub fn value(quantity: &str, unit: &str, expected: f64, obtained: f64, relative: f64) -> Self {
        let tolerance = Tolerance::Relative(relative);
        Self::new(quantity, unit, Expected::Value(expected), Obtained::Value(obtained), tolerance)
    }

    /// A number with a tolerance in its own unit: for numbers that should be zero.
    #[must_use]
    pub fn within(quantity: &str, unit: &str, expected: f64, obtained: f64, by: f64) -> Self {
        let tolerance = Tolerance::Absolute(by);
        Self::new(quantity, unit, Expected::Value(expected), Obtained::Value(obtained), tolerance)
    }

    /// A number that should lie in a range.
    #[must_use]
    pub fn range(quantity: &str, unit: &str, range: [f64; 2], obtained: f64) -> Self {
        let tolerance = Tolerance::Absolute(0.0);
        Self::new(quantity, unit, Expected::Range(range), Obtained::Value(obtained), tolerance)
    }

    /// A statement that should hold.
    #[must_use]
    pub fn statement(quantity: &str, expected: &str, obtained: &str, holds: bool) -> Self {
        let seen = Obtained::Text { text: obtained.to_owned(), holds };
        let tolerance = Tolerance::Absolute(0.0);
        Self::new(quantity, "", Expected::Text(expected.to_owned()), seen, tolerance)
    }

    /// A number that is told beside another one without judgement.
    #[must_use]
    pub fn told(quantity: &str, unit: &str, expected: f64, obtained: f64, reason: &str) -> Self {
        let tolerance = Tolerance::NotJudged(reason.to_owned());
        Self::new(quantity, unit, Expected::Value(expected), Obtained::Value(obtained), tolerance)
    }

    fn new(
        quantity: &str,
        unit: &str,
        expected: Expected,
        obtained: Obtained,
        tolerance: Tolerance,
    ) -> Self {
        let (quantity, unit) = (quantity.to_owned(), unit.to_owned());
        Self { quantity, unit, expected, obtained, tolerance, note: String::new() }
    }

    /// The same with a remark.
    #[must_use]
    pub fn noted(mut self, note: impl Into<String>) -> Self {
        self.note = note.into();
        self
    }

    /// How far obtained is from expected; none for statements.
    #[must_use]
    pub fn difference(&self) -> Option<f64> {
        let Obtained::Value(obtained) = self.obtained else { return None };
        match self.expected {
            Expected::Value(expected) => Some(obtained - expected),
            Expected::Range([low, high]) => Some(obtained - obtained.clamp(low, high)),
            Expected::Text(_) => None,
        }
    }

    /// Whether it is judged at all.
    #[must_use]
    pub fn is_judged(&self) -> bool {
        !matches!(self.tolerance, Tolerance::NotJudged(_))
    }

    /// Whether expected and obtained agree; what is not judged does.
    #[must_use]
    pub fn agrees(&self) -> bool {
        let size = match self.expected {
            Expected::Value(v) => v.abs(),
            Expected::Range([low, high]) => low.abs().max(high.abs()),
            Expected::Text(_) => 0.0,
        };
        let most = match self.tolerance {
            Tolerance::NotJudged(_) => return true,
            Tolerance::Relative(part) => part * size,
            Tolerance::Absolute(by) => by,
        };
        match (&self.obtained, self.difference()) {
            (Obtained::Text { holds, .. }, _) => *holds,
            // NaN does not agree
            (_, Some(difference)) => difference.abs() <= most,
            (_, None) => false,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agreement_has_the_tolerance_that_is_given() {
        assert!(Finding::value("a", "m", 2.0, 2.019, 0.01).agrees());
        assert!(!Finding::value("a", "m", -2.0, -2.021, 0.01).agrees());
        assert!(Finding::within("a", "m", 0.0, 1e-7, 1e-6).agrees());
        assert!(!Finding::within("a", "m", 0.0, f64::NAN, 1e-6).agrees());
        assert!(Finding::range("a", "m", [1.0, 2.0], 2.0).agrees());
        assert!(!Finding::range("a", "m", [1.0, 2.0], 2.1).agrees());
        assert!(!Finding::statement("a", "stands", "falls", false).agrees());
        assert!(Finding::told("a", "m", 1.0, 5.0, "no data").agrees());
    }
}
