//! Acoustic sources as vertices.

use yformat::ym::{AcousticSource, CodedRecord, Record, Scales};

use crate::vtk::{CellType, DataArray, UnstructuredGrid};

/// The grid that shows these records. `magnitude` is -15 where a joint broke without an event.
pub(super) fn grid(records: &[CodedRecord], scales: &Scales) -> UnstructuredGrid {
    let sources: Vec<AcousticSource> = records
        .iter()
        .filter_map(|record| match record.decode(scales) {
            Record::AcousticSource(source) => Some(source),
            _ => None,
        })
        .collect();
    let mut grid = UnstructuredGrid::default();
    for source in &sources {
        let [x, y] = source.position;
        grid.cells.push(CellType::Vertex, &[grid.points.len() as u32]);
        grid.points.push([x, y, 0.0]);
    }
    let magnitudes = sources.iter().map(|source| source.magnitude).collect();
    grid.cell_data = vec![DataArray::scalar("magnitude", magnitudes)];
    grid
}
