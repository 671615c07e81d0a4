//! Files that are no decks, decks of other programs, and includes that go wrong: one error each.

mod support;

use insta::assert_snapshot;
use support::spoilt_deck::{self, edited, verdict, verdict_of};
use tempfile::TempDir;
use yformat::diagnostic::Severity;

/// What is said about one deck file: one error.
fn one_error(mistake: &str, bytes: &[u8]) -> String {
    let found = verdict(bytes);
    assert_eq!(found.severities, [Severity::Error], "{mistake}:\n{}", found.text);
    assert_eq!(found.placed, [true], "{mistake}:\n{}", found.text);
    format!("== {mistake}\n{}\n", found.text)
}

#[test]
fn files_that_are_no_decks() {
    let d3plot: Vec<u8> = (0..400u32).flat_map(|word| (word * 7919).to_le_bytes()).collect();
    let utf16: Vec<u8> = [0xFF, 0xFE]
        .into_iter()
        .chain(spoilt_deck::base().bytes().flat_map(|byte| [byte, 0]))
        .collect();
    let marked = [b"\xEF\xBB\xBF".as_slice(), b"/YD/YDC/MCSTEP 20\n$YDOIT\n"].concat();
    let said = [
        one_error("empty file", b""),
        one_error("blank file", b"\n\n  \n"),
        one_error("binary file", &d3plot),
        one_error("UTF-16", &utf16),
        one_error("byte order mark", &marked),
        one_error("another language", b"*NODE\n 1, 0.0, 0.0\n*END\n"),
    ];
    assert_snapshot!(said.concat());
}

#[test]
fn files_that_cannot_be_included() {
    let in_folder = |deck: &str, others: &[(&str, &str)]| {
        let folder = TempDir::new().expect("a temporary folder");
        for (name, text) in others {
            spoilt_deck::write(folder.path(), name, text.as_bytes());
        }
        let found = verdict_of(&spoilt_deck::write(folder.path(), "deck.y", deck.as_bytes()));
        assert_eq!(found.severities, [Severity::Error], "{}", found.text);
        assert_eq!(found.placed, [true], "{}", found.text);
        found.text
    };
    let including = edited(&[("/YD/YDC/DCGRAY", "$YINCL steel.y\n/YD/YDC/DCGRAY")]);
    let said = [
        format!("== missing file\n{}", in_folder(&including, &[])),
        format!(
            "== mistake inside\n{}",
            in_folder(&including, &[("steel.y", "/YD/YDPE/MPORP 1\n")])
        ),
        format!(
            "== file that includes itself\n{}",
            in_folder(&including, &[("steel.y", "$YINCL steel.y\n")])
        ),
        format!("== no name\n{}", in_folder("/YD/YDC/MCSTEP 3\n$YINCL\n", &[])),
    ];
    assert_snapshot!(said.join("\n"));
}

#[test]
fn a_deck_that_is_not_there() {
    let found = verdict_of(std::path::Path::new("no/such/deck.y"));
    assert!(found.text.starts_with("error: cannot read deck.y: "), "{}", found.text);
    assert!(!found.runs);
}
