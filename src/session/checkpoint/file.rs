//! The file: magic line, version of the format, version of the program, length of the payload,
//! payload (`postcard`), checksum of everything before it. Numbers are little-endian.

use super::{Checkpoint, CheckpointError};
use std::{
    fs,
    io::{self, Write as _},
    path::Path,
};
use yformat::{checksum::Checksum, part_file::PartFile};

/// First bytes of a checkpoint.
const MAGIC: &[u8] = b"YPSILON CHECKPOINT\n";
/// Version of the file format: to be raised with every change of what a checkpoint holds.
pub(super) const FORMAT: u32 = 8;
const VERSION: &str = env!("CARGO_PKG_VERSION");

impl Checkpoint {
    /// Writes the file; what had the name before is replaced when it is complete.
    ///
    /// # Errors
    /// If the system refuses.
    pub(in crate::session) fn write(&self, path: &Path) -> io::Result<()> {
        let payload = postcard::to_stdvec(self).map_err(io::Error::other)?;
        let mut bytes = Vec::with_capacity(payload.len() + 64);
        bytes.extend_from_slice(MAGIC);
        bytes.extend_from_slice(&FORMAT.to_le_bytes());
        bytes.push(VERSION.len() as u8);
        bytes.extend_from_slice(VERSION.as_bytes());
        bytes.extend_from_slice(&(payload.len() as u64).to_le_bytes());
        bytes.extend_from_slice(&payload);
        let checksum = Checksum::of(&bytes);
        let mut file = PartFile::create(path)?;
        file.write_all(&bytes)?;
        file.write_all(&checksum.to_le_bytes())?;
        file.complete().map(drop)
    }

    /// Reads a checkpoint of this version of the program. Nothing in it is trusted: whether it
    /// fits the deck is checked when a run goes on from it.
    ///
    /// # Errors
    /// If the file cannot be read, is no checkpoint, is one of another version, or is damaged.
    pub fn read(path: &Path) -> Result<Self, CheckpointError> {
        let io = |source| CheckpointError::Io { path: path.to_path_buf(), source };
        let bytes = fs::read(path).map_err(io)?;
        Self::parse(&bytes, path)
    }

    /// The checkpoint that these bytes are. `path` appears in messages.
    ///
    /// # Errors
    /// As [`Self::read`], but for files that cannot be read.
    pub fn parse(bytes: &[u8], path: &Path) -> Result<Self, CheckpointError> {
        parse(bytes, path)
    }
}

fn parse(bytes: &[u8], path: &Path) -> Result<Checkpoint, CheckpointError> {
    let path = || path.to_path_buf();
    let damaged =
        |reason: &str| CheckpointError::Damaged { path: path(), reason: reason.to_owned() };
    let cut = || damaged("it ends too early");
    let rest = bytes.strip_prefix(MAGIC).ok_or_else(|| CheckpointError::NotOne { path: path() })?;
    let (format, rest) = rest.split_first_chunk::<4>().ok_or_else(cut)?;
    let format = u32::from_le_bytes(*format);
    let (&length, rest) = rest.split_first().ok_or_else(cut)?;
    let (version, rest) = rest.split_at_checked(length.into()).ok_or_else(cut)?;
    if format != FORMAT || version != VERSION.as_bytes() {
        let found = String::from_utf8_lossy(version).into_owned();
        return Err(CheckpointError::Version { path: path(), found, format });
    }
    let (length, rest) = rest.split_first_chunk::<8>().ok_or_else(cut)?;
    let length = usize::try_from(u64::from_le_bytes(*length)).map_err(|_| cut())?;
    let (payload, checksum) = rest.split_at_checked(length).ok_or_else(cut)?;
    let checksum = <[u8; 8]>::try_from(checksum).map_err(|_| {
        if checksum.len() < 8 { cut() } else { damaged("it is longer than it says") }
    })?;
    let content = bytes.get(..bytes.len() - checksum.len()).unwrap_or_default();
    if u64::from_le_bytes(checksum) != Checksum::of(content) {
        return Err(damaged("its checksum is wrong"));
    }
    match postcard::take_from_bytes(payload) {
        Ok((checkpoint, [])) => Ok(checkpoint),
        Ok(_) => Err(damaged("there is more in it than a state")),
        Err(error) => Err(damaged(&format!("what it holds cannot be read ({error})"))),
    }
}
