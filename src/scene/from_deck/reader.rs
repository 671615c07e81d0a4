use super::names::{in_dialect, translated};
use crate::scene::SpatialContact;
use std::borrow::Cow;
use yformat::{
    database::{Database, Field},
    deck::Deck,
    diagnostic::Diagnostic,
    dialect::Dialect,
    source::Span,
};

/// Most node sets or joint sets that a deck may have.
const MOST_SETS: usize = 1_000_000;

/// Reads values of a deck and collects findings about them.
pub(super) struct Reader<'a> {
    pub deck: &'a Deck,
    pub database: &'a Database,
    /// Law of contact of tetrahedra, which decks do not name.
    pub spatial_contact: SpatialContact,
    findings: Vec<Diagnostic>,
    /// What too short an array has been reported for: where their number is wrong, all are short.
    reported_short: Vec<&'static str>,
    /// Counts that have been reported: the classic dialect asks for its only one several times.
    reported_counts: Vec<String>,
}

/// `1 entry`, `4 entries`.
fn entries(count: usize) -> String {
    if count == 1 { "1 entry".to_owned() } else { format!("{count} entries") }
}

fn one_entry_each(count: usize, what: &str) -> String {
    format!("{}, one for each of the {what}", entries(count))
}

/// The numbers of `count` things: `0 to 3`, or `0` where there is only one.
pub(super) fn numbers_of(count: usize) -> String {
    match count {
        0 => "there is none".to_owned(),
        1 => "0, as there is only one".to_owned(),
        _ => format!("0 to {}", count - 1),
    }
}

/// The first entry that is wrong, and how many are.
pub(super) struct Offenders {
    pub first: usize,
    pub count: usize,
}

impl Offenders {
    /// Those of `0..len` that `is_wrong`.
    pub fn find(len: usize, is_wrong: impl Fn(usize) -> bool) -> Option<Self> {
        let mut wrong = (0..len).filter(|&i| is_wrong(i));
        let first = wrong.next()?;
        Some(Self { first, count: 1 + wrong.count() })
    }

    /// ` (and 4 more)`, if there are.
    pub fn more(&self) -> String {
        if self.count > 1 { format!(" (and {} more)", self.count - 1) } else { String::new() }
    }
}

impl<'a> Reader<'a> {
    pub fn new(deck: &'a Deck, database: &'a Database) -> Self {
        Self {
            deck,
            database,
            findings: Vec::new(),
            reported_short: Vec::new(),
            reported_counts: Vec::new(),
            spatial_contact: SpatialContact::default(),
        }
    }

    /// The same, for a run with this law of contact of tetrahedra.
    pub fn with_contact(self, spatial_contact: SpatialContact) -> Self {
        Self { spatial_contact, ..self }
    }

    pub fn into_findings(self) -> Vec<Diagnostic> {
        let sources = self.deck.sources();
        self.findings.into_iter().map(|finding| finding.located(sources)).collect()
    }

    /// Keeps a finding, with the keywords in it as the deck's dialect calls them.
    pub fn report(&mut self, mut finding: Diagnostic) {
        let dialect = self.database.dialect();
        let notes = &mut finding.notes;
        let texts = [&mut notes.label, &mut notes.expected, &mut notes.help];
        for text in texts.into_iter().flatten().chain([&mut finding.message]) {
            *text = translated(dialect, text);
        }
        self.findings.push(finding);
    }

    pub fn has_errors(&self) -> bool {
        self.findings.iter().any(Diagnostic::is_error)
    }

    /// What the deck's dialect calls a keyword; `None` if it has no such thing.
    pub fn own_name<'n>(&self, name: &'n str) -> Option<Cow<'n, str>> {
        in_dialect(self.database.dialect(), name)
    }

    /// The same for messages.
    pub fn called<'n>(&self, name: &'n str) -> Cow<'n, str> {
        self.own_name(name).unwrap_or(Cow::Borrowed(name))
    }

    /// Whether the deck is of the classic dialect, with one table for property sets of all kinds.
    pub fn is_classic(&self) -> bool {
        self.database.dialect() == Dialect::Classic
    }

    /// Whether the deck's dialect has the keyword.
    pub fn knows(&self, name: &str) -> bool {
        self.own_name(name).is_some()
    }

    /// An integer, 0 if the dialect has no such keyword.
    pub fn integer(&self, name: &str) -> i64 {
        self.own_name(name).map_or(0, |name| self.database.integer(&name))
    }

    /// A real, 0 if the dialect has no such keyword.
    pub fn real(&self, name: &str) -> f64 {
        self.own_name(name).map_or(0.0, |name| self.database.real(&name))
    }

    /// The item that gives a keyword, if the dialect has it and the deck gives it.
    pub fn given(&self, name: &str) -> Option<usize> {
        self.database.given(&self.own_name(name)?)
    }

    pub fn is_given(&self, name: &str) -> bool {
        self.given(name).is_some()
    }

    /// An array of reals, if the dialect has it and it exists.
    pub fn real_field(&self, name: &str) -> Option<&'a Field<f64>> {
        self.database.reals(&self.own_name(name)?)
    }

    /// An array of integers, if the dialect has it and it exists.
    pub fn integer_field(&self, name: &str) -> Option<&'a Field<i64>> {
        self.database.integers(&self.own_name(name)?)
    }

    /// Where a keyword's first number stands; the keyword itself if it has none.
    pub fn place(&self, name: &str) -> Option<Span> {
        let item = self.given(name)?;
        self.deck.number_span(item, 0).or_else(|| self.deck.word_span(item))
    }

    /// Where a keyword's word stands.
    pub fn word(&self, name: &str) -> Option<Span> {
        self.deck.word_span(self.given(name)?)
    }

    /// Number of entities: `actual` within `capacity`, at least `least`.
    pub fn count(&mut self, actual: &str, capacity: &str, what: &str, least: i64) -> usize {
        let (n, room) = (self.integer(actual), self.integer(capacity));
        let place = self.place(actual).or_else(|| self.place(capacity));
        let (actual, capacity, given) =
            (self.called(actual), self.called(capacity), self.is_given(actual));
        if self.reported_counts.iter().any(|reported| *reported == *actual) {
            return 0;
        }
        if n < least || n > room {
            self.reported_counts.push(actual.clone().into_owned());
        }
        if n < least {
            let message = match given {
                true => format!("{actual} gives {n} {what}"),
                false => format!("{actual}, the number of {what}, is missing"),
            };
            self.report(
                Diagnostic::error("scene::count", message)
                    .at(place)
                    .expected(format!("at least {least}"))
                    .help(format!("give the number of {what} with /YD/{actual}")),
            );
            return 0;
        }
        if n > room {
            self.report(
                Diagnostic::error(
                    "scene::capacity",
                    format!("{actual} gives {n} {what}, {capacity} leaves room for {room}"),
                )
                .at(place)
                .expected(format!("{capacity} of {n} or more"))
                .help(format!(
                    "raise /YD/{capacity} to at least {n}, before the arrays that it sizes"
                )),
            );
            return 0;
        }
        usize::try_from(n).unwrap_or(0)
    }

    /// Number of sets whose arrays may all be absent, so that nothing else bounds it.
    pub fn count_of_sets(&mut self, actual: &str, capacity: &str, what: &str, least: i64) -> usize {
        let n = self.count(actual, capacity, what, least);
        if n <= MOST_SETS {
            return n;
        }
        self.reported_counts.push(self.called(actual).into_owned());
        self.report(
            Diagnostic::error("scene::count", format!("{} gives {n} {what}", self.called(actual)))
                .at(self.place(actual))
                .expected(format!("at most {MOST_SETS}"))
                .help("correct it: a number of this size is hardly meant"),
        );
        0
    }

    /// An array that must give at least `needed` entries along its last index.
    pub fn required_reals(
        &mut self,
        name: &str,
        what: &'static str,
        needed: usize,
    ) -> Option<&'a Field<f64>> {
        let field = self.real_field(name);
        let given = field.map(|f| (f.given_shape().last().copied().unwrap_or(0), f.item()));
        self.complete(name, what, needed, given).then_some(field).flatten()
    }

    /// The same for integers.
    pub fn required_integers(
        &mut self,
        name: &str,
        what: &'static str,
        needed: usize,
    ) -> Option<&'a Field<i64>> {
        let field = self.integer_field(name);
        let given = field.map(|f| (f.given_shape().last().copied().unwrap_or(0), f.item()));
        self.complete(name, what, needed, given).then_some(field).flatten()
    }

    fn complete(
        &mut self,
        name: &str,
        what: &'static str,
        needed: usize,
        given: Option<(usize, Option<usize>)>,
    ) -> bool {
        // their count is wrong, which has been reported
        if needed == 0 {
            return false;
        }
        let name = &*self.called(name);
        let Some((given, Some(_))) = given else {
            self.report(
                Diagnostic::error("scene::missing-array", format!("{name} is missing"))
                    .expected(format!("/YD/{name} with {}", one_entry_each(needed, what)))
                    .help(format!("add /YD/{name} before $YDOIT")),
            );
            return false;
        };
        if given < needed && self.reported_short.contains(&what) {
            return false;
        }
        if given < needed {
            self.reported_short.push(what);
            let place = self.length(name, usize::MAX);
            self.report(
                Diagnostic::error(
                    "scene::short-array",
                    format!("{name} has too few entries for the {what}"),
                )
                .at(place)
                .label(entries(given))
                .expected(one_entry_each(needed, what))
                .help(format!("give the missing entries, or correct the number of {what}")),
            );
            return false;
        }
        true
    }

    /// A real array if the deck gives it: `absent` where there is no such array.
    pub fn reals(&self, name: &str, absent: f64) -> impl Fn(usize) -> f64 + use<'a> {
        let field = self.real_field(name);
        move |i| field.map_or(absent, |f| f.get1(i))
    }

    /// An integer array if the deck gives it: `absent` where there is no such array.
    pub fn integers(&self, name: &str, absent: i64) -> impl Fn(usize) -> i64 + use<'a> {
        let field = self.integer_field(name);
        move |i| field.map_or(absent, |f| f.get1(i))
    }

    /// Where the length of an array along an index stands; that of the last index for an index
    /// beyond.
    pub fn length(&self, name: &str, index: usize) -> Option<Span> {
        let item = self.given(name)?;
        let rank = self.deck.item(item)?.assignment()?.keyword.rank();
        // arrays of one index have no order code before their length
        let position = if rank > 1 { index.saturating_add(1).min(rank) } else { 0 };
        self.deck.header_span(item, position).or_else(|| self.deck.word_span(item))
    }

    /// Where entry `i` of a one-dimensional array stands.
    pub fn entry(&self, name: &str, i: usize) -> Option<Span> {
        self.entry_at(name, [i, 0, 0])
    }

    /// Where an entry of an array stands.
    pub fn entry_at(&self, name: &str, index: [usize; 3]) -> Option<Span> {
        let own = self.own_name(name)?;
        let keyword = yformat::keywords::find(self.database.dialect(), &own)?;
        match keyword.number {
            yformat::keywords::NumberKind::Integer => {
                self.integer_field(name)?.span(self.deck, index)
            }
            yformat::keywords::NumberKind::Real => self.real_field(name)?.span(self.deck, index),
        }
    }

    /// Reports entries of a real array below `least` (or not above it).
    pub fn check_at_least(&mut self, name: &str, len: usize, least: f64, strict: bool, what: &str) {
        let Some(field) = self.real_field(name) else { return };
        let wrong = |i: usize| {
            let value = field.get1(i);
            if strict { value <= least } else { value < least }
        };
        if let Some(found) = Offenders::find(len, wrong) {
            let value = field.get1(found.first);
            let wanted =
                if strict { format!("above {least}") } else { format!("of {least} or more") };
            let called = self.called(name);
            self.report(
                Diagnostic::error(
                    "scene::value-range",
                    format!(
                        "{called}: the {what} of set {} is {value}{}",
                        found.first,
                        found.more()
                    ),
                )
                .at(self.entry(name, found.first))
                .expected(format!("a {what} {wanted}")),
            );
        }
    }
}
