//! Descriptions of parameter studies.

use super::folder;
use std::fs;
use ypsilon::sweep::Study;

const DECK: &str = include_str!("../bad_decks/base.y");
const SCENARIO: &str = include_str!("../../examples/bridge/bridge.toml");
/// Cases whose deck is made: the others differ in their values only.
const TRIED: usize = 4;

/// A study beside a deck and a scenario that it may vary, down to the inputs of its cases.
pub fn study(bytes: &[u8]) {
    let folder = folder();
    let path = folder.path().join("study.toml");
    let files =
        [("study.toml", bytes), ("deck.y", DECK.as_bytes()), ("bridge.toml", SCENARIO.as_bytes())];
    for (name, contents) in files {
        fs::write(folder.path().join(name), contents).expect("a writable folder");
    }
    let results = folder.path().join("results");
    let Ok(study) = Study::read(&path, Some(&results), &|_| Ok(None)) else { return };
    for number in 1..=TRIED {
        let Some(case) = study.case(number) else { return };
        let _ = study.words(case);
        let _ = study.print(case);
    }
}
