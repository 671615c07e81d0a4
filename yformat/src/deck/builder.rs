//! Decks made from values.

use super::Deck;
use super::array::{Array, Header};
use super::item::{Assignment, Item, ItemKind, Value};
use crate::dialect::Dialect;
use crate::keywords::{self, Keyword, NumberKind};
use crate::source::SourceMap;

/// Makes a deck, item after item. Names are those of the dialect's tables, such as `YDC/MCSTEP`;
/// what does not fit them is a mistake of the caller and panics.
///
/// ```
/// use yformat::deck::DeckBuilder;
/// use yformat::dialect::Dialect;
///
/// let deck = DeckBuilder::new(Dialect::Split)
///     .comment("a single triangle")
///     .integer("YDC/MCSTEP", 100)
///     .integer("YDN/MNODIM", 2)
///     .integer("YDN/MNOPO", 3)
///     .reals2("YDN/D2NCI", 2, vec![0.0, 0.0, 1.0, 0.0, 0.0, 1.0])
///     .run()
///     .stop()
///     .build();
/// assert!(deck.to_text().contains("/YD/YDN/D2NCI 21 2 3\n0.0 0.0\n1.0 0.0\n0.0 1.0\n"));
/// ```
#[derive(Debug, Clone)]
pub struct DeckBuilder {
    dialect: Dialect,
    items: Vec<Item>,
}

impl DeckBuilder {
    /// An empty deck.
    #[must_use]
    pub fn new(dialect: Dialect) -> Self {
        DeckBuilder { dialect, items: Vec::new() }
    }

    /// A comment; texts too long for the original's readers become several.
    #[must_use]
    pub fn comment(self, text: impl Into<String>) -> Self {
        self.item(ItemKind::Comment(text.into()))
    }

    /// One history: the kinetic energy. `threshold` is the relative change (`DOHYP`) from which
    /// on its value is renewed.
    ///
    /// # Panics
    /// If the dialect has no such histories.
    #[must_use]
    pub fn kinetic_energy_history(self, threshold: f64) -> Self {
        self.integer("YDO/MOHYS", 1)
            .integer("YDO/NOHYS", 1)
            .real("YDO/DOHYP", threshold)
            .reals("YDO/D1OHYC", vec![1.0])
            .reals("YDO/D1OHYF", vec![1.0])
            .reals("YDO/D1OHYS", vec![0.0])
            .reals("YDO/D1OHYT", vec![0.0])
            .reals("YDO/D1OHYX", vec![0.0])
            .reals("YDO/D1OHYY", vec![0.0])
            .integers("YDO/I1OHYT", vec![15])
    }

    /// An integer scalar.
    ///
    /// # Panics
    /// If the dialect has no such integer scalar.
    #[must_use]
    pub fn integer(self, name: &str, value: i64) -> Self {
        let keyword = self.keyword(name, NumberKind::Integer, 0);
        self.assign(keyword, Value::Integer(Some(value)))
    }

    /// A real scalar.
    ///
    /// # Panics
    /// If the dialect has no such real scalar, or the value is not finite.
    #[must_use]
    pub fn real(self, name: &str, value: f64) -> Self {
        let keyword = self.keyword(name, NumberKind::Real, 0);
        assert!(value.is_finite(), "{name} must be finite");
        self.assign(keyword, Value::Real(Some(value)))
    }

    /// A one-dimensional array of integers.
    ///
    /// # Panics
    /// If the dialect has no such array.
    #[must_use]
    pub fn integers(self, name: &str, values: Vec<i64>) -> Self {
        let keyword = self.keyword(name, NumberKind::Integer, 1);
        let header = Header::rank1(length(values.len()));
        self.assign(keyword, Value::Integers(Array::new(header, values)))
    }

    /// A one-dimensional array of reals.
    ///
    /// # Panics
    /// If the dialect has no such array, or a value is not finite.
    #[must_use]
    pub fn reals(self, name: &str, values: Vec<f64>) -> Self {
        let keyword = self.keyword(name, NumberKind::Real, 1);
        let header = Header::rank1(length(values.len()));
        self.assign_reals(keyword, header, values)
    }

    /// A two-dimensional array of integers in the usual order 21: one record of `components`
    /// numbers per node or element.
    ///
    /// # Panics
    /// If the dialect has no such array, or the values are not whole records.
    #[must_use]
    pub fn integers2(self, name: &str, components: usize, values: Vec<i64>) -> Self {
        let keyword = self.keyword(name, NumberKind::Integer, 2);
        let header = Header::rank2(21, length(components), records(name, components, values.len()));
        self.assign(keyword, Value::Integers(Array::new(header, values)))
    }

    /// A two-dimensional array of reals in the usual order 21: one record of `components` numbers
    /// per node or element.
    ///
    /// # Panics
    /// If the dialect has no such array, a value is not finite, or the values are not whole
    /// records.
    #[must_use]
    pub fn reals2(self, name: &str, components: usize, values: Vec<f64>) -> Self {
        let keyword = self.keyword(name, NumberKind::Real, 2);
        let header = Header::rank2(21, length(components), records(name, components, values.len()));
        self.assign_reals(keyword, header, values)
    }

    /// A three-dimensional array of reals in the usual order 231: the first index runs fastest,
    /// then the third.
    ///
    /// # Panics
    /// If the dialect has no such array, a value is not finite, or the number of values is not the
    /// product of `counts`.
    #[must_use]
    pub fn reals3(self, name: &str, counts: [usize; 3], values: Vec<f64>) -> Self {
        let keyword = self.keyword(name, NumberKind::Real, 3);
        assert_eq!(
            counts.iter().product::<usize>(),
            values.len(),
            "{name} needs as many values as its counts say"
        );
        self.assign_reals(keyword, Header::rank3(231, counts.map(length)), values)
    }

    /// `$YDOIT`.
    #[must_use]
    pub fn run(self) -> Self {
        self.item(ItemKind::Run)
    }

    /// `$YSTOP`.
    #[must_use]
    pub fn stop(self) -> Self {
        self.item(ItemKind::Stop)
    }

    /// `$YINCL` and a file name, which may have no blanks. The file's own items are not part of the
    /// deck then.
    ///
    /// # Panics
    /// If the name is empty or has white space.
    #[must_use]
    pub fn include(self, name: &str) -> Self {
        assert!(
            !name.is_empty() && !name.contains(char::is_whitespace),
            "`{name}` cannot be included"
        );
        self.item(ItemKind::Include(name.to_owned()))
    }

    /// Any item, such as one of another deck.
    #[must_use]
    pub fn item(mut self, kind: ItemKind) -> Self {
        self.items.push(Item::new(kind));
        self
    }

    /// The deck.
    #[must_use]
    pub fn build(self) -> Deck {
        let mut sources = SourceMap::new();
        sources.add("deck", Vec::new());
        Deck { sources, dialect: self.dialect, items: self.items }
    }

    fn assign(self, keyword: &'static Keyword, value: Value) -> Self {
        self.item(ItemKind::Assignment(Assignment { keyword, value }))
    }

    fn assign_reals(self, keyword: &'static Keyword, header: Header, values: Vec<f64>) -> Self {
        assert!(values.iter().all(|value| value.is_finite()), "{} must be finite", keyword.path());
        self.assign(keyword, Value::Reals(Array::new(header, values)))
    }

    fn keyword(&self, name: &str, number: NumberKind, rank: usize) -> &'static Keyword {
        let found = keywords::find(self.dialect, name)
            .filter(|keyword| keyword.number == number && keyword.rank() == rank);
        found.unwrap_or_else(|| {
            panic!("the {} dialect has no {number:?} keyword {name} of rank {rank}", self.dialect)
        })
    }
}

fn length(n: usize) -> i64 {
    i64::try_from(n).unwrap_or(i64::MAX)
}

fn records(name: &str, components: usize, values: usize) -> i64 {
    assert!(components > 0 || values == 0, "{name} needs records of at least one number");
    assert!(
        values == 0 || values.is_multiple_of(components),
        "{name} needs whole records of {components} numbers"
    );
    length(values.checked_div(components).unwrap_or(0))
}
