//! The VTK XML that Y-Geo prints: single-quoted attributes, every array on one line, a blank
//! after every value, no line end after the last tag.

use std::fmt::Display;
use std::io::{self, Write};

/// Decimals of most arrays.
pub(super) const SIX: usize = 6;
/// Decimals of sliding, opening and area.
pub(super) const NINE: usize = 9;

const ARRAY_END: &str = "</DataArray>\n";

pub(super) fn open_poly_data(
    out: &mut impl Write,
    points: usize,
    polygons: usize,
) -> io::Result<()> {
    out.write_all(
        b"<?xml version='1.0'?>\n\
        <VTKFile type='PolyData' version='0.1' byte_order='LittleEndian'><PolyData>\n",
    )?;
    writeln!(
        out,
        "<Piece NumberOfPoints='{points}' NumberOfVerts='0' NumberOfLines='0' \
         NumberOfStrips='0' NumberOfPolys='{polygons}'>"
    )
}

/// The polygons (the points of one after the other, then where each ends among these) and the
/// end of the file.
pub(super) fn close_poly_data(
    out: &mut impl Write,
    connectivity: impl Iterator<Item = usize>,
    offsets: impl Iterator<Item = usize>,
) -> io::Result<()> {
    out.write_all(b"<Polys>\n<DataArray type='Int32' Name='connectivity' format='ascii'>\n")?;
    integers(out, connectivity)?;
    out.write_all(b"<DataArray type='Int32' Name='offsets' format='ascii'>\n")?;
    integers(out, offsets)?;
    out.write_all(b"</Polys>\n</Piece>\n</PolyData>\n</VTKFile>")
}

pub(super) fn open_point_cloud(out: &mut impl Write, points: usize) -> io::Result<()> {
    out.write_all(
        b"<?xml version='1.0'?>\n\
        <VTKFile type='UnstructuredGrid' version='0.1' byte_order='LittleEndian'>\
        <UnstructuredGrid>\n",
    )?;
    writeln!(out, "<Piece NumberOfPoints='{points}' NumberOfCells='0'>")
}

/// The points of a cloud, which come after their data, and the end of the file.
pub(super) fn close_point_cloud(
    out: &mut impl Write,
    positions: impl Iterator<Item = [f32; 2]>,
) -> io::Result<()> {
    out.write_all(b"<CellData>\n\n</CellData>\n")?;
    points(out, positions)?;
    out.write_all(
        b"<Cells><DataArray type='Int32' Name='connectivity'/>\
        <DataArray type='Int32' Name='offsets'/><DataArray type='UInt8' Name='types'/></Cells>\n\
        </Piece>\n</UnstructuredGrid>\n</VTKFile>",
    )
}

/// The block `<Points>`; the third coordinate is zero.
pub(super) fn points(
    out: &mut impl Write,
    positions: impl Iterator<Item = [f32; 2]>,
) -> io::Result<()> {
    out.write_all(b"<Points>\n<DataArray type='Float32' NumberOfComponents='3' format='ascii'>\n")?;
    plane_vectors(out, positions)?;
    out.write_all(b"</Points>\n")
}

/// An array of vectors of the plane with their third component, zero.
pub(super) fn vector_array(
    out: &mut impl Write,
    name: &str,
    vectors: impl Iterator<Item = [f32; 2]>,
) -> io::Result<()> {
    tag(out, "Float32", name, 3)?;
    plane_vectors(out, vectors)
}

/// An array of symmetric or other tensors of the plane, `[xx, xy, yx, yy]`; what has to do with
/// the third axis is zero.
pub(super) fn tensor_array(
    out: &mut impl Write,
    name: &str,
    tensors: impl Iterator<Item = [f32; 4]>,
) -> io::Result<()> {
    tag(out, "Float32", name, 9)?;
    for [xx, xy, yx, yy] in tensors {
        for value in [xx, xy, 0.0, yx, yy, 0.0, 0.0, 0.0, 0.0] {
            number(out, value, SIX)?;
        }
    }
    end(out)
}

pub(super) fn float_array(
    out: &mut impl Write,
    name: &str,
    decimals: usize,
    values: impl Iterator<Item = f32>,
) -> io::Result<()> {
    tag(out, "Float32", name, 1)?;
    for value in values {
        number(out, value, decimals)?;
    }
    end(out)
}

pub(super) fn integer_array<T: Display>(
    out: &mut impl Write,
    name: &str,
    values: impl Iterator<Item = T>,
) -> io::Result<()> {
    tag(out, "Int32", name, 1)?;
    integers(out, values)
}

/// Rounds the components of a vector to single precision.
pub(super) fn single(vector: [f64; 2]) -> [f32; 2] {
    vector.map(|component| component as f32)
}

fn tag(out: &mut impl Write, kind: &str, name: &str, components: usize) -> io::Result<()> {
    writeln!(
        out,
        "<DataArray type='{kind}' Name='{name}' NumberOfComponents='{components}' format='ascii'>"
    )
}

fn plane_vectors(out: &mut impl Write, vectors: impl Iterator<Item = [f32; 2]>) -> io::Result<()> {
    for [x, y] in vectors {
        number(out, x, SIX)?;
        number(out, y, SIX)?;
        number(out, 0.0, SIX)?;
    }
    end(out)
}

fn integers<T: Display>(out: &mut impl Write, values: impl Iterator<Item = T>) -> io::Result<()> {
    for value in values {
        write!(out, "{value} ")?;
    }
    end(out)
}

fn end(out: &mut impl Write) -> io::Result<()> {
    out.write_all(b"\n")?;
    out.write_all(ARRAY_END.as_bytes())
}

/// `%.6f ` or `%.9f ` of C; Rust rounds the same way and differs only in `nan`.
fn number(out: &mut impl Write, value: f32, decimals: usize) -> io::Result<()> {
    if value.to_bits() == 0 && decimals == SIX {
        return out.write_all(b"0.000000 ");
    }
    if value.is_nan() {
        let sign = if value.is_sign_negative() { "-" } else { "" };
        return write!(out, "{sign}nan ");
    }
    write!(out, "{value:.decimals$} ")
}
