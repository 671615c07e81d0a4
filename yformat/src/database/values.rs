//! What the program holds, by name.

use std::collections::{BTreeMap, BTreeSet};

use super::field::Field;
use crate::dialect::Dialect;
use crate::keywords::{self, Keyword, NumberKind};

/// One value or array.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Slot {
    Integer { value: i64, item: Option<usize> },
    Real { value: f64, item: Option<usize> },
    Integers(Field<i64>),
    Reals(Field<f64>),
}

/// The values that the items of a deck leave in the program.
///
/// Names are those of the keyword tables, `YDC/MCSTEP`. Asking for a name that the dialect's tables
/// do not have, or for it as another kind than it is, is a mistake of the caller and panics.
///
/// ```
/// use yformat::database::Database;
/// use yformat::deck::Deck;
///
/// let deck = Deck::parse("a.y", "/YD/YDC/MCSTEP 5 /YD/YDC/DCSTEC 1e-5 $YDOIT\n").deck;
/// let mut database = Database::new(deck.dialect());
/// for stage in deck.stages() {
///     for item in stage.items {
///         assert!(database.apply(&deck, item).is_empty());
///     }
/// }
/// assert_eq!(database.integer("YDC/MCSTEP"), 5);
/// assert_eq!(database.real("YDC/DCSTEC"), 1e-5);
/// assert_eq!(database.integer("YDC/ICOUTF"), 10); // the dialect's default
/// assert_eq!(database.given("YDC/DCSTEC"), Some(1));
/// assert_eq!(database.given("YDC/ICOUTF"), None);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Database {
    pub(super) dialect: Dialect,
    pub(super) slots: BTreeMap<(&'static str, &'static str), Slot>,
    /// Size keywords that were reported as missing or too small: once is enough, however many
    /// arrays they size.
    pub(super) reported_sizes: BTreeSet<(&'static str, &'static str)>,
}

impl Database {
    /// What the program holds before it reads anything.
    #[must_use]
    pub fn new(dialect: Dialect) -> Self {
        Database { dialect, slots: BTreeMap::new(), reported_sizes: BTreeSet::new() }
    }

    /// The dialect whose keywords it knows.
    #[must_use]
    pub fn dialect(&self) -> Dialect {
        self.dialect
    }

    /// Whether the dialect has a keyword of this name.
    #[must_use]
    pub fn knows(&self, name: &str) -> bool {
        keywords::find(self.dialect, name).is_some()
    }

    /// An integer; the dialect's default if the deck does not give it.
    ///
    /// # Panics
    /// If the dialect has no such integer scalar.
    #[must_use]
    pub fn integer(&self, name: &str) -> i64 {
        let keyword = self.keyword(name, NumberKind::Integer, true);
        match self.slot(keyword) {
            Some(Slot::Integer { value, .. }) => *value,
            _ => keyword.default as i64,
        }
    }

    /// A real; the dialect's default if the deck does not give it.
    ///
    /// # Panics
    /// If the dialect has no such real scalar.
    #[must_use]
    pub fn real(&self, name: &str) -> f64 {
        let keyword = self.keyword(name, NumberKind::Real, true);
        match self.slot(keyword) {
            Some(Slot::Real { value, .. }) => *value,
            _ => keyword.default,
        }
    }

    /// An array of integers, if it exists.
    ///
    /// # Panics
    /// If the dialect has no such array of integers.
    #[must_use]
    pub fn integers(&self, name: &str) -> Option<&Field<i64>> {
        match self.slot(self.keyword(name, NumberKind::Integer, false))? {
            Slot::Integers(field) => Some(field),
            _ => None,
        }
    }

    /// An array of reals, if it exists.
    ///
    /// # Panics
    /// If the dialect has no such array of reals.
    #[must_use]
    pub fn reals(&self, name: &str) -> Option<&Field<f64>> {
        match self.slot(self.keyword(name, NumberKind::Real, false))? {
            Slot::Reals(field) => Some(field),
            _ => None,
        }
    }

    /// The item that gave a value last; `None` if the deck does not give it.
    ///
    /// # Panics
    /// If the dialect has no such keyword.
    #[must_use]
    pub fn given(&self, name: &str) -> Option<usize> {
        match self.slot(self.any_keyword(name))? {
            Slot::Integer { item, .. } | Slot::Real { item, .. } => *item,
            Slot::Integers(field) => field.item(),
            Slot::Reals(field) => field.item(),
        }
    }

    /// Sets an integer that the program itself moves on, such as `YDC/NCSTEP` after the steps of a
    /// stage.
    ///
    /// # Panics
    /// If the dialect has no such integer scalar.
    pub fn set_integer(&mut self, name: &str, value: i64) {
        let keyword = self.keyword(name, NumberKind::Integer, true);
        let item = self.given(name);
        self.slots.insert((keyword.database, keyword.name), Slot::Integer { value, item });
    }

    /// Sets a real that the program itself moves on, such as `YDC/DCTIME` after the steps of a
    /// stage.
    ///
    /// # Panics
    /// If the dialect has no such real scalar.
    pub fn set_real(&mut self, name: &str, value: f64) {
        let keyword = self.keyword(name, NumberKind::Real, true);
        let item = self.given(name);
        self.slots.insert((keyword.database, keyword.name), Slot::Real { value, item });
    }

    pub(super) fn slot(&self, keyword: &Keyword) -> Option<&Slot> {
        self.slots.get(&(keyword.database, keyword.name))
    }

    fn any_keyword(&self, name: &str) -> &'static Keyword {
        let keyword = keywords::find(self.dialect, name);
        keyword.unwrap_or_else(|| panic!("the {} dialect has no keyword {name}", self.dialect))
    }

    fn keyword(&self, name: &str, number: NumberKind, scalar: bool) -> &'static Keyword {
        let keyword = self.any_keyword(name);
        let fits = keyword.number == number && (keyword.rank() == 0) == scalar;
        assert!(
            fits,
            "{name} of the {} dialect is of another kind: {:?}, rank {}",
            self.dialect,
            keyword.number,
            keyword.rank()
        );
        keyword
    }
}
