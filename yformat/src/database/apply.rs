//! Executes one item of a deck.

use super::field::Field;
use super::values::{Database, Slot};
use crate::deck::{Deck, Header, Value};
use crate::diagnostic::Diagnostic;
use crate::keywords::{self, Adjustment, Extent, Keyword, NumberKind};

impl Database {
    /// Executes the item with this index: an assignment changes values, everything else changes
    /// nothing.
    ///
    /// Values are stored also where an error is reported, as far as that makes sense.
    pub fn apply(&mut self, deck: &Deck, index: usize) -> Vec<Diagnostic> {
        let Some(given) = deck.item(index).and_then(|item| item.assignment()) else {
            return Vec::new();
        };
        let keyword = given.keyword;
        let mut found = Vec::new();
        match &given.value {
            Value::Integer(None) | Value::Real(None) => {}
            Value::Integer(Some(value)) => {
                let value = adjusted(keyword.adjustment, *value);
                self.put(keyword, Slot::Integer { value, item: Some(index) });
                self.resize(deck, index, keyword, value, &mut found);
            }
            Value::Real(Some(value)) => {
                self.put(keyword, Slot::Real { value: *value, item: Some(index) })
            }
            Value::Integers(array) => {
                let (target, declared) =
                    self.check_array(deck, index, keyword, array.header(), &mut found);
                let field =
                    Field::new(keyword.rank(), declared, target.fill as i64, array.clone(), index);
                self.put(target, Slot::Integers(field));
            }
            Value::Reals(array) => {
                let (target, declared) =
                    self.check_array(deck, index, keyword, array.header(), &mut found);
                let field = Field::new(keyword.rank(), declared, target.fill, array.clone(), index);
                self.put(target, Slot::Reals(field));
            }
        }
        found.into_iter().map(|diagnostic| diagnostic.located(deck.sources())).collect()
    }

    fn put(&mut self, keyword: &Keyword, slot: Slot) {
        self.slots.insert((keyword.database, keyword.name), slot);
    }

    /// Present value of a size keyword of a database.
    fn size(&self, database: &'static str, name: &'static str) -> usize {
        match self.slots.get(&(database, name)) {
            Some(Slot::Integer { value, .. }) => usize::try_from(*value).unwrap_or(0),
            _ => 0,
        }
    }

    fn declared(&self, keyword: &Keyword) -> [usize; 3] {
        let mut declared = [1; 3];
        for (length, extent) in declared.iter_mut().zip(keyword.extents) {
            *length = match extent {
                Extent::Fixed(length) => *length,
                Extent::Size(name) => self.size(keyword.database, name),
            };
        }
        declared
    }

    /// A size keyword makes some arrays anew, and leaves others at their old size.
    fn resize(
        &mut self,
        deck: &Deck,
        index: usize,
        size: &Keyword,
        value: i64,
        found: &mut Vec<Diagnostic>,
    ) {
        let table = keywords::table(self.dialect, size.database);
        for keyword in table.into_iter().flat_map(|table| table.keywords) {
            let declared = self.declared(keyword);
            let exists = declared.iter().all(|&length| length > 0);
            let made =
                keyword.created.filter(|created| created.by == size.name && value > 0 && exists);
            let old = self.slot(keyword).and_then(Slot::shape);
            if let Some(created) = made {
                if let Some((_, true)) = old {
                    let message = format!(
                        "{} makes {} anew: the values given before are lost",
                        size.path(),
                        keyword.path()
                    );
                    let warning =
                        Diagnostic::warning("deck::values-lost", message).at(deck.word_span(index));
                    found.push(warning.help(format!("move {} before {}", size.name, keyword.name)));
                }
                let (rank, value) = (keyword.rank(), created.value);
                let slot = match keyword.number {
                    NumberKind::Integer => {
                        Slot::Integers(Field::filled(rank, declared, value as i64))
                    }
                    NumberKind::Real => Slot::Reals(Field::filled(rank, declared, value)),
                };
                self.put(keyword, slot);
            } else if let Some((old, true)) = old
                && keyword.is_sized_by(size.name)
                && !self.reported_sizes.contains(&(size.database, size.name))
                && old.iter().zip(declared).any(|(&old, now)| old < now)
            {
                let message = format!(
                    "{} was made before {} was set to {value} and stays smaller",
                    keyword.path(),
                    size.path()
                );
                let warning = Diagnostic::warning("deck::array-stays-small", message)
                    .at(deck.word_span(index));
                found.push(
                    warning.help(format!("move {} before the first {}", size.name, keyword.name)),
                );
            }
        }
    }

    /// Checks the lengths of an array against its declared ones; returns the keyword that it is
    /// stored under and the latter.
    fn check_array(
        &mut self,
        deck: &Deck,
        index: usize,
        keyword: &'static Keyword,
        header: &Header,
        found: &mut Vec<Diagnostic>,
    ) -> (&'static Keyword, [usize; 3]) {
        let alias = keyword.stores_into.and_then(|name| {
            keywords::table(self.dialect, keyword.database)?.match_name(name.as_bytes())
        });
        let target = alias.unwrap_or(keyword);
        let declared = self.declared(target);
        if let Some(name) = keyword.stores_into {
            let message = format!(
                "the original stores {} into {name}, whose values are lost",
                keyword.path()
            );
            found.push(
                Diagnostic::warning("deck::wrong-array", message)
                    .at(deck.word_span(index))
                    .help("leave it out"),
            );
        }
        if header.expected() == 0 {
            return (target, declared);
        }
        for (axis, extent) in target.extents.iter().enumerate() {
            let count = usize::try_from(header.counts()[axis]).unwrap_or(0);
            if count > declared[axis] {
                if let Extent::Size(name) = *extent
                    && !self.reported_sizes.insert((keyword.database, name))
                {
                    return (target, declared);
                }
                found.push(self.too_long(deck, index, keyword, axis, *extent, count));
                return (target, declared);
            }
        }
        let old = self.slot(target).and_then(Slot::shape);
        if let Some((old, _)) = old
            && old.iter().zip(declared).any(|(&old, now)| old < now)
        {
            let message =
                format!("{} was made smaller before: the original overruns it", keyword.path());
            let error =
                Diagnostic::error("deck::array-outgrown", message).at(deck.word_span(index));
            found.push(error.help(
                "give the size keywords once, before all arrays, large enough for all stages",
            ));
        }
        (target, declared)
    }

    fn too_long(
        &self,
        deck: &Deck,
        index: usize,
        keyword: &Keyword,
        axis: usize,
        extent: Extent,
        count: usize,
    ) -> Diagnostic {
        let position = if keyword.rank() == 1 { 0 } else { axis + 1 };
        let place = deck.header_span(index, position).or_else(|| deck.word_span(index));
        let path = keyword.path();
        let name = match extent {
            Extent::Fixed(length) => {
                let message = format!("{path} is given length {count}, where it holds {length}");
                return Diagnostic::error("deck::too-long", message)
                    .at(place)
                    .expected(format!("at most {length}"));
            }
            Extent::Size(name) => name,
        };
        let declared = self.size(keyword.database, name);
        let size = format!("/YD/{}/{name}", keyword.database);
        if declared > 0 {
            let message =
                format!("{path} is given length {count}, where {name} declares {declared}");
            let error = Diagnostic::error("deck::too-long", message)
                .at(place)
                .expected(format!("at most {declared}"));
            return error.help(format!("raise {size}, or give fewer values"));
        }
        let is_size = |kept: &crate::deck::Assignment| {
            kept.keyword.name == name && kept.keyword.database == keyword.database
        };
        let later = deck.assignments().find(|(at, given)| *at > index && is_size(given));
        let error = Diagnostic::error(
            "deck::size-missing",
            format!("{path} comes before {size} has declared its length"),
        );
        match later {
            Some((at, _)) => {
                let line = deck.word_span(at).map(|span| deck.sources().location(span).line);
                let line = line.map_or_else(String::new, |line| format!(" from line {line}"));
                error.at(deck.word_span(index)).help(format!("move {size}{line} before {path}"))
            }
            None => error
                .at(deck.word_span(index))
                .help(format!("write {size} with at least {count} before it")),
        }
    }
}

impl Slot {
    /// Declared lengths of an array, and whether the deck gives values for it.
    fn shape(&self) -> Option<([usize; 3], bool)> {
        match self {
            Slot::Integers(field) => Some((field.declared, field.given[0] > 0)),
            Slot::Reals(field) => Some((field.declared, field.given[0] > 0)),
            Slot::Integer { .. } | Slot::Real { .. } => None,
        }
    }
}

fn adjusted(adjustment: Adjustment, value: i64) -> i64 {
    match adjustment {
        Adjustment::NegativeTo(instead) if value < 0 => instead,
        Adjustment::NonPositiveTo(instead) if value <= 0 => instead,
        Adjustment::NonZeroTo(instead) if value != 0 => instead,
        Adjustment::OutsideTo(allowed, instead) if !allowed.contains(&value) => instead,
        _ => value,
    }
}
