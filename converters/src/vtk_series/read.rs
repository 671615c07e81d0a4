//! Reads VTK files with arrays as text: poly data of polygons, and points without cells.

use quick_xml::Reader;
use quick_xml::events::{BytesStart, Event};

use crate::vtk::{CellType, Cells, Components, DataArray, UnstructuredGrid, Values};

/// Whether the file was written to its end.
pub(super) fn check_complete(text: &[u8]) -> Result<(), String> {
    if text.trim_ascii_end().ends_with(b"</VTKFile>") {
        Ok(())
    } else {
        Err("the file ends before </VTKFile>: it is cut short and left out".to_owned())
    }
}

/// Where in the file an array stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Section {
    Outside,
    Points,
    PointData,
    CellData,
    Cells,
}

/// An array whose text is being read.
struct Open {
    name: String,
    integers: bool,
    components: usize,
    text: String,
}

/// The whole file as a grid. Points of a file without cells become vertices.
pub(super) fn read_grid(text: &[u8]) -> Result<UnstructuredGrid, String> {
    check_complete(text)?;
    let text = std::str::from_utf8(text).map_err(|e| e.to_string())?;
    let mut reader = Reader::from_str(text);
    let mut grid = UnstructuredGrid::default();
    let (mut connectivity, mut offsets) = (Vec::new(), Vec::new());
    let (mut section, mut open) = (Section::Outside, None::<Open>);
    let mut pieces = 0;
    loop {
        let place = reader.buffer_position();
        let event = reader.read_event().map_err(|e| format!("byte {place}: {e}"))?;
        match event {
            Event::Eof => break,
            Event::Start(tag) => match tag.name().as_ref() {
                "Points" => section = Section::Points,
                "PointData" => section = Section::PointData,
                "CellData" => section = Section::CellData,
                "Polys" | "Cells" => section = Section::Cells,
                "Lines" | "Strips" | "Verts" => section = Section::Outside,
                "Piece" => {
                    pieces += 1;
                    if pieces > 1 {
                        return Err("the file has several pieces; expected one".to_owned());
                    }
                }
                "DataArray" if section != Section::Outside => open = Some(opened(&tag)?),
                _ => {}
            },
            Event::Text(words) => {
                if let Some(array) = &mut open {
                    array.text.push_str(&words);
                }
            }
            Event::End(tag) => match tag.name().as_ref() {
                "DataArray" => {
                    if let Some(array) = open.take() {
                        match section {
                            Section::Points => grid.points = points(&array)?,
                            Section::PointData => grid.point_data.push(data(array)?),
                            Section::CellData => grid.cell_data.push(data(array)?),
                            Section::Cells if array.name == "connectivity" => {
                                connectivity = numbers(&array)?;
                            }
                            Section::Cells if array.name == "offsets" => offsets = numbers(&array)?,
                            Section::Cells | Section::Outside => {}
                        }
                    }
                }
                "Points" | "PointData" | "CellData" | "Polys" | "Cells" => {
                    section = Section::Outside;
                }
                _ => {}
            },
            _ => {}
        }
    }
    grid.cells = cells(&connectivity, &offsets, grid.points.len())?;
    if offsets.is_empty() && grid.cell_data.iter().all(|array| array.values.is_empty()) {
        for point in 0..grid.points.len() {
            let point = u32::try_from(point).map_err(|_| "too many points".to_owned())?;
            grid.cells.push(CellType::Vertex, &[point]);
        }
        grid.cell_data.clear();
    }
    Ok(grid)
}

fn opened(tag: &BytesStart<'_>) -> Result<Open, String> {
    let mut open =
        Open { name: String::new(), integers: false, components: 1, text: String::new() };
    for attribute in tag.attributes() {
        let attribute = attribute.map_err(|e| e.to_string())?;
        let value = &*attribute.value;
        match attribute.key.as_ref() {
            "Name" => open.name = value.to_owned(),
            "type" => open.integers = value.contains("Int"),
            "NumberOfComponents" => {
                let count = value.parse().ok().filter(|count| (1..=9).contains(count));
                open.components = count
                    .ok_or_else(|| format!("NumberOfComponents is `{value}`; expected 1 to 9"))?;
            }
            "format" if value != "ascii" => {
                return Err(format!("an array has the format `{value}`; expected ascii"));
            }
            _ => {}
        }
    }
    Ok(open)
}

fn numbers<T: std::str::FromStr>(array: &Open) -> Result<Vec<T>, String> {
    let number = |word: &str| {
        word.parse().map_err(|_| {
            let short: String = word.chars().take(40).collect();
            format!("array {:?} holds `{short}`; expected a number", array.name)
        })
    };
    array.text.split_ascii_whitespace().map(number).collect()
}

fn points(array: &Open) -> Result<Vec<[f64; 3]>, String> {
    let numbers: Vec<f64> = numbers(array)?;
    let (points, []) = numbers.as_chunks::<3>() else {
        return Err(format!("the points are {} numbers; expected triples", numbers.len()));
    };
    Ok(points.to_vec())
}

fn data(array: Open) -> Result<DataArray, String> {
    let values = if array.integers {
        Values::Int32(numbers(&array)?)
    } else {
        Values::Float32(numbers(&array)?)
    };
    let components = match array.components {
        1 => Components::Scalar,
        3 => Components::Vector,
        9 => {
            let names = ["XX", "XY", "XZ", "YX", "YY", "YZ", "ZX", "ZY", "ZZ"];
            Components::Named(names.map(str::to_owned).to_vec())
        }
        count => Components::Named((0..count).map(|i| i.to_string()).collect()),
    };
    Ok(DataArray::new(array.name, components, values))
}

fn cells(connectivity: &[i64], offsets: &[i64], points: usize) -> Result<Cells, String> {
    let mut cells = Cells::new();
    let mut begin = 0;
    for &offset in offsets {
        let end = usize::try_from(offset).unwrap_or(usize::MAX);
        let Some(corners) = connectivity.get(begin..end) else {
            return Err(format!(
                "a cell ends at {offset}, outside of its {} corners",
                connectivity.len()
            ));
        };
        let mut indices = Vec::with_capacity(corners.len().min(4));
        for &corner in corners {
            let index = u32::try_from(corner).ok().filter(|&index| (index as usize) < points);
            indices.push(index.ok_or_else(|| {
                format!(
                    "a cell names point {corner}; points run from 0 to {}",
                    points.wrapping_sub(1)
                )
            })?);
        }
        let kind = match indices.len() {
            1 => CellType::Vertex,
            2 => CellType::Line,
            3 => CellType::Triangle,
            4 => CellType::Quad,
            count => return Err(format!("a cell has {count} corners; expected 1 to 4")),
        };
        cells.push(kind, &indices);
        begin = end;
    }
    Ok(cells)
}
