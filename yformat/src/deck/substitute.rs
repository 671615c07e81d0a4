//! Decks with other numbers: every other byte stays.

use std::collections::BTreeMap;

use super::item::Value;
use super::{Deck, Entry, Number};
use crate::source::SourceId;

/// A number that cannot be put into a deck.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum SubstituteError {
    /// The keyword holds integers.
    #[error("{keyword} holds whole numbers, {value} is none")]
    NotWhole {
        /// The keyword.
        keyword: String,
        /// The number.
        value: String,
    },
    /// Decks hold finite numbers.
    #[error("{keyword} = {value} is not finite")]
    NotFinite {
        /// The keyword.
        keyword: String,
        /// The number.
        value: String,
    },
    /// The item is new or changed, no number, or not there.
    #[error("the deck has no number there")]
    NoNumber,
}

impl Deck {
    /// A number of the kind that the keyword of an entry holds.
    ///
    /// ```
    /// use yformat::deck::{Deck, Number};
    ///
    /// let deck = Deck::parse("a.y", "/YD/YDC/MCSTEP 5\n").deck;
    /// let entry = deck.entries(&"MCSTEP".parse().unwrap()).unwrap()[0];
    /// assert_eq!(deck.number_for(entry, 8.0), Ok(Number::Integer(8)));
    /// assert!(deck.number_for(entry, 8.5).is_err());
    /// ```
    ///
    /// # Errors
    /// If it is not finite, or the keyword holds integers and the value is none.
    pub fn number_for(&self, entry: Entry, value: f64) -> Result<Number, SubstituteError> {
        let assignment = self.item(entry.item).and_then(|item| item.assignment());
        let assignment = assignment.ok_or(SubstituteError::NoNumber)?;
        let keyword = || assignment.keyword.path();
        if !value.is_finite() {
            let value = value.to_string();
            return Err(SubstituteError::NotFinite { keyword: keyword(), value });
        }
        match assignment.value {
            Value::Real(_) | Value::Reals(_) => Ok(Number::Real(value)),
            // beyond 2⁵³ not every whole number is a double
            Value::Integer(_) | Value::Integers(_)
                if value.fract() == 0.0 && value.abs() <= 9e15 =>
            {
                Ok(Number::Integer(value as i64))
            }
            Value::Integer(_) | Value::Integers(_) => {
                let value = format!("{value:?}");
                Err(SubstituteError::NotWhole { keyword: keyword(), value })
            }
        }
    }

    /// The bytes of the deck's files with other numbers in some places: only files that change are
    /// given, and in them every other byte is as it was read. Where an array gives fewer numbers
    /// than it announces and one of them changes, those that are missing are written out.
    ///
    /// ```
    /// use yformat::deck::{Deck, Number};
    ///
    /// let deck = Deck::parse("a.y", "/YD/YDC/DCSTEC  1e-5 /* short */ $YDOIT\n").deck;
    /// let entry = deck.entries(&"DCSTEC".parse().unwrap()).unwrap()[0];
    /// let files = deck.with_numbers(&[(entry, Number::Real(2.5e-6))]).unwrap();
    /// assert_eq!(files[0].1, b"/YD/YDC/DCSTEC  2.5e-6 /* short */ $YDOIT\n");
    /// ```
    ///
    /// # Errors
    /// If there is no number at a place.
    pub fn with_numbers(
        &self,
        changes: &[(Entry, Number)],
    ) -> Result<Vec<(SourceId, Vec<u8>)>, SubstituteError> {
        let mut by_item: BTreeMap<usize, BTreeMap<usize, Number>> = BTreeMap::new();
        for (entry, number) in changes {
            by_item.entry(entry.item).or_default().insert(entry.ordinal, *number);
        }
        // (file, first byte, last byte) → text
        let mut edits: BTreeMap<(SourceId, usize, usize), String> = BTreeMap::new();
        for (item, numbers) in &by_item {
            let (given, expected) = self.lengths(*item).ok_or(SubstituteError::NoNumber)?;
            let repeated = given.checked_sub(1).ok_or(SubstituteError::NoNumber)?;
            for (&ordinal, number) in numbers.range(..given) {
                let span = self.number_span(*item, ordinal).ok_or(SubstituteError::NoNumber)?;
                edits.insert((span.source, span.start, span.end), number.to_string());
            }
            if given == expected {
                continue;
            }
            let last = self.number_span(*item, repeated).ok_or(SubstituteError::NoNumber)?;
            let was = self.sources().text(last).into_owned();
            let text = edits.entry((last.source, last.start, last.end)).or_insert(was.clone());
            for ordinal in given..expected {
                text.push(' ');
                text.push_str(&numbers.get(&ordinal).map_or(was.clone(), Number::to_string));
            }
        }
        let mut files: BTreeMap<SourceId, (Vec<u8>, usize)> = BTreeMap::new();
        for ((source, start, end), text) in edits {
            let bytes = self.sources().get(source).ok_or(SubstituteError::NoNumber)?.bytes();
            let (out, done) = files.entry(source).or_default();
            out.extend_from_slice(bytes.get(*done..start).unwrap_or_default());
            out.extend_from_slice(text.as_bytes());
            *done = end;
        }
        let rest = |(source, (mut out, done)): (SourceId, (Vec<u8>, usize))| {
            let bytes = self.sources().get(source).map_or(&[][..], |file| file.bytes());
            out.extend_from_slice(bytes.get(done..).unwrap_or_default());
            (source, out)
        };
        Ok(files.into_iter().map(rest).collect())
    }

    /// How many numbers an item gives, and how many it announces.
    fn lengths(&self, item: usize) -> Option<(usize, usize)> {
        let expected = |expected: u64| usize::try_from(expected).ok();
        Some(match &self.item(item)?.assignment()?.value {
            Value::Integer(value) => (usize::from(value.is_some()), 1),
            Value::Real(value) => (usize::from(value.is_some()), 1),
            Value::Integers(array) => (array.numbers().len(), expected(array.header().expected())?),
            Value::Reals(array) => (array.numbers().len(), expected(array.header().expected())?),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::super::{DeckReader, EntryPath};
    use super::*;

    fn changed(text: &str, changes: &[(&str, f64)]) -> String {
        let deck = Deck::parse("a.y", text).deck;
        let mut numbers = Vec::new();
        for (words, value) in changes {
            let path: EntryPath = words.parse().expect("a path");
            for entry in deck.entries(&path).expect("entries") {
                numbers.push((entry, deck.number_for(entry, *value).expect("a number")));
            }
        }
        let files = deck.with_numbers(&numbers).expect("changes");
        String::from_utf8(files[0].1.clone()).expect("text")
    }

    const TEXT: &str = "/* a */\r\n/YD/YDPE/MPROP\t3 /YD/YDPE/D1PERO 3\n 10.0  2e+001\t30/* c */\n\
                        /YD/YDPE/D1PEMU 3 7 /* one */ $YDOIT trailing ";

    #[test]
    fn other_bytes_stay() {
        assert_eq!(
            changed(TEXT, &[("D1PERO[1]", 1.0 / 3.0), ("D1PERO[2]", 1e30)]),
            TEXT.replace("2e+001", "0.3333333333333333").replace("30/*", "1e30/*")
        );
        assert_eq!(changed(TEXT, &[("MPROP", 4.0)]), TEXT.replace("MPROP\t3", "MPROP\t4"));
    }

    #[test]
    fn numbers_that_are_missing_are_written_out() {
        let one = changed(TEXT, &[("D1PEMU[1]", 5.0)]);
        assert_eq!(one, TEXT.replace("3 7 /*", "3 7 5.0 7 /*"));
        // the last given number changes, those that repeated it do not
        let first = changed(TEXT, &[("D1PEMU[0]", 5.0)]);
        assert_eq!(first, TEXT.replace("3 7 /*", "3 5.0 7 7 /*"));
        let all = changed(TEXT, &[("D1PEMU[*]", 5.0)]);
        assert_eq!(all, TEXT.replace("3 7 /*", "3 5.0 5.0 5.0 /*"));
    }

    #[test]
    fn included_files_change_by_themselves() {
        let library = |_: &str| Ok(b"/YD/YDC/DCSTEC 1e-5 /* of steel */\n".to_vec());
        let text = "/YD/YDC/MCSTEP 5\n$YINCL steel\n$YDOIT\n";
        let deck = DeckReader::new().includes(library).parse("a.y", text).deck;
        let entry = deck.entries(&"DCSTEC".parse().expect("a path")).expect("entries")[0];
        let files = deck.with_numbers(&[(entry, Number::Real(2e-5))]).expect("changes");
        assert_eq!(files.len(), 1);
        assert_eq!(files[0].0.index(), 1);
        assert_eq!(files[0].1, b"/YD/YDC/DCSTEC 2e-5 /* of steel */\n");
    }

    #[test]
    fn what_does_not_fit_is_refused() {
        let deck = Deck::parse("a.y", TEXT).deck;
        let entry = deck.entries(&"MPROP".parse().expect("a path")).expect("entries")[0];
        let fault = |value| deck.number_for(entry, value).expect_err("a fault").to_string();
        assert_eq!(fault(2.5), "/YD/YDPE/MPROP holds whole numbers, 2.5 is none");
        assert!(fault(f64::NAN).contains("not finite"));
        let nowhere = Entry { item: 99, ordinal: 0 };
        assert_eq!(
            deck.with_numbers(&[(nowhere, Number::Integer(1))]),
            Err(SubstituteError::NoNumber)
        );
    }
}
