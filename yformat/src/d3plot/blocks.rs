//! Words on their way into a file, collected in blocks: a record of any length needs little memory.

use std::io::{self, Write};

/// Bytes of a block.
const BLOCK: usize = 1 << 18;

/// Collects words and writes them block by block.
pub(super) struct Blocks<'a> {
    file: &'a mut dyn Write,
    block: &'a mut Vec<u8>,
    /// The first refusal; nothing is written after it.
    refused: Option<io::Error>,
}

impl<'a> Blocks<'a> {
    /// Into this file, with the buffer for a block.
    pub fn new(file: &'a mut dyn Write, block: &'a mut Vec<u8>) -> Self {
        block.clear();
        Self { file, block, refused: None }
    }

    /// Appends a word.
    pub fn put(&mut self, word: [u8; 4]) {
        self.block.extend_from_slice(&word);
        if self.block.len() >= BLOCK {
            self.flush();
        }
    }

    /// Appends bytes.
    pub fn put_all(&mut self, bytes: &[u8]) {
        self.block.extend_from_slice(bytes);
    }

    fn flush(&mut self) {
        if self.refused.is_none() {
            self.refused = self.file.write_all(self.block).err();
        }
        self.block.clear();
    }

    /// Writes what is left.
    ///
    /// # Errors
    /// If the file refused any of it.
    pub fn finish(mut self) -> io::Result<()> {
        self.flush();
        self.refused.map_or(Ok(()), Err)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_arrive_in_order_whatever_the_block() {
        let (mut file, mut block) = (Vec::new(), vec![7; 3]);
        let mut blocks = Blocks::new(&mut file, &mut block);
        blocks.put_all(b"head");
        let words = BLOCK / 2;
        (0..words).for_each(|k| blocks.put((k as u32).to_le_bytes()));
        blocks.finish().expect("memory takes everything");
        assert_eq!(file.len(), 4 + 4 * words);
        assert!(
            file[4..]
                .as_chunks()
                .0
                .iter()
                .enumerate()
                .all(|(k, word)| { u32::from_le_bytes(*word) == k as u32 })
        );
    }

    #[test]
    fn a_refusal_is_told_at_the_end() {
        let mut room = [0; 8];
        let (mut file, mut block) = (&mut room[..], Vec::new());
        let mut blocks = Blocks::new(&mut file, &mut block);
        (0..BLOCK).for_each(|_| blocks.put([1; 4]));
        assert!(blocks.finish().is_err());
    }
}
