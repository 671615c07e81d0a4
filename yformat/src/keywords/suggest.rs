//! Help for names that no table knows: the nearest name, and the dialects that know the name.

use super::table::{match_word, tables};
use crate::dialect::Dialect;

/// The spelling of the dialect nearest to an unknown word, if one is near enough to be meant.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::similar;
///
/// assert_eq!(similar(Dialect::Split, "/yd/ydc/mcstep").as_deref(), Some("/YD/YDC/MCSTEP"));
/// assert_eq!(similar(Dialect::Split, "/YD/YDC/MCSTPE").as_deref(), Some("/YD/YDC/MCSTEP"));
/// assert_eq!(similar(Dialect::Split, "$YDOTI").as_deref(), Some("$YDOIT"));
/// assert_eq!(similar(Dialect::Split, "bonjour"), None);
/// ```
#[must_use]
pub fn similar(dialect: Dialect, word: &str) -> Option<String> {
    // Words longer than any keyword path are not misspelt keywords, and the distance costs their
    // length.
    if word.len() > 40 || !word.contains(['/', '$']) {
        return None;
    }
    let asked = word.to_uppercase();
    let paths = tables(dialect).iter().flat_map(|table| table.keywords).map(super::Keyword::path);
    let commands = COMMANDS.into_iter().map(str::to_owned);
    let near = paths
        .chain(commands)
        .map(|known| (distance(&asked, &known), known))
        .min_by_key(|(distance, _)| *distance);
    near.filter(|(distance, _)| *distance <= 2).map(|(_, known)| known)
}

/// The dialects that know a word, as their users name them.
///
/// ```
/// use yformat::dialect::Dialect;
/// use yformat::keywords::dialects_knowing;
///
/// assert_eq!(dialects_knowing(b"/YD/YDC/ICSAVF"), vec!["classic"]);
/// ```
#[must_use]
pub fn dialects_knowing(word: &[u8]) -> Vec<&'static str> {
    let knows = |dialect: &Dialect| matches!(match_word(*dialect, word), Some((_, Some(_))));
    let mut names: Vec<_> = Dialect::ALL.into_iter().filter(knows).map(Dialect::name).collect();
    if BOOK_ONLY.iter().any(|path| word.starts_with(path)) {
        names.push("book");
    }
    names
}

const COMMANDS: [&str; 3] = ["$YDOIT", "$YSTOP", "$YINCL"];

/// Keywords of the program of Munjiza's book that its successors dropped.
const BOOK_ONLY: [&[u8]; 2] = [b"/YD/YDP/D1PEFS", b"/YD/YDP/D1PEGF"];

/// Number of characters to insert, delete, replace or swap with their neighbour.
fn distance(a: &str, b: &str) -> usize {
    let (a, b): (Vec<char>, Vec<char>) = (a.chars().collect(), b.chars().collect());
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for i in 1..=a.len() {
        let mut row = vec![i];
        for j in 1..=b.len() {
            let replaced = last[j - 1] + usize::from(a[i - 1] != b[j - 1]);
            let mut best = replaced.min(last[j] + 1).min(row[j - 1] + 1);
            if i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1] {
                best = best.min(before[j - 2] + 1);
            }
            row.push(best);
        }
        before = std::mem::replace(&mut last, row);
    }
    last[b.len()]
}
