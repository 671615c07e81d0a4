//! Damaged snapshots lead to errors, never to panics.

use proptest::prelude::*;
use yformat::ym::{Scales, Snapshot};

const PAIR: &[u8] = include_bytes!("data/classic/g_joint_pair4.ym");

/// Reads and decodes; tells how many records there were.
fn read_all(bytes: &[u8]) -> Option<usize> {
    let snapshot = Snapshot::parse("a.ym", bytes).ok()?;
    for record in &snapshot.records {
        let _ = record.decode(&Scales::default());
    }
    // Memory follows the file: no record has less than two characters and eight numbers.
    assert!(10 * snapshot.records.len() <= bytes.len());
    let again = Snapshot::parse("a.ym", &snapshot.to_bytes()).unwrap();
    assert_eq!(again.records, snapshot.records);
    Some(snapshot.records.len())
}

proptest! {
    #[test]
    fn on_damaged_bytes(
        damage in prop::collection::vec((0..500_usize, any::<u8>()), 0..6),
        length in 0..600_usize,
    ) {
        let mut bytes = PAIR.to_vec();
        for (index, byte) in damage {
            if let Some(slot) = bytes.get_mut(index) {
                *slot = byte;
            }
        }
        bytes.truncate(length);
        read_all(&bytes);
    }

    #[test]
    fn on_noise(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        read_all(&bytes);
        read_all(&[b"CODED\n".to_vec(), bytes].concat());
    }

    #[test]
    fn on_lines_of_digits(lines in "(CODED\n)([1-9][-yri0-9?][1356][0-9]{0,40}\r?\n){0,5}") {
        read_all(lines.as_bytes());
    }
}

#[test]
fn the_undamaged_file_is_read() {
    assert_eq!(read_all(PAIR), Some(8));
    assert_eq!(read_all(b"CODED\n"), Some(0));
    assert_eq!(read_all(b""), None);
}
