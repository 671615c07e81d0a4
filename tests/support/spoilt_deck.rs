//! Decks that differ from a sound one by a mistake, and what is said about them.

use std::{
    fmt::Write,
    fs,
    path::{Path, PathBuf},
};
use tempfile::TempDir;
use yformat::diagnostic::{Diagnostic, Severity};
use ypsilon::{
    scene::Profile,
    session::{DeckFault, load},
    simulation::SolverOptions,
};

/// Replacements of text that make a mistake.
pub type Edits<'a> = &'a [(&'a str, &'a str)];

/// What loading a deck came to.
pub struct Verdict {
    /// The findings, worst or not, as the user sees them, without the folder's name.
    pub text: String,
    /// How bad each finding is.
    pub severities: Vec<Severity>,
    /// Whether each finding has a place in a file.
    pub placed: Vec<bool>,
    /// Whether the deck can be run.
    pub runs: bool,
}

/// The sound deck.
pub fn base() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad_decks/base.y");
    fs::read_to_string(path).expect("the base deck is part of the repository")
}

/// A sound deck of another dialect: `classic`, `classic_glued` or `ygeo`.
pub fn base_of(dialect: &str) -> String {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/bad_decks");
    fs::read_to_string(root.join(format!("base_{dialect}.y"))).expect("a committed deck")
}

/// The sound deck after some edits. Each edit must name text that the deck has exactly once.
pub fn edited(edits: Edits<'_>) -> String {
    edit(base(), edits)
}

/// A deck after some edits. Each edit must name text that the deck has exactly once.
pub fn edit(mut deck: String, edits: Edits<'_>) -> String {
    for (old, new) in edits {
        assert_eq!(deck.matches(old).count(), 1, "`{old}` must stand in the deck once");
        deck = deck.replacen(old, new, 1);
    }
    deck
}

/// What is said about a sound deck with one mistake after the other, if that is one finding of this
/// severity with a place each.
pub fn all_say(severity: Severity, deck: &str, cases: &[(&str, Edits<'_>)]) -> String {
    let (mut said, mut wrong) = (String::new(), String::new());
    for (mistake, edits) in cases {
        let found = verdict(edit(deck.to_owned(), edits).as_bytes());
        let as_wanted = found.severities == [severity]
            && found.placed == [true]
            && found.runs == (severity != Severity::Error);
        let list = if as_wanted { &mut said } else { &mut wrong };
        let _ = writeln!(list, "== {mistake}\n{}", found.text);
    }
    assert_eq!(wrong, "", "not one finding with a place:\n{wrong}");
    said
}

/// What is said about a deck of these bytes, which is alone in its folder.
pub fn verdict(deck: &[u8]) -> Verdict {
    let folder = TempDir::new().expect("a temporary folder");
    verdict_of(&write(folder.path(), "deck.y", deck))
}

/// Writes a file into a folder.
pub fn write(folder: &Path, name: &str, bytes: &[u8]) -> PathBuf {
    let path = folder.join(name);
    fs::write(&path, bytes).expect("the temporary folder is writable");
    path
}

/// What is said about a deck file.
pub fn verdict_of(path: &Path) -> Verdict {
    let (rendered, findings, runs) =
        match load(path, None, Profile::default(), SolverOptions::default()) {
            Ok(loaded) => {
                let sources = loaded.deck.sources();
                let text: String = loaded.findings.iter().map(|f| f.render(sources)).collect();
                (text, loaded.findings, loaded.simulation.is_some())
            }
            Err(DeckFault::Findings { sources, findings }) => {
                (findings.iter().map(|f| f.render(&sources)).collect(), findings, false)
            }
            Err(fault) => (format!("error: {fault}\n"), Vec::new(), false),
        };
    let folder = path.parent().map_or(String::new(), |p| format!("{}/", p.display()));
    let lines: Vec<String> =
        rendered.replace(&folder, "").lines().map(|line| line.trim_end().to_owned()).collect();
    Verdict {
        text: lines.join("\n"),
        severities: findings.iter().map(|f| f.severity).collect(),
        placed: findings.iter().map(has_place).collect(),
        runs,
    }
}

fn has_place(finding: &Diagnostic) -> bool {
    finding.notes.location.is_some()
}
