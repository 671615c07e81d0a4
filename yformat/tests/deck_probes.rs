//! Small decks that were fed to the original program, with what it did: what it read is read here,
//! what it refused or choked on is explained here.

use std::fmt::Write;
use std::path::PathBuf;

use yformat::deck::Deck;

/// What the original did.
enum Original {
    /// It ran the steps this many times.
    Ran(usize),
    /// It read to the end and did nothing.
    DidNothing,
    /// It stopped reading at the word named here, which the diagnostic must point at or explain.
    Stopped,
    /// It crashed.
    Crashed,
}
use Original::{Crashed, DidNothing, Ran, Stopped};

/// Deck, behaviour, size of the original's echo file where it was not mixed with progress rows
/// (line ends are two bytes there).
const PROBES: &[(&str, Original, Option<usize>)] = &[
    ("p_array_comment", Stopped, Some(1447)),
    ("p_comma", Stopped, Some(1446)),
    ("p_comment150", Ran(1), None),
    ("p_comment600", Stopped, Some(1430)),
    ("p_floatint", Stopped, Some(1446)),
    ("p_fortran_d", Stopped, Some(1446)),
    ("p_garbage", Stopped, Some(1430)),
    ("p_incl_missing", Stopped, Some(1438)),
    ("p_incl_ok", Ran(1), None),
    ("p_inlinecomment", Stopped, Some(1446)),
    ("p_leadcomment", Ran(1), None),
    ("p_longcomment", Crashed, Some(1430)),
    ("p_longword120", Ran(1), None),
    ("p_lowercase", Stopped, Some(1446)),
    ("p_melem_small_joint", Ran(1), None),
    ("p_multiline", Ran(1), None),
    ("p_nanvel", Stopped, Some(299)),
    ("p_noend", DidNothing, Some(1430)),
    ("p_nospacecomment", DidNothing, Some(1430)),
    ("p_noydoit", DidNothing, Some(1438)),
    ("p_noystop", Ran(1), None),
    ("p_trailcomment", Ran(1), None),
    ("p_twoperline", Ran(1), None),
    ("p_unclosed", DidNothing, Some(1430)),
    ("p_unknown_db", Stopped, Some(1446)),
    ("p_unknown_ydc", Stopped, Some(1446)),
    ("p_unknown_ydpe", Stopped, Some(1446)),
    ("p_ydoit2", Ran(2), None),
    ("p_yfoo", Stopped, None),
];

fn folder() -> PathBuf {
    [env!("CARGO_MANIFEST_DIR"), "tests", "data", "probes"].iter().collect()
}

#[test]
fn probes_are_read_as_the_original_reads_them() {
    for (name, original, echo) in PROBES {
        let outcome = Deck::read(folder().join(name).with_extension("y")).expect("probe deck");
        let runs = outcome.deck.stages().iter().filter(|stage| stage.runs).count();
        match original {
            Ran(times) => {
                assert!(!outcome.has_errors(), "{name}: {:?}", outcome.error());
                assert_eq!(runs, *times, "{name}");
            }
            DidNothing => {
                assert!(!outcome.has_errors(), "{name}");
                assert_eq!(runs, 0, "{name}");
                assert!(
                    !outcome.diagnostics.is_empty(),
                    "{name}: somebody must be told that nothing runs"
                );
            }
            Stopped | Crashed => assert!(outcome.has_errors(), "{name}"),
        }
        if let Some(bytes) = echo {
            let ours: usize = outcome.deck.echo_lines().iter().map(|line| line.len() + 2).sum();
            assert_eq!(ours, *bytes, "{name}: {:?}", outcome.deck.echo_lines().last());
        }
    }
}

#[test]
fn what_is_said_about_the_probes() {
    let mut said = String::new();
    for (name, ..) in PROBES {
        let outcome = Deck::read(folder().join(name).with_extension("y")).expect("probe deck");
        let _ = writeln!(said, "== {name}");
        for found in &outcome.diagnostics {
            let shown = found.render(outcome.deck.sources());
            said.push_str(&shown.replace(folder().to_str().expect("UTF-8 path"), "probes"));
        }
    }
    insta::assert_snapshot!(said);
}
