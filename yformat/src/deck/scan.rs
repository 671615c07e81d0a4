//! Reads what follows a keyword: a scalar, or a header and its numbers.

use super::array::{Array, Header};
use super::number::{Number, Refusal, Scan};
use crate::diagnostic::Diagnostic;
use crate::dialect::Dialect;
use crate::keywords::Keyword;
use crate::source::{SourceId, Span};

/// What a scan for a number met.
pub(super) enum Found<T> {
    Value(T),
    /// Nothing that begins a number; the stream stays where it was.
    Nothing,
    /// A lone sign or point, which the scanner swallows and fails.
    Swallowed,
}

/// A place in a file while the values of one keyword are read.
pub(super) struct Cursor<'a> {
    pub bytes: &'a [u8],
    pub source: SourceId,
    pub at: usize,
    pub keyword: &'static Keyword,
    pub dialect: Dialect,
    pub warnings: Vec<Diagnostic>,
    /// The first `nan` or infinite value that was taken, and how many there are.
    pub undefined: Option<(Span, usize)>,
}

impl Cursor<'_> {
    pub(super) fn span(&self, range: std::ops::Range<usize>) -> Span {
        Span::new(self.source, range)
    }

    /// The next number. Numbers that no sane program can use end the reading.
    pub(super) fn number<T: Number>(&mut self) -> Result<Found<T>, Diagnostic> {
        let scanned = T::scan(self.bytes, self.at);
        let span = self.span(scanned.start..scanned.end);
        match scanned.scan {
            Scan::Value(value) => {
                self.at = scanned.end;
                if scanned.incomplete_exponent {
                    self.warnings.push(
                        Diagnostic::warning(
                            "deck::incomplete-exponent",
                            "the exponent of this number is not finished",
                        )
                        .at(span)
                        .label("the `e` is dropped")
                        .help("write the exponent's digits or leave the `e` out"),
                    );
                }
                Ok(Found::Value(value))
            }
            Scan::Failed if scanned.end > scanned.start => {
                self.at = scanned.end;
                self.warnings.push(
                    Diagnostic::warning(
                        "deck::lone-sign",
                        format!("no number follows this in {}", self.keyword.path()),
                    )
                    .at(span)
                    .label("dropped")
                    .help("write the number without space after its sign"),
                );
                Ok(Found::Swallowed)
            }
            Scan::Failed => Ok(Found::Nothing),
            Scan::Refused(Refusal::NotFinite) if self.keyword.may_be_undefined => {
                let word = self.bytes.get(span.range()).unwrap_or_default();
                let Some(value) = T::not_finite(word) else {
                    return Err(self.refuse(Refusal::NotFinite, span));
                };
                self.at = scanned.end;
                let (first, count) = self.undefined.unwrap_or((span, 0));
                self.undefined = Some((first, count + 1));
                Ok(Found::Value(value))
            }
            Scan::Refused(refusal) => Err(self.refuse(refusal, span)),
        }
    }

    fn refuse(&self, refusal: Refusal, span: Span) -> Diagnostic {
        let name = self.keyword.path();
        match refusal {
            Refusal::NotFinite => Diagnostic::error(
                "deck::not-a-number",
                format!("{name} is given no finite number"),
            )
            .label("not a finite number")
            .help(
                "write the number that is meant; a computation that made this deck may have failed",
            ),
            Refusal::Hexadecimal => Diagnostic::error(
                "deck::not-a-number",
                format!("{name} is given a hexadecimal number"),
            )
            .label("hexadecimal: only some of the original programs can read it")
            .help("write it as a decimal number"),
            Refusal::OutOfRange => Diagnostic::error(
                "deck::number-out-of-range",
                format!("{name} is given a number that is too large"),
            )
            .label("cannot be stored")
            .help("integers go up to 9.2e18, reals up to 1.7e308"),
        }
        .at(span)
        .expected("a decimal number")
    }

    /// The header of an array of the keyword's rank.
    pub(super) fn header(&mut self) -> Result<Header, Diagnostic> {
        if self.keyword.rank() == 1 {
            return Ok(Header::rank1(self.count("the number of values")?));
        }
        let order = self.count("the order code")?;
        let n1 = self.count("the first length")?;
        let n2 = self.count("the second length")?;
        if self.keyword.rank() == 2 {
            return Ok(Header::rank2(order, n1, n2));
        }
        let n3 = match self.number::<i64>()? {
            Found::Value(n3) => n3,
            // With an order that is no permutation nothing is read, whatever the lengths are.
            _ if self.keyword.short_header || Header::rank3(order, [1; 3]).loops().is_none() => 0,
            _ => self.unreadable("the third length")?,
        };
        Ok(Header::rank3(order, [n1, n2, n3]))
    }

    fn count(&mut self, what: &str) -> Result<i64, Diagnostic> {
        match self.number::<i64>()? {
            Found::Value(_) if self.bytes.get(self.at) == Some(&b'.') => {
                let rest = self.next_word_span();
                Err(super::unknown::glued(&self.keyword.path(), true, self.bytes, rest))
            }
            Found::Value(count) => Ok(count),
            Found::Nothing | Found::Swallowed => self.unreadable(what),
        }
    }

    fn unreadable(&mut self, what: &str) -> Result<i64, Diagnostic> {
        let span = self.next_word_span();
        let message = format!("{what} of {} cannot be read", self.keyword.path());
        let expected = match self.keyword.rank() {
            1 => "the number of values, then the values",
            2 => "an order code (21 or 12) and two lengths, then the values",
            _ => "an order code (such as 231) and three lengths, then the values",
        };
        // Y-Geo takes 0 then; the other programs take whatever their memory holds.
        if self.dialect == Dialect::YGeo {
            let warning = Diagnostic::warning("deck::unreadable-count", message + "; 0 is taken");
            self.warnings.push(warning.at(span).label("no integer").expected(expected));
            return Ok(0);
        }
        Err(Diagnostic::error("deck::unreadable-count", message)
            .at(span)
            .label("no integer")
            .expected(expected))
    }

    /// The numbers that a header announces, as far as they are there.
    pub(super) fn array<T: Number>(&mut self, header: Header) -> Result<Array<T>, Diagnostic> {
        let expected = header.expected();
        // A count is only believed as far as the file can hold it: one digit and one blank per
        // number.
        let possible = (self.bytes.len().saturating_sub(self.at) / 2 + 1) as u64;
        let mut numbers: Vec<T> =
            Vec::with_capacity(usize::try_from(expected.min(possible)).unwrap_or(0));
        while (numbers.len() as u64) < expected {
            match (self.number()?, numbers.last().copied()) {
                (Found::Value(number), _) => numbers.push(number),
                (Found::Swallowed, Some(last)) => numbers.push(last),
                _ => break,
            }
        }
        numbers.shrink_to_fit();
        Ok(Array::new(header, numbers))
    }

    /// The word that comes next, or the empty place at the end of the file.
    pub(super) fn next_word_span(&self) -> Span {
        let range =
            super::lex::next_word(self.bytes, self.at).map_or(self.at..self.at, |word| word.range);
        self.span(range)
    }
}
