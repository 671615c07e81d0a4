//! Words of a `.msh` text with their lines. Counts of the file never allocate anything: what is
//! read grows with the bytes that are there.

use nom::IResult;
use nom::bytes::complete::{take_till1, take_while};

use super::error::GmshError;

/// A place in the text.
#[derive(Debug, Clone)]
pub(super) struct Scanner<'a> {
    rest: &'a [u8],
    line: usize,
}

fn white(byte: u8) -> bool {
    byte.is_ascii_whitespace()
}

fn blank(input: &[u8]) -> IResult<&[u8], &[u8]> {
    take_while(white)(input)
}

fn token(input: &[u8]) -> IResult<&[u8], &[u8]> {
    take_till1(white)(input)
}

impl<'a> Scanner<'a> {
    pub(super) fn new(text: &'a [u8]) -> Self {
        Self { rest: text, line: 1 }
    }

    /// Line of the next word.
    pub(super) fn line(&mut self) -> usize {
        self.skip_blank();
        self.line
    }

    fn skip_blank(&mut self) {
        if let Ok((rest, skipped)) = blank(self.rest) {
            self.line += skipped.iter().filter(|&&byte| byte == b'\n').count();
            self.rest = rest;
        }
    }

    /// The next word, if there is one.
    pub(super) fn word(&mut self) -> Option<&'a [u8]> {
        self.skip_blank();
        let (rest, word) = token(self.rest).ok()?;
        self.rest = rest;
        Some(word)
    }

    /// The rest of the line, without its end.
    pub(super) fn rest_of_line(&mut self) -> &'a [u8] {
        let end = self.rest.iter().position(|&b| b == b'\n').unwrap_or(self.rest.len());
        let (line, rest) = self.rest.split_at(end);
        self.rest = rest;
        line
    }

    /// The error that the next word, not `expected`, is.
    pub(super) fn unexpected(&mut self, expected: &'static str) -> GmshError {
        let line = self.line();
        let found = match self.clone().word() {
            None => "the end of the file".to_owned(),
            Some(word) => {
                let text = String::from_utf8_lossy(word);
                let short: String = text.chars().take(40).collect();
                format!("`{}`", short.escape_debug())
            }
        };
        GmshError::Unexpected { line, found, expected }
    }

    fn value<T: std::str::FromStr>(
        &mut self,
        expected: &'static str,
        fits: impl Fn(&T) -> bool,
    ) -> Result<T, GmshError> {
        let mut ahead = self.clone();
        let value = ahead
            .word()
            .and_then(|word| std::str::from_utf8(word).ok())
            .and_then(|word| word.parse::<T>().ok())
            .filter(fits);
        match value {
            Some(value) => {
                *self = ahead;
                Ok(value)
            }
            None => Err(self.unexpected(expected)),
        }
    }

    /// An integer.
    pub(super) fn integer(&mut self, expected: &'static str) -> Result<i64, GmshError> {
        self.value(expected, |_| true)
    }

    /// A count: an integer that is not negative.
    pub(super) fn count(&mut self, expected: &'static str) -> Result<i64, GmshError> {
        self.value(expected, |&count| count >= 0)
    }

    /// A finite real.
    pub(super) fn real(&mut self, expected: &'static str) -> Result<f64, GmshError> {
        self.value(expected, |real: &f64| real.is_finite())
    }

    /// Takes exactly this word.
    pub(super) fn take(&mut self, wanted: &'static str) -> Result<(), GmshError> {
        let mut ahead = self.clone();
        if ahead.word() == Some(wanted.as_bytes()) {
            *self = ahead;
            Ok(())
        } else {
            Err(self.unexpected(wanted))
        }
    }
}
