//! Numbers as C's scanner reads them: it takes the longest piece that can be a number and leaves
//! the rest in the stream.

use super::lex::is_space;

/// Why a number cannot be used although the original's scanner takes it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Refusal {
    /// `nan`, `inf`.
    NotFinite,
    /// `0x1.8p3`: glibc reads it, the Windows run-time library does not.
    Hexadecimal,
    /// Too large for 64 bits (integer) or for a double (real).
    OutOfRange,
}

/// Result of one scan.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Scan<T> {
    /// A number.
    Value(T),
    /// Nothing here begins a number.
    Failed,
    /// A number that cannot be used.
    Refused(Refusal),
}

/// Result of one scan and what it consumed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Scanned<T> {
    pub scan: Scan<T>,
    /// First byte after white space.
    pub start: usize,
    /// First byte left in the stream. A failed scan consumes a lone sign or point, so this may lie
    /// behind `start`.
    pub end: usize,
    /// `1e`, `1e+`: the value is right, the exponent was started and not finished.
    pub incomplete_exponent: bool,
}

impl<T> Scanned<T> {
    fn new(scan: Scan<T>, start: usize, end: usize) -> Self {
        Scanned { scan, start, end, incomplete_exponent: false }
    }
}

/// Numbers that decks hold.
pub(super) trait Number: Copy {
    /// Scans one number from `at`.
    fn scan(bytes: &[u8], at: usize) -> Scanned<Self>;

    /// The value of a whole word that is refused as [`Refusal::NotFinite`], for the few keywords
    /// that may hold such values.
    fn not_finite(word: &[u8]) -> Option<Self>;
}

impl Number for i64 {
    fn scan(bytes: &[u8], at: usize) -> Scanned<i64> {
        let start = skip(bytes, at, is_space);
        let digits = start + usize::from(is_sign(bytes.get(start)));
        let end = skip(bytes, digits, |b| b.is_ascii_digit());
        if end == digits {
            return Scanned::new(Scan::Failed, start, digits);
        }
        let negative = bytes[start] == b'-';
        let grown = bytes[digits..end].iter().try_fold(0i64, |sum, digit| {
            let digit = i64::from(digit - b'0');
            sum.checked_mul(10)?.checked_add(if negative { -digit } else { digit })
        });
        Scanned::new(grown.map_or(Scan::Refused(Refusal::OutOfRange), Scan::Value), start, end)
    }

    fn not_finite(_: &[u8]) -> Option<i64> {
        None
    }
}

impl Number for f64 {
    fn scan(bytes: &[u8], at: usize) -> Scanned<f64> {
        let start = skip(bytes, at, is_space);
        let unsigned = start + usize::from(is_sign(bytes.get(start)));
        if let Some(refused) = special_word(bytes, start, unsigned) {
            return refused;
        }
        let point = skip(bytes, unsigned, |b| b.is_ascii_digit());
        let has_point = bytes.get(point) == Some(&b'.');
        let fraction = point + usize::from(has_point);
        let mantissa_end =
            if has_point { skip(bytes, fraction, |b| b.is_ascii_digit()) } else { point };
        if mantissa_end - unsigned == usize::from(has_point) {
            return Scanned::new(Scan::Failed, start, mantissa_end);
        }
        let mut number_end = mantissa_end;
        let mut end = mantissa_end;
        if matches!(bytes.get(end), Some(b'e' | b'E')) {
            let digits = end + 1 + usize::from(is_sign(bytes.get(end + 1)));
            end = skip(bytes, digits, |b| b.is_ascii_digit());
            if end > digits {
                number_end = end;
            }
        }
        let parsed = std::str::from_utf8(&bytes[start..number_end])
            .ok()
            .and_then(|text| text.parse::<f64>().ok());
        let scan = match parsed {
            Some(value) if value.is_finite() => Scan::Value(value),
            Some(_) => Scan::Refused(Refusal::OutOfRange),
            None => Scan::Failed,
        };
        Scanned { scan, start, end, incomplete_exponent: end > number_end }
    }

    fn not_finite(word: &[u8]) -> Option<f64> {
        let (sign, unsigned) = match word {
            [b'-', rest @ ..] => (-1.0, rest),
            [b'+', rest @ ..] => (1.0, rest),
            _ => (1.0, word),
        };
        let magnitude = match unsigned.to_ascii_lowercase().as_slice() {
            b"nan" | b"nan(ind)" | b"nan(snan)" => f64::NAN,
            b"inf" | b"infinity" => f64::INFINITY,
            _ => return None,
        };
        Some(magnitude.copysign(sign))
    }
}

/// `nan`, `inf` and hexadecimal numbers, and the beginnings of such words, which a failed scan
/// swallows.
fn special_word(bytes: &[u8], start: usize, unsigned: usize) -> Option<Scanned<f64>> {
    let rest = bytes.get(unsigned..)?;
    let word: &[u8] = match rest.first()? {
        b'n' | b'N' => b"nan",
        b'i' | b'I' => b"inf",
        b'0' if matches!(rest.get(1), Some(b'x' | b'X')) => {
            let end = skip(bytes, unsigned, |b| !is_space(b));
            return Some(Scanned::new(Scan::Refused(Refusal::Hexadecimal), start, end));
        }
        _ => return None,
    };
    let common = rest.iter().zip(word).take_while(|(a, b)| a.eq_ignore_ascii_case(b)).count();
    if common == word.len() {
        let end = skip(bytes, unsigned, |b| !is_space(b));
        return Some(Scanned::new(Scan::Refused(Refusal::NotFinite), start, end));
    }
    Some(Scanned::new(Scan::Failed, start, unsigned + common))
}

fn is_sign(byte: Option<&u8>) -> bool {
    matches!(byte, Some(b'+' | b'-'))
}

fn skip(bytes: &[u8], at: usize, wanted: impl Fn(u8) -> bool) -> usize {
    let rest = bytes.get(at..).unwrap_or_default();
    at + rest.iter().position(|&b| !wanted(b)).unwrap_or(rest.len())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn integer(text: &str) -> (Option<i64>, &str) {
        let scanned = i64::scan(text.as_bytes(), 0);
        (
            if let Scan::Value(value) = scanned.scan { Some(value) } else { None },
            &text[scanned.end..],
        )
    }

    fn real(text: &str) -> (Option<f64>, &str) {
        let scanned = f64::scan(text.as_bytes(), 0);
        (
            if let Scan::Value(value) = scanned.scan { Some(value) } else { None },
            &text[scanned.end..],
        )
    }

    #[test]
    fn integers() {
        let table = [
            ("+7", Some(7), ""),
            ("010", Some(10), ""),
            ("0x10", Some(0), "x10"),
            ("2e+004", Some(2), "e+004"),
            ("20000.0", Some(20000), ".0"),
            ("5/*", Some(5), "/*"),
            ("+-5", None, "-5"),
            (".5", None, ".5"),
            ("-9223372036854775808", Some(i64::MIN), ""),
            ("9223372036854775808", None, ""),
            ("", None, ""),
        ];
        for (text, value, rest) in table {
            assert_eq!(integer(text), (value, rest), "{text}");
        }
    }

    #[test]
    fn undefined_reals_keep_their_sign() {
        for (word, nan, negative) in [
            ("nan", true, false),
            ("-nan", true, true),
            ("+NaN", true, false),
            ("-nan(ind)", true, true),
            ("-inf", false, true),
            ("Infinity", false, false),
        ] {
            let value = f64::not_finite(word.as_bytes()).unwrap();
            assert_eq!((value.is_nan(), value.is_sign_negative()), (nan, negative), "{word}");
            assert!(!value.is_finite());
        }
        assert_eq!(f64::not_finite(b"nano"), None);
        assert_eq!(i64::not_finite(b"nan"), None);
    }

    #[test]
    fn reals() {
        let table = [
            ("5.", Some(5.0), ""),
            (".5", Some(0.5), ""),
            ("+2e+002", Some(200.0), ""),
            ("1e-007", Some(1e-7), ""),
            ("1.0D3", Some(1.0), "D3"),
            ("1,5", Some(1.0), ",5"),
            ("1_0", Some(1.0), "_0"),
            ("1.5.5", Some(1.5), ".5"),
            ("1f", Some(1.0), "f"),
            ("1e", Some(1.0), ""),
            ("1e+", Some(1.0), ""),
            ("1.e", Some(1.0), ""),
            ("100ergs", Some(100.0), "rgs"),
            ("1e-400", Some(0.0), ""),
            ("1e400", None, ""),
            ("+-5", None, "-5"),
            (".", None, ""),
            ("-.x", None, "x"),
            ("nan", None, ""),
            ("-inf", None, ""),
            ("no", None, "o"),
            ("0x1.8p3", None, ""),
        ];
        for (text, value, rest) in table {
            assert_eq!(real(text), (value, rest), "{text}");
        }
    }
}
