//! How long couples can be left alone.

use serde::{Deserialize, Serialize};
use std::ops::Range;

/// How long couples can be left alone, in the order of the list. Paths are those of the fastest
/// node since the list was made: no node has moved further.
///
/// Paths are rounded down to single precision, which is precise enough for a bound and takes half
/// the memory.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub(super) struct Respites {
    /// Path up to which the couple provably has no effect, m.
    pub rest: Vec<f32>,
    /// Path up to which it provably is not dropped, m.
    pub stay: Vec<f32>,
    /// Path up to which the facing edges alone can tell that it has no effect, m; not beyond
    /// `stay`.
    pub face: Vec<f32>,
    /// How far the facing edges may reach into each other until then, twice an area, m².
    pub limit: Vec<f32>,
    /// Turn from which on it may be asked again whether it can rest ([`is_due`]).
    pub ask: Vec<u16>,
    /// Edges cut in the last evaluation, a bit each.
    pub edges: Vec<u8>,
}

/// The largest number in single precision that is not above this one.
pub(super) fn rounded_down(path: f64) -> f32 {
    let rounded = path as f32;
    if f64::from(rounded) > path { rounded.next_down() } else { rounded }
}

/// Whether a turn has come. Turns are counted round: half of them lie behind, half ahead.
#[inline(always)]
pub(super) fn is_due(ask: u16, turn: u16) -> bool {
    turn.wrapping_sub(ask) < u16::MAX / 2
}

impl Respites {
    /// Whether they are those of so many couples.
    pub fn is_of(&self, couples: usize) -> bool {
        let paths = [&self.rest, &self.stay, &self.face, &self.limit];
        paths.into_iter().all(|values| values.len() == couples)
            && self.ask.len() == couples
            && self.edges.len() == couples
    }

    /// Those of couples in a row.
    pub fn range_mut(&mut self, couples: Range<usize>) -> RespitesMut<'_> {
        RespitesMut {
            rest: &mut self.rest[couples.clone()],
            stay: &mut self.stay[couples.clone()],
            face: &mut self.face[couples.clone()],
            limit: &mut self.limit[couples.clone()],
            ask: &mut self.ask[couples.clone()],
            edges: &mut self.edges[couples],
        }
    }

    /// Those of so many couples of which nothing is known; they may be asked in this turn.
    pub fn reset(&mut self, couples: usize, turn: u16) {
        for paths in [&mut self.rest, &mut self.stay, &mut self.face, &mut self.limit] {
            paths.clear();
            paths.resize(couples, 0.0);
        }
        self.ask.clear();
        self.ask.resize(couples, turn);
        self.edges.clear();
        self.edges.resize(couples, 0);
    }

    /// Keeps the couples for which `keep` holds.
    pub fn retain(&mut self, keep: impl Fn(usize) -> bool) {
        fn retain<T>(values: &mut Vec<T>, keep: impl Fn(usize) -> bool) {
            let mut index = 0..;
            values.retain(|_| index.next().is_some_and(&keep));
        }
        retain(&mut self.rest, &keep);
        retain(&mut self.stay, &keep);
        retain(&mut self.face, &keep);
        retain(&mut self.limit, &keep);
        retain(&mut self.ask, &keep);
        retain(&mut self.edges, &keep);
    }
}

/// [`Respites`] of some couples in a row.
pub(super) struct RespitesMut<'a> {
    pub rest: &'a mut [f32],
    pub stay: &'a mut [f32],
    pub face: &'a mut [f32],
    pub limit: &'a mut [f32],
    pub ask: &'a mut [u16],
    pub edges: &'a mut [u8],
}

/// Parts of the arrays of [`RespitesMut`], as zipped iterators give them.
type Zipped<'a> = (
    ((&'a mut [f32], &'a mut [f32]), (&'a mut [f32], &'a mut [f32])),
    (&'a mut [u16], &'a mut [u8]),
);

impl<'a> RespitesMut<'a> {
    fn zipped((((rest, stay), (face, limit)), (ask, edges)): Zipped<'a>) -> Self {
        Self { rest, stay, face, limit, ask, edges }
    }

    /// Those of so many couples each.
    pub fn chunks(self, size: usize) -> impl Iterator<Item = RespitesMut<'a>> + Send {
        let paths = self.rest.chunks_mut(size).zip(self.stay.chunks_mut(size));
        let faces = self.face.chunks_mut(size).zip(self.limit.chunks_mut(size));
        let others = self.ask.chunks_mut(size).zip(self.edges.chunks_mut(size));
        paths.zip(faces).zip(others).map(Self::zipped)
    }
}

#[cfg(test)]
mod tests {
    use super::{is_due, rounded_down};

    #[test]
    fn turns_come_in_order_also_where_they_begin_anew() {
        assert!(is_due(5, 5) && is_due(5, 6) && !is_due(6, 5));
        assert!(is_due(u16::MAX, 2) && !is_due(3, u16::MAX));
    }

    #[test]
    fn paths_are_never_rounded_up() {
        for path in [0.0, 0.1, 0.3, 1e-30, 1.0 + 1e-9, 1e300] {
            let rounded = f64::from(rounded_down(path));
            assert!(rounded <= path && (rounded >= path * (1.0 - 1e-6) || path > 1e38), "{path}");
        }
    }
}
