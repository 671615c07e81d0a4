//! Records that are written several times.

/// The records without repetition.
///
/// The program writes all joints, and all acoustic sources, once per set of joints: a list that is
/// one block several times over becomes one block. Other lists stay as they are.
pub(super) fn without_repeats<T: PartialEq>(records: &[T]) -> &[T] {
    let length = records.len();
    let repeats = |block: usize| {
        length.is_multiple_of(block)
            && records.iter().zip(records.iter().skip(block)).all(|(a, b)| a == b)
    };
    let block = (1..=length / 2).find(|&block| repeats(block)).unwrap_or(length);
    records.get(..block).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn whole_blocks_are_dropped_and_nothing_else() {
        for (records, kept) in [
            (&[][..], &[][..]),
            (&[1], &[1]),
            (&[1, 2, 1, 2, 1, 2], &[1, 2]),
            (&[7, 7, 7], &[7]),
            (&[1, 2, 1], &[1, 2, 1]),
            (&[1, 1, 2, 1, 1, 2], &[1, 1, 2]),
            (&[1, 2, 3, 1, 2, 4], &[1, 2, 3, 1, 2, 4]),
        ] {
            assert_eq!(without_repeats(records), kept);
        }
    }
}
