//! Places of single numbers, found by reading the item again when somebody asks.

use super::lex::next_word;
use super::number::Number;
use super::{Deck, Value};
use crate::source::Span;

impl Deck {
    /// Where number `ordinal` (from 0, in the order of the text) of an assignment stands; the value
    /// itself for a scalar. `None` if the item is not an assignment, is new or changed, or has no
    /// such number.
    ///
    /// ```
    /// let deck = yformat::deck::Deck::parse("a.y", "/YD/YDPE/MPROP 3 /YD/YDPE/D1PERO 3 10 20 30\n").deck;
    /// let span = deck.number_span(1, 2).unwrap();
    /// assert_eq!(deck.sources().text(span), "30");
    /// ```
    #[must_use]
    pub fn number_span(&self, item: usize, ordinal: usize) -> Option<Span> {
        let (header, numbers, reals) = match &self.item(item)?.assignment()?.value {
            Value::Integer(value) => (0, usize::from(value.is_some()), false),
            Value::Real(value) => (0, usize::from(value.is_some()), true),
            Value::Integers(array) => {
                (header_numbers(array.header().rank()), array.numbers().len(), false)
            }
            Value::Reals(array) => {
                (header_numbers(array.header().rank()), array.numbers().len(), true)
            }
        };
        if ordinal >= numbers {
            return None;
        }
        let word = self.word_span(item)?;
        let values = self.skip::<i64>(word, word.end, header)?;
        match reals {
            true => self.number_at::<f64>(word, self.skip::<f64>(word, values, ordinal)?),
            false => self.number_at::<i64>(word, self.skip::<i64>(word, values, ordinal)?),
        }
    }

    /// Where a number of the header stands: `n` for rank 1, `how n1 n2 n3` counted from 0 for the
    /// others.
    #[must_use]
    pub fn header_span(&self, item: usize, position: usize) -> Option<Span> {
        let header = match &self.item(item)?.assignment()?.value {
            Value::Integers(array) => array.header(),
            Value::Reals(array) => array.header(),
            Value::Integer(_) | Value::Real(_) => return None,
        };
        if position >= header_numbers(header.rank()) {
            return None;
        }
        let word = self.word_span(item)?;
        self.number_at::<i64>(word, self.skip::<i64>(word, word.end, position)?)
    }

    /// Where the keyword, command or comment of an item begins: its first word.
    #[must_use]
    pub fn word_span(&self, item: usize) -> Option<Span> {
        let span = self.item(item)?.span()?;
        let word = next_word(self.sources.get(span.source)?.bytes(), span.start)?;
        Some(Span { start: word.range.start, end: word.range.end.min(span.end), ..span })
    }

    /// Skips numbers of the file that holds `word`.
    fn skip<T: Number>(&self, word: Span, from: usize, numbers: usize) -> Option<usize> {
        let bytes = self.sources.get(word.source)?.bytes();
        Some((0..numbers).fold(from, |at, _| T::scan(bytes, at).end))
    }

    fn number_at<T: Number>(&self, word: Span, at: usize) -> Option<Span> {
        let scanned = T::scan(self.sources.get(word.source)?.bytes(), at);
        Some(Span { start: scanned.start, end: scanned.end, ..word })
    }
}

fn header_numbers(rank: usize) -> usize {
    if rank == 1 { 1 } else { rank + 1 }
}
