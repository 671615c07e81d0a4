//! Damaged files lead to errors or notices, never to panics or huge allocations.

use std::io::Cursor;

use proptest::prelude::*;
use yformat::d3plot::{FamilyReader, State};

const PLANE: &[u8] = include_bytes!("data/d3plot/jx_33_2.d3plot");
const SPATIAL: &[u8] = include_bytes!("data/d3plot/t3d_uniaxial.d3plot");

/// Reads all there is; tells how many states that were.
fn read_all(files: Vec<Vec<u8>>) -> Option<usize> {
    let mut reader = FamilyReader::from_sources(files.into_iter().map(Cursor::new)).ok()?;
    let mut state = State::default();
    for index in 0..reader.state_count() {
        reader.read_state(index, &mut state).unwrap();
    }
    assert!(reader.read_state(reader.state_count(), &mut state).is_err());
    Some(reader.state_count())
}

/// Words that counts and flags may be damaged to.
fn word() -> impl Strategy<Value = i32> {
    prop_oneof![
        any::<i32>(),
        -3..20_000_i32,
        Just(i32::MAX),
        Just(i32::MIN),
        Just(-10_001),
        Just((-999_999.0_f32).to_bits().cast_signed()),
    ]
}

proptest! {
    #[test]
    fn on_damaged_words(
        spatial: bool,
        damage in prop::collection::vec((0..400_usize, word()), 0..6),
        length in 0..3000_usize,
    ) {
        let mut bytes = if spatial { SPATIAL } else { PLANE }.to_vec();
        for (index, word) in damage {
            if let Some(slot) = bytes.get_mut(4 * index..4 * index + 4) {
                slot.copy_from_slice(&word.to_le_bytes());
            }
        }
        bytes.truncate(length);
        read_all(vec![bytes.clone(), bytes]);
    }

    #[test]
    fn on_damaged_control_words(
        spatial: bool,
        damage in prop::collection::vec((10..64_usize, word()), 1..3),
    ) {
        let mut bytes = if spatial { SPATIAL } else { PLANE }.to_vec();
        for (index, word) in damage {
            bytes[4 * index..4 * index + 4].copy_from_slice(&word.to_le_bytes());
        }
        read_all(vec![bytes]);
    }

    #[test]
    fn on_noise(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        read_all(vec![bytes]);
    }
}

#[test]
fn the_undamaged_files_are_read() {
    assert_eq!(read_all(vec![PLANE.to_vec()]), Some(2));
    assert_eq!(read_all(vec![SPATIAL.to_vec()]), Some(1));
    assert_eq!(read_all(Vec::new()), None);
}

#[test]
fn the_largest_counts_are_refused_without_allocating() {
    let mut bytes = PLANE.to_vec();
    for word in [16, 18, 31, 33] {
        bytes[4 * word..4 * word + 4].copy_from_slice(&i32::MAX.to_le_bytes());
    }
    assert_eq!(read_all(vec![bytes.clone()]), None);
    // With few nodes the geometry fits and only the states do not.
    bytes[64..68].copy_from_slice(&1_i32.to_le_bytes());
    bytes[124..128].copy_from_slice(&2_i32.to_le_bytes());
    assert_eq!(read_all(vec![bytes]), Some(0));
}

#[test]
fn a_marker_right_after_the_geometry_leaves_the_states_to_the_next_file() {
    let geometry = 4 * (64 + 3 * 18 + 5 * 6);
    let mut first = PLANE[..geometry].to_vec();
    first.extend((-999_999.0_f32).to_le_bytes());
    assert_eq!(read_all(vec![first, PLANE[geometry..].to_vec()]), Some(2));
}
