//! Scans numbers as C programs print them, whatever stands between them.

/// Takes one number from the front of `text`, blanks before it skipped.
///
/// Besides decimal numbers this takes `nan` and `inf` in the spellings of C libraries, older
/// Windows ones included (`1.#QNAN00e+000`, `-1.#IND`, `-nan(ind)`). A number ends where the
/// next character cannot continue it, so that `+1.0e+00-2.0e+00` is two numbers.
pub(super) fn take(text: &[u8]) -> Option<(f64, &[u8])> {
    let text = text.trim_ascii_start();
    let (negative, unsigned) = match text {
        [b'-', rest @ ..] => (true, rest),
        [b'+', rest @ ..] => (false, rest),
        _ => (false, text),
    };
    let (magnitude, rest) = special(unsigned).or_else(|| decimal(unsigned))?;
    Some((if negative { -magnitude } else { magnitude }, rest))
}

fn special(text: &[u8]) -> Option<(f64, &[u8])> {
    const NAMES: [(&[u8], f64); 7] = [
        (b"infinity", f64::INFINITY),
        (b"inf", f64::INFINITY),
        (b"nan", f64::NAN),
        (b"1.#INF", f64::INFINITY),
        (b"1.#QNAN", f64::NAN),
        (b"1.#SNAN", f64::NAN),
        (b"1.#IND", f64::NAN),
    ];
    let (name, value) = NAMES.into_iter().find(|(name, _)| {
        text.get(..name.len()).is_some_and(|head| head.eq_ignore_ascii_case(name))
    })?;
    let rest = text.get(name.len()..)?;
    if name.contains(&b'#') {
        // The rest of the printed width: digits and an exponent.
        let (_, rest) = digits(rest);
        return Some((value, exponent(rest)));
    }
    if let Some(inside) = rest.strip_prefix(b"(") {
        let end = inside.iter().position(|&b| b == b')')?;
        return Some((value, inside.get(end + 1..)?));
    }
    Some((value, rest))
}

fn decimal(text: &[u8]) -> Option<(f64, &[u8])> {
    let (whole, rest) = digits(text);
    let (fraction, rest) = match rest.strip_prefix(b".") {
        Some(rest) => digits(rest),
        None => (&[][..], rest),
    };
    if whole.is_empty() && fraction.is_empty() {
        return None;
    }
    let rest = exponent(rest);
    let number = text.get(..text.len() - rest.len())?;
    let value = std::str::from_utf8(number).ok()?.parse().ok()?;
    Some((value, rest))
}

/// What follows the exponent at the front of `text`; all of `text` when there is none.
fn exponent(text: &[u8]) -> &[u8] {
    let [b'e' | b'E', rest @ ..] = text else {
        return text;
    };
    let unsigned = match rest {
        [b'+' | b'-', rest @ ..] => rest,
        _ => rest,
    };
    match digits(unsigned) {
        ([], _) => text,
        (_, rest) => rest,
    }
}

fn digits(text: &[u8]) -> (&[u8], &[u8]) {
    let end = text.iter().position(|b| !b.is_ascii_digit()).unwrap_or(text.len());
    text.split_at(end)
}
