//! Changing a deck that was read: untouched items keep their bytes.

use super::item::{Assignment, Item, ItemKind, Value};
use super::{Array, Deck, Header};
use crate::keywords::{self, NumberKind};
use crate::source::SourceId;

impl Deck {
    /// Puts another item in the place of one; the white space before it stays. Returns whether
    /// there was such an item.
    ///
    /// ```
    /// use yformat::deck::{Deck, ItemKind};
    ///
    /// let mut deck = Deck::parse("a.y", "/YD/YDC/MCSTEP 5 /* few */\n$YDOIT\n").deck;
    /// let more = deck.scalar("YDC/MCSTEP", 9.0).unwrap();
    /// deck.replace(0, more);
    /// assert_eq!(deck.to_text(), "/YD/YDC/MCSTEP 9 /* few */\n$YDOIT\n");
    /// ```
    pub fn replace(&mut self, index: usize, kind: ItemKind) -> bool {
        let Some(item) = self.items.get_mut(index) else { return false };
        item.kind = kind;
        item.text = None;
        true
    }

    /// Puts a new item before the one with this index, or at the end.
    pub fn insert(&mut self, index: usize, kind: ItemKind) {
        let index = index.min(self.items.len());
        let file = self.items.get(index).map_or(SourceId(0), Item::file);
        self.items.insert(index, Item { file, ..Item::new(kind) });
    }

    /// Takes an item out, with the white space before it.
    pub fn remove(&mut self, index: usize) -> Option<Item> {
        (index < self.items.len()).then(|| self.items.remove(index))
    }

    /// An assignment of a scalar of this deck's dialect, for [`Deck::replace`] and
    /// [`Deck::insert`]. `None` if the dialect has no such scalar.
    #[must_use]
    pub fn scalar(&self, name: &str, value: f64) -> Option<ItemKind> {
        let keyword = keywords::find(self.dialect, name).filter(|keyword| keyword.rank() == 0)?;
        let value = match keyword.number {
            NumberKind::Integer => Value::Integer(Some(value as i64)),
            NumberKind::Real => Value::Real(Some(value)),
        };
        Some(ItemKind::Assignment(Assignment { keyword, value }))
    }

    /// An assignment of an array of reals of this deck's dialect. `None` if the dialect has no such
    /// array of this rank.
    #[must_use]
    pub fn reals(&self, name: &str, header: Header, numbers: Vec<f64>) -> Option<ItemKind> {
        let keyword = keywords::find(self.dialect, name)?;
        let fits = keyword.number == NumberKind::Real && keyword.rank() == header.rank();
        fits.then(|| {
            ItemKind::Assignment(Assignment {
                keyword,
                value: Value::Reals(Array::new(header, numbers)),
            })
        })
    }

    /// An assignment of an array of integers of this deck's dialect. `None` if the dialect has no
    /// such array of this rank.
    #[must_use]
    pub fn integers(&self, name: &str, header: Header, numbers: Vec<i64>) -> Option<ItemKind> {
        let keyword = keywords::find(self.dialect, name)?;
        let fits = keyword.number == NumberKind::Integer && keyword.rank() == header.rank();
        fits.then(|| {
            ItemKind::Assignment(Assignment {
                keyword,
                value: Value::Integers(Array::new(header, numbers)),
            })
        })
    }
}
