//! Round numbers at axes, and prefixes of units.

/// Ticks of an axis.
#[derive(Debug, Clone, PartialEq)]
pub struct Ticks {
    /// Where they are.
    pub values: Vec<f64>,
    /// What they say, all with the same number of decimals.
    pub labels: Vec<String>,
}

impl Ticks {
    /// Round numbers (1, 2 or 5 times a power of ten apart) from `low` to `high`, about `wanted`
    /// of them.
    ///
    /// ```
    /// use ypsilon_post::plot::Ticks;
    /// assert_eq!(Ticks::new(-0.26, 0.31, 5).labels, ["−0.2", "−0.1", "0.0", "0.1", "0.2", "0.3"]);
    /// ```
    #[must_use]
    pub fn new(low: f64, high: f64, wanted: usize) -> Self {
        let span = high - low;
        if !(span.is_finite() && span > 0.0) || wanted == 0 {
            return Self { values: Vec::new(), labels: Vec::new() };
        }
        let raw = span / wanted as f64;
        let power = raw.log10().floor();
        let unit = 10_f64.powf(power);
        let step = match raw / unit {
            share if share < 1.5 => 1.0,
            share if share < 3.5 => 2.0,
            share if share < 7.5 => 5.0,
            _ => 10.0,
        };
        let power = if step >= 10.0 { power + 1.0 } else { power };
        let step = if step >= 10.0 { 10_f64.powf(power) } else { step * unit };
        let decimals = (-power).clamp(0.0, 12.0) as usize;
        let first = (low / step - 1e-9).ceil() as i64;
        let last = (high / step + 1e-9).floor() as i64;
        let values: Vec<f64> =
            (first..=last.min(first.saturating_add(1000))).map(|i| i as f64 * step).collect();
        let labels = values.iter().map(|v| label(*v, decimals)).collect();
        Self { values, labels }
    }
}

impl Ticks {
    /// Ticks of a logarithmic axis that shows the numbers 10^`low` to 10^`high`: powers of ten,
    /// and twice and five times these where there are few. Values are logarithms.
    ///
    /// ```
    /// use ypsilon_post::plot::Ticks;
    /// assert_eq!(Ticks::logarithmic(-6.1, 0.1, 4).labels, ["10⁻⁶", "10⁻⁴", "10⁻²", "1"]);
    /// assert_eq!(Ticks::logarithmic(-1.0, 0.31, 5).labels, ["0.1", "0.2", "0.5", "1", "2"]);
    /// ```
    #[must_use]
    pub fn logarithmic(low: f64, high: f64, wanted: usize) -> Self {
        let none = Self { values: Vec::new(), labels: Vec::new() };
        if !(low < high && low.is_finite() && high.is_finite()) || wanted == 0 {
            return none;
        }
        let [first, last] = [low.floor(), high.ceil()].map(|x| x.clamp(-300.0, 300.0) as i32);
        let span = high - low;
        let stride = if span <= 2.5 { 1 } else { ((span / wanted as f64).ceil() as i32).max(1) };
        let factors: &[f64] = if span <= 2.5 { &[1.0, 2.0, 5.0] } else { &[1.0] };
        let decades = (first..=last).filter(|power| power.rem_euclid(stride) == 0);
        let all = decades.flat_map(|power| factors.iter().map(move |&factor| (power, factor)));
        let at = |(power, factor): &(i32, f64)| f64::from(*power) + factor.log10();
        let shown = all.filter(|tick| (low - 1e-9..=high + 1e-9).contains(&at(tick)));
        shown.fold(none, |mut ticks, (power, factor)| {
            ticks.values.push(at(&(power, factor)));
            let is_plain = (-3..=3).contains(&power) && span <= 2.5 || power == 0;
            ticks.labels.push(match (is_plain, factor == 1.0) {
                (true, _) => {
                    label(factor * 10_f64.powi(power), usize::try_from(-power).unwrap_or(0))
                }
                (false, true) => format!("10{}", superscript(power)),
                (false, false) => format!("{factor}·10{}", superscript(power)),
            });
            ticks
        })
    }
}

/// A number with a true minus sign.
pub(super) fn label(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    if text.trim_start_matches('-').chars().all(|c| matches!(c, '0' | '.')) {
        text.trim_start_matches('-').to_owned()
    } else {
        text.replace('-', "−")
    }
}

/// A number of about four digits.
pub(super) fn short(value: f64) -> String {
    if value == 0.0 || !value.is_finite() {
        return label(value, 0);
    }
    let power = value.abs().log10().floor();
    if (-4.0..6.0).contains(&power) {
        label(value, (3.0 - power).clamp(0.0, 8.0) as usize)
    } else {
        let mantissa = label(value / 10_f64.powf(power), 3);
        format!("{mantissa}·10{}", superscript(power as i32))
    }
}

/// The factor that makes `largest` a handy number, and the prefix or power that says so: for
/// units of the SI a prefix (`("M", 1e6)`), without unit a power of ten (`("10³", 1e3)`).
#[must_use]
pub fn prefix(largest: f64, unit: &str) -> (String, f64) {
    if !(largest.is_finite() && largest > 0.0) {
        return (String::new(), 1.0);
    }
    let power = (largest.log10() / 3.0 + 1e-12).floor() as i32 * 3;
    let letters = [(-9, "n"), (-6, "µ"), (-3, "m"), (0, ""), (3, "k"), (6, "M"), (9, "G")];
    let is_si = matches!(unit, "Pa" | "m" | "m/s" | "N" | "J" | "s");
    // tenths of the unit and numbers up to ten thousand need no prefix
    let plain = if unit == "Pa" { 1.0..1e3 } else { 0.1..1e4 };
    if plain.contains(&largest) {
        return (String::new(), 1.0);
    }
    // nobody measures in km or ks here
    let is_small_only = matches!(unit, "m" | "m/s" | "s");
    match letters.iter().find(|(p, _)| *p == power) {
        Some((p, letter)) if is_si && !(is_small_only && *p > 0) => {
            ((*letter).to_owned(), 10_f64.powi(*p))
        }
        _ => (format!("10{} ", superscript(power)), 10_f64.powi(power)),
    }
}

fn superscript(power: i32) -> String {
    let digit = |c: char| match c {
        '-' => '⁻',
        '1' => '¹',
        '2' => '²',
        '3' => '³',
        c => char::from_u32('⁰' as u32 + c.to_digit(10).unwrap_or(0)).unwrap_or(c),
    };
    power.to_string().chars().map(digit).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ticks_are_round() {
        assert_eq!(Ticks::new(0.0, 10.0, 5).labels, ["0", "2", "4", "6", "8", "10"]);
        assert_eq!(Ticks::new(1e6, 1.3e6, 3).labels, ["1000000", "1100000", "1200000", "1300000"]);
        assert_eq!(Ticks::new(0.0, 0.97, 10).labels[9], "0.9");
        assert!(Ticks::new(1.0, 1.0, 5).values.is_empty());
        assert!(Ticks::new(f64::NAN, 1.0, 5).values.is_empty());
        assert_eq!(
            Ticks::new(0.0, 0.05, 5).labels,
            ["0.00", "0.01", "0.02", "0.03", "0.04", "0.05"]
        );
    }

    #[test]
    fn units_get_prefixes() {
        let of = |value, unit| prefix(value, unit).0;
        assert_eq!(of(8.3e5, "Pa"), "k");
        assert_eq!(of(1.0e6, "Pa"), "M");
        assert_eq!(of(0.03, "m"), "m");
        assert_eq!(of(0.3, "m"), "");
        assert_eq!(of(2.0e5, "m"), "10³ ");
        assert_eq!(of(2.0e-4, ""), "10⁻⁶ ");
        assert_eq!(of(0.0, "m"), "");
    }

    #[test]
    fn short_numbers_have_four_digits() {
        assert_eq!(short(-0.83124), "−0.8312");
        assert_eq!(short(12345.6), "12346");
        assert_eq!(short(1.5e-7), "1.500·10⁻⁷");
        assert_eq!(short(-0.0), "0");
    }
}
