//! Unstructured grids.

use super::cells::Cells;
use super::data_array::DataArray;

/// Points, cells and the data on them.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct UnstructuredGrid {
    /// Points.
    pub points: Vec<[f64; 3]>,
    /// Cells, naming points by index from 0.
    pub cells: Cells,
    /// Arrays with one entry per point.
    pub point_data: Vec<DataArray>,
    /// Arrays with one entry per cell.
    pub cell_data: Vec<DataArray>,
    /// Arrays of any length that concern the whole grid.
    pub field_data: Vec<DataArray>,
}
