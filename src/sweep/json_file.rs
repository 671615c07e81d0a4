use super::error::{SweepError, at};
use serde::Serialize;
use std::{
    io::{self, Write},
    path::Path,
};
use yformat::part_file::PartFile;

/// Writes a value as JSON, whole or not at all.
pub(super) fn write_json(path: &Path, value: &impl Serialize) -> Result<(), SweepError> {
    let write = || -> io::Result<()> {
        let mut text = serde_json::to_string_pretty(value)?;
        text.push('\n');
        let mut file = PartFile::create(path)?;
        file.write_all(text.as_bytes())?;
        file.complete().map(drop)
    };
    write().map_err(at(path))
}
