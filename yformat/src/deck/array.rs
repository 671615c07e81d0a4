//! Arrays as the deck spells them: a header and a run of numbers.

use std::sync::Arc;

/// What stands between an array keyword and its numbers.
///
/// ```
/// use yformat::deck::Header;
///
/// let header = Header::rank2(21, 2, 3); // three records of two numbers
/// assert_eq!(header.expected(), 6);
/// assert_eq!(header.ordinal([1, 2, 0]), Some(5));
/// assert_eq!(Header::rank2(12, 2, 3).ordinal([1, 0, 0]), Some(3));
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Header {
    rank: usize,
    order: i64,
    counts: [i64; 3],
}

impl Header {
    /// `n`.
    #[must_use]
    pub fn rank1(n: i64) -> Self {
        Header { rank: 1, order: 1, counts: [n, 1, 1] }
    }

    /// `how n1 n2`.
    #[must_use]
    pub fn rank2(order: i64, n1: i64, n2: i64) -> Self {
        Header { rank: 2, order, counts: [n1, n2, 1] }
    }

    /// `how n1 n2 n3`.
    #[must_use]
    pub fn rank3(order: i64, counts: [i64; 3]) -> Self {
        Header { rank: 3, order, counts }
    }

    /// Number of indices, 1 to 3.
    #[must_use]
    pub fn rank(&self) -> usize {
        self.rank
    }

    /// The digits that name the loops, outermost first; 1 for rank 1.
    #[must_use]
    pub fn order(&self) -> i64 {
        self.order
    }

    /// Given lengths per index, as spelled; 1 beyond the rank.
    #[must_use]
    pub fn counts(&self) -> [i64; 3] {
        self.counts
    }

    /// Number of numbers that the original reads after this header.
    #[must_use]
    pub fn expected(&self) -> u64 {
        if self.loops().is_none() {
            return 0;
        }
        let length = |count: i64| u64::try_from(count).unwrap_or(0);
        self.counts.iter().fold(1, |product: u64, &count| product.saturating_mul(length(count)))
    }

    /// Indices from the outermost loop to the innermost; `None` for a rank-3 order that is no
    /// permutation of 123: the original then reads nothing.
    #[must_use]
    pub fn loops(&self) -> Option<[usize; 3]> {
        match (self.rank, self.order) {
            (1, _) => Some([2, 1, 0]),
            (2, 12) => Some([2, 0, 1]),
            (2, _) => Some([2, 1, 0]),
            (_, 123) => Some([0, 1, 2]),
            (_, 132) => Some([0, 2, 1]),
            (_, 213) => Some([1, 0, 2]),
            (_, 231) => Some([1, 2, 0]),
            (_, 312) => Some([2, 0, 1]),
            (_, 321) => Some([2, 1, 0]),
            _ => None,
        }
    }

    /// Position of an entry's number in the text, counted from 0; `None` if the header gives no
    /// such entry.
    #[must_use]
    pub fn ordinal(&self, index: [usize; 3]) -> Option<usize> {
        let loops = self.loops()?;
        let mut ordinal = 0usize;
        for axis in loops {
            let length = usize::try_from(self.counts[axis]).ok()?;
            if index[axis] >= length {
                return None;
            }
            ordinal = ordinal.checked_mul(length)?.checked_add(index[axis])?;
        }
        Some(ordinal)
    }
}

/// An array as given: its header and the numbers that are really there.
///
/// The original repeats the last number where some are missing; [`Array::get`] does so too, without
/// storing them.
///
/// ```
/// use yformat::deck::{Array, Header};
///
/// let array = Array::new(Header::rank1(4), vec![1.0, 2.0, 3.0]);
/// assert_eq!(array.get([3, 0, 0]), Some(3.0));
/// assert_eq!(array.get([4, 0, 0]), None);
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Array<T> {
    header: Header,
    numbers: Arc<Vec<T>>,
}

impl<T: Copy> Array<T> {
    /// An array of a header and its numbers in the order of the text.
    #[must_use]
    pub fn new(header: Header, numbers: Vec<T>) -> Self {
        Array { header, numbers: Arc::new(numbers) }
    }

    /// What stands before the numbers.
    #[must_use]
    pub fn header(&self) -> &Header {
        &self.header
    }

    /// The numbers in the order of the text.
    #[must_use]
    pub fn numbers(&self) -> &[T] {
        &self.numbers
    }

    /// The entry with this index, `None` if the deck does not give it.
    #[must_use]
    pub fn get(&self, index: [usize; 3]) -> Option<T> {
        let ordinal = self.header.ordinal(index)?;
        self.numbers.get(ordinal).or(self.numbers.last()).copied()
    }
}
