//! How the values of parameters are combined into cases.

use super::{cell::Cell, random::Random, values::Values};

/// A way to combine parameters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Sampling {
    /// Every value with every other: the last parameter changes from case to case.
    Grid,
    /// First values, second values, and so on.
    List,
    /// A Latin hypercube.
    LatinHypercube {
        /// Number of cases.
        samples: usize,
        /// What the numbers are drawn by.
        seed: u64,
    },
}

/// Why parameters cannot be combined.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) enum Mismatch {
    /// The parameter with this index has a range where values are needed.
    Range(usize),
    /// The parameter with this index has another number of values than the first.
    Length(usize),
    /// There would be more cases than [`MOST_CASES`].
    TooMany,
}

/// Most cases of a study.
pub const MOST_CASES: usize = 100_000;

impl Sampling {
    /// The values of every parameter, case by case.
    pub(super) fn cases(self, parameters: &[(&str, &Values)]) -> Result<Vec<Vec<Cell>>, Mismatch> {
        if let Self::LatinHypercube { samples, seed } = self {
            if samples > MOST_CASES {
                return Err(Mismatch::TooMany);
            }
            let column = |(index, (name, values)): (usize, &(&str, &Values))| {
                values.latin(samples, &mut Random::of(seed, name)).ok_or(Mismatch::Length(index))
            };
            let columns: Vec<Vec<Cell>> =
                parameters.iter().enumerate().map(column).collect::<Result<_, _>>()?;
            return Ok(rows(&columns, samples));
        }
        let given = |(index, (_, values)): (usize, &(&str, &Values))| match values {
            Values::Given(cells) => Ok(cells.clone()),
            Values::Uniform(_) | Values::LogUniform(_) => Err(Mismatch::Range(index)),
        };
        let columns: Vec<Vec<Cell>> =
            parameters.iter().enumerate().map(given).collect::<Result<_, _>>()?;
        if self == Self::List {
            let length = columns.first().map_or(0, Vec::len);
            if let Some(other) = columns.iter().position(|column| column.len() != length) {
                return Err(Mismatch::Length(other));
            }
            let length = Some(length).filter(|&length| length <= MOST_CASES);
            return Ok(rows(&columns, length.ok_or(Mismatch::TooMany)?));
        }
        let count = columns.iter().try_fold(1usize, |count, column| {
            count.checked_mul(column.len()).filter(|&count| count <= MOST_CASES)
        });
        let count = count.ok_or(Mismatch::TooMany)?;
        let case = |case: usize| {
            let mut rest = case;
            let mut row: Vec<Cell> = columns
                .iter()
                .rev()
                .filter_map(|column| {
                    let cell = column.get(rest % column.len().max(1)).cloned();
                    rest /= column.len().max(1);
                    cell
                })
                .collect();
            row.reverse();
            row
        };
        Ok((0..count).map(case).collect())
    }
}

fn rows(columns: &[Vec<Cell>], count: usize) -> Vec<Vec<Cell>> {
    let row = |k: usize| columns.iter().filter_map(|column| column.get(k).cloned()).collect();
    (0..count).map(row).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn given(numbers: &[f64]) -> Values {
        Values::Given(numbers.iter().map(|&x| Cell::Number(x)).collect())
    }

    fn cases(sampling: Sampling, parameters: &[(&str, &Values)]) -> Vec<Vec<f64>> {
        let cases = sampling.cases(parameters).expect("cases");
        cases.iter().map(|row| row.iter().filter_map(Cell::value).collect()).collect()
    }

    #[test]
    fn a_grid_has_every_combination_once() {
        let (a, b) = (given(&[1.0, 2.0]), given(&[5.0, 6.0, 7.0]));
        let found = cases(Sampling::Grid, &[("a", &a), ("b", &b)]);
        let expected = [[1.0, 5.0], [1.0, 6.0], [1.0, 7.0], [2.0, 5.0], [2.0, 6.0], [2.0, 7.0]];
        assert_eq!(found, expected.map(Vec::from));
    }

    #[test]
    fn a_list_has_rows() {
        let (a, b) = (given(&[1.0, 2.0]), given(&[5.0, 6.0]));
        assert_eq!(
            cases(Sampling::List, &[("a", &a), ("b", &b)]),
            [vec![1.0, 5.0], vec![2.0, 6.0]]
        );
        let c = given(&[1.0]);
        assert_eq!(Sampling::List.cases(&[("a", &a), ("c", &c)]), Err(Mismatch::Length(1)));
    }

    #[test]
    fn ranges_need_a_latin_hypercube() {
        let (a, b) = (given(&[1.0]), Values::Uniform([0.0, 1.0]));
        assert_eq!(Sampling::Grid.cases(&[("a", &a), ("b", &b)]), Err(Mismatch::Range(1)));
        let latin = Sampling::LatinHypercube { samples: 5, seed: 1 };
        assert_eq!(cases(latin, &[("a", &a), ("b", &b)]).len(), 5);
    }

    #[test]
    fn parameters_that_are_added_leave_the_others_alone() {
        let (a, b) = (Values::Uniform([0.0, 1.0]), Values::Uniform([0.0, 1.0]));
        let latin = Sampling::LatinHypercube { samples: 8, seed: 11 };
        let one = cases(latin, &[("a", &a)]);
        let both = cases(latin, &[("b", &b), ("a", &a)]);
        assert!(one.iter().zip(&both).all(|(x, y)| x[0].to_bits() == y[1].to_bits()));
        assert!(both.iter().any(|row| row[0].to_bits() != row[1].to_bits()));
    }

    #[test]
    fn studies_have_an_end() {
        let many = given(&[0.0; 1000]);
        let three = [("a", &many), ("b", &many), ("c", &many)];
        assert_eq!(Sampling::Grid.cases(&three), Err(Mismatch::TooMany));
    }
}
