//! A quick look over the command words of a deck without reading its numbers.

use super::lex::is_space;

/// The words that begin with `/YD/` or `$`, outside comments, wherever they stand.
pub(crate) struct DeckWords<'a> {
    rest: &'a [u8],
    in_comment: bool,
}

impl<'a> DeckWords<'a> {
    pub(crate) fn new(bytes: &'a [u8]) -> Self {
        DeckWords { rest: bytes, in_comment: false }
    }
}

impl<'a> Iterator for DeckWords<'a> {
    type Item = &'a [u8];

    fn next(&mut self) -> Option<&'a [u8]> {
        loop {
            let start = self.rest.iter().position(|&b| !is_space(b))?;
            let from = &self.rest[start..];
            let end = from.iter().position(|&b| is_space(b)).unwrap_or(from.len());
            let (word, rest) = from.split_at(end);
            self.rest = rest;
            // Numbers may be glued to what follows them: `5/* c */` opens a comment.
            let glued = word
                .iter()
                .position(|b| !b.is_ascii_digit() && !b"+-.eE".contains(b))
                .unwrap_or(word.len());
            let word = &word[glued..];
            if self.in_comment {
                self.in_comment = !word.starts_with(b"*/");
            } else if word.starts_with(b"/*") {
                self.in_comment = true;
            } else if word.starts_with(b"$YSTOP") {
                return None;
            } else if word.starts_with(b"/YD/") || word.starts_with(b"$") {
                return Some(word);
            }
        }
    }
}
