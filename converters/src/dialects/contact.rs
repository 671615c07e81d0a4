//! Contact laws of pairs of element sets, and how single values per set make them.

use std::collections::BTreeMap;

use super::DialectError;

/// Most sets for which all pairs are looked at.
const MOST_SETS: usize = 2000;

/// How two element sets touch.
#[derive(Debug, Clone, Copy, Default, PartialEq)]
pub(super) struct PairLaw {
    /// Coulomb friction.
    pub(super) friction: f64,
    /// Normal penalty, Pa.
    pub(super) normal: f64,
    /// Tangential penalty, Pa.
    pub(super) tangential: f64,
}

/// The laws of all pairs, by set numbers, the smaller one first.
#[derive(Debug, Clone, Default, PartialEq)]
pub(super) struct PairTable {
    pub(super) laws: BTreeMap<(usize, usize), PairLaw>,
}

impl PairTable {
    /// The table of `sets` sets with a law for each pair.
    pub(super) fn of(
        sets: usize,
        law: impl Fn(usize, usize) -> PairLaw,
    ) -> Result<Self, DialectError> {
        if sets > MOST_SETS {
            return Err(DialectError::TooManySets(sets));
        }
        let pairs = (0..sets).flat_map(|i| (i..sets).map(move |j| (i, j)));
        Ok(Self { laws: pairs.map(|(i, j)| ((i, j), law(i, j))).collect() })
    }

    fn get(&self, i: usize, j: usize) -> PairLaw {
        self.laws.get(&(i.min(j), i.max(j))).copied().unwrap_or_default()
    }

    /// Values per set whose smaller one is that of the pair. Pairs (i, i) are taken as they are,
    /// unless `only_different`: then the value of a set is the greatest of its pairs with others.
    pub(super) fn per_set(
        &self,
        sets: usize,
        value: impl Fn(PairLaw) -> f64,
        only_different: bool,
    ) -> Vec<f64> {
        (0..sets)
            .map(|i| match only_different {
                false => value(self.get(i, i)),
                true => {
                    let others = (0..sets).filter(|&j| j != i).map(|j| value(self.get(i, j)));
                    others.reduce(f64::max).unwrap_or_else(|| value(self.get(i, i)))
                }
            })
            .collect()
    }

    /// The pairs, at most `(i, j)` with i < j, for which the smaller of two values per set is
    /// another one.
    pub(super) fn misfits(
        &self,
        values: &[f64],
        value: impl Fn(PairLaw) -> f64,
    ) -> Vec<(usize, usize)> {
        let at = |i: usize| values.get(i).copied().unwrap_or(0.0);
        let pairs = self.laws.iter().filter(|((i, j), _)| i != j);
        pairs
            .filter(|((i, j), law)| at(*i).min(at(*j)) != value(**law))
            .map(|(&pair, _)| pair)
            .collect()
    }
}

/// A sentence about pairs whose law cannot be said, if there are any.
pub(super) fn misfit_line(what: &str, rule: &str, pairs: &[(usize, usize)]) -> Option<String> {
    let (i, j) = pairs.first()?;
    let more = match pairs.len() {
        1 => String::new(),
        count => format!(" and of {} more pairs", count - 1),
    };
    Some(format!("the {what} of element sets {i} and {j}{more} is not {rule} any more"))
}
