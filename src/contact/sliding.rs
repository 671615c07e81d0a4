//! Sliding of the couples that have slid.
//!
//! Most couples never touch: a row is lent to a couple when it first slides, and
//! stays with the couple's slot for good, as slots are never cleared.

use serde::{Deserialize, Serialize};

/// Sliding accumulated on the edges of target and contactor, m².
pub type SlidingRow = [f64; 6];

/// Which row is a couple's: 0 for none, else one more than its place.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Serialize, Deserialize)]
pub struct RowPlace(u32);

impl RowPlace {
    #[inline(always)]
    fn index(self) -> usize {
        // no row has the number that comes of none
        self.0.wrapping_sub(1) as usize
    }
}

/// Rows of all couples that have slid.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Sliding {
    rows: Vec<SlidingRow>,
}

impl Sliding {
    /// The row of a couple.
    #[inline(always)]
    pub fn of(&self, place: RowPlace) -> &SlidingRow {
        self.rows.get(place.index()).unwrap_or(&[0.0; 6])
    }

    /// Takes over the row of a couple.
    #[inline(always)]
    pub fn keep(&mut self, place: &mut RowPlace, row: &SlidingRow) {
        if let Some(kept) = self.rows.get_mut(place.index()) {
            *kept = *row;
        } else if row.iter().any(|slid| slid.to_bits() != 0) {
            self.rows.push(*row);
            *place = RowPlace(self.rows.len() as u32);
        }
    }

    /// Makes room for the rows of so many couples, so that none has to be made while they are
    /// evaluated. What is not used takes no memory, only addresses.
    pub fn reserve(&mut self, couples: usize) {
        self.rows.reserve(couples.saturating_sub(self.rows.len()));
    }

    /// Whether the row of a couple is there, if it has one.
    pub fn has(&self, place: RowPlace) -> bool {
        place == RowPlace::default() || place.index() < self.rows.len()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn only_couples_that_slide_have_rows() {
        let mut sliding = Sliding::default();
        let (mut still, mut moving) = (RowPlace::default(), RowPlace::default());
        sliding.keep(&mut still, &[0.0; 6]);
        sliding.keep(&mut moving, &[0.0, 1.0, 0.0, 0.0, 0.0, 0.0]);
        sliding.keep(&mut moving, &[0.0, 2.0, 0.0, 0.0, 0.0, 0.0]);
        assert_eq!((sliding.rows.len(), still), (1, RowPlace::default()));
        assert_eq!(sliding.of(moving)[1], 2.0);
        sliding.keep(&mut moving, &[0.0; 6]);
        assert_eq!((sliding.of(moving), sliding.of(still)), (&[0.0; 6], &[0.0; 6]));
    }
}
