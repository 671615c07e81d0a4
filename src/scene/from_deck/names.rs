//! Where the dialects keep the same thing under different keywords.
//!
//! Readers ask by the names of the split dialect and Y-Geo, which have a
//! database for each kind of property set; the classic dialect has one table
//! for all (spec `deck.md` 8.2).

use std::borrow::Cow;
use yformat::{dialect::Dialect, keywords};

/// Keywords of classic that have another name than in the split dialect.
const IN_CLASSIC: &[(&str, &str)] = &[
    ("YDPE/D1PEPE", "YDP/D1PEPC"),
    ("YDPE/D1PEPT", ""),
    ("YDPN/NPNSET", "YDP/NPROP"),
    ("YDPN/MPNSET", "YDP/MPROP"),
    ("YDPJ/NPJSET", "YDP/NPROP"),
    ("YDPJ/MPJSET", "YDP/MPROP"),
    ("YDPJ/D1PJFT", "YDP/D1PEFT"),
    ("YDPJ/D1PJFS", "YDP/D1PCOH"),
    ("YDPJ/D1PJGF", "YDP/D1PEGT"),
    ("YDPJ/D1PJGS", "YDP/D1PEGS"),
    ("YDPJ/D1PJCO", "YDP/D1PCOH"),
    ("YDPJ/D1PJFR", "YDP/D1PICF"),
    ("YDPJ/D1PJPE", "YDP/D1PEPE"),
];

/// What a keyword is called in a dialect; `None` if it has no such thing.
pub(super) fn in_dialect<'n>(dialect: Dialect, name: &'n str) -> Option<Cow<'n, str>> {
    let own: Cow<'_, str> = if dialect == Dialect::Classic {
        match IN_CLASSIC.iter().find(|(split, _)| *split == name) {
            Some((_, classic)) => Cow::Borrowed(*classic),
            None => match name.split_once('/') {
                Some(("YDPE" | "YDPN" | "YDPJ", keyword)) => Cow::Owned(format!("YDP/{keyword}")),
                _ => Cow::Borrowed(name),
            },
        }
    } else {
        Cow::Borrowed(name)
    };
    keywords::find(dialect, &own).is_some().then_some(own)
}

/// A text with the keywords in it as a dialect calls them.
pub(super) fn translated(dialect: Dialect, text: &str) -> String {
    let mut translated = String::with_capacity(text.len());
    let mut rest = text;
    while let Some(start) = rest.find("YDP") {
        let (before, from) = rest.split_at(start);
        let end = from.find(|c: char| !c.is_ascii_alphanumeric() && c != '/').unwrap_or(from.len());
        let (name, after) = from.split_at(end);
        translated.push_str(before);
        translated.push_str(&in_dialect(dialect, name).unwrap_or(Cow::Borrowed(name)));
        rest = after;
    }
    translated + rest
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_name_the_keywords_of_the_dialect() {
        let text = "give it with /YD/YDPJ/D1PJFT; YDPE/D1PERO is missing";
        assert_eq!(
            translated(Dialect::Classic, text),
            "give it with /YD/YDP/D1PEFT; YDP/D1PERO is missing"
        );
        assert_eq!(translated(Dialect::Split, text), text);
    }
}
