//! Whatever a deck file holds: reading it ends without panic and without allocating much, and if
//! it can be run, so do its first steps, with all output files.
//!
//! Decks are sound ones cut short, or with words replaced by other words and numbers.

mod support;

use proptest::prelude::*;
use std::{fs, path::Path};
use support::{
    largest_allocation::{LARGEST_ALLOCATION, Watched, largest},
    spoilt_deck,
};
use tempfile::TempDir;
use yformat::dialect::Dialect;
use ypsilon::{
    scene::Profile,
    session::{Format, RunOptions, Silent, load, run},
    simulation::SolverOptions,
};

#[global_allocator]
static ALLOCATOR: Watched = Watched;

/// Most bytes that a result file of three steps of such a deck may have.
const LARGEST_FILE: u64 = 10 << 20;

/// Loads a deck and runs up to three steps of it. Whether it could be run.
fn exercise(deck: &[u8]) -> bool {
    let folder = TempDir::new().expect("a temporary folder");
    let path = spoilt_deck::write(folder.path(), "deck.y", deck);
    let recognised = load_and_run(&path, None);
    let forced = load_and_run(&path, Some(Dialect::Split));
    for file in fs::read_dir(folder.path().join("out")).into_iter().flatten().flatten() {
        let size = file.metadata().map_or(0, |metadata| metadata.len());
        assert!(size <= LARGEST_FILE, "{file:?} has {size} bytes");
    }
    let largest = largest();
    assert!(largest <= LARGEST_ALLOCATION, "somebody asked for {largest} bytes");
    recognised || forced
}

fn load_and_run(path: &Path, dialect: Option<Dialect>) -> bool {
    let Ok(loaded) = load(path, dialect, Profile::default(), SolverOptions::default()) else {
        return false;
    };
    let runs = loaded.simulation.is_some();
    let options = RunOptions {
        formats: vec![Format::Native, Format::D3plot, Format::Yh, Format::Vtu, Format::Json],
        states: vec![0, 1, 3],
        steps: Some(3),
        ..RunOptions::new(path, path.with_file_name("out"))
    };
    // motion may become unstable and later stages may be wrong: that is no panic
    let _ = run(loaded, &options, &mut Silent);
    runs
}

/// Sound decks: the bases of the bad ones, reference cases of all dialects, a restart deck, and one
/// of two stages.
const DECKS: [&str; 15] = [
    include_str!("bad_decks/base_classic_glued.y"),
    include_str!("data/y3d/11_one_tet10.Y3D"),
    include_str!("data/y3d/12_joint_pair.Y3D"),
    include_str!("bad_decks/base_ygeo.y"),
    include_str!("data/classic/k_unused_joint_prop/k_unused_joint_prop.y"),
    include_str!("bad_decks/classic_stages.y"),
    include_str!("data/classic/g_joint_pair/g_joint_pair.y"),
    include_str!("data/classic/g_joint_pair/g_joint_pair4_restart.y"),
    include_str!("data/classic/i_pressure/i_pressure.y"),
    include_str!("data/ygeo/g_joint_pair/g_joint_pair.y"),
    include_str!("data/ygeo/y_absorbing/y_absorbing.y"),
    include_str!("bad_decks/base.y"),
    include_str!("data/split2d/e2_tension_cyc/e2_tension_cyc.y"),
    include_str!("data/split2d/x_mesh_31/x_mesh_31.y"),
    include_str!("../yformat/tests/data/probes/p_ydoit2.y"),
];

/// What replaces words.
fn replacement() -> impl Strategy<Value = String> {
    let words = [
        "0",
        "1",
        "-1",
        "2",
        "3",
        "4",
        "7",
        "-2",
        "21",
        "12",
        "31",
        "231",
        "100",
        "-1000",
        "1e-300",
        "1e-12",
        "0.5",
        "-0.5",
        "1e8",
        "-1e8",
        "1e30",
        "1e300",
        "-1e300",
        "4294967296",
        "1000000000000",
        "9223372036854775807",
        "-9223372036854775808",
        "nan",
        ".",
        "-",
        "1e",
        "2e4",
        "1,5",
        "*/",
        "/*",
        "$YDOIT",
        "$YSTOP",
        "$YINCL",
        "/YD/YDC/MCSTEP",
        "/YD/YDN/NNOPO",
        "/YD/YDE/MELEM",
        "/YD/YDPE/MPROP",
        "/YD/YDI/MICOUP",
        "/YD/YDP/NPROP",
        "/YD/YDP/I1PTYP",
        "/YD/YDP/I1PEMN",
        "/YD/YDP/I1PNFZ",
        "/YD/YDE/I1ELTY",
        "/YD/YDJ/NJOINT",
        "/YD/YDPE/D2PEINT",
        "/YD/YDFN/IUSEFN",
        "brick",
        "\u{e9}",
    ];
    prop_oneof![
        4 => prop::sample::select(words.to_vec()).prop_map(str::to_owned),
        1 => any::<i64>().prop_map(|n| n.to_string()),
        1 => (-400i32..400).prop_map(|n| n.to_string()),
        1 => any::<f64>().prop_map(|x| format!("{x:e}")),
    ]
}

/// A deck with the words at some places replaced.
fn replaced(deck: &str, changes: &[(prop::sample::Index, String)]) -> String {
    let mut words: Vec<&str> = deck.split_inclusive(char::is_whitespace).collect();
    for (place, word) in changes {
        let at = place.index(words.len());
        words[at] = word;
        words.insert(at + 1, " ");
    }
    words.concat()
}

#[test]
fn the_decks_are_sound() {
    for deck in DECKS {
        assert!(exercise(deck.as_bytes()));
    }
}

#[test]
fn numbers_beyond_all_bounds() {
    for (old, new) in [
        ("MELNO 4", "MELNO 100000000"),
        ("MELST 1", "MELST 1000000000000"),
        ("MICOUP 40", "MICOUP 9000000000000000000"),
        ("MELEM 7", "MELEM 1000000000000"),
        ("MNOPO 10", "MNOPO 1000000000000"),
        ("21 3 1\n0 0 0\n", "21 3 2\n2147483647 2147483647 0\n0 0 0\n"),
        ("MCSTEP 20", "MCSTEP 9000000000000000000"),
        ("ICOUTF 10", "ICOUTF 9000000000000000000"),
        ("DIEDI 200", "DIEDI 1e300"),
        ("DIEZON 0.1", "DIEZON 1e300"),
    ] {
        let deck = spoilt_deck::edited(&[(old, new)]).replace("MPMROW 1", "MPMROW 2");
        assert!(exercise(deck.as_bytes()), "{new} can be run");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn truncated_decks(deck in 0..DECKS.len(), length in any::<prop::sample::Index>(), run in any::<bool>()) {
        let mut bytes = DECKS[deck].as_bytes()[..length.index(DECKS[deck].len())].to_vec();
        if run {
            bytes.extend(b"\n$YDOIT\n");
        }
        exercise(&bytes);
    }

    #[test]
    fn one_word_replaced(deck in 0..DECKS.len(), place in any::<prop::sample::Index>(), word in replacement()) {
        exercise(replaced(DECKS[deck], &[(place, word)]).as_bytes());
    }

    #[test]
    fn several_words_replaced(
        deck in 0..DECKS.len(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), replacement()), 2..5),
    ) {
        exercise(replaced(DECKS[deck], &changes).as_bytes());
    }

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        exercise(&bytes);
    }
}
