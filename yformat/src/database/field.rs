//! An array as the program holds it.

use crate::deck::{Array, Deck};
use crate::source::Span;

/// An array: the entries that the deck gives, and one value for all others.
///
/// Takes as much memory as the deck gives numbers, whatever its declared size is.
///
/// ```
/// use yformat::database::Database;
/// use yformat::deck::Deck;
///
/// let deck = Deck::parse("a.y", "/YD/YDN/MNODIM 2 /YD/YDN/MNOPO 1000 /YD/YDN/D2NCI 21 2 2 1 2 3 4 $YDOIT\n").deck;
/// let mut database = Database::new(deck.dialect());
/// (0..deck.items().len()).for_each(|item| assert!(database.apply(&deck, item).is_empty()));
/// let coordinates = database.reals("YDN/D2NCI").unwrap();
/// assert_eq!(coordinates.get2(1, 1), 4.0);
/// assert_eq!(coordinates.get2(1, 999), 0.0);
/// assert_eq!(coordinates.declared_shape(), [2, 1000]);
/// assert_eq!(coordinates.given_shape(), [2, 2]);
/// assert_eq!(deck.sources().text(coordinates.span(&deck, [1, 1, 0]).unwrap()), "4");
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Field<T> {
    pub(super) rank: usize,
    pub(super) declared: [usize; 3],
    pub(super) given: [usize; 3],
    pub(super) fill: T,
    pub(super) array: Option<Array<T>>,
    pub(super) item: Option<usize>,
}

impl<T: Copy> Field<T> {
    /// An array that holds one value everywhere.
    pub(super) fn filled(rank: usize, declared: [usize; 3], fill: T) -> Self {
        Field { rank, declared, given: [0; 3], fill, array: None, item: None }
    }

    /// An array that an item gives.
    pub(super) fn new(
        rank: usize,
        declared: [usize; 3],
        fill: T,
        array: Array<T>,
        item: usize,
    ) -> Self {
        let reads = array.header().expected() > 0;
        let count = |n: i64| if reads { usize::try_from(n).unwrap_or(0) } else { 0 };
        let given = array.header().counts().map(count);
        Field { rank, declared, given, fill, array: Some(array), item: Some(item) }
    }

    /// Entry of an array of rank 1.
    #[must_use]
    pub fn get1(&self, i: usize) -> T {
        self.get([i, 0, 0])
    }

    /// Entry of an array of rank 2: the first index is the component, the second the node or
    /// element.
    #[must_use]
    pub fn get2(&self, i: usize, j: usize) -> T {
        self.get([i, j, 0])
    }

    /// Entry of an array of rank 3.
    #[must_use]
    pub fn get3(&self, i: usize, j: usize, k: usize) -> T {
        self.get([i, j, k])
    }

    /// Entry of an array of any rank, indices beyond the rank being 0. What the deck does not give
    /// is the fill value, also beyond the declared size.
    #[must_use]
    pub fn get(&self, index: [usize; 3]) -> T {
        self.array.as_ref().and_then(|array| array.get(index)).unwrap_or(self.fill)
    }

    /// The value of entries that are not given.
    #[must_use]
    pub fn fill(&self) -> T {
        self.fill
    }

    /// Number of indices.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// Lengths that the size keywords declared when the array was made.
    #[must_use]
    pub fn declared_shape(&self) -> &[usize] {
        &self.declared[..self.rank]
    }

    /// Lengths that the deck gives; 0 if the array only holds fill values.
    #[must_use]
    pub fn given_shape(&self) -> &[usize] {
        &self.given[..self.rank]
    }

    /// Which number of the text an entry is, counted from 0; `None` for fill values and repeated
    /// ones.
    #[must_use]
    pub fn ordinal(&self, index: [usize; 3]) -> Option<usize> {
        let array = self.array.as_ref()?;
        array.header().ordinal(index).filter(|&ordinal| ordinal < array.numbers().len())
    }

    /// The item that gave the array.
    #[must_use]
    pub fn item(&self) -> Option<usize> {
        self.item
    }

    /// Where an entry stands in the deck; the keyword's word for entries that do not stand there.
    #[must_use]
    pub fn span(&self, deck: &Deck, index: [usize; 3]) -> Option<Span> {
        let item = self.item?;
        let number = self.ordinal(index).and_then(|ordinal| deck.number_span(item, ordinal));
        number.or_else(|| deck.word_span(item))
    }
}
