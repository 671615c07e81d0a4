//! Numbers printed as C's `printf` prints them: Y's text files are defined by its formats.

use std::fmt;

/// How many digits the exponent has at least.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ExponentDigits {
    /// Two, as C prescribes.
    #[default]
    Two,
    /// Three, as the C library of older Windows programs prints.
    Three,
}

/// The conversion `%e` of C with its flags, width and precision.
///
/// ```
/// use yformat::c_format::{ExponentDigits, Exponential};
/// let plain = Exponential::new(7).width(15);            // %15.7e
/// assert_eq!(plain.format(0.25).to_string(), "  2.5000000e-01");
/// let signed = Exponential::new(10).plus();             // %+17.10e where it fits
/// assert_eq!(signed.format(5e-4).to_string(), "+5.0000000000e-04");
/// let windows = signed.exponent_digits(ExponentDigits::Three);
/// assert_eq!(windows.format(5e-4).to_string(), "+5.0000000000e-004");
/// ```
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Exponential {
    precision: usize,
    width: usize,
    plus: bool,
    exponent_digits: ExponentDigits,
}

impl Exponential {
    /// `precision` digits after the point.
    pub const fn new(precision: usize) -> Self {
        Self { precision, width: 0, plus: false, exponent_digits: ExponentDigits::Two }
    }

    /// At least `width` characters, filled with blanks on the left.
    #[must_use]
    pub const fn width(self, width: usize) -> Self {
        Self { width, ..self }
    }

    /// A sign also before positive numbers (flag `+`).
    #[must_use]
    pub const fn plus(self) -> Self {
        Self { plus: true, ..self }
    }

    /// The least number of digits of the exponent.
    #[must_use]
    pub const fn exponent_digits(self, exponent_digits: ExponentDigits) -> Self {
        Self { exponent_digits, ..self }
    }

    /// `value` in this format, to be displayed.
    pub const fn format(self, value: f64) -> Formatted {
        Formatted { format: self, value }
    }
}

/// A value with its format; what `Display` gives is what `printf` prints.
#[derive(Debug, Clone, Copy)]
pub struct Formatted {
    format: Exponential,
    value: f64,
}

impl fmt::Display for Formatted {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Exponential { precision, width, plus, exponent_digits } = self.format;
        let sign = match (self.value.is_sign_negative(), plus) {
            (true, _) => "-",
            (false, true) => "+",
            (false, false) => "",
        };
        let magnitude = self.value.abs();
        if !magnitude.is_finite() {
            let name = if magnitude.is_nan() { "nan" } else { "inf" };
            return write!(f, "{:>width$}", format!("{sign}{name}"));
        }
        // Rust rounds to nearest, ties to even, of the exact binary value, as glibc does; only
        // the exponent looks different.
        let text = format!("{magnitude:.precision$e}");
        let (mantissa, exponent) = text.split_once('e').unwrap_or((&text, "0"));
        let (exponent_sign, exponent) = match exponent.strip_prefix('-') {
            Some(digits) => ('-', digits),
            None => ('+', exponent),
        };
        let digits = match exponent_digits {
            ExponentDigits::Two => 2,
            ExponentDigits::Three => 3,
        };
        let length = sign.len() + mantissa.len() + 2 + exponent.len().max(digits);
        let fill = width.saturating_sub(length);
        write!(f, "{:fill$}{sign}{mantissa}e{exponent_sign}{exponent:0>digits$}", "")
    }
}
