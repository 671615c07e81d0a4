//! Words of the top level.

use std::ops::Range;

use nom::branch::alt;
use nom::bytes::complete::{tag, take_till1, take_while};
use nom::combinator::value;
use nom::{IResult, Parser};

/// Longest word that the original's buffer holds.
pub(super) const LONGEST_WORD: usize = 299;

/// White space of C's scanner.
pub(crate) fn is_space(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t'..=b'\r')
}

/// A word of the stream.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Word {
    pub range: Range<usize>,
    /// Whether white space follows: the original tests for the end of the file after reading a word
    /// and before using it, so a last word without white space is lost.
    pub terminated: bool,
}

/// The next word from `at`, white space skipped; `None` at the end of the file.
pub(super) fn next_word(bytes: &[u8], at: usize) -> Option<Word> {
    let input = bytes.get(at..)?;
    let (input, _) = white_space(input).ok()?;
    let start = bytes.len() - input.len();
    let (rest, word) = word(input).ok()?;
    Some(Word { range: start..start + word.len(), terminated: !rest.is_empty() })
}

fn white_space(input: &[u8]) -> IResult<&[u8], &[u8]> {
    take_while(is_space).parse(input)
}

fn word(input: &[u8]) -> IResult<&[u8], &[u8]> {
    take_till1(is_space).parse(input)
}

/// What a word of the top level asks for. The original compares prefixes in this order.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum WordKind {
    Include,
    Stop,
    Run,
    Comment,
    Data,
    Unknown,
}

/// Classifies a word of the top level by its first characters.
pub(super) fn classify(word: &[u8], has_include: bool) -> WordKind {
    let kind: IResult<&[u8], WordKind> = alt((
        value(WordKind::Include, tag("$YINCL")),
        value(WordKind::Stop, tag("$YSTOP")),
        value(WordKind::Run, tag("$YDOIT")),
        value(WordKind::Comment, tag("/*")),
        value(WordKind::Data, tag("/YD/")),
    ))
    .parse(word);
    match kind {
        Ok((_, WordKind::Include)) if !has_include => WordKind::Unknown,
        Ok((_, kind)) => kind,
        Err(_) => WordKind::Unknown,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_end_at_any_white_space_and_know_whether_it_follows() {
        let bytes = b" \r\na\x0bb";
        assert_eq!(next_word(bytes, 0), Some(Word { range: 3..4, terminated: true }));
        assert_eq!(next_word(bytes, 4), Some(Word { range: 5..6, terminated: false }));
        assert_eq!(next_word(bytes, 6), None);
    }

    #[test]
    fn prefixes_decide() {
        assert_eq!(classify(b"$YDOITNOW", true), WordKind::Run);
        assert_eq!(classify(b"/**/", true), WordKind::Comment);
        assert_eq!(classify(b"$YINCL", false), WordKind::Unknown);
        assert_eq!(classify(b"/yd/ydc/mcstep", true), WordKind::Unknown);
    }
}
