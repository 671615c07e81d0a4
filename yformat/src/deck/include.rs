//! Where included files come from.

use std::io;
use std::path::{Path, PathBuf};

/// Supplies the files that `$YINCL` names.
///
/// ```
/// use yformat::deck::{DeckReader, IncludeLoader};
///
/// struct Library;
///
/// impl IncludeLoader for Library {
///     fn load(&mut self, name: &str) -> std::io::Result<Vec<u8>> {
///         Ok(format!("/* {name} */\n").into_bytes())
///     }
/// }
///
/// let outcome = DeckReader::new().includes(Library).parse("a.y", "$YINCL steel\n$YDOIT\n");
/// assert!(!outcome.has_errors());
/// ```
pub trait IncludeLoader {
    /// The bytes of a file.
    ///
    /// # Errors
    /// If there is no such file or it cannot be read.
    fn load(&mut self, name: &str) -> io::Result<Vec<u8>>;
}

/// Has no files at all.
///
/// ```
/// use yformat::deck::{IncludeLoader, NoIncludes};
///
/// assert!(NoIncludes.load("steel").is_err());
/// ```
#[derive(Debug, Clone, Copy, Default)]
pub struct NoIncludes;

impl IncludeLoader for NoIncludes {
    fn load(&mut self, _name: &str) -> io::Result<Vec<u8>> {
        Err(io::Error::new(
            io::ErrorKind::Unsupported,
            "this deck was read without access to other files",
        ))
    }
}

/// Reads files as the original does, relative to the working directory; what is not there is looked
/// for beside the deck.
///
/// ```
/// use yformat::deck::{FolderIncludes, IncludeLoader};
///
/// assert!(FolderIncludes::beside("decks/wall.y").load("no/such/file").is_err());
/// ```
#[derive(Debug, Clone)]
pub struct FolderIncludes {
    folder: PathBuf,
}

impl FolderIncludes {
    /// Looks beside this deck.
    #[must_use]
    pub fn beside(deck: impl AsRef<Path>) -> Self {
        FolderIncludes { folder: deck.as_ref().parent().map(Path::to_path_buf).unwrap_or_default() }
    }
}

impl IncludeLoader for FolderIncludes {
    fn load(&mut self, name: &str) -> io::Result<Vec<u8>> {
        match std::fs::read(name) {
            Err(error) if error.kind() == io::ErrorKind::NotFound => {
                std::fs::read(self.folder.join(name))
            }
            other => other,
        }
    }
}

impl<F: FnMut(&str) -> io::Result<Vec<u8>>> IncludeLoader for F {
    fn load(&mut self, name: &str) -> io::Result<Vec<u8>> {
        self(name)
    }
}
