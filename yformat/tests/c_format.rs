//! The `%e` formatting against an oracle that rounds the exact decimal expansion by hand.

use proptest::prelude::*;
use yformat::c_format::{ExponentDigits, Exponential};

/// `%.{precision}e` of a finite value: all digits of the value exactly, cut, rounded to
/// nearest with ties to even.
fn oracle(value: f64, precision: usize) -> String {
    // A double has at most 1074 digits behind the point; Rust prints them all.
    let exact = format!("{:.1074}", value.abs());
    let (whole, fraction) = exact.split_once('.').unwrap();
    let all: Vec<u8> = whole.bytes().chain(fraction.bytes()).map(|b| b - b'0').collect();
    let (first, mut exponent) = match all.iter().position(|&d| d != 0) {
        Some(first) => (first, whole.len() as i32 - 1 - first as i32),
        None => (0, 0),
    };
    let digit = |i: usize| all.get(first + i).copied().unwrap_or(0);
    let mut kept: Vec<u8> = (0..=precision).map(digit).collect();
    let rest: Vec<u8> = all.iter().skip(first + precision + 1).copied().collect();
    let half = rest.first().is_some_and(|&d| d == 5) && rest[1..].iter().all(|&d| d == 0);
    let up = if half { kept[precision] % 2 == 1 } else { rest.first().is_some_and(|&d| d >= 5) };
    if up {
        let mut place = precision as isize;
        while place >= 0 && kept[place as usize] == 9 {
            kept[place as usize] = 0;
            place -= 1;
        }
        if place >= 0 {
            kept[place as usize] += 1;
        } else {
            kept.insert(0, 1);
            kept.pop();
            exponent += 1;
        }
    }
    let text: String = kept.iter().map(|&d| char::from(b'0' + d)).collect();
    let minus = if value.is_sign_negative() { "-" } else { "" };
    let sign = if exponent < 0 { '-' } else { '+' };
    let (head, tail) = text.split_at(1);
    let point = if tail.is_empty() { "" } else { "." };
    format!("{minus}{head}{point}{tail}e{sign}{:02}", exponent.abs())
}

fn finite() -> impl Strategy<Value = f64> {
    prop_oneof![
        prop::num::f64::NORMAL | prop::num::f64::SUBNORMAL | prop::num::f64::ZERO,
        // Values with short binary fractions: many exact ties.
        (-4000..4000_i32).prop_map(|n| f64::from(n) / 64.0),
    ]
}

proptest! {
    #[test]
    fn agrees_with_the_oracle(value in finite(), precision in 0..20_usize) {
        let ours = Exponential::new(precision).format(value).to_string();
        prop_assert_eq!(ours, oracle(value, precision));
    }

    #[test]
    fn width_sign_and_exponent_only_pad(value in finite(), precision in 0..12_usize, width in 0..40_usize) {
        let plain = oracle(value, precision);
        let format = Exponential::new(precision).width(width);
        prop_assert_eq!(format.format(value).to_string(), format!("{plain:>width$}"));
        let signed = format.plus().format(value).to_string();
        let expected = if value.is_sign_negative() { plain.clone() } else { format!("+{plain}") };
        prop_assert_eq!(signed, format!("{expected:>width$}"));
        let windows = Exponential::new(precision).exponent_digits(ExponentDigits::Three);
        let (mantissa, exponent) = plain.split_once('e').unwrap();
        let (sign, digits) = exponent.split_at(1);
        prop_assert_eq!(windows.format(value).to_string(), format!("{mantissa}e{sign}{digits:0>3}"));
    }
}

#[test]
fn known_texts() {
    let y = Exponential::new(10).width(17).plus();
    for (value, text) in [
        (0.0, "+0.0000000000e+00"),
        (-0.0, "-0.0000000000e+00"),
        (1e-300, "+1.0000000000e-300"),
        (f64::MAX, "+1.7976931349e+308"),
        (f64::NAN, "             +nan"),
        (f64::NEG_INFINITY, "             -inf"),
    ] {
        assert_eq!(y.format(value).to_string(), text);
    }
    assert_eq!(Exponential::new(0).format(2.5).to_string(), "2e+00");
    assert_eq!(Exponential::new(0).format(3.5).to_string(), "4e+00");
}
