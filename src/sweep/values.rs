//! The values that a parameter takes.

use super::{cell::Cell, random::Random};

/// Where the values of a parameter come from.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// These, in this order.
    Given(Vec<Cell>),
    /// Anything from the first to the second, all alike.
    Uniform([f64; 2]),
    /// Anything from the first to the second, every factor alike; both above 0.
    LogUniform([f64; 2]),
}

impl Values {
    /// `count` numbers with equal differences; both ends belong to them.
    #[must_use]
    pub fn linspace([from, to]: [f64; 2], count: usize) -> Self {
        Self::spaced(count, to, from, |share| from + (to - from) * share)
    }

    /// `count` numbers with equal ratios; both ends belong to them. Both are above 0.
    #[must_use]
    pub fn logspace([from, to]: [f64; 2], count: usize) -> Self {
        Self::spaced(count, to, from, |share| between_logarithms([from, to], share))
    }

    fn spaced(count: usize, to: f64, from: f64, value: impl Fn(f64) -> f64) -> Self {
        let last = count.saturating_sub(1);
        let at = |k: usize| match k {
            0 => from,
            k if k == last => to,
            k => value(k as f64 / last as f64),
        };
        Self::Given((0..count).map(|k| Cell::Number(at(k))).collect())
    }

    /// The value below which a share in [0, 1) of all values lies.
    fn quantile(&self, share: f64) -> Option<Cell> {
        Some(match self {
            Self::Uniform([low, high]) => Cell::Number(low + (high - low) * share),
            Self::LogUniform(range) => Cell::Number(between_logarithms(*range, share)),
            Self::Given(values) => {
                let at = (share * values.len() as f64) as usize;
                values.get(at.min(values.len().checked_sub(1)?))?.clone()
            }
        })
    }

    /// A column of a Latin hypercube: of `samples` parts that are equally likely, each gives one
    /// value, at a random place within it, in random order.
    pub(super) fn latin(&self, samples: usize, random: &mut Random) -> Option<Vec<Cell>> {
        let order = random.order(samples);
        let share = |stratum: usize| (stratum as f64 + random.unit()) / samples as f64;
        order.into_iter().map(share).map(|share| self.quantile(share)).collect()
    }
}

/// Between two numbers on a logarithmic scale. Logarithms are those of a library of its own,
/// because those of operating systems differ in the last bit.
fn between_logarithms([from, to]: [f64; 2], share: f64) -> f64 {
    let [low, high] = [from, to].map(libm::log10);
    libm::exp10(low + (high - low) * share)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn numbers(values: &Values) -> Vec<f64> {
        let Values::Given(cells) = values else { panic!("values") };
        cells.iter().filter_map(Cell::value).collect()
    }

    #[test]
    fn spaced_values_have_both_ends_and_round_middles() {
        assert_eq!(numbers(&Values::linspace([1.0, 2.0], 5)), [1.0, 1.25, 1.5, 1.75, 2.0]);
        assert_eq!(numbers(&Values::logspace([1e9, 1e11], 3)), [1e9, 1e10, 1e11]);
        assert_eq!(numbers(&Values::logspace([3.0, 0.1], 2)), [3.0, 0.1]);
        assert_eq!(numbers(&Values::linspace([7.0, 9.0], 1)), [7.0]);
    }

    #[test]
    fn each_stratum_of_a_latin_hypercube_is_met_once() {
        let samples = 37;
        for seed in 0..20 {
            for (range, log) in [([-2.0, 5.0], false), ([1e-3, 1e6], true)] {
                let values = if log { Values::LogUniform(range) } else { Values::Uniform(range) };
                let column = values.latin(samples, &mut Random::of(seed, "x")).expect("a column");
                let scale = |x: f64| if log { x.ln() } else { x };
                let [low, high] = range.map(scale);
                let mut strata: Vec<usize> = column
                    .iter()
                    .filter_map(Cell::value)
                    .map(|x| ((scale(x) - low) / (high - low) * samples as f64) as usize)
                    .collect();
                strata.sort_unstable();
                assert_eq!(strata, (0..samples).collect::<Vec<_>>(), "seed {seed}");
            }
        }
    }

    #[test]
    fn given_values_have_equal_shares_of_a_latin_hypercube() {
        let given = Values::Given(["a", "b", "c"].map(|w| Cell::Word(w.to_owned())).to_vec());
        let column = given.latin(12, &mut Random::of(3, "bond")).expect("a column");
        for word in ["a", "b", "c"] {
            assert_eq!(column.iter().filter(|c| **c == Cell::Word(word.to_owned())).count(), 4);
        }
    }

    /// The numbers themselves are part of what a study means: they must not change. They were
    /// computed apart from this program, in Python with fifty digits.
    #[test]
    fn samples_are_the_same_everywhere() {
        let column = Values::LogUniform([1e9, 1e11]).latin(3, &mut Random::of(1, "young"));
        let bits: Vec<u64> =
            column.expect("a column").iter().filter_map(Cell::value).map(f64::to_bits).collect();
        assert_eq!(bits, SAMPLES);
    }

    const SAMPLES: [u64; 3] =
        [4_756_258_133_012_218_971, 4_745_507_822_590_986_920, 4_764_952_954_422_761_885];
}
