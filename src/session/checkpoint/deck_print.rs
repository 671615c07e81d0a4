use serde::{Deserialize, Serialize};
use yformat::{checksum::Checksum, deck::Deck};

/// Tells a deck from others: a checksum of its text and that of the files that it includes. The
/// values of `MCSTEP` are left out, so that a finished run can be made longer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
pub(in crate::session) struct DeckPrint(u64);

impl DeckPrint {
    /// The print of a deck as it was read.
    pub fn of(deck: &Deck) -> Self {
        let mut free: Vec<_> = deck
            .assignments()
            .filter(|(_, assignment)| {
                assignment.keyword.database == "YDC" && assignment.keyword.name == "MCSTEP"
            })
            .filter_map(|(item, _)| deck.number_span(item, 0))
            .collect();
        free.sort_by_key(|span| (span.source.index(), span.start));
        let mut checksum = Checksum::new();
        for (index, source) in deck.sources().iter().enumerate() {
            let mut at = 0;
            for span in free.iter().filter(|span| span.source.index() == index) {
                checksum.add(source.bytes().get(at..span.start).unwrap_or_default());
                // keeps apart what the number kept apart
                checksum.add(&[0]);
                at = span.end.max(at);
            }
            checksum.add(source.bytes().get(at..).unwrap_or_default());
            checksum.add(&[0xff]);
        }
        Self(checksum.value())
    }
}
