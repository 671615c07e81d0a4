//! Where the settings of a deck stand.

use yformat::{database::Database, deck::Deck, source::Span};

/// A deck and what it gives.
#[derive(Debug, Clone, Copy)]
pub(super) struct Places<'a> {
    pub deck: &'a Deck,
    pub database: &'a Database,
}

impl Places<'_> {
    /// A scalar; the first of the names that the deck gives.
    pub fn of(&self, names: &[&str]) -> Option<Span> {
        self.number(names, 0)
    }

    /// An entry of an array.
    pub fn number(&self, names: &[&str], entry: usize) -> Option<Span> {
        let given =
            |name: &&str| self.database.knows(name).then(|| self.database.given(name)).flatten();
        let item = names.iter().find_map(given)?;
        self.deck.number_span(item, entry).or_else(|| self.deck.word_span(item))
    }

    /// An entry of an array of element property sets.
    pub fn of_set(&self, keyword: &str, set: usize) -> Option<Span> {
        let names = [format!("YDPE/{keyword}"), format!("YDP/{keyword}")];
        self.number(&names.each_ref().map(String::as_str), set)
    }
}
