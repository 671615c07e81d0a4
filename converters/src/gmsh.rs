//! Gmsh meshes to decks of the split dialect.
//!
//! Versions 2.2 and 4.1 of the `.msh` format are read, as text. The crate `mshio` (0.4.2) was
//! considered: it knows 4.1 only, allocates what the file's counts say before it has seen the
//! data, and leaves out the physical names, which are what a deck is made from.
//!
//! * [`parse_msh`]: the text to a [`Mesh`]
//! * [`skeleton`]: the mesh to a complete deck with placeholder materials
//! * [`gmsh_to_deck`]: both, from file to file

mod deck;
mod error;
mod mesh;
mod plane;
mod read;
mod scan;

use std::fs;
use std::io::Write;
use std::path::Path;

use crate::error::{ConvertError, at, no_deck_there};
use crate::replace_file::replace_file;

pub use deck::{Skeleton, skeleton};
pub use error::GmshError;
pub use mesh::{Element, ElementKind, Mesh, Node, PhysicalName};
pub use read::parse_msh;

/// Converts the mesh in `input` to the deck `output` and gives the warnings: what the deck does
/// not say as the mesh did.
///
/// # Errors
/// If the mesh cannot be read or makes no deck, or the deck exists or cannot be written.
pub fn gmsh_to_deck(input: &Path, output: &Path) -> Result<Vec<String>, ConvertError> {
    let bytes = fs::read(input).map_err(at(input))?;
    let refused = |source| ConvertError::Gmsh { path: input.to_path_buf(), source };
    let mesh = parse_msh(&bytes).map_err(refused)?;
    let name = input.file_name().unwrap_or(input.as_os_str()).to_string_lossy();
    let Skeleton { deck, warnings } = skeleton(&mesh, &name).map_err(refused)?;
    no_deck_there(output)?;
    replace_file(output, |file| file.write_all(deck.to_text().as_bytes())).map_err(at(output))?;
    Ok(warnings)
}
