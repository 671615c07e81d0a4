//! Whatever a history file holds: reading it ends, takes no more memory than the file suggests, and
//! what was read is what a writer would write.

use proptest::prelude::*;
use yformat::history::{History, HistoryError};

/// As the split program, the classic one and Y-Geo write them.
const HISTORIES: [&str; 3] = [
    "0.0000000000e+00   1.0000000000e+00\n1.0000000000e-03  -2.5000000000e-01\n",
    "+0.00000000000e+00 +1.00000000000e+00\n  +1.0e+00 -2.0e+00\n+1.00000000000e-03 +2.00000000000e+00\n  +0.0e+00 +0.0e+00\n",
    "0.000000e+000 nan\r\n1.000000e-003-2.500000e-001\r\n\r\n2.000000e-003 -inf\r\n",
];

/// Reads a history; tells how many points it has.
fn exercise(bytes: &[u8]) -> Option<usize> {
    let lines = bytes.split(|&byte| byte == b'\n').count();
    match History::parse(bytes) {
        Ok(history) => {
            assert!(history.points.len() + history.contact_forces.len() <= lines);
            assert!(history.contact_forces.len() <= history.points.len());
            assert_eq!(history.unterminated, bytes.last().is_some_and(|&byte| byte != b'\n'));
            Some(history.points.len())
        }
        Err(error) => {
            assert!(!error.to_string().contains('\n'), "{error}");
            assert!(error.to_string().len() < 1000);
            let (HistoryError::NotTwoNumbers { line, .. } | HistoryError::NotAlternating { line }) =
                error;
            assert!((1..=lines).contains(&line));
            None
        }
    }
}

#[test]
fn sound_files_are_read() {
    assert_eq!(HISTORIES.map(|text| exercise(text.as_bytes())), [Some(2), Some(2), Some(3)]);
    assert_eq!(exercise(b""), Some(0));
}

#[test]
fn long_files_are_read_in_linear_time() {
    let points = "1.0 2.0\n".repeat(500_000);
    assert_eq!(exercise(points.as_bytes()), Some(500_000));
    assert_eq!(exercise("1".repeat(5_000_000).as_bytes()), Some(0));
    assert_eq!(exercise(("1".repeat(5_000_000) + "\n").as_bytes()), None);
    assert_eq!(exercise(" \n".repeat(1_000_000).as_bytes()), Some(0));
    let exponent = format!("1e{} 2\n", "9".repeat(1_000_000));
    exercise(exponent.as_bytes());
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn random_bytes(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        exercise(&bytes);
    }

    #[test]
    fn pieces_of_numbers(text in "([-+ .0-9eEnainf\r\n]|nan|inf|1e|\n ){0,60}") {
        exercise(text.as_bytes());
    }

    #[test]
    fn damaged_files(
        file in 0..HISTORIES.len(),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..6),
        length in any::<prop::sample::Index>(),
    ) {
        let mut bytes = HISTORIES[file].as_bytes().to_vec();
        for (at, byte) in changes {
            let at = at.index(bytes.len());
            bytes[at] = byte;
        }
        bytes.truncate(length.index(bytes.len() + 1));
        exercise(&bytes);
    }
}
