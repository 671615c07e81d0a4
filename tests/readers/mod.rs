//! Every reader of files, as something that takes bytes: whatever they are, reading ends, without
//! panic and without memory beyond what the bytes deserve.
//!
//! The fuzz targets (`fuzz/`) and the test over their corpora (`tests/reads_anything.rs`) share
//! these functions.

pub mod checkpoints;
pub mod decks;
pub mod results;
pub mod scenarios;
pub mod studies;

/// A reader and the name of its corpus.
pub type Reader = (&'static str, fn(&[u8]));

/// All readers: one fuzz target and one folder in `fuzz/corpus` each.
pub const READERS: [Reader; 18] = [
    ("deck_split", decks::split),
    ("deck_classic", decks::classic),
    ("deck_ygeo", decks::ygeo),
    ("deck_y3d", decks::y3d),
    ("restart_deck", decks::restart_deck),
    ("checkpoint", checkpoints::file),
    ("state", checkpoints::state),
    ("d3plot", results::d3plot),
    ("ym", results::ym),
    ("history", results::history),
    ("vtp", results::vtp),
    ("vtu", results::vtu),
    ("pvd", results::pvd),
    ("csv", results::csv),
    ("gmsh", scenarios::gmsh),
    ("scenario", scenarios::scenario),
    ("study", studies::study),
    ("words", scenarios::words),
];

/// A folder of its own for one input, removed afterwards.
fn folder() -> tempfile::TempDir {
    tempfile::TempDir::new().expect("a temporary folder")
}
