//! Compares what was written with the original's file.

use super::vtk_text::array_name;

/// How many numbers of an array came out with the same digits.
#[derive(Debug, Clone, Copy, Default)]
pub struct Agreement {
    pub same: usize,
    pub all: usize,
}

impl Agreement {
    pub fn add(&mut self, other: Self) {
        self.same += other.same;
        self.all += other.all;
    }
}

/// Panics unless the files are the same, but for the numbers of some arrays: those are handed
/// to `may_differ` (array, index, the original's, ours) where their digits differ.
pub fn same_but(
    what: &str,
    original: &str,
    ours: &str,
    loose: &[&str],
    may_differ: impl Fn(&str, usize, f64, f64) -> bool,
) -> Agreement {
    let mut agreement = Agreement::default();
    let mut array = None;
    let lines = (original.split('\n').count(), ours.split('\n').count());
    assert_eq!(lines.0, lines.1, "{what}: number of lines");
    for (number, (theirs, mine)) in original.split('\n').zip(ours.split('\n')).enumerate() {
        match array.take().filter(|name: &String| loose.contains(&name.as_str())) {
            Some(name) => {
                let columns = (theirs.split(' ').count(), mine.split(' ').count());
                assert_eq!(columns.0, columns.1, "{what}: length of {name}");
                for (index, (a, b)) in theirs.split(' ').zip(mine.split(' ')).enumerate() {
                    agreement.all += usize::from(!a.is_empty());
                    agreement.same += usize::from(!a.is_empty() && a == b);
                    if a != b {
                        let close = may_differ(&name, index, number_in(a), number_in(b));
                        assert!(close, "{what}: {name}[{index}] is {b}, the original's {a}");
                    }
                }
            }
            None => assert_eq!(mine, theirs, "{what}: line {}", number + 1),
        }
        array = array_name(theirs);
    }
    agreement
}

fn number_in(word: &str) -> f64 {
    word.parse().unwrap_or_else(|_| panic!("not a number: {word:?}"))
}
