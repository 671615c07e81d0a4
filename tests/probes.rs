//! Small decks that were given to the original program, with what it did.
//!
//! What it ran runs here, too, with result files of the same size. What it stopped at or crashed
//! with is refused with an error, and so is what it ran without saying that the result is wrong.

use std::{
    collections::BTreeMap,
    fs,
    path::{Path, PathBuf},
};
use tempfile::TempDir;
use yformat::diagnostic::Diagnostic;
use ypsilon::{
    scene::Profile,
    session::{DeckFault, Format, LoadedDeck, RunOptions, Silent, load, run},
    simulation::SolverOptions,
};

/// What the original did with a deck.
#[derive(Debug, Clone, Copy)]
enum Original {
    /// It ran, and left files of these sizes.
    Ran(Sizes),
    /// It read to the end, ran nothing, and left a log of this size.
    DidNothing(usize),
    /// It stopped reading with a message.
    StoppedReading,
    /// It stopped at the first step with a message.
    StoppedRunning,
    /// It crashed.
    Crashed,
}
use Original::{Crashed, DidNothing, Ran, StoppedReading, StoppedRunning};

/// Bytes of the original's files. Its lines end in two characters, its exponents have three digits.
#[derive(Debug, Clone, Copy)]
struct Sizes {
    d3plot: u64,
    history: u64,
    log: usize,
}

const fn sizes(d3plot: u64, history: u64, log: usize) -> Sizes {
    Sizes { d3plot, history, log }
}

/// What happens here.
#[derive(Debug, Clone, Copy)]
enum Here {
    /// The same.
    Same,
    /// An error with this code, before anything runs.
    Refused(&'static str),
}
use Here::{Refused, Same};

const PROBES: &[(&str, Original, Here)] = &[
    // what is read and run
    ("p_a_very_long_deck_name_over_thirty_chars_x", Ran(sizes(696, 39, 1574)), Same),
    ("p_comment150", Ran(sizes(1080, 39, 1590)), Same),
    ("p_incl_ok", Ran(sizes(888, 39, 1667)), Same),
    ("p_leadcomment", Ran(sizes(1080, 39, 1590)), Same),
    ("p_longword120", Ran(sizes(1080, 39, 1590)), Same),
    ("p_micoup1", Ran(sizes(696, 39, 1574)), Same),
    ("p_multiline", Ran(sizes(696, 39, 1574)), Same),
    ("p_ncstep5", Ran(sizes(1272, 0, 1510)), Same),
    ("p_noystop", Ran(sizes(696, 39, 1566)), Same),
    ("p_trailcomment", Ran(sizes(1080, 39, 1590)), Same),
    ("p_twoperline", Ran(sizes(1080, 39, 1606)), Same),
    ("p_ydoit2", Ran(sizes(1272, 39, 1614)), Same),
    // types without mechanics and a node set that does not exist: run with a warning
    ("e3_jtyp0", Ran(sizes(100_436, 1560, 4070)), Same),
    ("h_nopr_outofrange", Ran(sizes(4152, 39, 1574)), Same),
    ("p_ptyp0", Ran(sizes(888, 39, 1574)), Same),
    ("p_ptyp5", Ran(sizes(888, 39, 1574)), Same),
    // decks that never come to `$YDOIT`: nothing happens, with a warning
    ("p_noend", DidNothing(1430), Same),
    ("p_nospacecomment", DidNothing(1430), Same),
    ("p_noydoit", DidNothing(1438), Same),
    ("p_unclosed", DidNothing(1430), Same),
    // the area of a flat triangle divides its stresses
    ("p_degenerate", Ran(sizes(888, 39, 1574)), Refused("scene::flat-triangle")),
    // an element of a material that does not exist has neither stiffness nor mass
    ("p_elpr_oor", Ran(sizes(696, 39, 1574)), Refused("scene::property-number")),
    // a word behind the last `$YDOIT` is found before the steps, not after them
    ("p_yfoo", Ran(sizes(696, 39, 1566)), Refused("deck::unknown-word")),
    ("p_array_comment", StoppedReading, Refused("deck::comment-inside-values")),
    ("p_comma", StoppedReading, Refused("deck::glued-text")),
    ("p_comment600", StoppedReading, Refused("deck::comment-too-long")),
    ("p_comment_40lines", StoppedReading, Refused("deck::comment-too-long")),
    ("p_floatint", StoppedReading, Refused("deck::glued-text")),
    ("p_fortran_d", StoppedReading, Refused("deck::glued-text")),
    ("p_garbage", StoppedReading, Refused("deck::unknown-word")),
    ("p_incl", StoppedReading, Refused("deck::include-missing")),
    ("p_incl_missing", StoppedReading, Refused("deck::include-missing")),
    ("p_inlinecomment", StoppedReading, Refused("deck::comment-inside-values")),
    ("p_lowercase", StoppedReading, Refused("deck::unknown-keyword")),
    ("p_nanvel", StoppedReading, Refused("deck::not-a-number")),
    ("p_unknown_db", StoppedReading, Refused("deck::unknown-database")),
    ("p_unknown_ydc", StoppedReading, Refused("deck::unknown-keyword")),
    ("p_unknown_ydpe", StoppedReading, Refused("deck::unknown-keyword")),
    ("p_melem6_joint", StoppedRunning, Refused("scene::capacity")),
    ("p_melem_small_joint", StoppedRunning, Refused("deck::too-long")),
    ("p_mnopo8_joint", StoppedRunning, Refused("scene::capacity")),
    ("p_longcomment", Crashed, Refused("deck::word-too-long")),
    ("p_ptyp4", Crashed, Refused("scene::softening")),
    ("pm_2_0_j0", Crashed, Refused("scene::mesh-record")),
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Probes about reading alone belong to `yformat`, the others are here.
fn deck(name: &str) -> PathBuf {
    let file = format!("{name}.y");
    let here = root().join("tests/data/probes").join(&file);
    if here.exists() { here } else { root().join("yformat/tests/data/probes").join(file) }
}

fn load_probe(name: &str) -> Result<LoadedDeck, DeckFault> {
    load(&deck(name), None, Profile::Windows, SolverOptions::default())
}

/// The findings of a deck that is refused.
fn refusal(name: &str) -> Vec<Diagnostic> {
    match load_probe(name) {
        Ok(_) => panic!("{name} is not refused"),
        Err(DeckFault::Findings { findings, .. }) => findings,
        Err(fault) => panic!("{name}: {fault}"),
    }
}

/// Files that a run of a probe leaves, with their content.
fn results(name: &str) -> BTreeMap<String, Vec<u8>> {
    let loaded = load_probe(name).unwrap_or_else(|fault| panic!("{name}: {fault:?}"));
    let folder = TempDir::new().expect("a temporary folder");
    let options = RunOptions {
        formats: vec![Format::D3plot, Format::Yh],
        legacy_d3plot: true,
        ..RunOptions::new(deck(name), folder.path())
    };
    run(loaded, &options, &mut Silent).unwrap_or_else(|error| panic!("{name}: {error}"));
    let entries = fs::read_dir(&folder).expect("the results").flatten();
    let read = |path: PathBuf| fs::read(path).expect("a result file");
    entries.map(|e| (e.file_name().to_string_lossy().into_owned(), read(e.path()))).collect()
}

/// Characters that the original adds to its log for an included file. What they say is not known.
const INCLUDE_NOTE: usize = 53;

/// Bytes of a log as the original wrote it, which gave no warnings about decks.
fn original_size(log: &[u8]) -> usize {
    let text = String::from_utf8_lossy(log);
    let said = |line: &&str| line.contains(".y:") || line.starts_with("warning[");
    let includes = text.lines().filter(|line| line.starts_with("$YINCL")).count();
    let lines = text.lines().filter(|line| !said(line)).map(|line| line.len() + 2);
    lines.sum::<usize>() + includes * INCLUDE_NOTE
}

#[test]
fn what_the_original_ran_runs_with_files_of_the_same_size() {
    for &(name, original, here) in PROBES {
        let (Ran(expected), Same) = (original, here) else { continue };
        let files = results(name);
        let size = |file: &str| files.get(file).map_or(0, |bytes| bytes.len() as u64);
        assert_eq!(size(name), expected.d3plot, "{name}: d3plot");
        // 39 bytes in a line of the original are 36 here
        assert_eq!(size(&format!("{name}.yh0")) / 36 * 39, expected.history, "{name}: history");
        assert_eq!(original_size(&files["Ytmp"]), expected.log, "{name}: log");
    }
}

#[test]
fn decks_without_command_do_nothing_and_say_so() {
    for &(name, original, here) in PROBES {
        let (DidNothing(log), Same) = (original, here) else { continue };
        let loaded = load_probe(name).unwrap_or_else(|fault| panic!("{name}: {fault:?}"));
        assert!(loaded.findings.iter().any(|f| f.code == "deck::no-run"), "{name}");
        let files = results(name);
        assert_eq!(files.keys().collect::<Vec<_>>(), ["Ytmp"], "{name}");
        assert_eq!(original_size(&files["Ytmp"]), log, "{name}: log");
    }
}

#[test]
fn what_the_original_could_not_read_or_run_is_refused_with_one_error() {
    for &(name, _, here) in PROBES {
        let Refused(code) = here else { continue };
        let findings = refusal(name);
        let errors: Vec<_> = findings.iter().filter(|f| f.is_error()).collect();
        assert_eq!(errors.len(), 1, "{name}: {findings:?}");
        assert_eq!(errors[0].code, code, "{name}");
        assert!(errors[0].notes.location.is_some(), "{name}");
    }
}

#[test]
fn nothing_that_stopped_the_original_runs_here() {
    for &(name, original, here) in PROBES {
        let ran = matches!(original, Ran(_) | DidNothing(_));
        assert!(ran || matches!(here, Refused(_)), "{name}: {original:?}");
    }
}

/// The table above against the records of the original, where they are at hand.
#[test]
fn the_table_tells_what_was_observed() {
    let folder = root().join("../shared/reference/probes");
    if !folder.is_dir() {
        println!("skipping: {} is absent", folder.display());
        return;
    }
    let mut known: Vec<&str> = PROBES.iter().map(|probe| probe.0).collect();
    known.sort_unstable();
    let mut observed: Vec<String> = fs::read_dir(&folder)
        .expect("the probes")
        .flatten()
        .map(|entry| entry.file_name().to_string_lossy().into_owned())
        .collect();
    observed.sort_unstable();
    assert_eq!(known, observed);
    for &(name, original, _) in PROBES {
        let record = fs::read_to_string(folder.join(name).join("observed.txt")).expect("a record");
        let size = |file: &str| {
            let line = record.lines().find_map(|line| line.strip_suffix(&format!(" {file}")));
            line.map_or(0, |bytes| bytes.parse::<u64>().expect("a size"))
        };
        let exit: i32 = record
            .lines()
            .find_map(|line| line.strip_prefix("exit status: "))
            .and_then(|status| status.parse().ok())
            .expect("an exit status");
        let found = (size(name), size(&format!("{name}.yh0")), size("Ytmp"));
        match original {
            Ran(s) => assert_eq!(found, (s.d3plot, s.history, s.log as u64), "{name}"),
            DidNothing(log) => assert_eq!(found, (0, 0, log as u64), "{name}"),
            StoppedReading => assert!(matches!(exit, 0 | 103 | 104) && found.0 == 0, "{name}"),
            StoppedRunning => assert_eq!(exit, 1, "{name}"),
            Crashed => assert!(matches!(exit, 5 | 9), "{name}"),
        }
    }
}
