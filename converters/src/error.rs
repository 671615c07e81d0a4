//! What can go wrong in a conversion.

use std::io;
use std::path::{Path, PathBuf};

/// Why a file cannot be converted or written.
#[derive(Debug, thiserror::Error)]
pub enum ConvertError {
    /// The operating system refused.
    #[error("{path}: {source}", path = path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// The refusal.
        source: io::Error,
    },
    /// The content is of no kind that can be converted.
    #[error(
        "{path} is of no kind that can be converted; known are d3plot families, `.ym` snapshots, \
         `.yh` histories, Gmsh meshes, Y-Geo's VTK files and decks",
        path = path.display()
    )]
    Unrecognised {
        /// The file.
        path: PathBuf,
    },
    /// The d3plot family cannot be read.
    #[error(transparent)]
    D3plot(#[from] yformat::d3plot::ReadError),
    /// The history cannot be read.
    #[error("{path}: {source}", path = path.display())]
    History {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: yformat::history::HistoryError,
    },
    /// A snapshot cannot be read.
    #[error(transparent)]
    Ym(#[from] yformat::ym::YmError),
    /// The name of a file is not one that the program gives its snapshots.
    #[error(
        "{path} is not called like a snapshot: a name, a number and `.ym` are expected, such as \
         wall12.ym",
        path = path.display()
    )]
    NotASnapshot {
        /// The file.
        path: PathBuf,
    },
    /// A restart deck cannot be read.
    #[error(transparent)]
    Restart(#[from] yformat::classic_output::RestartError),
    /// An element of a deck names a node that does not exist.
    #[error("element {element} names node {node}, but there are {nodes}, counted from 0")]
    NoSuchDeckNode {
        /// Element number, from 0.
        element: usize,
        /// The node it names, from 0.
        node: i64,
        /// Number of nodes.
        nodes: usize,
    },
    /// The Gmsh mesh cannot be read or makes no deck.
    #[error("{path}: {source}", path = path.display())]
    Gmsh {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: crate::gmsh::GmshError,
    },
    /// The deck cannot be converted to another dialect.
    #[error("{path}: {source}", path = path.display())]
    Dialect {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        source: crate::dialects::DialectError,
    },
    /// An input of this kind does not become what is asked for.
    #[error("{path} cannot become {to}; inputs of its kind become {becomes}", path = path.display())]
    Unsuitable {
        /// The file.
        path: PathBuf,
        /// What it can become.
        becomes: &'static str,
        /// What is asked for.
        to: &'static str,
    },
    /// A deck where results are expected.
    #[error(
        "{path} is an input deck; `--to deck --dialect NAME` converts it to another dialect, \
         `ypsilon run` runs it",
        path = path.display()
    )]
    DeckAlone {
        /// The file.
        path: PathBuf,
    },
    /// Two inputs would become the same file.
    #[error(
        "{} and {} would both become {}; convert them into different folders",
        inputs[0].display(),
        inputs[1].display(),
        output.display()
    )]
    SameOutput {
        /// The inputs.
        inputs: [PathBuf; 2],
        /// What both would become.
        output: PathBuf,
    },
    /// There is a deck of that name, which somebody may have changed by hand.
    #[error(
        "{path} exists and is not replaced; move it away or choose another folder with --out",
        path = path.display()
    )]
    DeckExists {
        /// The file.
        path: PathBuf,
    },
    /// A VTK file whose name does not say which step it shows.
    #[error(
        "{path}: the name has no step number; expected names such as wall.y_300.vtp",
        path = path.display()
    )]
    SeriesName {
        /// The file.
        path: PathBuf,
    },
    /// The VTK file cannot be read.
    #[error("{path}: {message}", path = path.display())]
    Vtk {
        /// The file.
        path: PathBuf,
        /// What is wrong with it.
        message: String,
    },
    /// An element names a node that does not exist.
    #[error("element {element} names node {node}, but nodes run from 1 to {nodes}")]
    NoSuchNode {
        /// Element number, from 1.
        element: usize,
        /// The node it names.
        node: i32,
        /// Number of nodes.
        nodes: usize,
    },
    /// States lack what a conversion needs.
    #[error("the states hold no {0}")]
    Missing(&'static str),
    /// An array of a grid has a length that does not fit the grid.
    #[error("array {array:?} holds {found} values where {expected} are needed")]
    ArrayLength {
        /// Name of the array.
        array: String,
        /// Values needed.
        expected: usize,
        /// Values there.
        found: usize,
    },
}

/// Adds the path to an error of the operating system.
pub(crate) fn at(path: &Path) -> impl Fn(io::Error) -> ConvertError + '_ {
    |source| ConvertError::Io { path: path.to_path_buf(), source }
}

/// Decks are never replaced: people edit them.
pub(crate) fn no_deck_there(path: &Path) -> Result<(), ConvertError> {
    if path.exists() {
        return Err(ConvertError::DeckExists { path: path.to_path_buf() });
    }
    Ok(())
}
