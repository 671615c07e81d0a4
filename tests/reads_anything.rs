//! What the fuzzers have found worth keeping (`fuzz/corpus`) goes through its reader: no panic, no
//! allocation beyond what small files deserve, no run without end.

#[path = "support/largest_allocation.rs"]
mod largest_allocation;
mod readers;

use largest_allocation::{LARGEST_ALLOCATION, Watched, largest};
use readers::READERS;
use std::{fs, path::Path};

#[global_allocator]
static ALLOCATOR: Watched = Watched;

#[test]
fn every_file_of_every_corpus_is_read() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus");
    for (name, read) in READERS {
        let mut files: Vec<_> = fs::read_dir(root.join(name))
            .unwrap_or_else(|error| panic!("fuzz/corpus/{name}: {error}"))
            .map(|entry| entry.expect("a file").path())
            .collect();
        files.sort();
        assert!(!files.is_empty(), "fuzz/corpus/{name} is empty");
        for file in files {
            read(&fs::read(&file).expect("a readable file"));
            let largest = largest();
            assert!(largest <= LARGEST_ALLOCATION, "{file:?}: somebody asked for {largest} bytes");
        }
    }
}

/// A reader without a fuzz target would never be fuzzed.
#[test]
fn every_reader_has_a_fuzz_target() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz");
    let manifest = fs::read_to_string(folder.join("Cargo.toml")).expect("the manifest");
    for (name, _) in READERS {
        assert!(manifest.contains(&format!("name = \"{name}\"")), "{name}");
        assert!(folder.join(format!("fuzz_targets/{name}.rs")).is_file(), "{name}");
    }
    assert_eq!(fs::read_dir(folder.join("fuzz_targets")).expect("targets").count(), READERS.len());
}

/// States and checkpoints that runs leave: to be written anew whenever what they hold changes.
#[test]
#[ignore = "writes seeds into fuzz/corpus"]
fn seeds_of_states() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus");
    for (name, seeds) in
        [("state", readers::checkpoints::states()), ("checkpoint", readers::checkpoints::files())]
    {
        fs::create_dir_all(root.join(name)).expect("a writable folder");
        for (index, bytes) in seeds.iter().enumerate() {
            fs::write(root.join(name).join(format!("seed_{index}")), bytes).expect("room");
        }
    }
}

/// What this version writes is what it reads: else the corpora say nothing about it.
#[test]
fn states_and_checkpoints_of_this_version_go_on() {
    for state in readers::checkpoints::states() {
        assert!(readers::checkpoints::goes_on(&state));
    }
    for file in readers::checkpoints::files() {
        readers::checkpoints::file(&file);
    }
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus/state");
    let whole = fs::read_dir(root).expect("a corpus").filter(|entry| {
        let path = entry.as_ref().expect("a file").path();
        readers::checkpoints::goes_on(&fs::read(path).expect("a readable file"))
    });
    assert!(
        whole.count() > 0,
        "no state in the corpus can be restored: write seeds_of_states anew"
    );
}
