//! What checkpoints keep of result files, so that a later run can go on with them.

use super::{OutputError, OutputNames};
use serde::{Deserialize, Serialize, de::DeserializeOwned};
use std::{
    io::{self, BufWriter, Write as _},
    path::{Path, PathBuf},
};
use yformat::part_file::{Mark, PartFile};

/// How far a file was written.
#[derive(Debug, Clone, Copy, Serialize, Deserialize)]
pub struct FilePosition {
    length: u64,
    checksum: u64,
}

impl From<Mark> for FilePosition {
    fn from(mark: Mark) -> Self {
        Self { length: mark.length, checksum: mark.checksum }
    }
}

impl From<FilePosition> for Mark {
    fn from(position: FilePosition) -> Self {
        Self { length: position.length, checksum: position.checksum }
    }
}

/// The bytes of a writer's mark.
///
/// # Errors
/// If the value cannot be written out.
pub fn encode(kind: &'static str, value: &impl Serialize) -> Result<Vec<u8>, OutputError> {
    postcard::to_stdvec(value).map_err(|_| OutputError::Mark { kind })
}

/// The value of a writer's mark.
///
/// # Errors
/// If the bytes are not those of such a value.
pub fn decode<T: DeserializeOwned>(kind: &'static str, mark: &[u8]) -> Result<T, OutputError> {
    match postcard::take_from_bytes(mark) {
        Ok((value, [])) => Ok(value),
        _ => Err(OutputError::Mark { kind }),
    }
}

/// How far a buffered file has been written, all of it on the disk.
pub(super) fn mark_of(file: &mut BufWriter<PartFile>) -> io::Result<FilePosition> {
    file.flush()?;
    Ok(file.get_mut().mark()?.into())
}

/// Names of result files within their folder.
///
/// # Errors
/// If a name is no text.
pub fn file_names(kind: &'static str, files: &[PathBuf]) -> Result<Vec<String>, OutputError> {
    let name = |file: &PathBuf| {
        let name = file.file_name().and_then(|name| name.to_str());
        name.map(str::to_owned).ok_or(OutputError::Mark { kind })
    };
    files.iter().map(name).collect()
}

/// The files of these names, which must be there.
///
/// # Errors
/// If one is missing.
pub fn present(names: &OutputNames, files: &[String]) -> Result<Vec<PathBuf>, OutputError> {
    let path = |file: &String| {
        // a name, not a way into other folders
        let name = Path::new(file).file_name().unwrap_or_default();
        let path = names.folder().join(name);
        if path.is_file() { Ok(path) } else { Err(OutputError::Missing { path }) }
    };
    files.iter().map(path).collect()
}
