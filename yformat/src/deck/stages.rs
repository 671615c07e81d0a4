//! Stages: what is read before each `$YDOIT`.

use std::ops::Range;

use super::{Deck, ItemKind};

/// Items that are read one after the other, then the steps are run.
///
/// ```
/// let stages = yformat::deck::Deck::parse("a.y", "$YDOIT $YSTOP\n").deck.stages();
/// assert_eq!((stages[0].items.clone(), stages[0].runs), (0..1, true));
/// assert!(!stages[1].runs);
/// ```
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Stage {
    /// Indices of the items, the `$YDOIT` included.
    pub items: Range<usize>,
    /// Whether a `$YDOIT` ends the stage; false only for what follows the last one.
    pub runs: bool,
}

impl Deck {
    /// The stages in order.
    ///
    /// ```
    /// let deck = yformat::deck::Deck::parse("a.y", "/YD/YDC/MCSTEP 5 $YDOIT /YD/YDC/MCSTEP 9 $YDOIT\n").deck;
    /// assert_eq!(deck.stages().iter().filter(|stage| stage.runs).count(), 2);
    /// ```
    #[must_use]
    pub fn stages(&self) -> Vec<Stage> {
        let mut stages = Vec::new();
        let mut start = 0;
        for (index, item) in self.items.iter().enumerate() {
            if item.kind == ItemKind::Run {
                stages.push(Stage { items: start..index + 1, runs: true });
                start = index + 1;
            }
        }
        if start < self.items.len() {
            stages.push(Stage { items: start..self.items.len(), runs: false });
        }
        stages
    }
}
