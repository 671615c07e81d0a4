//! Numbers of base 90.

/// The digits 0 to 89.
const ALPHABET: &[u8; 90] = b"0123456789-=qwertyuiop[]^asdfg\
hjkl;zxcvbnm,./~!@#$%&*()_+QWE\
RTYUIOP{}|ASDFGHJKL:ZXCVBNM<>?";

/// What a byte is worth as a digit; 255 for none.
static VALUES: [u8; 256] = {
    let mut values = [u8::MAX; 256];
    let mut digit = 0;
    while digit < ALPHABET.len() {
        values[ALPHABET[digit] as usize] = digit as u8;
        digit += 1;
    }
    values
};

/// The value of one digit, 0 to 89.
pub(super) fn value_of(digit: u8) -> Option<u8> {
    VALUES.get(usize::from(digit)).copied().filter(|&value| value < 90)
}

/// The digit of a value of 0 to 89.
pub(super) fn digit_of(value: u8) -> u8 {
    ALPHABET.get(usize::from(value)).copied().unwrap_or(b'?')
}

/// How many digits a number has: 1 to 9, `ICOUTP` of the deck.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Digits(u8);

impl Digits {
    /// `None` if it is not 1 to 9.
    #[must_use]
    pub fn new(digits: i64) -> Option<Self> {
        u8::try_from(digits).ok().filter(|digits| (1..=9).contains(digits)).map(Self)
    }

    /// How many.
    #[must_use]
    pub fn get(self) -> usize {
        usize::from(self.0)
    }

    /// The largest number, `90^digits - 1`.
    #[must_use]
    pub fn largest(self) -> u64 {
        90_u64.pow(u32::from(self.0)) - 1
    }

    /// The distance of neighbouring reals, in units of their scale: `2 / (90^digits - 1)`.
    #[must_use]
    pub fn quantum(self) -> f64 {
        2.0 / self.largest() as f64
    }

    /// The number for a real that is divided by its scale: what lies outside of -1 to 1 is cut to
    /// that, `nan` becomes -1, the result is truncated.
    ///
    /// With nine digits the largest number is no double, and the original may write one more than
    /// fits; here it is cut. (outputs.md 1.2)
    #[must_use]
    pub fn encode(self, unit: f64) -> u64 {
        let unit = if unit.is_nan() { -1.0 } else { unit.clamp(-1.0, 1.0) };
        let largest = self.largest();
        (((0.5 * (unit + 1.0)) * largest as f64) as u64).min(largest)
    }

    /// The real, -1 to 1, for a number.
    #[must_use]
    pub fn decode(self, number: u64) -> f64 {
        2.0 * number as f64 / self.largest() as f64 - 1.0
    }

    /// Appends a number, the least significant digit first.
    pub(super) fn push(self, number: u64, line: &mut Vec<u8>) {
        let mut rest = number;
        for _ in 0..self.0 {
            line.push(digit_of((rest % 90) as u8));
            rest /= 90;
        }
    }

    /// The number for digits, the least significant first; the first byte that is no digit
    /// otherwise.
    pub(super) fn take(text: &[u8]) -> Result<u64, u8> {
        // Nine digits are less than 2^59.
        text.iter().rev().try_fold(0_u64, |number, &digit| {
            Ok(number.wrapping_mul(90).wrapping_add(u64::from(value_of(digit).ok_or(digit)?)))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_alphabet_has_each_digit_once() {
        for value in 0..90 {
            assert_eq!(value_of(digit_of(value)), Some(value));
        }
        assert_eq!((0..=255).filter(|&byte| value_of(byte).is_some()).count(), 90);
    }

    #[test]
    fn ends_and_middle() {
        let four = Digits::new(4).unwrap();
        assert_eq!(four.largest(), 65_609_999);
        for (unit, number) in [
            (-1.0, 0),
            (f64::NAN, 0),
            (f64::NEG_INFINITY, 0),
            (-3.0, 0),
            (0.0, 32_804_999),
            (-0.0, 32_804_999),
            (1.0, 65_609_999),
            (f64::INFINITY, 65_609_999),
        ] {
            assert_eq!(four.encode(unit), number, "{unit}");
        }
        assert_eq!(four.decode(0), -1.0);
        assert_eq!(four.decode(65_609_999), 1.0);
        assert!((-1.525e-8..-1.524e-8).contains(&four.decode(32_804_999)));
    }

    #[test]
    fn the_largest_number_of_any_width_fits() {
        for digits in (1..=9).filter_map(Digits::new) {
            let largest = digits.largest();
            let number = digits.encode(1.0);
            let mut line = Vec::new();
            digits.push(number, &mut line);
            assert_eq!(line, vec![b'?'; digits.get()], "{number} of {largest}");
            assert_eq!(Digits::take(&line), Ok(largest));
        }
        assert_eq!([0, 10, -1, i64::MAX].map(Digits::new), [None; 4]);
    }
}
