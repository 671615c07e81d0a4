//! What kind of file something is, by its content: Y's users name files as they like.

use std::fs::File;
use std::io::Read;
use std::path::Path;

use yformat::d3plot::{ControlBlock, StateLayout};
use yformat::history::History;

use crate::error::{ConvertError, at};

/// Kinds of files.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FileKind {
    /// First file of a d3plot family.
    D3plot,
    /// A `.yh` history.
    History,
    /// A `.ym` snapshot.
    Ym,
    /// A Gmsh mesh.
    Gmsh,
    /// A VTK file as Y-Geo writes it: version 0.1, arrays as text.
    VtkSeries,
    /// A deck that goes on from an earlier run: its first step is not 0.
    RestartDeck,
    /// Another input deck, of any dialect.
    Deck,
    /// None of these.
    Unknown,
}

/// How much of a file is looked at.
const HEAD: u64 = 4096;

/// Looks into the file at `path`.
pub fn detect_file(path: &Path) -> Result<FileKind, ConvertError> {
    let mut head = Vec::new();
    File::open(path).and_then(|file| file.take(HEAD).read_to_end(&mut head)).map_err(at(path))?;
    Ok(detect(&head))
}

/// Tells the kind of a file from its first bytes (4096 are plenty).
///
/// ```
/// use ypsilon_converters::detect::{FileKind, detect};
/// assert_eq!(detect(b"+0.0000000000e+00 +0.0000000000e+00\n"), FileKind::History);
/// assert_eq!(detect(b"$MeshFormat\n4.1 0 8\n"), FileKind::Gmsh);
/// assert_eq!(detect(b"/* wall */ /YD/YDC/MCSTEP 600\n"), FileKind::Deck);
/// assert_eq!(detect(b"time,value\n"), FileKind::Unknown);
/// ```
pub fn detect(head: &[u8]) -> FileKind {
    if is_d3plot(head) {
        FileKind::D3plot
    } else if is_history(head) {
        FileKind::History
    } else if is_ym(head) {
        FileKind::Ym
    } else if head.trim_ascii_start().starts_with(b"$MeshFormat") {
        FileKind::Gmsh
    } else if is_vtk(head) {
        FileKind::VtkSeries
    } else if is_deck(head) {
        if goes_on(head) { FileKind::RestartDeck } else { FileKind::Deck }
    } else {
        FileKind::Unknown
    }
}

/// A control block that can be read, with elements: text never passes, its words are huge.
fn is_d3plot(head: &[u8]) -> bool {
    head.first_chunk::<{ ControlBlock::BYTES }>().map(ControlBlock::from_bytes).is_some_and(
        |control| StateLayout::new(&control).is_ok_and(|layout| layout.solids + layout.shells > 0),
    )
}

/// The first line is that of a `.ym` snapshot.
///
/// ```
/// use ypsilon_converters::detect::is_ym;
/// assert!(is_ym(b"CODED\n") && !is_ym(b"CODED2\n"));
/// ```
pub fn is_ym(head: &[u8]) -> bool {
    head.strip_prefix(b"CODED")
        .is_some_and(|rest| rest.is_empty() || rest.starts_with(b"\n") || rest.starts_with(b"\r\n"))
}

/// The first word outside of comments is one of a deck.
///
/// ```
/// use ypsilon_converters::detect::is_deck;
/// assert!(is_deck(b"     /*   Control   */\n/YD/YDC/MCSTEP     2000\n"));
/// ```
pub fn is_deck(head: &[u8]) -> bool {
    let mut in_comment = false;
    for word in head.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty()) {
        match (in_comment, word) {
            (true, word) => in_comment = !word.starts_with(b"*/"),
            (false, word) if word.starts_with(b"/*") => in_comment = true,
            (false, word) => {
                return [&b"/YD/"[..], b"$YDOIT", b"$YSTOP", b"$YINCL"]
                    .iter()
                    .any(|start| word.starts_with(start));
            }
        }
    }
    false
}

/// The first whole line is a time and a value, both printed with sign and exponent.
fn is_history(head: &[u8]) -> bool {
    let end = head.iter().position(|&b| b == b'\n').unwrap_or(head.len());
    let (line, _) = head.split_at(end);
    line.first().is_some_and(|&b| matches!(b, b'+' | b'-'))
        && line.len() < 100
        && History::parse(line).is_ok_and(|history| history.points.len() == 1)
}

/// The opening tag of a VTK file of Y-Geo: poly data or an unstructured grid of version 0.1.
fn is_vtk(head: &[u8]) -> bool {
    let head = String::from_utf8_lossy(head).replace('"', "'");
    let tag = head.split_once("<VTKFile").and_then(|(_, rest)| rest.split_once('>'));
    tag.is_some_and(|(tag, _)| {
        (tag.contains("type='PolyData'") || tag.contains("type='UnstructuredGrid'"))
            && tag.contains("version='0.1'")
    })
}

/// The deck gives a first step above 0.
fn goes_on(head: &[u8]) -> bool {
    let mut words = head.split(u8::is_ascii_whitespace).filter(|word| !word.is_empty());
    words.any(|word| word == b"/YD/YDC/NCSTEP")
        && words.next().is_some_and(|number| {
            std::str::from_utf8(number).ok().and_then(|n| n.parse::<i64>().ok()).unwrap_or(0) > 0
        })
}
