//! Single numbers of a deck, named as people name them: `YDPE/D1PEMU[2]`.

use std::fmt;
use std::str::FromStr;

use super::item::{Assignment, Value};
use super::{Deck, Header};
use crate::keywords::{self, Keyword};

/// Which numbers of a deck are meant: a keyword and, for arrays, an index.
///
/// Indices count from 0, in the order of the keyword's documentation; `*` means all of them.
/// `@2` means the second time that the deck gives the keyword, `@*` every time.
///
/// ```
/// use yformat::deck::EntryPath;
///
/// for words in ["/YD/YDC/DCSTEC", "YDPE/D1PEMU[2]", "D1PEMU[*]", "D2NCI[1,*]", "MCSTEP@2"] {
///     let path: EntryPath = words.parse().unwrap();
///     assert_eq!(path.to_string(), words.trim_start_matches("/YD/"));
/// }
/// assert!("D1PEMU[2".parse::<EntryPath>().is_err());
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EntryPath {
    database: Option<String>,
    name: String,
    index: Vec<Slot>,
    occurrence: Option<Slot>,
}

/// One index, or all.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Slot {
    All,
    At(usize),
}

/// A number of a deck: the item that gives it, and its place among the item's numbers in the
/// order of the text.
///
/// ```
/// use yformat::deck::{Deck, Entry};
///
/// let deck = Deck::parse("a.y", "/YD/YDPE/MPROP 2 /YD/YDPE/D1PERO 2 10 20\n").deck;
/// let entries = deck.entries(&"D1PERO[1]".parse().unwrap()).unwrap();
/// assert_eq!(entries, [Entry { item: 1, ordinal: 1 }]);
/// assert_eq!(deck.number(entries[0]).map(|number| number.to_string()), Some("20.0".to_owned()));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Entry {
    /// Index of the item.
    pub item: usize,
    /// Place of the number, from 0; 0 for a scalar.
    pub ordinal: usize,
}

/// A number as a deck holds it. `Display` gives the shortest text that reads back the same.
///
/// ```
/// use yformat::deck::Number;
///
/// assert_eq!(Number::Real(1e9).to_string(), "1000000000.0");
/// assert_eq!(Number::Integer(5).value(), 5.0);
/// ```
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Number {
    /// Of a keyword that holds integers.
    Integer(i64),
    /// Of a keyword that holds reals.
    Real(f64),
}

impl Number {
    /// Its value.
    #[must_use]
    pub fn value(self) -> f64 {
        match self {
            Self::Integer(value) => value as f64,
            Self::Real(value) => value,
        }
    }
}

impl fmt::Display for Number {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Integer(value) => write!(f, "{value}"),
            // as canonical items are written
            Self::Real(value) => write!(f, "{value:?}"),
        }
    }
}

/// Why numbers are not found.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[non_exhaustive]
pub enum EntryError {
    /// Words of another form.
    #[error(
        "`{0}` names no numbers of a deck: expected a keyword, with an index if it is an array, \
         such as YDC/DCSTEC, YDPE/D1PEMU[2], D1PEMU[*] or D2NCI[1,*]"
    )]
    Form(String),
    /// The dialect has no such keyword.
    #[error("the {dialect} dialect has no keyword `{name}`{}", did_you_mean(similar))]
    Unknown {
        /// The keyword.
        name: String,
        /// The dialect of the deck.
        dialect: &'static str,
        /// A spelling that is near.
        similar: Option<String>,
    },
    /// The deck does not give the keyword.
    #[error("the deck gives no number for {0}: write its value into the deck first")]
    NotGiven(String),
    /// Keywords of several databases have the name.
    #[error("`{name}` is given in several databases: write {}", choices.join(" or "))]
    SeveralDatabases {
        /// The name.
        name: String,
        /// The full names.
        choices: Vec<String>,
    },
    /// The deck gives the keyword several times.
    #[error(
        "the deck gives {name} {} times (lines {}): add @1, @2, ... for one of them, @* for all",
        lines.len(),
        listed(lines)
    )]
    SeveralTimes {
        /// The keyword.
        name: String,
        /// Where.
        lines: Vec<usize>,
    },
    /// The deck gives the keyword less often.
    #[error("the deck gives {name} {times} times: there is no @{asked} (they count from 1)")]
    NoSuchTime {
        /// The keyword.
        name: String,
        /// How often it is given.
        times: usize,
        /// What was asked for.
        asked: usize,
    },
    /// An index too many, too few, or where there are none.
    #[error("{name} {}", shape(counts))]
    Rank {
        /// The keyword.
        name: String,
        /// Lengths of its indices; none for a scalar.
        counts: Vec<i64>,
    },
    /// An index that the array does not have.
    #[error("{name} has no entry {asked}: it {}", lengths(counts))]
    OutOfRange {
        /// The keyword.
        name: String,
        /// What was asked for.
        asked: String,
        /// Lengths of its indices.
        counts: Vec<i64>,
    },
}

fn did_you_mean(similar: &Option<String>) -> String {
    similar.as_ref().map_or_else(String::new, |name| format!("; did you mean {name}?"))
}

fn listed(lines: &[usize]) -> String {
    lines.iter().map(usize::to_string).collect::<Vec<_>>().join(", ")
}

fn shape(counts: &[i64]) -> String {
    match counts.len() {
        0 => "is a single number: leave the index out".to_owned(),
        1 => format!("{}: write one index in brackets, or [*] for all", lengths(counts)),
        n => format!("{}: write {n} indices in brackets, * for all of one", lengths(counts)),
    }
}

fn lengths(counts: &[i64]) -> String {
    let numbers: Vec<String> = counts.iter().map(i64::to_string).collect();
    match counts {
        [0] => "is an empty array".to_owned(),
        [1] => "is an array with the one entry [0]".to_owned(),
        [n] => format!("is an array with the entries [0] to [{}]", n - 1),
        _ => format!("is an array of {} numbers, counted from 0", numbers.join(" by ")),
    }
}

impl FromStr for EntryPath {
    type Err = EntryError;

    fn from_str(words: &str) -> Result<Self, EntryError> {
        parse(words.trim()).ok_or_else(|| EntryError::Form(words.to_owned()))
    }
}

fn parse(words: &str) -> Option<EntryPath> {
    let words = words.strip_prefix("/YD/").unwrap_or(words);
    let (words, occurrence) = match words.split_once('@') {
        Some((front, "*")) => (front, Some(Slot::All)),
        Some((front, number)) => (front, Some(Slot::At(number.parse().ok()?))),
        None => (words, None),
    };
    let (keyword, index) = match words.split_once('[') {
        Some((front, rest)) => {
            let slots = rest.strip_suffix(']')?.split(',').map(|slot| match slot.trim() {
                "*" => Some(Slot::All),
                number => number.parse().ok().map(Slot::At),
            });
            (front, slots.collect::<Option<Vec<_>>>()?)
        }
        None => (words, Vec::new()),
    };
    let (database, name) = match keyword.split_once('/') {
        Some((database, name)) => (Some(database), name),
        None => (None, keyword),
    };
    let is_word = |word: &str| {
        !word.is_empty() && word.bytes().all(|byte| byte.is_ascii_alphanumeric() || byte == b'_')
    };
    (is_word(name) && database.is_none_or(is_word) && index.len() <= 3).then(|| EntryPath {
        database: database.map(str::to_owned),
        name: name.to_owned(),
        index,
        occurrence,
    })
}

impl fmt::Display for EntryPath {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(database) = &self.database {
            write!(f, "{database}/")?;
        }
        f.write_str(&self.name)?;
        if !self.index.is_empty() {
            let slots: Vec<String> = self.index.iter().map(Slot::to_string).collect();
            write!(f, "[{}]", slots.join(","))?;
        }
        self.occurrence.map_or(Ok(()), |slot| write!(f, "@{slot}"))
    }
}

impl fmt::Display for Slot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::All => f.write_str("*"),
            Self::At(number) => write!(f, "{number}"),
        }
    }
}

impl Deck {
    /// The numbers that a path names, in the order of the text.
    ///
    /// # Errors
    /// If the deck gives no such numbers, or it is not clear which are meant.
    pub fn entries(&self, path: &EntryPath) -> Result<Vec<Entry>, EntryError> {
        let given = self.given(path)?;
        let name = given.first().map(|(_, a)| a.keyword.path()).unwrap_or_default();
        let chosen: &[_] = match path.occurrence {
            Some(Slot::All) => &given,
            Some(Slot::At(asked)) => {
                let one = asked.checked_sub(1).and_then(|at| given.get(at..=at));
                let times = given.len();
                one.ok_or(EntryError::NoSuchTime { name, times, asked })?
            }
            None if given.len() > 1 => {
                let lines = given.iter().filter_map(|(item, _)| self.word_span(*item));
                let lines = lines.map(|span| self.sources().location(span).line).collect();
                return Err(EntryError::SeveralTimes { name, lines });
            }
            None => &given,
        };
        let mut entries = Vec::new();
        for (item, assignment) in chosen {
            entries.extend(
                ordinals(assignment, path)?
                    .into_iter()
                    .map(|ordinal| Entry { item: *item, ordinal }),
            );
        }
        Ok(entries)
    }

    /// The number at a place; where an array gives fewer numbers than it announces, the last one
    /// is repeated.
    #[must_use]
    pub fn number(&self, entry: Entry) -> Option<Number> {
        let at = |length: usize| Some(entry.ordinal.min(length.checked_sub(1)?));
        match &self.item(entry.item)?.assignment()?.value {
            Value::Integer(value) => value.map(Number::Integer),
            Value::Real(value) => value.map(Number::Real),
            Value::Integers(array) => {
                let at = at(array.numbers().len());
                array.numbers().get(at?).copied().map(Number::Integer)
            }
            Value::Reals(array) => {
                let at = at(array.numbers().len());
                array.numbers().get(at?).copied().map(Number::Real)
            }
        }
    }

    /// Assignments of the keyword that a path names, which hold numbers.
    fn given(&self, path: &EntryPath) -> Result<Vec<(usize, &Assignment)>, EntryError> {
        let dialect = self.dialect();
        let fits = |keyword: &Keyword| {
            keyword.name == path.name
                && path.database.as_ref().is_none_or(|database| keyword.database == database)
        };
        let all = || keywords::tables(dialect).iter().flat_map(|table| table.keywords);
        if !all().any(fits) {
            let asked = path.database.as_ref().map(|database| format!("{database}/{}", path.name));
            let similar = match &asked {
                Some(asked) => keywords::similar(dialect, &format!("/YD/{asked}")),
                // no database: the nearest in any of those that the deck uses
                None => self.assignments().map(|(_, a)| a.keyword.database).find_map(|database| {
                    keywords::similar(dialect, &format!("/YD/{database}/{}", path.name))
                        .filter(|found| found.starts_with(&format!("/YD/{database}/")))
                }),
            };
            let name = asked.unwrap_or_else(|| path.name.clone());
            return Err(EntryError::Unknown { name, dialect: dialect.name(), similar });
        }
        let given: Vec<_> = self
            .assignments()
            .filter(|(_, a)| {
                fits(a.keyword) && !matches!(a.value, Value::Integer(None) | Value::Real(None))
            })
            .collect();
        let Some((_, first)) = given.first() else {
            let name = all().find(|keyword| fits(keyword)).map(Keyword::path);
            return Err(EntryError::NotGiven(name.unwrap_or_default()));
        };
        if given.iter().any(|(_, a)| a.keyword.database != first.keyword.database) {
            let mut choices: Vec<String> = given
                .iter()
                .map(|(_, a)| format!("{}/{}", a.keyword.database, a.keyword.name))
                .collect();
            choices.sort();
            choices.dedup();
            return Err(EntryError::SeveralDatabases { name: path.name.clone(), choices });
        }
        Ok(given)
    }
}

/// Places of the numbers that the path's index names.
fn ordinals(assignment: &Assignment, path: &EntryPath) -> Result<Vec<usize>, EntryError> {
    let name = assignment.keyword.path();
    let header: &Header = match &assignment.value {
        Value::Integer(_) | Value::Real(_) if path.index.is_empty() => return Ok(vec![0]),
        Value::Integer(_) | Value::Real(_) => {
            return Err(EntryError::Rank { name, counts: Vec::new() });
        }
        Value::Integers(array) => array.header(),
        Value::Reals(array) => array.header(),
    };
    let counts = header.counts()[..header.rank()].to_vec();
    if path.index.len() != header.rank() {
        return Err(EntryError::Rank { name, counts });
    }
    let ranges: Vec<std::ops::Range<usize>> = path
        .index
        .iter()
        .zip(&counts)
        .map(|(slot, &count)| match *slot {
            Slot::At(at) => at..at + 1,
            Slot::All => 0..usize::try_from(count).unwrap_or(0),
        })
        .collect();
    let range = |axis: usize| ranges.get(axis).cloned().unwrap_or(0..1);
    let mut found = Vec::new();
    for i in range(0) {
        for j in range(1) {
            for k in range(2) {
                let ordinal = header.ordinal([i, j, k]);
                found.push(ordinal.ok_or_else(|| EntryError::OutOfRange {
                    name: name.clone(),
                    asked: path.index.iter().map(Slot::to_string).collect::<Vec<_>>().join(","),
                    counts: counts.clone(),
                })?);
            }
        }
    }
    found.sort_unstable();
    if found.is_empty() {
        let asked = path.index.iter().map(Slot::to_string).collect::<Vec<_>>().join(",");
        return Err(EntryError::OutOfRange { name, asked, counts });
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = "/YD/YDC/MCSTEP 5 /YD/YDC/DCSTEC 1e-5\n/YD/YDPE/MPROP 3\n\
                        /YD/YDPE/D1PERO 3 10 20\n/YD/YDN/MNODIM 2 /YD/YDN/MNOPO 3\n\
                        /YD/YDN/D2NCI 21 2 3 0 1 2 3 4 5\n$YDOIT\n/YD/YDC/MCSTEP 9 $YDOIT\n";

    fn deck() -> Deck {
        Deck::parse("a.y", TEXT).deck
    }

    fn values(words: &str) -> Vec<f64> {
        let deck = deck();
        let path = words.parse::<EntryPath>().expect("a path");
        let entries = deck.entries(&path).unwrap_or_else(|error| panic!("{words}: {error}"));
        entries.into_iter().filter_map(|entry| deck.number(entry)).map(Number::value).collect()
    }

    fn fault(words: &str) -> String {
        let found = words.parse::<EntryPath>().and_then(|path| deck().entries(&path));
        found.expect_err("a fault").to_string()
    }

    #[test]
    fn numbers_are_found_by_keyword_and_index() {
        assert_eq!(values("/YD/YDC/DCSTEC"), [1e-5]);
        assert_eq!(values("D1PERO[0]"), [10.0]);
        // the last number given is repeated
        assert_eq!(values("YDPE/D1PERO[*]"), [10.0, 20.0, 20.0]);
        assert_eq!(values("D2NCI[1,2]"), [5.0]);
        assert_eq!(values("D2NCI[1,*]"), [1.0, 3.0, 5.0]);
        assert_eq!(values("D2NCI[*,0]"), [0.0, 1.0]);
        assert_eq!(values("MCSTEP@2"), [9.0]);
        assert_eq!(values("MCSTEP@*"), [5.0, 9.0]);
    }

    #[test]
    fn what_is_not_there_is_told() {
        assert!(fault("D1PERO").contains("[0] to [2]: write one index"), "{}", fault("D1PERO"));
        assert!(fault("D1PERO[3]").contains("no entry 3"));
        assert!(fault("DCSTEC[0]").contains("single number"));
        assert!(fault("D2NCI[1]").contains("2 by 3 numbers"));
        assert!(fault("MCSTEP").contains("2 times (lines 1, 7)"), "{}", fault("MCSTEP"));
        assert!(fault("MCSTEP@3").contains("no @3"));
        assert!(fault("YDPE/D1PEMU[0]").contains("gives no number for /YD/YDPE/D1PEMU"));
        assert!(fault("YDC/DCSTEK").contains("did you mean /YD/YDC/DCSTEC?"));
        assert!(fault("DCSTEK").contains("did you mean /YD/YDC/DCSTEC?"), "{}", fault("DCSTEK"));
        for words in ["", "[1]", "A[", "A[x]", "A B", "A[1,2,3,4]", "A@x", "YD//A"] {
            assert!(fault(words).contains("names no numbers"), "{words}: {}", fault(words));
        }
    }
}
