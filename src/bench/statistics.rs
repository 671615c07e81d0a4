//! What is made of repeated measurements.

use serde::{Deserialize, Serialize};

/// The middle of sorted values; the mean of the two in the middle if their number is even.
#[must_use]
pub fn median(values: &[f64]) -> Option<f64> {
    let mut sorted = values.to_vec();
    sorted.sort_by(f64::total_cmp);
    let upper = *sorted.get(sorted.len() / 2)?;
    if sorted.len() % 2 == 1 {
        return Some(upper);
    }
    let lower = *sorted.get(sorted.len() / 2 - 1)?;
    Some(f64::midpoint(lower, upper))
}

/// Median, smallest and largest of repeated measurements.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct Spread {
    /// The median.
    pub median: f64,
    /// The smallest.
    pub min: f64,
    /// The largest.
    pub max: f64,
}

impl Spread {
    /// Of some values; `None` if there are none.
    #[must_use]
    pub fn of(values: &[f64]) -> Option<Self> {
        let least = values.iter().copied().reduce(f64::min)?;
        let most = values.iter().copied().reduce(f64::max)?;
        Some(Self { median: median(values)?, min: least, max: most })
    }
}

/// The exponent p of cost ∝ sizeᵖ: the slope of the line of least squares through the logarithms.
/// `None` with fewer than two sizes, or where a number is not above 0.
#[must_use]
pub fn growth_exponent(points: &[[f64; 2]]) -> Option<f64> {
    if points.iter().flatten().any(|&x| !(x > 0.0 && x.is_finite())) {
        return None;
    }
    let logs: Vec<[f64; 2]> = points.iter().map(|p| p.map(f64::ln)).collect();
    let count = logs.len() as f64;
    let mean = |k: usize| logs.iter().map(|p| p[k]).sum::<f64>() / count;
    let [x, y] = [mean(0), mean(1)];
    let above: f64 = logs.iter().map(|p| (p[0] - x) * (p[1] - y)).sum();
    let below: f64 = logs.iter().map(|p| (p[0] - x) * (p[0] - x)).sum();
    (below > 0.0).then(|| above / below)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn medians_do_not_see_outliers() {
        assert_eq!(median(&[]), None);
        assert_eq!(median(&[3.0]), Some(3.0));
        assert_eq!(median(&[100.0, 2.0, 1.0]), Some(2.0));
        assert_eq!(median(&[4.0, 100.0, 1.0, 2.0]), Some(3.0));
    }

    #[test]
    fn spreads_hold_all_values() {
        assert_eq!(Spread::of(&[]), None);
        let spread = Spread { median: 2.0, min: 1.0, max: 7.0 };
        assert_eq!(Spread::of(&[7.0, 1.0, 2.0]), Some(spread));
    }

    #[test]
    fn exponents_are_those_of_power_laws() {
        let law = |p: f64| [1.0, 3.0, 10.0, 70.0].map(|x: f64| [x, 5.0 * x.powf(p)]);
        for p in [-1.0, 0.0, 1.0, 1.5] {
            let found = growth_exponent(&law(p)).expect("an exponent");
            assert!((found - p).abs() < 1e-12, "{found} for {p}");
        }
        assert_eq!(growth_exponent(&[[1.0, 2.0]]), None);
        assert_eq!(growth_exponent(&[[1.0, 2.0], [1.0, 3.0]]), None);
        assert_eq!(growth_exponent(&[[1.0, 2.0], [2.0, 0.0]]), None);
    }
}
