//! Which files belong together.

use std::path::{Path, PathBuf};

use super::YmNotice;
use crate::error::{ConvertError, at};

/// The snapshots of one run.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct YmSeries {
    /// What all names begin with: the deck's name up to its first point.
    pub prefix: String,
    /// Numbers and files, ascending.
    pub snapshots: Vec<(u64, PathBuf)>,
    /// The deck that wrote them.
    pub deck: Option<PathBuf>,
    /// What is doubtful.
    pub notices: Vec<YmNotice>,
}

impl YmSeries {
    /// Finds the series that a snapshot belongs to: for `test12.ym` all `test<number>.ym` of the
    /// folder and the deck `test.y`, or another one whose name up to the first point is `test`, or
    /// else a restart deck `test<number>_restart.y`.
    ///
    /// Where the name before the number may end in a digit (`wall21.ym`: snapshot 21 of `wall.y` or
    /// 1 of `wall2.y`) the deck decides, the given one first, then the one that there is.
    ///
    /// # Errors
    /// If the name is not that of a snapshot, or the folder cannot be read.
    pub fn find(input: &Path, deck: Option<&Path>) -> Result<Self, ConvertError> {
        let not_a_snapshot = || ConvertError::NotASnapshot { path: input.to_path_buf() };
        let name = input.file_name().and_then(|name| name.to_str()).ok_or_else(not_a_snapshot)?;
        let folder = match input.parent() {
            Some(folder) if !folder.as_os_str().is_empty() => folder,
            _ => Path::new("."),
        };
        let names = names_in(folder)?;
        // The longest number first: shortest prefix.
        let mut candidates = splits(name);
        candidates.reverse();
        let with_deck: Vec<(&str, String)> = candidates
            .iter()
            .filter_map(|&(prefix, _)| Some((prefix, deck_of(prefix, &names)?)))
            .collect();
        let given = deck.and_then(|deck| deck.file_name()?.to_str()).map(base_of);
        let by_given = candidates.iter().find(|(prefix, _)| Some(*prefix) == given);
        let mut notices = Vec::new();
        let (prefix, found) = match (by_given, with_deck.as_slice()) {
            (Some((prefix, _)), _) => (*prefix, None),
            (None, [(prefix, found), others @ ..]) => {
                if let ([(_, other), ..], None) = (others, deck) {
                    let [taken, other] = [found, other].map(|name| folder.join(name));
                    notices.push(YmNotice::TwoSeries { taken, other });
                }
                (*prefix, Some(folder.join(found)))
            }
            (None, []) => (candidates.first().ok_or_else(not_a_snapshot)?.0, None),
        };
        let deck = deck
            .map(Path::to_path_buf)
            .or(found)
            .or_else(|| restart_deck_of(prefix, &names).map(|name| folder.join(name)));
        if deck.is_none() {
            let expected = folder.join(format!("{prefix}.y"));
            notices.push(YmNotice::NoDeck { expected });
        }
        let mut snapshots: Vec<(u64, PathBuf)> = names
            .iter()
            .filter_map(|name| Some((number(name, prefix)?, folder.join(name))))
            .collect();
        snapshots.sort();
        Ok(Self { prefix: prefix.to_owned(), snapshots, deck, notices })
    }
}

fn names_in(folder: &Path) -> Result<Vec<String>, ConvertError> {
    let mut names = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(at(folder))? {
        names.extend(entry.map_err(at(folder))?.file_name().into_string().ok());
    }
    names.sort();
    Ok(names)
}

/// All ways to split a name into prefix and number, the shortest number first.
fn splits(name: &str) -> Vec<(&str, u64)> {
    let Some(stem) = name.strip_suffix(".ym") else {
        return Vec::new();
    };
    let digits = stem.len() - stem.trim_end_matches(|c: char| c.is_ascii_digit()).len();
    let split = |length: usize| {
        let (prefix, number) = stem.split_at(stem.len() - length);
        let padded = length > 1 && number.starts_with('0');
        (!padded).then(|| Some((prefix, number.parse().ok()?))).flatten()
    };
    (1..=digits).filter_map(split).collect()
}

/// The number of a snapshot of this prefix.
fn number(name: &str, prefix: &str) -> Option<u64> {
    splits(name).into_iter().find(|(found, _)| *found == prefix).map(|(_, number)| number)
}

/// A deck's name up to its first point.
fn base_of(name: &str) -> &str {
    name.split_once('.').map_or(name, |(base, _)| base)
}

fn is_deck_name(name: &str) -> bool {
    name.ends_with(".y") || name.ends_with(".Y")
}

fn deck_of(prefix: &str, names: &[String]) -> Option<String> {
    let plain = format!("{prefix}.y");
    let fits = |name: &&String| is_deck_name(name) && base_of(name) == prefix;
    names.iter().find(|name| **name == plain).or_else(|| names.iter().find(fits)).cloned()
}

/// The restart deck with the highest number.
fn restart_deck_of(prefix: &str, names: &[String]) -> Option<String> {
    let number = |name: &String| -> Option<u64> {
        name.strip_prefix(prefix)?.strip_suffix("_restart.y")?.parse().ok()
    };
    let last = names.iter().filter_map(|name| Some((number(name)?, name))).max()?;
    Some(last.1.clone())
}
