//! Files that appear under their name only when they are complete.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};

/// A file written as `<name>.part` and renamed to `<name>` when complete.
///
/// Dropped without [`PartFile::complete`], what was written stays under the temporary name.
///
/// ```
/// use std::io::Write;
/// use yformat::part_file::PartFile;
///
/// # let folder = std::env::temp_dir().join(format!("yformat-part-{}", std::process::id()));
/// # std::fs::create_dir_all(&folder)?;
/// let path = folder.join("wall.csv");
/// let mut file = PartFile::create(&path)?;
/// file.write_all(b"time,energy\n")?;
/// assert!(!path.exists());
/// file.complete()?;
/// assert!(path.exists());
/// # std::fs::remove_dir_all(&folder)?;
/// # Ok::<(), std::io::Error>(())
/// ```
#[derive(Debug)]
pub struct PartFile {
    file: File,
    part: PathBuf,
    path: PathBuf,
}

impl PartFile {
    /// Starts a file that is to become `path`.
    pub fn create(path: &Path) -> io::Result<Self> {
        let Some(name) = path.file_name() else {
            return Err(io::Error::new(io::ErrorKind::InvalidInput, "the path names no file"));
        };
        let mut part_name = OsString::from(name);
        part_name.push(".part");
        let part = path.with_file_name(part_name);
        let file = File::create(&part)?;
        Ok(Self { file, part, path: path.to_path_buf() })
    }

    /// The name that the file is to have.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// The name that it has until it is complete.
    #[must_use]
    pub fn temporary_path(&self) -> &Path {
        &self.part
    }

    /// Puts the file in its place; whatever had the name before is replaced.
    pub fn complete(self) -> io::Result<PathBuf> {
        let Self { file, part, path } = self;
        file.sync_all()?;
        drop(file);
        fs::rename(&part, &path)?;
        Ok(path)
    }
}

impl Write for PartFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        self.file.write(bytes)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}
