//! Whatever the bytes are, reading ends, in time and memory that the size of the file bounds, and
//! loses nothing.

use proptest::prelude::*;
use yformat::database::Database;
use yformat::deck::DeckReader;
use yformat::dialect::Dialect;

const DECKS: [&[u8]; 4] = [
    include_bytes!("data/probes/p_ydoit2.y"),
    include_bytes!("data/probes/p_incl_ok.y"),
    include_bytes!("data/probes/p_comment150.y"),
    include_bytes!("data/probes/p_nanvel.y"),
];

/// Reads bytes by every dialect and asks everything that can be asked.
fn exercise(bytes: &[u8]) {
    for dialect in [
        None,
        Some(Dialect::Split),
        Some(Dialect::Classic),
        Some(Dialect::YGeo),
        Some(Dialect::Y3d),
    ] {
        let mut reader =
            DeckReader::new().dialect(dialect).includes(|_: &str| Ok(DECKS[0].to_vec()));
        let outcome = reader.parse("deck.y", bytes);
        assert_eq!(outcome.deck.to_bytes(), bytes);
        for found in &outcome.diagnostics {
            assert!(!found.render(outcome.deck.sources()).is_empty());
        }
        assert!(outcome.diagnostics.len() <= 105);
        let _ = outcome.deck.echo_lines();
        let mut database = Database::new(outcome.deck.dialect());
        for item in 0..outcome.deck.items().len() {
            for found in database.apply(&outcome.deck, item) {
                assert!(!found.render(outcome.deck.sources()).is_empty());
            }
            for number in [0, 1, 7, usize::MAX] {
                let _ = outcome.deck.number_span(item, number);
                let _ = outcome.deck.header_span(item, number);
            }
        }
    }
}

#[test]
fn hostile_counts_take_no_memory() {
    let huge = i64::MAX;
    for text in [
        format!("/YD/YDPE/MPROP {huge} /YD/YDPE/D1PERO {huge} 1 2 $YDOIT\n"),
        "/YD/YDPE/MPROP 99999999999 /YD/YDPE/D1PERO 99999999999 1 $YDOIT\n".to_owned(),
        format!(
            "/YD/YDN/MNODIM {huge} /YD/YDN/MNOPO {huge} /YD/YDN/D2NCC 21 {huge} {huge} 1 $YDOIT\n"
        ),
        format!(
            "/YD/YDPN/MPNSET {huge} /YD/YDPN/MPNFACT {huge} /YD/YDPN/D3PNFAC 231 2 {huge} {huge} 1 $YDOIT\n"
        ),
        format!("/YD/YDPN/MPNSET {} $YDOIT\n", i64::MIN),
    ] {
        exercise(text.as_bytes());
    }
}

#[test]
fn long_decks_are_read_in_linear_time() {
    let warnings = "/YD/YDC/MCSTEPS 1\n".repeat(100_000);
    let comments = "/* x */ ".repeat(100_000);
    let numbers = format!("/YD/YDPE/MPROP 1 /YD/YDPE/D1PERO 1 1{}\n", " 1".repeat(1_000_000));
    let blanks = " ".repeat(1_000_000);
    let line = "x".repeat(1_000_000);
    let includes = "$YINCL a\n".repeat(2_000);
    for text in [warnings, comments + "junk\n", numbers, blanks, line, includes] {
        let mut reader = DeckReader::new().includes(|_: &str| Ok(b"/YD/YDC/MCSTEP 1\n".to_vec()));
        let outcome = reader.parse("long.y", text.clone().into_bytes());
        assert!(outcome.deck.to_bytes() == text.as_bytes());
        let _ = outcome.deck.echo_lines();
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        exercise(&bytes);
    }

    #[test]
    fn truncated_decks(deck in 0usize..4, length in any::<prop::sample::Index>()) {
        exercise(&DECKS[deck][..length.index(DECKS[deck].len())]);
    }

    #[test]
    fn mutated_decks(
        deck in 0usize..4,
        changes in proptest::collection::vec((any::<prop::sample::Index>(), prop_oneof![any::<u8>(), Just(b' '), Just(b'9')]), 1..8),
    ) {
        let mut bytes = DECKS[deck].to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        exercise(&bytes);
    }

    #[test]
    fn pieces_in_disorder(pieces in proptest::collection::vec(
        prop::sample::select(vec![
            "/YD/YDPE/MPROP", "/YD/YDPE/D1PERO", "/YD/YDN/MNODIM", "/YD/YDN/MNOPO", "/YD/YDN/D2NCC", "/YD/YDE/I1ELPR",
            "/YD/YDE/I2ELTO", "/YD/YDPN/D3PNFAC", "/YD/YDN/D1NMCT", "/YD/YDE/D3TCS", "$YDOIT", "$YSTOP", "$YINCL", "/*", "*/",
            "21", "231", "2", "-1", "1e", "+", ".", "nan", "na", "99999999999", "\n", "\u{e9}",
        ]), 0..60)) {
        exercise(pieces.join(" ").as_bytes());
        exercise(pieces.concat().as_bytes());
    }
}
