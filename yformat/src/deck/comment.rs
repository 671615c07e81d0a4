//! Comments, which end at a *word* that begins with `*/` and hold at most a hundred words.

use super::lex::{LONGEST_WORD, next_word};
use crate::diagnostic::Diagnostic;
use crate::source::{SourceId, Span};

/// Most words behind the opening one, the closing one included.
const MOST_WORDS: usize = 100;

/// Reads a comment whose opening word is `open`; returns the first byte behind it.
pub(super) fn read(
    source: SourceId,
    bytes: &[u8],
    open: Span,
    warnings: &mut Vec<Diagnostic>,
) -> Result<usize, Diagnostic> {
    let closes_itself =
        bytes.get(open.range()).is_some_and(|word| word.len() >= 4 && word.ends_with(b"*/"));
    let mut suspicious = closes_itself.then_some(open);
    let mut swallowed = 0usize;
    let mut at = open.end;
    for _ in 0..MOST_WORDS {
        let Some(word) = next_word(bytes, at) else {
            warnings.push(unclosed(open, suspicious));
            return Ok(at);
        };
        at = word.range.end;
        let text = &bytes[word.range.clone()];
        let span = Span::new(source, word.range);
        if text.len() > LONGEST_WORD {
            return Err(too_long_word(span));
        }
        if text.starts_with(b"*/") {
            warnings.extend(
                suspicious.filter(|_| swallowed > 0).map(|near| swallowing(near, swallowed)),
            );
            return Ok(at);
        }
        swallowed += usize::from(text.starts_with(b"/YD/") || text.starts_with(b"$Y"));
        if text.ends_with(b"*/") {
            suspicious.get_or_insert(span);
        }
    }
    let Some(word) = next_word(bytes, at) else {
        warnings.push(unclosed(open, suspicious));
        return Ok(at);
    };
    let near = String::from_utf8_lossy(&bytes[word.range]).into_owned();
    let message = format!(
        "this comment is too long: it has not ended at `{near}`, its word number {}",
        MOST_WORDS + 1
    );
    let help = match suspicious {
        Some(_) => "a comment ends at a word that begins with `*/`: put a blank before `*/`",
        None => "split it into several comments",
    };
    let error = Diagnostic::error("deck::comment-too-long", message).at(suspicious.unwrap_or(open));
    Err(error.expected("`*/` after at most 99 words").help(help))
}

/// A word that the original's buffer cannot hold.
pub(super) fn too_long_word(span: Span) -> Diagnostic {
    let message = format!(
        "this word has {} characters, more than the {LONGEST_WORD} that a word may have",
        span.range().len()
    );
    Diagnostic::error("deck::word-too-long", message)
        .at(Span { end: span.start + 20, ..span })
        .label("begins here")
}

fn unclosed(open: Span, suspicious: Option<Span>) -> Diagnostic {
    let warning = Diagnostic::warning(
        "deck::unclosed-comment",
        "this comment is not closed: the rest of the file is not read",
    );
    match suspicious {
        Some(near) => warning.at(near).label("does not close it").help("put a blank before `*/`"),
        None => warning.at(open).label("opened here").help("close it with `*/`, a blank before it"),
    }
}

fn swallowing(near: Span, swallowed: usize) -> Diagnostic {
    let plural = if swallowed == 1 { "a keyword" } else { "keywords" };
    let message = format!("the comment does not end here and swallows {plural}");
    Diagnostic::warning("deck::swallowed-keywords", message)
        .at(near)
        .label("`*/` closes a comment only at the beginning of a word")
        .help("put a blank before `*/`")
}
