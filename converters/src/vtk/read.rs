//! Reads `.vtu` and `.pvd` files back: exactly the form in which this crate writes them, raw
//! appended arrays behind an XML header with 64-bit lengths.
//!
//! Lengths in a file are believed only as far as the file is long.

use std::path::Path;

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use super::cells::{CellType, Cells};
use super::data_array::{Components, DataArray, Values};
use super::grid::UnstructuredGrid;
use crate::error::{ConvertError, at};

/// What the appended section begins with.
const APPENDED: &[u8] = b"<AppendedData";

/// Reads the grid in a `.vtu` file.
///
/// # Errors
/// If the file cannot be read, is cut short, is damaged, or has another form than the one that
/// [`write_vtu`](super::write_vtu) gives it.
pub fn read_vtu(path: &Path) -> Result<UnstructuredGrid, ConvertError> {
    let bytes = std::fs::read(path).map_err(at(path))?;
    decode_vtu(&bytes).map_err(|message| ConvertError::Vtk { path: path.to_path_buf(), message })
}

/// A file of a collection, as a `.pvd` file lists it.
#[derive(Debug, Clone, PartialEq)]
pub struct PvdEntry {
    /// Time that it shows.
    pub time: f64,
    /// Number of the part of the picture.
    pub part: u32,
    /// Name of the part.
    pub name: String,
    /// The file, relative to the folder of the collection.
    pub file: String,
}

/// Reads the list in a `.pvd` file, in the order of the file.
///
/// # Errors
/// If the file cannot be read or is no collection.
pub fn read_pvd(path: &Path) -> Result<Vec<PvdEntry>, ConvertError> {
    let bytes = std::fs::read(path).map_err(at(path))?;
    decode_pvd(&bytes).map_err(|message| ConvertError::Vtk { path: path.to_path_buf(), message })
}

/// The list of a `.pvd` file in memory.
///
/// # Errors
/// A message without the name of the file.
pub fn decode_pvd(bytes: &[u8]) -> Result<Vec<PvdEntry>, String> {
    let text = std::str::from_utf8(bytes).map_err(|e| e.to_string())?;
    let mut reader = Reader::from_str(text);
    let (mut entries, mut is_collection) = (Vec::new(), false);
    loop {
        let place = reader.buffer_position();
        match reader.read_event().map_err(|e| format!("byte {place}: {e}"))? {
            Event::Eof => break,
            Event::Start(tag) | Event::Empty(tag) => match tag.name().as_ref() {
                "VTKFile" => {
                    is_collection = attribute(&tag, "type")?.as_deref() == Some("Collection");
                }
                "DataSet" => {
                    let time = attribute(&tag, "timestep")?.unwrap_or_else(|| "0".to_owned());
                    let time = time.trim().parse().map_err(|_| {
                        format!("byte {place}: timestep is `{time}`; expected a number")
                    })?;
                    let part = attribute(&tag, "part")?.and_then(|p| p.trim().parse().ok());
                    let file = attribute(&tag, "file")?
                        .ok_or_else(|| format!("byte {place}: a DataSet names no file"))?;
                    let name = attribute(&tag, "name")?.unwrap_or_default();
                    entries.push(PvdEntry { time, part: part.unwrap_or(0), name, file });
                }
                _ => {}
            },
            _ => {}
        }
    }
    if is_collection {
        Ok(entries)
    } else {
        Err("this is no VTK collection: <VTKFile type=\"Collection\"> is missing".to_owned())
    }
}

fn attribute(tag: &BytesStart<'_>, name: &str) -> Result<Option<String>, String> {
    for attribute in tag.attributes() {
        let attribute = attribute.map_err(|e| e.to_string())?;
        let key: &str = attribute.key.as_ref();
        if key == name {
            let text: &str = &attribute.value;
            let value = quick_xml::escape::unescape(text).map_err(|e| e.to_string())?;
            return Ok(Some(value.into_owned()));
        }
    }
    Ok(None)
}

/// Where in the header an array is announced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Section {
    Outside,
    Field,
    Points,
    PointData,
    CellData,
    Cells,
}

/// The grid of a `.vtu` file in memory.
///
/// # Errors
/// A message without the name of the file.
pub fn decode_vtu(bytes: &[u8]) -> Result<UnstructuredGrid, String> {
    let start = bytes
        .windows(APPENDED.len())
        .position(|window| window == APPENDED)
        .ok_or("there is no <AppendedData> section: the file is cut short or of another form")?;
    let (header, rest) = bytes.split_at(start);
    let mark = rest.iter().position(|&b| b == b'_').ok_or("the appended section is cut short")?;
    let data = rest.get(mark + 1..).unwrap_or_default();
    let tag = rest.get(..mark).unwrap_or_default();
    if !String::from_utf8_lossy(tag).contains("encoding=\"raw\"") {
        return Err("the appended section is not raw; only Ypsilon's own files are read".to_owned());
    }
    let header = std::str::from_utf8(header).map_err(|e| e.to_string())?;
    let mut reader = Reader::from_str(header);
    let mut grid = UnstructuredGrid::default();
    let mut section = Section::Outside;
    let (mut connectivity, mut offsets, mut types) = (Vec::new(), Vec::new(), Vec::new());
    loop {
        let place = reader.buffer_position();
        match reader.read_event().map_err(|e| format!("byte {place}: {e}"))? {
            Event::Eof => break,
            Event::Start(tag) | Event::Empty(tag) => match tag.name().as_ref() {
                "VTKFile" => check_form(&tag)?,
                "FieldData" => section = Section::Field,
                "Points" => section = Section::Points,
                "PointData" => section = Section::PointData,
                "CellData" => section = Section::CellData,
                "Cells" => section = Section::Cells,
                "DataArray" if section != Section::Outside => {
                    let array = array(&tag, data)?;
                    match section {
                        Section::Field => grid.field_data.push(array),
                        Section::PointData => grid.point_data.push(array),
                        Section::CellData => grid.cell_data.push(array),
                        Section::Points => grid.points = points(array)?,
                        Section::Cells => match (array.name.as_str(), array.values) {
                            ("connectivity", Values::Int64(values)) => connectivity = values,
                            ("offsets", Values::Int64(values)) => offsets = values,
                            ("types", Values::UInt8(values)) => types = values,
                            (name, _) => {
                                return Err(format!("the cells have an unknown array {name:?}"));
                            }
                        },
                        Section::Outside => {}
                    }
                }
                _ => {}
            },
            Event::End(tag) => {
                if matches!(
                    tag.name().as_ref(),
                    "FieldData" | "Points" | "PointData" | "CellData" | "Cells"
                ) {
                    section = Section::Outside;
                }
            }
            _ => {}
        }
    }
    grid.cells = cells(&connectivity, &offsets, &types, grid.points.len())?;
    check_lengths(&grid)?;
    Ok(grid)
}

fn check_form(tag: &BytesStart<'_>) -> Result<(), String> {
    for (name, expected) in
        [("type", "UnstructuredGrid"), ("byte_order", "LittleEndian"), ("header_type", "UInt64")]
    {
        let found = attribute(tag, name)?.unwrap_or_default();
        if found != expected {
            return Err(format!(
                "{name} is `{found}`; expected {expected}: only Ypsilon's own files are read"
            ));
        }
    }
    match attribute(tag, "compressor")? {
        Some(name) => Err(format!("the arrays are compressed ({name}); expected raw ones")),
        None => Ok(()),
    }
}

/// An array as its announcement and its block tell it.
fn array(tag: &BytesStart<'_>, data: &[u8]) -> Result<DataArray, String> {
    let name = attribute(tag, "Name")?.unwrap_or_default();
    let number = |key: &str, otherwise: usize| match attribute(tag, key)? {
        Some(text) => text
            .trim()
            .parse::<usize>()
            .map_err(|_| format!("array {name:?}: {key} is `{text}`; expected a count")),
        None => Ok(otherwise),
    };
    if attribute(tag, "format")?.as_deref() != Some("appended") {
        return Err(format!("array {name:?} is not appended; only Ypsilon's own files are read"));
    }
    let block = block(data, number("offset", 0)?).ok_or_else(|| {
        format!("array {name:?} ends behind the end of the file: it is cut short")
    })?;
    let kind = attribute(tag, "type")?.unwrap_or_default();
    let values = match kind.as_str() {
        "Float64" => Values::Float64(numbers(block, f64::from_le_bytes)),
        "Float32" => Values::Float32(numbers(block, f32::from_le_bytes)),
        "Int64" => Values::Int64(numbers(block, i64::from_le_bytes)),
        "Int32" => Values::Int32(numbers(block, i32::from_le_bytes)),
        "UInt8" => Values::UInt8(block.to_vec()),
        _ => return Err(format!("array {name:?} has the unknown type `{kind}`")),
    };
    let count = number("NumberOfComponents", 1)?;
    let mut names = Vec::new();
    for index in 0..count.min(9) {
        names.extend(attribute(tag, &format!("ComponentName{index}"))?);
    }
    let components = match count {
        1 => Components::Scalar,
        3 => Components::Vector,
        6 if names == Components::SymmetricTensor.names() => Components::SymmetricTensor,
        2..=9 => {
            names.resize(count, String::new());
            Components::Named(names)
        }
        _ => return Err(format!("array {name:?} has {count} components; expected 1 to 9")),
    };
    Ok(DataArray::new(name, components, values))
}

fn block(data: &[u8], offset: usize) -> Option<&[u8]> {
    let rest = data.get(offset..)?;
    let (length, rest) = rest.split_first_chunk::<8>()?;
    rest.get(..usize::try_from(u64::from_le_bytes(*length)).ok()?)
}

fn numbers<T, const N: usize>(block: &[u8], number: impl Fn([u8; N]) -> T) -> Vec<T> {
    block.as_chunks::<N>().0.iter().map(|&bytes| number(bytes)).collect()
}

fn points(array: DataArray) -> Result<Vec<[f64; 3]>, String> {
    let Values::Float64(numbers) = array.values else {
        return Err("the points are not of type Float64".to_owned());
    };
    match numbers.as_chunks::<3>() {
        (points, []) => Ok(points.to_vec()),
        _ => Err(format!("the points are {} numbers; expected triples", numbers.len())),
    }
}

/// Most points that a cell has.
const MOST_POINTS: usize = CellType::QuadraticTetra.points();

fn cells(
    connectivity: &[i64],
    offsets: &[i64],
    types: &[u8],
    points: usize,
) -> Result<Cells, String> {
    if offsets.len() != types.len() {
        return Err(format!("{} cells have {} types", offsets.len(), types.len()));
    }
    let mut cells = Cells::new();
    let mut begin = 0;
    for (index, (&offset, &number)) in offsets.iter().zip(types).enumerate() {
        let kind = CellType::from_number(number)
            .ok_or_else(|| format!("cell {index} is of the unknown kind {number}"))?;
        let end = usize::try_from(offset).unwrap_or(usize::MAX);
        let corners = connectivity
            .get(begin..end)
            .filter(|corners| corners.len() == kind.points())
            .ok_or_else(|| format!("cell {index} ends at {offset}, which fits no {kind:?}"))?;
        let mut indices = [0_u32; MOST_POINTS];
        for (slot, &corner) in indices.iter_mut().zip(corners) {
            *slot =
                u32::try_from(corner).ok().filter(|&i| (i as usize) < points).ok_or_else(|| {
                    format!("cell {index} names point {corner}, but there are {points}")
                })?;
        }
        cells.push(kind, indices.get(..kind.points()).unwrap_or(&[]));
        begin = end;
    }
    Ok(cells)
}

fn check_lengths(grid: &UnstructuredGrid) -> Result<(), String> {
    let of_points = grid.point_data.iter().map(|a| (a, grid.points.len()));
    let of_cells = grid.cell_data.iter().map(|a| (a, grid.cells.len()));
    for (array, entries) in of_points.chain(of_cells) {
        let expected = entries * array.components.count();
        if array.values.len() != expected {
            let (name, found) = (&array.name, array.values.len());
            return Err(format!("array {name:?} holds {found} values where {expected} are needed"));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::vtk::{PvdSeries, encode_vtu};
    use proptest::prelude::*;

    fn grid() -> UnstructuredGrid {
        let mut grid = UnstructuredGrid {
            points: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.5, 0.0]],
            point_data: vec![
                DataArray::vector("displacement", vec![[1e-9, -2.0, 0.0]; 3]),
                DataArray::integer("node <ID>", vec![0, 1, -2]),
            ],
            cell_data: vec![
                DataArray::symmetric_tensor(
                    "Cauchy stress",
                    vec![[1.0, 2.0, 3.0, 4.0, 0.0, 0.0]; 2],
                ),
                DataArray::byte("deleted", vec![0, 1]),
            ],
            field_data: vec![DataArray::time(0.25)],
            ..UnstructuredGrid::default()
        };
        grid.cells.push(CellType::Triangle, &[0, 1, 2]);
        grid.cells.push(CellType::Line, &[2, 0]);
        grid
    }

    fn encoded() -> Vec<u8> {
        let mut bytes = Vec::new();
        encode_vtu(&mut bytes, &grid()).expect("a grid that fits");
        bytes
    }

    #[test]
    fn what_was_written_is_read_back() {
        assert_eq!(decode_vtu(&encoded()).expect("a grid"), grid());
        let mut series = PvdSeries::new();
        series.push(0.5, 1, "joints", "a & b.vtu");
        let mut text = Vec::new();
        series.encode(&mut text).expect("text");
        let entry =
            PvdEntry { time: 0.5, part: 1, name: "joints".into(), file: "a & b.vtu".into() };
        assert_eq!(decode_pvd(&text).expect("a list"), [entry]);
    }

    #[test]
    fn a_file_that_is_cut_short_says_so() {
        let bytes = encoded();
        let cut = decode_vtu(&bytes[..bytes.len() - 60]).expect_err("a message");
        assert!(cut.contains("cut short"), "{cut}");
        let foreign = decode_vtu(b"<VTKFile type=\"PolyData\">").expect_err("a message");
        assert!(foreign.contains("AppendedData"), "{foreign}");
        assert!(decode_pvd(b"<VTKFile type=\"PolyData\"/>").is_err());
    }

    proptest! {
        /// Damaged files lead to messages, never to panics or huge allocations.
        #[test]
        fn damage_does_no_harm(at in any::<prop::sample::Index>(), byte in any::<u8>()) {
            let mut bytes = encoded();
            let at = at.index(bytes.len());
            bytes[at] = byte;
            let _ = decode_vtu(&bytes);
            let _ = decode_pvd(&bytes);
        }
    }
}
