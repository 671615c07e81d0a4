//! `.vtu` files: XML in front, raw appended arrays behind.

use std::io::{self, Write};
use std::path::Path;

use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, Event};

use super::data_array::{Components, DataArray, Values};
use super::grid::UnstructuredGrid;
use crate::error::{ConvertError, at};
use crate::replace_file::replace_file;

/// Writes a grid to `path`: through a temporary file beside it that is renamed when complete.
pub fn write_vtu(path: &Path, grid: &UnstructuredGrid) -> Result<(), ConvertError> {
    check(grid)?;
    replace_file(path, |output| write(output, grid)).map_err(at(path))
}

/// Writes a grid into `output`, which is best buffered.
pub fn encode_vtu(output: impl Write, grid: &UnstructuredGrid) -> Result<(), ConvertError> {
    check(grid)?;
    write(output, grid).map_err(at(Path::new("output")))
}

/// Every array must have one entry per point or cell.
fn check(grid: &UnstructuredGrid) -> Result<(), ConvertError> {
    let of_points = grid.point_data.iter().map(|a| (a, grid.points.len()));
    let of_cells = grid.cell_data.iter().map(|a| (a, grid.cells.len()));
    for (array, entries) in of_points.chain(of_cells) {
        let expected = entries * array.components.count();
        if array.values.len() != expected {
            return Err(ConvertError::ArrayLength {
                array: array.name.clone(),
                expected,
                found: array.values.len(),
            });
        }
    }
    Ok(())
}

/// One block of the appended section.
#[derive(Clone, Copy)]
enum Block<'a> {
    Float64(&'a [f64]),
    Float32(&'a [f32]),
    Int64(&'a [i64]),
    Int32(&'a [i32]),
    UInt8(&'a [u8]),
}

impl<'a> From<&'a Values> for Block<'a> {
    fn from(values: &'a Values) -> Self {
        match values {
            Values::Float64(values) => Self::Float64(values),
            Values::Float32(values) => Self::Float32(values),
            Values::Int64(values) => Self::Int64(values),
            Values::Int32(values) => Self::Int32(values),
            Values::UInt8(values) => Self::UInt8(values),
        }
    }
}

impl Block<'_> {
    fn type_name(self) -> &'static str {
        match self {
            Self::Float64(_) => "Float64",
            Self::Float32(_) => "Float32",
            Self::Int64(_) => "Int64",
            Self::Int32(_) => "Int32",
            Self::UInt8(_) => "UInt8",
        }
    }

    fn bytes(self) -> u64 {
        let bytes = match self {
            Self::Float64(values) => size_of_val(values),
            Self::Float32(values) => size_of_val(values),
            Self::Int64(values) => size_of_val(values),
            Self::Int32(values) => size_of_val(values),
            Self::UInt8(values) => size_of_val(values),
        };
        bytes as u64
    }

    fn write(self, output: &mut impl Write) -> io::Result<()> {
        output.write_all(&self.bytes().to_le_bytes())?;
        match self {
            Self::Float64(values) => little_endian(output, values, |v| v.to_le_bytes()),
            Self::Float32(values) => little_endian(output, values, |v| v.to_le_bytes()),
            Self::Int64(values) => little_endian(output, values, |v| v.to_le_bytes()),
            Self::Int32(values) => little_endian(output, values, |v| v.to_le_bytes()),
            Self::UInt8(values) => output.write_all(values),
        }
    }
}

/// Writes values in pieces that are encoded on the stack.
fn little_endian<T: Copy, const N: usize>(
    output: &mut impl Write,
    values: &[T],
    bytes: impl Fn(T) -> [u8; N],
) -> io::Result<()> {
    let mut buffer = [0; 4096];
    for piece in values.chunks(buffer.len() / N) {
        for (slot, &value) in buffer.chunks_exact_mut(N).zip(piece) {
            slot.copy_from_slice(&bytes(value));
        }
        output.write_all(&buffer[..piece.len() * N])?;
    }
    Ok(())
}

/// The XML part under way, and the blocks it has announced.
struct Header<'a, W: Write> {
    xml: Writer<W>,
    blocks: Vec<Block<'a>>,
    offset: u64,
}

impl<'a, W: Write> Header<'a, W> {
    fn open(&mut self, name: &str, attributes: &[(&str, &str)]) -> io::Result<()> {
        let element = BytesStart::new(name).with_attributes(attributes.iter().copied());
        self.xml.write_event(Event::Start(element))
    }

    fn close(&mut self, name: &str) -> io::Result<()> {
        self.xml.write_event(Event::End(BytesEnd::new(name)))
    }

    /// Announces an array and remembers its block.
    fn array(
        &mut self,
        name: &str,
        components: &Components,
        tuples: Option<usize>,
        block: Block<'a>,
    ) -> io::Result<()> {
        let mut element = BytesStart::new("DataArray");
        element.push_attribute(("type", block.type_name()));
        element.push_attribute(("Name", name));
        let count = components.count();
        if count != 1 {
            element.push_attribute(("NumberOfComponents", count.to_string().as_str()));
        }
        for (index, component) in components.names().into_iter().enumerate() {
            let attribute = format!("ComponentName{index}");
            element.push_attribute((attribute.as_str(), component));
        }
        if let Some(tuples) = tuples {
            element.push_attribute(("NumberOfTuples", tuples.to_string().as_str()));
        }
        element.push_attribute(("format", "appended"));
        element.push_attribute(("offset", self.offset.to_string().as_str()));
        self.offset += 8 + block.bytes();
        self.blocks.push(block);
        self.xml.write_event(Event::Empty(element))
    }

    fn data(&mut self, element: &str, arrays: &'a [DataArray]) -> io::Result<()> {
        self.open(element, &[])?;
        for array in arrays {
            let block = Block::from(&array.values);
            self.array(&array.name, &array.components, None, block)?;
        }
        self.close(element)
    }
}

fn write(output: impl Write, grid: &UnstructuredGrid) -> io::Result<()> {
    let mut header =
        Header { xml: Writer::new_with_indent(output, b' ', 2), blocks: Vec::new(), offset: 0 };
    header.xml.write_event(Event::Decl(BytesDecl::new("1.0", None, None)))?;
    let file = [
        ("type", "UnstructuredGrid"),
        ("version", "1.0"),
        ("byte_order", "LittleEndian"),
        ("header_type", "UInt64"),
    ];
    header.open("VTKFile", &file)?;
    header.open("UnstructuredGrid", &[])?;
    if !grid.field_data.is_empty() {
        header.open("FieldData", &[])?;
        for array in &grid.field_data {
            let block = Block::from(&array.values);
            let tuples = Some(array.entries());
            header.array(&array.name, &array.components, tuples, block)?;
        }
        header.close("FieldData")?;
    }
    let points = grid.points.len().to_string();
    let cells = grid.cells.len().to_string();
    let piece = [("NumberOfPoints", points.as_str()), ("NumberOfCells", &cells)];
    header.open("Piece", &piece)?;
    header.data("PointData", &grid.point_data)?;
    header.data("CellData", &grid.cell_data)?;
    header.open("Points", &[])?;
    let coordinates = Block::Float64(grid.points.as_flattened());
    header.array("Points", &Components::Vector, None, coordinates)?;
    header.close("Points")?;
    header.open("Cells", &[])?;
    let connectivity = Block::Int64(grid.cells.connectivity());
    header.array("connectivity", &Components::Scalar, None, connectivity)?;
    let offsets = Block::Int64(grid.cells.offsets());
    header.array("offsets", &Components::Scalar, None, offsets)?;
    let types = Block::UInt8(grid.cells.types());
    header.array("types", &Components::Scalar, None, types)?;
    header.close("Cells")?;
    header.close("Piece")?;
    header.close("UnstructuredGrid")?;
    header.open("AppendedData", &[("encoding", "raw")])?;
    let mut output = header.xml.into_inner();
    // The underscore marks where the blocks begin; the XML writer must not add blanks in here.
    output.write_all(b"\n_")?;
    for block in header.blocks {
        block.write(&mut output)?;
    }
    output.write_all(b"\n  </AppendedData>\n</VTKFile>\n")
}
