//! Files that appear under their name only when they are complete, and that a later run can
//! go on with.

use std::ffi::OsString;
use std::fs::{self, File};
use std::io::{self, Read, Seek, SeekFrom, Write};
use std::path::{Path, PathBuf};

use crate::checksum::Checksum;

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
    length: u64,
    checksum: Checksum,
}

/// How far a file was written: enough for another run to go on from there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Mark {
    /// Bytes written.
    pub length: u64,
    /// [`Checksum`] of those bytes.
    pub checksum: u64,
}

impl PartFile {
    /// Starts a file that is to become `path`.
    pub fn create(path: &Path) -> io::Result<Self> {
        let part = temporary_name(path)?;
        let file = File::create(&part)?;
        let (length, checksum) = (0, Checksum::new());
        Ok(Self { file, part, path: path.to_path_buf(), length, checksum })
    }

    /// Goes on with a file that an earlier run has written up to `mark`, under its temporary name
    /// if that run was killed, or under its own. What stands there beyond the mark is cut off.
    ///
    /// ```
    /// use std::io::Write;
    /// use yformat::part_file::PartFile;
    ///
    /// # let folder = std::env::temp_dir().join(format!("yformat-resume-{}", std::process::id()));
    /// # std::fs::create_dir_all(&folder)?;
    /// let path = folder.join("wall.csv");
    /// let mut file = PartFile::create(&path)?;
    /// file.write_all(b"0,1\n")?;
    /// let mark = file.mark()?;
    /// file.write_all(b"1,")?; // and here the program is killed
    /// # drop(file);
    /// let mut file = PartFile::resume(&path, &mark)?;
    /// file.write_all(b"1,5\n")?;
    /// file.complete()?;
    /// assert_eq!(std::fs::read(&path)?, b"0,1\n1,5\n");
    /// # std::fs::remove_dir_all(&folder)?;
    /// # Ok::<(), std::io::Error>(())
    /// ```
    ///
    /// # Errors
    /// If neither file begins with what had been written up to the mark.
    pub fn resume(path: &Path, mark: &Mark) -> io::Result<Self> {
        let part = temporary_name(path)?;
        let path = path.to_path_buf();
        if let Some(checksum) = begins_with(&part, mark)? {
            let mut file = File::options().write(true).open(&part)?;
            file.set_len(mark.length)?;
            file.seek(SeekFrom::End(0))?;
            return Ok(Self { file, part, path, length: mark.length, checksum });
        }
        if let Some(checksum) = begins_with(&path, mark)? {
            let mut file = File::create(&part)?;
            io::copy(&mut File::open(&path)?.take(mark.length), &mut file)?;
            return Ok(Self { file, part, path, length: mark.length, checksum });
        }
        let kind = if path.exists() || part.exists() {
            io::ErrorKind::InvalidData
        } else {
            io::ErrorKind::NotFound
        };
        Err(io::Error::new(
            kind,
            format!(
                "there is no file that begins with the {} bytes that the earlier run had written",
                mark.length
            ),
        ))
    }

    /// How far the file has been written; that much is on the disk then.
    pub fn mark(&mut self) -> io::Result<Mark> {
        self.file.sync_data()?;
        Ok(Mark { length: self.length, checksum: self.checksum.value() })
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
        let Self { file, part, path, .. } = self;
        file.sync_all()?;
        drop(file);
        fs::rename(&part, &path)?;
        Ok(path)
    }
}

impl Write for PartFile {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let written = self.file.write(bytes)?;
        self.length += written as u64;
        self.checksum.add(bytes.get(..written).unwrap_or(bytes));
        Ok(written)
    }

    fn flush(&mut self) -> io::Result<()> {
        self.file.flush()
    }
}

fn temporary_name(path: &Path) -> io::Result<PathBuf> {
    let Some(name) = path.file_name() else {
        return Err(io::Error::new(io::ErrorKind::InvalidInput, "the path names no file"));
    };
    let mut part_name = OsString::from(name);
    part_name.push(".part");
    Ok(path.with_file_name(part_name))
}

/// The checksum up to the mark, if the file is there and has the marked bytes.
fn begins_with(path: &Path, mark: &Mark) -> io::Result<Option<Checksum>> {
    let file = match File::open(path) {
        Ok(file) => file,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(None),
        Err(error) => return Err(error),
    };
    let (mut file, mut checksum, mut length) = (file.take(mark.length), Checksum::new(), 0);
    let mut buffer = [0; 1 << 16];
    loop {
        match file.read(&mut buffer) {
            Ok(0) => break,
            Ok(count) => {
                checksum.add(buffer.get(..count).unwrap_or(&buffer));
                length += count as u64;
            }
            Err(error) if error.kind() == io::ErrorKind::Interrupted => {}
            Err(error) => return Err(error),
        }
    }
    let same = length == mark.length && checksum.value() == mark.checksum;
    Ok(same.then_some(checksum))
}
